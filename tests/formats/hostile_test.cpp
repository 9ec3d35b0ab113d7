// SPDX-License-Identifier: Apache-2.0
// Hostile texts: load() returns soon, and its memory is bounded by a multiple of their length.
#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <filesystem>
#include <random>

#include "formats/load_text.h"

namespace glint::test {
namespace {

const char* const k_gallery[] = {
    "cgfs/three_spheres.cgfs", "cgfs/from_the_side.cgfs", "epfl/three_lights.json", "epfl/two_scenes.js",
    "csc473/glass_ball.pov",   "nff/fullerene.nff",       "glint/still_life.glint"};

std::string gallery(const std::string& name) { return read_whole_file(GLINT_SOURCE_DIR "/scenes/" + name); }

void expect_an_answer(std::string_view text, const std::string& name) {
    const Result<Scene> result = load_text(text, name);
    EXPECT_EQ(what_is_wrong(result, text), "") << name;
}

TEST(Gallery, LoadsWithoutErrors) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        if (!entry.is_regular_file()) continue;
        const std::string path = entry.path().string();
        if (path.find("/parts/") != std::string::npos) continue;  // of scenes that include them
        const std::string text = read_whole_file(path);
        FolderSources sources;
        const Result<Scene> result = load_text(text, path, {}, &sources);
        for (const Diagnostic& d : result.diagnostics) EXPECT_NE(d.severity, Severity::error) << to_string(d);
        EXPECT_EQ(what_is_wrong(result, text), "");
        ++files;
    }
    EXPECT_GE(files, 14u);
}

TEST(Hostile, TruncatedTexts) {
    for (const char* name : k_gallery) {
        const std::string text = gallery(name);
        ASSERT_FALSE(text.empty()) << name;
        for (std::size_t n = 0; n < text.size(); ++n)
            expect_an_answer(std::string_view(text).substr(0, n), name);
    }
}

TEST(Hostile, RandomEdits) {
    std::mt19937 random(20241);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const std::string_view pieces[] = {"{",    "}", "(",    ")",        "[",  "]",  "=",       ":",   ",",
                                       "\"",   "'", "/*",   "#",        "\n", "-",  "1e999",   "NaN", "0",
                                       "none", "x", "\xff", "\xc3\xa9", ".",  "\\", "rotation"};
    std::vector<std::string> texts;
    for (const char* name : k_gallery) texts.push_back(gallery(name));
    std::size_t broken = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::size_t which = below(texts.size());
        std::string text = texts[which];
        for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
            const std::size_t at = below(text.size());
            switch (below(4)) {
                case 0:
                    text[at] = static_cast<char>(random() & 0xff);
                    break;
                case 1:
                    text.erase(at, 1 + below(20));
                    break;
                case 2:
                    text.insert(at, pieces[below(std::size(pieces))]);
                    break;
                default:
                    text.insert(at, text.substr(below(text.size()), below(60)));
            }
            if (text.empty()) text = " ";
        }
        const Result<Scene> result = load_text(text, k_gallery[which]);
        ASSERT_EQ(what_is_wrong(result, text), "") << "iteration " << i << " of " << k_gallery[which];
        broken += !result;
    }
    EXPECT_GT(broken, 5000u) << "the edits break something";
    EXPECT_LT(broken, 19900u) << "and not everything";
}

TEST(Hostile, AMillionBracketsAreAnError) {
    for (const char* name : {"a.cgfs", "a.json", "a.pov", "a.nff", "a.dat", "a.glint"}) {
        for (const char* before : {"", "x = ", "sphere { center = ", "sphere { x = ", "{ \"camera\": ",
                                   "{ x: ", "[", "const a = ", "group ", "group { sphere "}) {
            for (const char bracket : {'{', '[', '('}) {
                const std::string text = before + std::string(1000000, bracket);
                const Result<Scene> result = load_text(text, name);
                EXPECT_FALSE(result);
                EXPECT_EQ(what_is_wrong(result, text), "");
            }
        }
    }
    const Result<Scene> result = load_text("foo = " + std::string(1000000, '('), "a.cgfs");
    EXPECT_NE(to_string(result.diagnostics.back()).find("nested more than 256 deep"), std::string::npos);
    std::string groups;
    while (groups.size() < 8000000) groups += "group { ";
    const Result<Scene> nested = load_text(groups, "a.glint");
    ASSERT_FALSE(nested.diagnostics.empty());
    EXPECT_EQ(nested.diagnostics.back().message, "blocks are nested more than 256 deep");
}

