#include "statistics/bsdf_cases.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "lancer/world/albedo_table.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

Closure closure_of(int kind, const Spectrum& color) {
    Closure c = no_closure();
    c.kind = kind;
    c.color = color;
    return c;
}

const Spectrum tinted = vec4_of(0.8f, 0.4f, 0.2f, 0.6f);
const Spectrum white = vec4_all(1.0f);

Closure rough(Closure c, float x, float y) {
    c.roughness_x = x;
    c.roughness_y = y;
    return c;
}

Closure conductor(const Spectrum& color, float x, float y, bool perfect) {
    Closure c = rough(closure_of(BSDF_CONDUCTOR, color), x, y);
    // Gold from 480 to 700 nm, about; or a mirror without loss.
    c.index = perfect ? vec4_all(0.0f) : vec4_of(0.13f, 0.35f, 0.85f, 1.3f);
    c.extinction = perfect ? vec4_all(1.0f) : vec4_of(3.8f, 2.6f, 1.9f, 1.8f);
    return c;
}

Closure beckmann(Closure c) {
    c.beckmann = true;
    return c;
}

BsdfCase beckmann(BsdfCase c) {
    c.name += ", Beckmann's";
    c.closure.beckmann = true;
    c.other_side.beckmann = true;
    return c;
}

BsdfCase dielectric(const std::string& name, const Spectrum& color, float eta, float x, float y) {
    BsdfCase d;
    d.name = fmt::format("{} index {} roughness {} {}", name, eta, x, y);
    d.closure = rough(closure_of(BSDF_DIELECTRIC, color), x, y);
    d.closure.index = vec4_all(eta);
    d.other_side = d.closure;
    d.other_side.index = vec4_all(1.0f / eta);
    d.transmits = true;
    return d;
}

Closure plastic(const Spectrum& color, float alpha, float eta) {
    Closure c = rough(closure_of(BSDF_PLASTIC, color), alpha, alpha);
    c.index = vec4_all(eta);
    c.extinction = white;
    return c;
}

struct Layers {
    float metalness = 0.0f;
    float transmission = 0.0f;
    bool thin = false;
    float coat = 0.0f;
    float coat_roughness = 0.0f;
    float sheen = 0.0f;
    float sheen_roughness = 0.0f;
    float film = 0.0f;
};

std::vector<Layers> layers_to_try() {
    return {{},
            {.metalness = 1.0f},
            {.metalness = 1.0f, .film = 0.7f},
            {.film = 0.35f},
            {.transmission = 1.0f, .film = 0.35f},
            {.transmission = 0.6f, .thin = true, .film = 0.6f},
            {.transmission = 1.0f},
            {.transmission = 1.0f, .thin = true},
            {.metalness = 0.3f, .transmission = 0.4f},
            {.coat = 1.0f, .coat_roughness = 0.0f},
            {.metalness = 0.5f, .coat = 0.7f, .coat_roughness = 0.3f},
            {.sheen = 0.8f, .sheen_roughness = 0.1f},
            {.sheen = 1.0f, .sheen_roughness = 0.6f},
            {.metalness = 0.2f, .transmission = 0.5f, .coat = 0.5f, .coat_roughness = 0.1f, .sheen = 0.5f, .sheen_roughness = 0.3f},
            {.metalness = 0.2f, .transmission = 0.5f, .thin = true, .coat = 0.5f, .coat_roughness = 0.1f}};
}

BsdfCase principled(const Spectrum& color, float alpha, const Layers& layers) {
    BsdfCase p;
    p.name =
        fmt::format("principled {}: metal {}, clear {}{}, coat {} {}, sheen {} {}, film {}", alpha, layers.metalness, layers.transmission,
                    layers.thin ? " sheet" : "", layers.coat, layers.coat_roughness, layers.sheen, layers.sheen_roughness, layers.film);
    Closure c = rough(closure_of(BSDF_PRINCIPLED, color), alpha, alpha);
    c.index = vec4_all(1.5f);
    c.extinction = white;
    c.metalness = layers.metalness;
    c.transmission = layers.transmission;
    c.thin = layers.thin;
    c.coat = layers.coat;
    c.coat_roughness = layers.coat_roughness;
    c.sheen = vec4_of(layers.sheen, 0.5f * layers.sheen, 0.2f * layers.sheen, layers.sheen);
    c.sheen_roughness = layers.sheen_roughness;
    c.film = vec4_all(layers.film);
    c.film_index = 1.4f;
    p.closure = c;
    p.other_side = c;
    p.transmits = layers.transmission > 0.0f;
    if (p.transmits && !layers.thin) {
        p.other_side.index = vec4_all(1.0f / 1.5f);
    }
    return p;
}

// As other programs have their facets: each direction by itself, and what meets several of them is lost.
BsdfCase lossy(BsdfCase c) {
    c.name += ", lossy";
    for (Closure* side : {&c.closure, &c.other_side}) {
        side->separate = true;
        side->once = true;
    }
    return c;
}

