// SPDX-License-Identifier: Apache-2.0
// .gltf and .glb: containers, accessors, primitives, nodes and mistakes. gltf_materials_test.cpp: materials,
// lights and cameras.
#include <chrono>
#include <random>

#include "formats/gltf_text.h"
#include "math/transform.h"

namespace glint::test {
namespace {

const MeshData& gltf_mesh(const Scene& scene) {
    EXPECT_EQ(scene.meshes.size(), 1u);
    return *scene.meshes.at(0);
}

void expect_gltf_square(const MeshData& mesh) {
    EXPECT_EQ(mesh.single_positions, (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<TriangleCorners>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.normals.values, (std::vector<Float3>(4, Float3{0, 0, 1})));
}

/// GltfFiles by their names.
struct GltfFiles : Sources {
    std::map<std::string, std::string, std::less<>> texts;
    std::string opened;
    Result<std::string> read(std::string_view name, std::string_view) override {
        opened += std::string(name) + ";";
        const auto found = texts.find(name);
        if (found != texts.end()) return found->second;
        return Status{ErrorCode::io, "no such file", {}};
    }
};

void expect_gltf_error(const std::string& text, const std::string& message, const char* name = "a.gltf") {
    const Result<Scene> result = load_text(text, name);
    EXPECT_FALSE(result);
    EXPECT_EQ(what_is_wrong(result, text), "");
    EXPECT_NE(messages(result).find(message), std::string::npos) << messages(result) << "\nnot " << message;
}

std::string with_change(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Gltf, TextsFilesAndBinaryFilesAreTheSame) {
    const GltfText file = gltf_square();
    const Scene text = quiet_scene(file.text(), "a.gltf");
    expect_gltf_square(gltf_mesh(text));
    EXPECT_EQ(text.lights.size(), 3u);
    EXPECT_EQ(text.camera.look_at, (Vec3{0.5, 0.5, 0}));
    EXPECT_EQ(text.conventions.transfer, Transfer::srgb);
    expect_gltf_square(gltf_mesh(quiet_scene(file.binary(), "A.GLB")));
    expect_gltf_square(gltf_mesh(quiet_scene(file.binary(), "named_otherwise.gltf")));
    expect_gltf_square(gltf_mesh(quiet_scene(file.text(), "text.glb")));

    GltfFiles files;
    files.texts["a b.bin"] = file.bytes + "more";
    const Result<Scene> beside = load_text(file.json(R"(, "uri": "a%20b.bin")"), "a.gltf", {}, &files);
    ASSERT_TRUE(beside) << messages(beside);
    expect_gltf_square(gltf_mesh(*beside));
    EXPECT_EQ(files.opened, "a b.bin;");
}

TEST(Gltf, OnlyFilesOfBuffersAreOpened) {
    GltfFiles files;
    const auto said = [&](const std::string& uri) {
        const Result<Scene> result =
            load_text(gltf_square().json(R"(, "uri": ")" + uri + '"'), "a.gltf", {}, &files);
        EXPECT_FALSE(result);
        return messages(result);
    };
    EXPECT_NE(said("/etc/passwd").find("expected the name of a file that ends in .bin"), std::string::npos);
    EXPECT_NE(said("http://a.b/c.bin").find("relative to this one"), std::string::npos);
    EXPECT_NE(said("//a.b/c.bin").find("relative to this one"), std::string::npos);
    EXPECT_NE(said("").find("expected the name of a file"), std::string::npos);
    EXPECT_EQ(files.opened, "");
    EXPECT_NE(said("no.bin").find("a.gltf:12:40: error: 'no.bin': no such file"), std::string::npos)
        << said("no.bin");
    files.texts["short.bin"] = "123";
    EXPECT_NE(said("short.bin").find("expected 108 bytes in buffers[0], found 3"), std::string::npos);
    EXPECT_NE(said("data:text/plain,abc").find("expected `data:...;base64,`"), std::string::npos);
    EXPECT_NE(said("data:;base64,AAA!").find("expected bytes in base64"), std::string::npos);
}

TEST(Gltf, ModesOfPrimitives) {
    const auto triangles = [](const std::string& mode) {
        GltfText file = gltf_square();
        std::string& mesh = file.members["meshes"];
        mesh = with_change(mesh, "\"indices\": 2", "\"mode\": " + mode);
        return load_text(file.text(), "a.gltf");
    };
    using Triangles = std::vector<TriangleCorners>;
    EXPECT_EQ(gltf_mesh(*triangles("5")).triangles, (Triangles{{0, 1, 2}, {1, 3, 2}}));
    EXPECT_EQ(gltf_mesh(*triangles("6")).triangles, (Triangles{{1, 2, 0}, {2, 3, 0}}));
    const Result<Scene> rest = triangles("4");
    EXPECT_EQ(gltf_mesh(*rest).triangles, (Triangles{{0, 1, 2}}));
    EXPECT_NE(messages(rest).find("no multiple of three"), std::string::npos);
    EXPECT_NE(messages(triangles("1")).find("glint draws no points and lines"), std::string::npos);
    EXPECT_NE(messages(triangles("7")).find("expected a number from 0 to 6 as `mode`, found '7'"),
              std::string::npos);
}

TEST(Gltf, InterleavedSparseAndNormalisedAccessors) {
    GltfText file = gltf_square();
    // Positions as bytes, 8 apart; those that sparse values replace.
    const int view = file.view(bytes_of<std::uint8_t>({0, 0, 0,   9,   9, 9, 9, 9, 255, 0, 0, 9,   9, 9,
                                                       9, 9, 255, 255, 0, 9, 9, 9, 9,   9, 0, 255, 0}),
                               ", \"byteStride\": 8");
    const int indices = file.view(bytes_of<std::uint8_t>({1, 3})),
              values = file.view(bytes_of<std::uint8_t>({51, 0, 0, 0, 51, 0}));
    const int positions = file.accessor(
        view, 4, 5121, "VEC3",
        fmt::format(
            R"(, "normalized": true, "sparse": {{"count": 2, "indices": {{"bufferView": {}, "componentType": 5121}}, "values": {{"bufferView": {}}}}})",
            indices, values));
    std::string& mesh = file.members["meshes"];
    mesh = with_change(mesh, "\"POSITION\": 0", fmt::format("\"POSITION\": {}", positions));
    const Scene scene = quiet_scene(file.text(), "a.gltf");
    EXPECT_EQ(gltf_mesh(scene).single_positions,
              (std::vector<Float3>{{0, 0, 0}, {0.2F, 0, 0}, {1, 1, 0}, {0, 0.2F, 0}}));

    // Zeros, of which sparse values replace some.
    GltfText zeros = gltf_square();
    const int where = zeros.view(bytes_of<std::uint16_t>({1, 2})),
              what = zeros.view(bytes_of<float>({1, 0, 0, 1, 1, 0}));
    zeros.accessors[0] = fmt::format(
        R"({{"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {{"count": 2, "indices": {{"bufferView": {}, "componentType": 5123}}, "values": {{"bufferView": {}}}}}}})",
        where, what);
    EXPECT_EQ(gltf_mesh(quiet_scene(zeros.text(), "a.gltf")).single_positions,
              (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}));
    expect_gltf_error(with_change(zeros.text(), "\"count\": 4", "\"count\": 4000000000"),
                      "accessors[0]: expected at most 1048576 zeros");
}

