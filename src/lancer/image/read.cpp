#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "lancer/base/failure.h"
#include "lancer/base/file.h"
#include "lancer/image/image.h"
#include "lancer/image/images_module.h"
#include "lancer/image/memory_file.h"
#include "lancer/image/png.h"
#include "lancer/image/signature.h"
#include "lancer/image/stored.h"

namespace lancer {
namespace {

constexpr std::int64_t most_pixels = std::int64_t{1} << 29;

// No format in use packs better than deflate's 1 to 1032, but for a picture of a single colour here and there; what claims to be this many
// times larger than its file is broken, or made to fill the memory.
constexpr std::uint64_t most_packed = 4096;
constexpr std::uint64_t always_allowed = 1 << 20;  // bytes

void append(void* receiver, const char* data, std::size_t size) { static_cast<std::string*>(receiver)->append(data, size); }

std::string first_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        fail_to_read(path, std::strerror(errno));
    }
    std::array<char, 16> bytes{};
    file.read(bytes.data(), bytes.size());
    return {bytes.data(), static_cast<std::size_t>(file.gcount())};
}

std::uint64_t file_size(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        fail_to_read(path, errno == ENOENT ? "there is no such file" : std::strerror(errno));
    }
    if (!S_ISREG(status.st_mode)) {
        fail_to_read(path, "it is not a file");
    }
    return static_cast<std::uint64_t>(status.st_size);
}

struct Header {
    int width = 0;
    int height = 0;
    int channels = 0;
    int bits = 0;              // of a stored integer; 0 for floats
    std::uint64_t stored = 0;  // bytes of all the pixels, uncompressed
};

// An empty image of the header's size, if that is one that the file can fill.
Image make_image(const Header& header, std::uint64_t file_bytes) {
    check_size(header.width, header.height, header.stored, file_bytes);
    Image image{header.width, header.height, header.channels, {}};
    image.pixels.resize(static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height) *
                        static_cast<std::size_t>(header.channels));
    return image;
}

StoredPixels read_png(const std::string& path, std::uint64_t file_bytes) {
    PngReader reader(path);
    const auto area = static_cast<std::uint64_t>(reader.width()) * static_cast<std::uint64_t>(reader.height());
    const Header header{reader.width(), reader.height(), reader.channels(), reader.bits(),
                        area * static_cast<std::uint64_t>(reader.channels() * reader.bits() / 8)};
    StoredPixels result{make_image(header, file_bytes), header.bits};
    reader.read(result.image.pixels.data());
    return result;
}

StoredPixels read_by_module(const std::string& path, const std::string& format, std::uint64_t file_bytes) {
    if (format == "openexr" && !exr_attributes_fit(path, file_bytes)) {
        throw std::runtime_error("broken OpenEXR file: its header claims more bytes than the file has");
    }
    const LancerImages& module = images_module();
    std::string reason;
    LancerImageHeader found{};
    const auto close = [&module](void* reader) { module.close(reader); };
    const std::unique_ptr<void, decltype(close)> reader(module.open(path.c_str(), format.c_str(), &found, &reason, append), close);
    if (!reader) {
        throw std::runtime_error(reason);
    }
    const Header header{found.width, found.height, found.channels, found.bits, found.stored};
    StoredPixels result{make_image(header, file_bytes), header.bits};
    if (!module.read(reader.get(), result.image.pixels.data(), &reason, append)) {
        throw std::runtime_error(reason);
    }
    return result;
}

// The stored integers are few, so each is decoded once: n of `bits` bits comes as n / (2^bits - 1).
void decode_srgb(Image& image, int bits) {
    std::vector<float> table;
    float largest = 0.0f;
    if (bits == 8 || bits == 16) {
        largest = static_cast<float>((1 << bits) - 1);
        table.resize(std::size_t{1} << bits);
        for (std::size_t i = 0; i < table.size(); ++i) {
            table[i] = srgb_decode(static_cast<float>(i) / largest);
        }
    }
    const int colors = image.channels == 2 || image.channels == 4 ? image.channels - 1 : image.channels;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (static_cast<int>(i % static_cast<std::size_t>(image.channels)) >= colors) {
            continue;
        }
        float& value = image.pixels[i];
        if (!table.empty() && value >= 0.0f && value <= 1.0f) {
            value = table[static_cast<std::size_t>(value * largest + 0.5f)];
        } else {
            value = srgb_decode(value);
        }
    }
}

}  // namespace

void fail_to_read(const std::string& path, const std::string& reason) {
    throw std::runtime_error(fmt::format("cannot read the image {}: {}", path, reason));
}

FoundImage find_image(const std::string& path) {
    FoundImage found;
    found.bytes = file_size(path);
    found.format = image_format(first_bytes(path), file_ending(path));
    if (found.format.empty()) {
        fail_to_read(path, "its first bytes are those of no image format that lancer knows");
    }
    return found;
}

void check_size(std::int64_t width, std::int64_t height, std::uint64_t stored, std::uint64_t file_bytes) {
    if (width * height > most_pixels) {
        throw std::runtime_error(fmt::format("it is {} x {} pixels, more than the {} that are allowed", width, height, most_pixels));
    }
    if (stored > always_allowed && stored / most_packed > file_bytes) {
        throw std::runtime_error(fmt::format("it claims to be {} x {} pixels, but the file has only {} bytes", width, height, file_bytes));
    }
}

Image read_image(const std::string& path, Encoding encoding) {
    bool encoded = false;
    return read_image(path, encoding, encoded);
}

StoredPixels read_stored_pixels(const std::string& path) {
    const FoundImage found = find_image(path);
    try {
        return found.format == "png" ? read_png(path, found.bytes) : read_by_module(path, found.format, found.bytes);
    } catch (const std::bad_alloc&) {
        fail_to_read(path, "there is not enough memory for it");
    } catch (const MachineFailure& failure) {
        throw MachineFailure(fmt::format("cannot read the image {}: {}", path, failure.what()));
    } catch (const std::exception& error) {
        fail_to_read(path, error.what());
    }
}

namespace {

Image decoded(StoredPixels stored, Encoding encoding, bool& encoded) {
    encoded = encoding == Encoding::srgb || (encoding == Encoding::automatic && (stored.bits == 8 || stored.bits == 16));
    if (encoded) {
        decode_srgb(stored.image, stored.bits);
    }
    return std::move(stored.image);
}

}  // namespace

Image read_image(const std::string& path, Encoding encoding, bool& encoded) { return decoded(read_stored_pixels(path), encoding, encoded); }

StoredPixels read_stored_pixels(std::string_view bytes, const std::string& name) {
    const MemoryFile file(bytes);
    try {
        return read_stored_pixels(file.path());
    } catch (const MachineFailure&) {
        throw;
    } catch (const std::runtime_error& error) {
        std::string message = error.what();
        if (const std::size_t at = message.find(file.path()); at != std::string::npos) {
            message.replace(at, file.path().size(), name);
        }
        throw std::runtime_error(message);
    }
}

Image read_image(std::string_view bytes, const std::string& name, Encoding encoding) {
    bool encoded = false;
    return decoded(read_stored_pixels(bytes, name), encoding, encoded);
}

}  // namespace lancer
