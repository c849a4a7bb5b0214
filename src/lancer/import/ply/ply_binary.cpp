#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "lancer/import/ply/ply_data.h"

static_assert(std::endian::native == std::endian::little, "values are swapped for big-endian files only");

namespace lancer::ply {

namespace {

template <class T>
T load(const char* from, bool swapped) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, from, sizeof(T));
    if (swapped) {
        std::reverse(bytes, bytes + sizeof(T));
    }
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

// Calls `use` with a value of the type's C++ type.
template <class Use>
void with_type(Type type, const Use& use) {
    switch (type) {
        case Type::int8:
            return use(std::int8_t{});
        case Type::uint8:
            return use(std::uint8_t{});
        case Type::int16:
            return use(std::int16_t{});
        case Type::uint16:
            return use(std::uint16_t{});
        case Type::int32:
            return use(std::int32_t{});
        case Type::uint32:
            return use(std::uint32_t{});
        case Type::float32:
            return use(float{});
        case Type::float64:
            return use(double{});
    }
}

// Negative numbers become huge ones, which no vertex has.
std::uint32_t load_corner(const char* from, Type type, bool swapped) {
    std::uint32_t corner = 0;
    with_type(type,
              [&](auto kind) { corner = static_cast<std::uint32_t>(static_cast<std::int64_t>(load<decltype(kind)>(from, swapped))); });
    return corner;
}

std::int64_t load_count(const char* from, Type type, bool swapped) {
    std::int64_t count = 0;
    with_type(type, [&](auto kind) { count = static_cast<std::int64_t>(load<decltype(kind)>(from, swapped)); });
    return count;
}

class BinaryReader {
public:
    BinaryReader(std::string_view body, const Header& header, Data& data, MeshMessages& messages)
        : at_(body.data()), end_(at_ + body.size()), swapped_(header.format == Format::big_endian), header_(header), data_(data),
          messages_(messages) {}

    void run() {
        for (const Element& element : header_.elements) {
            const std::size_t smallest = element.smallest_size();
            if (smallest == 0) {
                continue;
            }
            if (element.count > left() / smallest) {
                messages_.error(element.line, 1,
                                fmt::format("{} {} elements need at least {} bytes each, but only {} bytes are left", element.count,
                                            quoted(element.name), smallest, left()));
                return;
            }
            if (!(element.has_lists() ? read_with_lists(element) : read_fixed(element, smallest))) {
                return;
            }
        }
    }

private:
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

    // All elements have the same size.
    bool read_fixed(const Element& element, std::size_t stride) {
        const std::size_t count = static_cast<std::size_t>(element.count);
        if (count > 0 && meaning_of(element) == Meaning::vertices) {
            read_columns(element, count, stride);
        }
        at_ += count * stride;
        return true;
    }

    void read_columns(const Element& element, std::size_t count, std::size_t stride) {
        const Columns columns = vertex_columns(element);
        const auto to = make_room(data_.mesh, count, columns);
        const auto is_float = [&](int property) { return element.properties[static_cast<std::size_t>(property)].type == Type::float32; };
        if (!swapped_ && stride == sizeof(glm::vec3) && columns[x] == 0 && columns[y] == 1 && columns[z] == 2 && is_float(0) &&
            is_float(1)) {
            std::memcpy(to[x].first, at_, count * stride);
            return;
        }
        std::vector<std::size_t> offsets;
        std::size_t offset = 0;
        for (const Property& property : element.properties) {
            offsets.push_back(offset);
            offset += size_of(property.type);
        }
        constexpr std::size_t block = 1024;  // vertices whose bytes stay in the nearest cache while all columns are read
        for (std::size_t begin = 0; begin < count; begin += block) {
            const std::size_t end = std::min(begin + block, count);
            for (std::size_t role = 0; role < role_count; ++role) {
                if (columns[role] < 0) {
                    continue;
                }
                const std::size_t property = static_cast<std::size_t>(columns[role]);
                const char* from = at_ + offsets[property];
                const Destination d = to[role];
                with_type(element.properties[property].type, [&](auto kind) {
                    for (std::size_t i = begin; i < end; ++i) {
                        d.first[i * d.stride] = static_cast<float>(load<decltype(kind)>(from + i * stride, swapped_));
                    }
                });
            }
        }
    }