TEST(Gltf, PrimitivesThatShareVerticesHaveTheirOwn) {
    GltfText file;
    std::string positions;
    for (int i = 0; i < 40; ++i)
        positions += bytes_of<float>({static_cast<float>(i), static_cast<float>(i % 2), 0});
    file.accessor(file.view(positions), 40, 5126, "VEC3");
    file.accessor(file.view(bytes_of<std::uint32_t>({30, 31, 32, 32, 31, 33})), 6, 5125, "SCALAR");
    file.members["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])";
    file.members["nodes"] = R"([{"mesh": 0, "name": "far"}])";
    const Scene scene = quiet_scene(file.binary(), "a.glb");
    EXPECT_EQ(gltf_mesh(scene).single_positions,
              (std::vector<Float3>{{30, 0, 0}, {31, 1, 0}, {32, 0, 0}, {33, 1, 0}}));
    EXPECT_EQ(gltf_mesh(scene).triangles, (std::vector<TriangleCorners>{{0, 1, 2}, {2, 1, 3}}));
    EXPECT_TRUE(gltf_mesh(scene).normals.empty());
    EXPECT_EQ(scene.shape_texts.name(0), "far");
}

Vec3 place_of(const Scene& scene, std::size_t shape, Vec3 p) {
    const std::uint32_t transform = scene.shapes.at(shape).transform;
    return transform == k_none ? p : transform_point(scene.transforms.at(transform), p);
}

TEST(Gltf, NodesPlaceAMeshThatTheyShare) {
    GltfText file = gltf_square();
    file.members["nodes"] = R"([
        {"mesh": 0},
        {"translation": [10, 0, 0], "rotation": [0, 0, 2, 2], "scale": [1, 2, 3], "children": [2, 3]},
        {"mesh": 0, "translation": [1, 0, 0]},
        {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 5, 6, 7, 1]}])";
    file.members["scenes"] = R"([{"nodes": [0, 1]}])";
    const Scene scene = quiet_scene(file.text(), "a.gltf");
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.shapes[0].transform, k_none);
    EXPECT_EQ(place_of(scene, 1, {1, 2, 3}), (Vec3{10 - 4, 2, 9}));
    EXPECT_EQ(place_of(scene, 2, {1, 2, 3}), (Vec3{10 - 16, 6, 12}));
    EXPECT_EQ(scene.camera.look_at, (Vec3{(10 - 4) / 2.0, 3, 21 / 2.0})) << "of all shapes";

    file.members["scenes"] = R"([{"nodes": [0, 1, 2]}])";
    expect_gltf_error(file.text(), "nodes[2] has two parents, or is in itself");
    file.members["nodes"] = R"([{"children": [1]}, {"mesh": 0, "children": [0]}])";
    file.members["scenes"] = R"([{"nodes": [0]}])";
    expect_gltf_error(file.text(), "nodes[0] has two parents, or is in itself");
    file.members["nodes"] = R"([{"mesh": 0}, {"mesh": 0, "scale": [0, 0, 0]}, {"mesh": 1}])";
    file.members["scenes"] = R"([{"nodes": [0, 1]}])";
    const Result<Scene> flat = load_text(file.text(), "a.gltf");
    ASSERT_TRUE(flat) << messages(flat);
    EXPECT_EQ(flat->shapes.size(), 1u);
    EXPECT_NE(messages(flat).find("a mesh with a scale of 0 is left out"), std::string::npos);
    file.members["scenes"] = R"([{"nodes": [2]}])";
    expect_gltf_error(file.text(), "expected a number of `meshes` from 0 to 0, found '1'");
}

