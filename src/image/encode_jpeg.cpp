// SPDX-License-Identifier: Apache-2.0
// JPEG by libjpeg(-turbo): 8 bits, baseline, colors at full resolution.
#include <array>
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/quantizing_encoder.h"
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

// Takes the bytes from libjpeg, a chunk at a time. The encoder brings them to its file, because no exception
// may pass through libjpeg.
struct WrittenBytes {
    jpeg_destination_mgr manager{};  // first: libjpeg knows only this part
    std::array<JOCTET, 1 << 16> chunk;
    std::vector<std::uint8_t> bytes;

    void begin_chunk() {
        manager.next_output_byte = chunk.data();
        manager.free_in_buffer = chunk.size();
    }
    static WrittenBytes& of(j_compress_ptr info) { return *reinterpret_cast<WrittenBytes*>(info->dest); }
    static void take(j_compress_ptr info, std::size_t count) {
        WrittenBytes& written = of(info);
        bool has_memory = true;
        try {
            written.bytes.insert(written.bytes.end(), written.chunk.data(), written.chunk.data() + count);
        } catch (const std::bad_alloc&) {
            has_memory = false;
        }
        if (!has_memory) ERREXIT1(info, JERR_OUT_OF_MEMORY, 0);
        written.begin_chunk();
    }
    static void begin(j_compress_ptr info) { of(info).begin_chunk(); }
    static boolean take_chunk(j_compress_ptr info) {
        take(info, of(info).chunk.size());
        return TRUE;
    }
    static void end(j_compress_ptr info) {
        take(info, of(info).chunk.size() - of(info).manager.free_in_buffer);
    }

    WrittenBytes() {
        manager.init_destination = begin;
        manager.empty_output_buffer = take_chunk;
        manager.term_destination = end;
    }
};

struct Compressor {
    jpeg_compress_struct info{};

    Compressor() = default;
    ~Compressor() { jpeg_destroy_compress(&info); }  // also if it was never created: all bytes are zero
    Compressor(const Compressor&) = delete;
    Compressor& operator=(const Compressor&) = delete;
};

class JpegEncoder : public QuantizingEncoder {
  public:
    JpegEncoder(std::int32_t width, std::int32_t height, const EncodeOptions& options, ByteFile& file)
        : QuantizingEncoder(width, options, file),
          samples_(std::size_t{3} * static_cast<std::size_t>(width)) {
        info_.err = jpeg_std_error(&errors_.manager);
        errors_.manager.error_exit = on_write_error;
        errors_.manager.emit_message = on_write_message;
        guard_jumps([&] {
            jpeg_create_compress(&info_);
            info_.dest = &written_.manager;
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

    void append(EncodedStrip strip) override {
        guard_jumps([&] {
            for (std::size_t first = 0; first < strip.bytes.size(); first += samples_) {
                JSAMPROW rows[] = {&strip.bytes[first]};
                jpeg_write_scanlines(&info_, rows, 1);
            }
        });
        write_bytes();
    }
    void finish() override {
        guard_jumps([&] { jpeg_finish_compress(&info_); });
        write_bytes();
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

    void write_bytes() {
        file_.write(written_.bytes);
        written_.bytes.clear();
    }

    const std::size_t samples_;  // of a row
    WriteErrors errors_{};
    WrittenBytes written_;
    Compressor compressor_;  // is destroyed first: it uses both
    jpeg_compress_struct& info_ = compressor_.info;
};

}  // namespace

std::unique_ptr<StripEncoder> make_jpeg_encoder(std::int32_t width, std::int32_t height,
                                                const EncodeOptions& options, ByteFile& file) {
    return std::make_unique<JpegEncoder>(width, height, options, file);
}

}  // namespace glint
