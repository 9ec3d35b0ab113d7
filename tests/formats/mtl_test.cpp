// SPDX-License-Identifier: Apache-2.0
// The materials of .obj files.
#include <fmt/format.h>

#include <map>

#include "formats/mistakes.h"

namespace glint::test {
namespace {

class Libraries : public Sources {
  public:
    Libraries(std::initializer_list<std::pair<const std::string, std::string>> texts) : texts_(texts) {}
    Result<std::string> read(std::string_view name, std::string_view) override {
        opened += std::string(name) + ";";
        const auto found = texts_.find(name);
        if (found != texts_.end()) return found->second;
        return Status{ErrorCode::io, "no such file", {}};
    }
    std::string opened;

  private:
    std::map<std::string, std::string, std::less<>> texts_;
};

const std::string k_triangle_lines = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

// What a material's statements become.
Material material(const std::string& statements) {
    Libraries libraries{{"a.mtl", "newmtl m\n" + statements}};
    const Result<Scene> result =
        load_text("mtllib a.mtl\n" + k_triangle_lines + "usemtl m\nf 1 2 3\n", "a.obj", {}, &libraries);
    EXPECT_TRUE(result) << messages(result);
    EXPECT_EQ(messages(result), "");
    if (!result || result->materials.size() != 1) return {};
    EXPECT_EQ(result->material_texts.name(0), "m");
    EXPECT_EQ(result->shapes.at(0).material, 0u);
    return result->materials[0];
}

// A picture of 2 x 1 texels.
const std::string k_pixels("P6 2 1 255\n\x01\x02\x03\xff\xfe\xfd", 17);

Result<Scene> textured(Libraries& libraries, const std::string& more = {}, const LoadOptions& options = {}) {
    return load_text(
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\nvt 1\nvt 0 1 7\nusemtl m\n"
        "f 1/1 2/2 3/3\n" +
            more,
        "a.obj", options, &libraries);
}

TEST(Mtl, MapsAreTextures) {
    Libraries libraries{{"a.mtl", "newmtl m\nmap_Kd -blendu off -s 2 3 -o 0.5 -clamp on my pixels.ppm\n"},
                        {"my pixels.ppm", k_pixels}};
    const Result<Scene> scene = textured(libraries);
    ASSERT_TRUE(scene) << messages(scene);
    EXPECT_EQ(messages(scene), "");
    ASSERT_EQ(scene->textures.size(), 1u);
    const Texture& t = scene->textures[0];
    EXPECT_EQ(*t.image, (TextureImage{2, 1, false, std::vector<std::uint8_t>{1, 2, 3, 255, 254, 253}}));
    EXPECT_EQ(t.uv_map, (UvMap{{{2, 0, 0.5}, {0, 3, 0}}}));
    EXPECT_EQ(t.wrap_u, TextureWrap::clamp);
    EXPECT_EQ(t.encoding, TextureEncoding::linear);
    EXPECT_EQ(t.file, "my pixels.ppm");
    EXPECT_EQ(scene->materials[0].texture, 0u);
    EXPECT_EQ(scene->materials[0].color, (Color{1, 1, 1}));
    const CornerValues& places = scene->meshes[0]->texture_coordinates;
    EXPECT_EQ(places.values, (std::vector<Float3>{{0.25F, 0.5F, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_TRUE(places.corners.empty());
}

TEST(Mtl, MapsOfOpacityAreTheAlpha) {
    const std::string grey("P5 2 1 255\n\x00\x80", 13);
    Libraries libraries{
        {"a.mtl", "newmtl m\nmap_Kd c.ppm\nmap_d d.pgm\n"}, {"c.ppm", k_pixels}, {"d.pgm", grey}};
    const Result<Scene> both = textured(libraries);
    ASSERT_TRUE(both) << messages(both);
    EXPECT_EQ(*both->textures.at(0).image,
              (TextureImage{2, 1, true, std::vector<std::uint8_t>{1, 2, 3, 0, 255, 254, 253, 128}}));
    EXPECT_TRUE(both->textures[0].has_alpha());
    Libraries alone{{"a.mtl", "newmtl m\nmap_d d.pgm\n"}, {"d.pgm", grey}};
    const Result<Scene> white = textured(alone);
    ASSERT_TRUE(white) << messages(white);
    EXPECT_EQ(*white->textures.at(0).image,
              (TextureImage{2, 1, true, std::vector<std::uint8_t>{255, 255, 255, 0, 255, 255, 255, 128}}));
    Libraries sizes{{"a.mtl", "newmtl m\nmap_Kd c.ppm\nmap_d d.pgm\n"},
                    {"c.ppm", k_pixels},
                    {"d.pgm", std::string("P5 1 1 255\n\x00", 12)}};
    const Result<Scene> other = textured(sizes);
    ASSERT_TRUE(other);
    EXPECT_NE(messages(other).find("expected a picture of the size of map_Kd's"), std::string::npos);
    EXPECT_FALSE(other->textures.at(0).has_alpha());
}

TEST(Mtl, MapsOfOpacityAreMixedOnceWithinTheMemory) {
    const std::string text = "newmtl m\nmap_Kd c.pgm\nmap_d d.pgm\nnewmtl n\nmap_d d.pgm\nmap_Kd c.pgm\n";
    const auto libraries = [&](int side) {
        const std::string grey =
            fmt::format("P5 {} {} 255\n", side, side) +
            std::string(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 'a');
        return Libraries{{"a.mtl", text}, {"c.pgm", grey}, {"d.pgm", grey + " "}};
    };
    Libraries small = libraries(2);
    const Result<Scene> scene = textured(small, "usemtl n\nf 1/1 2/2 3/3\n");
    ASSERT_TRUE(scene) << messages(scene);
    ASSERT_EQ(scene->textures.size(), 2u);
    EXPECT_EQ(scene->textures[0].image, scene->textures[1].image);
    // Two files and their images fit, the third image does not.
    Libraries large = libraries(1024);
    LoadOptions options;
    options.max_memory = 9u << 20;
    const Result<Scene> refused = textured(large, {}, options);
    EXPECT_FALSE(refused);
    EXPECT_NE(messages(refused).find("MiB of memory"), std::string::npos) << messages(refused);
}

TEST(Mtl, MapsThatCannotBeReadAreWarnings) {
    for (const auto& [line, message] : {std::pair{"map_Kd none.ppm", "no such file"},
                                        {"map_Kd a.mtl", "expected the name of a file that ends in `.png`"},
                                        {"map_Kd bad.png", "its surfaces are drawn without it"}}) {
        Libraries libraries{{"a.mtl", "newmtl m\n" + std::string(line) + "\n"}, {"bad.png", "no picture"}};
        const Result<Scene> scene = textured(libraries);
        ASSERT_TRUE(scene) << messages(scene);
        EXPECT_NE(messages(scene).find(message), std::string::npos) << messages(scene);
        EXPECT_TRUE(scene->textures.empty());
        EXPECT_EQ(scene->materials[0].texture, k_none);
    }
    for (const char* line : {"map_Kd", "map_Kd -s x a.png", "map_Kd -clamp", "map_d -o"}) {
        Libraries libraries{{"a.mtl", "newmtl m\n" + std::string(line) + "\n"}};
        const Result<Scene> scene = textured(libraries);
        EXPECT_EQ(scene.code, ErrorCode::parse) << line;
    }
}

TEST(Mtl, ColorsAreCoefficients) {
    const Material m = material("Ka 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\nNs 96\nKe 1 2 3\n");
    EXPECT_EQ(m.ambient, (Color{0.1, 0.2, 0.3}));
    EXPECT_EQ(m.diffuse, (Color{0.4, 0.5, 0.6}));
    EXPECT_EQ(m.color, m.diffuse);
    EXPECT_EQ(m.specular, (Color{0.7, 0.8, 0.9}));
    EXPECT_EQ(m.shininess, 96);
    EXPECT_EQ(m.emission, (Color{1, 2, 3}));
    EXPECT_EQ(m.mirror, 0);
    EXPECT_EQ(m.transmission + m.transmit, 0);
    const Material gray = material("Kd 0.5\n");
    EXPECT_EQ(gray.diffuse, (Color{0.5, 0.5, 0.5}));
    EXPECT_EQ(gray.ambient, gray.diffuse) << "of materials that do not say";
    EXPECT_EQ(material("").diffuse, (Color{0.8, 0.8, 0.8}));
}

TEST(Mtl, IllumChoosesTheModel) {
    const std::string colors = "Ka 0.1 0.1 0.1\nKd 0.4 0.5 0.6\nKs 0.25 0.5 0\nKe 0 0 1\nd 0.75\nNi 1.5\n";
    const auto with = [&](int illum) { return material(colors + "illum " + std::to_string(illum) + "\n"); };
    const Material color_only = with(0);
    EXPECT_EQ(color_only.emission, (Color{0.4, 0.5, 1.6}));
    EXPECT_EQ(color_only.diffuse, (Color{}));
    EXPECT_EQ(color_only.ambient, (Color{}));
    EXPECT_EQ(color_only.specular, (Color{}));
    EXPECT_EQ(with(1).specular, (Color{}));
    EXPECT_EQ(with(1).diffuse, (Color{0.4, 0.5, 0.6}));
    EXPECT_EQ(with(2).specular, (Color{0.25, 0.5, 0}));
    for (int illum = 0; illum <= 10; ++illum) {
        const Material m = with(illum);
        const bool is_mirror = illum >= 3 && illum <= 9;
        const bool is_glass = illum == 4 || illum == 6 || illum == 7 || illum == 9;
        EXPECT_EQ(m.mirror, is_mirror ? 0.5 : 0) << illum;
        EXPECT_EQ(m.mirror_tint, is_mirror ? Color({0.5, 1, 0}) : Color({1, 1, 1})) << illum;
        EXPECT_EQ(m.transmission, is_glass ? 0.25 : 0) << illum;
        EXPECT_EQ(m.ior, is_glass ? 1.5 : 1) << illum;
        EXPECT_EQ(m.transmit, is_glass ? 0 : 0.25) << illum;
    }
    EXPECT_EQ(material("Ks 4 2 0\nillum 3\n").mirror, 1);
    EXPECT_EQ(material("Tr 0.3\n").transmit, 0.3);
    EXPECT_EQ(material("d 1\nTr 1\n").transmit, 0) << "d counts";
    EXPECT_EQ(material("d 0.5\nillum 4\nNi 0\n").ior, 1);
}

TEST(Mtl, AShapeForEachMaterial) {
    Libraries libraries{{"a.mtl", "# two\nnewmtl red\nKd 1 0 0\nnewmtl dark blue\nKd 0 0 0.1\n"},
                        {"my own.mtl", "newmtl green\r\nKd 0 1 0\r\n"}};
    const std::string text =
        "mtllib a.mtl my own.mtl\nmtllib a.mtl\n" + k_triangle_lines +
        "f 1 2 3\nusemtl dark blue\nf 2 3 4\nusemtl green\nf 1 3 4\nusemtl dark blue\nf 1 2 4\n";
    const Result<Scene> result = load_text(text, "a.obj", {}, &libraries);
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(messages(result), "");
    EXPECT_EQ(libraries.opened, "a.mtl;my own.mtl;");
    const Scene& scene = *result;
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.shapes[0].material, k_none);
    ASSERT_EQ(scene.materials.size(), 2u) << "only those that are used";
    EXPECT_EQ(scene.materials[scene.shapes[1].material].diffuse, (Color{0, 0, 0.1}));
    EXPECT_EQ(scene.materials[scene.shapes[2].material].diffuse, (Color{0, 1, 0}));
    EXPECT_EQ(scene.material_texts.place(0).line, 4u);
    EXPECT_EQ(scene.meshes[1]->triangles.size(), 2u);
    EXPECT_EQ(scene.meshes[2]->single_positions, (std::vector<Float3>{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}))
        << "the vertices that it uses";
    EXPECT_EQ(scene.lights.at(0).color, (Color{0.1, 0.1, 0.1})) << "ambient";
}

TEST(Mtl, SmoothingGroupsGoAcrossMaterials) {
    Libraries libraries{{"a.mtl", "newmtl red\nnewmtl green\n"}};
    const Result<Scene> result =
        load_text("mtllib a.mtl\n" + k_triangle_lines + "s 1\nusemtl red\nf 1 2 3\nusemtl green\nf 1 3 4\n",
                  "a.obj", {}, &libraries);
    ASSERT_TRUE(result) << messages(result);
    const auto first = result->meshes.at(0)->corner_normals(0),
               second = result->meshes.at(1)->corner_normals(0);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->at(0), second->at(0));
    EXPECT_GT(first->at(0).x, 0);
    EXPECT_GT(first->at(0).z, 0);
}

TEST(Mtl, WhatIsMissingIsAWarning) {
    const std::string faces = k_triangle_lines + "usemtl red\nf 1 2 3\nusemtl green\nf 1 3 4\n";
    const Result<Scene> alone = load_text("mtllib a.mtl\n" + faces, "a.obj");
    ASSERT_TRUE(alone);
    EXPECT_NE(messages(alone).find("a.obj:1:8: warning: 'a.mtl': this text cannot refer to others"),
              std::string::npos)
        << messages(alone);
    Libraries libraries{{"b.mtl", "newmtl red\n"}};
    const Result<Scene> missing = load_text("mtllib a.mtl\n" + faces, "a.obj", {}, &libraries);
    ASSERT_TRUE(missing) << messages(missing);
    ASSERT_EQ(missing.diagnostics.size(), 1u);
    EXPECT_NE(messages(missing).find("'a.mtl': no such file; "), std::string::npos) << messages(missing);
    EXPECT_EQ(missing->lights.at(0).color, (Color{1, 1, 1}));
    const Result<Scene> undefined = load_text("mtllib b.mtl\n" + faces, "a.obj", {}, &libraries);
    ASSERT_TRUE(undefined);
    EXPECT_NE(messages(undefined).find("a.obj:8:8: warning: no .mtl has the material 'green':"),
              std::string::npos)
        << messages(undefined);
    const Result<Scene> none = load_text(faces, "a.obj");
    EXPECT_NE(messages(none).find("a.obj:5:8: warning: no .mtl has the material 'red', and 1 others"),
              std::string::npos)
        << messages(none);
    const Result<Scene> other = load_text("mtllib /etc/hosts\n" + faces, "a.obj", {}, &libraries);
    EXPECT_NE(messages(other).find(
                  "a.obj:1:8: warning: '/etc/hosts': expected the name of a file that ends in .mtl"),
              std::string::npos);
    EXPECT_EQ(libraries.opened, "a.mtl;b.mtl;") << "no other file is opened";
    Libraries many{};
    std::string names = "mtllib";
    for (int i = 0; i < 1500; ++i) names += " " + std::to_string(i) + ".mtl";
    EXPECT_TRUE(load_text(names + "\n" + faces, "a.obj", {}, &many));
    EXPECT_EQ(std::count(many.opened.begin(), many.opened.end(), ';'), 1000);
}

TEST(Mtl, WhatIsNotDrawnIsNamedOnce) {
    Libraries libraries(
        {{"a.mtl",
          "newmtl m\nmap_Ks a.png\nbump b.png\nTf 1 1 1\nTf 1 0 0\nPr 0.5\nPm 1\nKd spectral a.rfl\n"}});
    const Result<Scene> result =
        load_text("mtllib a.mtl\n" + k_triangle_lines + "usemtl m\nf 1 2 3\n", "a.obj", {}, &libraries);
    ASSERT_TRUE(result) << messages(result);
    ASSERT_EQ(result.diagnostics.size(), 4u) << messages(result);
    EXPECT_NE(messages(result).find("a.mtl:2:1: warning: glint ignores 'map_Ks'"), std::string::npos);
    EXPECT_NE(messages(result).find("glint ignores `Tf`"), std::string::npos);
    EXPECT_NE(messages(result).find("a.mtl:6:1: warning: glint ignores 'Pr'"), std::string::npos);
    EXPECT_NE(messages(result).find("r, g, b only"), std::string::npos);
}

TEST(Mtl, MistakesAreReportedAtTheirPlace) {
    const auto expect_error = [](const std::string& library, const std::string& message) {
        Libraries libraries{{"a.mtl", library}};
        const Result<Scene> result =
            load_text("mtllib a.mtl\n" + k_triangle_lines + "usemtl m\nf 1 2 3\n", "a.obj", {}, &libraries);
        EXPECT_FALSE(result);
        EXPECT_NE(messages(result).find(message), std::string::npos) << messages(result);
    };
    expect_error("Kd 1 1 1\n", "a.mtl:1:1: error: expected `newmtl`, found 'Kd'");
    expect_error("newmtl\n", "a.mtl:1:7: error: the line ends here: expected the name of the material");
    expect_error("newmtl m\nKd 1 1\n",
                 "a.mtl:2:7: error: the line ends here: expected a number from 0 to 1e6");
    expect_error("newmtl m\nKd 1 x 1\n", "a.mtl:2:6: error: expected a number from 0 to 1e6, found 'x'");
    expect_error("newmtl m\nKd nan\n", "a.mtl:2:4: error: expected a number from 0 to 1e6, found 'nan'");
    expect_error("newmtl m\nd 1.5\n", "a.mtl:2:3: error: expected a number from 0 to 1, found '1.5'");
    expect_error("newmtl m\nNs -1\n", "a.mtl:2:4: error: expected a number from 0 to 1e9");
    expect_error("newmtl m\nillum 11\n", "a.mtl:2:7: error: expected a whole number from 0 to 10");
    expect_error("newmtl m\nillum 1.5\n",
                 "a.mtl:2:7: error: expected a whole number from 0 to 10, found '1.5'");
}

TEST(Mtl, AMeshBlockHasItsOwnMaterial) {
    Libraries sources{{"two.obj", "mtllib a.mtl\n" + k_triangle_lines +
                                      "usemtl red\nf 1 2 3\nusemtl green\ns 1\nf 1 3 4\n"},
                      {"a.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n"},
                      {"b.stl",
                       "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 "
                       "endloop endfacet endsolid\n"}};
    const std::string camera = "camera { position = (0, 0, 9)  look_at = (0, 0, 0) }\n";
    const Result<Scene> block = load_text(camera +
                                              "mesh { file = \"two.obj\"  color = (0, 0, 1) }\nmesh { file = "
                                              "\"two.obj\" }\nmesh { file = \"b.stl\" }\n",
                                          "a.glint", {}, &sources);
    ASSERT_TRUE(block) << messages(block);
    EXPECT_EQ(messages(block).find("warning: 'a.mtl'"), std::string::npos);
    ASSERT_EQ(block->shapes.size(), 3u);
    ASSERT_EQ(block->meshes.size(), 2u);
    EXPECT_EQ(block->meshes[0]->triangles.size(), 2u) << "one mesh of all parts";
    EXPECT_TRUE(block->meshes[0]->corner_normals(1));
    EXPECT_EQ(block->materials.at(block->shapes[0].material).color, (Color{0, 0, 1}));
    EXPECT_EQ(sources.opened, "two.obj;b.stl;") << "no materials";

    const Result<Scene> included = load_text(camera + "include \"two.obj\"\n", "a.glint", {}, &sources);
    ASSERT_TRUE(included) << messages(included);
    ASSERT_EQ(included->shapes.size(), 2u) << "include keeps the materials";
    EXPECT_EQ(included->materials.at(included->shapes[1].material).diffuse, (Color{0, 1, 0}));
    EXPECT_TRUE(included->lights.empty());
}

}  // namespace
}  // namespace glint::test
