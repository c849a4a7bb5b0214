// Numbers as the bytes they are in memory, one after another: for files that the same kind of machine reads again.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace lancer {

static_assert(std::endian::native == std::endian::little, "files hold little-endian numbers");

class ByteWriter {
public:
    template <class Number>
    void put(const Number& value) {
        put_all(std::span<const Number>(&value, 1));
    }
    template <class Number>
    void put_all(std::span<const Number> values) {
        static_assert(std::is_trivially_copyable_v<Number>);
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }
    void put_text(std::string_view text) {
        put(static_cast<std::uint64_t>(text.size()));
        bytes_.append(text);
    }

    const std::string& bytes() const { return bytes_; }
    void clear() { bytes_.clear(); }

private:
    std::string bytes_;
};

// Once something was missing, everything is, and what is read is left as it was.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : left_(bytes) {}

    bool good() const { return good_; }
    std::size_t left() const { return left_.size(); }

    template <class Number>
    void get(Number& value) {
        get_all(std::span<Number>(&value, 1));
    }
    template <class Number>
    void get_all(std::span<Number> values) {
        static_assert(std::is_trivially_copyable_v<Number>);
        const std::string_view bytes = take(values.size_bytes());
        if (!bytes.empty()) {
            std::memcpy(values.data(), bytes.data(), bytes.size());
        }
    }
    std::string_view take(std::uint64_t size) {
        if (!good_ || size > left_.size()) {
            good_ = false;
            return {};
        }
        const std::string_view bytes = left_.substr(0, static_cast<std::size_t>(size));
        left_.remove_prefix(bytes.size());
        return bytes;
    }
    std::string get_text() {
        std::uint64_t size = 0;
        get(size);
        return std::string(take(size));
    }

private:
    std::string_view left_;
    bool good_ = true;
};

}  // namespace lancer
