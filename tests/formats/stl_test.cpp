// SPDX-License-Identifier: Apache-2.0
// .stl: text and binary, merged vertices, colors and mistakes.
#include <cstring>
#include <limits>

#include "formats/mistakes.h"

namespace glint::test {
namespace {

// A square of two triangles.
constexpr std::string_view k_square_text =
    "solid a square\n"
    "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1 0 0\n      vertex 1 1 0.5\n"
    "    endloop\n  endfacet\n"
    "  facet normal nan nan nan\n    outer loop\n      vertex -0 0 0\n      vertex 1 1 0.5\n"
    "      vertex 0 1 0\n    endloop\n  endfacet\n"
    "endsolid a square\n";

struct StlFacet {
    float corners[3][3];
    std::uint16_t attribute = 0;
};
constexpr StlFacet k_facets[] = {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5F}}},
                                 {{{-0.F, 0, 0}, {1, 1, 0.5F}, {0, 1, 0}}}};

template <class T> void append(std::string& to, const T& value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}
std::string binary(std::string header, std::vector<StlFacet> facets) {
    header.resize(80);
    append(header, static_cast<std::uint32_t>(facets.size()));
    for (const StlFacet& f : facets) {
        header.append(12, '\x7f');  // the normal: not used
        append(header, f.corners);
        append(header, f.attribute);
    }
    return header;
}
std::string binary_square(std::string header, std::uint16_t first = 0, std::uint16_t second = 0) {
    std::vector<StlFacet> facets(std::begin(k_facets), std::end(k_facets));
    facets[0].attribute = first;
    facets[1].attribute = second;
    return binary(std::move(header), facets);
}

const MeshData& only_mesh(const Scene& scene) {
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.shapes.size(), 1u);
    return *scene.meshes.at(0);
}