TEST(Gltf, InstancesHaveTheirTransforms) {
    GltfText file = gltf_square();
    const int t = file.floats("VEC3", 2, {1, 0, 0, 2, 0, 0}), s = file.floats("VEC3", 2, {1, 1, 1, 2, 2, 2});
    const int r = file.accessor(file.view(bytes_of<std::int8_t>({0, 0, 0, 127, 0, 0, 127, 0})), 2, 5120,
                                "VEC4", ", \"normalized\": true");
    file.members["extensionsRequired"] = R"(["EXT_mesh_gpu_instancing"])";
    file.members["nodes"] = fmt::format(
        R"([{{"mesh": 0, "translation": [0, 5, 0], "extensions": {{"EXT_mesh_gpu_instancing": {{"attributes": {{"TRANSLATION": {}, "ROTATION": {}, "SCALE": {}}}}}}}}}])",
        t, r, s);
    const Scene scene = quiet_scene(file.text(), "a.gltf");
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(place_of(scene, 0, {1, 1, 0}), (Vec3{2, 6, 0}));
    EXPECT_EQ(place_of(scene, 1, {1, 1, 0}), (Vec3{0, 3, 0}));
}

TEST(Gltf, ScenesAreChosenByName) {
    GltfText file = gltf_square();
    file.members["nodes"] = R"([{"mesh": 0}, {"mesh": 0, "translation": [7, 0, 0]}])";
    file.members["scenes"] = R"([{"nodes": [0], "name": "here"}, {"nodes": [1], "name": "there"}])";
    const auto x = [&](const std::string& name) {
        LoadOptions options;
        options.scene_name = name;
        const Result<Scene> result = load_text(file.text(), "a.gltf", options);
        return result ? place_of(*result, 0, {}).x : -1;
    };
    EXPECT_EQ(x(""), 0);
    EXPECT_EQ(x("there"), 7);
    file.members["scene"] = "1";
    EXPECT_EQ(x(""), 7);
    EXPECT_EQ(x("here"), 0);
    EXPECT_EQ(x("nowhere"), -1);
    EXPECT_NE(messages(load_text(file.text(), "a.gltf")).find("2 scenes: this one is read ('here', 'there')"),
              std::string::npos);
    file.members.erase("scene");
    file.members.erase("scenes");
    EXPECT_EQ(quiet_scene(file.text(), "a.gltf").shapes.size(), 2u) << "all nodes";
}

