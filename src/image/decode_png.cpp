// SPDX-License-Identifier: Apache-2.0
// PNG by libpng: any color type, 1 to 16 bits, interlaced or not.
#include <png.h>

#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "image/decoders.h"

namespace glint {
namespace {

// A byte of deflate gives at most this many bytes of picture (a figure of zlib); a file that claims more is
// truncated.
constexpr std::size_t k_max_inflated = 1032;

// Rows with which libpng works, besides ours.
constexpr std::size_t k_rows_of_libpng = 4;

// State that survives a longjmp; libpng's callbacks use it.
struct Reading {
    ByteSpan bytes;
    std::size_t at = 0;
    std::string error;
    bool has_holes = false;  // a pixel that is not opaque
    bool out_of_memory = false;
};

void read_bytes(png_structp png, png_bytep out, std::size_t count) {
    auto& reading = *static_cast<Reading*>(png_get_io_ptr(png));
    if (count > reading.bytes.size() - reading.at) png_error(png, "the file is cut off");
    std::memcpy(out, reading.bytes.data() + reading.at, count);
    reading.at += count;
}

png_voidp allocate(png_structp png, png_alloc_size_t size) {
    void* memory = std::malloc(size);
    if (memory == nullptr) static_cast<Reading*>(png_get_mem_ptr(png))->out_of_memory = true;
    return memory;
}

void release(png_structp, png_voidp memory) { std::free(memory); }

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    auto& reading = *static_cast<Reading*>(png_get_error_ptr(png));
    try {
        reading.error = message;
    } catch (...) {  // no exception may pass through C; an empty message is replaced below
    }
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

struct Png {
    png_structp png = nullptr;
    png_infop info = nullptr;
    ~Png() { png_destroy_read_struct(&png, &info, nullptr); }
};

// Runs body(), from which libpng may jump out: no destructor may be pending inside it.
template <class Body> void guard_jumps(Png& file, Reading& reading, Body&& body) {
    if (setjmp(png_jmpbuf(file.png)) != 0) {
        if (reading.out_of_memory) throw std::bad_alloc();
        throw Undecodable("PNG: " + (reading.error.empty() ? std::string("unreadable") : reading.error));
    }
    body();
}

// Requests channels of 8 or 16 bits: RGBA for every color type.
void ask_for_rgba(const Png& file, int bits) {
    png_set_expand(file.png);  // palettes, greys with few bits, a transparent color
    png_set_gray_to_rgb(file.png);
    png_set_add_alpha(file.png, bits == 16 ? 0xffff : 0xff, PNG_FILLER_AFTER);
}

std::uint32_t channel_at(const std::uint8_t* row, std::size_t i, std::uint8_t) { return row[i]; }
std::uint32_t channel_at(const std::uint8_t* row, std::size_t i, std::uint16_t) {
    return std::uint32_t{row[2 * i]} << 8 | row[2 * i + 1];
}

// Stores the RGB of a row of RGBA, which `rgb` has room for; true if a pixel is not opaque.
template <class Number>
bool take_row(const std::uint8_t* row, std::int32_t y, std::vector<Number>& rgb, StoredPicture& picture) {
    std::uint32_t opaque = picture.most;
    for (std::size_t x = 0; 3 * x < rgb.size(); ++x) {
        for (std::size_t c = 0; c < 3; ++c)
            rgb[3 * x + c] = static_cast<Number>(channel_at(row, 4 * x + c, Number{}));
        opaque &= channel_at(row, 4 * x + 3, Number{});
    }
    picture.put_row(y, rgb.data());
    return opaque != picture.most;
}

}  // namespace

DecodedPicture decode_png(ByteSpan bytes, const DecoderOptions& options) {
    Reading reading;
    reading.bytes = bytes;
    Png file;
    file.png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &reading, on_error, on_warning, &reading,
                                        allocate, release);
    if (file.png == nullptr) throw std::bad_alloc();
    file.info = png_create_info_struct(file.png);
    if (file.info == nullptr) throw std::bad_alloc();
    png_set_read_fn(file.png, &reading, read_bytes);
    png_set_user_limits(file.png, k_max_size, k_max_size);
    // Texts and profiles are not used; a thousand of them would take eight megabytes each.
    png_set_keep_unknown_chunks(file.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_set_chunk_malloc_max(file.png, 1 << 23);
    png_set_crc_action(file.png, PNG_CRC_ERROR_QUIT, PNG_CRC_WARN_DISCARD);
    guard_jumps(file, reading, [&] { png_read_info(file.png, file.info); });

    const std::size_t width = png_get_image_width(file.png, file.info),
                      height = png_get_image_height(file.png, file.info);
    check_size(static_cast<std::int64_t>(width), static_cast<std::int64_t>(height), options);
    const std::size_t packed_row = png_get_rowbytes(file.png, file.info);
    if (packed_row * height / k_max_inflated > bytes.size()) throw Undecodable("PNG: the file is cut off");
    const int file_bits = png_get_bit_depth(file.png, file.info), bits = file_bits == 16 ? 16 : 8;

    const std::size_t row_bytes = 4 * width * (bits / 8);
    const bool interlaced = png_get_interlace_type(file.png, file.info) != PNG_INTERLACE_NONE;
    const std::size_t rows_bytes = interlaced ? row_bytes * height : row_bytes;
    DecodedPicture result{
        make_picture(width, height, bits == 16 ? 65535 : 255,
                     rows_bytes + k_rows_of_libpng * row_bytes + sizeof(png_bytep) * height, options),
        file_bits,
        {}};
    StoredPicture& picture = result.picture;
    std::vector<std::uint8_t> rows(rows_bytes), rgb(bits == 8 ? 3 * width : 0);
    std::vector<std::uint16_t> wide_rgb(bits == 16 ? 3 * width : 0);
    std::vector<png_bytep> pointers;
    for (std::size_t y = 0; interlaced && y < height; ++y) pointers.push_back(&rows[y * row_bytes]);
    guard_jumps(file, reading, [&] {
        ask_for_rgba(file, bits);
        if (interlaced) png_set_interlace_handling(file.png);
        png_read_update_info(file.png, file.info);
        if (interlaced) png_read_image(file.png, pointers.data());
        for (std::size_t y = 0; y < height; ++y) {
            if (!interlaced) png_read_row(file.png, rows.data(), nullptr);
            const std::uint8_t* row = interlaced ? pointers[y] : rows.data();
            const auto at = static_cast<std::int32_t>(y);
            reading.has_holes |=
                bits == 16 ? take_row(row, at, wide_rgb, picture) : take_row(row, at, rgb, picture);
        }
        png_read_end(file.png, nullptr);
    });

    if (reading.has_holes) result.note = "its transparency is left out";
    return result;
}

}  // namespace glint
