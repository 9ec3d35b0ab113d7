// SPDX-License-Identifier: Apache-2.0
// JPEG by libjpeg(-turbo), grey or colour, 8 bits.
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it
#include <vector>

#include "image/decoders.h"
// (the empty line keeps the headers from being sorted into one block)
#include <jpeglib.h>

namespace glint {
namespace {

// Progressive files store the picture in passes; usual files have about ten, hostile ones thousands.
constexpr int k_max_scans = 100;

struct ErrorManager {
    jpeg_error_mgr manager;  // first: libjpeg knows only this part
    std::jmp_buf jump;
    char message[JMSG_LENGTH_MAX];
    bool is_cut;
};

[[noreturn]] void fail(ErrorManager& errors) { std::longjmp(errors.jump, 1); }

[[noreturn]] void on_error(j_common_ptr info) {
    auto& errors = *reinterpret_cast<ErrorManager*>(info->err);
    info->err->format_message(info, errors.message);
    fail(errors);
}

// Warnings report damaged data, which libjpeg replaces by grey.
void on_message(j_common_ptr info, int level) {
    if (level < 0) on_error(info);
}

void on_progress(j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= k_max_scans) return;
    auto& errors = *reinterpret_cast<ErrorManager*>(info->err);
    std::snprintf(errors.message, sizeof errors.message, "more than %d passes", k_max_scans);
    fail(errors);
}

struct Jpeg {
    jpeg_decompress_struct info{};
    ErrorManager errors{};
    jpeg_progress_mgr progress{};
    ~Jpeg() { jpeg_destroy_decompress(&info); }  // also if it was never created: all bytes are zero
};

// Runs body(), from which libjpeg may jump out: no destructor may be pending inside it.
template <class Body> void guard_jumps(Jpeg& file, Body&& body) {
    if (setjmp(file.errors.jump) != 0) throw Undecodable(std::string("JPEG: ") + file.errors.message);
    body();
}

}  // namespace

DecodedImage decode_jpeg(ByteSpan bytes, const DecodeOptions& options) {
    Jpeg file;
    file.info.err = jpeg_std_error(&file.errors.manager);
    file.errors.manager.error_exit = on_error;
    file.errors.manager.emit_message = on_message;
    file.progress.progress_monitor = on_progress;
    guard_jumps(file, [&] {
        jpeg_create_decompress(&file.info);
        file.info.progress = &file.progress;
        jpeg_mem_src(&file.info, bytes.data(), static_cast<unsigned long>(bytes.size()));
        jpeg_read_header(&file.info, TRUE);
    });
    check_size(file.info.image_width, file.info.image_height, options);
    // A block of 8 x 8 pixels takes at least one bit, so a short file cannot be a large picture.
    const std::uint64_t blocks = std::uint64_t{file.info.image_width} * file.info.image_height / 64;
    if (blocks > 8 * std::uint64_t{bytes.size()})
        throw Undecodable("JPEG: the file is too short for its size");
    if (file.info.num_components != 1 && file.info.num_components != 3)
        throw Undecodable("JPEG: neither grey nor RGB");

    const std::size_t width = file.info.image_width, height = file.info.image_height;
    Image image{static_cast<std::int32_t>(width), static_cast<std::int32_t>(height), {}};
    std::vector<std::uint8_t> row(3 * width);
    image.rgb.resize(3 * width * height);
    guard_jumps(file, [&] {
        file.info.out_color_space = JCS_RGB;
        file.info.dct_method = JDCT_ISLOW;
        jpeg_start_decompress(&file.info);
        for (std::size_t y = 0; y < height; ++y) {
            JSAMPROW rows[] = {row.data()};
            jpeg_read_scanlines(&file.info, rows, 1);
            for (std::size_t i = 0; i < row.size(); ++i)
                image.rgb[3 * width * y + i] = static_cast<float>(row[i]) / 255.0f;
        }
        jpeg_finish_decompress(&file.info);
    });
    DecodedImage result;
    result.note = "JPEG changes colours a little";
    result.image = std::move(image);
    return result;
}

}  // namespace glint