TEST(Gltf, ExtensionsThatAreNotReadAreNamed) {
    GltfText file = gltf_square();
    file.members["extensionsUsed"] =
        R"(["KHR_materials_clearcoat", "KHR_lights_punctual", "KHR_materials_clearcoat"])";
    const Result<Scene> used = load_text(file.text(), "a.gltf");
    ASSERT_TRUE(used);
    ASSERT_EQ(used.diagnostics.size(), 1u);
    EXPECT_EQ(used.diagnostics[0].message, "glint ignores the extension 'KHR_materials_clearcoat'");
    file.members["extensionsRequired"] = R"(["KHR_draco_mesh_compression"])";
    expect_gltf_error(
        file.text(),
        "the file requires the extension 'KHR_draco_mesh_compression', which glint does not read");
}

TEST(Gltf, WhatMovesIsDrawnAtRest) {
    GltfText file = gltf_square();
    std::string& mesh = file.members["meshes"];
    mesh = with_change(mesh, "\"indices\": 2", R"("indices": 2, "targets": [{"POSITION": 0}])");
    const int matrices = file.floats("MAT4", 1, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -3, 0, 0, 1});
    file.members["skins"] = fmt::format(R"([{{"joints": [1], "inverseBindMatrices": {}}}])", matrices);
    file.members["nodes"] =
        R"([{"mesh": 0, "skin": 0, "translation": [99, 0, 0]}, {"translation": [5, 0, 0]}])";
    file.members["scenes"] = R"([{"nodes": [0, 1]}])";
    file.members["animations"] = "[{}]";
    const Result<Scene> result = load_text(file.text(), "a.gltf");
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result.diagnostics.size(), 3u) << messages(result);
    EXPECT_EQ(place_of(*result, 0, {}), (Vec3{2, 0, 0})) << "as its joint is";
}

TEST(Gltf, MistakesAreReportedAtTheirPlace) {
    const std::string text = gltf_square().text();
    const auto expect = [&](const std::string& from, const std::string& to, const std::string& message) {
        expect_gltf_error(with_change(text, from, to), message);
    };
    expect_gltf_error("", "a.gltf:1:1: error: expected `{`, found the end of the text");
    expect_gltf_error("[]", "a.gltf:1:1: error: expected an object `{ ... }`, found a list");
    expect_gltf_error("{}", "expected the version of glTF as `asset.version`");
    expect_gltf_error("{\"a\": 1\n \"b\": 2}", "a.gltf:2:2: error: expected `,` or `}`, found '\"b\"'");
    expect_gltf_error("{\"a\": [1, }", "a.gltf:1:11: error: expected a value, found '}'");
    expect_gltf_error("{\"a\": {", "the object that begins in line 1 has no end");
    expect_gltf_error("{a: 1}", "a.gltf:1:2: error: expected a key in quotes or `}`, found 'a'");
    expect_gltf_error("{\"a\": yes}", "a.gltf:1:7: error: expected a value, found 'yes'");
    expect_gltf_error(std::string(1000000, '['), "brackets are nested more than 256 deep");
    expect("\"2.0\"", "\"1.0\"", "expected glTF 2.0, found version '1.0'");
    expect("\"count\": 4,", "\"count\": 5,",
           "accessors[0]: expected 5 elements of 12 bytes from byte 0 on, found a buffer view of 48 bytes");
    expect("\"count\": 4,", "\"count\": 1.5,",
           "expected a whole number of at least 0 as `count`, found '1.5'");
    expect("\"type\": \"VEC3\"", "\"type\": \"VEC2\"",
           "accessors[0]: expected elements of 3 numbers, found 2");
    expect("5126", "5124", "expected 5120, 5121, 5122, 5123, 5125 or 5126 as `componentType`");
    expect("\"POSITION\": 0", "\"POSITION\": 9",
           "a.gltf:3:56: error: expected a number of `accessors` from 0 to 2, found '9'");
    expect("\"byteLength\": 48", "\"byteLength\": 4800",
           "expected bytes 0 to 4800 of buffers[0], which has 108");
    expect("\"mesh\": 0", "\"mesh\": \"a\"", "a.gltf:4:20: error: expected a number of `meshes`");
    expect("\"nodes\": [0]", "\"nodes\": []", "the scene has no triangles");

    GltfText file = gltf_square();
    file.bytes[96] = 9;
    expect_gltf_error(file.text(),
                      "accessors[2]: expected the number of a vertex from 0 to 3, found 9 as number 0");
    file = gltf_square();
    file.bytes.replace(4, 4, "\xff\xff\xff\x7f");
    expect_gltf_error(file.text(),
                      "accessors[0], element 0: expected a number from -1e12 to 1e12, found nan");
}

