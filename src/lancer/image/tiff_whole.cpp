#include "lancer/image/tiff_whole.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace lancer {

namespace {

class Tiff {
public:
    explicit Tiff(std::string_view bytes) : bytes_(bytes), little_(bytes.starts_with("II")) {}

    std::optional<std::uint32_t> number(std::size_t place, std::size_t size) const {
        if (place > bytes_.size() || bytes_.size() - place < size) {
            return std::nullopt;
        }
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t at = place + (little_ ? size - 1 - i : i);
            value = value << 8 | static_cast<unsigned char>(bytes_[at]);
        }
        return value;
    }

    // The whole numbers of a directory's entry, 2 or 4 bytes each. Nothing where they are not there.
    std::optional<std::vector<std::uint32_t>> numbers(std::size_t entry) const {
        const auto type = number(entry + 2, 2), count = number(entry + 4, 4), place = number(entry + 8, 4);
        if (!type || !count || !place) {
            return std::nullopt;
        }
        const std::size_t size = *type == 3 ? 2 : 4;
        const std::size_t first = *count * size <= 4 ? entry + 8 : *place;
        if (*count > bytes_.size()) {
            return std::nullopt;
        }
        std::vector<std::uint32_t> values;
        for (std::size_t i = 0; i < *count; ++i) {
            const auto value = number(first + i * size, size);
            if (!value) {
                return std::nullopt;
            }
            values.push_back(*value);
        }
        return values;
    }

private:
    std::string_view bytes_;
    bool little_;
};

// Strips or tiles, by where they begin and how long they are.
bool lie_within(const std::vector<std::uint32_t>& places, const std::vector<std::uint32_t>& lengths, std::size_t size) {
    if (places.size() != lengths.size()) {
        return false;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (std::size_t{places[i]} + lengths[i] > size) {
            return false;
        }
    }
    return true;
}

}  // namespace

bool is_whole_tiff(std::string_view bytes) {
    constexpr std::size_t entry_size = 12;
    const Tiff tiff(bytes);
    const auto first = tiff.number(4, 4);
    if ((!bytes.starts_with("II*") && !bytes.starts_with(std::string_view("MM\0*", 4))) || !first) {
        return false;
    }
    const auto entries = tiff.number(*first, 2);
    if (!entries || !tiff.number(*first + 2 + *entries * entry_size, 4)) {
        return false;
    }
    std::vector<std::uint32_t> places, lengths;
    for (std::size_t i = 0; i < *entries; ++i) {
        const std::size_t entry = *first + 2 + i * entry_size;
        const auto tag = tiff.number(entry, 2);
        const bool is_place = tag == 273u || tag == 324u, is_length = tag == 279u || tag == 325u;
        if (is_place || is_length) {
            auto values = tiff.numbers(entry);
            if (!values) {
                return false;
            }
            (is_place ? places : lengths) = std::move(*values);
        }
    }
    return !places.empty() && lie_within(places, lengths, bytes.size());
}

}  // namespace lancer
