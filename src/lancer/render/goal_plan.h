// What reaching a goal will take, seen from a few pixels of the whole picture before the start.
//
// A goal asks for a share of the picture's pixels. Which tiles these lie in can't be counted by machines that render shares of the picture with no talk, so each
// foresees it from the same samples: some pixels of each tile are followed for a while, those that are easiest make up the share, and each tile is asked
// for as many as it has of these. The parts make up the whole however well that is foreseen; where it is wrong, samples are spent where others would have
// done more.
#pragma once

#include "lancer/render/render.h"

namespace lancer {

// The goal of the options with its floor and, where it has an error, its plan. Takes a quarter of a sample for each of the picture's pixels to one for each
// (64 samples each of 4 to 16 pixels in each tile), or a sixteenth of that where only the floor is asked for, on all of the options' threads.
//
// The floor is a tenth of the picture's brightness: what is darker than that needs no better absolute precision. Brightness is the square of the mean root
// of luminance, which a few lamps in the picture change little.
ErrorGoal plan_goal(const Device& device, const RenderOptions& options);

}  // namespace lancer
