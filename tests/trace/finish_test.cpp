// SPDX-License-Identifier: Apache-2.0
// The fields of materials that a World stores in its second table.
#include <gtest/gtest.h>

#include <bit>

#include "explain/added_up.h"
#include "glint/explain.h"
#include "trace/pictures.h"
#include "world/world.h"

namespace glint::test {
namespace {

// Two balls and a mirror on a floor, one of them in front of a wall that is a mirror.
Scene room() {
    Scene scene;
    set_size(scene, 61, 47);
    scene.camera.position = {0.3, 1.2, 5};
    scene.camera.look_at = {0, 0.6, 0};
    scene.background = {0.1, 0.2, 0.3};
    scene.lights = {ambient_light({0.7, 0.8, 0.9}), point_light({-3, 5, 4}, {0.9, 0.8, 0.7}),
                    point_light({4, 3, 2}, {0.2, 0.3, 0.4})};
    Material ball;
    ball.color = ball.diffuse = {0.7, 0.4, 0.1};
    ball.specular = {0.5, 0.5, 0.5};
    Material plain;
    plain.specular = {0.3, 0.3, 0.3};
    Material mirror = plain;
    mirror.mirror = 0.6;
    mirror.mirror_tint = {0.9, 0.8, 0.7};
    scene.materials = {ball, plain, mirror};
    scene.add(Sphere{{-0.7, 0.7, 0}, 0.7}, 0);
    scene.add(Sphere{{0.9, 0.5, 0.8}, 0.5}, 1);
    scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, 1);
    scene.add(Plane{{0, 0, -2}, {-0.3, 0, 1}}, 2);
    return scene;
}

// The explanation of every third pixel adds up to the picture, to the bit.
void expect_explained(const Scene& scene) {
    const World world = *make_world(scene);
    const Image picture = render_scene(scene);
    for (int y = 0; y < picture.height; y += 2) {
        for (int x = 0; x < picture.width; x += 3) {
            const Explanation e = explain(scene, world, x, y).value();
            float layers[k_light_layers][3];
            add_up(e, layers);
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (int l = 0; l < k_light_layers; ++l) {
                    ASSERT_EQ(layers[l][c], e.layers[l][c]) << x << ',' << y << " layer " << l;
                    sum += e.layers[l][c];
                }
                ASSERT_EQ(std::bit_cast<std::uint32_t>(sum), std::bit_cast<std::uint32_t>(e.value[c]));
                ASSERT_EQ(e.value[c], picture.rgb[3 * static_cast<std::size_t>(y * picture.width + x) +
                                                  static_cast<std::size_t>(c)]);
            }
            for (const ExplainedRay& ray : e.rays) {
                if (!ray.hit) continue;
                Color diffuse, specular;
                for (const LightTerms& terms : ray.hit->lights) {
                    diffuse = diffuse + terms.diffuse;
                    specular = specular + terms.specular;
                }
                ASSERT_EQ(diffuse * ray.hit->outline, ray.hit->diffuse);
                ASSERT_EQ(specular, ray.hit->specular);
            }
        }
    }
}

TEST(ExtendedMaterials, AreStoredOnlyIfUsed) {
    Scene scene = room();
    EXPECT_TRUE(make_world(scene)->parts().extended->empty());
    scene.materials[0].emission = {0, 0.5, 0.25};
    const World world = *make_world(scene);
    ASSERT_EQ(world.parts().extended->size(), 4u * k_extended_values);
    EXPECT_TRUE(world.parts().uses<&Material::emission>());
    EXPECT_EQ((*world.parts().extended)[k_extended_value<&Material::emission> + 1], 0.5);
    EXPECT_EQ((*world.parts().extended)[k_extended_values + k_extended_value<&Material::emission> + 1], 0);
}

TEST(ExtendedMaterials, AreReplaced) {
    const Scene plain = room();
    Scene glowing = room();
    glowing.materials[1].emission = {0.1, 0.3, 0.5};
    const World world = with_material(*make_world(plain), 1, glowing.materials[1]).value();
    expect_same_picture(render_world(world), render_scene(glowing));
    const World back = with_material(world, 1, plain.materials[1]).value();
    expect_same_picture(render_world(back), render_scene(plain));
    expect_same_picture(render_world(*with_materials(back, glowing.materials)), render_scene(glowing));
    EXPECT_TRUE(with_materials(world, plain.materials).value().parts().extended->empty());
}

