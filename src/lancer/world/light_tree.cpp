#include "lancer/world/light_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lancer {

namespace {

using std::numbers::pi;

constexpr int most_depth = 30;  // bits of a way
constexpr int buckets = 12;

struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};

    void add(const Bounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    glm::dvec3 size() const { return high - low; }
    double area() const {
        const glm::dvec3 d = size();
        return 2.0 * (d.x * d.y + d.y * d.z + d.z * d.x);
    }
};

// Directions within `spread` of an axis, and what light does beyond: up to `reach` farther. Radians. Twofold: to both sides of the axis.
struct Cone {
    glm::dvec3 axis{0.0, 1.0, 0.0};
    double spread = 0.0;
    double reach = 0.0;
    bool twofold = false;

    // How much there is of it, for the cost of a split [Conty Estevez and Kulla 2018, eq. 2].
    double measure() const {
        const double wide = std::min(spread + reach, pi);
        const double one =
            2.0 * pi * (1.0 - std::cos(spread)) +
            0.5 * pi * (2.0 * wide * std::sin(spread) - std::cos(spread - 2.0 * wide) - 2.0 * spread * std::sin(spread) + std::cos(spread));
        return std::min(twofold ? 2.0 * one : one, 4.0 * pi);
    }
};

Cone everywhere(double reach) { return {{0.0, 1.0, 0.0}, pi, reach, false}; }

// The narrowest cone around two [Conty Estevez and Kulla 2018, algorithm 1].
Cone around(Cone a, Cone b) {
    const double reach = std::max(a.reach, b.reach);
    if (a.twofold != b.twofold || a.spread >= pi || b.spread >= pi) {
        return everywhere(reach);
    }
    if (a.twofold && glm::dot(a.axis, b.axis) < 0.0) {
        b.axis = -b.axis;
    }
    if (b.spread > a.spread) {
        std::swap(a, b);
    }
    const glm::dvec3 across = glm::cross(a.axis, b.axis);
    const double between = std::atan2(glm::length(across), glm::dot(a.axis, b.axis));
    if (std::min(between + b.spread, pi) <= a.spread) {
        return {a.axis, a.spread, reach, a.twofold};
    }
    const double spread = 0.5 * (a.spread + between + b.spread);
    if (spread >= pi || !(glm::length(across) > 1e-12)) {
        return everywhere(reach);
    }
    const double turn = spread - a.spread;
    const glm::dvec3 side = glm::normalize(glm::cross(across, a.axis));
    return {glm::normalize(a.axis * std::cos(turn) + side * std::sin(turn)), spread, reach, a.twofold};
}

struct Leaf {
    int emitter = 0;
    Bounds bounds;
    glm::dvec3 middle{0.0};
    double radius = 0.0;
    Cone cone;
    double power = 0.0;
};

Cone cone_of(const kernel::EmitterRecord& emitter) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(emitter.direction));
    switch (emitter.kind) {
        case kernel::EMITTER_SPOT:
        case kernel::EMITTER_PROJECTOR:
        case kernel::EMITTER_IES:
            return {axis, std::acos(std::clamp(static_cast<double>(emitter.cos_outer), -1.0, 1.0)), 0.0, false};
        default:
            return emitter.planar != 0 ? Cone{axis, 0.0, 0.5 * pi, emitter.two_sided != 0} : everywhere(0.5 * pi);
    }
}

class Builder {
public:
    Builder(World& world, std::vector<Leaf> leaves) : world_(world), leaves_(std::move(leaves)) {}

    void build() {
        world_.light_nodes.assign(static_cast<std::size_t>(kernel::NODE_SIZE), 0.0f);
        add(0, 0, leaves_.size(), 0, 0);
    }

private:
    struct Summary {
        Bounds bounds;
        Cone cone;
        double power = 0.0;
        bool any = false;

        void add(const Bounds& b, const Cone& c, double p) {
            cone = any ? around(cone, c) : c;
            bounds.add(b);
            power += p;
            any = true;
        }
        double cost() const { return any ? power * cone.measure() : 0.0; }
    };

    // The node's numbers, and its subtree below it. `way`: the bits that lead here.
    void add(std::size_t node, std::size_t first, std::size_t end, int depth, unsigned way) {
        Summary all;
        for (std::size_t i = first; i < end; ++i) {
            all.add(leaves_[i].bounds, leaves_[i].cone, leaves_[i].power);
        }
        glm::dvec3 middle = 0.5 * (all.bounds.low + all.bounds.high);
        double radius = 0.0;
        for (std::size_t i = first; i < end; ++i) {
            radius = std::max(radius, glm::length(leaves_[i].middle - middle) + leaves_[i].radius);
        }
        if (end - first == 1) {
            middle = leaves_[first].middle;
            radius = leaves_[first].radius;
            world_.light_ways[static_cast<std::size_t>(leaves_[first].emitter)] = static_cast<int>(way);
            put(node, middle, radius, all, -1 - leaves_[first].emitter);
            return;
        }
        const std::size_t split = divide(all, first, end, depth);
        const std::size_t child = world_.light_nodes.size() / kernel::NODE_SIZE;
        world_.light_nodes.resize(world_.light_nodes.size() + 2 * kernel::NODE_SIZE);
        put(node, middle, radius, all, static_cast<int>(child));
        add(child, first, split, depth + 1, way);
        add(child + 1, split, end, depth + 1, way | 1u << depth);
    }

