#include "lancer/import/toml/materials.h"

#include <fmt/format.h>

#include <algorithm>

#include "lancer/import/toml/colors.h"
#include "lancer/import/toml/media.h"
#include "lancer/import/toml/spectra.h"
#include "lancer/spectrum/glass.h"
#include "lancer/spectrum/metal.h"

namespace lancer::notation {

namespace {

// Sellmeier coefficients with a pole or an imaginary index in the visible would be noticed late and far from their cause.
void check_sellmeier(TableReader& reader, const scene::SellmeierGlass& glass) {
    for (double nanometres = 380.0; nanometres <= 780.0; nanometres += 5.0) {
        const double square = nanometres * nanometres * 1e-6;  // square micrometres
        double n_squared = 1.0;
        for (int i = 0; i < 3; ++i) {
            n_squared += glass.b[i] == 0.0 ? 0.0 : glass.b[i] * square / (square - glass.c[i]);
        }
        if (!(n_squared >= 0.01 && n_squared <= 100.0)) {
            reader.error("b", fmt::format("these coefficients give no refractive index between 0.1 and 10 at {} nm: n^2 = {:.4g}",
                                          nanometres, n_squared));
            return;
        }
    }
}

scene::Refraction read_refraction_table(Messages& messages, const toml::table& table) {
    const bool sellmeier = table.contains("b") || table.contains("c");
    TableReader reader(messages, table, sellmeier ? sellmeier_glass() : abbe_glass());
    if (!sellmeier) {
        const double index = reader.number("index");
        return scene::AbbeGlass{index, reader.number("abbe_number")};
    }
    scene::SellmeierGlass glass;
    glass.b = reader.vector3("b");
    glass.c = reader.vector3("c");
    if (reader.good()) {
        check_sellmeier(reader, glass);
    }
    return glass;
}

scene::Refraction read_refraction(Context& context, TableReader& reader, std::string_view name) {
    const Key& key = reader.described(name, Kind::refraction);
    const double preset = std::get<double>(key.preset);
    const toml::node* node = reader.value(name, Kind::refraction);
    if (!node) {
        return preset;
    }
    if (const auto* string = node->as_string()) {
        if (!find_glass(string->get())) {
            const std::string hint = did_you_mean(string->get(), glass_names());
            reader.error(name, fmt::format("there is no glass \"{}\"{}", string->get(),
                                           hint.empty() ? "; known are " + some_of(glass_names()) : ";" + hint));
        }
        return scene::NamedGlass{string->get()};
    }
    if (const toml::table* table = node->as_table(); table && (is_spectrum(*table))) {
        auto curve = read_curve(context, *node, key);
        if (!curve) {
            reader.spoil();
            return preset;
        }
        return std::move(*curve);
    }
    if (const toml::table* table = node->as_table()) {
        return read_refraction_table(reader.messages(), *table);
    }
    double index = preset;
    if (!node->is_number()) {
        reader.error(
            name,
            fmt::format("\"{}\" must be a refractive index, the name of a glass, {{ index, abbe_number }}, {{ b, c }} or a curve, not {}",
                        name, what_it_is(*node)));
    } else if (!read_number(reader.messages(), *node, key, index)) {
        reader.spoil();
        index = preset;
    }
    return index;
}

}  // namespace

namespace {

scene::WhittedMaterial read_whitted(Context& context, TableReader& reader) {
    scene::WhittedMaterial model;
    model.color = read_texture(context, reader, "color");
    model.ambient = reader.number("ambient");
    model.diffuse = reader.number("diffuse");
    model.highlight = reader.number("highlight");
    model.shininess = reader.number("shininess");
    model.reflectivity = reader.number("reflectivity");
    model.transparency = reader.number("transparency");
    model.refraction = read_refraction(context, reader, "refraction");
    model.absorption = read_color(context, reader, "absorption");
    const double together = model.reflectivity + model.transparency;
    if (reader.good() && together > 1.0 + 1e-9) {
        reader.error(
            "transparency",
            fmt::format("\"reflectivity\" and \"transparency\" share the light that arrives: together at most 1, not {}", together));
    }
    return model;
}

scene::DiffuseMaterial read_diffuse(Context& context, TableReader& reader) {
    return {read_texture(context, reader, "color"), read_value(context, reader, "roughness")};
}

std::optional<scene::Index> read_index(Context& context, TableReader& reader, std::string_view name) {
    const toml::node* node = reader.value(name, Kind::index);
    if (!node) {
        return std::nullopt;
    }
    const Key& key = reader.described(name, Kind::index);
    if (node->is_array()) {
        scene::Rgb rgb(0.0);
        if (!read_numbers(reader.messages(), *node, key, 3, "a curve or three numbers [r, g, b]", &rgb.x)) {
            reader.spoil();
        }
        return rgb;
    }
    auto curve = read_curve(context, *node, key);
    if (!curve) {
        reader.spoil();
        return std::nullopt;
    }
    return std::move(*curve);
}

scene::Facets read_facets(TableReader& reader) {
    scene::Facets facets;
    facets.distribution = reader.choice("facets") == 1 ? scene::Facets::Distribution::beckmann : scene::Facets::Distribution::ggx;
    facets.separate = reader.choice("facet_shadows") == 1;
    facets.once = reader.choice("facet_light") == 1;
    return facets;
}

scene::ConductorMaterial read_conductor(Context& context, TableReader& reader) {
    scene::ConductorMaterial model;
    model.metal = reader.text("metal");
    if (reader.has("metal") && !find_metal(model.metal)) {
        const std::string hint = did_you_mean(model.metal, metal_names());
        reader.error("metal", fmt::format("there is no metal \"{}\"{}", model.metal,
                                          hint.empty() ? "; known are " + some_of(metal_names()) : ";" + hint));
    }
    model.n = read_index(context, reader, "n");
    model.k = read_index(context, reader, "k");
    if (reader.has("n") != reader.has("k")) {
        reader.error(reader.has("n") ? "n" : "k", "\"n\" and \"k\" belong together");
    }
    if (reader.has("n") && reader.has("metal")) {
        reader.error("metal", "a conductor has either \"n\" and \"k\" or \"metal\"");
    }
    model.color = read_texture(context, reader, "color");
    model.roughness = read_value(context, reader, "roughness");
    model.anisotropy = read_value(context, reader, "anisotropy");
    model.facets = read_facets(reader);
    return model;
}

scene::DielectricMaterial read_dielectric(Context& context, TableReader& reader) {
    scene::DielectricMaterial model;
    model.refraction = read_refraction(context, reader, "refraction");
    model.color = read_texture(context, reader, "color");
    model.roughness = read_value(context, reader, "roughness");
    model.anisotropy = read_value(context, reader, "anisotropy");
    model.absorption = read_color(context, reader, "absorption");
    model.thin = reader.flag("thin");
    model.facets = read_facets(reader);
    if (reader.good() && model.thin && model.roughness.most() > 0.0) {
        reader.error("roughness", "a thin dielectric is smooth: write roughness = 0, or thin = false");
    }
    return model;
}

scene::PlasticMaterial read_plastic(Context& context, TableReader& reader) {
    return {read_texture(context, reader, "color"), reader.number("refraction"), read_value(context, reader, "roughness"),
            reader.flag("saturates"), read_facets(reader)};
}

void read_coat_relief(Context& context, TableReader& reader, scene::PrincipledMaterial& model) {
    const bool has_map = reader.has("coat_normal_map");
    if (reader.flag("coat_smooth") || has_map) {
        model.coat_relief.emplace();
    }
    if (has_map) {
        model.coat_relief->normals = read_texture(context, reader, "coat_normal_map", true);
        model.coat_relief->scale = reader.number("coat_normal_scale");
        if (reader.good() && model.coat_relief->normals->index() == 0) {
            reader.error("coat_normal_map", "\"coat_normal_map\" must be a texture: a color bends all normals alike");
        }
    }
    if (reader.has("coat_normal_scale") && !has_map) {
        reader.error("coat_normal_scale", "\"coat_normal_scale\" needs \"coat_normal_map\" beside it");
    }
    if (has_map && reader.flag("coat_smooth")) {
        reader.error("coat_smooth", "a coat is either smooth or has a \"coat_normal_map\"");
    }
}

scene::PrincipledMaterial read_principled(Context& context, TableReader& reader) {
    scene::PrincipledMaterial model;
    model.color = read_texture(context, reader, "color");
    model.metalness = read_value(context, reader, "metalness");
    model.roughness = read_value(context, reader, "roughness");
    model.anisotropy = read_value(context, reader, "anisotropy");
    model.refraction = reader.number("refraction");
    model.specular = read_texture(context, reader, "specular");
    model.transmission = read_value(context, reader, "transmission");
    model.thin = reader.flag("thin");
    model.absorption = read_color(context, reader, "absorption");
    model.coat = read_value(context, reader, "coat");
    model.coat_roughness = read_value(context, reader, "coat_roughness");
    model.sheen = read_texture(context, reader, "sheen");
    model.sheen_roughness = read_value(context, reader, "sheen_roughness");
    model.film = read_value(context, reader, "film");
    model.film_refraction = reader.number("film_refraction");
    model.dispersion = reader.number("dispersion");
    read_coat_relief(context, reader, model);
    model.turn = reader.number("turn");
    if (reader.has("smooth_along")) {
        model.smooth_along = read_texture(context, reader, "smooth_along", true);
    }
    return model;
}

scene::BurleyMaterial read_burley(Context& context, TableReader& reader) {
    scene::BurleyMaterial model;
    model.color = read_texture(context, reader, "color");
    model.roughness = read_value(context, reader, "roughness");
    model.anisotropy = read_value(context, reader, "anisotropy");
    model.refraction = reader.number("refraction");
    model.specular_tint = reader.number("specular_tint");
    model.metalness = read_value(context, reader, "metalness");
    model.transmission = read_value(context, reader, "transmission");
    model.flatness = reader.number("flatness");
    model.sheen = read_value(context, reader, "sheen");
    model.sheen_tint = reader.number("sheen_tint");
    model.coat = read_value(context, reader, "coat");
    model.coat_gloss = reader.number("coat_gloss");
    model.thin = reader.flag("thin");
    model.passes = read_value(context, reader, "passes");
    return model;
}

scene::Relief read_relief(Context& context, TableReader& reader) {
    scene::Relief relief;
    if (reader.has("normal_map")) {
        relief.normals = read_texture(context, reader, "normal_map", true);
        if (reader.good() && relief.normals->index() == 0) {
            reader.error("normal_map", "\"normal_map\" must be a texture: a color bends all normals alike");
        }
    }
    relief.scale = reader.number("normal_scale");
    relief.flips_green = reader.flag("normal_flip_green");
    relief.crosswise = reader.flag("normal_crosswise");
    for (const char* key : {"normal_scale", "normal_flip_green", "normal_crosswise"}) {
        if (reader.has(key) && !relief.normals) {
            reader.error(key, fmt::format("\"{}\" needs \"normal_map\" beside it", key));
        }
    }
    if (reader.has("bump")) {
        relief.heights = read_value(context, reader, "bump");
    }
    relief.shadows = reader.flag("relief_shadows");
    if (relief.shadows && !relief.normals && !relief.heights) {
        reader.error("relief_shadows", "\"relief_shadows\" needs \"normal_map\" or \"bump\" beside it");
    }
    return relief;
}

std::optional<scene::Emission> read_emission(Context& context, TableReader& reader) {
    const scene::Emission emission{read_texture(context, reader, "emission"), reader.number("emission_strength"),
                                   reader.choice("emission_sides") == 1};
    if (!reader.has("emission")) {
        for (const char* key : {"emission_strength", "emission_sides"}) {
            if (reader.has(key)) {
                reader.error(key, fmt::format("\"{}\" needs \"emission\" beside it", key));
            }
        }
        return std::nullopt;
    }
    return emission;
}

}  // namespace

scene::Material Materials::read_table(const toml::table& table) {
    std::vector<std::string> types;
    for (const Table* kind : materials()) {
        types.emplace_back(kind->name);
    }
    const toml::node* node = table.get("type");
    const auto* type = node ? node->as_string() : nullptr;
    const auto found = !node ? types.begin() : type ? std::find(types.begin(), types.end(), type->get()) : types.end();
    scene::Material material;
    material.position = context_.messages.at(table);
    if (found == types.end()) {
        std::string hint = type ? did_you_mean(type->get(), types) : "";
        hint = hint.empty() ? "; known are " + some_of(types) : ";" + hint;
        context_.messages.error(context_.messages.at(*node), type ? fmt::format("there is no material of type \"{}\"{}", type->get(), hint)
                                                                  : fmt::format("\"type\" must be a text, not {}", what_it_is(*node)));
        return material;
    }
    const auto kind = static_cast<std::size_t>(found - types.begin());
    TableReader reader(context_.messages, table, *materials()[kind]);
    switch (kind) {
        case 0:
            material.model = read_whitted(context_, reader);
            return material;
        case 1:
            material.model = read_diffuse(context_, reader);
            break;
        case 2:
            material.model = read_conductor(context_, reader);
            break;
        case 3:
            material.model = read_dielectric(context_, reader);
            break;
        case 4:
            material.model = read_plastic(context_, reader);
            break;
        case 5:
            material.model = read_principled(context_, reader);
            break;
        case 6:
            material.model = read_burley(context_, reader);
            break;
        case 7:
            material.model = read_mix(reader);
            break;
        default:
            material.model = scene::NullMaterial{};
            material.interior = read_interior(context_, reader);
            material.priority = reader.integer("priority");
            return material;
    }
    if (materials()[kind]->find("interior")) {
        material.interior = read_interior(context_, reader);
        material.priority = reader.integer("priority");
        if (reader.has("interior") && reader.has("absorption")) {
            reader.error("interior", "a material has either an \"interior\" or \"absorption\"");
        }
        if (reader.has("interior") && !std::holds_alternative<scene::DielectricMaterial>(material.model) && reader.has("thin") &&
            reader.flag("thin")) {
            reader.error("interior", "a material has either an \"interior\" or \"thin\"");
        }
    }
    material.emission = read_emission(context_, reader);
    read_sides(reader, material);
    if (!std::holds_alternative<scene::MixMaterial>(material.model)) {
        material.relief = read_relief(context_, reader);
    }
    return material;
}

scene::MixMaterial Materials::read_mix(TableReader& reader) {
    scene::MixMaterial mix;
    mix.first = std::max(read(reader, "first"), 0);
    mix.second = std::max(read(reader, "second"), 0);
    mix.share = read_value(context_, reader, "share");
    return mix;
}

void Materials::read_sides(TableReader& reader, scene::Material& material) {
    material.opacity = read_value(context_, reader, "opacity");
    material.opacity_cutoff = reader.number("opacity_cutoff");
    if (const int behind = read(reader, "behind"); behind >= 0) {
        material.behind = behind;
    }
    material.one_sided = reader.flag("one_sided");
    material.open_behind = reader.flag("open_behind");
    if (reader.has("opacity_cutoff") && !reader.has("opacity")) {
        reader.error("opacity_cutoff", "\"opacity_cutoff\" needs \"opacity\" beside it");
    }
    if (reader.has("behind") && material.one_sided) {
        reader.error("one_sided", "a material has either \"behind\" or one_sided = true");
    }
    if (material.open_behind && (reader.has("behind") || material.one_sided)) {
        reader.error("open_behind", "a material that is not there from behind has neither \"behind\" nor one_sided = true");
    }
}

void Materials::read_names(const toml::table& root) {
    const toml::node* node = root.get("material");
    if (!node) {
        return;
    }
    const toml::table* all = node->as_table();
    if (!all) {
        context_.messages.error(context_.messages.at(*node), fmt::format("materials are written as [material.NAME], not as {}",
                                                                         node->is_array() ? "[[material]]" : what_it_is(*node)));
        return;
    }
    for (const auto& [key, value] : *all) {
        in_order_.push_back({&key, &value});
    }
    const auto place_of = [](const Written& w) { return std::pair(w.key->source().begin.line, w.key->source().begin.column); };
    std::sort(in_order_.begin(), in_order_.end(), [&](const Written& a, const Written& b) { return place_of(a) < place_of(b); });
    // First the names, since mixes speak of others that may come later; those written in place come after all of them.
    for (const Written& written : in_order_) {
        const std::string name(written.key->str());
        if (written.node->is_table()) {
            by_name_[name] = static_cast<int>(context_.scene.materials.size());
            context_.scene.materials.emplace_back();
            context_.scene.materials.back().name = name;
        } else if (whitted_material().find(name)) {
            context_.messages.error(context_.messages.at(*written.key),
                                    fmt::format("a material needs a name: [material.NAME]; \"{}\" stands in none", name));
        } else {
            context_.messages.error(context_.messages.at(*written.node),
                                    fmt::format("material \"{}\" must be a table, not {}", name, what_it_is(*written.node)));
        }
    }
    used_.assign(context_.scene.materials.size(), false);
}

void Materials::read_named() {
    for (const Written& written : in_order_) {
        if (const toml::table* table = written.node->as_table()) {
            const std::string name(written.key->str());
            scene::Material material = read_table(*table);
            material.name = name;
            context_.scene.materials[static_cast<std::size_t>(by_name_[name])] = std::move(material);
        }
    }
}

std::vector<int> Materials::adopt(std::vector<scene::Material>&& included) {
    std::vector<scene::Material>& all = context_.scene.materials;
    const int first = static_cast<int>(all.size());
    std::vector<int> numbers;
    for (std::size_t i = 0; i < included.size(); ++i) {
        const std::string& name = included[i].name;
        const auto known = name.empty() ? by_name_.end() : by_name_.find(name);
        if (known != by_name_.end() && static_cast<std::size_t>(known->second) < used_.size()) {
            used_[static_cast<std::size_t>(known->second)] = true;
            numbers.push_back(known->second);
        } else {
            numbers.push_back(first + static_cast<int>(i));
        }
    }
    for (std::size_t i = 0; i < included.size(); ++i) {
        scene::Material& material = all.emplace_back(std::move(included[i]));
        const auto renumbered = [&](int old) { return numbers[static_cast<std::size_t>(old)]; };
        if (material.behind) {
            material.behind = renumbered(*material.behind);
        }
        if (auto* mix = std::get_if<scene::MixMaterial>(&material.model)) {
            mix->first = renumbered(mix->first);
            mix->second = renumbered(mix->second);
        }
        if (!material.name.empty()) {
            by_name_.try_emplace(material.name, first + static_cast<int>(i));
        }
    }
    return numbers;
}

int Materials::read(TableReader& reader, std::string_view key) {
    const toml::node* node = reader.value(key, Kind::material);
    if (!node) {
        return -1;
    }
    if (const toml::table* table = node->as_table()) {
        scene::Material material = read_table(*table);
        context_.scene.materials.push_back(std::move(material));
        return static_cast<int>(context_.scene.materials.size()) - 1;
    }
    const auto* string = node->as_string();
    if (!string) {
        reader.error(key, fmt::format("\"{}\" must be the name of a material or a table, not {}", key, what_it_is(*node)));
        return -1;
    }
    if (const auto found = by_name_.find(string->get()); found != by_name_.end()) {
        if (static_cast<std::size_t>(found->second) < used_.size()) {
            used_[static_cast<std::size_t>(found->second)] = true;
        }
        return found->second;
    }
    reader.spoil();
    if (context_.messages.full()) {
        return -1;
    }
    std::vector<std::string> names;
    for (const auto& [name, index] : by_name_) {
        names.push_back(name);
    }
    const std::string hint = did_you_mean(string->get(), names);
    const std::string expected = names.empty() ? fmt::format("; add [material.{}]", string->get()) : "; there are " + some_of(names);
    reader.error(key, fmt::format("there is no material \"{}\"{}", string->get(), hint.empty() ? expected : ";" + hint));
    return -1;
}

int Materials::preset() {
    if (preset_ < 0) {
        preset_ = static_cast<int>(context_.scene.materials.size());
        context_.scene.materials.push_back({{}, scene::WhittedMaterial{}, {context_.messages.file(), 0, 0}, std::nullopt, true});
    }
    return preset_;
}

void Materials::warn_about_unused() {
    for (std::size_t i = 0; i < used_.size(); ++i) {
        if (!used_[i]) {
            const scene::Material& material = context_.scene.materials[i];
            context_.messages.warning(material.position, fmt::format("material \"{}\" is not used", material.name));
        }
    }
}

}  // namespace lancer::notation