TEST(Emission, IsALayerOfItsOwn) {
    Scene scene = room();
    const Image without = render_scene(scene);
    scene.materials[0].emission = {0.5, 0.25, 2};
    const Image with = render_scene(scene);
    RenderOptions options;
    options.layers = {Layer::emission, Layer::reflection};
    const Rendering layers = render(*make_world(scene), options).value();
    const std::vector<float>&emission = layers.layers[0].values, &reflection = layers.layers[1].values;
    int direct = 0, mirrored = 0;
    for (std::size_t i = 2; i < emission.size(); i += 3) {
        EXPECT_TRUE(emission[i] == 0 || emission[i] == 2) << emission[i];
        EXPECT_NEAR(with.rgb[i] - without.rgb[i] - emission[i], reflection[i] > 0 ? 2 * 0.6 * 0.7 : 0,
                    reflection[i] > 0 ? 2 * 0.6 * 0.7 + 1e-6 : 1e-6);
        direct += emission[i] > 0;
        mirrored += with.rgb[i] != without.rgb[i] && emission[i] == 0;
    }
    EXPECT_GT(direct, 100);
    EXPECT_GT(mirrored, 10);
    expect_explained(scene);
}

TEST(Emission, IsScaledWithTheSurfacesOwnLight) {
    Scene scene = room();
    scene.materials[2].emission = {0.5, 0.5, 0.5};
    RenderOptions options;
    options.layers = {Layer::emission};
    const Rendering drawn = render(*make_world(scene), options).value();
    EXPECT_EQ(*std::max_element(drawn.layers[0].values.begin(), drawn.layers[0].values.end()),
              float(0.5 * (1 - 0.6)));
    expect_explained(scene);
}

TEST(Emission, IsExplained) {
    Scene scene = room();
    scene.materials[0].emission = {0.5, 0.25, 2};
    const Explanation e = explain(scene, *make_world(scene), 23, 22).value();
    ASSERT_TRUE(e.rays[0].hit);
    EXPECT_EQ(e.rays[0].hit->emission, (Color{0.5, 0.25, 2}));
    EXPECT_EQ(e.rays[0].hit->parts[3], (Color{0.5, 0.25, 2}));
    EXPECT_EQ(e.layers[static_cast<std::size_t>(Layer::emission)][2], 2);
}

// One ball under one light, seen by parallel rays, in front of black.
Scene ball(const Material& material, Vec3 to_light = {0.4, 0.5, 0.7}) {
    Scene scene;
    set_size(scene, 41, 41);
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 0, 5};
    scene.camera.width = 2.1;
    scene.lights = {directional_light(to_light, {1, 0.5, 0.25})};
    scene.add(Sphere{{0, 0, 0}, 1}, add_material(scene, material));
    return scene;
}

Vec3 unit(Vec3 v) { return v * (1 / std::sqrt(dot(v, v))); }

// Compares the ball with terms(N, L, V).
template <class Terms> void expect_ball(const Scene& scene, const Terms& terms) {
    const Vec3 l = unit(scene.lights[0].to_light), v{0, 0, 1};
    int seen = 0;
    expect_picture(render_scene(scene), [&](int i, int j) {
        const double x = (i + 0.5 - 20.5) / 41 * 2.1, y = (20.5 - j - 0.5) / 41 * 2.1, zz = 1 - x * x - y * y;
        if (zz < 1e-6) return Layers{.background = scene.background};
        ++seen;
        return terms(Vec3{x, y, std::sqrt(zz)}, l, v);
    });
    EXPECT_GT(seen, 1000);
}

Material white() {
    Material m;
    m.color = {0.9, 0.5, 0.2};
    m.ambient = {0, 0, 0};
    m.diffuse = {0.5, 0.6, 0.7};
    return m;
}

double power(double s, double n) { return s > 0 ? std::pow(s, n) : 0; }

TEST(Finishes, BrillianceIsAPowerOfTheCosine) {
    for (const double b : {0.0, 0.4, 2.0, 7.5}) {
        Material m = white();
        m.brilliance = b;
        const Scene scene = ball(m);
        expect_ball(scene, [&](Vec3 n, Vec3 l, Vec3) {
            return Layers{.diffuse = m.diffuse * scene.lights[0].color * power(dot(n, l), b)};
        });
    }
}

