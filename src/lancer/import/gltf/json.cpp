#include "lancer/import/gltf/json.h"

#include <cmath>

#include <fmt/format.h>

namespace lancer::gltf {

const JsonValue& Json::value() const { return tree_->values()[index_]; }

Json::Iterator& Json::Iterator::operator++() {
    index_ = tree_->values()[index_].after;
    return *this;
}

Json::Iterator Json::begin() const { return {tree_, index_ + 1}; }

Json::Iterator Json::end() const {
    const bool holds = is(JsonKind::array) || is(JsonKind::object);
    return {tree_, holds ? value().after : index_ + 1};
}

Json Json::operator[](std::string_view key) const {
    if (is(JsonKind::object)) {
        for (const Json member : *this) {
            if (member.value().key == key) {
                return member;
            }
        }
    }
    return {};
}

double Json::number(std::string_view key, double otherwise) const {
    const Json member = (*this)[key];
    return member.is(JsonKind::number) ? member.value().number : otherwise;
}

std::string_view Json::text(std::string_view key, std::string_view otherwise) const {
    const Json member = (*this)[key];
    return member.is(JsonKind::string) ? member.value().text : otherwise;
}

bool Json::truth(std::string_view key, bool otherwise) const {
    const Json member = (*this)[key];
    return member.is(JsonKind::boolean) ? member.value().number != 0.0 : otherwise;
}

std::optional<std::size_t> Json::natural(std::string_view key) const {
    constexpr double most = 9007199254740992.0;  // beyond it, doubles are no longer every whole number
    const double number = this->number(key, -1.0);
    if (!(number >= 0.0 && number < most) || number != std::floor(number)) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(number);
}

std::vector<double> Json::numbers(std::string_view key) const {
    std::vector<double> numbers;
    if (const Json list = (*this)[key]; list.is(JsonKind::array)) {
        numbers.reserve(list.size());
        for (const Json item : list) {
            numbers.push_back(item.is(JsonKind::number) ? item.value().number : 0.0);
        }
    }
    return numbers;
}

std::string JsonTree::pointer_to(Json json) const {
    std::string pointer;
    if (!json) {
        return pointer;
    }
    Json around = root();
    while (around.index() != json.index()) {
        std::size_t place = 0;
        for (const Json child : around) {
            if (json.index() < child.value().after) {
                if (around.is(JsonKind::array)) {
                    pointer += fmt::format("/{}", place);
                } else {
                    pointer.append("/").append(child.value().key.substr(0, 80));
                }
                around = child;
                break;
            }
            ++place;
        }
    }
    return pointer;
}

}  // namespace lancer::gltf
