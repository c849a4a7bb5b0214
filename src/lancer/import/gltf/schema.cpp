#include "lancer/import/gltf/schema.h"

#include <algorithm>
#include <array>

namespace lancer::gltf {

namespace {

using T = Type;

constexpr bool needed = true;
constexpr bool optional = false;
constexpr double u8_to_u32 = 4294967295.0;
constexpr double safe = 9007199254740991.0;  // the largest odd whole number of a double

constexpr Property named = {"name", T::text};

constexpr Property root[] = {
    {"extensionsUsed", T::texts},
    {"extensionsRequired", T::texts},
    {"accessors", T::objects, "accessor"},
    {"animations", T::objects, "animation"},
    {"asset", T::object, "asset", needed},
    {"buffers", T::objects, "buffer"},
    {"bufferViews", T::objects, "bufferView"},
    {"cameras", T::objects, "camera"},
    {"images", T::objects, "image"},
    {"materials", T::objects, "material"},
    {"meshes", T::objects, "mesh"},
    {"nodes", T::objects, "node"},
    {"samplers", T::objects, "sampler"},
    {"scene", T::index, "scenes"},
    {"scenes", T::objects, "scene"},
    {"skins", T::objects, "skin"},
    {"textures", T::objects, "texture"},
};

constexpr Property asset[] = {
    {"copyright", T::text},
    {"generator", T::text},
    {"version", T::text, {}, needed},
    {"minVersion", T::text},
};

constexpr Property accessor[] = {
    named,
    {"bufferView", T::index, "bufferViews"},
    {"byteOffset", T::integer, {}, optional, 0.0, safe},
    {"componentType", T::integer, {}, needed, -unbounded, unbounded, "5120 5121 5122 5123 5125 5126"},
    {"normalized", T::boolean},
    {"count", T::integer, {}, needed, 1.0, safe},
    {"type", T::text, {}, needed, -unbounded, unbounded, "SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4"},
    {"max", T::numbers, {}, optional, -unbounded, unbounded, {}, 1, 16},
    {"min", T::numbers, {}, optional, -unbounded, unbounded, {}, 1, 16},
    {"sparse", T::object, "sparse"},
};

constexpr Property sparse[] = {
    {"count", T::integer, {}, needed, 1.0, safe},
    {"indices", T::object, "sparseIndices", needed},
    {"values", T::object, "sparseValues", needed},
};
constexpr Property sparse_indices[] = {
    {"bufferView", T::index, "bufferViews", needed},
    {"byteOffset", T::integer, {}, optional, 0.0, safe},
    {"componentType", T::integer, {}, needed, -unbounded, unbounded, "5121 5123 5125"},
};
constexpr Property sparse_values[] = {
    {"bufferView", T::index, "bufferViews", needed},
    {"byteOffset", T::integer, {}, optional, 0.0, safe},
};

constexpr Property animation[] = {
    named,
    {"channels", T::objects, "channel", needed},
    {"samplers", T::objects, "animationSampler", needed},
};
constexpr Property channel[] = {
    {"sampler", T::integer, {}, needed, 0.0, u8_to_u32},  // into its animation's samplers
    {"target", T::object, "channelTarget", needed},
};
constexpr Property channel_target[] = {
    {"node", T::index, "nodes"},
    {"path", T::text, {}, needed, -unbounded, unbounded, "translation rotation scale weights pointer"},
};
constexpr Property animation_sampler[] = {
    {"input", T::index, "accessors", needed},
    {"interpolation", T::text, {}, optional, -unbounded, unbounded, "LINEAR STEP CUBICSPLINE"},
    {"output", T::index, "accessors", needed},
};

constexpr Property buffer[] = {
    named,
    {"uri", T::text},
    {"byteLength", T::integer, {}, needed, 1.0, safe},
};
constexpr Property buffer_view[] = {
    named,
    {"buffer", T::index, "buffers", needed},
    {"byteOffset", T::integer, {}, optional, 0.0, safe},
    {"byteLength", T::integer, {}, needed, 1.0, safe},
    {"byteStride", T::integer, {}, optional, 4.0, 252.0},
    {"target", T::integer, {}, optional, -unbounded, unbounded, "34962 34963"},
};

constexpr Property camera[] = {
    named,
    {"orthographic", T::object, "orthographic"},
    {"perspective", T::object, "perspective"},
    {"type", T::text, {}, needed, -unbounded, unbounded, "perspective orthographic"},
};
constexpr Property orthographic[] = {
    {"xmag", T::number, {}, needed},
    {"ymag", T::number, {}, needed},
    {"zfar", T::number, {}, needed, 0.0},
    {"znear", T::number, {}, needed, 0.0},
};
constexpr Property perspective[] = {
    {"aspectRatio", T::number, {}, optional, 0.0},
    {"yfov", T::number, {}, needed, 0.0},
    {"zfar", T::number, {}, optional, 0.0},
    {"znear", T::number, {}, needed, 0.0},
};

constexpr Property image[] = {
    named,
    {"uri", T::text},
    {"mimeType", T::text, {}, optional, -unbounded, unbounded, "image/jpeg image/png image/webp image/ktx2 image/vnd-ms.dds"},
    {"bufferView", T::index, "bufferViews"},
};

constexpr Property material[] = {
    named,
    {"pbrMetallicRoughness", T::object, "pbrMetallicRoughness"},
    {"normalTexture", T::object, "normalTextureInfo"},
    {"occlusionTexture", T::object, "occlusionTextureInfo"},
    {"emissiveTexture", T::object, "textureInfo"},
    {"emissiveFactor", T::numbers, {}, optional, 0.0, 1.0, {}, 3, 3},
    {"alphaMode", T::text, {}, optional, -unbounded, unbounded, "OPAQUE MASK BLEND"},
    {"alphaCutoff", T::number, {}, optional, 0.0},
    {"doubleSided", T::boolean},
};
constexpr Property pbr[] = {
    {"baseColorFactor", T::numbers, {}, optional, 0.0, 1.0, {}, 4, 4},
    {"baseColorTexture", T::object, "textureInfo"},
    {"metallicFactor", T::number, {}, optional, 0.0, 1.0},
    {"roughnessFactor", T::number, {}, optional, 0.0, 1.0},
    {"metallicRoughnessTexture", T::object, "textureInfo"},
};
constexpr Property texture_info[] = {
    {"index", T::index, "textures", needed},
    {"texCoord", T::integer, {}, optional, 0.0, u8_to_u32},
};
constexpr Property normal_texture_info[] = {
    {"index", T::index, "textures", needed},
    {"texCoord", T::integer, {}, optional, 0.0, u8_to_u32},
    {"scale", T::number},
};
constexpr Property occlusion_texture_info[] = {
    {"index", T::index, "textures", needed},
    {"texCoord", T::integer, {}, optional, 0.0, u8_to_u32},
    {"strength", T::number, {}, optional, 0.0, 1.0},
};

constexpr Property mesh[] = {
    named,
    {"primitives", T::objects, "primitive", needed},
    {"weights", T::numbers},
};
constexpr Property primitive[] = {
    {"attributes", T::index_map, "accessors", needed}, {"indices", T::index, "accessors"},      {"material", T::index, "materials"},
    {"mode", T::integer, {}, optional, 0.0, 6.0},      {"targets", T::index_maps, "accessors"},
};

constexpr Property node[] = {
    named,
    {"camera", T::index, "cameras"},
    {"children", T::indices, "nodes"},
    {"skin", T::index, "skins"},
    {"matrix", T::numbers, {}, optional, -unbounded, unbounded, {}, 16, 16},
    {"mesh", T::index, "meshes"},
    {"rotation", T::numbers, {}, optional, -1.0, 1.0, {}, 4, 4},
    {"scale", T::numbers, {}, optional, -unbounded, unbounded, {}, 3, 3},
    {"translation", T::numbers, {}, optional, -unbounded, unbounded, {}, 3, 3},
    {"weights", T::numbers},
};

constexpr Property sampler[] = {
    named,
    {"magFilter", T::integer, {}, optional, -unbounded, unbounded, "9728 9729"},
    {"minFilter", T::integer, {}, optional, -unbounded, unbounded, "9728 9729 9984 9985 9986 9987"},
    {"wrapS", T::integer, {}, optional, -unbounded, unbounded, "33071 33648 10497"},
    {"wrapT", T::integer, {}, optional, -unbounded, unbounded, "33071 33648 10497"},
};

constexpr Property scene[] = {named, {"nodes", T::indices, "nodes"}};

constexpr Property skin[] = {
    named,
    {"inverseBindMatrices", T::index, "accessors"},
    {"skeleton", T::index, "nodes"},
    {"joints", T::indices, "nodes", needed},
};

constexpr Property texture[] = {named, {"sampler", T::index, "samplers"}, {"source", T::index, "images"}};

constexpr Schema schemas[] = {
    {"gltf", root},
    {"asset", asset},
    {"accessor", accessor},
    {"sparse", sparse},
    {"sparseIndices", sparse_indices},
    {"sparseValues", sparse_values},
    {"animation", animation},
    {"channel", channel},
    {"channelTarget", channel_target},
    {"animationSampler", animation_sampler},
    {"buffer", buffer},
    {"bufferView", buffer_view},
    {"camera", camera},
    {"orthographic", orthographic},
    {"perspective", perspective},
    {"image", image},
    {"material", material},
    {"pbrMetallicRoughness", pbr},
    {"textureInfo", texture_info},
    {"normalTextureInfo", normal_texture_info},
    {"occlusionTextureInfo", occlusion_texture_info},
    {"mesh", mesh},
    {"primitive", primitive},
    {"node", node},
    {"sampler", sampler},
    {"scene", scene},
    {"skin", skin},
    {"texture", texture},
};

}  // namespace

std::span<const Schema> core_schemas() { return schemas; }

const Schema* find_schema(std::string_view name) {
    for (const std::span<const Schema> list : {core_schemas(), extension_schemas()}) {
        const auto found = std::find_if(list.begin(), list.end(), [&](const Schema& schema) { return schema.name == name; });
        if (found != list.end()) {
            return &*found;
        }
    }
    return nullptr;
}

}  // namespace lancer::gltf