TEST(Finishes, OutlineDarkensTheEdge) {
    for (const auto& [outline, width] : {std::pair{1.0, 0.0}, {0.4, 0.8}, {0.7, 0.98}, {0.5, 1.0}}) {
        Material m = white();
        m.ambient = {0.1, 0.1, 0.1};
        m.specular = {0.2, 0.3, 0.4};
        m.outline = outline;
        m.outline_width = width;
        Scene scene = ball(m, {0.1, 0.2, 0.9});
        scene.settings.shading = Shading::phong;
        scene.lights.push_back(ambient_light({0.5, 0.5, 0.5}));
        expect_ball(scene, [&, o = outline, w = width](Vec3 n, Vec3 l, Vec3 v) {
            const double edge = 1 - std::pow(1 - dot(n, v) * dot(n, v), 32 * (1 - w)), n_l = dot(n, l);
            const double r_v = dot(n * (2 * n_l) - l, v);
            Layers layers;
            layers.ambient = m.ambient * 0.5;
            layers.diffuse = m.diffuse * scene.lights[0].color * (std::max(n_l, 0.0) * (1 - o + o * edge));
            if (n_l > 0) layers.specular = m.specular * scene.lights[0].color * power(r_v, m.shininess);
            return layers;
        });
    }
}

TEST(Finishes, OutlineDarkensTheSky) {
    Scene scene = ball(white());
    scene.lights.clear();
    scene.occlusion = Occlusion{.samples = 16};
    const Image plain = render_scene(scene);
    Material& m = scene.materials[0];
    m.outline = 0.5;
    m.outline_width = 0.9;
    const World world = *make_world(scene);
    const Image picture = render_world(world);
    int darker = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const Explanation e = explain(scene, world, x, y).value();
            const double factor = e.rays[0].hit ? e.rays[0].hit->outline : 1;
            const auto i = 3 * static_cast<std::size_t>(y * picture.width + x);
            EXPECT_NEAR(picture.rgb[i], plain.rgb[i] * factor, 1e-6);
            darker += factor < 0.6 ? 1 : 0;
        }
    }
    EXPECT_GT(darker, 50);
    expect_explained(scene);
}

TEST(Finishes, OpacityDependsOnTheAngle) {
    Material m = white();
    m.transmit = 0.6;
    m.angled_opacity = true;
    Scene scene = ball(m);
    scene.conventions.transparency = Transparency::blend;
    const World world = *make_world(scene);
    double least = 1, most = 0;
    for (int y = 0; y < scene.settings.height; y += 2) {
        for (int x = 0; x < scene.settings.width; x += 3) {
            const Explanation e = explain(scene, world, x, y).value();
            for (const ExplainedRay& ray : e.rays) {
                if (!ray.hit) continue;
                const Vec3 d = ray.direction;
                const double c = std::abs(dot(ray.hit->normal, d)) / std::sqrt(dot(d, d));
                const double s = 1 + std::cos(3.14159265358979 * 0.6 * c);
                EXPECT_NEAR(ray.hit->opacity, s * s / 4, 1e-9);
                const int straight = ray.hit->transmitted.ray;
                if (straight >= 0) {
                    const Color weight = e.rays[static_cast<std::size_t>(straight)].weight;
                    EXPECT_EQ(ray.weight * ray.hit->through, weight);
                }
                least = std::min(least, ray.hit->opacity);
                most = std::max(most, ray.hit->opacity);
            }
        }
    }
    EXPECT_LT(least, 0.2);
    EXPECT_GT(most, 0.6);
    expect_explained(scene);
}

TEST(Finishes, SecondHighlightIsPhongs) {
    for (const Shading shading : {Shading::phong, Shading::blinn_phong, Shading::diffuse}) {
        Material m = white();
        m.specular = {0.2, 0.3, 0.4};
        m.shininess = 30;
        m.phong = {0.5, 0.1, 0.3};
        m.phong_shininess = 7;
        Scene scene = ball(m);
        scene.settings.shading = shading;
        expect_ball(scene, [&](Vec3 n, Vec3 l, Vec3 v) {
            const double n_l = dot(n, l), r_v = dot(n * (2 * n_l) - l, v), n_h = dot(n, unit(l + v));
            const Color light = scene.lights[0].color;
            Layers layers;
            layers.diffuse = m.diffuse * light * std::max(n_l, 0.0);
            if (n_l > 0 && shading != Shading::diffuse)
                layers.specular = m.specular * light * power(shading == Shading::phong ? r_v : n_h, 30) +
                                  m.phong * light * power(r_v, 7);
            return layers;
        });
    }
}

double reflectance(double cosine) {
    const double a = std::acos(cosine) / (M_PI / 2);
    return std::clamp(0.014567225 / ((a - 1.12) * (a - 1.12)) - 0.011612903, 0.0, 1.0);
}
Color tint_of(const Material& m, double metallic, double cosine) {
    const double part = metallic * (1 - reflectance(cosine));
    return {1 + part * (m.color.r - 1), 1 + part * (m.color.g - 1), 1 + part * (m.color.b - 1)};
}

