// SPDX-License-Identifier: Apache-2.0
// RT2's scenes, field by field, as JSON and as JavaScript.
#include "formats/load_text.h"

namespace glint::test {
namespace {

constexpr std::string_view k_json = R"({
 "name": "test",
 "camera": { "position": [1, 2, 3], "target": [4, 5, 7], "up": [0, 0, 2], "fov": 50 },
 "spheres": [ { "center": [1, 0, 0], "radius": 2, "material": "b" } ],
 "planes": [ { "center": [0, 0, -1], "normal": [0, 0, 3], "material": "a" } ],
 "cylinders": [ { "center": [1, 2, 3], "axis": [0, 0, -5], "radius": 0.5, "height": 4, "material": "a" } ],
 "materials": [
  { "name": "a", "color": [0.5, 1, 0.25], "ambient": 0.5, "diffuse": 0.25, "specular": 2, "shininess": 8, "mirror": 0.75 },
  { "name": "b", "color": [1, 1, 1], "ambient": 0, "diffuse": 1, "specular": 0, "shininess": 4, "mirror": 0 }
 ],
 "lights": [ { "position": [9, 8, 7], "color": [1, 0.5, 0] } ]
}
)";

Scene epfl_scene(std::string_view text, const LoadOptions& options = {}) {
    const Result<Scene> result = load_text(text, "a.json", options);
    EXPECT_TRUE(result) << messages(result);
    return result.value_or(Scene{});
}

TEST(Epfl, ReadsEveryField) {
    const Result<Scene> result = load_text(k_json, "a.json");
    ASSERT_TRUE(result) << messages(result);
    EXPECT_TRUE(result.diagnostics.empty()) << messages(result);
    const Scene& s = *result;
    EXPECT_EQ(s.profile, "epfl");
    EXPECT_EQ(s.background, (Color{0, 0, 0}));
    EXPECT_EQ(s.camera.position, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.camera.look_at, (Vec3{4, 5, 7}));
    EXPECT_EQ(s.camera.up, (Vec3{0, 0, 2}));
    EXPECT_EQ(s.camera.fov_degrees, 50);
    EXPECT_EQ(s.camera.fov_axis, FovAxis::x);
    EXPECT_FALSE(s.camera.frame);

    ASSERT_EQ(s.lights.size(), 2u);
    EXPECT_EQ(s.lights[0].kind, LightKind::ambient);
    EXPECT_EQ(s.lights[0].color, (Color{1, 1, 1}));
    EXPECT_EQ(s.light_texts.place(0).line, 0u);
    EXPECT_EQ(s.lights[1].kind, LightKind::point);
    EXPECT_EQ(s.lights[1].position, (Vec3{9, 8, 7}));
    EXPECT_EQ(s.lights[1].color, (Color{1, 0.5, 0}));
    EXPECT_EQ(s.lights[1].specular_color, (Color{1, 0.5, 0}));
    EXPECT_EQ(s.light_texts.place(1).line, 11u);

    ASSERT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.materials[0].color, (Color{0.5, 1, 0.25}));
    EXPECT_EQ(s.materials[0].ambient, (Color{0.25, 0.5, 0.125}));
    EXPECT_EQ(s.materials[0].diffuse, (Color{0.125, 0.25, 0.0625}));
    EXPECT_EQ(s.materials[0].specular, (Color{1, 2, 0.5}));
    EXPECT_EQ(s.materials[0].shininess, 8);
    EXPECT_EQ(s.materials[0].mirror, 0.75);
    EXPECT_EQ(s.materials[0].mirror_tint, (Color{1, 1, 1}));
    EXPECT_EQ(s.material_texts.name(0), "a");

    ASSERT_EQ(s.shapes.size(), 3u);
    EXPECT_EQ(s.get<Sphere>()[0].center, (Vec3{1, 0, 0}));
    EXPECT_EQ(s.get<Sphere>()[0].radius, 2);
    EXPECT_EQ(s.shapes[0].material, 1u) << "materials may come after the shapes";
    EXPECT_EQ(s.get<Plane>()[0].point, (Vec3{0, 0, -1}));
    EXPECT_EQ(s.get<Plane>()[0].normal, (Vec3{0, 0, 3}));
    EXPECT_EQ(s.shapes[1].material, 0u);
    EXPECT_EQ(s.get<Cylinder>()[0].from, (Vec3{1, 2, 5}));
    EXPECT_EQ(s.get<Cylinder>()[0].to, (Vec3{1, 2, 1}));
    EXPECT_EQ(s.get<Cylinder>()[0].radius, 0.5);
    EXPECT_FALSE(s.get<Cylinder>()[0].caps);
    EXPECT_EQ(s.shape_texts.place(2), (SourcePlace{6, 17, 0}));
}

