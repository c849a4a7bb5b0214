#include "lancer/world/thrown.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "lancer/kernel/emitter/emitter.h"
#include "lancer/world/spectra.h"

namespace lancer {

namespace {

// Cells to draw directions from, and points in each of them, each way, at which the light is looked up.
constexpr int most_cells = 128;
constexpr int points_a_cell = 4;
// What is left for light that these miss, in parts of the mean.
constexpr double unseen_light = 0.02;

kernel::Vec3 to_kernel(const glm::dvec3& v) {
    return kernel::vec3_of(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

// The direction of a place in the picture.
glm::dvec3 way_at(const kernel::EmitterRecord& record, double u, double v) {
    using std::numbers::pi;
    const glm::dvec3 axis(record.direction), across(record.across), upwards(record.upwards);
    if (record.kind == kernel::EMITTER_PROJECTOR) {
        return glm::normalize(axis + across * ((2.0 * u - 1.0) / glm::dot(across, across)) +
                              upwards * ((2.0 * v - 1.0) / glm::dot(upwards, upwards)));
    }
    const double turn = 2.0 * pi * u;
    const double sine = std::sin(pi * v), cosine = std::cos(pi * v);
    if (record.kind == kernel::EMITTER_GONIOMETRIC) {
        return -axis * (std::cos(turn) * sine) - across * (std::sin(turn) * sine) - upwards * cosine;
    }
    return across * (std::cos(turn) * sine) + upwards * (std::sin(turn) * sine) + axis * cosine;
}

// Solid angle of a part of the picture.
double solid_angle(const kernel::EmitterRecord& record, double u, double v, double du, double dv) {
    using std::numbers::pi;
    if (record.kind == kernel::EMITTER_PROJECTOR) {
        const double depth = glm::dot(way_at(record, u, v), glm::dvec3(record.direction));
        const double size = glm::length(glm::dvec3(record.across)) * glm::length(glm::dvec3(record.upwards));
        return 4.0 * du * dv * depth * depth * depth / size;
    }
    return 2.0 * pi * du * (std::cos(pi * (v - 0.5 * dv)) - std::cos(pi * (v + 0.5 * dv)));
}

// Luminance of the intensity there.
double light_at(const World& world, const kernel::WorldRecord& tables, const kernel::EmitterRecord& record, double u, double v) {
    const kernel::Vec3 way = to_kernel(way_at(record, u, v));
    double light = static_cast<double>(kernel::thrown_share(tables, record, way, true));
    if (record.light.texture >= 0) {
        kernel::SurfacePoint point = kernel::no_surface();
        point.uv = kernel::vec2_of(static_cast<float>(u), static_cast<float>(v));
        const kernel::TextureRecord& texture = world.textures[static_cast<std::size_t>(record.light.texture)];
        const kernel::Vec4 rgb = kernel::texture_color(tables, texture, point, true);
        light *= brightness({rgb.x, rgb.y, rgb.z});
    }
    return light;
}

void put_shares(const std::vector<double>& parts, std::vector<float>& shares) {
    double sum = 0.0;
    for (const double part : parts) {
        sum += part;
    }
    double so_far = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        so_far += parts[i];
        shares.push_back(static_cast<float>(sum > 0.0 ? so_far / sum : static_cast<double>(i + 1) / static_cast<double>(parts.size())));
    }
}

// The cells' cumulative shares. Returns the mean intensity over `opening`, a solid angle.
double share_out(World& world, int columns, int rows, double opening, kernel::EmitterRecord& record) {
    const kernel::WorldRecord tables = world.record();
    const double du = 1.0 / (columns * points_a_cell), dv = 1.0 / (rows * points_a_cell);
    std::vector<std::vector<double>> cells(static_cast<std::size_t>(rows));
    double sum = 0.0, all = 0.0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            double light = 0.0;
            for (int i = 0; i < points_a_cell * points_a_cell; ++i) {
                const double u = (column * points_a_cell + i % points_a_cell + 0.5) * du;
                const double v = (row * points_a_cell + i / points_a_cell + 0.5) * dv;
                light += light_at(world, tables, record, u, v) * solid_angle(record, u, v, du, dv);
            }
            cells[static_cast<std::size_t>(row)].push_back(light);
            sum += light;
            all += solid_angle(record, (column + 0.5) / columns, (row + 0.5) / rows, 1.0 / columns, 1.0 / rows);
        }
    }
    std::vector<double> lights;
    for (int row = 0; row < rows; ++row) {
        double light = 0.0;
        for (int column = 0; column < columns; ++column) {
            double& cell = cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            cell += unseen_light * sum / all * solid_angle(record, (column + 0.5) / columns, (row + 0.5) / rows, 1.0 / columns, 1.0 / rows);
            light += cell;
        }
        lights.push_back(light);
    }
    record.first_share = static_cast<int>(world.distributions.size());
    record.share_count = rows;
    record.columns = columns;
    put_shares(lights, world.distributions);
    for (const std::vector<double>& row : cells) {
        put_shares(row, world.distributions);
    }
    return sum / opening;
}

// Where the axis points, and the two directions of a picture at right angles to it.
void set_axes(const glm::dvec3& direction, const glm::dvec3& up, kernel::EmitterRecord& record) {
    const glm::dvec3 axis = glm::normalize(direction);
    glm::dvec3 right = glm::cross(axis, up);
    if (!(glm::length(right) > 1e-9 * glm::length(up))) {  // looking along `up`
        right = glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
    }
    right = glm::normalize(right);
    record.direction = kernel::vec3(axis);
    record.across = kernel::vec3(right);
    record.upwards = kernel::vec3(glm::cross(right, axis));
}

// The picture, times the light of `power`.
kernel::ColorRecord picture_light(scene::ImageTexture image, const scene::Color& power, World& world, Textures& textures, Colors& colors) {
    image.filter = scene::Filter::bilinear;
    const bool spectral = power.spectrum && world.spectral;
    if (!spectral) {
        image.tint *= emitted(power);
    }
    kernel::ColorRecord light = colors.light(textures.add(image), 1.0);
    if (spectral) {
        light.illuminant = colors.add_curve(light_curve(*power.spectrum));
    }
    return light;
}

glm::ivec2 size_of(const World& world, const kernel::ColorRecord& light) {
    const kernel::TextureRecord& texture = world.textures[static_cast<std::size_t>(light.texture)];
    if (texture.level_count < 1) {
        return {1, 1};  // could not be read
    }
    const std::size_t level = 3 * static_cast<std::size_t>(texture.first_level);
    return {std::max(world.levels[level + 1], 1), std::max(world.levels[level + 2], 1)};
}

double power_scale(const kernel::ColorRecord& light, const scene::Color& power, bool spectral) {
    return light.texture >= 0 && !(power.spectrum && spectral) ? 1.0 : brightness(kernel::vec3(emitted(power)));
}

// Puts them into the world. `record`: of a lamp that has them.
PhotometricTables photometric_tables(const scene::Photometry& photometry, World& world, kernel::EmitterRecord record) {
    record.profile = static_cast<int>(world.distributions.size());
    const std::size_t rows = photometry.vertical.size(), columns = photometry.horizontal.size();
    std::vector<float>& table = world.distributions;
    const bool even = columns == 1;
    table.push_back(static_cast<float>(rows));
    table.push_back(static_cast<float>(even ? 2 : columns));
    for (const double angle : photometry.vertical) {
        table.push_back(static_cast<float>(angle / 180.0));
    }
    for (const double angle : photometry.horizontal) {
        table.push_back(static_cast<float>(angle / 360.0));
    }
    if (even) {
        table.push_back(1.0f);
    }
    double reach = 0.0;
    for (std::size_t i = 0; i < (even ? 2 : columns); ++i) {
        for (std::size_t j = 0; j < rows; ++j) {
            const double candela = photometry.candela[(even ? 0 : i) * rows + j];
            table.push_back(static_cast<float>(candela));
            if (candela > 0.0) {
                reach = std::max(reach, photometry.vertical[std::min(j + 1, rows - 1)]);
            }
        }
    }
    record.cos_outer = reach < 180.0 ? static_cast<float>(std::cos(glm::radians(reach))) - 1e-4f : -2.0f;
    const double opening = std::max(2.0 * std::numbers::pi * (1.0 - std::cos(glm::radians(reach))), 1e-6);
    const double mean = share_out(world, even ? 1 : 72, 90, opening, record);
    return {record.profile, record.first_share, record.share_count, record.columns, record.cos_outer, mean};
}

}  // namespace