TEST(Finishes, HighlightsOfMetalsHaveTheirColor) {
    for (const double metallic : {0.3, 1.0}) {
        for (const Vec3 to_light : {Vec3{0.4, 0.5, 0.7}, Vec3{2, 0.5, -1}}) {
            Material m = white();
            m.specular = {0.8, 0.8, 0.8};
            m.shininess = 3;
            m.metallic = metallic;
            const Scene scene = ball(m, to_light);
            expect_ball(scene, [&](Vec3 n, Vec3 l, Vec3 v) {
                const double n_l = dot(n, l);
                Layers layers;
                layers.diffuse = m.diffuse * scene.lights[0].color * std::max(n_l, 0.0);
                if (n_l > 0)
                    layers.specular = m.specular * scene.lights[0].color * power(dot(n, unit(l + v)), 3) *
                                      tint_of(m, metallic, n_l);
                return layers;
            });
        }
    }
}

TEST(Finishes, HighlightMayLeaveOutTheLightsColor) {
    Material m = white();
    m.specular = {0.6, 0.3, 0.1};
    m.shininess = 9;
    m.tinted_highlight = false;
    Scene scene = ball(m);
    scene.lights[0].specular_color = {0, 0, 0};
    expect_ball(scene, [&](Vec3 n, Vec3 l, Vec3 v) {
        Layers layers;
        layers.diffuse = m.diffuse * scene.lights[0].color * std::max(dot(n, l), 0.0);
        if (dot(n, l) > 0) layers.specular = m.specular * power(dot(n, unit(l + v)), 9);
        return layers;
    });
}

TEST(Finishes, MirrorsDependOnTheAngle) {
    for (const MirrorRule rule : {MirrorRule::add, MirrorRule::blend}) {
        Material m = white();
        m.mirror_min = 0.1;
        m.mirror = 0.9;
        m.mirror_falloff = 2.5;
        m.mirror_metallic = 0.7;
        m.mirror_tint = {1, 0.5, 1};
        Scene scene = ball(m);
        scene.conventions.mirror = rule;
        scene.background = {0.4, 0.5, 0.6};  // all that the mirror sees
        expect_ball(scene, [&](Vec3 n, Vec3 l, Vec3 v) {
            const double a = 0.1 + 0.8 * std::pow(1 - dot(n, v), 2.5),
                         own = rule == MirrorRule::add ? 1 : 1 - a;
            return Layers{.diffuse = m.diffuse * scene.lights[0].color * (std::max(dot(n, l), 0.0) * own),
                          .reflected = m.mirror_tint * tint_of(m, 0.7, dot(n, v)) * scene.background * a};
        });
    }
}

TEST(Finishes, MirrorIsExactWithoutFalloff) {
    Scene plain = room(), other = room();
    for (Material& m : other.materials) m.mirror_min = 0.3;
    other.materials[0].mirror_falloff = 2;  // not a mirror along the normal: see below
    other.materials[0].mirror_min = 0;
    expect_same_picture(render_scene(plain), render_scene(other));
    EXPECT_TRUE(make_world(other)->parts().uses<&Material::mirror_falloff>());
}

// A mirror only along the normal, and one only at grazing rays, and the limit.
TEST(Finishes, MirrorOfTheLeastAngle) {
    Material m = white();
    m.diffuse = {0, 0, 0};
    m.mirror_min = 0.8;
    m.mirror_falloff = 1;
    Scene scene = ball(m);
    scene.background = {0.4, 0.5, 0.6};
    expect_ball(scene, [&](Vec3 n, Vec3, Vec3 v) {
        return Layers{.reflected = scene.background * (0.8 * dot(n, v))};
    });
    scene.settings.reflections = 0;
    const Explanation e = explain(scene, *make_world(scene), 20, 20).value();
    EXPECT_EQ(e.rays[0].hit->reflected.state, SecondaryRayState::limit);
    EXPECT_NEAR(e.rays[0].hit->mirror, 0.8, 1e-12);
}