void expect_square(const MeshData& mesh) {
    EXPECT_EQ(mesh.single_positions, (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5F}, {0, 1, 0}}));
    EXPECT_TRUE(mesh.positions.empty());
    EXPECT_EQ(mesh.triangles, (std::vector<TriangleCorners>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(mesh.normals.empty());
}

TEST(Stl, TextsAndBinaryFilesAreTheSame) {
    const Scene text = quiet_scene(k_square_text, "a.stl");
    expect_square(only_mesh(text));
    EXPECT_EQ(text.lights.size(), 3u);
    EXPECT_EQ(text.camera.look_at, (Vec3{0.5, 0.5, 0.25}));
    const Scene numbers = quiet_scene(binary_square("made by hand"), "A.STL");
    expect_square(only_mesh(numbers));
    EXPECT_TRUE(only_mesh(numbers).colors.empty());
    expect_square(only_mesh(quiet_scene(binary_square("solid by its first word"), "a.stl")));
    std::string loud(k_square_text);
    std::transform(loud.begin(), loud.end(), loud.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    expect_square(only_mesh(quiet_scene(loud, "a.stl")));
}

TEST(Stl, ATextMayHaveSeveralSolidsAndAnyLines) {
    const std::string facet =
        "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet";
    const std::string text =
        "\r\nsolid\r\n" + facet + " endsolid\r\nsolid facet\n" + facet + "\rendsolid facet";
    const Scene scene = quiet_scene(text, "a.stl");
    EXPECT_EQ(only_mesh(scene).triangles, (std::vector<TriangleCorners>{{0, 1, 2}, {0, 1, 2}}));
}

TEST(Stl, PositionsOfTextsHaveThePrecisionOfTheirNumbers) {
    const auto positions = [](const std::string& x) {
        std::string text(k_square_text);
        text.replace(text.find("vertex 1 0 0"), 12, "vertex " + x + " 0 0");
        const Scene scene = quiet_scene(text, "a.stl");
        return only_mesh(scene);
    };
    EXPECT_EQ(positions("0.1").single_positions.at(1).x, 0.1F);
    EXPECT_EQ(positions("1.000000e-01").single_positions.at(1).x, 0.1F);
    EXPECT_EQ(positions("0.12345678901").positions.at(1).x, 0.12345678901);
    EXPECT_TRUE(positions("0.12345678901").single_positions.empty());
}

// 5 bits for each channel, by two conventions.
constexpr std::uint16_t bits(unsigned high, unsigned middle, unsigned low) {
    return static_cast<std::uint16_t>(high << 10 | middle << 5 | low);
}
constexpr std::uint16_t k_bit_15 = 0x8000;

TEST(Stl, TrianglesHaveColors) {
    const auto color = [](const MeshData& mesh, std::size_t triangle) {
        const auto found = mesh.corner_values(mesh.colors, triangle);
        return found ? std::optional(found->at(2)) : std::nullopt;
    };
    const Float3 mixed{31 / 31.F, 10 / 31.F, 5 / 31.F};
    const Scene one = quiet_scene(binary_square("", k_bit_15 | bits(31, 10, 5), bits(31, 10, 5)), "a.stl");
    EXPECT_EQ(color(only_mesh(one), 0), mixed) << "red is high";
    EXPECT_EQ(color(only_mesh(one), 1), std::nullopt) << "bit 15 is not set";
    const Scene both =
        quiet_scene(binary_square("", k_bit_15 | bits(1, 1, 1), k_bit_15 | bits(1, 1, 1)), "a.stl");
    EXPECT_EQ(only_mesh(both).colors.values.size(), 1u);

    const std::string magics = "COLOR=\xff\x33\x01\xff,MATERIAL=";
    const Scene own =
        quiet_scene(binary_square(magics, bits(5, 10, 31), k_bit_15 | bits(5, 10, 31)), "a.stl");
    EXPECT_EQ(color(only_mesh(own), 0), mixed) << "red is low";
    EXPECT_EQ(color(only_mesh(own), 1), (Float3{1, 0.2F, 1 / 255.F})) << "the header's";
    const Scene cut = quiet_scene(binary_square(std::string(72, ' ') + "COLOR=\xff"), "a.stl");
    EXPECT_TRUE(only_mesh(cut).colors.empty()) << "the color has no room in the header";
}

TEST(Stl, EveryShortenedFileIsAnError) {
    const std::string text(k_square_text.substr(0, k_square_text.rfind("endsolid")));
    for (const std::string& whole : {text, binary_square("")}) {
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const std::string part = whole.substr(0, length);
            const Result<Scene> result = load_text(part, "a.stl");
            ASSERT_FALSE(result) << length;
            ASSERT_EQ(what_is_wrong(result, part), "") << length;
        }
    }
}

TEST(Stl, MistakesAreReportedAtTheirPlace) {
    const auto expect_error = [](const std::string& text, const std::string& message) {
        const Result<Scene> result = load_text(text, "a.stl");
        EXPECT_FALSE(result);
        EXPECT_NE(messages(result).find(message), std::string::npos) << messages(result);
    };
    const auto changed = [](std::string_view from, std::string_view to) {
        std::string text(k_square_text);
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    expect_error("", "a.stl:1:1: error: expected `solid`");
    expect_error("solid\nendsolid\n", "no facets");
    expect_error(changed("facet", "face"), "a.stl:2:3: error: expected `facet` or `endsolid`, found 'face'");
    expect_error(changed("outer", "inner"), "a.stl:3:5: error: expected `outer`, found 'inner'");
    expect_error(changed("vertex 1 0 0", "vertex 1 O 0"),
                 "a.stl:5:16: error: expected a number from -1e12 to 1e12, found 'O'");
    expect_error(changed("vertex 1 0 0", "vertex 1 inf 0"), "a.stl:5:16: error: expected a number");
    expect_error(changed("vertex 1 0 0", "vertex 1 - 0"), "a.stl:5:16: error: expected a number");
    expect_error(changed("    endloop", "    vertex 2 2 2 endloop"), "a.stl:7:5: error: expected `endloop`");
    expect_error(std::string(k_square_text) + "rest", "a.stl:17:1: error: expected `solid`, found 'rest'");

    std::string many = binary_square("");
    many[83] = '\x7f';
    expect_error(many,
                 "a.stl:1:1: error: byte 80: expected 2130706434 triangles, found a file with room for 2");
    expect_error(binary("", {}), "no triangles");
    std::vector<StlFacet> facets(std::begin(k_facets), std::end(k_facets));
    facets[1].corners[1][2] = std::numeric_limits<float>::quiet_NaN();
    expect_error(binary("", facets), "byte 166, triangle 1: expected a number from -1e12 to 1e12, found nan");
    facets[1].corners[1][2] = 1e13F;
    expect_error(binary("", facets), "found 1");
}

TEST(Stl, BytesAfterTheTrianglesAreIgnored) {
    const Result<Scene> result = load_text(binary_square("") + "12345", "a.stl");
    ASSERT_TRUE(result);
    EXPECT_NE(messages(result).find("5 bytes after the last triangle"), std::string::npos);
    expect_square(only_mesh(*result));
}

TEST(Stl, MemoryIsAskedForBeforeItIsAllocated) {
    const std::vector<StlFacet> facets(300'000, k_facets[0]);
    LoadOptions options;
    options.max_memory = 24u << 20;
    const Result<Scene> result = load_text(binary("", facets), "a.stl", options);
    EXPECT_FALSE(result);
    EXPECT_EQ(result.code, ErrorCode::out_of_memory) << messages(result);
    EXPECT_TRUE(load_text(binary("", facets), "a.stl"));
}

}  // namespace
}  // namespace glint::test
