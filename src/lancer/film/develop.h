// The film as a picture for displays.
#pragma once

#include "lancer/film/film.h"
#include "lancer/image/image.h"
#include "lancer/image/view.h"

namespace lancer {

// The film's rows from `first` to before `end`, as the view shows them, encoded as sRGB, into an image of the film's size with three channels.
// Rows may be developed in any order, and by several threads.
void develop_rows(const Film& film, const ViewTransform& view, int first, int end, ByteImage& image);

}  // namespace lancer
