// OpenEXR: linear float RGB, written to memory. One thread: the library would need its global pool for more.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

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

}  // namespace

EncodeResult encode_exr(const Image& image) {
    EncodeResult result;
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    constexpr const char* names[] = {"R", "G", "B"};
    Imf::FrameBuffer channels;
    for (int c = 0; c < 3; ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        // The library only reads from the slices of an output file, but wants them writable.
        auto* first = reinterpret_cast<char*>(const_cast<float*>(image.rgb.data() + c));
        channels.insert(names[c],
                        Imf::Slice(Imf::FLOAT, first, 3 * sizeof(float), 3 * sizeof(float) * image.width));
    }
    {
        MemoryStream stream(result.bytes);
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(channels);
        file.writePixels(image.height);
    }  // the file's end writes its table of lines
    return result;
}

}  // namespace glint
