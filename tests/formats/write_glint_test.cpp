// SPDX-License-Identifier: Apache-2.0
// The text of a scene, with its comments and names.
#include <gtest/gtest.h>

#include "formats/load_text.h"
#include "glint/glint.h"

namespace glint::test {
namespace {

// Reads a text and writes its scene.
std::string converted(std::string_view text, std::string name, std::string scene_name = {}) {
    const SceneText texts[] = {{std::move(name), text, {}}};
    LoadOptions options;
    options.scene_name = std::move(scene_name);
    const Result<Scene> loaded = load(texts, options);
    EXPECT_TRUE(loaded);
    return loaded ? write_glint(*loaded, texts).value() : std::string();
}

void expect_part(const std::string& text, std::string_view part) {
    EXPECT_NE(text.find(part), std::string::npos) << "expected\n" << part << "in\n" << text;
}

TEST(WriteGlint, ABookListing) {
    EXPECT_EQ(converted(R"(# Two spheres.

sphere {
    center = (0, -1, 3)   # in the middle
    radius = 1
    color = (255, 0, 0)   # Red
    specular = 500
}

# The floor
sphere { center = (0, -5001, 0)  radius = 5000  color = (240, 120, 60) }  // large
// The sun
light { type = directional  intensity = 0.2  direction = (1, 4, 4) }
# The end
)",
                        "folder/two.cgfs"),
              R"(# Converted from two.cgfs (cgfs) by glint )" GLINT_VERSION R"(
#
# Two spheres.

glint = 1
profile = cgfs
render { size = 600 x 600  shading = phong  shadows = true  reflections = 3  aa = 1 }
background = (1, 1, 1)

camera { position = (0, 0, 0)  right = (1, 0, 0)  up = (0, 1, 0)  forward = (0, 0, 1) }

# The sun
light { type = directional  to_light = (1, 4, 4)  intensity = 0.2 }

sphere {
    center = (0, -1, 3)  radius = 1
    color = (1, 0, 0)  ambient = 1  diffuse = 1  specular = 1  shininess = 500
}  # in the middle; Red
# The floor
sphere {
    center = (0, -5001, 0)  radius = 5000
    color = rgb255(240, 120, 60)  ambient = 1  diffuse = 1  specular = 0  shininess = 1
}  # large

# The end
)");
}

TEST(WriteGlint, CommentsOfJavaScript) {
    const std::string text = converted(R"(/* Scenes
 * of two lines. */
const scenes = [
    // not of this scene
    { name: 'other', camera: { position: [9, 9, 9], target: [0, 0, 0], up: [0, 0, 1], fov: 45 } /* nor this */ },
    // of this one
    { name: 'wanted // no comment',
      camera: { position: [0, -8, 3], target: [0, 0, 1], up: [0, 0, 1], fov: 42 }, // the eye
      materials: [
        // like gold
        { name: 'gold', color: [1, .8, .2], ambient: .1, diffuse: .7, specular: .3, shininess: 40, mirror: 0 },
      ],
      lights: [],
      // all spheres
      spheres: [
        { center: [0, 0, 1], radius: .3,
          // inside
          material: 'gold' }, /* one */
        /* two
           and more */
        { center: [0, 0, 2], radius: .3, material: 'gold' },
      ] // no more
    },
];
)",
                                       "two.js", "wanted // no comment");
    expect_part(text, R"(# Scenes
# of two lines.

glint = 1
)");
    expect_part(text, R"(
# of this one
camera { position = (0, -8, 3)  look_at = (0, 0, 1)  up = (0, 0, 1)  fov_x = 42 }  # the eye

light "ambient" { type = ambient  intensity = 1 }

# like gold
material gold {
    color = (1, 0.8, 0.2)  ambient = 0.1  diffuse = 0.7  specular = 0.3  shininess = 40
}

# all spheres
# inside
sphere { center = (0, 0, 1)  radius = 0.3  material = gold }  # one
# two
# and more
sphere { center = (0, 0, 2)  radius = 0.3  material = gold }
)");
    EXPECT_EQ(text.find("not of this"), std::string::npos);
    EXPECT_EQ(text.find("nor this"), std::string::npos);
}

