// SPDX-License-Identifier: Apache-2.0
// OpenEXR: linear float RGB. On one thread: more would need the library's global pool.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>

#include <cstdint>
#include <exception>
#include <optional>
#include <string>

#include "image/encoders.h"
#include "image/memory_file.h"

namespace glint {
namespace {

// The library's view of a ByteFile. The library ignores errors at the end of a file, so the first one is
// kept.
class Stream : public Imf::OStream {
  public:
    explicit Stream(ByteFile& file) : Imf::OStream("file"), file_(file) {}
    void write(const char data[], int count) override {
        keep([&] {
            file_.write({reinterpret_cast<const std::uint8_t*>(data), static_cast<std::size_t>(count)});
        });
    }
    uint64_t tellp() override { return file_.position(); }
    void seekp(uint64_t position) override {
        keep([&] { file_.seek(position); });
    }
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    template <class Body> void keep(Body&& body) {
        try {
            body();
        } catch (...) {
            failure_ = std::current_exception();
            throw;
        }
    }
    ByteFile& file_;
    std::exception_ptr failure_;
};

Imf::Header header_of(std::string_view channels, std::int32_t width, std::int32_t height) {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char channel : channels)
        header.channels().insert(std::string(1, channel), Imf::Channel(Imf::FLOAT));
    return header;
}

// Interleaved channels in memory, of the rows from `first_row`.
Imf::FrameBuffer frame_of(std::string_view channels, const float* values, std::int32_t width,
                          std::int32_t first_row) {
    Imf::FrameBuffer frame;
    const std::size_t pixel = channels.size() * sizeof(float);
    const std::size_t row = pixel * static_cast<std::size_t>(width);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        // The library only reads from the slices of an output file, but requires pointers to non-const. It
        // counts rows from the top of the picture. The address is computed as a number, because it may lie
        // outside the memory of the rows.
        const auto address =
            reinterpret_cast<std::uintptr_t>(values + c) - row * static_cast<std::size_t>(first_row);
        auto* base = reinterpret_cast<char*>(address);  // NOLINT(performance-no-int-to-ptr)
        frame.insert(std::string(1, channels[c]), Imf::Slice(Imf::FLOAT, base, pixel, row));
    }
    return frame;
}

class ExrEncoder : public StripEncoder {
  public:
    ExrEncoder(std::int32_t width, std::int32_t height, ByteFile& file, bool alpha)
        : channels_(alpha ? "RGBA" : "RGB"),
          width_(width),
          stream_(file),
          file_(std::in_place, stream_, header_of(channels_, width, height), 0) {}

    EncodedStrip encode(std::int32_t, std::span<const float> values) const override {
        EncodedStrip strip;
        strip.values.assign(values.begin(), values.end());
        return strip;
    }
    void append(EncodedStrip strip) override { append_rows(strip.values); }

    void append_rows(std::span<const float> values) {
        const auto rows =
            static_cast<std::int32_t>(values.size() / channels_.size() / static_cast<std::size_t>(width_));
        file_->setFrameBuffer(frame_of(channels_, values.data(), width_, done_));
        file_->writePixels(rows);
        done_ += rows;
    }
    void finish() override {
        file_.reset();  // writes the table of lines
        stream_.rethrow();
    }

  private:
    const std::string_view channels_;
    const std::int32_t width_;
    std::int32_t done_ = 0;
    Stream stream_;
    std::optional<Imf::OutputFile> file_;
};

class ExrPartsEncoder : public PartsEncoder {
  public:
    ExrPartsEncoder(std::int32_t width, std::int32_t height, std::span<const Layer> layers, ByteFile& file,
                    bool alpha)
        : width_(width), stream_(file), channels_{alpha ? "RGBA" : "RGB"} {
        std::vector<Imf::Header> headers;
        const auto add = [&](std::string_view name, std::string_view channels) {
            headers.push_back(header_of(channels, width, height));
            headers.back().setName(std::string(name));
            headers.back().setType(Imf::SCANLINEIMAGE);
        };
        add("beauty", channels_.front());
        for (const Layer layer : layers) {
            channels_.push_back(layer_channels(layer));
            add(layer_name(layer), channels_.back());
        }
        file_.emplace(stream_, headers.data(), static_cast<int>(headers.size()), false, 0);
    }

    void append(std::size_t part, std::int32_t first_row, std::int32_t rows, const float* values) override {
        Imf::OutputPart output(*file_, static_cast<int>(part));
        output.setFrameBuffer(frame_of(channels_[part], values, width_, first_row));
        output.writePixels(rows);
    }
    void finish() override {
        file_.reset();
        stream_.rethrow();
    }

  private:
    const std::int32_t width_;
    Stream stream_;
    std::vector<std::string_view> channels_;
    std::optional<Imf::MultiPartOutputFile> file_;
};

}  // namespace

std::unique_ptr<StripEncoder> make_exr_encoder(std::int32_t width, std::int32_t height, ByteFile& file,
                                               bool alpha) {
    return std::make_unique<ExrEncoder>(width, height, file, alpha);
}

std::unique_ptr<PartsEncoder> make_parts_encoder(std::int32_t width, std::int32_t height,
                                                 std::span<const Layer> layers, ByteFile& file, bool alpha) {
    return std::make_unique<ExrPartsEncoder>(width, height, layers, file, alpha);
}

std::vector<std::uint8_t> encode_exr(const Image& image, std::span<const float> alpha) {
    std::vector<std::uint8_t> bytes;
    MemoryFile file(bytes);
    ExrEncoder encoder(image.width, image.height, file, !alpha.empty());
    if (alpha.empty()) {
        encoder.append_rows(image.rgb);
    } else {
        encoder.append_rows(with_alpha(image.rgb, alpha));
    }
    encoder.finish();
    return bytes;
}

std::vector<std::uint8_t> encode_exr_layers(const Image& picture, std::span<const LayerImage> layers,
                                            std::span<const float> alpha) {
    std::vector<std::uint8_t> bytes;
    MemoryFile file(bytes);
    std::vector<Layer> kinds;
    for (const LayerImage& layer : layers) kinds.push_back(layer.layer);
    ExrPartsEncoder encoder(picture.width, picture.height, kinds, file, !alpha.empty());
    if (alpha.empty()) {
        encoder.append(0, 0, picture.height, picture.rgb.data());
    } else {
        encoder.append(0, 0, picture.height, with_alpha(picture.rgb, alpha).data());
    }
    for (std::size_t i = 0; i < layers.size(); ++i)
        encoder.append(i + 1, 0, picture.height, layers[i].values.data());
    encoder.finish();
    return bytes;
}

}  // namespace glint