struct BurleyLayers {
    float metalness = 0.0f;
    float transmission = 0.0f;
    bool thin = false;
    float passes = 0.0f;  // of a sheet
    float coat = 0.0f;
    float sheen = 0.0f;
    float tint = 0.0f;
    float flatness = 0.0f;
};

BsdfCase burley(float x, float y, const BurleyLayers& layers) {
    BsdfCase b;
    b.name = fmt::format("Burley's {} {}: metal {}, clear {}{} {}, coat {}, sheen {}, tint {}, flat {}", x, y, layers.metalness,
                         layers.transmission, layers.thin ? " sheet" : "", layers.passes, layers.coat, layers.sheen, layers.tint,
                         layers.flatness);
    Closure c = rough(closure_of(BSDF_BURLEY, tinted), x, y);
    c.index = vec4_all(1.5f);
    c.metalness = layers.metalness;
    c.transmission = layers.transmission;
    c.thin = layers.thin;
    c.film_index = layers.passes;
    c.coat = layers.coat;
    c.coat_roughness = 0.05f;
    c.sheen_roughness = layers.sheen;
    c.sheen = vec4_of(layers.tint, layers.tint, layers.flatness, 0.5f);
    b.closure = c;
    b.other_side = c;
    b.transmits = layers.transmission > 0.0f || (layers.thin && layers.passes > 0.0f);
    if (layers.transmission > 0.0f && !layers.thin) {
        b.other_side.index = vec4_all(1.0f / 1.5f);
    }
    b.furnace = 0.5;  // its layers do not share the light out
    return b;
}

BsdfCase opaque(const std::string& name, const Closure& closure) {
    BsdfCase c;
    c.name = name;
    c.closure = closure;
    c.other_side = closure;
    return c;
}

}  // namespace

std::vector<BsdfCase> bsdf_cases() {
    std::vector<BsdfCase> cases;
    cases.push_back(opaque("none", closure_of(BSDF_NONE, white)));
    cases.push_back(opaque("diffuse", closure_of(BSDF_DIFFUSE, tinted)));
    for (const float r : {0.0f, 0.3f, 1.0f}) {
        cases.push_back(opaque(fmt::format("rough diffuse {}", r), rough(closure_of(BSDF_ROUGH_DIFFUSE, tinted), r, r)));
    }
    for (const auto& [x, y] :
         {std::pair{0.0f, 0.0f}, {0.05f, 0.05f}, {0.2f, 0.2f}, {0.1f, 0.4f}, {0.6f, 0.6f}, {1.0f, 1.0f}, {1.0f, 0.2f}}) {
        cases.push_back(opaque(fmt::format("conductor {} {}", x, y), conductor(tinted, x, y, false)));
    }
    for (const auto& [x, y] : {std::pair{0.1f, 0.1f}, {0.5f, 0.5f}, {0.1f, 0.6f}, {1.0f, 1.0f}}) {
        cases.push_back(opaque(fmt::format("conductor of Beckmann's {} {}", x, y), beckmann(conductor(tinted, x, y, false))));
    }
    for (const float eta : {1.5f, 1.0f / 1.5f, 1.1f, 2.4f}) {
        for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {0.1f, 0.1f}, {0.5f, 0.5f}, {0.2f, 0.6f}, {1.0f, 1.0f}}) {
            cases.push_back(dielectric("dielectric", tinted, eta, x, y));
            if (x > 0.1f) {
                cases.push_back(beckmann(cases.back()));
            }
        }
    }
    BsdfCase thin = opaque("thin dielectric", closure_of(BSDF_THIN_DIELECTRIC, tinted));
    thin.closure.index = vec4_all(1.5f);
    thin.other_side = thin.closure;
    thin.transmits = true;
    cases.push_back(thin);
    for (const float alpha : {0.0f, 0.1f, 0.5f}) {
        cases.push_back(opaque(fmt::format("plastic {}", alpha), plastic(tinted, alpha, 1.5f)));
        cases.push_back(opaque(fmt::format("plastic of Beckmann's {}, saturated", alpha), beckmann(plastic(tinted, alpha, 1.3f))));
        cases.back().closure.saturates = true;
    }
    for (const float alpha : {0.1f, 0.5f}) {
        cases.push_back(lossy(opaque(fmt::format("conductor {}", alpha), conductor(tinted, alpha, alpha, false))));
        cases.push_back(lossy(dielectric("dielectric", tinted, 1.5f, alpha, alpha)));
        cases.push_back(lossy(beckmann(dielectric("dielectric", tinted, 1.0f / 1.5f, alpha, alpha))));
        cases.push_back(lossy(opaque(fmt::format("plastic {}", alpha), plastic(tinted, alpha, 1.5f))));
        cases.push_back(lossy(beckmann(opaque(fmt::format("plastic {}, saturated", alpha), plastic(tinted, alpha, 1.5f)))));
        cases.back().closure.saturates = true;
    }
    for (const BurleyLayers& layers : {BurleyLayers{},
                                       {.metalness = 0.6f, .coat = 0.8f, .sheen = 0.5f, .tint = 0.5f},
                                       {.metalness = 0.1f, .transmission = 0.7f, .coat = 0.5f},
                                       {.sheen = 0.8f, .flatness = 1.0f},
                                       {.thin = true, .passes = 0.4f, .sheen = 0.5f},
                                       {.transmission = 0.6f, .thin = true, .passes = 0.7f, .tint = 0.6f}}) {
        cases.push_back(burley(0.2f, 0.2f, layers));
        cases.push_back(burley(0.1f, 0.4f, layers));
        if (layers.transmission > 0.0f && !layers.thin) {
            std::swap(cases.back().closure, cases.back().other_side);
            cases.back().name += ", from within";
        }
    }
    for (const float alpha : {0.0f, 0.3f}) {
        for (const Layers& layers : layers_to_try()) {
            const Spectrum color = vec4_of(0.8f, 0.4f, 0.2f, 0.6f);
            cases.push_back(principled(color, alpha, layers));
            if (layers.transmission > 0.0f && !layers.thin) {
                BsdfCase within = cases.back();
                within.name += ", from within";
                std::swap(within.closure, within.other_side);
                cases.push_back(within);
            }
        }
    }
    return cases;
}