TEST(Gltf, EveryShortenedFileIsAnError) {
    for (const std::string& whole : {gltf_square().text(), gltf_square().binary()}) {
        const std::size_t end = whole.find_last_not_of('\n') + 1;
        for (std::size_t length = 0; length < end; ++length) {
            const std::string part = whole.substr(0, length);
            const Result<Scene> result = load_text(part, "a.gltf");
            ASSERT_FALSE(result) << length;
            ASSERT_EQ(what_is_wrong(result, part), "") << length;
        }
    }
}

TEST(Gltf, ChangedFilesHaveAnAnswer) {
    std::mt19937 random(2);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    GltfText file = gltf_square(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 0.5]}, "alphaMode": "BLEND"})");
    file.members["cameras"] = R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}])";
    file.members["nodes"] = R"([{"mesh": 0, "camera": 0, "children": [1]}, {"translation": [0, 0, 2]}])";
    const std::string wholes[] = {file.text(), file.binary()};
    const std::string_view pieces[] = {"1e99", "-1", "{", "]", "null", "\"", "99999999999", "0", "[", ","};
    std::size_t broken = 0;
    for (int i = 0; i < 6000; ++i) {
        std::string text = wholes[i % 2];
        for (std::size_t edits = 1 + below(3); edits > 0; --edits) {
            const std::size_t at = below(text.size());
            if (below(2) == 0) {
                text[at] = static_cast<char>(random() & 0xff);
            } else {
                text.replace(at, 1 + below(3), pieces[below(std::size(pieces))]);
            }
        }
        const Result<Scene> result = load_text(text, "a.gltf");
        ASSERT_EQ(what_is_wrong(result, text), "") << i;
        broken += !result;
    }
    EXPECT_GT(broken, 2000u);
    EXPECT_LT(broken, 5900u);
}

// A short file may ask for the same vertices any number of times.
TEST(Gltf, MemoryAndTimeAreLimited) {
    GltfText file;
    constexpr int count = 30000;
    file.accessor(file.view(std::string(12 * count, '\0')), count, 5126, "VEC3");
    std::string primitives;
    for (int i = 0; i < 20000; ++i)
        primitives += std::string(i == 0 ? "" : ", ") + R"({"attributes": {"POSITION": 0}, "mode": 4})";
    file.members["meshes"] = R"([{"primitives": [)" + primitives + "]}]";
    file.members["nodes"] = R"([{"mesh": 0}])";
    LoadOptions options;
    options.max_memory = 64u << 20;
    const auto start = std::chrono::steady_clock::now();
    const Result<Scene> result = load_text(file.text(), "a.gltf", options);
    EXPECT_FALSE(result);
    EXPECT_EQ(result.code, ErrorCode::out_of_memory) << messages(result);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_LT(seconds.count(), 20);
}

}  // namespace
}  // namespace glint::test