TEST(WriteGlint, ColorsOfShapes) {
    Scene scene;
    scene.materials.push_back({.mirror = 0.5});
    scene.material_texts.names[0] = "glass";
    const Color colors[] = {
        {0.1, 0.25, 1}, {200 / 255.0, 160 / 255.0, 40 / 255.0}, {1.0 / 3, 1e-9, 123456.789}};
    for (const Color& color : colors) scene.set_shape_color(scene.add(Sphere{}, 0), color);
    scene.add(Sphere{}, 0);
    const std::string text = write_glint(scene).value();
    expect_part(text, "material = glass  shape_color = (0.1, 0.25, 1) }\n");
    expect_part(text, "material = glass  shape_color = rgb255(200, 160, 40) }\n");
    expect_part(text, "shape_color = (0.333333");
    expect_part(text, "radius = 1  material = glass }\n");
    const Scene again = load_text(text, "a.glint").value();
    ASSERT_EQ(again.shape_colors.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(again.shape_color(i), scene.shape_color(i)) << i;
}

TEST(WriteGlint, CommentsOfGroups) {
    const std::string text = converted(R"(glint = 1
camera { position = (0, 2, 8)  look_at = (0, 1, 0)  fov_x = 50 }
group "tower" {   # of the tower
    scale = 2  rotate = (0, 45, 0)
    # its wall
    box { min = (0, 0, 0)  max = (1, 3, 1) }  # white # and flat
    sphere { center = (0, 0, 0)
             # round
             radius = 1 }
    # nothing more
}
)",
                                       "a.glint");
    expect_part(text, "    # of the tower\n    # its wall\n    box ");
    expect_part(text, "}  # white # and flat\n    # round\n    sphere ");
}

TEST(WriteGlint, CommentsOfNff) {
    const std::string text = converted(R"(# heading
b 0.1 0.2 0.3  # sky
v
from 0 0 5  # eye
at 0 0 0
up 0 1 0
angle 40
hither 1
resolution 100 100
l 1 2 3
# the finish
f 1 0 0 0.5 0.5 3 0 0
# the ball
s 0 0 0 1 # round
)",
                                       "a.nff");
    expect_part(text, "# heading\nbackground = (0.1, 0.2, 0.3)  # sky\n");
    expect_part(text, "fov_y = 40 }  # eye\n");
    expect_part(text, "# the finish\n# the ball\nsphere {\n");
    expect_part(text, "}  # round\n");
}

TEST(WriteGlint, Materials) {
    Scene scene;
    Material red;
    red.color = {0.1, 0.7, 0.3};
    red.ambient = red.color * 0.1;
    red.diffuse = red.color * 0.7;
    red.specular = {0.5, 0.5, 0.5};
    scene.materials = {red, red, red, Material{}, red};
    scene.material_texts.names = {{2, "deep red"}, {4, "unused"}};
    for (const std::uint32_t material : {0u, 1u, 2u, 3u, k_none}) scene.add(Sphere{}, material);
    const std::string text = write_glint(scene).value();
    constexpr auto keys = "color = (0.1, 0.7, 0.3)  ambient = 0.1  diffuse = 0.7";
    expect_part(text,
                std::string("\nmaterial material_1 {\n    ") + keys + "  specular_color = (0.5, 0.5, 0.5)\n");
    expect_part(text, std::string("\nmaterial \"deep red\" {\n    ") + keys);
    expect_part(text, std::string("\nmaterial unused "));
    expect_part(text, R"(
sphere { center = (0, 0, 0)  radius = 1  material = material_1 }
sphere { center = (0, 0, 0)  radius = 1  material = material_1 }
sphere { center = (0, 0, 0)  radius = 1  material = "deep red" }
sphere { center = (0, 0, 0)  radius = 1 }
sphere { center = (0, 0, 0)  radius = 1 }
)");
}

// A name that an earlier material has is lost, and the material is then as one without a name.
TEST(WriteGlint, EqualMaterialsWhoseNameIsTakenAreOne) {
    Scene scene;
    Material red;
    red.diffuse = {0.7, 0, 0};
    scene.materials = {Material{}, red, red};
    scene.material_texts.names = {{0, "paint"}, {1, "paint"}};
    for (const std::uint32_t material : {0u, 1u, 2u}) scene.add(Sphere{}, material);
    const std::string text = write_glint(scene).value();
    expect_part(text,
                "material = material_1 }\nsphere { center = (0, 0, 0)  radius = 1  material = material_1 }");
    const Result<Scene> again = load_text(text, "a.glint");
    ASSERT_TRUE(again) << messages(again);
    EXPECT_EQ(write_glint(*again).value(), text);
}

