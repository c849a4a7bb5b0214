#include "lancer/app/frames/frame_progress.h"

#include <algorithm>

namespace lancer::app {

RenderProgress over_all(const RenderProgress& progress, const FramePart& part) {
    if (part.all <= 1) {
        return progress;
    }
    RenderProgress result = progress;
    result.share = (part.before + progress.share) / part.all;
    result.pixels_done += part.before * progress.pixels_total;
    result.pixels_total *= part.all;
    result.seconds += part.seconds;
    // Whoever divides the samples by the seconds finds the rate unchanged.
    result.samples_done =
        static_cast<std::uint64_t>(static_cast<double>(progress.samples_done) * result.seconds / std::max(progress.seconds, 1e-9));
    const double rendered = part.before - part.skipped + progress.share;
    result.seconds_left = rendered > 0.0 ? result.seconds / rendered * (part.all - part.before - progress.share) : 0.0;
    return result;
}

}  // namespace lancer::app
