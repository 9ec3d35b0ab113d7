// SPDX-License-Identifier: Apache-2.0
// JPEG by libjpeg(-turbo): 8 bits, baseline, colors at full resolution.
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it
#include <cstdlib>
#include <stdexcept>

#include "image/uncompressed.h"
// (the empty line keeps the headers from being sorted into one block)
#include <jerror.h>
#include <jpeglib.h>

namespace glint {
namespace {

struct WriteErrors {
    jpeg_error_mgr manager;  // first: libjpeg knows only this part
    std::jmp_buf jump;
};

[[noreturn]] void on_write_error(j_common_ptr info) {
    std::longjmp(reinterpret_cast<WriteErrors*>(info->err)->jump, 1);
}

void on_write_message(j_common_ptr, int) {}

class JpegEncoder : public UncompressedEncoder {
  public:
    JpegEncoder(std::int32_t width, std::int32_t height, const EncodeOptions& options, ByteFile& file)
        : UncompressedEncoder(width, options, file),
          samples_(std::size_t{3} * static_cast<std::size_t>(width)) {
        info_.err = jpeg_std_error(&errors_.manager);
        errors_.manager.error_exit = on_write_error;
        errors_.manager.emit_message = on_write_message;
        guard_jumps([&] {
            jpeg_create_compress(&info_);
            jpeg_mem_dest(&info_, &bytes_, &size_);
            info_.image_width = static_cast<JDIMENSION>(width);
            info_.image_height = static_cast<JDIMENSION>(height);
            info_.input_components = 3;
            info_.in_color_space = JCS_RGB;
            jpeg_set_defaults(&info_);
            jpeg_set_quality(&info_, options.jpeg_quality, TRUE);
            info_.dct_method = JDCT_ISLOW;
            for (int i = 0; i < info_.num_components; ++i)
                info_.comp_info[i].h_samp_factor = info_.comp_info[i].v_samp_factor = 1;
            jpeg_start_compress(&info_, TRUE);
        });
    }
    ~JpegEncoder() override {
        jpeg_destroy_compress(&info_);  // also if it was never created: all bytes are zero
        std::free(bytes_);
    }
    JpegEncoder(const JpegEncoder&) = delete;
    JpegEncoder& operator=(const JpegEncoder&) = delete;

    void append(EncodedStrip strip) override {
        guard_jumps([&] {
            for (std::size_t first = 0; first < strip.bytes.size(); first += samples_) {
                JSAMPROW rows[] = {&strip.bytes[first]};
                jpeg_write_scanlines(&info_, rows, 1);
            }
        });
    }
    void finish() override {
        guard_jumps([&] { jpeg_finish_compress(&info_); });
        file_.write({bytes_, size_});
    }

  private:
    // Runs body(), from which libjpeg may jump out: no destructor may be pending inside it.
    template <class Body> void guard_jumps(Body&& body) {
        if (setjmp(errors_.jump) != 0) {
            if (errors_.manager.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
            char message[JMSG_LENGTH_MAX];
            errors_.manager.format_message(reinterpret_cast<j_common_ptr>(&info_), message);
            throw std::runtime_error(std::string("JPEG: ") + message);
        }
        body();
    }

    const std::size_t samples_;  // of a row
    jpeg_compress_struct info_{};
    WriteErrors errors_{};
    unsigned char* bytes_ = nullptr;  // of the file so far, by malloc
    unsigned long size_ = 0;
};

}  // namespace

std::unique_ptr<StripEncoder> make_jpeg_encoder(std::int32_t width, std::int32_t height,
                                                const EncodeOptions& options, ByteFile& file) {
    return std::make_unique<JpegEncoder>(width, height, options, file);
}

}  // namespace glint
