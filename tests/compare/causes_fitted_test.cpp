// SPDX-License-Identifier: Apache-2.0
// Exponents that are wrong by any factor are named with that factor.
#include "compare/small_scene.h"

namespace glint::test {
namespace {

std::string with_exponents(const std::string& text, double factor) {
    return scaled_numbers(text, "shininess = ([0-9.]+)", factor);
}

// The number before " times", or NaN.
double factor_in(const std::string& explanation) {
    std::smatch match;
    return std::regex_search(explanation, match, std::regex("([0-9.]+) times")) ? std::stod(match[1])
                                                                                : std::nan("");
}

TEST(CausesFitted, TheFactorOfAnExponent) {
    const double factors[] = {1.5, 3, 1.25, 1.0 / 3, 0.7, 6, 1.37};
    for (const TestScene& scene : scenes_to_test()) {
        const Scene reference_scene = read_scene(scene.text);
        std::vector<Image> pictures;
        for (const double factor : factors) pictures.push_back(draw_text(with_exponents(scene.text, factor)));
        const auto reports =
            find_causes(std::span<const Image>(pictures), draw_text(scene.text), &reference_scene);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            ASSERT_EQ(first_cause(reports[i]), "exponent")
                << scene.name << factors[i] << all_causes(reports[i]);
            const Cause& best = reports[i]->causes.front();
            EXPECT_NEAR(factor_in(best.explanation) / factors[i], 1, 0.02)
                << scene.name << factors[i] << best.explanation << best.explained;
        }
    }
}

TEST(CausesFitted, TheFactorBesideTheOtherModel) {
    for (const TestScene& scene : scenes_to_test()) {
        const bool is_phong = scene.text.find("shading = phong") != std::string::npos;
        const std::string other = is_phong ? replaced(scene.text, "shading = phong", "shading = blinn-phong")
                                           : replaced(scene.text, "shading = blinn-phong", "shading = phong");
        const Scene reference_scene = read_scene(scene.text);
        const CauseReport report =
            find_causes(draw_text(with_exponents(other, 3)), draw_text(scene.text), &reference_scene).value();
        ASSERT_EQ(first_cause(report), "shading-model-and-exponent") << scene.name << all_causes(report);
        EXPECT_NEAR(factor_in(report.causes.front().explanation), 3, 0.05) << all_causes(report);
    }
}

// What a file has lost above white is not known without the scene.
TEST(CausesFitted, AFactorOfAllLightIsAboutThat) {
    const std::string text = with_light(test_scenes()[1].text, 2.5);
    const Scene reference_scene = read_scene(text);
    const Image reference = draw_text(text);
    Image faulty = draw(reference_scene);
    for (float& v : faulty.rgb) v *= 0.6f;
    const CauseReport alone = find_causes(as_file(faulty), reference).value();
    ASSERT_EQ(first_cause(alone), "light-intensity") << all_causes(alone);
    EXPECT_NE(alone.causes.front().explanation.find("Everything is about 0."), std::string::npos)
        << all_causes(alone);
    const CauseReport by_scene = find_causes(as_file(faulty), reference, &reference_scene).value();
    ASSERT_EQ(first_cause(by_scene), "light-intensity") << all_causes(by_scene);
    EXPECT_NE(by_scene.causes.front().explanation.find("Everything is 0.6"), std::string::npos)
        << all_causes(by_scene);
}

TEST(CausesFitted, FactorsThatAreNumbersOfTheSceneAreNamed) {
    const std::string text = replaced(k_scene, "intensity = 0.9", "intensity = 0.7");
    const Scene scene = read_scene(text);
    const Image right = as_file(draw(scene));
    const auto first_text = [&](double ambient, double others) {
        Scene faulty = scene;
        for (Light& light : faulty.lights) {
            const double factor = light.is_ambient() ? ambient : others;
            light.color = light.color * factor;
            light.specular_color = light.specular_color * factor;
        }
        const CauseReport report = *find_causes(as_file(draw(faulty)), right, &scene);
        return report.causes.empty() ? "" : report.causes[0].explanation;
    };
    EXPECT_NE(first_text(0.7, 1).find("is its intensity"), std::string::npos) << first_text(0.7, 1);
    EXPECT_NE(first_text(1 / 0.7, 1).find("1 / its intensity"), std::string::npos) << first_text(1 / 0.7, 1);
    EXPECT_NE(first_text(1, 0.5).find("averaged"), std::string::npos) << first_text(1, 0.5);
    // Near misses.
    EXPECT_EQ(first_text(0.75, 1).find("That is"), std::string::npos) << first_text(0.75, 1);
    EXPECT_EQ(first_text(1, 0.55).find("That is"), std::string::npos) << first_text(1, 0.55);
}

}  // namespace
}  // namespace glint::test
