// SPDX-License-Identifier: Apache-2.0
// decode_texture(): the words of files of other programs, and files that are damaged. tests/image/textures
// was made by Pillow (palettes, grey, TGA), cjpeg of libjpeg-turbo, and a script (16 bits, interlaced, PPM as
// text).
#include "image/texture_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "image/texture_words.h"

namespace glint::test {
namespace {

using TextureFile = std::vector<std::uint8_t>;

const std::filesystem::path k_textures = GLINT_SOURCE_DIR "/tests/image/textures";

TextureFile read_file(const std::string& name) {
    std::ifstream file(k_textures / name, std::ios::binary);
    EXPECT_TRUE(file) << name;
    return TextureFile(std::istreambuf_iterator<char>(file), {});
}

// The lines of `words`: a file's name, a colon, and what words_of() says.
std::map<std::string, std::string> known_words() {
    std::map<std::string, std::string> known;
    std::ifstream file(k_textures / "words");
    for (std::string line; std::getline(file, line);)
        known[line.substr(0, line.find(':'))] = line.substr(line.find(':') + 2);
    return known;
}

TextureImage read_texture(const TextureFile& file) {
    Result<TextureImage> result = decode_texture(file);
    EXPECT_EQ(result.message, "");
    return result ? *result : TextureImage{};
}
TextureImage read_texture(const std::string& name) { return read_texture(read_file(name)); }

std::string error_of_texture(const TextureFile& file, const DecodeOptions& options = {}) {
    const Result<TextureImage> result = decode_texture(file, options);
    EXPECT_FALSE(result.has_value());
    EXPECT_NE(result.code, ErrorCode::none);
    return result.message;
}

template <class Word> std::vector<Word> words_as(const TextureImage& image) {
    return std::get<std::vector<Word>>(image.words);
}

TEST(TextureImage, WordsAreThoseThatAreKnown) {
    const auto known = known_words();
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(k_textures)) {
        const std::string name = entry.path().filename().string();
        if (name == "words") continue;
        ++files;
        const auto line = known.find(name);
        EXPECT_EQ(words_of(read_texture(name)), line == known.end() ? "" : line->second) << name;
    }
    EXPECT_EQ(files, known.size());
}

// Files with the same picture, of decoders that have nothing in common.
TEST(TextureImage, FormatsAgree) {
    for (const auto& [name, same] :
         std::vector<std::pair<std::string, std::string>>{{"type2.tga", "rgb.png"},
                                                          {"type10.tga", "rgb.png"},
                                                          {"p6.ppm", "rgb.png"},
                                                          {"type2_alpha.tga", "rgba.png"},
                                                          {"type10_alpha.tga", "rgba.png"},
                                                          {"interlaced.png", "rgba.png"},
                                                          {"type3.tga", "grey.png"},
                                                          {"type11.tga", "grey.png"},
                                                          {"p5.pgm", "grey.png"},
                                                          {"type3_alpha.tga", "grey_alpha.png"},
                                                          {"type1.tga", "palette.png"},
                                                          {"type9.tga", "palette.png"},
                                                          {"p6_16.ppm", "rgb16.png"}})
        EXPECT_TRUE(read_texture(name) == read_texture(same)) << name;
}

// The same inverse DCT as libjpeg's ISLOW with 12 bits of its factors instead of 13. Of 4:2:2, stb_image has
// another interpolation in the last column.
TEST(TextureImage, JpegIsNearThatOfLibjpeg) {
    const std::map<std::string, int> most = {{"jpeg_grey.jpg", 1},        {"jpeg_444.jpg", 2},
                                             {"jpeg_422.jpg", 18},        {"jpeg_420.jpg", 2},
                                             {"jpeg_progressive.jpg", 2}, {"jpeg_restart.jpg", 2}};
    for (const auto& [name, limit] : most) {
        const Result<DecodedImage> other = decode(read_file(name));
        if (!other && other.message.find("reads no JPEG") != std::string::npos) GTEST_SKIP();
        ASSERT_TRUE(other) << other.message;
        const auto words = words_as<std::uint8_t>(read_texture(name));
        ASSERT_EQ(words.size(), other->image.rgb.size());
        int difference = 0;
        for (std::size_t i = 0; i < words.size(); ++i)
            difference = std::max(
                difference, std::abs(words[i] - static_cast<int>(std::lround(255 * other->image.rgb[i]))));
        EXPECT_LE(difference, limit) << name;
    }
}

TEST(TextureImage, TextOfPpmIsScaledToTheNearestWord) {
    EXPECT_EQ(words_as<std::uint8_t>(read_texture("p2.pgm")),
              (std::vector<std::uint8_t>{0,   0,   0,   85,  85,  85,  170, 170, 170, 255, 255, 255,
                                         68,  68,  68,  153, 153, 153, 238, 238, 238, 51,  51,  51,
                                         136, 136, 136, 221, 221, 221, 34,  34,  34,  119, 119, 119}));
    const auto wide = words_as<std::uint16_t>(read_texture("p3.ppm"));
    EXPECT_EQ(wide[0], 0);
    EXPECT_EQ(wide[1], 6214);  // 65535 * 97 / 1023 = 6213.99
    EXPECT_EQ(wide[2], 12428);
}

TEST(TextureImage, TransparentColorsOfPng) {
    const TextureImage plain = read_texture("rgb.png"), keyed = read_texture("rgb_trns.png");
    EXPECT_FALSE(plain.has_alpha);
    ASSERT_TRUE(keyed.has_alpha);
    const auto rgb = words_as<std::uint8_t>(plain), rgba = words_as<std::uint8_t>(keyed);
    int holes = 0;
    for (std::size_t i = 0; i < rgb.size() / 3; ++i) {
        const bool is_hole = rgb[3 * i] == 250 && rgb[3 * i + 1] == 20 && rgb[3 * i + 2] == 30;
        EXPECT_EQ(rgba[4 * i + 3], is_hole ? 0 : 255);
        holes += is_hole ? 1 : 0;
    }
    EXPECT_GT(holes, 10);
    const auto wide = words_as<std::uint16_t>(read_texture("rgb16_trns.png"));
    for (std::size_t i = 0; i < wide.size() / 4; ++i) EXPECT_EQ(wide[4 * i + 3], i == 3 ? 0 : 65535);
}

TEST(TextureImage, GreyBecomesRgb) {
    for (const char* name : {"grey16.png", "one_bit.png", "jpeg_grey.jpg"}) {
        const TextureImage image = read_texture(name);
        EXPECT_FALSE(image.has_alpha) << name;
        std::visit(
            [name](const auto& words) {
                for (std::size_t i = 0; i < words.size(); i += 3)
                    EXPECT_TRUE(words[i] == words[i + 1] && words[i] == words[i + 2]) << name;
            },
            image.words);
    }
}

TEST(TextureImage, SixteenBitsAreKept) {
    for (const char* name : {"grey16.png", "rgb16.png", "rgba16.png", "p6_16.ppm"})
        EXPECT_TRUE(std::holds_alternative<std::vector<std::uint16_t>>(read_texture(name).words)) << name;
}

// A TGA of 2 x 2 pixels.
TextureFile small_tga(std::uint8_t type, std::uint8_t bits, std::uint8_t flags, const TextureFile& data) {
    TextureFile file = {0, 0, type, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, bits, flags};
    file.insert(file.end(), data.begin(), data.end());
    return file;
}

TEST(TextureImage, CornersOfTga) {
    const TextureFile data = {1, 2, 3, 4};
    const std::map<std::uint8_t, std::vector<std::uint8_t>> greys = {
        {0, {3, 4, 1, 2}}, {16, {4, 3, 2, 1}}, {32, {1, 2, 3, 4}}, {48, {2, 1, 4, 3}}};
    for (const auto& [flags, grey] : greys) {
        const auto words = words_as<std::uint8_t>(read_texture(small_tga(3, 8, flags, data)));
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(words[3 * i], grey[i]) << int{flags};
    }
}

TEST(TextureImage, ATgasEmptyAlphaIsNone) {
    const TextureFile empty = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 0};
    TextureFile used = empty;
    used[7] = 1;
    const TextureImage opaque = read_texture(small_tga(2, 32, 32 + 8, empty)),
                       alpha = read_texture(small_tga(2, 32, 32, used));
    EXPECT_FALSE(opaque.has_alpha);
    EXPECT_EQ(words_as<std::uint8_t>(opaque),
              (std::vector<std::uint8_t>{3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10}));
    ASSERT_TRUE(alpha.has_alpha);
    EXPECT_EQ(words_as<std::uint8_t>(alpha)[7], 1);
}

