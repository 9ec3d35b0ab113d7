// SPDX-License-Identifier: Apache-2.0
// .ply: headers, the three codings, faces and mistakes.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "formats/mistakes.h"
#include "glint/write.h"
#include "math/transform.h"

namespace glint::test {
namespace {

constexpr std::string_view k_square =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n4 0 1 2 3\n";

Result<Scene> read(std::string_view text) { return load_text(text, "a.ply"); }

const MeshData& mesh_of(const Scene& scene) {
    EXPECT_EQ(scene.meshes.size(), 1u);
    return *scene.meshes.at(0);
}

TEST(Ply, AFileIsASceneWithCameraAndLights) {
    const Scene scene = quiet_scene(k_square, "a.ply");
    const MeshData& mesh = mesh_of(scene);
    EXPECT_EQ(mesh.single_positions, (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5F}, {0, 1, 0}}));
    EXPECT_TRUE(mesh.positions.empty()) << "in the precision of the file";
    using Triangle3 = std::array<std::uint32_t, 3>;
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle3>{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.shapes[0].kind, ShapeKind::mesh);
    EXPECT_EQ(scene.camera.look_at, (Vec3{0.5, 0.5, 0.25}));
    // The sphere around the vertices touches the upper and lower side of the picture.
    const double radius = length(Vec3{0.5, 0.5, 0.25});
    const double distance = length(scene.camera.position - scene.camera.look_at);
    EXPECT_NEAR(std::asin(radius / distance) * 2 * 180 / M_PI, scene.camera.fov_degrees, 1e-12);
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[1].kind, LightKind::directional);
}

// A binary file with every type of number, in one order of bytes.
template <class T> void put(std::string& to, T value, bool swapped) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (swapped) std::reverse(std::begin(bytes), std::end(bytes));
    to.append(bytes, sizeof value);
}
std::string binary_file(bool big) {
    std::string text = "ply\r\nformat binary_" + std::string(big ? "big" : "little") +
                       "_endian 1.0\r\nelement vertex 3\r\nproperty double x\r\nproperty uchar red\r\n"
                       "property float32 y\r\nproperty short z\r\nproperty list uint8 ushort tags\r\n"
                       "property float nx\r\nproperty float ny\r\nproperty float nz\r\nelement other 2\r\n"
                       "property int8 a\r\nproperty list int uint b\r\nelement face 2\r\n"
                       "property uint flags\r\nproperty list uint32 uint32 vertex_index\r\nend_header\r\n";
    for (int i = 0; i < 3; ++i) {
        put(text, 0.1 * i, big), put(text, std::uint8_t{200}, big),
            put(text, 0.5F * static_cast<float>(i * i), big);
        put(text, static_cast<std::int16_t>(-i), big), put(text, std::uint8_t{2}, big);
        put(text, std::uint16_t{7}, big), put(text, std::uint16_t{8}, big);
        for (const float n : {0.F, 0.F, i == 2 ? 0.F : 2.F}) put(text, n, big);
    }
    for (int i = 0; i < 2; ++i) {
        put(text, std::int8_t{-1}, big), put(text, std::int32_t{i}, big);
        if (i == 1) put(text, std::uint32_t{5}, big);
    }
    for (const std::uint32_t corners : {3U, 2U}) {
        put(text, std::uint32_t{9}, big), put(text, corners, big);
        for (std::uint32_t i = 0; i < corners; ++i) put(text, corners - 1 - i, big);
    }
    return text;
}

TEST(Ply, BinaryFilesHaveEitherOrderOfBytes) {
    for (const bool big : {false, true}) {
        const Result<Scene> result = read(binary_file(big));
        ASSERT_TRUE(result) << messages(result);
        const MeshData& mesh = mesh_of(*result);
        EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {0.1, 0.5, -1}, {0.2, 2, -2}}));
        EXPECT_EQ(mesh.normals.values, (std::vector<Float3>{{0, 0, 2}, {0, 0, 2}, {0, 0, 0}}));
        EXPECT_FALSE(mesh.corner_normals(0)) << "a corner has the normal 0";
        ASSERT_EQ(mesh.triangles.size(), 1u);
        EXPECT_TRUE(mesh.colors.empty()) << "red alone is no color";
        EXPECT_NE(messages(result).find("1 faces with fewer than three vertices"), std::string::npos);
    }
}

