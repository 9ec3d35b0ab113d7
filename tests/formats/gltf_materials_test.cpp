// SPDX-License-Identifier: Apache-2.0
// .gltf: materials, textures, colors of vertices, cameras and lights.
#include "formats/gltf/materials.h"
#include "formats/gltf_text.h"
#include "math/elementary.h"

namespace glint::test {
namespace {

constexpr double k_half_turn = 3.14159265358979323846;

Result<Scene> with_material(const std::string& material) {
    return load_text(gltf_square(material).text(), "a.gltf");
}
Material gltf_material(const std::string& text) {
    const Result<Scene> result = with_material(text);
    EXPECT_TRUE(result) << messages(result);
    EXPECT_EQ(messages(result), "");
    return result && !result->materials.empty() ? result->materials[0] : Material{};
}
void expect_gltf_color(Color found, Color expected) {
    EXPECT_NEAR(found.r, expected.r, 1e-12);
    EXPECT_NEAR(found.g, expected.g, 1e-12);
    EXPECT_NEAR(found.b, expected.b, 1e-12);
}

TEST(GltfMaterials, AreThoseOfAPhongModel) {
    const Material plastic = gltf_material(
        R"({"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.4, 0.2, 1], "metallicFactor": 0, "roughnessFactor": 0.5}})");
    expect_gltf_color(plastic.color, {0.8, 0.4, 0.2});
    expect_gltf_color(plastic.ambient, {0.8, 0.4, 0.2});
    expect_gltf_color(plastic.diffuse, {0.8, 0.4, 0.2});
    EXPECT_EQ(plastic.shininess, 2 / 0.0625 - 2);
    expect_gltf_color(plastic.specular, Color{0.04, 0.04, 0.04} * (0.75 * 32 / 8));

    const Material metal = gltf_material(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1], "roughnessFactor": 0.5}})");
    expect_gltf_color(metal.ambient, {1, 0.5, 0});
    expect_gltf_color(metal.diffuse, Color{1, 0.5, 0} * (1.25 / 2));
    expect_gltf_color(metal.specular, {1, 0.5, 0});

    const Material rough = gltf_material("{}");
    EXPECT_EQ(rough.shininess, 0);
    expect_gltf_color(rough.diffuse, {1, 1, 1});
    expect_gltf_color(rough.specular, {0, 0, 0});
    const Material smooth =
        gltf_material(R"({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0}})");
    EXPECT_EQ(smooth.shininess, 10000);
    expect_gltf_color(smooth.specular, {1, 1, 1});
    EXPECT_EQ(quiet_scene(gltf_square().text(), "a.gltf").materials.size(), 1u) << "the default one";
}

TEST(GltfMaterials, AlphaModes) {
    const auto of = [](const std::string& more) {
        return with_material(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.25]})" + more + "}");
    };
    EXPECT_EQ(of("")->materials.at(0).transmit, 0);
    EXPECT_EQ(of(R"(, "alphaMode": "BLEND", "doubleSided": true)")->materials.at(0).transmit, 0.75);
    EXPECT_EQ(of(R"(, "alphaMode": "MASK", "alphaCutoff": 0.2)")->materials.at(0).transmit, 0);
    EXPECT_NE(messages(of(R"(, "alphaMode": "MASK")")).find("no triangles"), std::string::npos)
        << "invisible";
    EXPECT_NE(messages(of(R"(, "alphaMode": "mask")")).find("expected OPAQUE, MASK or BLEND as `alphaMode`"),
              std::string::npos);
}

TEST(GltfMaterials, AreOneSidedUnlessDoubleSided) {
    EXPECT_TRUE(gltf_material("{}").one_sided);
    EXPECT_TRUE(gltf_material(R"({"doubleSided": false})").one_sided);
    EXPECT_FALSE(gltf_material(R"({"doubleSided": true})").one_sided);
    EXPECT_TRUE(quiet_scene(gltf_square().text(), "a.gltf").materials.at(0).one_sided) << "the default one";
    const std::string glass = R"({"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1})";
    EXPECT_TRUE(gltf_material(glass + "}}").one_sided);
    EXPECT_FALSE(gltf_material(glass + R"(, "KHR_materials_volume": {"thicknessFactor": 1}}})").one_sided);
}