TEST(TextureImage, FiveBitsOfTga) {
    // Red, green, blue 31, and half of each.
    const TextureFile data = {0x00, 0x7c, 0xe0, 0x03, 0x1f, 0x80, 0xef, 0x3d};
    const TextureImage plain = read_texture(small_tga(2, 16, 32, data)),
                       alpha = read_texture(small_tga(2, 16, 33, data));
    EXPECT_FALSE(plain.has_alpha);
    EXPECT_EQ(words_as<std::uint8_t>(plain),
              (std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 255, 123, 123, 123}));
    ASSERT_TRUE(alpha.has_alpha);
    const auto words = words_as<std::uint8_t>(alpha);
    EXPECT_EQ((std::vector<int>{words[3], words[7], words[11], words[15]}), (std::vector<int>{0, 0, 255, 0}));
}

TEST(TextureImage, ErrorsSayWhatIsWrong) {
    EXPECT_EQ(error_of_texture({}), "an empty file");
    EXPECT_EQ(error_of_texture({'G', 'I', 'F', '8', '9', 'a'}), "no PNG, JPEG, TGA, PPM or PGM file");
    TextureFile png = read_file("rgb.png");
    png[45] ^= 1;
    EXPECT_EQ(error_of_texture(png), "PNG: the checksum of IDAT is wrong");
    TextureFile wide = small_tga(3, 8, 32, {1, 2, 3, 4});
    wide[13] = 0xff;
    EXPECT_EQ(error_of_texture(wide), "a picture of 65282 x 2 pixels; those read have 1 to 32768 a side");
    EXPECT_EQ(error_of_texture(small_tga(3, 8, 32, {1, 2, 3})), "the TGA file is cut off");
    TextureFile palette = read_file("type1.tga");
    palette[3] = 5;  // the first index
    EXPECT_NE(error_of_texture(palette).find("but the palette has the indices 5 to"), std::string::npos);
}

