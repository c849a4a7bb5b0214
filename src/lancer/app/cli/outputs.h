// Where pictures go: looked at before the work starts, written when it is done.
#pragma once

#include <string>
#include <vector>

#include "lancer/app/prepare.h"
#include "lancer/base/diagnostic.h"
#include "lancer/film/film.h"
#include "lancer/image/image.h"

namespace lancer::app {

// Says what would keep us from writing these files: no such folder, no permission, an ending that we do not know, a name given twice.
// Nothing is created. `option` is for the messages: "-o".
void check_pictures(const std::vector<std::string>& paths, const std::string& option, Diagnostics& diagnostics);
void check_file(const std::string& path, const std::string& option, Diagnostics& diagnostics);

bool is_picture(const std::string& path);  // by its ending

// Whether the file holds linear light, for which exposure is the reader's business.
bool is_linear(const std::string& path);

// Whether the file can hold more than the picture itself.
bool holds_layers(const std::string& path);

// PNG and JPEG get the view and its exposure, EXR what the presentation wants beside the picture, if there are sums.
// Throws MachineFailure.
void write_film(const std::string& path, const Film& film, const Presentation& presentation, const FilmSums* sums = nullptr);

// How many samples each pixel took: in PNG and JPEG grey, white for the pixel with the most; in the others the number itself.
void write_sample_map(const std::string& path, const Film& film, const Metadata& metadata);

}  // namespace lancer::app
