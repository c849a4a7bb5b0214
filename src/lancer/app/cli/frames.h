// Animations: lancer render --frames, one picture after the other, and lancer movie.
#pragma once

#include <optional>
#include <string>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/render_job.h"
#include "lancer/app/frames/frame_range.h"

namespace CLI {
class App;
}  // namespace CLI

namespace lancer::app {

void add_movie(CLI::App& program, Work& work);

// --frames and --fps.
void add_frame_range(CLI::App& app, std::optional<FrameRange>& frames, const std::string& description);
void add_fps(CLI::App& app, std::optional<double>& fps);

// A sentence when --frames, --fps and the names of the files do not go together.
std::optional<std::string> check_frames(const RenderJob& job);

// Renders those of the frames that are not done. Returns the exit status, as for one picture.
int run_frames(const CLI::App& app, const RenderJob& job);

}  // namespace lancer::app
