#include "lancer/import/gltf/meshopt_indices.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace lancer::gltf {

namespace {

constexpr std::uint8_t triangles_header = 0xE1;
constexpr std::uint8_t indices_header = 0xD1;

void store(const MeshoptView& view, std::string& to, std::size_t i, std::uint32_t index) {
    if (view.stride == 2) {
        const auto small = static_cast<std::uint16_t>(index);
        std::memcpy(&to[2 * i], &small, sizeof small);
    } else {
        std::memcpy(&to[4 * i], &index, sizeof index);
    }
}

// Reads past the end give zeros; the decoders ask `overran` afterwards.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

    std::uint8_t byte() {
        const std::size_t at = at_++;
        return at < bytes_.size() ? static_cast<std::uint8_t>(bytes_[at]) : std::uint8_t{0};
    }
    // Seven bits a byte, the lowest first; the highest bit says that more follow.
    std::uint32_t variable() {
        std::uint32_t value = 0;
        for (unsigned shift = 0; shift < 35; shift += 7) {
            const std::uint32_t part = byte();
            value |= (part & 0x7F) << shift;
            if (part < 0x80) {
                break;
            }
        }
        return value;
    }
    bool overran() const { return at_ > bytes_.size(); }
    bool at_end() const { return at_ == bytes_.size(); }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

std::uint32_t from_zigzag(std::uint32_t v) { return (v >> 1) ^ (0u - (v & 1)); }

// The last sixteen of something; the newest has age 0.
template <class Item>
class Recent {
public:
    void push(const Item& item) { items_[next_++ % 16] = item; }
    const Item& aged(unsigned age) const { return items_[(next_ + 15 - age) % 16]; }

private:
    std::array<Item, 16> items_{};
    unsigned next_ = 0;
};

struct Edge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
};

class TriangleDecoder {
public:
    TriangleDecoder(std::string_view data, std::string_view table) : data_(data), table_(table) {}

    std::array<std::uint32_t, 3> next(std::uint8_t code) { return code < 0xF0 ? from_edge(code >> 4, code & 15) : on_its_own(code); }
    const Bytes& data() const { return data_; }

private:
    // A triangle at one of the recent edges, with a corner that is new, recent, next to the last free one, or free.
    std::array<std::uint32_t, 3> from_edge(unsigned edge, unsigned corner) {
        const Edge shared = edges_.aged(edge);
        std::uint32_t c = 0;
        if (corner == 0) {
            c = fresh_++;
        } else if (corner < 13) {
            c = vertices_.aged(corner);
        } else {
            last_ = c = corner == 13 ? last_ - 1 : corner == 14 ? last_ + 1 : free_index();
        }
        if (corner == 0 || corner >= 13) {
            vertices_.push(c);
        }
        edges_.push({c, shared.to});
        edges_.push({shared.from, c});
        return {shared.from, shared.to, c};
    }

    std::array<std::uint32_t, 3> on_its_own(std::uint8_t code) {
        const bool from_table = code < 0xFE;
        const std::uint8_t corners = from_table ? static_cast<std::uint8_t>(table_[code & 15]) : data_.byte();
        const unsigned kind_a = code == 0xFF ? 15 : 0, kind_b = corners >> 4, kind_c = corners & 15;
        if (!from_table && corners == 0) {
            fresh_ = 0;
        }
        // All recent corners are looked up, and all new ones numbered, before any free one is read. The newest has age 1 here.
        std::uint32_t a = kind_a == 0 ? fresh_++ : 0;
        std::uint32_t b = kind_b == 0 ? fresh_++ : vertices_.aged(kind_b - 1);
        std::uint32_t c = kind_c == 0 ? fresh_++ : vertices_.aged(kind_c - 1);
        if (!from_table) {
            a = kind_a == 15 ? last_ = free_index() : a;
            b = kind_b == 15 ? last_ = free_index() : b;
            c = kind_c == 15 ? last_ = free_index() : c;
        }
        vertices_.push(a);
        if (kind_b == 0 || (!from_table && kind_b == 15)) {
            vertices_.push(b);
        }
        if (kind_c == 0 || (!from_table && kind_c == 15)) {
            vertices_.push(c);
        }
        edges_.push({b, a});
        edges_.push({c, b});
        edges_.push({a, c});
        return {a, b, c};
    }

    std::uint32_t free_index() { return last_ + from_zigzag(data_.variable()); }

    Bytes data_;
    std::string_view table_;
    Recent<Edge> edges_;
    Recent<std::uint32_t> vertices_;
    std::uint32_t fresh_ = 0;
    std::uint32_t last_ = 0;
};

}  // namespace

bool decode_triangles(const MeshoptView& view, std::string& indices, std::string& problem) {
    constexpr std::size_t table_size = 16;
    const std::size_t triangles = view.count / 3;
    if (view.count % 3 != 0 || view.bytes.size() < 1 + triangles + table_size ||
        static_cast<std::uint8_t>(view.bytes[0]) != triangles_header) {
        problem = "these are no compressed triangles of the version that EXT_meshopt_compression uses, or too few";
        return false;
    }
    const std::string_view codes = view.bytes.substr(1, triangles);
    const std::string_view table = view.bytes.substr(view.bytes.size() - table_size);
    TriangleDecoder decoder(view.bytes.substr(1 + triangles, view.bytes.size() - 1 - triangles - table_size), table);
    for (std::size_t t = 0; t < triangles; ++t) {
        const std::array<std::uint32_t, 3> corners = decoder.next(static_cast<std::uint8_t>(codes[t]));
        for (std::size_t i = 0; i < 3; ++i) {
            store(view, indices, 3 * t + i, corners[i]);
        }
    }
    if (!decoder.data().at_end()) {
        problem = "the compressed triangles do not end where their bytes do";
        return false;
    }
    return true;
}

bool decode_indices(const MeshoptView& view, std::string& indices, std::string& problem) {
    constexpr std::size_t tail = 4;
    if (view.bytes.size() < 1 + tail || static_cast<std::uint8_t>(view.bytes[0]) != indices_header) {
        problem = "these are no compressed indices of the version that EXT_meshopt_compression uses";
        return false;
    }
    Bytes data(view.bytes.substr(1, view.bytes.size() - 1 - tail));
    std::uint32_t last[2] = {0, 0};
    for (std::size_t i = 0; i < view.count; ++i) {
        const std::uint32_t value = data.variable();
        std::uint32_t& base = last[value & 1];
        base += from_zigzag(value >> 1);
        store(view, indices, i, base);
        if (data.overran()) {
            problem = "the compressed indices end too early";
            return false;
        }
    }
    if (!data.at_end()) {
        problem = "the compressed indices do not end where their bytes do";
        return false;
    }
    return true;
}

}  // namespace lancer::gltf
