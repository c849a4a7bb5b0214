#include "lancer/image/exr_stream.h"

#include <ImfChromaticitiesAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lancer {

void ExrMemory::write(const char data[], int size) {
    const std::size_t end = place_ + static_cast<std::size_t>(size);
    if (end > bytes_.size()) {
        bytes_.resize(end);
    }
    std::memcpy(bytes_.data() + place_, data, static_cast<std::size_t>(size));
    place_ = end;
}

Imf::Header exr_header(int width, int height, const Metadata& metadata) {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities());  // the default ones are Rec. 709's, D65: those of sRGB
    for (const auto& [key, value] : metadata) {
        if (key.empty()) {
            continue;
        }
        // The names that the format uses itself ("channels", "compression", ...) are taken.
        const bool taken = header.find(key) != header.end() || key == "tiles" || key == "type" || key == "name" || key == "version" ||
                           key == "chunkCount" || key == "view";
        header.insert(taken ? "text:" + key : key, Imf::StringAttribute(value));
    }
    return header;
}

bool fits_half(const std::vector<float>& values) {
    constexpr float largest_half = 65504.0f;
    return std::all_of(values.begin(), values.end(), [](float v) { return !std::isfinite(v) || std::fabs(v) <= largest_half; });
}

}  // namespace lancer
