// The module: OpenColorIO's output transform of ACES behind one plain function. No exception leaves it.
#include <OpenColorIO/OpenColorIO.h>

#include <exception>
#include <string_view>

#include "lancer/image/aces/module/interface.h"

namespace {

namespace ocio = OCIO_NAMESPACE;

ocio::BuiltinTransformRcPtr built_in(const char* style, bool inverse = false) {
    const ocio::BuiltinTransformRcPtr transform = ocio::BuiltinTransform::Create();
    transform->setStyle(style);
    transform->setDirection(inverse ? ocio::TRANSFORM_DIR_INVERSE : ocio::TRANSFORM_DIR_FORWARD);
    return transform;
}

// OpenColorIO 2.1 has no configurations of its own, but the parts that they are made of.
ocio::ConstCPUProcessorRcPtr make_processor() {
    const ocio::GroupTransformRcPtr all = ocio::GroupTransform::Create();
    all->appendTransform(built_in("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD", true));
    all->appendTransform(built_in("ACEScg_to_ACES2065-1"));
    all->appendTransform(built_in("ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0"));
    // From XYZ to the display's linear light: Rec. 709 primaries, D65 (0.3127, 0.3290) [IEC 61966-2-1].
    const ocio::MatrixTransformRcPtr to_display = ocio::MatrixTransform::Create();
    const double matrix[16] = {3.2409699419045213,
                               -1.5373831775700935,
                               -0.4986107602930033,
                               0.0,  //
                               -0.9692436362808798,
                               1.8759675015077206,
                               0.0415550574071756,
                               0.0,  //
                               0.0556300796969936,
                               -0.2039769588889766,
                               1.0569715142428786,
                               0.0,  //
                               0.0,
                               0.0,
                               0.0,
                               1.0};
    to_display->setMatrix(matrix);
    all->appendTransform(to_display);
    return ocio::Config::CreateRaw()->getProcessor(all)->getDefaultCPUProcessor();
}

bool develop(float* colors, std::size_t count, void* receiver, LancerAcesReason reason) try {
    static const ocio::ConstCPUProcessorRcPtr processor = make_processor();
    ocio::PackedImageDesc image(colors, static_cast<long>(count), 1, 3);
    processor->apply(image);
    return true;
} catch (const std::exception& error) {
    const std::string_view words = error.what();
    reason(receiver, words.data(), words.size());
    return false;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const LancerAces lancer_aces = {lancer_aces_version, develop};