TEST(Finishes, DefaultsGiveTheSameBits) {
    const Scene plain = room();
    Scene other = room();
    Material unused;
    unused.emission = {1, 1, 1};
    unused.brilliance = 2;
    unused.metallic = 1;
    unused.phong = {1, 1, 1};
    unused.tinted_highlight = false;
    unused.mirror = unused.mirror_falloff = unused.mirror_metallic = 1;
    unused.outline = 1;
    other.materials.push_back(unused);
    for (const Shading shading : {Shading::phong, Shading::blinn_phong, Shading::diffuse}) {
        Scene a = plain, b = other;
        a.settings.shading = b.settings.shading = shading;
        expect_same_picture(render_scene(a), render_scene(b));
    }
}

// A light that fades, and a spot: the highlight is not multiplied by their factors.
TEST(Finishes, HighlightsMayIgnoreAttenuation) {
    for (const bool spot : {false, true}) {
        Scene scene = room();
        scene.lights.resize(2);
        Light& light = scene.lights[1];
        light.attenuation = {2, 0.1, 0.1};
        if (spot) {
            light.kind = LightKind::spot;
            light.axis = -light.position;
            light.inner_angle = 2;
            light.outer_angle = 25;
        }
        RenderOptions options;
        options.layers = {Layer::specular, Layer::diffuse};
        const Rendering attenuated = render(*make_world(scene), options).value();
        scene.conventions.attenuate_highlights = false;
        const World world = *make_world(scene);
        const Rendering full = render(world, options).value();
        EXPECT_EQ(attenuated.layers[1].values, full.layers[1].values);
        int brighter = 0;
        for (int y = 0; y < full.image.height; ++y) {
            for (int x = 0; x < full.image.width; ++x) {
                const auto i = 3 * static_cast<std::size_t>(y * full.image.width + x);
                const float now = full.layers[0].values[i], before = attenuated.layers[0].values[i];
                if (before < 1e-3) continue;
                const LightTerms terms = explain(scene, world, x, y).value().rays[0].hit->lights[0];
                EXPECT_NEAR(now * (terms.attenuation * terms.spot), before, 1e-6);
                ++brighter;
            }
        }
        EXPECT_GT(brighter, 20);
        expect_explained(scene);
    }
}

TEST(Finishes, FaintLightsDoNotCount) {
    Scene scene = room();
    scene.lights.resize(2);
    scene.lights[1].attenuation = {0, 0, 0.02};
    const World before = *make_world(scene);
    scene.conventions.light_threshold = 0.9;
    const World world = *make_world(scene);
    const Image picture = render_world(world);
    int faint = 0, lit = 0;
    for (int y = 0; y < picture.height; y += 2) {
        for (int x = 0; x < picture.width; x += 2) {
            const Explanation e = explain(scene, world, x, y).value();
            if (!e.rays[0].hit) continue;
            const LightTerms& terms = e.rays[0].hit->lights[0];
            const LightTerms other = explain(scene, before, x, y).value().rays[0].hit->lights[0];
            const double strength = other.n_l * (other.attenuation * other.spot);
            if (strength > 0.9) {
                EXPECT_EQ(terms.diffuse, other.diffuse);
                EXPECT_EQ(terms.specular, other.specular);
                ++lit;
            } else {
                EXPECT_EQ(terms.diffuse, Color{});
                EXPECT_EQ(terms.specular, Color{});
                EXPECT_TRUE(!(terms.n_l > 0) || reason(terms) == LightReason::faint);
                ++faint;
            }
        }
    }
    EXPECT_GT(faint, 20);
    EXPECT_GT(lit, 20);
}

TEST(Finishes, AreExplained) {
    for (const Shading shading : {Shading::phong, Shading::blinn_phong}) {
        Scene scene = room();
        scene.settings.shading = shading;
        scene.lights[2].attenuation = {0.1, 0.1, 0.1};
        scene.conventions.attenuate_highlights = false;
        scene.conventions.light_threshold = 0.1;
        Material& metal = scene.materials[0];
        metal.emission = {0.1, 0.2, 0};
        metal.brilliance = 2.5;
        metal.metallic = 0.8;
        metal.phong = {0.3, 0.3, 0.2};
        metal.phong_shininess = 5;
        metal.mirror = 0.7;
        metal.mirror_min = 0.1;
        metal.mirror_falloff = 3;
        metal.mirror_metallic = 1;
        scene.materials[1].tinted_highlight = false;
        scene.materials[1].outline = 0.6;
        scene.materials[1].outline_width = 0.9;
        scene.materials[2].brilliance = 0.5;
        expect_explained(scene);
        scene.settings.samples = 2;
        scene.conventions.mirror = MirrorRule::add;
        scene.conventions.clamp_cosines = scene.conventions.specular_gate = false;
        expect_explained(scene);
    }
}

}  // namespace
}  // namespace glint::test
