#include "lancer/import/gltf/animation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace lancer::gltf {

namespace {

using Values = std::vector<double>;

// Keys over time, each of `width` numbers; with cubic splines each is a tangent towards it, a value and a tangent from it.
struct Keys {
    std::vector<float> times;
    std::vector<float> values;
    std::size_t width = 0;
    bool is_step = false;
    bool is_cubic = false;

    double at(std::size_t key, std::size_t part, std::size_t i) const {
        const std::size_t index = is_cubic ? (3 * key + part) * width + i : key * width + i;
        return static_cast<double>(values[index]);
    }
    Values value(std::size_t key) const {
        Values result(width);
        for (std::size_t i = 0; i < width; ++i) {
            result[i] = at(key, 1, i);
        }
        return result;
    }
};

glm::dquat to_quaternion(const Values& v) {
    const glm::dquat q(v[3], v[0], v[1], v[2]);
    const double length = glm::length(q);
    return length > 0.0 ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

// [Khronos 2021, appendix C]
Values evaluate(const Keys& keys, double seconds, bool is_rotation) {
    const auto after =
        std::upper_bound(keys.times.begin(), keys.times.end(), seconds, [](double a, float b) { return a < static_cast<double>(b); });
    if (after == keys.times.begin()) {
        return keys.value(0);
    }
    const auto key = static_cast<std::size_t>(after - keys.times.begin()) - 1;
    if (after == keys.times.end() || keys.is_step) {
        return keys.value(key);
    }
    const double begin = static_cast<double>(keys.times[key]);
    const double span = static_cast<double>(keys.times[key + 1]) - begin;
    const double t = (seconds - begin) / span;
    Values result(keys.width);
    if (keys.is_cubic) {
        const double t2 = t * t, t3 = t2 * t;
        for (std::size_t i = 0; i < keys.width; ++i) {
            result[i] = (2.0 * t3 - 3.0 * t2 + 1.0) * keys.at(key, 1, i) + span * (t3 - 2.0 * t2 + t) * keys.at(key, 2, i) +
                        (-2.0 * t3 + 3.0 * t2) * keys.at(key + 1, 1, i) + span * (t3 - t2) * keys.at(key + 1, 0, i);
        }
    } else if (is_rotation) {
        const glm::dquat q = glm::slerp(to_quaternion(keys.value(key)), to_quaternion(keys.value(key + 1)), t);
        result = {q.x, q.y, q.z, q.w};
    } else {
        for (std::size_t i = 0; i < keys.width; ++i) {
            result[i] = (1.0 - t) * keys.at(key, 1, i) + t * keys.at(key + 1, 1, i);
        }
    }
    return result;
}

class Animator {
public:
    Animator(Document& document, Accessors& accessors, Nodes& nodes, double seconds)
        : document_(document), accessors_(accessors), nodes_(nodes), seconds_(seconds) {}

    void run(Json animation) {
        std::vector<Json> samplers;
        for (const Json sampler : animation["samplers"]) {
            samplers.push_back(sampler);
        }
        for (const Json channel : animation["channels"]) {
            const std::size_t number = channel.natural("sampler").value_or(samplers.size());
            if (number >= samplers.size()) {
                document_.error(channel["sampler"], fmt::format("the animation has {} samplers", samplers.size()));
                return;
            }
            const Json target = channel["target"];
            const auto node = target.natural("node");
            const std::string path(target.text("path"));
            if (!node || *node >= nodes_.list().size()) {
                continue;  // an extension's
            }
            if (!moved_.insert({*node, path}).second) {
                document_.warning(channel, fmt::format("the {} of node {} is moved twice; the first counts", path, *node));
                continue;
            }
            move(nodes_.list()[*node], path, samplers[number], channel);
        }
    }

private:
    void move(Node& node, const std::string& path, Json sampler, Json channel) {
        const bool is_rotation = path == "rotation";
        std::size_t width = path == "translation" || path == "scale" ? 3 : is_rotation ? 4 : 0;
        if (path == "weights") {
            width = document_.item("meshes", node.json, "mesh")["primitives"].size() > 0 ? targets_of(node) : 0;
            if (width == 0) {
                document_.error(channel, "the node's mesh has no morph targets to weigh");
                return;
            }
        } else if (width == 0) {
            return;
        }
        if (node.matrix && path != "weights") {
            document_.warning(channel, "a node with a matrix can't be animated");
            return;
        }
        Keys keys;
        keys.width = width;
        if (!read_keys(sampler, path == "weights", keys)) {
            return;
        }
        const Values value = evaluate(keys, seconds_, is_rotation);
        if (path == "translation") {
            node.translation = {value[0], value[1], value[2]};
        } else if (path == "scale") {
            node.scale = {value[0], value[1], value[2]};
        } else if (is_rotation) {
            node.rotation = to_quaternion(value);
        } else {
            node.weights.assign(value.begin(), value.end());
        }
        document_.honoured(fmt::format("animation of {}, {}", path, sampler.text("interpolation", "LINEAR")), channel);
    }

    std::size_t targets_of(const Node& node) const {
        for (const Json primitive : document_.item("meshes", node.json, "mesh")["primitives"]) {
            return primitive["targets"].size();
        }
        return 0;
    }

    bool read_keys(Json sampler, bool scalar, Keys& keys) {
        const auto input = accessors_.open(document_.item("accessors", sampler, "input"));
        const auto output = accessors_.open(document_.item("accessors", sampler, "output"));
        if (!input || !output) {
            return false;
        }
        const std::string_view interpolation = sampler.text("interpolation", "LINEAR");
        keys.is_step = interpolation == "STEP";
        keys.is_cubic = interpolation == "CUBICSPLINE";
        const std::size_t expected = input->count * (keys.is_cubic ? 3 : 1) * (scalar ? keys.width : 1);
        if (input->components != 1 || input->component != Component::f32) {
            document_.error(sampler["input"], fmt::format("{}: expected times as SCALAR of floats", Accessors::kind(*input)));
            return false;
        }
        if (output->components != (scalar ? 1 : keys.width)) {
            document_.error(sampler["output"],
                            fmt::format("{}: expected {} numbers an element", Accessors::kind(*output), scalar ? 1 : keys.width));
            return false;
        }
        if (output->count != expected) {
            document_.error(sampler["output"], fmt::format("{} values for {} times: expected {}", output->count, input->count, expected));
            return false;
        }
        auto times = accessors_.floats(*input);
        auto values = accessors_.floats(*output);
        if (!times || !values) {
            return false;
        }
        bool has_twins = false;
        for (std::size_t i = 0; i < times->size(); ++i) {
            if (!std::isfinite((*times)[i]) || (i > 0 && (*times)[i] < (*times)[i - 1])) {
                document_.error(sampler["input"], fmt::format("time {} is {}: expected growing ones", i, (*times)[i]));
                return false;
            }
            has_twins = has_twins || (i > 0 && (*times)[i] == (*times)[i - 1]);
        }
        if (has_twins) {
            document_.warning(sampler["input"], "some times are the same; the last of them counts");
        }
        if (std::any_of(values->begin(), values->end(), [](float v) { return !std::isfinite(v); })) {
            document_.error(sampler["output"], "a value is not finite");
            return false;
        }
        keys.times = std::move(*times);
        keys.values = std::move(*values);
        return true;
    }

    Document& document_;
    Accessors& accessors_;
    Nodes& nodes_;
    double seconds_;
    std::set<std::pair<std::size_t, std::string>> moved_;
};

}  // namespace

void animate(Document& document, Accessors& accessors, Nodes& nodes, double seconds) {
    Animator animator(document, accessors, nodes, seconds);
    for (const Json animation : document.items("animations")) {
        AnimationFacts facts{std::string(animation.text("name")), 0.0, animation["channels"].size()};
        for (const Json sampler : animation["samplers"]) {
            const std::vector<double> last = document.item("accessors", sampler, "input").numbers("max");
            facts.seconds = std::max(facts.seconds, last.empty() ? 0.0 : last.front());
        }
        document.animation(std::move(facts));
        animator.run(animation);
    }
}

std::vector<glm::mat4> joints_of(Document& document, Accessors& accessors, const Nodes& nodes, Json skin) {
    std::vector<glm::dmat4> placed;
    for (const Json joint : skin["joints"]) {
        placed.push_back(nodes.list()[static_cast<std::size_t>(joint.value().number)].to_world);
    }
    std::vector<glm::mat4> joints(placed.begin(), placed.end());
    if (!skin["inverseBindMatrices"]) {
        return joints;
    }
    const auto accessor = accessors.open(document.item("accessors", skin, "inverseBindMatrices"));
    if (!accessor) {
        return {};
    }
    if (accessor->rows != 4 || accessor->components != 16 || accessor->count < joints.size()) {
        document.error(skin["inverseBindMatrices"],
                       fmt::format("{} elements, {}: expected {} of MAT4", accessor->count, Accessors::kind(*accessor), joints.size()));
        return {};
    }
    const auto values = accessors.floats(*accessor);
    if (!values) {
        return {};
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
        glm::dmat4 inverse(1.0);
        for (int i = 0; i < 16; ++i) {
            inverse[i / 4][i % 4] = static_cast<double>((*values)[16 * j + static_cast<std::size_t>(i)]);
        }
        joints[j] = glm::mat4(placed[j] * inverse);
    }
    return joints;
}

}  // namespace lancer::gltf