// The first byte of the data is that of a LF.
TEST(Ply, LinesOfAHeaderEndWithCr) {
    for (const bool is_binary : {false, true}) {
        std::string text =
            "ply\rformat " + std::string(is_binary ? "binary_big_endian" : "ascii") +
            " 1.0\relement vertex 3\rproperty int x\rproperty int y\rproperty int z\relement face 1\r"
            "property list uchar uchar vertex_indices\rend_header\r";
        if (is_binary) {
            for (const std::int32_t x : {0x0A000001, 0, 0, 0, 1, 0, 0, 0, 1}) put(text, x, true);
            text += std::string("\3\0\1\2", 4);
        } else {
            text += "167772161 0 0\r0 1 0\r0 0 1\r3 0 1 2\r";
        }
        const Result<Scene> result = read(text);
        ASSERT_TRUE(result) << messages(result);
        EXPECT_EQ(mesh_of(*result).positions, (std::vector<Vec3>{{0x0A000001, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    }
}

// The square's vertices with colors of a type.
std::string colored(const std::string& type, const std::string& prefix, const char* (&&colors)[4]) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\n";
    for (const char* const channel : {"red", "green", "blue"})
        text += "property " + type + " " + prefix + channel + "\n";
    text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const char* const corners[] = {"0 0 0 ", "1 0 0 ", "1 1 0 ", "0 1 0 "};
    for (std::size_t i = 0; i < 4; ++i) text += std::string(corners[i]) + colors[i] + "\n";
    return text + "4 0 1 2 3\n";
}

TEST(Ply, VerticesHaveColors) {
    const std::vector<Float3> expected{{0, 0, 1}, {0.2F, 0, 0}, {1, 1, 1}, {0, 0.6F, 0}};
    const Scene bytes =
        quiet_scene(colored("uchar", "", {"0 0 255", "51 0 0", "255 255 255", "0 153 0"}), "a.ply");
    EXPECT_EQ(mesh_of(bytes).colors.values, expected);
    EXPECT_TRUE(mesh_of(bytes).colors.corners.empty()) << "each vertex has one";
    const Scene words = quiet_scene(
        colored("ushort", "diffuse_", {"0 0 65535", "13107 0 0", "65535 65535 65535", "0 39321 0"}), "a.ply");
    EXPECT_EQ(mesh_of(words).colors.values, expected);
    const Scene floats = quiet_scene(colored("float", "", {"0 0 1", "0.2 0 0", "1 1 1", "0 0.6 0"}), "a.ply");
    EXPECT_EQ(mesh_of(floats).colors.values, expected);
    const Result<Scene> negative = read(colored("float", "", {"0 0 1", "0 -1 0", "1 1 1", "0 0 0"}));
    EXPECT_FALSE(negative);
    EXPECT_NE(messages(negative).find("a.ply:14:9: error: vertex 1: expected a color of at least 0"),
              std::string::npos)
        << messages(negative);
}

TEST(Ply, FacesHaveColors) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "VERTEX_COLORS"
        "element face 4\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nend_header\n";
    const std::string faces = "4 0 1 2 3 255 0 0\n2 0 1 0 0 0\n3 0 1 2 0 0 255\n3 1 2 3 0 0 255\n";
    const auto with = [&](const std::string& colors, const std::string& vertices) {
        std::string text = header + vertices + faces;
        return text.replace(text.find("VERTEX_COLORS"), 13, colors);
    };
    const Result<Scene> result = read(with("", "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"));
    ASSERT_TRUE(result) << messages(result);
    const MeshData& mesh = mesh_of(*result);
    ASSERT_EQ(mesh.colors.corners.size(), 4u) << "a square is two triangles";
    const auto color = [&](std::size_t i) { return mesh.corner_values(mesh.colors, i)->at(1); };
    EXPECT_EQ(color(0), (Float3{1, 0, 0}));
    EXPECT_EQ(color(1), (Float3{1, 0, 0}));
    EXPECT_EQ(color(2), (Float3{0, 0, 1}));
    EXPECT_EQ(color(3), (Float3{0, 0, 1}));
    EXPECT_EQ(mesh.colors.values.size(), 3u) << "the one of the face that is left out, and no repetition";

    const Result<Scene> both = read(with("property uchar red\nproperty uchar green\nproperty uchar blue\n",
                                         "0 0 0 0 0 0\n1 0 0 0 0 0\n1 1 0 0 0 0\n0 1 0 0 255 0\n"));
    ASSERT_TRUE(both) << messages(both);
    EXPECT_TRUE(mesh_of(*both).colors.corners.empty()) << "the colors of vertices count";
    EXPECT_EQ(mesh_of(*both).colors.values.size(), 4u);
}

TEST(Ply, EveryShortenedFileIsAnError) {
    for (const std::string& whole : {std::string(k_square), binary_file(false)}) {
        for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
            const std::string text = whole.substr(0, length);
            const Result<Scene> result = read(text);
            ASSERT_FALSE(result) << length;
            ASSERT_EQ(what_is_wrong(result, text), "") << length;
        }
    }
}

TEST(Ply, MistakesAreReportedAtTheirPlace) {
    const auto changed = [](std::string_view from, std::string_view to) {
        std::string text(k_square);
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    const auto expect_error = [](const std::string& text, const std::string& message) {
        const Result<Scene> result = read(text);
        EXPECT_FALSE(result);
        EXPECT_NE(messages(result).find(message), std::string::npos) << messages(result);
    };
    expect_error(changed("ply", "PLY"), "a.ply:1:1: error: expected `ply` in the first line");
    expect_error(changed("ascii", "utf8"), "a.ply:2:1: error: expected `ascii`");
    expect_error(changed("vertex 4", "vertex -4"),
                 "a.ply:4:1: error: expected `element`, a name and a number");
    expect_error(changed("float x", "real x"), "a.ply:5:1: error: expected a type");
    expect_error(changed("float x", "float a"), "a.ply:4:1: error: expected the properties x, y and z");
    expect_error(changed("vertex_indices", "corners"),
                 "a.ply:8:1: error: expected the list `vertex_indices`");
    expect_error(changed("vertex 4", "vertex 4000000000"), "with room for");
    expect_error(changed("1 1 0.5", "1 l 0.5"), "a.ply:13:3: error: vertex 2: expected a number, found 'l'");
    expect_error(changed("1 1 0.5", "1 - 0.5"), "a.ply:13:3: error: vertex 2: expected a number, found '-'");
    expect_error(changed("4 0 1 2 3", "4 0 1 2 4"),
                 "a.ply:15:9: error: face 0: expected a vertex from 0 to 3, found 4");
    expect_error(changed("4 0 1 2 3", "2 0 1"), "no face with three vertices");
    expect_error(changed("face 1", "face 0"), "a cloud of points");
    expect_error(changed("element face 1", "element vertex 4\nproperty float x\nelement face 1"),
                 "a.ply:8:1: error: expected one element `vertex`, found a second one");
    expect_error(changed("end_header", "element face 0\nproperty list uchar int vertex_indices\nend_header"),
                 "a.ply:10:1: error: expected one element `face`, found a second one");
    expect_error(changed("1 1 0.5", "1 1 1e30"),
                 "a.ply:13:5: error: vertex 2: expected a number from -1e12 to 1e12, found 1e+30");
    std::string binary = binary_file(false);
    binary[binary.size() - 8] = 77;
    expect_error(binary, "a.ply:15:1: error: byte");
}

TEST(Ply, AViewMovesTheEyeAndTheLights) {
    const auto seen_from = [](Vec3 view) {
        LoadOptions options;
        options.view = view;
        return load_text(std::string(k_square), "a.ply", options);
    };
    const Result<Scene> front = seen_from({0, 0, 3}), usual = load_text(std::string(k_square), "a.ply"),
                        again = seen_from({0.5, 0.4, 1});
    ASSERT_TRUE(front && usual && again);
    const Camera& camera = front->camera;
    EXPECT_EQ(camera.position.x, camera.look_at.x);
    EXPECT_EQ(camera.position.y, camera.look_at.y);
    EXPECT_GT(camera.position.z, camera.look_at.z);
    EXPECT_NEAR(length(camera.position - camera.look_at),
                length(usual->camera.position - usual->camera.look_at), 1e-12);
    EXPECT_NEAR(length(again->camera.position - usual->camera.position), 0, 1e-12);
    ASSERT_EQ(front->lights.size(), 3u);
    EXPECT_EQ(front->lights[2].to_light, (Vec3{0, 0, 1}));
    EXPECT_EQ(front->lights[1].to_light, (Vec3{-0.6, 0.75, 1}));
    // The light of this view is almost that of the usual one.
    EXPECT_GT(dot(normalize(again->lights[1].to_light), normalize(usual->lights[1].to_light)), 0.99);

    const Result<Scene> above = seen_from({0, 1, 0}), below = seen_from({0, -1, 0});
    ASSERT_TRUE(above && below);
    EXPECT_EQ(above->camera.up, (Vec3{0, 0, -1}));
    EXPECT_EQ(below->camera.up, (Vec3{0, 0, 1}));
}

TEST(Ply, AViewNeedsAMeshWithoutACamera) {
    const auto said = [](const std::string& text, const std::string& name, Vec3 view) {
        LoadOptions options;
        options.view = view;
        return messages(load_text(text, name, options));
    };
    EXPECT_EQ(said(std::string(k_square), "a.ply", {0, 0, 0}), "error: the view has no direction\n");
    EXPECT_EQ(said("camera { position = (0, 0, 9)  look_at = (0, 0, 0) }", "a.glint", {0, 0, 1}),
              "error: only meshes without a camera have a view\n");
}

class OneFile : public Sources {
  public:
    Result<std::string> read(std::string_view name, std::string_view) override {
        ++count;
        if (name == "square.ply") return std::string(k_square);
        return Status{ErrorCode::io, "no such file", {}};
    }
    int count = 0;
};

TEST(Ply, AGlintSceneUsesAFileSeveralTimes) {
    OneFile sources;
    const std::string text =
        "camera { position = (0, 0, 9)  look_at = (0, 0, 0) }\n"
        "mesh \"a\" { file = \"square.ply\"  color = (1, 0, 0) }\n"
        "mesh { file = \"square.ply\"  translate = (2, 0, 0) }\n"
        "mesh { vertices = ((0, 0, 0), (0.1, 0, 0), (0, 1, 0))  normals = ((0, 0, 1), (0, 0, 1), (0, 1, 1))\n"
        "  triangles = ((0, 1, 2)) }\n";
    const Result<Scene> result = load_text(text, "a.glint", {}, &sources);
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(sources.count, 1);
    EXPECT_EQ(result->meshes.size(), 2u);
    EXPECT_EQ(result->shapes.size(), 3u);
    EXPECT_EQ(result->meshes[1]->positions[1], (Vec3{0.1, 0, 0}));
    EXPECT_TRUE(result->meshes[1]->corner_normals(0));
    EXPECT_TRUE(result->lights.empty()) << "only a file alone has its own lights";
}

TEST(Ply, ManyShapesMayHaveALargeFile) {
    OneFile sources;
    std::string text = "camera { position = (0, 0, 9)  look_at = (0, 0, 0) }\n";
    for (int i = 0; i < 400'000; ++i) text += "mesh { file = \"square.ply\" }\n";
    const Result<Scene> result = load_text(text, "a.glint", {}, &sources);
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result->meshes.size(), 1u);
}

TEST(Ply, MistakesInAMeshBlock) {
    const auto said = [](const std::string& block) {
        OneFile sources;
        return messages(
            load_text("camera { position = (0, 0, 9)  look_at = (0, 0, 0) }\nmesh { " + block + " }",
                      "a.glint", {}, &sources));
    };
    EXPECT_NE(said("").find("2:1: error: expected a mesh's `file`"), std::string::npos) << said("");
    EXPECT_NE(said("file = \"b.ply\"").find("'b.ply': no such file"), std::string::npos);
    EXPECT_NE(said("file = \"b.png\"").find("ends in `.ply`, `.stl` or `.obj`"), std::string::npos);
    EXPECT_NE(said("file = \"square.ply\" vertices = ((0, 0, 0))").find("found both"), std::string::npos);
    EXPECT_NE(
        said("vertices = ((0, 0, 0)) triangles = ((0, 0, 1))").find("triangle 0: expected a vertex below 1"),
        std::string::npos);
    EXPECT_NE(said("vertices = ((0, 0, 0)) triangles = ((0, 0, 0.5))").find("whole numbers"),
              std::string::npos);
}

// What a triangle has at its corners.
std::string corners_of(const MeshData& mesh) {
    std::string text;
    const auto add = [&](Vec3 v) { text += fmt::format("({}, {}, {}) ", v.x, v.y, v.z); };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const std::uint32_t v : mesh.triangles[i]) add(mesh.position(v));
        for (const CornerValues* values : {&mesh.normals, &mesh.colors}) {
            const auto found = mesh.corner_values(*values, i);
            for (const Float3& v : found.value_or(std::array<Float3, 3>{})) add(to_vec3(v));
        }
        text += "\n";
    }
    return text;
}