TEST(GltfMaterials, Extensions) {
    const auto of = [](const std::string& extensions, const std::string& more = {}) {
        return gltf_material(
            R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1], "metallicFactor": 0, "roughnessFactor": 0.5}, "extensions": {)" +
            extensions + "}" + more + "}");
    };
    expect_gltf_color(of(R"("KHR_materials_emissive_strength": {"emissiveStrength": 3})",
                         R"(, "emissiveFactor": [1, 0.5, 0])")
                          .emission,
                      {3, 1.5, 0});
    const Material unlit = of(R"("KHR_materials_unlit": {})");
    expect_gltf_color(unlit.emission, {0.5, 0.5, 0.5});
    expect_gltf_color(unlit.diffuse, {});
    EXPECT_EQ(of(R"("KHR_materials_transmission": {"transmissionFactor": 0.5})").filter, 0.5);
    const Material glass = of(
        R"("KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_volume": {"thicknessFactor": 1}, "KHR_materials_ior": {"ior": 1.33})");
    EXPECT_EQ(glass.transmission, 1);
    EXPECT_EQ(glass.ior, 1.33);
    expect_gltf_color(of(R"("KHR_materials_ior": {"ior": 3})").specular, Color{0.25, 0.25, 0.25} * 3);
    expect_gltf_color(of(R"("KHR_materials_specular": {"specularFactor": 0})").specular, {});
    const Material glossy = of(
        R"("KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0, 0, 1, 1], "specularFactor": [0.04, 0.04, 0.04], "glossinessFactor": 0.5})");
    expect_gltf_color(glossy.diffuse, {0, 0, 1});
    EXPECT_EQ(glossy.shininess, 30);
}

// Texels of two pictures as PPM; the second one is cut short.
GltfText with_pictures(const std::string& material, const std::string& texels) {
    GltfText file = gltf_square(material);
    const std::string ppm = "P6 2 2 255\n" + texels;
    file.members["images"] = fmt::format(
        R"([{{"uri": "data:image/x-portable-pixmap;base64,{}"}}, {{"uri": "data:;base64,UDY="}}])",
        base64(ppm));
    file.members["textures"] = R"([{"source": 0}, {"source": 1}])";
    return file;
}

TEST(GltfMaterials, HaveTheMeansOfMapsOfMetalAndRoughness) {
    const auto of = [](int texture) {
        return with_pictures(
            fmt::format(
                R"({{"pbrMetallicRoughness": {{"baseColorFactor": [1, 0.5, 0, 1], "roughnessFactor": 0.5, "metallicFactor": 0.5, "metallicRoughnessTexture": {{"index": {}}}}}}})",
                texture),
            // Green: roughness 0.8, blue: metal 0, 0, 0.4 and 0.8.
            std::string("\xff\xcc\x00\x00\xcc\x00\x00\xcc\x66\xff\xcc\xcc", 12));
    };
    const Result<Scene> mean = load_text(of(0).text(), "a.gltf");
    ASSERT_TRUE(mean) << messages(mean);
    EXPECT_NE(messages(mean).find("the mean of its map"), std::string::npos) << messages(mean);
    const Material expected = gltf_material(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1], "roughnessFactor": 0.4, "metallicFactor": 0.15}})");
    const Material& found = mean->materials.at(0);
    EXPECT_NEAR(found.shininess, expected.shininess, 1e-9);
    expect_gltf_color(found.diffuse, expected.diffuse);
    expect_gltf_color(found.specular, expected.specular);

    const Result<Scene> unread = load_text(of(1).text(), "a.gltf");
    ASSERT_TRUE(unread) << messages(unread);
    EXPECT_EQ(unread.diagnostics.size(), 2u) << messages(unread);
    expect_gltf_color(unread->materials.at(0).diffuse, {1, 0.5, 0});
    const Result<Scene> none = load_text(of(2).text(), "a.gltf");
    EXPECT_FALSE(none);
}

