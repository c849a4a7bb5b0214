// The extensions that we read; each is named after what it extends.
#include "lancer/import/gltf/schema.h"

namespace lancer::gltf {

namespace {

using T = Type;

constexpr bool needed = true;
constexpr bool optional = false;
constexpr double safe = 9007199254740991.0;

constexpr Property lights[] = {{"lights", T::objects, "light", needed}};
constexpr Property light[] = {
    {"name", T::text},
    {"color", T::numbers, {}, optional, 0.0, 1.0, {}, 3, 3},
    {"intensity", T::number, {}, optional, 0.0},
    {"spot", T::object, "spot"},
    {"type", T::text, {}, needed, -unbounded, unbounded, "directional point spot"},
    {"range", T::number, {}, optional, 0.0},
};
constexpr Property spot[] = {
    {"innerConeAngle", T::number, {}, optional, 0.0, 1.5707963267948966},
    {"outerConeAngle", T::number, {}, optional, 0.0, 1.5707963267948966},
};
constexpr Property node_light[] = {{"light", T::integer, {}, needed, 0.0, safe}};

constexpr Property emissive_strength[] = {{"emissiveStrength", T::number, {}, optional, 0.0}};
constexpr Property ior[] = {{"ior", T::number, {}, optional, 0.0}};
constexpr Property specular[] = {
    {"specularFactor", T::number, {}, optional, 0.0, 1.0},
    {"specularTexture", T::object, "textureInfo"},
    {"specularColorFactor", T::numbers, {}, optional, 0.0, unbounded, {}, 3, 3},
    {"specularColorTexture", T::object, "textureInfo"},
};
constexpr Property clearcoat[] = {
    {"clearcoatFactor", T::number, {}, optional, 0.0, 1.0},          {"clearcoatTexture", T::object, "textureInfo"},
    {"clearcoatRoughnessFactor", T::number, {}, optional, 0.0, 1.0}, {"clearcoatRoughnessTexture", T::object, "textureInfo"},
    {"clearcoatNormalTexture", T::object, "normalTextureInfo"},
};
constexpr Property sheen[] = {
    {"sheenColorFactor", T::numbers, {}, optional, 0.0, 1.0, {}, 3, 3},
    {"sheenColorTexture", T::object, "textureInfo"},
    {"sheenRoughnessFactor", T::number, {}, optional, 0.0, 1.0},
    {"sheenRoughnessTexture", T::object, "textureInfo"},
};
constexpr Property transmission[] = {
    {"transmissionFactor", T::number, {}, optional, 0.0, 1.0},
    {"transmissionTexture", T::object, "textureInfo"},
};
constexpr Property volume[] = {
    {"thicknessFactor", T::number, {}, optional, 0.0},
    {"thicknessTexture", T::object, "textureInfo"},
    {"attenuationDistance", T::number, {}, optional, 0.0},
    {"attenuationColor", T::numbers, {}, optional, 0.0, 1.0, {}, 3, 3},
};
constexpr Property dispersion[] = {{"dispersion", T::number, {}, optional, 0.0}};
constexpr Property iridescence[] = {
    {"iridescenceFactor", T::number, {}, optional, 0.0, 1.0},
    {"iridescenceTexture", T::object, "textureInfo"},
    {"iridescenceIor", T::number, {}, optional, 1.0},
    {"iridescenceThicknessMinimum", T::number, {}, optional, 0.0},
    {"iridescenceThicknessMaximum", T::number, {}, optional, 0.0},
    {"iridescenceThicknessTexture", T::object, "textureInfo"},
};
constexpr Property anisotropy[] = {
    {"anisotropyStrength", T::number, {}, optional, 0.0, 1.0},
    {"anisotropyRotation", T::number},
    {"anisotropyTexture", T::object, "textureInfo"},
};

constexpr Property variants[] = {{"variants", T::objects, "variant", needed}};
constexpr Property variant[] = {{"name", T::text, {}, needed}};
constexpr Property mappings[] = {{"mappings", T::objects, "mapping", needed}};
constexpr Property mapping[] = {
    {"variants", T::numbers, {}, needed, 0.0, safe},
    {"material", T::index, "materials", needed},
    {"name", T::text},
};

constexpr Property texture_transform[] = {
    {"offset", T::numbers, {}, optional, -unbounded, unbounded, {}, 2, 2},
    {"rotation", T::number},
    {"scale", T::numbers, {}, optional, -unbounded, unbounded, {}, 2, 2},
    {"texCoord", T::integer, {}, optional, 0.0, safe},
};
constexpr Property webp[] = {{"source", T::index, "images", needed}};

constexpr Property draco[] = {
    {"bufferView", T::index, "bufferViews", needed},
    {"attributes", T::index_map, {}, needed},
};
constexpr Property meshopt_view[] = {
    {"buffer", T::index, "buffers", needed},
    {"byteOffset", T::integer, {}, optional, 0.0, safe},
    {"byteLength", T::integer, {}, needed, 1.0, safe},
    {"byteStride", T::integer, {}, needed, 1.0, 256.0},
    {"mode", T::text, {}, needed, -unbounded, unbounded, "ATTRIBUTES TRIANGLES INDICES"},
    {"count", T::integer, {}, needed, 0.0, safe},
    {"filter", T::text, {}, optional, -unbounded, unbounded, "NONE OCTAHEDRAL QUATERNION EXPONENTIAL"},
};
constexpr Property meshopt_buffer[] = {{"fallback", T::boolean}};
constexpr Property instancing[] = {{"attributes", T::index_map, "accessors", needed}};

constexpr Schema schemas[] = {
    {"gltf/KHR_lights_punctual", lights},
    {"light", light},
    {"spot", spot},
    {"node/KHR_lights_punctual", node_light},
    {"material/KHR_materials_unlit", {}},
    {"material/KHR_materials_emissive_strength", emissive_strength},
    {"material/KHR_materials_ior", ior},
    {"material/KHR_materials_specular", specular},
    {"material/KHR_materials_clearcoat", clearcoat},
    {"material/KHR_materials_sheen", sheen},
    {"material/KHR_materials_transmission", transmission},
    {"material/KHR_materials_volume", volume},
    {"material/KHR_materials_dispersion", dispersion},
    {"material/KHR_materials_iridescence", iridescence},
    {"material/KHR_materials_anisotropy", anisotropy},
    {"gltf/KHR_materials_variants", variants},
    {"variant", variant},
    {"primitive/KHR_materials_variants", mappings},
    {"mapping", mapping},
    {"textureInfo/KHR_texture_transform", texture_transform},
    {"normalTextureInfo/KHR_texture_transform", texture_transform},
    {"occlusionTextureInfo/KHR_texture_transform", texture_transform},
    {"texture/EXT_texture_webp", webp},
    {"primitive/KHR_draco_mesh_compression", draco},
    {"bufferView/EXT_meshopt_compression", meshopt_view},
    {"buffer/EXT_meshopt_compression", meshopt_buffer},
    {"node/EXT_mesh_gpu_instancing", instancing},
};

}  // namespace

std::span<const Schema> extension_schemas() { return schemas; }

}  // namespace lancer::gltf