// Work that grows with the square of the length would take many minutes here.
TEST(Hostile, OneLongLineIsReadInLinearTime) {
#if defined(GLINT_SANITIZED)
    constexpr std::size_t bytes = 400000;  // all takes five times as long
#else
    constexpr std::size_t bytes = 2000000;
#endif
    const std::tuple<const char*, const char*, const char*, std::size_t> cases[] = {
        {"a.cgfs", "", "sphere { center = (1, 2, 3) radius = 1 color = (9, 9, 9) } ", 5 * bytes},
        {"a.cgfs", "", "foo = 1 ", bytes},
        {"a.cgfs", "", "a", bytes},
        {"a.cgfs", "sphere { radius = ", "9", bytes},
        {"a.cgfs", "x = ", "( ", bytes},
        {"a.cgfs", "sphere { radius = ( ", "x ", bytes},
        {"a.glint", "camera { } ", "disc { radius = 1 center = (1, 2, 3) normal = (0, 1, 0) ior = 2 } ",
         5 * bytes},
        {"a.glint", "", "sphere { center = (1, 2, 3) radius = 1 color = (2, 2, 2) scale = 2 } ", 5 * bytes},
        {"a.glint", "", "sphere { center = (1, 2, 3) radius = 1 material = a color = (0, 1, 2) } ", bytes},
        {"a.glint", "", "group { scale = 2 ior = 3 box { min = (1, 2, 3) max = (4, 5, 6) } } ", bytes},
        {"a.glint", "polygon { vertices = (", "(1, 2, 3)", bytes},
        {"a.glint", "", "include \"a.glint\" ", bytes},
        {"a.glint", "", "material a { } ", bytes},
        {"a.glint", "material ", "a", bytes},
        {"a.json", "{\"spheres\":[", R"({"center":[1,2,3],"radius":1,"material":"x"},)", 5 * bytes},
        {"a.json", "[", "{\"name\":\"x\"},", bytes},
        {"a.json", "{\"spheres\":[", "{},", bytes},
        {"a.js", "/*", "/*", bytes},
        {"a.pov", "", "sphere { <1, 2, 3>, 1 translate <1, 1, 1> pigment { color rgb <1, 0, 0> } } ",
         5 * bytes},
        {"a.pov", "", "union ", bytes},
        {"a.pov", "", "a { ", bytes},
        {"a.pov", "sphere { <0,0,0>, 1 ", "scale 1 ", bytes},
        {"a.nff", "", "s 1 2 3 1 ", 5 * bytes},
        {"a.nff", "", "f 1 1 1 1 1 1 0 1 s 1 2 3 1 ", 5 * bytes},
        {"a.nff", "", "v from 1 1 1 ", bytes},
        {"a.nff", "v ", "x ", bytes},
        {"a.nff", "", "l 1 2 3 ", bytes},
        {"a.dat", "Begin_Scene Resolution 9 9 ", "Sphere Center 0 0 0 Rad 1 t ", bytes},
        {"a.dat", "Begin_Scene Resolution 9 9 ", "x ", bytes},
        {"a.dat", "Begin_Scene Resolution 9 9 ", "# ", bytes},
        {"a.dat", "Begin_Scene Resolution 9 9 VertexArray Numverts 4e9 Coords ", "1 ", bytes},
        {"a.dat", "Begin_Scene Resolution 9 9 ",
         "TexDef t Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 1 1 TexFunc 0 ", bytes},
        {"a.dat",
         "Begin_Scene Resolution 9 9 ImageDef a Format RGB24 Resolution 65536 65536 65536 Encoding Hex ",
         "123 ", bytes},
        {"a.js", "[{ name: '", "\\u00e9", bytes}};
    for (const auto& [name, begin, piece, length] : cases) {
        std::string text = begin;
        while (text.size() < length) text += piece;
        const auto start = std::chrono::steady_clock::now();
        const Result<Scene> result = load_text(text, name);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_EQ(what_is_wrong(result, text), "") << name << ": " << piece;
        EXPECT_LT(seconds.count(), 30) << name << ": " << piece;
    }
}