    bool read_with_lists(const Element& element) {
        const Meaning meaning = meaning_of(element);
        const bool has_corners = meaning == Meaning::faces || meaning == Meaning::strips;
        const int corners = has_corners ? corner_list(element) : -1;
        const Property& first = element.properties.front();
        if (meaning == Meaning::faces && element.properties.size() == 1 && corners == 0 && first.count_type == Type::uint8 &&
            size_of(first.type) == 4 && !swapped_) {
            return read_plain_faces(element);
        }
        Columns columns;
        columns.fill(-1);
        std::array<Destination, role_count> to{};
        if (meaning == Meaning::vertices) {
            columns = vertex_columns(element);
            to = make_room(data_.mesh, static_cast<std::size_t>(element.count), columns);
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const Property& property = element.properties[p];
                if (property.is_list ? !read_list(element, property, i, static_cast<int>(p) == corners ? meaning : Meaning::nothing)
                                     : !read_scalar(element, property, i, static_cast<int>(p), columns, to)) {
                    return false;
                }
            }
        }
        return true;
    }

    // By far the most common: a byte that counts, and whole numbers of four bytes; and of these, triangles.
    bool read_plain_faces(const Element& element) {
        std::vector<glm::uvec3>& triangles = data_.mesh.triangles;
        std::size_t filled = triangles.size();
        constexpr std::size_t smallest = 1 + sizeof(glm::uvec3);  // of a triangle: no more than that fit into what is left
        triangles.resize(filled + std::min(static_cast<std::size_t>(element.count), left() / smallest));
        std::uint64_t i = 0;
        for (; i < element.count && left() > 0; ++i) {
            const std::size_t count = static_cast<unsigned char>(*at_);
            if (left() < 1 + 4 * count) {
                break;
            }
            if (count == 3) {
                std::memcpy(&triangles[filled++], at_ + 1, sizeof(glm::uvec3));
            } else {
                std::uint32_t numbers[255];
                std::memcpy(numbers, at_ + 1, 4 * count);
                data_.add_large_face(numbers, count);
            }
            at_ += 1 + 4 * count;
        }
        triangles.resize(filled);
        return i == element.count || ended_early(element, i);
    }

    bool read_list(const Element& element, const Property& property, std::uint64_t i, Meaning meaning) {
        const std::size_t count_size = size_of(property.count_type);
        const std::size_t entry_size = size_of(property.type);
        if (left() < count_size) {
            return ended_early(element, i);
        }
        const std::int64_t count = load_count(at_, property.count_type, swapped_);
        at_ += count_size;
        if (count < 0 || static_cast<std::uint64_t>(count) > left() / entry_size) {
            messages_.error(0, 0,
                            fmt::format("{} element {} (counted from 0): a list can't have {} entries, {} bytes are left",
                                        quoted(element.name), i, count, left()));
            return false;
        }
        const std::size_t entries = static_cast<std::size_t>(count);
        if (meaning != Meaning::nothing) {
            list_.resize(entries);
            for (std::size_t k = 0; k < entries; ++k) {
                list_[k] = load_corner(at_ + k * entry_size, property.type, swapped_);
            }
            meaning == Meaning::strips ? data_.add_strip(list_.data(), entries) : data_.add_face(list_.data(), entries);
        }
        at_ += entries * entry_size;
        return true;
    }

    bool read_scalar(const Element& element, const Property& property, std::uint64_t i, int number, const Columns& columns,
                     const std::array<Destination, role_count>& to) {
        const std::size_t size = size_of(property.type);
        if (left() < size) {
            return ended_early(element, i);
        }
        for (std::size_t role = 0; role < role_count; ++role) {
            if (columns[role] == number) {
                with_type(property.type, [&](auto kind) {
                    to[role].first[i * to[role].stride] = static_cast<float>(load<decltype(kind)>(at_, swapped_));
                });
            }
        }
        at_ += size;
        return true;
    }

    bool ended_early(const Element& element, std::uint64_t read_so_far) {
        messages_.error(0, 0, fmt::format("the file ends after {} of {} {} elements", read_so_far, element.count, quoted(element.name)));
        return false;
    }

    const char* at_;
    const char* end_;
    bool swapped_;
    const Header& header_;
    Data& data_;
    MeshMessages& messages_;
    std::vector<std::uint32_t> list_;
};

}  // namespace

void read_binary(std::string_view body, const Header& header, Data& data, MeshMessages& messages) {
    BinaryReader(body, header, data, messages).run();
}

}  // namespace lancer::ply
