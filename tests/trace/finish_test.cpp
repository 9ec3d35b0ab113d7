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
    scene.add(Plane{{0, 0, -2}, {0.1, 0, 1}}, 2);
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
                ASSERT_EQ(diffuse, ray.hit->diffuse);
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

}  // namespace
}  // namespace glint::test