TEST(TextureImage, LimitsArePixelsAndMemory) {
    for (const char* name :
         {"rgb.png", "jpeg_420.jpg", "jpeg_progressive.jpg", "type10.tga", "p6.ppm", "interlaced.png"}) {
        const TextureFile file = read_file(name);
        DecodeOptions options;
        options.max_pixels = 23 * 17 - 1;
        EXPECT_EQ(error_of_texture(file, options),
                  "a picture of 23 x 17 pixels; those read have at most 390 in all");
        options.max_pixels = 23 * 17;
        options.max_memory = 1000;
        EXPECT_EQ(decode_texture(file, options).code, ErrorCode::out_of_memory) << name;
        options.max_memory = 1 << 17;
        EXPECT_EQ(decode_texture(file, options).message, "") << name;
    }
}

bool is_of_text(const std::string& name) { return name == "p2.pgm" || name == "p3.ppm"; }

TEST(TextureImage, FilesThatAreCutOff) {
    for (const auto& [name, words] : known_words()) {
        const TextureFile file = read_file(name);
        // Pillow ends a TGA with 26 bytes that are not of the picture.
        const std::size_t end = file.size() - (name.ends_with(".tga") ? 26 : 0);
        for (std::size_t length = 0; length < file.size(); ++length) {
            const Result<TextureImage> result = decode_texture(std::span(file).first(length));
            EXPECT_NE(result.has_value(), !result.message.empty());
            if (length < end && !is_of_text(name)) {
                EXPECT_FALSE(result.has_value()) << name << ", " << length << " bytes";
            }
        }
        TextureFile longer = file;
        longer.insert(longer.end(), 100, 0xff);
        EXPECT_EQ(words_of(read_texture(longer)), words) << name;
    }
}

TEST(TextureImage, FilesThatAreDamaged) {
    std::mt19937 random(1);
    DecodeOptions options;
    options.max_pixels = 1 << 16;
    for (const auto& [name, words] : known_words()) {
        const TextureFile file = read_file(name);
        for (int i = 0; i < 300; ++i) {
            TextureFile damaged = file;
            for (std::uint32_t bytes = 1 + random() % 4; bytes > 0; --bytes)
                damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
            const Result<TextureImage> result = decode_texture(damaged, options),
                                       again = decode_texture(damaged, options);
            EXPECT_NE(result.has_value(), !result.message.empty()) << name;
            ASSERT_EQ(result.has_value(), again.has_value()) << name;
            if (result) {
                EXPECT_TRUE(*result == *again) << name;
            }
        }
    }
}

}  // namespace
}  // namespace glint::test
