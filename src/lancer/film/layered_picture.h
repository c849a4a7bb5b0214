// The picture with everything that was asked for beside it, as channels of one file.
#pragma once

#include <string>
#include <vector>

#include "lancer/film/film.h"
#include "lancer/film/film_sums.h"
#include "lancer/image/aov.h"
#include "lancer/image/layers.h"

namespace lancer {

struct PictureContents {
    std::vector<Aov> aovs;
    int spectral_bins = 0;
    bool wide = false;         // 32-bit floats for what would be halves
    bool runs = false;         // of samples are kept, where the error is to be known
    double confidence = 0.95;  // of intervals
    double floor = 0.0;        // and what they count darker pixels as (film/interval.h)
    double clamp = 0.0;        // see FilmLayers

    bool is_plain() const { return aovs.empty() && spectral_bins == 0 && !wide; }
};

// The sums that these contents need.
FilmLayers layers_for(const PictureContents& contents);

// What things are called: for each object and material of the world.
struct PictureNames {
    std::vector<std::string> objects;
    std::vector<std::string> materials;
};

// R, G and B are the film's radiance. Depth, position, uv, samples, variance and the spectrum are 32-bit floats, as ids have to be.
LayeredImage layered_picture(const Film& film, const FilmSums& sums, const PictureContents& contents, const PictureNames& names,
                             const Metadata& metadata);

}  // namespace lancer
