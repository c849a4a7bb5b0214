#include <png.h>

#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

#include "lancer/image/png.h"

namespace lancer {

// What must outlive a longjmp out of libpng: nothing with a destructor may live in the frame that it leaves.
struct PngReader::State {
    std::FILE* file = nullptr;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<png_byte> bytes;
    std::vector<png_bytep> rows;
    char error[200] = "";

    ~State() {
        png_destroy_read_struct(&png, &info, nullptr);
        if (file) {
            std::fclose(file);
        }
    }
};

namespace {

void on_error(png_structp png, png_const_charp message) {
    char* const error = static_cast<char*>(png_get_error_ptr(png));
    std::strncpy(error, message, 199);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

// The header, and every kind of pixel turned into 8 or 16 bits of grey or RGB, with or without alpha.
bool read_header(png_structp png, png_infop info, std::FILE* file) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_init_io(png, file);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    // Only what the pixels need: libpng takes the memory that a text claims before it reads it.
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(png, info);
    png_set_expand(png);  // palettes, 1 to 4 bits, transparent colours
    if (std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_read_image(png, rows);
    return true;
}

}  // namespace

PngReader::PngReader(const std::string& path) : state_(nullptr) {
    auto state = std::make_unique<State>();
    state->file = std::fopen(path.c_str(), "rb");
    if (!state->file) {
        throw std::runtime_error(std::strerror(errno));
    }
    state->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, state->error, on_error, on_warning);
    state->info = state->png ? png_create_info_struct(state->png) : nullptr;
    if (!state->info) {
        throw std::bad_alloc();
    }
    if (!read_header(state->png, state->info, state->file)) {
        throw std::runtime_error(std::string("broken PNG file: ") + state->error);
    }
    width_ = static_cast<int>(png_get_image_width(state->png, state->info));
    height_ = static_cast<int>(png_get_image_height(state->png, state->info));
    channels_ = png_get_channels(state->png, state->info);
    bits_ = png_get_bit_depth(state->png, state->info);
    state_ = state.release();
}

PngReader::~PngReader() { delete state_; }

void PngReader::read(float* pixels) {
    State& state = *state_;
    const std::size_t stride = png_get_rowbytes(state.png, state.info);
    const std::size_t height = static_cast<std::size_t>(height_);
    state.bytes.resize(stride * height);
    state.rows.resize(height);
    for (std::size_t y = 0; y < height; ++y) {
        state.rows[y] = state.bytes.data() + y * stride;
    }
    if (!read_rows(state.png, state.rows.data())) {
        throw std::runtime_error(std::string("broken PNG file: ") + state.error);
    }
    const std::size_t row_values = static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels_);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t i = 0; i < row_values; ++i) {
            if (bits_ == 16) {
                std::uint16_t value;
                std::memcpy(&value, state.rows[y] + 2 * i, sizeof value);
                *pixels++ = static_cast<float>(value) / 65535.0f;
            } else {
                *pixels++ = static_cast<float>(state.rows[y][i]) / 255.0f;
            }
        }
    }
}

}  // namespace lancer
