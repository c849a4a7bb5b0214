// What a film of ours says of itself, and what can be told from it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lancer/app/prepare.h"
#include "lancer/film/film_file.h"

namespace lancer::app {

// `words`: the command that renders it.
FilmAbout about_film(const Prepared& prepared, const std::vector<std::string>& words);

// How to write a film as pictures, without its scene. Throws MachineFailure where its view needs a part of lancer that is not there.
Presentation presentation_of(const FilmAbout& about);

// What a merged film is to have been rendered with, as far as it matters to what is finished.
RenderOptions options_of(const FilmAbout& about, const FilmShape& shape);

// In words, how the things that two films or pictures must have in common differ: "textures/wood.png has changed", "the seed was 1 and is 2 now".
// `before` and `now` are what they say of themselves.
std::vector<std::string> differences(const Metadata& before, const Metadata& now);

// Of the film that stands for all its shards, and is written there.
FilmAbout about_merged(FilmAbout about, const std::vector<std::string>& outputs);

// Where the film of a shard goes for a picture: "a/out.exr" to "a/out.2-of-8.film". A name that ends in ".film" stays.
std::string shard_path(const std::string& picture, int shard, int shards);
bool is_film(const std::string& path);  // by its ending

}  // namespace lancer::app