TEST(Ply, HasTextureCoordinates) {
    MeshData mesh;
    mesh.single_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
    mesh.texture_coordinates.values = {{0, 0, 0}, {0.5F, 0, 0}, {0, 1, 0}, {7, -2, 0}};
    const Scene same = quiet_scene(write_ply(mesh).value(), "a.ply");
    EXPECT_EQ(*same.meshes.at(0), mesh);
    // A seam: vertices with two places become two.
    mesh.texture_coordinates.corners = {{0, 1, 2}, {3, 1, 0}};
    const Scene seam = quiet_scene(write_ply(mesh).value(), "a.ply");
    ASSERT_EQ(seam.meshes.at(0)->vertex_count(), 5u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(seam.meshes[0]->corner_values(seam.meshes[0]->texture_coordinates, i),
                  mesh.corner_values(mesh.texture_coordinates, i));
    mesh.texture_coordinates.corners[1].fill(CornerValues::k_none);
    EXPECT_EQ(write_ply(mesh).code, ErrorCode::invalid_argument);
    for (const char* names : {"u v", "texture_u texture_v", "s t"}) {
        const std::string name(names), u = name.substr(0, name.find(' ')),
                                       v = name.substr(name.find(' ') + 1);
        const Scene scene = quiet_scene(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nproperty float " +
                u + "\nproperty float " + v +
                "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                "0 0 0 0.25 -3\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n",
            "a.ply");
        EXPECT_EQ(scene.meshes.at(0)->texture_coordinates.values,
                  (std::vector<Float3>{{0.25F, -3, 0}, {1, 0, 0}, {0, 1, 0}}));
    }
}

TEST(Ply, IsWrittenAndReadBack) {
    MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0}, {1, 1, 1}};
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
    mesh.normals.values = {{0, 0, 1}, {0, 1, 0}};
    mesh.normals.corners = {{0, 0, 1}, {1, 1, 1}};
    mesh.colors.values = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5F, 0.25F, 0}};
    const Result<std::string> text = write_ply(mesh);
    ASSERT_TRUE(text) << to_string(text);
    const Result<Scene> scene = read(*text);
    ASSERT_TRUE(scene) << to_string(scene);
    EXPECT_EQ(corners_of(mesh_of(*scene)), corners_of(mesh));
    EXPECT_EQ(mesh_of(*scene).vertex_count(), 5u) << "vertex 1 has two normals";
    mesh.colors.corners = {{0, 1, 2}, {CornerValues::k_none, 0, 0}};
    EXPECT_EQ(write_ply(mesh).code, ErrorCode::invalid_argument) << "a triangle without colors";
    mesh.colors.corners = {{0, 1, 2}};
    EXPECT_EQ(write_ply(mesh).code, ErrorCode::invalid_argument) << "colors of one triangle of two";
}

}  // namespace
}  // namespace glint::test