// Pairs of numbers from 0 to 1 that a hash which multiplies and shifts, without a secret, takes to one
// number.
std::vector<std::pair<double, double>> colliding_pairs(std::size_t count) {
    std::mt19937_64 random(7);
    std::vector<std::pair<double, double>> pairs;
    while (pairs.size() < count) {
        const double first = static_cast<double>(random() >> 11) * 0x1p-53;
        std::uint64_t hash = std::bit_cast<std::uint64_t>(first) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
        const auto second = std::bit_cast<double>(hash);
        if (second >= 1e-300 && second <= 1) pairs.emplace_back(first, second);
    }
    return pairs;
}

TEST(Hostile, NumbersOfMaterialsThatCollideAreReadSoon) {
#if defined(GLINT_SANITIZED)
    constexpr std::size_t count = 20000;
#else
    constexpr std::size_t count = 80000;
#endif
    std::string povray, tachyon = "Begin_Scene Resolution 9 9 ";
    for (const auto& [a, b] : colliding_pairs(count)) {
        povray += fmt::format("sphere{{0,1 pigment{{rgb<{},{},0>}}}}\n", a, b);
        tachyon += fmt::format(
            "Sphere Center 0 0 0 Rad 1 Texture Ambient {} Diffuse {} Specular 0 Opacity 1 Color 1 1 1 "
            "TexFunc 0\n",
            a, b);
    }
    tachyon += "End_Scene";
    for (const auto& [name, text] : {std::pair{"a.pov", povray}, std::pair{"a.dat", tachyon}}) {
        const auto start = std::chrono::steady_clock::now();
        const Result<Scene> result = load_text(text, name);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        ASSERT_TRUE(result) << name << messages(result).substr(0, 500);
        EXPECT_GE(result->materials.size(), count) << name;
        EXPECT_LT(seconds.count(), 10) << name;
    }
}

TEST(Hostile, BinaryDataIsRejectedOnce) {
    using namespace std::string_view_literals;
    for (const char* name : {"a.cgfs", "a.json", "a.pov", "a.nff", "a.dat", "a.glint"}) {
        const std::pair<std::string_view, const char*> cases[] = {
            {"\0\0\0\0"sv, "expected text, found the byte 0x00"},
            {"\x7f"
             "ELF\1\2"sv,
             "expected text, found the byte 0x7f"},
            {"\xff\xfe"
             "s\0p\0"sv,
             "expected UTF-8, found UTF-16"},
            {"\xfe\xff\0s"sv, "expected UTF-8, found UTF-16"}};
        for (const auto& [text, message] : cases) {
            const Result<Scene> result = load_text(text, name);
            ASSERT_FALSE(result.diagnostics.empty());
            EXPECT_EQ(result.diagnostics[0].message, message);
            EXPECT_EQ(result.diagnostics[0].line, 1u);
            EXPECT_LE(result.diagnostics.size(), 2u);
        }
    }
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        std::string text(1000, '\0');
        for (char& c : text) c = static_cast<char>(random() & 0xff);
        expect_an_answer(text, "a.cgfs");
        expect_an_answer(text, "a.json");
        expect_an_answer(text, "a.glint");
    }
}

TEST(Hostile, EmptyTextsReportWhatIsExpected) {
    for (const char* name : {"a.cgfs", "a.json", "a.pov", "a.nff", "a.dat", "a.glint"}) {
        for (const char* text : {"", " ", "\n\n", "\xef\xbb\xbf", "// only a comment"}) {
            const Result<Scene> result = load_text(text, name);
            EXPECT_FALSE(result);
            ASSERT_GE(result.diagnostics.size(), 1u);
            EXPECT_EQ(result.diagnostics[0].message.substr(0, 9), "expected ");
            EXPECT_EQ(what_is_wrong(result, text), "");
        }
    }
}

TEST(Hostile, MessagesContainNoControlCharacters) {
    const Result<Scene> result = load_text(
        "sphere { radius = \xc2\x9b"
        "31mred }\n\"\x1b[2J\"",
        "a.cgfs");
    for (const Diagnostic& d : result.diagnostics) {
        const std::string message = to_string(d);
        EXPECT_EQ(message.find('\x1b'), std::string::npos);
        EXPECT_EQ(message.find("\xc2\x9b"), std::string::npos);
        EXPECT_TRUE(is_utf8(message));
    }
    EXPECT_FALSE(result.diagnostics.empty());
}

}  // namespace
}  // namespace glint::test