TEST(WriteGlint, LightsAndNames) {
    Scene scene;
    Light gray, colored, two;
    gray.color = gray.specular_color = {0.2, 0.2, 0.2};
    colored.color = colored.specular_color = {1, 0.5, 0};
    colored.kind = LightKind::directional;
    two.color = {1, 1, 1};
    two.specular_color = {1, 0, 0};
    two.attenuation = {1, 0.1, 0.01};
    scene.lights = {gray, colored, two};
    scene.light_texts.names = {{0, "key \"a\"\n"}};
    expect_part(write_glint(scene).value(), R"(
light "key \"a\"\u000a" { type = point  position = (0, 0, 0)  intensity = 0.2 }
light { type = directional  to_light = (0, 1, 0)  color = (1, 0.5, 0) }
light {
    type = point  position = (0, 0, 0)  color = (1, 1, 1)  specular_color = (1, 0, 0)
    attenuation = (1, 0.1, 0.01)
}
)");
}

TEST(WriteGlint, Transforms) {
    Scene scene;
    scene.transforms = {{{{1, 0, 0, 3}, {0, 1, 0, 0}, {0, 0, 1, -1}}},
                        {{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}}},
                        {{{2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 4, 0}}},
                        {{{0, 1, 0, 5}, {-1, 0, 0, 0}, {0, 0, 1, 0}}},
                        {{{0, 1, 0, 5}, {-1, 0, 0, 0}, {0, 0, 1, 0}}}};
    for (const std::uint32_t transform : {0u, 1u, 2u, k_none, 3u, 4u, 3u, 0u})
        scene.add(Disc{}, k_none, transform);
    constexpr std::string_view disc = "disc { center = (0, 0, 0)  normal = (0, 1, 0)  radius = 1";
    std::string expected = "\n";
    for (const auto* more : {"  translate = (3, 0, -1)", "  scale = 2", "  scale = (2, 3, 4)", ""})
        expected += std::string(disc) + more + " }\n";
    expected += "group {\n    matrix = ((0, 1, 0, 5), (-1, 0, 0, 0), (0, 0, 1, 0))\n";
    for (int i = 0; i < 3; ++i) expected += "    " + std::string(disc) + " }\n";
    expected += "}\n" + std::string(disc) + "  translate = (3, 0, -1) }\n";
    expect_part(write_glint(scene).value(), expected);
}

TEST(WriteGlint, ConventionsThatDifferFromTheProfile) {
    Scene scene;
    apply_profile(scene, "epfl");
    scene.conventions.limit = LimitRule::drop;
    scene.conventions.epsilon = 0.01;
    const std::string text = write_glint(scene).value();
    expect_part(text, "\nprofile = epfl\nconventions { epsilon = 0.01  limit = drop }\nrender {");
    scene.profile = "unheard of";
    expect_part(write_glint(scene).value(), "\nprofile = glint\nconventions { offset = normal ");
}

TEST(WriteGlint, LongListsAreBrokenUnlessTheSceneIsLarge) {
    Scene scene;
    for (int i = 0; i < 40; ++i) scene.polygon_vertices.push_back({i * 0.1, 0, 0});
    scene.add(Polygon{0, 40});
    std::istringstream lines(write_glint(scene).value());
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
    for (int i = 0; i < 20000; ++i) scene.add(Polygon{0, 40});
    const std::string text = write_glint(scene).value();
    EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 20020);
}

TEST(WriteGlint, InvalidScenesAreNotWritten) {
    Scene scene;
    scene.add(Sphere{{0, 0, 0}, -1});
    EXPECT_EQ(write_glint(scene).code, ErrorCode::invalid_scene);
    Scene dangling;
    dangling.shapes.push_back({ShapeKind::cone, 7, 8, 9});
    EXPECT_EQ(write_glint(dangling).code, ErrorCode::invalid_scene);
}

}  // namespace
}  // namespace glint::test
