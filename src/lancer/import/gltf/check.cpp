#include "lancer/import/gltf/check.h"

#include <algorithm>

#include <fmt/format.h>

namespace lancer::gltf {

namespace {

bool is_matrix(Json accessor) { return accessor.text("type").substr(0, 3) == "MAT"; }

// Numbers should lie where a processor can take them at once.
void check_alignment(Document& document, Json accessor) {
    const Json view = document.item("bufferViews", accessor, "bufferView");
    const std::size_t size = size_of(static_cast<Component>(accessor.natural("componentType").value_or(5126)));
    const std::size_t unit = is_matrix(accessor) ? 4 : size;
    const std::size_t offset = accessor.natural("byteOffset").value_or(0);
    if (offset % unit != 0 || (view && (offset + view.natural("byteOffset").value_or(0)) % unit != 0)) {
        document.warning(accessor, fmt::format("the values should begin at a multiple of {} bytes", unit));
    }
    if (view.natural("byteStride").value_or(4) % size != 0) {
        document.warning(accessor, "the view's byteStride is no multiple of a value's size");
    }
    if (accessor["byteOffset"] && !accessor["bufferView"]) {
        document.warning(accessor["byteOffset"], "an offset without a bufferView means nothing");
    }
}

void check_views(Document& document, Accessors& accessors) {
    const std::vector<Json>& views = document.items("bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (views[i].natural("byteStride").value_or(4) % 4 != 0) {
            document.warning(views[i]["byteStride"], "expected a multiple of 4");
        }
        // Compressed views are opened when something asks for what is in them.
        if (!document.extension(views[i], "EXT_meshopt_compression")) {
            accessors.view(i);
        }
    }
}

void check_cameras(Document& document) {
    for (const Json camera : document.items("cameras")) {
        const bool has_both = camera["orthographic"] && camera["perspective"];
        if (has_both || !camera[camera.text("type")]) {
            document.warning(camera, "expected one object, of the camera's type");
        }
        for (const std::string_view kind : {"orthographic", "perspective"}) {
            const Json shape = camera[kind];
            if (shape["zfar"] && shape.number("zfar", 1.0) <= shape.number("znear", 0.0)) {
                document.warning(shape["zfar"], "should be larger than znear");
            }
        }
    }
}

void check_images(Document& document) {
    for (const Json image : document.items("images")) {
        if (static_cast<bool>(image["uri"]) == static_cast<bool>(image["bufferView"])) {
            document.warning(image, "expected either a uri or a bufferView");
        }
        if (image["bufferView"] && !image["mimeType"]) {
            document.warning(image, "a picture in a bufferView needs a mimeType; its first bytes tell instead");
        }
        const Json view = document.item("bufferViews", image, "bufferView");
        if (view["byteStride"] || view["target"]) {
            document.warning(image["bufferView"], "the view is made for vertices");
        }
    }
}

}  // namespace

void check(Document& document, Accessors& accessors, const Nodes& nodes) {
    check_views(document, accessors);
    for (const Json json : document.items("accessors")) {
        check_alignment(document, json);
        if (!json["bufferView"] && !json["sparse"]) {
            continue;  // zeros, or a stand-in for something compressed
        }
        if (const auto accessor = accessors.open(json)) {
            check_values(document, *accessor);
        }
    }
    if (document.has_errors()) {
        return;
    }
    check_cameras(document);
    check_images(document);
    check_meshes(document);
    check_skins(document, accessors, nodes);
    check_animations(document, accessors);
}

}  // namespace lancer::gltf