std::vector<BsdfCase> white_cases() {
    std::vector<BsdfCase> cases;
    cases.push_back(opaque("diffuse", closure_of(BSDF_DIFFUSE, white)));
    for (const float r : {0.0f, 0.2f, 0.5f, 1.0f}) {
        cases.push_back(opaque(fmt::format("rough diffuse {}", r), rough(closure_of(BSDF_ROUGH_DIFFUSE, white), r, r)));
    }
    for (const float alpha : {0.0f, 0.0025f, 0.01f, 0.04f, 0.1f, 0.2f, 0.35f, 0.5f, 0.65f, 0.8f, 1.0f}) {
        cases.push_back(opaque(fmt::format("conductor {}", alpha), conductor(white, alpha, alpha, true)));
        cases.push_back(opaque(fmt::format("conductor of Beckmann's {}", alpha), beckmann(conductor(white, alpha, alpha, true))));
        for (const float eta : {1.1f, 1.5f, 2.4f, 1.0f / 1.1f, 1.0f / 1.5f, 1.0f / 2.4f}) {
            cases.push_back(dielectric("dielectric", white, eta, alpha, alpha));
            cases.push_back(beckmann(cases.back()));
        }
    }
    for (const auto& [x, y] : {std::pair{0.1f, 0.2f}, {0.6f, 0.3f}, {0.1f, 0.8f}, {1.0f, 0.12f}}) {
        cases.push_back(opaque(fmt::format("conductor {} {}", x, y), conductor(white, x, y, true)));
        cases.push_back(beckmann(cases.back()));
        cases.back().furnace = 0.0065;  // between the nodes of the table
        for (const float eta : {1.5f, 1.0f / 1.5f}) {
            cases.push_back(dielectric("dielectric", white, eta, x, y));
            cases.back().furnace = eta > 1.0f ? 0.005 : 0.0075;  // the table of stretched borders is coarse
        }
    }
    BsdfCase thin = opaque("thin dielectric", closure_of(BSDF_THIN_DIELECTRIC, white));
    thin.closure.index = vec4_all(1.5f);
    thin.transmits = true;
    cases.push_back(thin);
    for (const float alpha : {0.0f, 0.04f, 0.2f, 0.5f, 1.0f}) {
        for (const float eta : {1.3f, 1.5f, 2.0f}) {
            cases.push_back(opaque(fmt::format("plastic {} index {}", alpha, eta), plastic(white, alpha, eta)));
            cases.push_back(
                opaque(fmt::format("plastic of Beckmann's {} index {}, saturated", alpha, eta), beckmann(plastic(white, alpha, eta))));
            cases.back().closure.saturates = true;
        }
        for (const Layers& layers : layers_to_try()) {
            if (layers.coat == 0.0f && layers.sheen == 0.0f && layers.film == 0.0f) {
                cases.push_back(principled(white, alpha, layers));
            }
        }
    }
    for (BsdfCase& c : cases) {
        c.white = true;
    }
    return cases;
}

Vec3 direction_of(double cosine, double angle) {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return vec3_of(static_cast<float>(sine * std::cos(angle)), static_cast<float>(sine * std::sin(angle)), static_cast<float>(cosine));
}

namespace {

WorldRecord world_of_tables() {
    WorldRecord world{};
    world.albedo = microfacet_albedo_table().data();
    return world;
}

const WorldRecord world = world_of_tables();

}  // namespace

BsdfValue value_of(const Closure& closure, const Vec3& wo, const Vec3& wi) { return bsdf_value(world, closure, wo, wi, true); }

BsdfSample sample_of(const Closure& closure, const Vec3& wo, double choice, double u, double v) {
    return bsdf_sample(world, closure, wo, static_cast<float>(choice), vec2_of(static_cast<float>(u), static_cast<float>(v)), true);
}

}  // namespace lancer::statistics
