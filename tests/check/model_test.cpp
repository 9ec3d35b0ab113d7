// SPDX-License-Identifier: Apache-2.0
// Exported models: one finding for each kind, and notes where the picture is as it should be.
#include "check/check_text.h"

namespace glint::test {
namespace {

// A grid of spheres in front of the camera, each with its own material; 10 in a row.
std::string atoms(int count, std::string_view name = {}) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += fmt::format("sphere {}{{ center = ({}, {}, 0)  radius = 0.3  color = (0.8, 0.3, 0.{}) }}\n",
                            name.empty() ? "" : fmt::format("\"{}{}\" ", name, i), i % 10 * 0.7 - 3.2,
                            i / 10 * 0.7 - 2.5, i % 9 + 1);
    return text;
}

const std::string k_model = R"(camera { position = (0, 0, 12)  look_at = (0, 0, 0)  fov_x = 50 }
light { type = ambient  intensity = 0.2 }
light { position = (3, 6, 9)  intensity = 0.6 }
)";

std::vector<Finding> notes_of(const std::string& text) {
    const Result<Scene> loaded = load_text(text, "a.glint");
    EXPECT_TRUE(loaded) << messages(loaded);
    return check(loaded.value_or(Scene{})).value();
}

TEST(CheckModels, UnusedMaterialsAreOneNote) {
    std::string text = k_model;
    for (int i = 0; i < 5; ++i) text += fmt::format("material spare{} {{ color = (1, 0, 0) }}\n", i);
    const std::vector<Finding> by_hand = notes_of(text + atoms(60)), model = notes_of(text + atoms(70));
    EXPECT_EQ(ids(by_hand),
              "material-unused@4 material-unused@5 material-unused@6 material-unused@7 "
              "material-unused@8");
    EXPECT_EQ(by_hand[0].diagnostic.severity, Severity::warning);
    ASSERT_EQ(ids(model), "material-unused@4");
    EXPECT_EQ(model[0].diagnostic.severity, Severity::note);
    EXPECT_TRUE(has(to_string(model[0]),
                    "no shape uses material 'spare0' (line 4); and 4 more like it, the next (line 5)"))
        << to_string(model[0]);
}

TEST(CheckModels, HiddenAtomsAreOneNote) {
    std::string text = k_model + atoms(70);
    for (int i = 0; i < 30; ++i)
        text += fmt::format("sphere \"core{}\" {{ center = ({}, {}, 0)  radius = 0.1 }}\n", i,
                            i % 10 * 0.7 - 3.2, i / 10 * 0.7 - 2.5);
    const std::vector<Finding> model = notes_of(text);
    ASSERT_EQ(ids(model), "shape-hidden@74");
    EXPECT_EQ(model[0].diagnostic.severity, Severity::note);
    EXPECT_TRUE(has(to_string(model[0]), "30 of 100 shapes are hidden")) << to_string(model[0]);
    EXPECT_TRUE(has(to_string(model[0]), "'core0' (line 74), sphere 'core1' (line 75) and 28 more"))
        << to_string(model[0]);
}

TEST(CheckModels, ShapesWrittenTwiceAreOneNote) {
    const std::vector<Finding> model = notes_of(k_model + atoms(70) + atoms(7));
    ASSERT_EQ(ids(model), "shape-written-twice@74");
    EXPECT_EQ(model[0].diagnostic.severity, Severity::note);
    EXPECT_TRUE(has(to_string(model[0]), "and so have 6 more shapes, the next sphere 72 (line 75)"))
        << to_string(model[0]);
}

// A mesh of triangles that are smaller than a pixel; `size` is its width.
std::string mesh(double size) {
    std::string text;
    const int side = 60;
    for (int i = 0; i < side * side; ++i) {
        const double step = size / side, x = i % side * step - size / 2, y = i / side * step - size / 2;
        text += fmt::format("triangle {{ vertices = (({0}, {1}, 0), ({2}, {1}, 0), ({0}, {3}, 0)) }}\n", x, y,
                            x + step, y + step);
    }
    return text;
}

TEST(CheckModels, AFineMeshIsNoMistake) {
    const std::string small = "render { size = 40 x 40 }\n";
    EXPECT_EQ(ids(notes_of(small + k_model + mesh(6))), "");
    EXPECT_TRUE(has(ids(notes_of(k_model + mesh(0.02))), "shape-too-small@4"));
}

// Shapes of a declared object have one place in the text.
TEST(CheckModels, MacrosAreComputed) {
    std::string text =
        "camera { location <0, 0, -12> look_at <0, 0, 0> }\nlight_source { <3, 6, -9> rgb 0.6 }\n"
        "#declare Atom = union { sphere { <0, 0, 0>, 0.3 pigment { rgb 0.7 } }\n"
        "  sphere { <0, 0, 0>, 0.1 pigment { rgb 0.5 } } }\n";
    const auto atoms_of = [&](int count) {
        std::string all = text;
        for (int i = 0; i < count; ++i)
            all += fmt::format("object {{ Atom translate <{}, 0, 0> }}\n", i * 0.5 - 4);
        return all;
    };
    EXPECT_EQ(ids_of(atoms_of(15), "a.pov"), "");
    EXPECT_EQ(ids_of(atoms_of(3), "a.pov"), "shape-hidden@4");
}

}  // namespace
}  // namespace glint::test
