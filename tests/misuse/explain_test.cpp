// SPDX-License-Identifier: Apache-2.0
// explain() and the functions that use its result: with a scene edited after prepare(), and with explanations
// that explain() never returns.
#include <functional>

#include "misuse/misused.h"

namespace glint::test {
namespace {

// The pixel of the glass ball.
constexpr std::int32_t k_x = 10, k_y = 7;

TEST(Misuse, OfExplain) {
    const Scene scene = some_scene();
    const World world = world_of(scene);
    ASSERT_EQ(explain(scene, world, k_x, k_y).message, "");
    for (const std::int32_t odd :
         {-1, 16, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()}) {
        EXPECT_NE(explain(scene, world, odd, 0).message, "") << odd;
        EXPECT_NE(explain(scene, world, 0, odd).message, "") << odd;
    }
    for (const int sample : {1, -2, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()})
        EXPECT_NE(explain(scene, world, k_x, k_y, {sample, ""}).message, "") << sample;
    EXPECT_NE(explain(scene, world, k_x, k_y, {-1, "avx9"}).message, "");
}

// Changes to a scene while a World of it exists.
const std::pair<const char*, std::function<void(Scene&)>> k_edits[] = {
    {"empty", [](Scene& s) { s = {}; }},
    {"moved from", [](Scene& s) { const Scene elsewhere = std::move(s); }},
    {"fewer lights", [](Scene& s) { s.lights.pop_back(); }},
    {"no lights", [](Scene& s) { s.lights.clear(); }},
    {"more lights", [](Scene& s) { s.lights.insert(s.lights.begin(), Light{}); }},
    {"another kind of light", [](Scene& s) { s.lights[1].kind = LightKind::directional; }},
    {"an ambient light more", [](Scene& s) { s.lights[2].kind = LightKind::ambient; }},
    {"fewer shapes", [](Scene& s) { s.shapes.pop_back(); }},
    {"one shape", [](Scene& s) { s.shapes.resize(1); }},
    {"more shapes", [](Scene& s) { s.add(Sphere{}); }},
    {"no materials", [](Scene& s) { s.materials.clear(); }},
    {"more materials", [](Scene& s) { s.materials.insert(s.materials.begin(), Material{}); }},
};

TEST(Misuse, OfASceneEditedSincePrepare) {
    const Scene scene = some_scene();
    const World world = world_of(scene);
    const Explanation good = explain(scene, world, k_x, k_y).value();
    Image drawn = picture(16, 12);
    for (const auto& [what, edit] : k_edits) {
        Scene edited = scene;
        edit(edited);
        for (std::int32_t y = 0; y < 12; ++y)
            for (std::int32_t x = 0; x < 16; ++x) EXPECT_NE(explain(edited, world, x, y).message, "") << what;
        // The explanation has no reference to the world: its indices must exist in the scene, or there is an
        // error.
        const Result<std::string> json = explanation_json(good, edited);
        EXPECT_TRUE(json || json.code == ErrorCode::invalid_argument) << what;
        const Image before = drawn;
        EXPECT_EQ(render_overlay(drawn, good, edited, world).code, ErrorCode::invalid_argument) << what;
        EXPECT_EQ(drawn.rgb, before.rgb) << what;
        for (const ExplainedRay& ray : good.rays) {
            if (!ray.hit) continue;
            material_of(*ray.hit, edited);
            for (const LightTerms& terms : ray.hit->lights) highlight_reason(terms, *ray.hit, edited);
        }
    }
    for (const auto& [what, edit] : {k_edits[0], k_edits[3], k_edits[8]}) {
        Scene edited = scene;
        edit(edited);
        EXPECT_EQ(explanation_json(good, edited).code, ErrorCode::invalid_argument) << what;
    }
    EXPECT_TRUE(render_overlay(drawn, good, scene, world));
}

// Edits that keep every index valid: no error, and no crash.
TEST(Misuse, OfASceneWithOtherValues) {
    Scene scene = some_scene();
    const World world = world_of(scene);
    scene.lights[1].position = {k_nan, k_infinity, 0};
    scene.materials[0].mirror = k_nan;
    scene.camera.position = {k_nan, 0, 0};
    scene.conventions.offset = beyond<Offset>();
    scene.settings.shading = beyond<Shading>();
    scene.settings.samples = 0;
    scene.shapes[0].kind = beyond<ShapeKind>();
    scene.shapes[1].index = k_none;
    const Explanation e = explain(scene, world, k_x, k_y).value();
    EXPECT_TRUE(explanation_json(e, scene));
    Image drawn = picture(16, 12);
    EXPECT_TRUE(render_overlay(drawn, e, scene, world));
}

TEST(Misuse, OfExplanations) {
    const Scene scene = some_scene();
    const World world = world_of(scene);
    const Explanation good = explain(scene, world, k_x, k_y).value();
    ASSERT_GT(good.rays.size(), 2u);
    ASSERT_TRUE(good.rays[0].hit && !good.rays[0].hit->lights.empty());
    const std::pair<const char*, std::function<void(Explanation&)>> edits[] = {
        {"no samples", [](Explanation& e) { e.samples = 0; }},
        {"less than no samples", [](Explanation& e) { e.samples = -2; }},
        {"too many samples", [](Explanation& e) { e.samples = std::numeric_limits<int>::max(); }},
        {"a ray of no sample", [](Explanation& e) { e.rays[1].sample = 1; }},
        {"a ray of a sample below 0", [](Explanation& e) { e.rays[1].sample = -1; }},
        {"its own parent", [](Explanation& e) { e.rays[1].parent = 1; }},
        {"parent beyond", [](Explanation& e) { e.rays[1].parent = std::numeric_limits<int>::max(); }},
        {"shape", [](Explanation& e) { e.rays[0].hit->shape = 4; }},
        {"no shape", [](Explanation& e) { e.rays[0].hit->shape = k_none; }},
        {"material", [](Explanation& e) { e.rays[0].hit->material = 2; }},
        {"light", [](Explanation& e) { e.rays[0].hit->lights[0].light = 9999; }},
        {"blocker", [](Explanation& e) { e.rays[0].hit->lights[0].blocker = Blocker{}; }},
    };
    Image drawn = picture(16, 12);
    for (const auto& [what, edit] : edits) {
        Explanation e = good;
        edit(e);
        EXPECT_EQ(explanation_json(e, scene).code, ErrorCode::invalid_argument) << what;
        EXPECT_EQ(render_overlay(drawn, e, scene, world).code, ErrorCode::invalid_argument) << what;
        for (std::size_t ray = 0; ray < e.rays.size(); ++ray) layer_of(e, ray);
        EXPECT_NE(sample_values(e).code, ErrorCode::internal) << what;
    }
    // Rays with NaN or infinity have no position in a picture.
    Explanation e = good;
    for (ExplainedRay& ray : e.rays) {
        ray.origin = {k_nan, 1e300, -k_infinity};
        ray.direction = {};
        ray.t = k_nan;
        if (ray.hit) ray.hit->point = {k_infinity, k_nan, 1e300};
    }
    EXPECT_TRUE(render_overlay(drawn, e, scene, world));
    EXPECT_TRUE(explanation_json(e, scene));
    e = good;
    e.x = std::numeric_limits<std::int32_t>::max();
    EXPECT_EQ(render_overlay(drawn, e, scene, world).code, ErrorCode::invalid_argument);
    for (Image& odd : misfits())
        EXPECT_EQ(render_overlay(odd, good, scene, world).code, ErrorCode::invalid_argument);
}

TEST(Misuse, OfExplanationJson) {
    const Scene scene = some_scene();
    const Explanation good = explain(scene, world_of(scene), k_x, k_y).value();
    EXPECT_TRUE(explanation_json(good, scene));
    for (const int bits : {0, -8, 7, 32}) {
        EncodeOptions file;
        file.bits = bits;
        EXPECT_EQ(explanation_json(good, scene, file).code, ErrorCode::invalid_argument) << bits;
    }
    EncodeOptions file;
    file.format = beyond<FileFormat>();
    file.transfer = beyond<Transfer>();
    EXPECT_TRUE(explanation_json(good, scene, file));
    EXPECT_TRUE(explanation_json(Explanation{}, Scene{}));
}

TEST(Misuse, OfLayerOf) {
    const Scene scene = some_scene();
    Explanation e = explain(scene, world_of(scene), k_x, k_y).value();
    for (const std::size_t ray : {e.rays.size(), std::size_t{9999}, std::numeric_limits<std::size_t>::max()})
        EXPECT_FALSE(layer_of(e, ray)) << ray;
    EXPECT_FALSE(layer_of(Explanation{}, 0));
    for (ExplainedRay& ray : e.rays) ray.generation = 5;  // a path without a beginning
    for (std::size_t ray = 0; ray < e.rays.size(); ++ray) EXPECT_FALSE(layer_of(e, ray)) << ray;
}

TEST(Misuse, OfSampleValues) {
    const Scene scene = some_scene();
    const Explanation good = explain(scene, world_of(scene), k_x, k_y).value();
    EXPECT_EQ(sample_values(good).value().size(), 1u);
    for (const int samples : {0, -1, 65, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
        Explanation e = good;
        e.samples = samples;
        EXPECT_EQ(sample_values(e).code, ErrorCode::invalid_argument) << samples;
    }
    for (const int sample : {1, -1, std::numeric_limits<int>::max()}) {
        Explanation e = good;
        e.rays[0].sample = sample;
        EXPECT_EQ(sample_values(e).code, ErrorCode::invalid_argument) << sample;
    }
    EXPECT_EQ(sample_values(Explanation{}).value().size(), 1u);
}

TEST(Misuse, OfReasons) {
    EXPECT_EQ(to_string(beyond<LightReason>()), "unknown");
    EXPECT_EQ(to_string(beyond<HighlightReason>()), "unknown");
    EXPECT_EQ(to_string(beyond<SecondaryRayState>()), "unknown");
    LightTerms terms;
    EXPECT_EQ(reason(terms), LightReason::in_surface);
    terms.distance = terms.attenuation = terms.n_l = terms.s = k_nan;
    EXPECT_EQ(reason(terms), LightReason::in_surface);
    terms.light = 9999;
    ExplainedHit hit;
    hit.material = 9999;
    EXPECT_EQ(highlight_reason(terms, hit, Scene{}), HighlightReason::none);
    EXPECT_EQ(material_of(hit, Scene{}).shininess, Material{}.shininess);
    hit.parts[3] = {k_nan, 1e300, 1};
    hit.occlusion.emplace().part = {1, 1e300, 2};
    EXPECT_EQ(hit.own_light().b, 3);
    Material odd;
    odd.filter = odd.transmit = k_nan;
    EXPECT_FALSE(odd.is_transparent());
    EXPECT_FALSE(odd.has_angled_mirror());
}

}  // namespace
}  // namespace glint::test