    void put(std::size_t node, const glm::dvec3& middle, double radius, const Summary& all, int child) {
        float* numbers = &world_.light_nodes[node * kernel::NODE_SIZE];
        for (int i = 0; i < 3; ++i) {
            numbers[kernel::NODE_MIDDLE + i] = static_cast<float>(middle[i]);
            numbers[kernel::NODE_AXIS + i] = static_cast<float>(all.cone.axis[i]);
        }
        const double slack = 1e-6 * std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
        for (int i = 0; i < 3; ++i) {
            const double half = std::max(all.bounds.high[i] - middle[i], middle[i] - all.bounds.low[i]);
            numbers[kernel::NODE_HALF + i] = static_cast<float>(half * (1.0 + 1e-4) + slack);
        }
        // A little wider than it is: what is computed from it is rounded.
        const double size = std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
        numbers[kernel::NODE_RADIUS] = static_cast<float>(radius > 0.0 ? radius * (1.0 + 1e-4) + 1e-6 * size : 0.0);
        numbers[kernel::NODE_SPREAD] = static_cast<float>(all.cone.spread >= pi ? -1.0 : std::cos(all.cone.spread));
        numbers[kernel::NODE_REACH] = static_cast<float>(std::cos(std::min(all.cone.reach, pi)) - 1e-4);
        numbers[kernel::NODE_POWER] = static_cast<float>(all.power);
        numbers[kernel::NODE_CHILD] = static_cast<float>(child);
        numbers[kernel::NODE_TWOFOLD] = all.cone.twofold ? 1.0f : 0.0f;
    }

    // Sorts the leaves so that the two children are [first, result) and [result, end): where their costs together are least.
    std::size_t divide(const Summary& all, std::size_t first, std::size_t end, int depth) {
        const std::size_t count = end - first;
        Bounds middles;
        for (std::size_t i = first; i < end; ++i) {
            middles.add({leaves_[i].middle, leaves_[i].middle});
        }
        const glm::dvec3 room = middles.size();
        double least = std::numeric_limits<double>::infinity();
        int best_axis = -1;
        int best_bucket = 0;
        const bool deep = static_cast<std::size_t>(most_depth - depth) <= std::bit_width(count) + 1u;
        const double longest = std::max({room.x, room.y, room.z});
        for (int axis = 0; axis < 3 && !deep; ++axis) {
            if (!(room[axis] > 0.0)) {
                continue;
            }
            std::array<Summary, buckets> parts;
            for (std::size_t i = first; i < end; ++i) {
                parts[static_cast<std::size_t>(bucket(leaves_[i], middles, axis))].add(leaves_[i].bounds, leaves_[i].cone,
                                                                                       leaves_[i].power);
            }
            for (int cut = 1; cut < buckets; ++cut) {
                Summary left, right;
                for (int i = 0; i < buckets; ++i) {
                    const Summary& part = parts[static_cast<std::size_t>(i)];
                    if (part.any) {
                        (i < cut ? left : right).add(part.bounds, part.cone, part.power);
                    }
                }
                if (!left.any || !right.any) {
                    continue;
                }
                const double area = std::max(all.bounds.area(), 1e-300);
                const double cost =
                    (left.cost() * std::max(left.bounds.area() / area, 1e-6) + right.cost() * std::max(right.bounds.area() / area, 1e-6)) *
                    longest / room[axis];
                if (cost < least) {
                    least = cost;
                    best_axis = axis;
                    best_bucket = cut;
                }
            }
        }
        const auto begin = leaves_.begin() + static_cast<std::ptrdiff_t>(first);
        const auto stop = leaves_.begin() + static_cast<std::ptrdiff_t>(end);
        if (best_axis >= 0) {
            const auto split =
                std::stable_partition(begin, stop, [&](const Leaf& leaf) { return bucket(leaf, middles, best_axis) < best_bucket; });
            return static_cast<std::size_t>(split - leaves_.begin());
        }
        // In the middle of their order along the longest side; or as they stand.
        const int axis = room.x >= room.y && room.x >= room.z ? 0 : room.y >= room.z ? 1 : 2;
        std::stable_sort(begin, stop, [&](const Leaf& a, const Leaf& b) { return a.middle[axis] < b.middle[axis]; });
        return first + count / 2;
    }

    static int bucket(const Leaf& leaf, const Bounds& middles, int axis) {
        const double place = (leaf.middle[axis] - middles.low[axis]) / (middles.high[axis] - middles.low[axis]);
        return std::clamp(static_cast<int>(place * buckets), 0, buckets - 1);
    }

    World& world_;
    std::vector<Leaf> leaves_;
};

}  // namespace

void compile_light_tree(World& world) {
    world.light_nodes.clear();
    world.light_ways.assign(world.emitters.size(), -1);
    std::vector<Leaf> leaves;
    for (std::size_t i = static_cast<std::size_t>(world.far_count); i < world.emitters.size(); ++i) {
        const kernel::EmitterRecord& emitter = world.emitters[i];
        if (!(emitter.strength > 0.0f)) {
            continue;
        }
        Leaf leaf;
        leaf.emitter = static_cast<int>(i);
        leaf.middle = glm::dvec3(emitter.middle);
        leaf.radius = static_cast<double>(emitter.radius);
        leaf.bounds = {leaf.middle - leaf.radius, leaf.middle + leaf.radius};
        leaf.cone = cone_of(emitter);
        leaf.power = static_cast<double>(emitter.strength);
        leaves.push_back(leaf);
    }
    if (!leaves.empty()) {
        Builder(world, std::move(leaves)).build();
    }
}

}  // namespace lancer
