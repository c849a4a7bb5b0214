// The film as a picture for displays.
#pragma once

#include "lancer/film/film.h"
#include "lancer/image/image.h"

namespace lancer {

// The film's rows from `first` to before `end`, brightened by `exposure` stops and encoded as sRGB, into an image of the film's size with
// three channels. Rows may be developed in any order, and by several threads.
void develop_rows(const Film& film, double exposure, int first, int end, ByteImage& image);

}  // namespace lancer
