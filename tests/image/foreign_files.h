// SPDX-License-Identifier: Apache-2.0
#pragma once
// Picture files of kinds that glint reads but does not write, made with the libraries.
#include <png.h>

#include <cstdint>
#include <cstdio>  // jpeglib.h needs it before
#include <cstdlib>
#include <vector>
// (so that the headers are not sorted into one block)
#include <jpeglib.h>

namespace glint::test {

using Bytes = std::vector<std::uint8_t>;

struct PngKind {
    int color_type = PNG_COLOR_TYPE_RGB, bits = 8;
    bool interlaced = false;
};

/// A PNG whose packed rows are `rows`. A palette has 16 entries, (16 i, 255 - i, i).
inline Bytes make_png(int width, const std::vector<Bytes>& rows, const PngKind& kind) {
    Bytes out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto write = [](png_structp p, png_bytep data, std::size_t count) {
        auto& to = *static_cast<Bytes*>(png_get_io_ptr(p));
        to.insert(to.end(), data, data + count);
    };
    png_set_write_fn(png, &out, write, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(rows.size()), kind.bits,
                 kind.color_type, kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
        png_color palette[16];
        for (int i = 0; i < 16; ++i)
            palette[i] = {static_cast<png_byte>(16 * i), static_cast<png_byte>(255 - i),
                          static_cast<png_byte>(i)};
        png_set_PLTE(png, info, palette, 16);
    }
    png_write_info(png, info);
    std::vector<png_bytep> pointers;
    for (const Bytes& row : rows) pointers.push_back(const_cast<png_bytep>(row.data()));
    png_write_image(png, pointers.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return out;
}

/// A JPEG of the best quality, with `components` (1 or 3) bytes per pixel.
inline Bytes make_jpeg(int width, int height, int components, const Bytes& samples, bool progressive) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &memory, &size);
    info.image_width = static_cast<JDIMENSION>(width);
    info.image_height = static_cast<JDIMENSION>(height);
    info.input_components = components;
    info.in_color_space = components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, 100, TRUE);
    if (progressive) jpeg_simple_progression(&info);
    for (int c = 0; c < components; ++c)
        info.comp_info[c].h_samp_factor = info.comp_info[c].v_samp_factor = 1;
    jpeg_start_compress(&info, TRUE);
    for (int y = 0; y < height; ++y) {
        auto* row = const_cast<JSAMPROW>(&samples[static_cast<std::size_t>(y) * width * components]);
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    Bytes out(memory, memory + size);
    std::free(memory);
    return out;
}

}  // namespace glint::test
