// SPDX-License-Identifier: Apache-2.0
// Mistakes of programs that take numbers of another material or light, or shadow rays of another light.
#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/planted_faults.h"
#include "math/transform.h"

namespace glint::test {
namespace {

using SceneChange = std::function<void(Scene&)>;

struct MixedUp {
    const char *cause, *text;  // the text: a part of what is said
    SceneChange change;
    bool mirrors = false;
};

std::string colored_room(bool mirrors) {
    const std::string mirror = mirrors ? "  mirror = 0.35" : "";
    return "background = (0.2, 0.3, 0.5)\n"
           "camera { position = (0.5, 2, 7)  look_at = (0, 0.8, 0)  fov_x = 48 }\n"
           "light { type = ambient  intensity = 0.8 }\n"
           "light { type = point  position = (3, 5, 4)  color = (0.6, 0.5, 0.3) }\n"
           "light { type = point  position = (-4, 4, 5)  color = (0.2, 0.3, 0.4) }\n"
           "light { type = directional  to_light = (0.4, 1, 0.3)  intensity = 0.3 }\n"
           "material red { color = (0.9, 0.2, 0.2)  ambient = 0.2  diffuse = 0.8  specular = 0.5  shininess "
           "= 20 }\n"
           "material blue { color = (0.3, 0.4, 0.8)  ambient = 0.3  diffuse = 0.6  specular = 0.2  shininess "
           "= 80" +
           mirror +
           " }\nmaterial floor { color = (0.6, 0.6, 0.5)  ambient = 0.25  diffuse = 0.7  specular = 0.3  "
           "shininess = 10 }\n"
           "sphere { center = (-1.1, 1, 0)  radius = 1  material = red }\n"
           "sphere { center = (1.2, 0.8, 0.5)  radius = 0.8  material = blue }\n"
           "plane { point = (0, 0, 0)  normal = (0, 1, 0)  material = floor }\n"
           "render { size = 96 x 72  shading = phong  reflections = 2 }\n";
}

std::string colored_table(bool mirrors) {
    const std::string mirror = mirrors ? "  mirror = 0.4" : "";
    return "background = (0.7, 0.7, 0.65)\n"
           "camera { position = (0, 1.5, 8)  look_at = (0, 1, 0)  fov_x = 40 }\n"
           "light { type = ambient  intensity = 1 }\n"
           "light { type = directional  to_light = (-1, 1.5, 1)  color = (0.5, 0.4, 0.3) }\n"
           "light { type = point  position = (4, 5, 4)  color = (0.3, 0.5, 0.4) }\n"
           "material green { color = (0.2, 0.7, 0.3)  ambient = 0.1  diffuse = 0.9  specular_color = (0.3, "
           "0.3, 0.3)  shininess = 12" +
           mirror +
           " }\nmaterial gold { color = (0.8, 0.7, 0.2)  ambient = 0.2  diffuse = 0.5  specular_color = "
           "(0.7, 0.7, 0.7)  "
           "shininess = 50 }\n"
           "material grey { color = (0.5, 0.5, 0.5)  ambient = 0.3  diffuse = 0.8  specular_color = (0.1, "
           "0.1, 0.1)  shininess = 5 }\n"
           "sphere { center = (-1.5, 1, 0.5)  radius = 1  material = green }\n"
           "cylinder { from = (1, 0, 0)  to = (1, 2, 0)  radius = 0.7  material = gold }\n"
           "sphere { center = (2.2, 0.5, 1.5)  radius = 0.5  material = green }\n"
           "plane { point = (0, 0, 0)  normal = (0, 1, 0)  material = grey }\n"
           "render { size = 96 x 72  shading = blinn-phong  reflections = 2 }\n";
}

// Highlights have the surface's color, or are white.
bool has_colored_highlights(const Scene& s) { return s.settings.shading == Shading::phong; }
double k_s(const Scene& s, const Material& m) {
    return has_colored_highlights(s) ? m.specular.r / m.color.r : m.specular.r;
}
Color specular(const Scene& s, const Material& m, double k) {
    return has_colored_highlights(s) ? m.color * k : Color{k, k, k};
}

SceneChange of_materials(void (*change)(const Scene&, Material&)) {
    return [=](Scene& s) {
        for (Material& m : s.materials) change(s, m);
    };
}
SceneChange of_lights(void (*change)(Light&)) {
    return [=](Scene& s) {
        for (Light& light : s.lights) {
            if (!light.is_ambient()) change(light);
        }
    };
}
SceneChange with_material(std::size_t (*of)(const Scene&)) {
    return [=](Scene& s) {
        const auto material = static_cast<std::uint32_t>(of(s));
        for (Shape& shape : s.shapes) shape.material = material;
    };
}
std::size_t first_material(const Scene&) { return 0; }
std::size_t last_material(const Scene& s) { return s.materials.size() - 1; }

const std::vector<MixedUp>& mixed_up() {
    static const std::vector<MixedUp> all = {
        {"material-of-another", "the first material", with_material(first_material)},
        {"material-of-another", "the last material", with_material(last_material)},
        {"material-of-another", "the exponent of the first",
         [](Scene& s) {
             for (std::size_t i = 1; i < s.materials.size(); ++i)
                 s.materials[i].shininess = s.materials[0].shininess;
         }},
        {"material-of-another", "the k_s of the first",
         [](Scene& s) {
             for (std::size_t i = 1; i < s.materials.size(); ++i)
                 s.materials[i].specular = s.materials[0].specular;
         }},
        {"coefficients-exchanged", "k_d and k_s are exchanged", of_materials([](const Scene& s, Material& m) {
             const double k_d = m.diffuse.r / m.color.r;
             m.diffuse = m.color * k_s(s, m);
             m.specular = specular(s, m, k_d);
         })},
        {"coefficients-exchanged", "k_d and k_s are exchanged",
         of_materials([](const Scene&, Material& m) { std::swap(m.diffuse, m.specular); })},
        {"coefficients-exchanged", "diffuse term is multiplied by k_s",
         of_materials([](const Scene& s, Material& m) { m.diffuse = m.color * k_s(s, m); })},
        {"coefficients-exchanged", "specular term is multiplied by k_d",
         of_materials([](const Scene& s, Material& m) {
             const double k_d = m.diffuse.g / m.color.g;
             m.specular = specular(s, m, k_d);
         })},
        {"coefficients-exchanged", "ambient term is multiplied by k_d",
         of_materials([](const Scene&, Material& m) { m.ambient = m.diffuse; })},
        {"coefficients-exchanged", "diffuse term is multiplied by k_a",
         of_materials([](const Scene&, Material& m) { m.diffuse = m.ambient; })},
        {"diffuse-without-color", "not multiplied by the surface's color",
         of_materials([](const Scene&, Material& m) {
             const double k_d = m.diffuse.b / m.color.b;
             m.diffuse = {k_d, k_d, k_d};
         })},
        {"ambient-without-color", "not multiplied by the surface's color",
         of_materials([](const Scene&, Material& m) {
             const double k_a = m.ambient.g / m.color.g;
             m.ambient = {k_a, k_a, k_a};
         })},
        {"light-color-ignored", "diffuse term is not multiplied", of_lights([](Light& l) {
             l.color = {1, 1, 1};
         })},
        {"highlight-not-light-color", "(R.V)^n",
         [](Scene& s) {
             for (Material& m : s.materials) {
                 const double k = k_s(s, m);
                 m.specular = {k, k, k};
             }
             for (Light& light : s.lights) light.specular_color = {1, 1, 1};
         }},
        {"ambient-without-material", "added as it is", of_materials([](const Scene&, Material& m) {
             m.ambient = {1, 1, 1};
         })},
        {"ambient-without-material", "but not by k_a",
         of_materials([](const Scene&, Material& m) { m.ambient = m.color; })},
        {"highlight-of-one-light", "the first light",
         [](Scene& s) {
             for (std::size_t i = 2; i < s.lights.size(); ++i) s.lights[i].specular_color = {0, 0, 0};
         }},
        {"highlight-of-one-light", "the last light",
         [](Scene& s) {
             for (std::size_t i = 1; i + 1 < s.lights.size(); ++i) s.lights[i].specular_color = {0, 0, 0};
         }},
        {"diffuse-of-one-light", "the first light",
         [](Scene& s) {
             for (std::size_t i = 2; i < s.lights.size(); ++i) s.lights[i].color = {0, 0, 0};
         }},
        {"diffuse-without-color", "the largest channel", of_materials([](const Scene&, Material& m) {
             const double most = std::max({m.diffuse.r, m.diffuse.g, m.diffuse.b});
             m.diffuse = {most, most, most};
         })},
        {"light-color-twice", "twice", of_lights([](Light& l) {
             l.color = l.color * l.color;
             l.specular_color = l.specular_color * l.specular_color;
         })},
        {"light-color-ignored", "the lights' green", of_lights([](Light& l) { l.color.b = l.color.g; })},
        {"color-decoded", "of lights", of_lights([](Light& l) {
             for (Color* c : {&l.color, &l.specular_color})
                 *c = {std::pow(c->r, 2.2), std::pow(c->g, 2.2), std::pow(c->b, 2.2)};
         })},
        {"color-decoded", "of materials", of_materials([](const Scene&, Material& m) {
             const Color by{std::pow(m.color.r, 1.2), std::pow(m.color.g, 1.2), std::pow(m.color.b, 1.2)};
             m.ambient = m.ambient * by;
             m.diffuse = m.diffuse * by;
         })},
        {"light-axes-exchanged", "y and z", of_lights([](Light& l) {
             l.position = {l.position.x, l.position.z, l.position.y};
             l.to_light = {l.to_light.x, l.to_light.z, l.to_light.y};
         })},
        {"up-not-orthogonal", "up vector",
         [](Scene& s) {
             const Vec3 forward = normalize(s.camera.look_at - s.camera.position),
                        right = normalize(cross(forward, {0, 1, 0}));
             const double width = 2 * std::tan(s.camera.fov_degrees / 2 * 3.14159265358979323846 / 180);
             s.camera.frame = {right * width, Vec3{0, 1, 0} * (width * 0.75), forward};
         }},
        {"mirror-coefficient", "All shapes are mirrors",
         of_materials([](const Scene& s, Material& m) { m.mirror = k_s(s, m); }), true},
        {"light-of-another", "of the first",
         [](Scene& s) {
             for (std::size_t i = 2; i < s.lights.size(); ++i)
                 s.lights[i].color = s.lights[i].specular_color = s.lights[1].color;
         }},
        {"light-vector", "subtract P", of_lights([](Light& l) {
             if (!l.has_position()) return;
             l.to_light = l.position;
             l.kind = LightKind::directional;
         })},
        {"light-vector", "is subtracted from the direction", of_lights([](Light& l) {
             if (!l.has_direction()) return;
             l.position = l.to_light;
             l.kind = LightKind::point;
         })},
        {"shadows-missing", "Directional lights cast no shadows",
         of_lights([](Light& l) { l.casts_shadows = !l.has_direction(); })},
        {"shadows-missing", "Only directional lights cast shadows",
         of_lights([](Light& l) { l.casts_shadows = l.has_direction(); })},
        {"mirror-weights-exchanged", "(1 - a) local",
         of_materials([](const Scene&, Material& m) { m.mirror = m.mirror > 0 ? 1 - m.mirror : 0; }), true},
        {"mirror-coefficient", "by k_s",
         of_materials([](const Scene& s, Material& m) { m.mirror = m.mirror > 0 ? k_s(s, m) : 0; }), true},
        {"mirror-not-multiplied", "as it is",
         [](Scene& s) {
             s.conventions.mirror = MirrorRule::add;
             for (Material& m : s.materials) m.mirror = m.mirror > 0 ? 1 : 0;
         },
         true},
    };
    return all;
}

bool is_among_first(const CauseReport& report, const MixedUp& plant) {
    for (const Cause& cause : report.causes) {
        if (cause.explained < report.causes[0].explained - 0.001) break;
        if (cause.name == plant.cause && cause.explanation.find(plant.text) != std::string::npos) return true;
    }
    return false;
}

TEST(CausesOfMixedItems, AreNamed) {
    for (const auto& make : {colored_room, colored_table}) {
        for (const MixedUp& plant : mixed_up()) {
            const Scene scene = read_scene(make(plant.mirrors));
            Scene faulty = scene;
            plant.change(faulty);
            const Image wrong = as_file(draw(faulty)), right = as_file(draw(scene));
            ASSERT_NE(wrong.rgb, right.rgb) << plant.text;
            const CauseReport report = *find_causes(wrong, right, &scene);
            ASSERT_FALSE(report.causes.empty()) << plant.cause << ": " << plant.text;
            EXPECT_TRUE(is_among_first(report, plant)) << plant.cause << ": " << plant.text << "\n"
                                                       << all_causes(report);
        }
    }
}

// A picture of the scene with the terms of lights by what is known of their shadows: reaches[i] of light i.
using Rule = std::function<bool(const std::vector<bool>& reaches, std::size_t light)>;
// in_front: light from behind a surface counts as one that reaches it.
Image with_shadow_rule(const Scene& scene, const Rule& rule, double left, double in_shadow,
                       bool in_front = false) {
    // On all sides of white surfaces, or what a light adds.
    const auto only = [&](std::size_t kept, bool shadows, bool all_sides) {
        Scene one = scene;
        one.conventions.clamp_cosines = !all_sides;
        if (all_sides) {
            one.lights[kept].color = {1, 1, 1};
            for (Material& m : one.materials) {
                m.specular = {0, 0, 0};
                m.diffuse = {1, 1, 1};
            }
        }
        for (std::size_t i = 0; i < one.lights.size(); ++i) {
            if (i != kept) one.lights[i].color = one.lights[i].specular_color = {0, 0, 0};
        }
        if (kept > 0) one.background = {0, 0, 0};
        one.settings.shadows = shadows;
        return draw(one);
    };
    Image sum = only(0, true, false);
    std::vector<Image> lit, free, unblocked;
    for (std::size_t i = 1; i < scene.lights.size(); ++i) {
        lit.push_back(only(i, true, true));
        free.push_back(only(i, false, false));
        unblocked.push_back(only(i, false, true));
    }
    for (std::size_t p = 0; p < sum.rgb.size(); p += 3) {
        std::vector<bool> reaches;
        for (std::size_t i = 0; i < lit.size(); ++i)
            reaches.push_back(lit[i].rgb[p] != 0 || (in_front && unblocked[i].rgb[p] < 0));
        for (std::size_t c = p; c < p + 3; ++c) {
            for (std::size_t i = 0; i < lit.size(); ++i)
                sum.rgb[c] += static_cast<float>(rule(reaches, i) ? left : in_shadow) * free[i].rgb[c];
        }
    }
    return as_file(sum);
}

TEST(CausesOfMixedItems, OfShadowRaysAreNamed) {
    struct ShadowCase {
        const char *cause, *text;
        Rule rule;
        double in_shadow = 0;
        bool in_front = false;
    };
    const ShadowCase cases[] = {
        {"shadow-of-another-light", "No light is added where any",
         [](const std::vector<bool>& r, std::size_t) { return std::count(r.begin(), r.end(), false) == 0; }},
        {"shadow-of-another-light", "ends the light of the lights after it",
         [](const std::vector<bool>& r, std::size_t i) {
             return std::count(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(i) + 1, false) == 0;
         }},
        {"shadow-of-another-light", "that is in front of a surface",
         [](const std::vector<bool>& r, std::size_t i) {
             return std::count(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(i) + 1, false) == 0;
         },
         0, true},
        {"shadow-of-another-light", "of the first light counts for all",
         [](const std::vector<bool>& r, std::size_t) { return r[0]; }},
        {"shadow-part", "Half of a light", [](const std::vector<bool>& r, std::size_t i) { return r[i]; },
         0.5},
    };
    for (const auto& make : {colored_room, colored_table}) {
        for (const ShadowCase& c : cases) {
            const Scene scene = read_scene(make(false));
            const Image wrong = with_shadow_rule(scene, c.rule, 1, c.in_shadow, c.in_front),
                        right = as_file(draw(scene));
            const CauseReport report = *find_causes(wrong, right, &scene);
            ASSERT_FALSE(report.causes.empty()) << c.text;
            EXPECT_TRUE(is_among_first(report, {c.cause, c.text, {}})) << c.text << "\n"
                                                                       << all_causes(report);
        }
    }
}

TEST(CausesOfMixedItems, ToneCurvesAndTheGreatestLightAreNamed) {
    for (const auto& make : {colored_room, colored_table}) {
        const Scene scene = read_scene(make(false));
        const Image right = as_file(draw(scene));
        const auto first_of = [&](Image picture) {
            return first_cause(*find_causes(as_file(std::move(picture)), right, &scene));
        };
        Image curved = draw(scene), saturated = curved;
        Scene bright = scene;
        for (Light& light : bright.lights) light.color = light.color * 3;
        Image of_hue = draw(bright);
        for (std::size_t i = 0; i < of_hue.rgb.size(); i += 3) {
            const float most = std::max({of_hue.rgb[i], of_hue.rgb[i + 1], of_hue.rgb[i + 2], 1.0f});
            for (std::size_t c = i; c < i + 3; ++c) of_hue.rgb[c] /= most;
        }
        EXPECT_EQ(first_cause(*find_causes(as_file(of_hue), as_file(draw(bright)), &bright)), "tone-curve");
        for (float& v : curved.rgb) v /= 1 + v;
        for (float& v : saturated.rgb) v = 1 - std::exp(-v);
        EXPECT_EQ(first_of(curved), "tone-curve");
        EXPECT_EQ(first_of(saturated), "tone-curve");
        const auto with_lights = [&](std::size_t kept) {
            Scene one = scene;
            for (std::size_t i = 1; i < one.lights.size(); ++i) {
                if (i != kept) one.lights[i].color = one.lights[i].specular_color = {0, 0, 0};
            }
            return draw(one);
        };
        Image most = with_lights(1);
        for (std::size_t light = 2; light < scene.lights.size(); ++light) {
            const Image other = with_lights(light);
            for (std::size_t i = 0; i < most.rgb.size(); ++i)
                most.rgb[i] = std::max(most.rgb[i], other.rgb[i]);
        }
        EXPECT_EQ(first_of(most), "light-maximum");
    }
}

TEST(CausesOfMixedItems, CopiedAndRepeatedPixelsAreNamed) {
    for (const auto& make : {colored_room, colored_table}) {
        Scene scene = read_scene(make(false));
        scene.shapes.pop_back();  // the floor: the background is seen below, too
        const Image right = as_file(draw(scene));
        const auto first_of = [&](const Image& picture) {
            const CauseReport report = *find_causes(as_file(picture), right, &scene);
            return report.causes.empty() ? "none" : report.causes[0].explanation;
        };
        Image copied = draw(scene), repeated = copied, halved = copied;
        for (std::size_t i = 0; i < copied.rgb.size(); i += 3) copied.rgb[i + 2] = copied.rgb[i + 1];
        EXPECT_NE(first_of(copied).find("copy of green"), std::string::npos);
        for (std::size_t i = 3; i < repeated.rgb.size(); i += 3) {
            if (std::equal(&right.rgb[i], &right.rgb[i] + 3, right.rgb.data()))
                std::copy_n(&repeated.rgb[i - 3], 3, &repeated.rgb[i]);
        }
        EXPECT_NE(first_of(repeated).find("the pixel before it"), std::string::npos) << first_of(repeated);
        for (int y = 0; y < halved.height; ++y) {
            for (int x = 0; x < halved.width; ++x) {
                const auto at = [&](int u, int v) {
                    return static_cast<std::size_t>(3) * (static_cast<std::size_t>(v) * halved.width + u);
                };
                std::copy_n(&halved.rgb[at(x - x % 2, y - y % 2)], 3, &halved.rgb[at(x, y)]);
            }
        }
        EXPECT_NE(first_of(halved).find("2 x 2"), std::string::npos) << first_of(halved);
    }
}

// Near misses: another material than the first and the last, a third of the light in shadow.
TEST(CausesOfMixedItems, AreNotSureWhereTheyAreNot) {
    for (const auto& make : {colored_room, colored_table}) {
        const Scene scene = read_scene(make(false));
        const Image right = as_file(draw(scene));
        Scene middle = scene;
        for (Shape& shape : middle.shapes) shape.material = 1;
        Scene brighter = scene;  // to the power 1.5
        for (Light& light : brighter.lights) {
            for (Color* c : {&light.color, &light.specular_color})
                *c = {std::pow(c->r, 1.5), std::pow(c->g, 1.5), std::pow(c->b, 1.5)};
        }
        const Image pictures[] = {
            as_file(draw(middle)), as_file(draw(brighter)),
            with_shadow_rule(
                scene, [](const std::vector<bool>& r, std::size_t i) { return r[i]; }, 1, 1.0 / 3)};
        for (const Image& picture : pictures) {
            const CauseReport report = *find_causes(picture, right, &scene);
            for (const Cause& cause : report.causes)
                EXPECT_TRUE(cause.perhaps || cause.explained < 0.999) << all_causes(report);
        }
    }
}

}  // namespace
}  // namespace glint::test
