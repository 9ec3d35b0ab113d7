// SPDX-License-Identifier: Apache-2.0
// OpenEXR from memory: the channels R, G and B, or only Y, as floats, inside the display window.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "image/decoders.h"
#include "image/exr_header.h"
#include "image/levels.h"

namespace glint {
namespace {

class MemoryStream : public Imf::IStream {
  public:
    explicit MemoryStream(ByteSpan bytes) : Imf::IStream("memory"), bytes_(bytes) {}
    bool read(char out[], int count) override {
        const auto wanted = static_cast<std::size_t>(std::max(count, 0));
        if (at_ > bytes_.size() || wanted > bytes_.size() - at_)
            throw Undecodable("the OpenEXR file is cut off");
        std::memcpy(out, bytes_.data() + at_, wanted);
        at_ += wanted;
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override { at_ = position; }

  private:
    ByteSpan bytes_;
    std::size_t at_ = 0;
};

struct ChannelWindow {
    std::int64_t x = 0, y = 0, width = 0, height = 0;
};

ChannelWindow window_of(const Imath::Box2i& window) {
    return {window.min.x, window.min.y, std::int64_t{window.max.x} - window.min.x + 1,
            std::int64_t{window.max.y} - window.min.y + 1};
}

// The names of the three channels.
std::array<const char*, 3> channels_of(const Imf::ChannelList& list) {
    std::array<const char*, 3> names = {"R", "G", "B"};
    if (list.findChannel("R") == nullptr && list.findChannel("Y") != nullptr) names = {"Y", "Y", "Y"};
    for (const char* name : names) {
        const Imf::Channel* channel = list.findChannel(name);
        if (channel == nullptr) throw Undecodable("the OpenEXR file has no channels R, G, B, and no Y");
        if (channel->xSampling != 1 || channel->ySampling != 1)
            throw Undecodable("the OpenEXR file has colour at fewer pixels than light (subsampling)");
    }
    return names;
}

}  // namespace

DecodedImage decode_exr(ByteSpan bytes, const DecodeOptions& options) {
    check_exr_header(bytes, options);
    MemoryStream stream(bytes);
    Imf::InputFile file(stream, 0);
    const ChannelWindow data = window_of(file.header().dataWindow()),
                        shown = window_of(file.header().displayWindow());
    check_size(data.width, data.height, options);
    check_size(shown.width, shown.height, options);
    const auto names = channels_of(file.header().channels());

    std::vector<float> read(3 * static_cast<std::size_t>(data.width * data.height));
    Imf::FrameBuffer buffer;
    const bool is_grey = names[0] == names[1];
    for (std::size_t c = 0; c < (is_grey ? 1u : 3u); ++c) {
        buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, read.data() + c, file.header().dataWindow(),
                                                 3 * sizeof(float), 3 * sizeof(float) * data.width));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(file.header().dataWindow().min.y, file.header().dataWindow().max.y);

    Image image{static_cast<std::int32_t>(shown.width), static_cast<std::int32_t>(shown.height), {}};
    image.rgb.resize(3 * static_cast<std::size_t>(shown.width * shown.height));
    bool all_finite = true;
    const std::int64_t first = std::max(data.x, shown.x),
                       last = std::min(data.x + data.width, shown.x + shown.width);
    for (std::int64_t y = std::max(data.y, shown.y);
         y < std::min(data.y + data.height, shown.y + shown.height); ++y) {
        for (std::int64_t x = first; x < last; ++x) {
            const float* from = &read[3 * ((y - data.y) * data.width + x - data.x)];
            float* to = &image.rgb[3 * ((y - shown.y) * shown.width + x - shown.x)];
            for (int c = 0; c < 3; ++c) {
                const float value = from[is_grey ? 0 : c];
                to[c] = value;
                all_finite = all_finite && is_finite(value);
            }
        }
    }
    DecodedImage result;
    result.bits = 32;
    result.image = std::move(image);
    if (!all_finite) result.note = "some of its numbers are infinite or NaN";
    return result;
}

}  // namespace glint