TEST(GltfMaterials, MapsThatAreIgnoredAreNamedOnce) {
    const Result<Scene> result = with_material(
        R"({"normalTexture": {"index": 0}, "occlusionTexture": {"index": 0}, "emissiveTexture": {"index": 0}, "emissiveFactor": [1, 1, 1]})");
    ASSERT_TRUE(result);
    for (const char* name : {"normal maps", "occlusion maps", "maps of emission"})
        EXPECT_NE(messages(result).find(name), std::string::npos) << messages(result);
    EXPECT_EQ(result.diagnostics.size(), 3u);
    expect_gltf_color(result->materials.at(0).emission, {});
}

TEST(GltfMaterials, ColorsOfVerticesAreMultipliedByTheFactor) {
    GltfText file =
        gltf_square(R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 1]}, "alphaMode": "BLEND"})");
    const int colors = file.accessor(
        file.view(bytes_of<std::uint8_t>({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 128, 51, 51, 51, 0})), 4,
        5121, "VEC4", ", \"normalized\": true");
    std::string& mesh = file.members["meshes"];
    mesh.insert(mesh.find("\"NORMAL\""), fmt::format("\"COLOR_0\": {}, ", colors));
    const Result<Scene> result = load_text(file.text(), "a.gltf");
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result->meshes.at(0)->colors.values,
              (std::vector<Float3>{{0.5F, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1F, 0.2F, 0.2F}}));
    EXPECT_NE(messages(result).find("glint ignores the alpha of the colors of vertices"), std::string::npos);
}

TEST(GltfMaterials, HighlightsTakeTheColorsOfVerticesOnlyOfMetals) {
    const auto red = [](const std::string& metallic) {
        GltfText file = gltf_square(
            R"({"pbrMetallicRoughness": {"roughnessFactor": 0.5, "metallicFactor": )" + metallic + "}}");
        const int colors = file.floats("VEC3", 4, {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});
        std::string& mesh = file.members["meshes"];
        mesh.insert(mesh.find("\"NORMAL\""), fmt::format("\"COLOR_0\": {}, ", colors));
        return with_color(quiet_scene(file.text(), "a.gltf").materials.at(0), {1, 0, 0});
    };
    const Material plastic = red("0"), metal = red("1"), half = red("0.5");
    const double height = 0.75 * 32 / 8;
    expect_gltf_color(plastic.diffuse, {1, 0, 0});
    expect_gltf_color(plastic.specular, Color{0.04, 0.04, 0.04} * height);
    expect_gltf_color(metal.diffuse, {1.25 / 2, 0, 0});
    expect_gltf_color(metal.specular, {1, 0, 0});
    expect_gltf_color(half.diffuse, {0.5 + 0.5 * 1.25 / 2, 0, 0});
    EXPECT_EQ(half.specular.r, half.specular.b);
}

TEST(GltfCameras, TheFirstOfTheNodesCounts) {
    GltfText file = gltf_square();
    file.members["cameras"] =
        R"([{"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1, "zfar": 9, "znear": 0}},
        {"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}])";
    file.members["nodes"] =
        R"([{"mesh": 0}, {"camera": 1, "translation": [0, 0, 5], "rotation": [0, 1, 0, 1]}, {"camera": 0}])";
    file.members["scenes"] = R"([{"nodes": [0, 1, 2]}])";
    const Scene scene = quiet_scene(file.text(), "a.gltf");
    EXPECT_EQ(scene.camera.position, (Vec3{0, 0, 5}));
    EXPECT_NEAR(scene.camera.look_at.x, -5, 1e-12);
    EXPECT_EQ(scene.camera.fov_axis, FovAxis::y);
    EXPECT_NEAR(scene.camera.fov_degrees, 0.5 * 180 / k_half_turn, 1e-12);
    file.members["scenes"] = R"([{"nodes": [0, 2, 1]}])";
    const Scene other = quiet_scene(file.text(), "a.gltf");
    EXPECT_EQ(other.camera.projection, Projection::orthographic);
    EXPECT_EQ(other.camera.width, 4);
    EXPECT_EQ(other.lights.size(), 3u) << "those of a mesh";
}

