// SPDX-License-Identifier: Apache-2.0
// Invalid changes to a World, and invalid rays.
#include <functional>

#include "misuse/misused.h"

namespace glint::test {
namespace {

void expect_error(const Result<World>& result, const char* what) {
    EXPECT_FALSE(result) << what;
    EXPECT_TRUE(result.code == ErrorCode::invalid_argument || result.code == ErrorCode::invalid_scene)
        << what;
    EXPECT_NE(result.message, "") << what;
    EXPECT_EQ(has_errors(result.diagnostics), result.code == ErrorCode::invalid_scene) << what;
    for (const Diagnostic& d : result.diagnostics) EXPECT_FALSE(d.message.empty()) << what;
}

TEST(Misuse, OfColorsOfShapes) {
    Scene scene = some_scene();
    const World world = world_of(scene);
    for (const double odd : k_odd_numbers) {
        scene.shape_colors.clear();
        scene.set_shape_color(1, Color{0.5, odd, 0.5});
        EXPECT_TRUE(scene.shape_colors[1].is_set());
        EXPECT_EQ(scene.shape_color(1)->r, scene.shape_colors[1].color().r);
        expect_error(prepare(scene), "a color");
        expect_error(with_shape_colors(world, scene.shape_colors), "a color");
        World edited = world;
        EXPECT_FALSE(edit_shapes(edited, scene, std::vector<std::uint32_t>{1}));
        with_color(scene.materials[0], {odd, odd, 1});
        Material material;
        material.color.r = material.diffuse.g = odd;
        with_color(material, {1, 0, 0});
    }
    EXPECT_EQ(scene.shape_color(k_none), std::nullopt);
    scene.set_shape_color(1, std::nullopt);
    scene.set_shape_color(k_none, std::nullopt);
    EXPECT_TRUE(prepare(scene));
    expect_error(with_shape_colors(world, std::vector<ShapeColor>(scene.shapes.size() + 1)),
                 "more than shapes");
    expect_error(with_shape_colors(World(), std::vector<ShapeColor>(1)), "more than shapes");
}

TEST(Misuse, OfShading) {
    const Scene scene = some_scene();
    const World world = world_of(scene);
    const Image before = render(world).value().image;
    for (const double odd : k_odd_numbers) {
        Light light;
        light.position.y = odd;
        expect_error(with_lights(world, {&light, 1}), "a light");
        Camera camera = scene.camera;
        camera.position.x = odd;
        expect_error(with_camera(world, camera), "a camera");
        expect_error(with_background(world, {0, odd, 0}), "a background");
        expect_error(with_fog(world, Fog{.density = odd}), "a fog");
        expect_error(with_gradient(world, BackgroundGradient{.top = odd}), "a gradient");
        expect_error(with_occlusion(world, Occlusion{.color = {0, odd, 0}}), "an occlusion");
        Conventions conventions = scene.conventions;
        conventions.epsilon = odd;
        expect_error(with_rules(world, conventions, scene.settings), "a convention");
        Material material;
        material.shininess = odd;
        expect_error(with_material(world, 0, material), "a material");
        const Material materials[] = {{}, material};
        expect_error(with_materials(world, materials), "materials");
    }
    Light light;
    light.kind = beyond<LightKind>();
    expect_error(with_lights(world, {&light, 1}), "a kind of light");
    Camera camera = scene.camera;
    camera.up = {};
    expect_error(with_camera(world, camera), "a camera without up");
    camera = scene.camera;
    camera.projection = beyond<Projection>();
    expect_error(with_camera(world, camera), "a projection");
    for (const std::int32_t size : k_odd_sizes) {
        RenderSettings settings = scene.settings;
        settings.height = size;
        expect_error(with_rules(world, scene.conventions, settings), "a size");
    }
    Conventions conventions = scene.conventions;
    conventions.offset = beyond<Offset>();
    expect_error(with_rules(world, conventions, scene.settings), "an offset");
    for (const std::uint32_t index : {2u, 1000000u, k_none - 1, k_none})
        expect_error(with_material(world, index, Material{}), "an index");
    expect_error(with_materials(world, {}), "too few materials");
    expect_error(with_materials(world, {scene.materials.data(), 1}), "a material too few");
    EXPECT_EQ(render(world).value().image.rgb, before.rgb);
}

TEST(Misuse, OfAssignMaterial) {
    World world = world_of(some_scene());
    const Image before = render(world).value().image;
    const std::uint32_t first[] = {0};
    for (const std::uint32_t index : {2u, 1000000u, k_none - 1})
        EXPECT_EQ(assign_material(world, first, index).code, ErrorCode::invalid_argument) << index;
    for (const std::uint32_t shape : {4u, 1000000u, k_none}) {
        const std::uint32_t shapes[] = {0, shape};
        EXPECT_EQ(assign_material(world, shapes, 1).code, ErrorCode::invalid_argument) << shape;
    }
    EXPECT_TRUE(assign_material(world, {}, 1).ok());
    EXPECT_EQ(render(world).value().image.rgb, before.rgb);
    const std::uint32_t twice[] = {0, 0, 0};
    EXPECT_TRUE(assign_material(world, twice, k_none).ok());
    World empty;
    EXPECT_EQ(assign_material(empty, first, k_none).code, ErrorCode::invalid_argument);
}

TEST(Misuse, OfSpliceShapes) {
    Scene scene = some_scene();
    while (scene.shapes.size() < 40) scene.add(Sphere{{0, 0, -30}, 1});
    const World original = world_of(scene);
    const Image before = render(original).value().image;
    using Shapes = std::vector<std::uint32_t>;
    const auto refused = [&](ErrorCode code, const std::function<void(Scene&)>& edit, const Shapes& removed,
                             const Shapes& added, const char* what) {
        Scene edited = scene;
        edit(edited);
        World world = original;
        const Result<ShapeEdit> result = splice_shapes(world, edited, removed, added);
        EXPECT_EQ(result.code, code) << what;
        EXPECT_NE(result.message, "") << what;
        EXPECT_EQ(render(world).value().image.rgb, before.rgb) << what;
    };
    const auto nothing = [](Scene&) {};
    const auto one_less = [](Scene& s) { s.shapes.pop_back(); };
    for (const std::uint32_t shape : {40u, 1000000u, k_none}) {
        refused(ErrorCode::invalid_argument, one_less, {shape}, {}, "no such shape of the World");
        refused(ErrorCode::invalid_scene, nothing, {1}, {shape}, "no such shape of the scene");
    }
    refused(ErrorCode::invalid_argument, nothing, {1}, {}, "too many shapes");
    refused(ErrorCode::invalid_argument, one_less, {}, {}, "too few shapes");
    refused(ErrorCode::invalid_argument, one_less, {1, 1, 2}, {}, "two removed, one missing");
    refused(
        ErrorCode::invalid_argument, [](Scene& s) { s.shapes.clear(); }, {}, {}, "an empty scene");
    refused(
        ErrorCode::invalid_scene, [](Scene& s) { s.shapes[1].kind = beyond<ShapeKind>(); }, {1}, {1}, "kind");
    refused(
        ErrorCode::invalid_scene, [](Scene& s) { s.shapes[1].index = 99; }, {1}, {1}, "parameters");
    refused(
        ErrorCode::invalid_scene, [](Scene& s) { s.shapes[1].material = 2; }, {1}, {1}, "material");
    refused(
        ErrorCode::invalid_scene, [](Scene& s) { s.shapes[1].transform = 9; }, {1}, {1}, "transform");
    refused(
        ErrorCode::invalid_scene, [](Scene& s) { s.get<Sphere>()[0].radius = k_nan; }, {1}, {1}, "radius");
    refused(
        ErrorCode::invalid_scene,
        [](Scene& s) {
            s.add(Polygon{0, 3});
        },
        {}, {40}, "no vertices");
    refused(
        ErrorCode::invalid_scene, [](Scene& s) { s.add(Mesh{7}); }, {}, {40}, "no mesh");
    World world = original;
    EXPECT_EQ(splice_shapes(world, scene, {}, {}).value(), ShapeEdit::none);
    for (const int threads : {-1, std::numeric_limits<int>::min(), 2000})
        EXPECT_EQ(splice_shapes(world, scene, Shapes{3, 3}, Shapes{3}, {.threads = threads}).value(),
                  ShapeEdit::spliced);
    World empty;
    EXPECT_EQ(splice_shapes(empty, scene, Shapes{0}, {}).code, ErrorCode::invalid_argument);
    EXPECT_EQ(splice_shapes(empty, Scene(), {}, {}).value(), ShapeEdit::none);
}

TEST(Misuse, OfEditShapes) {
    const Scene scene = some_scene();
    World world = world_of(scene);
    const Image before = render(world).value().image;
    const auto refused = [&](const std::function<void(Scene&)>& edit, std::vector<std::uint32_t> changed,
                             const char* what) {
        Scene edited = scene;
        edit(edited);
        const Result<ShapeEdit> result = edit_shapes(world, edited, changed);
        EXPECT_EQ(result.code, ErrorCode::invalid_scene) << what;
        EXPECT_TRUE(has_errors(result.diagnostics)) << what;
        EXPECT_EQ(render(world).value().image.rgb, before.rgb) << what;
    };
    const auto nothing = [](Scene&) {};
    for (const std::uint32_t shape : {4u, 1000000u, k_none}) refused(nothing, {1, shape}, "no such shape");
    refused([](Scene& s) { s.shapes[1].kind = beyond<ShapeKind>(); }, {1}, "kind");
    refused([](Scene& s) { s.shapes[1].index = 99; }, {1}, "parameters");
    refused([](Scene& s) { s.shapes[1].material = 2; }, {1}, "material");
    refused([](Scene& s) { s.shapes[1].transform = 1; }, {1}, "transform");
    refused([](Scene& s) { s.transforms[0] = Affine{{{0}}}; }, {2}, "a transform without an inverse");
    refused([](Scene& s) { s.get<Sphere>()[0].radius = k_nan; }, {1}, "radius");
    refused(
        [](Scene& s) {
            s.add(Sphere{});
            s.get<Sphere>()[2].center.x = k_infinity;
        },
        {}, "a new shape");
    refused([](Scene& s) { s.add(Polygon{0, 3}); }, {}, "a new polygon without vertices");
    // Materials that the World does not have.
    refused(
        [](Scene& s) {
            s.materials.resize(9);
            s.shapes[1].material = 8;
        },
        {1}, "a material of the scene, not of the World");

    const Result<ShapeEdit> none = edit_shapes(world, scene, {});
    EXPECT_EQ(none.value(), ShapeEdit::none);
    const std::uint32_t twice[] = {3, 1, 1, 2, 3};
    for (const int threads : {-1, std::numeric_limits<int>::min(), 2000}) {
        EXPECT_TRUE(edit_shapes(world, scene, twice, {.threads = threads}).ok());
        EXPECT_EQ(render(world).value().image.rgb, before.rgb);
    }
    // Adding shapes to a World without shapes, and removing all of them.
    World empty;
    Scene bare = scene;
    for (Shape& shape : bare.shapes) shape.material = k_none;
    EXPECT_EQ(edit_shapes(empty, bare, {}).value(), ShapeEdit::rebuilt);
    EXPECT_TRUE(edit_shapes(empty, Scene{}, {}).ok());
    EXPECT_EQ(memory_usage(empty).packed, 0u);
    // An explanation of an earlier state of the scene.
    EXPECT_NE(explain(scene, empty, 3, 4).message, "");
}

TEST(Misuse, OfRays) {
    const World world = world_of(some_scene());
    std::vector<Ray> rays;
    const Ray good{{-1, 0, 9}, {0, 0, -1}};
    for (const double odd : {k_nan, k_infinity, -k_infinity, 1e300, 0.0}) {
        for (int field = 0; field < 8; ++field) {
            Ray ray = good;
            double* const numbers[] = {&ray.origin.x,    &ray.origin.y,    &ray.origin.z, &ray.direction.x,
                                       &ray.direction.y, &ray.direction.z, &ray.t_min,    &ray.t_max};
            *numbers[field] = odd;
            rays.push_back(ray);
        }
        rays.push_back({{odd, odd, odd}, {odd, odd, odd}, odd, odd});
        rays.push_back(good);
    }
    rays.push_back({good.origin, good.direction, 5, 1});  // ends before it begins
    for (const int threads : {0, -4, std::numeric_limits<int>::max()}) {
        const std::vector<RayHit> hits = nearest_hits(world, rays, threads).value();
        const std::vector<std::uint8_t> occlusions = occluded(world, rays, threads).value();
        ASSERT_EQ(hits.size(), rays.size());
        ASSERT_EQ(occlusions.size(), rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            EXPECT_TRUE(hits[i].shape == k_none || hits[i].shape < 4) << i;
            EXPECT_LE(occlusions[i], 1) << i;
            if (i % 10 != 9) continue;
            EXPECT_EQ(hits[i].shape, 1u) << i << ": its neighbours are odd, it is not";
        }
        EXPECT_EQ(hits.back().shape, k_none);
        // NaN in its origin or direction hits nothing.
        for (const std::size_t i : {0, 1, 2, 3, 4, 5, 8}) EXPECT_EQ(hits[i].shape, k_none) << i;
    }
    EXPECT_TRUE(nearest_hits(world, {}).value().empty());
    EXPECT_TRUE(occluded(world, {}).value().empty());
}

}  // namespace
}  // namespace glint::test
