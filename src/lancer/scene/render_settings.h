// How a scene is to be rendered.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lancer::scene {

enum class Antialiasing { uniform, adaptive };
enum class DirectSamples { mis, emitter, bsdf };  // how lamps are found: both ways together, by asking them, by scattered rays
enum class PixelFilter { box, tent, gaussian, mitchell, blackman_harris };

struct RenderSettings {
    int width = 1280;
    int height = 720;
    std::string integrator = "auto";  // path where anything in the scene follows physics, else whitted
    std::optional<int> bounces;       // after the first hit; not written: 5 for whitted, 16 for path, 1 for direct
    // How many of them may be of a kind; not written: all.
    std::optional<int> diffuse_bounces;
    std::optional<int> glossy_bounces;
    std::optional<int> transmission_bounces;
    DirectSamples direct_samples = DirectSamples::mis;  // of the direct integrator
    int spp = 64;                                       // samples a pixel of the path integrator
    bool rgb = false;                                   // paths carry linear RGB instead of wavelengths
    int seed = 0;
    PixelFilter filter = PixelFilter::blackman_harris;
    std::optional<double> filter_radius;  // pixels; not written: what suits the filter
    int ssaa = 1;                         // k x k samples a pixel
    Antialiasing antialiasing = Antialiasing::uniform;
    double adaptive_threshold = 0.03;  // difference of display values in [0, 1] that makes a cell be cut in four
    int adaptive_depth = 3;            // how often at most
    double min_weight = 0.0005;        // paths that can bring less than this share of their light to the pixel are not followed
    int wavelengths = 48;              // that carry a path through dispersive glass
    double exposure = 0.0;             // stops
    std::string view = "srgb";         // how linear light is shown; a name that image/view.h knows
    std::vector<std::string> aovs;     // what EXR files hold beside the picture; names that image/aov.h knows
    int spectral_bins = 0;             // and how many channels of spectral radiance
    bool wide = false;                 // 32-bit floats in EXR files, not halves
};

}  // namespace lancer::scene
