#include "lancer/import/toml/media.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lancer/base/file.h"
#include "lancer/import/toml/colors.h"
#include "lancer/import/toml/transforms.h"

namespace lancer::notation {

namespace {

constexpr double thinnest_box = 1e-9;  // metres

glm::dmat4 box_map(const glm::dvec3& low, const glm::dvec3& high) {
    glm::dmat4 map(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        map[axis][axis] = high[axis] - low[axis];
        map[3][axis] = low[axis];
    }
    return map;
}

// Where the box is, in the grid's own space.
glm::dmat4 read_box(TableReader& reader, const glm::dmat4& otherwise) {
    if (!reader.has("min") && !reader.has("max")) {
        return otherwise;
    }
    if (!reader.has("min") || !reader.has("max")) {
        reader.error(reader.has("min") ? "min" : "max", "\"min\" and \"max\" belong together");
        return otherwise;
    }
    const glm::dvec3 low = reader.vector3("min"), high = reader.vector3("max");
    for (int axis = 0; reader.good() && axis < 3; ++axis) {
        if (!(high[axis] - low[axis] > thinnest_box)) {
            reader.error("min",
                         fmt::format("\"min\" must be less than \"max\": along {} they are {} and {}", "xyz"[axis], low[axis], high[axis]));
        }
    }
    return box_map(low, high);
}

std::optional<glm::ivec3> read_cells(TableReader& reader) {
    const glm::dvec3 written = reader.vector3("cells");
    const glm::ivec3 cells(written);
    if (reader.good() && glm::dvec3(cells) != written) {
        reader.error("cells", "\"cells\" must be whole numbers");
    }
    return reader.good() ? std::optional(cells) : std::nullopt;
}

std::shared_ptr<const scene::VoxelData> read_values(TableReader& reader) {
    if (!reader.has("cells") || !reader.has("values")) {
        reader.error(reader.position(), "a grid needs \"file\", or \"cells\" and \"values\"");
        return nullptr;
    }
    const auto cells = read_cells(reader);
    const std::vector<double> values = reader.numbers("values");
    const int channels = reader.integer("channels");
    if (!cells || !reader.good()) {
        return nullptr;
    }
    const double count = static_cast<double>(cells->x) * cells->y * cells->z * channels;
    if (static_cast<double>(values.size()) != count) {
        reader.error("values", fmt::format("{} cells of {} channel{} have {} values, not {}", count / channels, channels,
                                           channels > 1 ? "s" : "", count, values.size()));
        return nullptr;
    }
    auto data = std::make_shared<scene::VoxelData>();
    data->size = *cells;
    data->channels = channels;
    data->values.assign(values.begin(), values.end());
    return data;
}

std::optional<VoxelFile> read_voxel_file(Context& context, TableReader& reader) {
    const std::string path = path_beside(context.messages.file(), reader.text("file"));
    const bool raw = file_ending(path) == ".raw";
    for (const char* key : {"cells", "channels", "values"}) {
        if (reader.has(key) && (!raw || std::string_view(key) == "values")) {
            reader.error(key, fmt::format("a grid has either \"file\" or \"{}\"", key));
        }
    }
    if (raw && !reader.has("cells")) {
        reader.error("file", "a .raw file needs \"cells\" beside it");
    }
    VoxelWords words;
    words.name = reader.text("name");
    words.channels = reader.integer("channels");
    if (raw && reader.good()) {
        words.cells = read_cells(reader).value_or(glm::ivec3(1));
    }
    if (!reader.good()) {
        return std::nullopt;
    }
    auto found = context.files.voxels(path, words, reader.position("file"));
    if (!found) {
        reader.spoil();
    }
    return found;
}

std::optional<scene::Grid> read_grid(Context& context, TableReader& medium, std::string_view key) {
    const toml::node* node = medium.value(key, Kind::grid);
    if (!node) {
        return std::nullopt;
    }
    const toml::table* table = node->as_table();
    if (!table) {
        medium.error(key, fmt::format("\"{}\" must be a table, {{ file }} or {{ cells, values }}, not {}", key, what_it_is(*node)));
        return std::nullopt;
    }
    TableReader reader(context.messages, *table, grid());
    scene::Grid result;
    if (reader.has("channels") && reader.integer("channels") == 2) {
        reader.error("channels", "\"channels\" must be 1 or 3");
    }
    if (reader.has("file")) {
        if (auto file = read_voxel_file(context, reader)) {
            result = {std::move(file->data), file->to_world, file->fades};
        }
    } else {
        result.data = read_values(reader);
    }
    const glm::dmat4 box = read_box(reader, result.to_world);
    result.to_world = read_transform(reader) * box;
    if (reader.has("fades")) {
        result.fades = reader.flag("fades");
    }
    if (!reader.good() || !result.data) {
        medium.spoil();
        return std::nullopt;
    }
    return result;
}

void read_coefficients(Context& context, TableReader& reader, scene::Medium& medium) {
    const bool sum = reader.has("extinction") || reader.has("albedo") || reader.has("albedo_grid");
    for (const char* key : {"absorption", "scattering"}) {
        if (sum && reader.has(key)) {
            reader.error(key, fmt::format("a medium has either \"extinction\" and \"albedo\" or \"{}\"", key));
        }
    }
    if (!sum) {
        medium.coefficients =
            scene::AbsorbingScattering{read_color(context, reader, "absorption"), read_color(context, reader, "scattering")};
        return;
    }
    if (!reader.has("extinction")) {
        reader.error(reader.position(), "an albedo needs \"extinction\" beside it");
    } else if (!reader.has("albedo") && !reader.has("albedo_grid")) {
        reader.error("extinction", "\"extinction\" needs \"albedo\" beside it");
    } else if (reader.has("albedo") && reader.has("albedo_grid")) {
        reader.error("albedo", "a medium has either \"albedo\" or \"albedo_grid\"");
    }
    medium.coefficients = scene::ExtinctionAlbedo{read_color(context, reader, "extinction"), read_color(context, reader, "albedo")};
}

scene::Medium read_medium(Context& context, const toml::table& table, bool& everywhere) {
    TableReader reader(context.messages, table, medium());
    scene::Medium result;
    result.position = reader.position();
    read_coefficients(context, reader, result);
    result.scale = reader.number("scale");
    result.phase = static_cast<scene::Phase>(reader.choice("phase"));
    result.asymmetry = reader.number("asymmetry");
    if (result.phase == scene::Phase::rayleigh && reader.has("asymmetry")) {
        reader.error("asymmetry", "\"asymmetry\" belongs to the phase henyey-greenstein");
    }
    result.density = read_grid(context, reader, "density");
    result.albedo = read_grid(context, reader, "albedo_grid");
    result.temperature = read_grid(context, reader, "temperature");
    if (!reader.has("density") && (reader.has("albedo_grid") || reader.has("temperature"))) {
        reader.error(reader.has("temperature") ? "temperature" : "albedo_grid", "this needs a \"density\" that is a grid, too");
    }
    if (result.temperature && result.temperature->data->channels != 1) {
        reader.error("temperature", "temperatures have one channel");
    }
    result.emission =
        reader.has("emission") ? read_color(context, reader, "emission") : scene::Color(scene::Rgb(result.temperature ? 1.0 : 0.0));
    result.emission_strength = reader.number("emission_strength");
    everywhere = reader.flag("everywhere");
    return result;
}

std::vector<std::string> medium_names(const scene::Scene& scene) {
    std::vector<std::string> names;
    for (const scene::Medium& medium : scene.media) {
        names.push_back(medium.name);
    }
    return names;
}

}  // namespace

void read_media(Context& context, const toml::table& root) {
    const toml::node* node = root.get("medium");
    if (!node) {
        return;
    }
    const toml::table* all = node->as_table();
    if (!all) {
        context.messages.error(context.messages.at(*node), fmt::format("media are written as [medium.NAME], not as {}",
                                                                       node->is_array() ? "[[medium]]" : what_it_is(*node)));
        return;
    }
    std::vector<std::pair<const toml::key*, const toml::node*>> in_order;  // of the file; toml++ sorts by name
    for (const auto& [key, value] : *all) {
        in_order.emplace_back(&key, &value);
    }
    const auto place_of = [](const auto& w) { return std::pair(w.first->source().begin.line, w.first->source().begin.column); };
    std::sort(in_order.begin(), in_order.end(), [&](const auto& a, const auto& b) { return place_of(a) < place_of(b); });
    for (const auto& [key, value] : in_order) {
        const std::string name(key->str());
        const toml::table* table = value->as_table();
        if (!table) {
            context.messages.error(context.messages.at(*key),
                                   medium().find(name) ? fmt::format("a medium needs a name: [medium.NAME]; \"{}\" stands in none", name)
                                                       : fmt::format("medium \"{}\" must be a table, not {}", name, what_it_is(*value)));
            continue;
        }
        bool everywhere = false;
        scene::Medium result = read_medium(context, *table, everywhere);
        result.name = name;
        if (everywhere && context.scene.medium) {
            context.messages.error(context.messages.at(*table),
                                   fmt::format("only one medium can be everywhere, and \"{}\" is already",
                                               context.scene.media[static_cast<std::size_t>(*context.scene.medium)].name));
        } else if (everywhere) {
            context.scene.medium = static_cast<int>(context.scene.media.size());
        }
        context.scene.media.push_back(std::move(result));
    }
}

std::optional<int> read_interior(Context& context, TableReader& reader) {
    const std::string name = reader.text("interior");
    if (name.empty()) {
        return std::nullopt;
    }
    const std::vector<std::string> names = medium_names(context.scene);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) {
        return static_cast<int>(found - names.begin());
    }
    const std::string hint = did_you_mean(name, names);
    const std::string expected = names.empty() ? fmt::format("; add [medium.{}]", name) : "; there are " + some_of(names);
    reader.error("interior", fmt::format("there is no medium \"{}\"{}", name, hint.empty() ? expected : ";" + hint));
    return std::nullopt;
}

void warn_about_unused_media(Context& context) {
    for (std::size_t i = 0; i < context.scene.media.size(); ++i) {
        const auto number = static_cast<int>(i);
        const auto& materials = context.scene.materials;
        const bool used = context.scene.medium == number ||
                          std::any_of(materials.begin(), materials.end(), [&](const scene::Material& m) { return m.interior == number; });
        if (!used) {
            const scene::Medium& medium = context.scene.media[i];
            context.messages.warning(medium.position, fmt::format("medium \"{}\" is not used", medium.name));
        }
    }
}

}  // namespace lancer::notation