void compile_thrown(const scene::ProjectorLight& light, const scene::Color& power, World& world, Textures& textures, Colors& colors,
                    kernel::EmitterRecord& record) {
    record.kind = kernel::EMITTER_PROJECTOR;
    record.position = kernel::vec3(light.position);
    set_axes(light.direction, light.up, record);
    glm::dvec2 size(1.0);
    if (light.image) {
        record.light = picture_light(*light.image, power, world, textures, colors);
        size = glm::dvec2(size_of(world, record.light));
    } else {
        record.light = colors.light(power);
    }
    const bool by_width =
        light.fov_axis == scene::ProjectorFov::width || (light.fov_axis == scene::ProjectorFov::smaller && size.x <= size.y);
    const double half = std::tan(glm::radians(std::clamp(light.fov, 1e-3, 179.9)) / 2.0);
    const double half_width = by_width ? half : half * size.x / size.y;
    const double half_height = by_width ? half * size.y / size.x : half;
    record.across = kernel::vec3(glm::dvec3(record.across) / half_width);
    record.upwards = kernel::vec3(glm::dvec3(record.upwards) / half_height);
    record.cos_outer = static_cast<float>(1.0 / std::sqrt(1.0 + half_width * half_width + half_height * half_height)) - 1e-4f;
    record.even = light.even ? 1 : 0;
    const double opening =
        4.0 * std::asin(half_width * half_height / std::sqrt((1.0 + half_width * half_width) * (1.0 + half_height * half_height)));
    const double mean = share_out(world, std::clamp(static_cast<int>(size.x), 16, most_cells),
                                  std::clamp(static_cast<int>(size.y), 16, most_cells), opening, record);
    record.strength = static_cast<float>(mean * power_scale(record.light, power, world.spectral));
}

