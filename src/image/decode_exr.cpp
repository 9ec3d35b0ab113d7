// SPDX-License-Identifier: Apache-2.0
// OpenEXR from memory: the channels R, G and B, or only Y, as floats, inside the display window.
#include <ImfChannelList.h>
#include <ImfCompositeDeepScanLine.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "base/one_at_a_time.h"
#include "image/decoders.h"
#include "image/exr_header.h"
#include "image/levels.h"

namespace glint {
namespace {

constexpr std::int64_t k_rows_read = 256;  // read at a time: as many as are compressed together, at most

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
            throw Undecodable("the OpenEXR file has color at fewer pixels than light (subsampling)");
    }
    return names;
}

DecodedPicture read_exr(ByteSpan bytes, const DecoderOptions& options, const ExrMemory& memory) {
    MemoryStream stream(bytes);
    Imf::InputFile file(stream, 0);
    const ChannelWindow data = window_of(file.header().dataWindow()),
                        shown = window_of(file.header().displayWindow());
    check_size(data.width, data.height, options);
    check_size(shown.width, shown.height, options);
    const auto names = channels_of(file.header().channels());

    const std::int64_t strip = std::min(k_rows_read, data.height);
    const auto row_size = 3 * static_cast<std::size_t>(data.width),
               shown_size = 3 * static_cast<std::size_t>(shown.width);
    DecodedPicture result{
        make_picture(static_cast<std::size_t>(shown.width), static_cast<std::size_t>(shown.height), 0,
                     memory.bytes + sizeof(float) * (static_cast<std::size_t>(strip) * row_size + shown_size),
                     options),
        32,
        {}};
    std::vector<float> read(static_cast<std::size_t>(strip) * row_size), row(shown_size);
    const bool is_grey = names[0] == names[1];
    bool all_finite = true;
    const std::int64_t first = std::max(data.x, shown.x),
                       last = std::min(data.x + data.width, shown.x + shown.width),
                       end = data.y + data.height;
    for (std::int64_t top = data.y; top < end; top += strip) {
        const std::int64_t bottom = std::min(top + strip, end);
        const Imath::Box2i window(Imath::V2i(file.header().dataWindow().min.x, static_cast<int>(top)),
                                  Imath::V2i(file.header().dataWindow().max.x, static_cast<int>(bottom - 1)));
        Imf::FrameBuffer buffer;
        for (std::size_t c = 0; c < (is_grey ? 1u : 3u); ++c) {
            buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, read.data() + c, window, 3 * sizeof(float),
                                                     sizeof(float) * row_size));
        }
        file.setFrameBuffer(buffer);
        file.readPixels(window.min.y, window.max.y);
        for (std::int64_t y = std::max(top, shown.y); y < std::min(bottom, shown.y + shown.height); ++y) {
            std::fill(row.begin(), row.end(), 0.0f);
            for (std::int64_t x = first; x < last; ++x) {
                const float* from = &read[static_cast<std::size_t>(y - top) * row_size +
                                          3 * static_cast<std::size_t>(x - data.x)];
                float* to = &row[3 * static_cast<std::size_t>(x - shown.x)];
                for (int c = 0; c < 3; ++c) {
                    const float value = from[is_grey ? 0 : c];
                    to[c] = value;
                    all_finite = all_finite && is_finite(value);
                }
            }
            result.picture.put_row(static_cast<std::int32_t>(y - shown.y), row.data());
        }
    }
    if (!all_finite) result.note = "some of its numbers are infinite or NaN";
    return result;
}

// Sets OpenEXR's limit of samples, which is one for the whole process.
class DeepLimit {
  public:
    explicit DeepLimit(std::uint64_t samples) {
        set(static_cast<std::int64_t>(std::max<std::uint64_t>(samples, 1)));
    }
    ~DeepLimit() { set(before_); }
    DeepLimit(const DeepLimit&) = delete;
    DeepLimit& operator=(const DeepLimit&) = delete;

  private:
    static void set(std::int64_t samples) { Imf::CompositeDeepScanLine::setMaximumSampleCount(samples); }
    const std::int64_t before_ = Imf::CompositeDeepScanLine::getMaximumSampleCount();
};

}  // namespace

DecodedPicture decode_exr(ByteSpan bytes, const DecoderOptions& options) {
    const ExrMemory memory = check_exr_header(bytes, options);
    check_memory(memory.bytes, memory.pixels, options);
    if (memory.sample_bytes == 0) return read_exr(bytes, options, memory);
    static OneAtATime deep_files;
    DecodedPicture picture;
    deep_files.run([&] {
        const DeepLimit limit((memory_limit(memory.pixels, options) - memory.bytes) / memory.sample_bytes);
        picture = read_exr(bytes, options, memory);
    });
    return picture;
}

}  // namespace glint
