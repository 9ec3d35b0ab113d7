// SPDX-License-Identifier: Apache-2.0
// The comparison with golden pictures must be able to fail.
#include "image/golden.h"

#include "image/pictures.h"

namespace glint::test {
namespace {

std::string temporary(const std::string& name) { return ::testing::TempDir() + "glint_golden_" + name; }

TEST(Golden, EqualPicturesPass) {
    const Picture picture = decode_png(encode(make_picture(20, 10)).value());
    EXPECT_TRUE(compare(picture, picture, {}, temporary("none.png")));
}

TEST(Golden, ASmallObjectThatIsMissingFails) {
    const Picture golden = decode_png(encode(make_picture(200, 100)).value());
    Picture found = golden;
    found.samples[3 * (50 * 200 + 7) + 1] ^= 0x80;
    const std::string path = temporary("one.png");
    const auto verdict = compare(golden, found, {.largest = 1, .differing = 100}, path);
    EXPECT_FALSE(verdict);
    EXPECT_NE(std::string(verdict.message()).find("x 7, y 50"), std::string::npos) << verdict.message();
    const Picture difference = read_png(path);
    EXPECT_EQ(difference.error, "");
    EXPECT_EQ(difference.samples[3 * (50 * 200 + 7) + 1], 255);
    EXPECT_EQ(std::count(difference.samples.begin(), difference.samples.end(), 0), 200 * 100 * 3 - 1);
    std::remove(path.c_str());
}

TEST(Golden, ManySmallDifferencesFail) {
    const Picture golden = decode_png(encode(make_picture(20, 10)).value());
    Picture found = golden;
    for (auto& sample : found.samples) sample ^= 1;
    EXPECT_TRUE(compare(golden, found, {.largest = 1, .differing = 200}, temporary("many.png")));
    EXPECT_FALSE(compare(golden, found, {.largest = 1, .differing = 199}, temporary("many.png")));
    std::remove(temporary("many.png").c_str());
}

TEST(Golden, AnotherSizeFails) {
    const Picture a = decode_png(encode(make_picture(20, 10)).value()),
                  b = decode_png(encode(make_picture(10, 20)).value());
    EXPECT_FALSE(compare(a, b, {.largest = 255, .differing = 1000}, temporary("none.png")));
}

TEST(Golden, ReadsAndComparesAFile) {
    const Image image = make_picture(20, 10);
    const std::string path = temporary("file.png");
    EXPECT_FALSE(matches_golden(image, path)) << "there is no such file yet";
    write_bytes(path, encode(image).value());
    EXPECT_TRUE(matches_golden(image, path));
    Image other = image;
    for (float& v : other.rgb) v = 1 - v;
    EXPECT_FALSE(matches_golden(other, path, {.largest = 3, .differing = 5}));
    for (const char* suffix : {".difference.png", ".found.png"})
        std::remove(("glint_golden_file" + std::string(suffix)).c_str());
    std::remove(path.c_str());
}

}  // namespace
}  // namespace glint::test