TEST(Epfl, AxesOfAnySizeAreDirections) {
    std::string text(k_json);
    for (const char* axis : {"[3e-200, 0, 4e-200]", "[3e11, 0, 4e11]", "[3, 0, 4]"}) {
        std::string with = text;
        with.replace(with.find("[0, 0, -5]"), 10, axis);
        const Scene s = epfl_scene(with);
        EXPECT_NEAR(s.get<Cylinder>()[0].to.x - s.get<Cylinder>()[0].from.x, 2.4, 1e-12) << axis;
        EXPECT_NEAR(s.get<Cylinder>()[0].to.z - s.get<Cylinder>()[0].from.z, 3.2, 1e-12) << axis;
    }
}

constexpr std::string_view k_javascript_text = R"('use strict';
import { vec3 } from "gl-matrix"
/* all of them */
export const scenes = [
  { // one
    name: 'first',
    camera: { position: [0., 0, -.5], target: [0, 0, 0], up: [0, 1, 0], fov: 4.e1, },
    materials: [{ name: "it's", color: [1, 1, 1,], ambient: .5, diffuse: 1., specular: 0, shininess: 1, mirror: 0 }],
    lights: [],
    spheres: [{ center: [0, 0, 5], radius: +1, material: 'it\'s' }],
  },
  { name: "second", spheres: [], camera: { position: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], fov: 60 } },
];
export const by_name = Object.fromEntries(scenes.map((s) => [s.name, s]));
)";

TEST(Epfl, ReadsTheHomeworksJavaScript) {
    const Result<Scene> result = load_text(k_javascript_text, "scenes.js");
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result->camera.position, (Vec3{0, 0, -0.5}));
    EXPECT_EQ(result->camera.fov_degrees, 40);
    EXPECT_EQ(result->material_texts.name(0), "it's");
    EXPECT_EQ(result->shapes[0].material, 0u);
    ASSERT_EQ(result.diagnostics.size(), 3u) << messages(result);
    EXPECT_EQ(result.diagnostics[0].message, "glint ignores imports");
    EXPECT_EQ(result.diagnostics[1].message, "2 scenes: the first one is read ('first', 'second')");
    EXPECT_EQ(result.diagnostics[1].line, 5u);
    EXPECT_EQ(result.diagnostics[1].severity, Severity::note);
    EXPECT_EQ(result.diagnostics[2].message, "glint reads data, not code: what follows is ignored");
    EXPECT_EQ(result.diagnostics[2].line, 14u);
}

TEST(Epfl, ASceneIsChosenByItsName) {
    LoadOptions options;
    options.scene_name = "second";
    const Result<Scene> second = load_text(k_javascript_text, "scenes.js", options);
    ASSERT_TRUE(second) << messages(second);
    EXPECT_EQ(second->camera.position, (Vec3{0, 0, 9}));
    EXPECT_TRUE(second->shapes.empty());
    options.scene_name = "third";
    const Result<Scene> third = load_text(k_javascript_text, "scenes.js", options);
    ASSERT_EQ(third.diagnostics.size(), 1u);
    EXPECT_EQ(third.diagnostics[0].message, "no scene is called 'third'; there are 'first', 'second'");
    options.scene_name = "test";
    EXPECT_TRUE(load_text(k_json, "a.json", options));
    options.scene_name = "tset";
    EXPECT_EQ(load_text(k_json, "a.json", options).diagnostics[0].message,
              "no scene is called 'tset'; there is 'test'");
}

