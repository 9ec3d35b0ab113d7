// SPDX-License-Identifier: Apache-2.0
// Files that make a library allocate much: decode() keeps to its limit, and returns an error when memory runs
// out.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <fstream>

#include "image/foreign_files.h"
#include "image/memory_output.h"
#include "image/pictures.h"

namespace glint::test {
namespace {

Bytes with_length(std::uint32_t length) {
    return {static_cast<std::uint8_t>(length >> 24), static_cast<std::uint8_t>(length >> 16),
            static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length)};
}

void append(Bytes& to, const Bytes& more) { to.insert(to.end(), more.begin(), more.end()); }

// A PNG chunk with a compressed text of this length.
Bytes compressed_text(std::size_t length) {
    const Bytes text(length, 'a');
    uLongf size = compressBound(text.size());
    Bytes packed(size);
    compress2(packed.data(), &size, text.data(), text.size(), 1);
    packed.resize(size);
    Bytes data = {'z', 'T', 'X', 't', 'k', 0, 0};
    append(data, packed);
    Bytes chunk = with_length(static_cast<std::uint32_t>(data.size() - 4));
    append(chunk, data);
    append(chunk,
           with_length(static_cast<std::uint32_t>(crc32(0, data.data(), static_cast<uInt>(data.size())))));
    return chunk;
}

long peak_megabytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

Status decode_within(const Bytes& file, std::uint64_t max_memory) {
    DecodeOptions options;
    options.max_memory = max_memory;
    return decode(file, options);
}

TEST(HostilePictures, TextsOfPngAreNotInflated) {
    constexpr std::size_t header = 8 + 25;  // the signature and the chunk IHDR
    const Bytes file = encode(make_picture(4, 4)).value(), text = compressed_text(8'000'000);
    Bytes bomb(file.begin(), file.begin() + header);
    for (int i = 0; i < 40; ++i) append(bomb, text);
    bomb.insert(bomb.end(), file.begin() + header, file.end());
    const long before = peak_megabytes();
    EXPECT_TRUE(decode(bomb));
    EXPECT_LT(peak_megabytes() - before, 64);
}

TEST(HostilePictures, PassesOfPngAndJpegCount) {
    const Bytes row(300), samples(90'000);
    const auto png = [&](bool interlaced) {
        return make_png(100, std::vector<Bytes>(300, row), {PNG_COLOR_TYPE_RGB, 8, interlaced});
    };
    const auto jpeg = [&](bool progressive) { return make_jpeg(100, 300, 3, samples, progressive); };
    constexpr std::uint64_t limit = 12 * 100 * 300 + 60'000;
    for (const Bytes& file : {png(false), jpeg(false)}) EXPECT_EQ(decode_within(file, limit).message, "");
    for (const Bytes& file : {png(true), jpeg(true)}) {
        EXPECT_EQ(decode_within(file, limit).code, ErrorCode::out_of_memory);
        EXPECT_EQ(decode_within(file, 2 * limit).message, "");
    }
}

Bytes tiled_exr(unsigned tile_side, int channels) {
    MemoryOutput out;
    Imf::Header header(4, 4);
    header.setTileDescription(Imf::TileDescription(32, 32, Imf::ONE_LEVEL));
    Imf::FrameBuffer buffer;
    const std::vector<float> values(16);
    std::vector<std::string> names = {"R", "G", "B"};
    for (int i = 3; i < channels; ++i) names.push_back("more" + std::to_string(i));
    for (const std::string& name : names) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        buffer.insert(name,
                      Imf::Slice(Imf::FLOAT, const_cast<char*>(reinterpret_cast<const char*>(values.data())),
                                 sizeof(float), 4 * sizeof(float)));
    }
    {
        Imf::TiledOutputFile file(out, header, 0);
        file.setFrameBuffer(buffer);
        file.writeTile(0, 0);
    }
    const std::string type = "tiledesc";
    const auto at = std::search(out.bytes.begin(), out.bytes.end(), type.begin(), type.end()) + 9 + 4;
    for (int i = 0; i < 8; ++i) at[i] = static_cast<std::uint8_t>(tile_side >> 8 * (i % 4));
    return out.bytes;
}

TEST(HostilePictures, TilesOfOpenExrCount) {
    EXPECT_EQ(decode_within(tiled_exr(32, 3), 0).message, "");
    const Status huge = decode_within(tiled_exr(20'000, 3), 0);
    EXPECT_EQ(huge.code, ErrorCode::out_of_memory);
    EXPECT_NE(huge.message.find("max_memory"), std::string::npos) << huge.message;
    const Bytes many = tiled_exr(32, 500);
    EXPECT_EQ(decode_within(many, 0).message, "");
    EXPECT_EQ(decode_within(many, 4'000'000).code, ErrorCode::out_of_memory);
}

// Sanitizers need more memory than there is then.
#if defined(__linux__) && !defined(GLINT_SANITIZED)

// Whether decoding in a process with so many more bytes ends with a picture, or with an error.
bool ends_well(const Bytes& file, std::size_t more) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlim_t limit = pages * 4096 + more;
        const rlimit limits{limit, limit};
        ::setrlimit(RLIMIT_AS, &limits);
        const Result<DecodedImage> result = decode(file);
        ::_exit(result.has_value() || result.code != ErrorCode::none ? 0 : 1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(HostilePictures, AnErrorWhenMemoryRunsOut) {
    const Image image = make_picture(500, 400);
    const Bytes samples(600'000);
    const std::vector<Bytes> rows(400, Bytes(1500));
    for (const Bytes& file :
         {encode(image).value(), encode(image, {FileFormat::png, 16}).value(),
          encode(image, {FileFormat::exr}).value(), encode(image, {FileFormat::ppm}).value(),
          make_png(500, rows, {PNG_COLOR_TYPE_RGB, 8, true}), make_jpeg(500, 400, 3, samples, false),
          make_jpeg(500, 400, 3, samples, true)}) {
        for (std::size_t more = 0; more < 6'000'000; more += 1'000'000)
            EXPECT_TRUE(ends_well(file, more)) << more;
    }
}

#endif

}  // namespace
}  // namespace glint::test
