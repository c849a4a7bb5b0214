#include "lancer/import/mitsuba/ply_attribute.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "lancer/import/ply/ply_header.h"

namespace lancer::mitsuba {

namespace {

// Numbers one after the other, in either order of bytes.
class Bytes {
public:
    Bytes(std::string_view bytes, bool swapped) : bytes_(bytes), swapped_(swapped) {}

    bool read(ply::Type type, double& value) {
        const std::size_t size = ply::size_of(type);
        if (bytes_.size() < size) {
            return false;
        }
        value = decode(type, bytes_.data());
        bytes_.remove_prefix(size);
        return true;
    }
    bool skip(double count, std::size_t size) {
        if (!(count >= 0.0) || count > static_cast<double>(bytes_.size() / size)) {
            return false;
        }
        bytes_.remove_prefix(static_cast<std::size_t>(count) * size);
        return true;
    }
    std::size_t left() const { return bytes_.size(); }

private:
    template <class T>
    double as(const char* from) const {
        char raw[sizeof(T)];
        std::memcpy(raw, from, sizeof(T));
        if (swapped_) {
            std::reverse(raw, raw + sizeof(T));
        }
        T value;
        std::memcpy(&value, raw, sizeof(T));
        return static_cast<double>(value);
    }
    double decode(ply::Type type, const char* raw) const {
        switch (type) {
            case ply::Type::int8:
                return as<std::int8_t>(raw);
            case ply::Type::uint8:
                return as<std::uint8_t>(raw);
            case ply::Type::int16:
                return as<std::int16_t>(raw);
            case ply::Type::uint16:
                return as<std::uint16_t>(raw);
            case ply::Type::int32:
                return as<std::int32_t>(raw);
            case ply::Type::uint32:
                return as<std::uint32_t>(raw);
            case ply::Type::float32:
                return as<float>(raw);
            case ply::Type::float64:
                return as<double>(raw);
        }
        return 0.0;
    }

    std::string_view bytes_;
    bool swapped_;
};

// The numbers of the properties; -1 for what is not there.
std::array<int, 3> columns_of(const ply::Element& element, const std::string& name) {
    const auto find = [&](const std::string& property) { return element.find(property); };
    if (find(name + "_0") >= 0) {
        return {find(name + "_0"), find(name + "_1"), find(name + "_2")};
    }
    if (find(name + "_r") >= 0) {
        return {find(name + "_r"), find(name + "_g"), find(name + "_b")};
    }
    if (name == "color" && find("red") >= 0) {
        return {find("red"), find("green"), find("blue")};
    }
    return {find(name), -1, -1};
}

bool read_entry(Bytes& bytes, const ply::Element& element, const std::array<int, 3>& columns, glm::vec4& entry) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const ply::Property& property = element.properties[p];
        double value = 0.0;
        if (property.is_list) {
            if (!bytes.read(property.count_type, value) || !bytes.skip(value, ply::size_of(property.type))) {
                return false;
            }
            continue;
        }
        if (!bytes.read(property.type, value)) {
            return false;
        }
        for (int k = 0; k < 3; ++k) {
            if (columns[static_cast<std::size_t>(k)] == static_cast<int>(p)) {
                entry[k] = static_cast<float>(ply::is_whole(property.type) ? value / 255.0 : value);
            }
        }
    }
    if (columns[1] < 0 || columns[2] < 0) {
        entry.y = entry.z = entry.x;
    }
    return true;
}

}  // namespace

std::vector<glm::vec4> read_ply_attribute(std::string_view bytes, const std::string& attribute) {
    Diagnostics unheard;
    MeshMessages messages({}, unheard);
    const auto header = ply::read_header(bytes, messages);
    const std::size_t line = attribute.find('_');
    if (!header || header->format == ply::Format::ascii || line == std::string::npos) {
        return {};
    }
    Bytes body(bytes.substr(header->size), header->format == ply::Format::big_endian);
    for (const ply::Element& element : header->elements) {
        const bool wanted = element.name == attribute.substr(0, line);
        const auto columns = wanted ? columns_of(element, attribute.substr(line + 1)) : std::array<int, 3>{-1, -1, -1};
        if ((wanted && columns[0] < 0) || element.properties.empty()) {
            return {};
        }
        std::vector<glm::vec4> entries;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            glm::vec4 entry(0.0f, 0.0f, 0.0f, 1.0f);
            if (!read_entry(body, element, columns, entry)) {
                return {};
            }
            if (wanted) {
                entries.push_back(entry);
            }
        }
        if (wanted) {
            return entries;
        }
    }
    return {};
}

}  // namespace lancer::mitsuba
