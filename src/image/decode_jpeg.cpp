// SPDX-License-Identifier: Apache-2.0
// JPEG by libjpeg(-turbo), grey or color, 8 bits.
#include <algorithm>
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it
#include <vector>

#include "image/decoders.h"
// (the empty line keeps the headers from being sorted into one block)
#include <jerror.h>
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

// An upper bound. A file of several passes has the coefficients of all its blocks in memory.
std::uint64_t memory_of_libjpeg(jpeg_decompress_struct& info) {
    constexpr std::uint64_t rows = 64;  // of samples, with which it works
    const std::uint64_t mcu_width = 8 * std::uint64_t(std::max(info.max_h_samp_factor, 1)),
                        mcu_height = 8 * std::uint64_t(std::max(info.max_v_samp_factor, 1)),
                        across = (info.image_width + mcu_width - 1) / mcu_width,
                        down = (info.image_height + mcu_height - 1) / mcu_height;
    std::uint64_t coefficients = 0;
    for (int i = 0; i < info.num_components; ++i) {
        const jpeg_component_info& component = info.comp_info[i];
        coefficients += across * down * DCTSIZE2 * std::uint64_t(component.h_samp_factor) *
                        std::uint64_t(component.v_samp_factor);
    }
    return rows * across * mcu_width * std::uint64_t(info.num_components) +
           (jpeg_has_multiple_scans(&info) != 0 ? sizeof(JCOEF) * coefficients : 0);
}

// Runs body(), from which libjpeg may jump out: no destructor may be pending inside it.
template <class Body> void guard_jumps(Jpeg& file, Body&& body) {
    if (setjmp(file.errors.jump) != 0) {
        if (file.errors.manager.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
        throw Undecodable(std::string("JPEG: ") + file.errors.message);
    }
    body();
}

}  // namespace

DecodedPicture decode_jpeg(ByteSpan bytes, const DecoderOptions& options) {
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
    DecodedPicture result{make_picture(width, height, 255, memory_of_libjpeg(file.info), options), 8, {}};
    std::vector<std::uint8_t> row(3 * width);
    guard_jumps(file, [&] {
        file.info.out_color_space = JCS_RGB;
        file.info.dct_method = JDCT_ISLOW;
        jpeg_start_decompress(&file.info);
        for (std::size_t y = 0; y < height; ++y) {
            JSAMPROW rows[] = {row.data()};
            jpeg_read_scanlines(&file.info, rows, 1);
            result.picture.put_row(static_cast<std::int32_t>(y), row.data());
        }
        jpeg_finish_decompress(&file.info);
    });
    result.note = "JPEG changes colors a little";
    return result;
}

}  // namespace glint