void compile_thrown(const scene::SpotLight& light, const scene::Color& power, World& world, Textures& textures, Colors& colors,
                    kernel::EmitterRecord& record) {
    set_axes(light.direction, light.up, record);
    record.light = picture_light(*light.image, power, world, textures, colors);
    // Of wide spots the picture covers the middle.
    const double half = std::tan(glm::radians(std::min(light.angle, 89.0)));
    record.across = kernel::vec3(glm::dvec3(record.across) / half);
    record.upwards = kernel::vec3(glm::dvec3(record.upwards) / half);
    // The brightest that it may be, so that no light is left out; emission is drawn from the whole cone.
    record.strength = static_cast<float>(brightness(kernel::vec3(emitted(power))));
}

void compile_thrown(const scene::GoniometricLight& light, const scene::Color& power, World& world, Textures& textures, Colors& colors,
                    kernel::EmitterRecord& record) {
    record.kind = kernel::EMITTER_GONIOMETRIC;
    record.position = kernel::vec3(light.position);
    // The picture's axis is `up`; its middle is turned to where `direction` points, as far as it can.
    set_axes(light.direction, light.up, record);
    const glm::dvec3 up = glm::length(light.up) > 0.0 ? glm::normalize(light.up) : glm::dvec3(0.0, 1.0, 0.0);
    if (std::abs(glm::dot(up, glm::dvec3(record.across))) < 1e-6) {
        record.upwards = kernel::vec3(up);
        record.direction = kernel::vec3(glm::cross(up, glm::dvec3(record.across)));
    }
    scene::ImageTexture image = light.image;
    image.wrap = scene::Wrap::repeat;
    image.wrap_v = scene::Wrap::clamp;
    record.light = picture_light(image, power, world, textures, colors);
    record.cos_outer = -2.0f;
    const glm::ivec2 size = size_of(world, record.light);
    const double mean =
        share_out(world, std::clamp(size.x, 8, most_cells), std::clamp(size.y, 4, most_cells / 2), 4.0 * std::numbers::pi, record);
    record.strength = static_cast<float>(mean * power_scale(record.light, power, world.spectral));
}

void compile_thrown(const scene::IesLight& light, const scene::Color& power, World& world, Photometries& known, Colors& colors,
                    kernel::EmitterRecord& record) {
    record.kind = kernel::EMITTER_IES;
    record.position = kernel::vec3(light.position);
    set_axes(light.direction, light.forward, record);
    // set_axes looks along the axis with `forward` up; here that is where the angle starts, and it grows counter-clockwise seen against the axis.
    record.across = record.upwards;
    record.upwards = kernel::vec3(glm::cross(glm::dvec3(record.across), glm::dvec3(record.direction)));
    record.light = colors.light(power);
    if (known.find(light.photometry.get()) == known.end()) {
        known[light.photometry.get()] = photometric_tables(*light.photometry, world, record);
    }
    const PhotometricTables& tables = known[light.photometry.get()];
    record.profile = tables.profile;
    record.first_share = tables.first_share;
    record.share_count = tables.share_count;
    record.columns = tables.columns;
    record.cos_outer = tables.cos_outer;
    record.strength = static_cast<float>(tables.mean * power_scale(record.light, power, world.spectral));
}

}  // namespace lancer