TEST(GltfLights, HaveTheirUnits) {
    GltfText file = gltf_square();
    file.members["extensions"] = R"({"KHR_lights_punctual": {"lights": [
        {"type": "directional", "intensity": 3.141592653589793, "color": [1, 0.5, 0]},
        {"type": "spot", "intensity": 6.283185307179586, "name": "lamp", "spot": {"innerConeAngle": 0.5, "outerConeAngle": 0.75}},
        {"type": "point", "range": 9}]}})";
    const auto node = [](int light) {
        return fmt::format(
            R"({{"translation": [1, 2, 3], "scale": [5, 5, 5], "extensions": {{"KHR_lights_punctual": {{"light": {}}}}}}})",
            light);
    };
    file.members["nodes"] = fmt::format(R"([{{"mesh": 0}}, {}, {}, {}])", node(0), node(1), node(2));
    file.members["scenes"] = R"([{"nodes": [0, 1, 2, 3]}])";
    const Scene scene = quiet_scene(file.text(), "a.gltf");
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
    EXPECT_EQ(scene.lights[0].to_light, (Vec3{0, 0, 1}));
    expect_gltf_color(scene.lights[0].color, {1, 0.5, 0});
    EXPECT_EQ(scene.lights[1].kind, LightKind::spot);
    EXPECT_EQ(scene.lights[1].position, (Vec3{1, 2, 3}));
    EXPECT_EQ(scene.lights[1].axis, (Vec3{0, 0, -1}));
    expect_gltf_color(scene.lights[1].color, {2, 2, 2});
    EXPECT_EQ(scene.lights[1].attenuation, (Attenuation{0, 0, 1}));
    EXPECT_NEAR(scene.lights[1].inner_angle, 0.5 * 180 / k_half_turn, 1e-12);
    EXPECT_EQ(scene.light_texts.name(1), "lamp");
    EXPECT_NEAR(scene.lights[2].color.r, 1 / k_half_turn, 1e-15);
    EXPECT_FALSE(scene.conventions.clamp_attenuation);
    file.members["nodes"] = fmt::format(R"([{{"mesh": 0}}, {}])", node(3));
    file.members["scenes"] = R"([{"nodes": [0, 1]}])";
    const Result<Scene> wrong = load_text(file.text(), "a.gltf");
    EXPECT_NE(messages(wrong).find("expected a number of `lights` from 0 to 2, found '3'"), std::string::npos)
        << messages(wrong);
}

TEST(GltfLights, AreMadeWeakerIfAllWouldBeWhite) {
    const auto lights = [](double intensity) {
        GltfText file = gltf_square();
        file.members["extensions"] = fmt::format(
            R"({{"KHR_lights_punctual": {{"lights": [{{"type": "directional", "intensity": {}}}, {{"type": "directional", "intensity": 0}}]}}}})",
            intensity);
        file.members["nodes"] =
            R"([{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}, {"extensions": {"KHR_lights_punctual": {"light": 1}}}])";
        file.members["scenes"] = R"([{"nodes": [0, 1, 2]}])";
        return load_text(file.text(), "a.gltf");
    };
    const Result<Scene> usual = lights(9 * k_half_turn), sun = lights(1000 * k_half_turn);
    ASSERT_TRUE(usual && sun);
    EXPECT_NEAR(usual->lights.at(0).color.r, 9, 1e-12);
    EXPECT_EQ(messages(usual), "");
    EXPECT_NEAR(sun->lights.at(0).color.r, 1, 1e-12);
    EXPECT_EQ(sun->lights.at(1).color.r, 0);
    EXPECT_NE(messages(sun).find("1000 times as bright as white: glint divides all of them by 1000"),
              std::string::npos)
        << messages(sun);
}

}  // namespace
}  // namespace glint::test