TEST(Epfl, IgnoresCodeInOtherScenes) {
    const std::string text =
        "const a = [\n{ name: 'bad', camera: {}, spheres: [1, 2].map(x => ({ name: 'inner' })) },\n" +
        std::string(k_json) + "];";
    LoadOptions options;
    options.scene_name = "test";
    const Result<Scene> result = load_text(text, "a.js", options);
    EXPECT_TRUE(result) << messages(result);
    EXPECT_TRUE(result.diagnostics.empty()) << messages(result);
    EXPECT_FALSE(load_text(text, "a.js"));
}

TEST(Epfl, ScenesMayBeStatementsOfTheirOwn) {
    const std::string text =
        "module.exports = " + std::string(k_json) + ";\nlet other = { name: 'x', camera: {} };\n";
    LoadOptions options;
    options.scene_name = "test";
    EXPECT_TRUE(load_text(text, "a.js", options));
    EXPECT_TRUE(load_text("export default [" + std::string(k_json) + "]", "a.js"));
}

TEST(Epfl, ReportsMissingCoefficients) {
    std::string text(k_json);
    const std::string from = "\"ambient\": 0, \"diffuse\": 1, \"specular\": 0, \"shininess\": 4, ";
    text.replace(text.find(from), from.size(), "");
    const Result<Scene> result = load_text(text, "a.json");
    ASSERT_TRUE(result);
    ASSERT_EQ(result.diagnostics.size(), 4u);
    EXPECT_EQ(result.diagnostics[1].message, "material 'b' has no `diffuse`: 0 is taken");
    EXPECT_EQ(result->materials[1].diffuse, (Color{0, 0, 0}));
    EXPECT_EQ(result->materials[1].shininess, 1);
}

TEST(Epfl, TheLastMaterialOfANameCounts) {
    std::string text(k_json);
    text.replace(text.find("\"name\": \"b\""), 11, "\"name\": \"a\"");
    text.replace(text.find("\"material\": \"b\""), 15, "\"material\": \"a\"");
    const Result<Scene> result = load_text(text, "a.json");
    ASSERT_TRUE(result);
    EXPECT_EQ(result->shapes[0].material, 1u);
    EXPECT_EQ(result->shapes[1].material, 1u);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].message, "a second material 'a': the last one holds");
    EXPECT_EQ(result.diagnostics[0].line, 9u);
}

TEST(Epfl, SeveralTextsAreOneScene) {
    const std::string world(k_json);
    const std::string lamp = R"({ "lights": [ { "position": [0, 0, 9], "color": [1, 1, 1] } ],
        "spheres": [ { "center": [0, 0, 9], "radius": 0.1, "material": "a" } ] })";
    const SceneText texts[] = {{"world.json", world, {}}, {"lamp.json", lamp, {}}};
    const Result<Scene> result = load(texts);
    ASSERT_TRUE(result) << messages(result);
    EXPECT_TRUE(result.diagnostics.empty()) << messages(result);
    EXPECT_EQ(result->lights.size(), 3u) << "one ambient light for all texts";
    EXPECT_EQ(result->shapes[3].material, 0u) << "a material of an earlier text";
    const Result<Scene> lamp_alone = load_text(lamp, "lamp.json");
    EXPECT_FALSE(lamp_alone);
    EXPECT_NE(messages(lamp_alone).find("lamp.json:1:1: error: expected `camera` in the scene"),
              std::string::npos);
}

}  // namespace
}  // namespace glint::test
