// SPDX-License-Identifier: Apache-2.0
// OpenEXR: linear float RGB, written to memory. On one thread: more would need the library's global pool.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>

#include <algorithm>
#include <cstring>

#include "image/encoders.h"

namespace glint {
namespace {

class MemoryStream : public Imf::OStream {
  public:
    explicit MemoryStream(std::vector<std::uint8_t>& bytes) : Imf::OStream("memory"), bytes_(bytes) {}
    void write(const char data[], int count) override {
        const std::size_t end = position_ + static_cast<std::size_t>(count);
        if (end > bytes_.size()) bytes_.resize(end);
        std::memcpy(bytes_.data() + position_, data, static_cast<std::size_t>(count));
        position_ = end;
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }

  private:
    std::vector<std::uint8_t>& bytes_;
    std::size_t position_ = 0;
};

// One part of a file: interleaved channels in memory.
struct Part {
    std::string name;
    std::string_view channels;  // one letter each
    const float* values;
    std::int32_t width, height;
};

Imf::Header header_of(const Part& part) {
    Imf::Header header(part.width, part.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char channel : part.channels)
        header.channels().insert(std::string(1, channel), Imf::Channel(Imf::FLOAT));
    return header;
}

Imf::FrameBuffer frame_of(const Part& part) {
    Imf::FrameBuffer frame;
    const std::size_t pixel = part.channels.size() * sizeof(float);
    for (std::size_t c = 0; c < part.channels.size(); ++c) {
        // The library only reads from the slices of an output file, but requires pointers to non-const.
        auto* first = reinterpret_cast<char*>(const_cast<float*>(part.values + c));
        frame.insert(std::string(1, part.channels[c]),
                     Imf::Slice(Imf::FLOAT, first, pixel, pixel * static_cast<std::size_t>(part.width)));
    }
    return frame;
}

}  // namespace

std::vector<std::uint8_t> encode_exr(const Image& image) {
    std::vector<std::uint8_t> bytes;
    const Part part{"", "RGB", image.rgb.data(), image.width, image.height};
    {
        MemoryStream stream(bytes);
        Imf::OutputFile file(stream, header_of(part), 0);
        file.setFrameBuffer(frame_of(part));
        file.writePixels(part.height);
    }  // the file's end writes its table of lines
    return bytes;
}

std::vector<std::uint8_t> encode_exr_layers(const Image& picture, std::span<const LayerImage> layers) {
    std::vector<Part> parts{{"beauty", "RGB", picture.rgb.data(), picture.width, picture.height}};
    for (const LayerImage& layer : layers) {
        const LayerInfo& info = layer_infos()[static_cast<std::size_t>(layer.layer)];
        parts.push_back(
            {std::string(info.name), info.channels, layer.values.data(), layer.width, layer.height});
    }
    std::vector<Imf::Header> headers;
    for (const Part& part : parts) {
        headers.push_back(header_of(part));
        headers.back().setName(part.name);
        headers.back().setType(Imf::SCANLINEIMAGE);
    }
    std::vector<std::uint8_t> bytes;
    {
        MemoryStream stream(bytes);
        Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()), false, 0);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            Imf::OutputPart output(file, static_cast<int>(i));
            output.setFrameBuffer(frame_of(parts[i]));
            output.writePixels(parts[i].height);
        }
    }
    return bytes;
}

}  // namespace glint
