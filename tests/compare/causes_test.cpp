// SPDX-License-Identifier: Apache-2.0
// Each classic fault of lighting and tracing, planted in a scene's text, is the first that find_causes()
// names.
#include <cctype>
#include <functional>
#include <iostream>
#include <map>

#include "compare/planted_faults.h"

namespace glint::test {
namespace {

using Edit = std::function<std::string(const std::string&)>;

struct Plant {
    const char* label;
    const char* cause;
    Edit fault;
    Edit both = {};         ///< what the reference needs for the fault to show
    const char* only = "";  ///< in scenes whose text has this
};

Edit key(const char* name, const char* value) {
    return [=](const std::string& text) { return with_key(text, name, value); };
}
Edit exponents(double factor) {
    return [=](const std::string& text) { return scaled_numbers(text, "shininess = ([0-9.]+)", factor); };
}
Edit pattern(const char* what, const char* with) {
    return [=](const std::string& text) { return replaced(text, what, with); };
}

std::string without_specular(const std::string& text) {
    const std::string plain = replaced(text, "specular = [0-9.]+", "specular = 0");
    return std::regex_replace(plain, std::regex("specular_color = \\([^)]*\\)"),
                              "specular_color = (0, 0, 0)");
}

std::string with_other_model(const std::string& text) {
    return text.find("shading = phong") != std::string::npos
               ? replaced(text, "shading = phong", "shading = blinn-phong")
               : replaced(text, "shading = blinn-phong", "shading = phong");
}

// Highlights of intensity 1 whatever the light's: its specular color is multiplied by the intensity.
std::string with_white_highlights(const std::string& text) {
    std::string out = text;
    for (const auto& [intensity, color] : {std::pair{"0\\.6", "1.6666666666666667"}, {"0\\.2", "5"}}) {
        out = std::regex_replace(
            out, std::regex(std::string("(type = (point|directional)[^}]*intensity = ") + intensity + ")"),
            std::string("$1 specular_color = (") + color + ", " + color + ", " + color + ")");
    }
    return out == text ? with_light_words(text, "specular_color = (1, 1, 1)") : out;
}

std::string with_warm_lights(const std::string& text) {
    return with_light_words(text, "color = (1, 0.6, 0.3)");
}
std::string with_green_lights(const std::string& text) {
    return with_light_words(text, "color = (0.4, 1, 0.8)");
}

std::string without_last_light(const std::string& text) {
    const std::size_t at = text.rfind("\nlight");
    return text.substr(0, at) + text.substr(text.find("}\n", at) + 1);
}

// Without shadows the reversed one lights what hung in the dark, and is not the same as none.
std::string with_sun_and_no_shadows(const std::string& text) {
    return replaced(replaced(text, "shadows = true", "shadows = false"), "\nrender",
                    "\nlight { type = directional  to_light = (2, -3, 4)  intensity = 0.4 }\nrender");
}

std::string with_sun_reversed(const std::string& text) {
    std::string out = scaled_numbers(text, "to_light = \\(([-0-9.e]+)", -1);
    out = scaled_numbers(out, "to_light = \\([^,]*, ([-0-9.e]+)", -1);
    return scaled_numbers(out, "to_light = \\([^,]*,[^,]*, ([-0-9.e]+)", -1);
}

std::string with_ambient_per_light(const std::string& text) {
    const std::regex other("type = (point|directional)");
    const auto lights = std::distance(std::sregex_iterator(text.begin(), text.end(), other), {});
    return scaled_numbers(text, "type = ambient  intensity = ([0-9.]+)", static_cast<double>(lights));
}

std::string without_mirrors(const std::string& text) {
    return replaced(text, "reflections = 2", "reflections = 0");
}

const Plant k_plants[] = {
    {"no ambient", "ambient-missing", pattern("\nlight[^{]*\\{ type = ambient[^}]*\\}", "\n")},
    {"no diffuse", "diffuse-missing", pattern("diffuse = [0-9.]+", "diffuse = 0")},
    {"no specular", "specular-missing", without_specular},
    {"exponent x 4", "exponent", exponents(4)},
    {"exponent / 4", "exponent", exponents(0.25)},
    {"exponent x 2", "exponent", exponents(2)},
    {"exponent / 2", "exponent", exponents(0.5)},
    {"other model", "shading-model", with_other_model},
    {"no shadows", "shadows-missing", pattern("shadows = true", "shadows = false")},
    {"acne", "acne", key("epsilon", "0")},
    {"no reflections", "reflections-missing", without_mirrors},
    {"one reflection", "reflections-one-fewer", pattern("reflections = 2", "reflections = 1")},
    {"three reflections", "reflections-one-more", pattern("reflections = 2", "reflections = 3")},
    {"limit drops", "mirror-limit-dark", key("limit", "drop"), pattern("reflections = 2", "reflections = 1")},
    {"mirrors see black", "mirror-miss-black", key("mirror_miss", "black")},
    {"mirrors add", "mirror-added", key("mirror", "add")},
    {"white highlights", "highlight-not-light-color", with_white_highlights},
    {"white lights", "light-color-ignored", pattern("color = \\(1, 0.6, 0.3\\)", "color = (1, 1, 1)"),
     with_warm_lights},
    {"lights of the first channel", "light-color-ignored",
     pattern("color = \\(0.4, 1, 0.8\\)", "color = (0.4, 0.4, 0.4)"), with_green_lights},
    {"half the warm light", "light-intensity", [](const std::string& text) { return with_light(text, 0.5); },
     with_warm_lights},
    {"light from behind", "back-sides-lit", key("clamp_cosines", "false")},
    {"highlights behind", "highlight-behind", key("specular_gate", "false"),
     [](const std::string& text) {  // else they lie in their own shape's shadow, or are too small
         const std::string lit = replaced(text, "shadows = true", "shadows = false");
         return with_key(scaled_numbers(lit, "shininess = ([0-9.]+)", 0.1), "specular_gate", "true");
     }},
    {"not unit", "not-normalized", key("normalize", "false")},
    {"past the light", "shadow-past-light", key("shadow_stops_at_light", "false")},
    {"last light missing", "light-missing", without_last_light},
    {"half the light", "light-intensity", [](const std::string& text) { return with_light(text, 0.5); }},
    {"no attenuation", "attenuation-missing", pattern(" attenuation = \\([^)]*\\)", "")},
    {"sun reversed", "light-direction-reversed", with_sun_reversed, with_sun_and_no_shadows},
    {"ambient per light", "ambient-per-light", with_ambient_per_light},
    {"view along y", "field-of-view", pattern("fov_x", "fov_y"), {}, "fov_x"},
    {"nine samples", "anti-aliasing", pattern("aa = 1", "aa = 3")},
};

class PlantedFaults : public ::testing::TestWithParam<int> {
  protected:
    const TestScene& scene() const { return test_scenes()[GetParam()]; }
};

// What one reference is held against.
struct Batch {
    std::vector<const Plant*> plants;
    std::vector<Image> pictures;
};

TEST_P(PlantedFaults, AreNamedFirst) {
    std::map<std::string, Batch> batches;  // by the reference's text
    for (const Plant& plant : k_plants) {
        if (scene().text.find(plant.only) == std::string::npos) continue;
        const std::string right = plant.both ? plant.both(scene().text) : scene().text;
        Batch& batch = batches[right];
        batch.plants.push_back(&plant);
        batch.pictures.push_back(draw_text(plant.fault(right)));
    }
    for (const auto& [text, batch] : batches) {
        const Scene reference_scene = read_scene(text);
        const Image reference = draw_text(text);
        const auto reports = find_causes(std::span(batch.pictures), reference, &reference_scene);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            const Plant& plant = *batch.plants[i];
            EXPECT_NE(reference.rgb, batch.pictures[i].rgb) << plant.label << ": nothing was planted";
            EXPECT_EQ(first_cause(reports[i]), plant.cause) << plant.label << "\n" << all_causes(reports[i]);
            if (reports[i]->causes.empty()) continue;
            const double explained = reports[i]->causes.front().explained;
            std::cout << plant.label << ": " << first_cause(reports[i]) << " " << 100 * explained << "%\n";
            EXPECT_GT(explained, 0.97) << plant.label;
            EXPECT_FALSE(reports[i]->swapped);
            EXPECT_EQ(reports[i]->scene_from_b, 0.0);
        }
    }
}

std::string test_name(const ::testing::TestParamInfo<int>& scene) {
    std::string name = test_scenes()[scene.param].name;
    std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
    return name;
}
INSTANTIATE_TEST_SUITE_P(Scene, PlantedFaults, ::testing::Range(0, k_scenes_to_test), test_name);

// Another renderer's edges and roundings: nine samples a pixel, and every channel up to 2 off.
TEST(Causes, AreNamedInAPictureThatIsNotGlints) {
    const std::pair<const char*, Edit> faults[] = {
        {"ambient-missing", pattern("\nlight[^{]*\\{ type = ambient[^}]*\\}", "\n")},
        {"shadows-missing", pattern("shadows = true", "shadows = false")},
        {"specular-missing", without_specular},
        {"reflections-missing", without_mirrors},
        {"light-missing", without_last_light}};
    for (const TestScene& scene : scenes_to_test()) {
        const Scene reference_scene = read_scene(scene.text);
        const Image reference = draw_text(scene.text);
        std::vector<Image> pictures;
        std::vector<const char*> planted;
        for (const auto& [cause, fault] : faults) {
            // Small highlights are edges themselves, and lost among them.
            const bool small =
                scene.text.find("shininess = 500") != std::string::npos || scene.name == "epfl/castle.json";
            if (small && std::string(cause) == "specular-missing") continue;
            planted.push_back(cause);
            pictures.push_back(draw_text(replaced(fault(scene.text), "aa = 1", "aa = 3")));
            std::uint32_t state = 1;
            for (float& v : pictures.back().rgb) {
                state = state * 1664525u + 1013904223u;
                v += static_cast<float>(static_cast<int>(state >> 24) % 5 - 2) / 255;
            }
        }
        const auto reports = find_causes(std::span<const Image>(pictures), reference, &reference_scene);
        for (std::size_t i = 0; i < reports.size(); ++i)
            EXPECT_EQ(first_cause(reports[i]), planted[i]) << scene.name << "\n" << all_causes(reports[i]);
    }
}

TEST(Causes, ABlackBackground) {
    for (const char* const name : {"cgfs/three_mirrors.cgfs", "glint/still_life.glint", "nff/pyramid.nff"}) {
        const std::string text = test_scene(name).text;
        const Scene reference_scene = read_scene(text);
        const Image faulty = draw_text(replaced(text, "background = \\([^)]*\\)", "background = (0, 0, 0)"));
        const CauseReport report = find_causes(faulty, draw_text(text), &reference_scene).value();
        EXPECT_EQ(first_cause(report), "background") << name << "\n" << all_causes(report);
    }
}

TEST(Causes, OfAPictureThatTheSceneDraws) {
    const TestScene& scene = test_scenes()[1];
    const Scene reference_scene = read_scene(scene.text);
    const Image reference = draw_text(scene.text);
    const Image faulty = draw_text(replaced(scene.text, "shadows = true", "shadows = false"));
    const CauseReport swapped = find_causes(reference, faulty, &reference_scene).value();
    EXPECT_TRUE(swapped.swapped);
    EXPECT_EQ(first_cause(swapped), "shadows-missing") << all_causes(swapped);

    const CauseReport same = find_causes(reference, reference, &reference_scene).value();
    EXPECT_TRUE(same.causes.empty());
    EXPECT_EQ(same.difference, 0);

    // Another scene altogether: nothing explains it, and the report says that the scene draws neither.
    const Image other = draw_text(test_scenes()[2].text);
    const CauseReport foreign = find_causes(other, reference, &reference_scene).value();
    EXPECT_TRUE(foreign.causes.empty()) << all_causes(foreign);
}

// A scene of code, whose shapes have no material of their own.
TEST(Causes, ReachTheDefaultMaterial) {
    Scene scene;
    scene.settings.width = scene.settings.height = 60;
    scene.add(Sphere{{0, 0, -4}, 1});
    scene.lights.push_back({});
    scene.lights.back().kind = LightKind::ambient;
    scene.lights.push_back({});
    scene.lights.back().position = {3, 4, 0};
    Scene faulty = scene;
    Material material;
    material.diffuse = {0, 0, 0};
    faulty.materials.push_back(material);
    faulty.shapes[0].material = 0;
    const CauseReport report = find_causes(as_file(draw(faulty)), as_file(draw(scene)), &scene).value();
    EXPECT_EQ(first_cause(report), "diffuse-missing") << all_causes(report);
}

TEST(Causes, OfManyPicturesAreThoseOfEach) {
    const TestScene& scene = test_scenes()[0];
    const Scene reference_scene = read_scene(scene.text);
    const Image reference = draw_text(scene.text);
    const std::vector<Image> pictures = {draw_text(replaced(scene.text, "shadows = true", "shadows = false")),
                                         reference, Image{2, 2, std::vector<float>(12)},
                                         draw_text(without_specular(scene.text))};
    const auto reports = find_causes(std::span(pictures), reference, &reference_scene);
    ASSERT_EQ(reports.size(), 4u);
    EXPECT_EQ(first_cause(reports[0]), "shadows-missing");
    EXPECT_TRUE(reports[1]->causes.empty());
    EXPECT_NE(reports[2].message, "");
    EXPECT_EQ(first_cause(reports[3]), "specular-missing");
    const CauseReport alone = find_causes(pictures[3], reference, &reference_scene).value();
    EXPECT_EQ(all_causes(alone), all_causes(reports[3]));
}

TEST(Causes, StopWhenCancelled) {
    const TestScene& scene = test_scenes()[0];
    const Scene reference_scene = read_scene(scene.text);
    const std::atomic<bool> cancel{true};
    CauseOptions options;
    options.cancel = &cancel;
    const Result<CauseReport> report = find_causes(draw_text(without_specular(scene.text)),
                                                   draw_text(scene.text), &reference_scene, options);
    EXPECT_FALSE(report);
    EXPECT_EQ(report.code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace glint::test
