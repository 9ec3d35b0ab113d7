// SPDX-License-Identifier: Apache-2.0
// Tachyon's scenes, object by object.
#include "formats/mistakes.h"

namespace glint::test {
namespace {

#define DAT_BEGIN "Begin_Scene\nResolution 40 20\n"
#define DAT_CAMERA                                                                                \
    "Camera Zoom 2 Aspectratio 1 Antialiasing 0 Raydepth 5 Center 1 2 3 Viewdir 0 0 4 Updir 0 2 " \
    "0 End_Camera\n"
#define DAT_LIGHT "Directional_Light Direction 0 0 1 Color 1 1 1\n"
#define DAT_TEXTURE                                                                                  \
    "Texture Ambient 0.5 Diffuse 0.25 Specular 0 Opacity 1 Phong Plastic 0.5 Phong_size 20 Color 1 " \
    "0.5 0 TexFunc 0\n"
#define DAT_SPHERE "Sphere Center 0 0 9 Rad 2 " DAT_TEXTURE
#define DAT_SCENE DAT_BEGIN DAT_CAMERA DAT_LIGHT DAT_SPHERE

Scene dat_scene(const std::string& text) { return quiet_scene(text, "a.dat"); }
Result<Scene> warned_dat_scene(const std::string& text, const std::string& warning) {
    Result<Scene> result = load_text(text, "a.dat");
    EXPECT_TRUE(result) << messages(result);
    EXPECT_NE(messages(result).find(warning), std::string::npos) << messages(result);
    return result;
}

void expect_dat_warning(const std::string& text, const std::string& warning) {
    static_cast<void>(warned_dat_scene(text, warning));
}

TEST(Tachyon, ReadsTheCamera) {
    const Scene s = dat_scene(DAT_SCENE "End_Scene\nwhat follows is not read");
    EXPECT_EQ(s.profile, "tachyon");
    EXPECT_EQ(s.settings.width, 40);
    EXPECT_EQ(s.settings.height, 20);
    EXPECT_EQ(s.settings.reflections, 4) << "Raydepth counts the camera's ray";
    EXPECT_EQ(s.settings.samples, 1);
    EXPECT_EQ(s.camera.position, (Vec3{1, 2, 3}));
    ASSERT_TRUE(s.camera.frame);
    EXPECT_EQ(s.camera.frame->forward, (Vec3{0.0125, 0.0125, 1})) << "half a pixel to the right and up";
    EXPECT_EQ(s.camera.frame->right, (Vec3{1, 0, 0})) << "left-handed; twice as wide as high";
    EXPECT_EQ(s.camera.frame->up, (Vec3{0, 0.5, 0}));
    EXPECT_EQ(s.camera_place.line, 3u);
}

TEST(Tachyon, TheFrameHasThePicturesProportions) {
    LoadOptions options;
    options.settings = {{"size", "30x30"}};
    const Result<Scene> s = load_text(DAT_SCENE, "a.dat", options);
    ASSERT_TRUE(s);
    EXPECT_EQ(s->camera.frame->right, (Vec3{0.5, 0, 0}));
    EXPECT_EQ(s->camera.frame->up, (Vec3{0, 0.5, 0}));
}

TEST(Tachyon, AspectRatioDividesTheWidth) {
    const Scene s =
        dat_scene(DAT_BEGIN
                  "camera projection orthographic zoom 0.5 aspectratio 2 antialiasing 3 raydepth 1 "
                  "center 0 0 0 viewdir 0 0 1 updir 0 1 0 end_camera " DAT_LIGHT DAT_SPHERE);
    EXPECT_EQ(s.camera.projection, Projection::orthographic);
    EXPECT_EQ(s.camera.position, (Vec3{0.025, 0.05, 0}));
    EXPECT_EQ(s.camera.frame->forward, (Vec3{0, 0, 1}));
    EXPECT_EQ(s.camera.frame->right, (Vec3{2, 0, 0}));
    EXPECT_EQ(s.camera.frame->up, (Vec3{0, 2, 0}));
    EXPECT_EQ(s.settings.samples, 2) << "one sample and three more";
    EXPECT_EQ(s.settings.reflections, 0);
}

// Left, right, bottom and top at distance 1; Zoom does not count.
TEST(Tachyon, ReadsAFrustum) {
    const auto scene = [](const std::string& projection, const std::string& frustum) {
        return dat_scene(
            DAT_BEGIN "Camera " + projection +
            "Zoom 2 Aspectratio 1 Antialiasing 0 Raydepth 5 Center 0 0 0 Viewdir 0 0 4 Updir 0 2 0 "
            "Frustum " +
            frustum + " End_Camera " DAT_LIGHT DAT_SPHERE);
    };
    const Scene s = scene("", "-1 3 -0.5 0.5");
    EXPECT_EQ(s.camera.frame->right, (Vec3{4, 0, 0}));
    EXPECT_EQ(s.camera.frame->up, (Vec3{0, 1, 0}));
    EXPECT_EQ(s.camera.frame->forward, (Vec3{1.05, 0.025, 1})) << "its middle, and half a pixel";
    EXPECT_EQ(scene("Projection Orthographic ", "-1 3 -0.5 0.5").camera.position, (Vec3{1.05, 0.025, 0}));
}

TEST(Tachyon, FiveSamplesNeedAGridOfNine) {
    const Scene s =
        dat_scene(DAT_BEGIN
                  "Camera Zoom 1 Aspectratio 1 Antialiasing 4 Raydepth 0 Center 0 0 0 Viewdir 0 0 1 "
                  "Updir 0 1 0 End_Camera " DAT_LIGHT DAT_SPHERE);
    EXPECT_EQ(s.settings.samples, 3);
    EXPECT_EQ(s.origins[*find_setting("aa")].kind, SettingOrigin::Kind::file);
    EXPECT_EQ(s.settings.reflections, 0);
}

TEST(Tachyon, ReadsTextures) {
    const Scene s =
        dat_scene(DAT_SCENE
                  "TexDef Red Ambient 0.1 Diffuse 1 Specular 0.25 Opacity 1 Color 1 0 0 TexFunc 0\n"
                  "TexAlias other Red\n"
                  "Sphere Center 0 0 9 Rad 1 Red Sphere Center 0 0 8 Rad 1 other " DAT_SPHERE);
    ASSERT_EQ(s.materials.size(), 2u) << "a repeated body is the same material";
    const Material& m = s.materials[0];
    EXPECT_EQ(m.color, (Color{1, 0.5, 0}));
    EXPECT_EQ(m.ambient, (Color{0.5, 0.25, 0}));
    EXPECT_EQ(m.diffuse, (Color{0.25, 0.125, 0}));
    EXPECT_EQ(m.specular, (Color{0.5, 0.5, 0.5}));
    EXPECT_EQ(m.shininess, 20);
    EXPECT_EQ(m.mirror, 0);
    EXPECT_EQ(s.materials[1].mirror, 0.25);
    EXPECT_EQ(s.materials[1].specular, (Color{0, 0, 0}));
    EXPECT_EQ(s.material_texts.name(1), "Red");
    EXPECT_EQ(s.shapes[1].material, 1u);
    EXPECT_EQ(s.shapes[2].material, 1u);
    EXPECT_EQ(s.shapes[3].material, 0u);
    EXPECT_EQ(s.material_texts.place(0).line, 5u);
}

TEST(Tachyon, ARepeatedBodyMayHaveOtherBlanks) {
    const Scene s = dat_scene(DAT_BEGIN DAT_CAMERA DAT_LIGHT DAT_SPHERE
                              "Sphere Center 0 0 9 Rad 2\n\n" DAT_TEXTURE
                              "Sphere Center 0 0 9 Rad 2 TEXTURE ambient 0.5\ndiffuse "
                              "0.25 Specular 0 Opacity 1.0 Phong Plastic .5 Phong_size 2e1 "
                              "Color 1 0.5 0 TexFunc 0\nSphere Center 0 0 9 Rad 2 Texture "
                              "ambient 0.5\ndiffuse "
                              "0.25 Specular 0 Opacity 1.0 Phong Plastic .5 Phong_size 2e1 "
                              "Color 1 0.5 0 TexFunc 0\n" DAT_SPHERE);
    EXPECT_EQ(s.materials.size(), 1u);
    ASSERT_EQ(s.shapes.size(), 5u);
    EXPECT_EQ(s.shape_texts.place(2).line, 9u);
    EXPECT_EQ(s.shape_texts.place(3).line, 11u);
    EXPECT_EQ(s.shape_texts.place(4).line, 13u);
}

TEST(Tachyon, AmbientNeedsALight) {
    const Scene s = dat_scene(DAT_SCENE);
    ASSERT_EQ(s.lights.size(), 2u);
    EXPECT_EQ(s.lights[0].kind, LightKind::directional);
    EXPECT_EQ(s.lights[0].to_light, (Vec3{0, 0, -1}));
    EXPECT_EQ(s.lights[1].kind, LightKind::ambient);
    EXPECT_EQ(s.lights[1].color, (Color{1, 1, 1}));
}

TEST(Tachyon, ALightIsASphere) {
    const Scene s = dat_scene(DAT_BEGIN DAT_CAMERA "Light Center 1 2 3 Rad 0.5 Color 1 0.5 0\n" DAT_SPHERE
                                                   "Light Center 1 2 3 Rad 0 Color 1 1 1");
    ASSERT_EQ(s.lights.size(), 3u);
    EXPECT_EQ(s.lights[0].position, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.lights[0].color, (Color{1, 0.5, 0}));
    ASSERT_EQ(s.shapes.size(), 2u) << "a light of no radius is not seen";
    EXPECT_EQ(s.get<Sphere>()[0].radius, 0.5);
    const Material& own = s.materials[s.shapes[0].material];
    EXPECT_EQ(own.ambient, (Color{1, 0.5, 0}));
    EXPECT_EQ(own.diffuse, (Color{0, 0, 0}));
    EXPECT_FALSE(own.casts_shadow);
}

#define DAT_GLASS                                                                              \
    "Sphere Center 0 0 9 Rad 1 Texture Ambient 1 Diffuse 0.5 Specular 0.5 Opacity 0.25 Phong " \
    "Plastic 1 Phong_size 20 Color 1 1 1 TexFunc 0 "

TEST(Tachyon, OpacityIsStraightTransmission) {
    const Scene plain = dat_scene(DAT_SCENE DAT_GLASS);
    EXPECT_EQ(plain.materials[1].diffuse.r, 0.5);
    EXPECT_EQ(plain.materials[1].transmit, 0.75);
    EXPECT_EQ(plain.materials[1].transmission, 0);
    EXPECT_EQ(plain.conventions.transparency, Transparency::add);
    EXPECT_EQ(plain.conventions.transparent_shadow, TransparentShadow::colored);
    const Scene vmd =
        dat_scene(DAT_SCENE DAT_GLASS
                  "Shader_Mode Medium Trans_VMD Shadow_Filter_Off Trans_Max_Surfaces 2 End_Shader_Mode\n");
    EXPECT_EQ(vmd.conventions.transparency, Transparency::blend);
    EXPECT_EQ(vmd.conventions.transparent_shadow, TransparentShadow::none);
    EXPECT_EQ(vmd.conventions.transparent_surfaces, 2);
    EXPECT_FALSE(vmd.settings.shadows);
}

TEST(Tachyon, ReadsAmbientOcclusion) {
    const Scene s =
        dat_scene(DAT_SCENE
                  "Shader_Mode Full Ambient_Occlusion Ambient_Color 1 0.5 0 Rescale_Direct 0.5 Samples 12 "
                  "End_Shader_Mode");
    ASSERT_TRUE(s.occlusion);
    EXPECT_EQ(s.occlusion->method, OcclusionMethod::fixed);
    EXPECT_EQ(s.occlusion->samples, 12);
    EXPECT_EQ(s.occlusion->color, (Color{1, 0.5, 0}));
    EXPECT_EQ(s.occlusion->direct, 0.5);
    EXPECT_EQ(s.lights[0].color.r, 1);
    const Scene sky = dat_scene(DAT_SCENE "Sky_Light NumSamples 9 Color 1 1 1");
    EXPECT_EQ(sky.occlusion->samples, 9);
    const Scene medium =
        dat_scene(DAT_SCENE
                  "Shader_Mode Medium Ambient_Occlusion Ambient_Color 1 1 1 Rescale_Direct 0.5 "
                  "Samples 12 End_Shader_Mode");
    EXPECT_FALSE(medium.occlusion);
    EXPECT_EQ(medium.lights[0].color.r, 0.5);
}

TEST(Tachyon, ReadsGradients) {
    const Scene s =
        dat_scene(DAT_SCENE
                  "Background_Gradient Sky_Ortho_Plane Updir 0 2 0 TopVal 1 BottomVal -1 TopColor 1 1 1 "
                  "BottomColor 0 0 0.5");
    ASSERT_TRUE(s.gradient);
    EXPECT_EQ(s.gradient->kind, GradientKind::plane);
    EXPECT_EQ(s.gradient->top, 0.5);
    EXPECT_EQ(s.gradient->bottom, -0.5);
    EXPECT_EQ(s.gradient->bottom_color, (Color{0, 0, 0.5}));
}

TEST(Tachyon, ReadsShapes) {
    const Scene s = dat_scene(DAT_BEGIN DAT_CAMERA DAT_LIGHT
                              "TexDef t Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 1 1 TexFunc 0\n"
                              "FCylinder Base 0 0 0 Apex 0 0 2 Rad 1 t\n"
                              "FCylinder Base 0 0 0 Apex 0 0 0 Rad 1 t\n"
                              "Tri V0 0 0 0 V1 1 0 0 V2 0 1 0 t\n"
                              "STri V0 0 0 0 V1 1 0 0 V2 0 1 0 N0 0 0 1 N1 0 1 0 N2 1 0 0 t\n"
                              "Plane Center 0 1 0 Normal 0 2 0 t\n"
                              "Box Min 1 0 0 Max 0 1 1 t\n"
                              "Ring Center 0 0 0 Normal 0 1 0 Inner 0 Outer 2 t\n"
                              "Ring Center 0 0 0 Normal 0 2 0 Inner 1 Outer 2 t\n"
                              "PolyCylinder Points 3 0 0 0 1 0 0 1 1 0 Rad 0.5 t\n");
    ASSERT_EQ(s.shapes.size(), 12u);
    EXPECT_EQ(s.get<Cylinder>()[0].to, (Vec3{0, 0, 2}));
    EXPECT_FALSE(s.get<Cylinder>()[0].caps);
    EXPECT_EQ(s.get<Triangle>()[0].vertices[2], (Vec3{0, 1, 0}));
    EXPECT_EQ(s.get<SmoothTriangle>()[0].normals[2], (Vec3{1, 0, 0}));
    EXPECT_EQ(s.get<Plane>()[0].normal, (Vec3{0, 2, 0}));
    EXPECT_EQ(s.get<Box>()[0].min, (Vec3{0, 0, 0})) << "the corners are sorted";
    EXPECT_EQ(s.get<Box>()[0].max, (Vec3{1, 1, 1}));
    EXPECT_EQ(s.get<Disc>()[0].radius, 2);
    EXPECT_EQ(s.get<Cone>()[0].from_radius, 1) << "a ring with a hole";
    EXPECT_EQ(s.get<Cone>()[0].to_radius, 2);
    EXPECT_EQ(s.get<Sphere>().size(), 3u);
    EXPECT_EQ(s.get<Cylinder>().size(), 3u);
    EXPECT_EQ(s.shape_texts.place(1).line, 8u);
}

// Programs write shapes without extent; Tachyon shows nothing of them.
TEST(Tachyon, ShapesOfRadius0AreNotSeen) {
    const Scene s = dat_scene(DAT_SCENE
                              "TexDef t Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 1 1 TexFunc 0\n"
                              "Sphere Center 0 0 0 Rad 0 t\n"
                              "FCylinder Base 0 0 0 Apex 1 0 0 Rad 0 t\n"
                              "Cylinder Center 0 0 0 Axis 1 0 0 Rad 0 t\n"
                              "PolyCylinder Points 2 0 0 0 1 0 0 Rad 0 t\n");
    EXPECT_EQ(s.shapes.size(), 1u);
}

TEST(Tachyon, ReadsVertexArrays) {
    const Scene s =
        dat_scene(DAT_BEGIN DAT_CAMERA DAT_LIGHT
                  "VertexArray Numverts 5 Coords 9 9 9 0 0 0 1 0 0 0 1 0 1 1 0 Normals 0 1 0 0 0 1 0 0 1 0 0 "
                  "1 0 0 1 " DAT_TEXTURE "TriMesh 1 1 2 3 TriStrip 4 1 2 3 4 End_VertexArray\n" DAT_SPHERE);
    ASSERT_EQ(s.meshes.size(), 1u);
    const MeshData& mesh = *s.meshes[0];
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.vertex_count(), 4u) << "without the vertex that no triangle has";
    EXPECT_EQ(mesh.position(mesh.triangles[1][0]), (Vec3{0, 0, 0}));
    EXPECT_EQ(mesh.position(mesh.triangles[2][0]), (Vec3{0, 1, 0})) << "every second one is turned";
    EXPECT_EQ(mesh.position(mesh.triangles[2][1]), (Vec3{1, 0, 0}));
    EXPECT_EQ(mesh.position(mesh.triangles[2][2]), (Vec3{1, 1, 0}));
    EXPECT_EQ((*mesh.corner_normals(0))[1], (Float3{0, 0, 1}));
    EXPECT_EQ(s.shapes[0].material, s.shapes[1].material);
}

constexpr const char* k_colored_array =
    "VertexArray Numverts 3 Coords 0 0 0 1 0 0 0 1 0 Normals 0 0 1 0 0 1 0 0 1 " DAT_TEXTURE
    "TriMesh 1 0 1 2 Colors 1 0 0 0 1 0 0 -1 1 TriMesh 1 0 1 2 End_VertexArray\n";

TEST(Tachyon, VerticesHaveColors) {
    const Scene s = dat_scene(std::string(DAT_BEGIN DAT_CAMERA DAT_LIGHT) + k_colored_array);
    ASSERT_EQ(s.meshes.size(), 2u) << "without and with colors";
    EXPECT_TRUE(s.meshes[0]->colors.empty());
    EXPECT_EQ((*s.meshes[1]->corner_values(s.meshes[1]->colors, 0))[1], (Float3{0, 1, 0}));
    EXPECT_EQ((*s.meshes[1]->corner_values(s.meshes[1]->colors, 0))[2], (Float3{0, 0, 1})) << "at least 0";
    const Scene white = dat_scene(
        std::string(DAT_BEGIN "Shader_Mode Lowest End_Shader_Mode " DAT_CAMERA DAT_LIGHT) + k_colored_array);
    EXPECT_TRUE(white.meshes.at(1)->colors.empty());
}

TEST(Tachyon, TrianglesWithColorsAreGathered) {
    const auto triangle = [](const std::string& body) {
        return "VCSTri V0 0 0 0 V1 1 0 0 V2 0 1 0 N0 0 0 1 N1 0 0 1 N2 0 0 1 C0 1 0 0 C1 0 1 0 C2 0 0 1 "
               "Ambient .1 "
               "Diffuse .5 Specular 0 Opacity 1 " +
               body + " VCST\n";
    };
    const std::string plastic = "Phong Plastic .5 Phong_size 9", metal = "Phong Metal .5 Phong_size 9";
    const Scene s = dat_scene(std::string(DAT_BEGIN DAT_CAMERA DAT_LIGHT) + triangle(plastic) + DAT_SPHERE +
                              triangle(plastic) + triangle(metal));
    ASSERT_EQ(s.get<Mesh>().size(), 2u);
    EXPECT_EQ(s.meshes[0]->triangles.size(), 2u);
    EXPECT_EQ((*s.meshes[0]->corner_values(s.meshes[0]->colors, 1))[2], (Float3{0, 0, 1}));
    const Material plain = with_color(s.materials.at(s.shapes.at(0).material), {.2, .4, .6});
    EXPECT_EQ(plain.diffuse, (Color{.1, .2, .3}));
    EXPECT_EQ(plain.specular, (Color{.5, .5, .5}));
    EXPECT_EQ(with_color(s.materials.at(s.shapes.at(2).material), {.2, .4, .6}).specular,
              (Color{.1, .2, .3}));
}

TEST(Tachyon, ReadsFog) {
    const Scene s = dat_scene(DAT_SCENE
                              "Fog Exp2 Start 1 End 2 Density 0.5 Color 1 0.5 0\n"
                              "Shader_Mode Full Fog_VMD End_Shader_Mode");
    ASSERT_TRUE(s.fog);
    EXPECT_EQ(s.fog->kind, FogKind::exp2);
    EXPECT_EQ(s.fog->start, 1);
    EXPECT_EQ(s.fog->density, 0.5);
    EXPECT_EQ(s.fog->color, (Color{1, 0.5, 0}));
    EXPECT_EQ(s.conventions.fog_distance, FogDistance::depth);
    EXPECT_FALSE(s.conventions.fog_background);
    EXPECT_FALSE(dat_scene(DAT_SCENE "Fog Off Start 1 End 2 Density 0.5 Color 1 0.5 0\n").fog);
}

TEST(Tachyon, ReadsSpotLights) {
    const Scene s =
        dat_scene(DAT_SCENE
                  "SpotLight Center 0 9 0 Rad 0 Direction 0 -2 0 Falloff_Start 20 Falloff_End 45 Attenuation "
                  "Constant 0 Linear 1 Quadratic 2 Color 1 1 0");
    const Light& l = s.lights[1];
    EXPECT_EQ(l.kind, LightKind::spot);
    EXPECT_EQ(l.axis, (Vec3{0, -2, 0}));
    EXPECT_EQ(l.inner_angle, 20);
    EXPECT_EQ(l.outer_angle, 45);
    EXPECT_EQ(l.attenuation, (Attenuation{0, 1, 2}));
}

TEST(Tachyon, AMetalsHighlightHasTheSurfacesColor) {
    const Scene s = dat_scene(DAT_SCENE
                              "Sphere Center 0 0 0 Rad 1 Texture Ambient 0 Diffuse 1 Specular 0 Opacity 1 "
                              "Phong Metal 0.5 Phong_size 9 Color 1 0.5 0 TexFunc 0");
    EXPECT_EQ(s.materials[1].specular, (Color{0.5, 0.25, 0}));
    EXPECT_FALSE(s.materials[1].tinted_highlight);
    EXPECT_TRUE(s.materials[0].tinted_highlight);
}

// Its highlight does not depend on the light's color, but on the scale of all light.
TEST(Tachyon, AMetalsHighlightIsRescaled) {
    const auto specular_with = [](const char* shader) {
        const std::string mode = std::string("Shader_Mode ") + shader +
                                 " Ambient_Occlusion Ambient_Color 1 1 1 Rescale_Direct 0.5 Samples 8 "
                                 "End_Shader_Mode ";
        const Scene s =
            dat_scene(DAT_SCENE + mode +
                      "Sphere Center 0 0 0 Rad 1 Texture Ambient 0 Diffuse 1 Specular 0 Opacity 1 "
                      "Phong Metal 0.5 Phong_size 9 Color 1 0.5 0 TexFunc 0");
        return s.materials[1].specular * (s.occlusion ? s.occlusion->direct : 1);
    };
    EXPECT_EQ(specular_with("Full"), (Color{0.25, 0.125, 0}));
    EXPECT_EQ(specular_with("Medium"), (Color{0.25, 0.125, 0}));
}

TEST(Tachyon, FlatShadersShowColors) {
    const Scene low = dat_scene(DAT_SCENE "Shader_Mode Low End_Shader_Mode Background 1 1 1");
    EXPECT_EQ(low.settings.shading, Shading::color);
    EXPECT_EQ(low.settings.reflections, 0);
    EXPECT_EQ(low.materials[0].color, (Color{1, 0.5, 0}));
    const Scene lowest =
        dat_scene(DAT_SCENE
                  "Shader_Mode Lowest End_Shader_Mode Background 1 1 1 Background_Gradient Sky_Sphere "
                  "Updir 0 1 0 TopVal 1 BottomVal 0 TopColor 1 1 1 BottomColor 0 1 0");
    EXPECT_EQ(lowest.materials[0].color, (Color{1, 1, 1}));
    EXPECT_EQ(lowest.background, (Color{0, 0, 0}));
    EXPECT_FALSE(lowest.gradient);
}

TEST(Tachyon, IncludedTextsNeedNoHeader) {
    class Parts : public Sources {
      public:
        Result<std::string> read(std::string_view name, std::string_view) override {
            EXPECT_EQ(name, "part.txt");
            return std::string("TexDef t Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 1 1 TexFunc 0\n");
        }
    } parts;
    const SceneText texts[] = {{"a.dat", DAT_SCENE "Include part.txt Sphere Center 0 0 9 Rad 1 t", {}}};
    const Result<Scene> s = load(texts, {}, &parts);
    ASSERT_TRUE(s) << messages(s);
    EXPECT_EQ(messages(s), "");
    EXPECT_EQ(s->shapes.size(), 2u);
}

TEST(Tachyon, ASecondTextMaySetModes) {
    const SceneText texts[] = {
        {"a.dat", DAT_BEGIN "Shader_Mode Medium End_Shader_Mode " DAT_CAMERA DAT_LIGHT DAT_GLASS, {}},
        {"flags", "Shader_Mode Trans_VMD Rescale_Direct 0.5 End_Shader_Mode", "tachyon"}};
    const Result<Scene> s = load(texts);
    ASSERT_TRUE(s) << messages(s);
    EXPECT_EQ(s->conventions.transparency, Transparency::blend);
    EXPECT_EQ(s->lights[0].color.r, 0.5);
    EXPECT_EQ(s->lights[0].specular_color.r, 0.5);
    EXPECT_FALSE(s->settings.shadows);
}

TEST(Tachyon, Outlines) {
    const Result<Scene> s =
        load_text(DAT_SCENE
                  "Sphere Center 0 0 0 Rad 1 Texture Ambient 0 Diffuse 1 Specular 0 Opacity 1 Outline 0.75 "
                  "Outline_Width 0.5 Color 1 1 1 TexFunc 0",
                  "a.dat");
    ASSERT_TRUE(s) << messages(s);
    EXPECT_EQ(messages(s), "");
    EXPECT_EQ(s->materials.back().outline, 0.75);
    EXPECT_EQ(s->materials.back().outline_width, 0.5);
}

TEST(Tachyon, TheFirstDefinitionOfATextureCounts) {
    const auto definition = [](const std::string& color) {
        return "TexDef t Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color " + color + " TexFunc 0\n";
    };
    const Result<Scene> s =
        warned_dat_scene(DAT_SCENE + definition("1 0 0") + "TexAlias u t\n" + definition("0 1 0") +
                             "Sphere Center 0 0 9 Rad 1 t\n" + definition("0 0 1") +
                             "TexAlias u t\nSphere Center 0 0 9 Rad 2 u\n",
                         "the texture 't' is defined already: its first definition counts, as in Tachyon");
    EXPECT_EQ(s->materials[s->shapes[1].material].color, (Color{1, 0, 0}));
    EXPECT_EQ(s->shapes[1].material, s->shapes[2].material);
    EXPECT_EQ(messages(s).find("is defined already"), messages(s).rfind("is defined already")) << "once";
}

TEST(Tachyon, Raster3DIsOpacityByTheAngle) {
    const auto angled = [](const std::string& mode, const std::string& texture) {
        const Scene s =
            dat_scene(DAT_SCENE + mode + "Sphere Center 0 0 0 Rad 1 Texture Ambient 0 Diffuse 1 Specular 0 " +
                      texture + " Color 1 1 1 TexFunc 0");
        return s.materials[s.shapes.back().material].angled_opacity;
    };
    EXPECT_TRUE(angled("", "Opacity 0.5 TransMode R3D"));
    EXPECT_FALSE(angled("", "Opacity 0.5"));
    EXPECT_FALSE(angled("", "Opacity 1 TransMode R3D"));
    const std::string mode = "Shader_Mode Full Trans_Raster3D ";
    EXPECT_TRUE(angled(mode + "End_Shader_Mode ", "Opacity 0.5"));
    EXPECT_TRUE(angled(mode + "Trans_VMD End_Shader_Mode ", "Opacity 0.5"));
}

TEST(Tachyon, LimitsAreNamedOnce) {
    expect_dat_warning(DAT_SCENE "Cylinder Center 0 0 0 Axis 0 0 1 Rad 1 " DAT_TEXTURE,
                       "the endless cylinder ends");
    expect_dat_warning(DAT_SCENE "STri V0 0 0 0 V1 0 1 0 V2 1 0 0 N0 0 0 -1 N1 0 0 -2 N2 0 0 -1 " DAT_TEXTURE,
                       "the normals of this triangle have different lengths");
    expect_dat_warning(DAT_SCENE "Box Min 0 0 0 Max 1 1 2 " DAT_TEXTURE,
                       "near the edges of a box that is no cube");
    const auto missing =
        warned_dat_scene(DAT_SCENE "Sphere Center 0 0 0 Rad 1 nosuch Sphere Center 0 0 0 Rad 1 nosuch",
                         "a.dat:6:27: warning: no texture is called 'nosuch'");
    EXPECT_EQ(missing.diagnostics.size(), 1u);
    EXPECT_EQ(missing->materials[1].diffuse, (Color{0.9, 0.9, 0.9}));
}

class TachyonMistakes : public testing::TestWithParam<BadText> {};
TEST_P(TachyonMistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.dat"); }

#define DAT_ANY "an object, a light, a texture, `Camera` or `End_Scene`"

INSTANTIATE_TEST_SUITE_P(
    Texts, TachyonMistakes,
    testing::Values(
        BadText{"empty", "$", {"expected `Begin_Scene`, found the end of the text"}},
        BadText{"no_resolution", "Begin_Scene\n$" DAT_CAMERA, {"expected `Resolution`, found 'Camera'"}},
        BadText{"unknown",
                DAT_SCENE "$Spere Center 0 0 0 Rad 1 t\n" DAT_SPHERE,
                {"expected " DAT_ANY ", found 'Spere'; did you mean `Sphere`?"}},
        BadText{
            "field", DAT_SCENE "Sphere $Centre 0 0 0\n" DAT_SPHERE, {"expected `Center`, found 'Centre'"}},
        BadText{"cut_off", DAT_SCENE "Sphere Center 0 0$", {"expected a number, found the end of the text"}},
        BadText{
            "word", DAT_SCENE "Sphere Center 0 $x 0 Rad 1 t\n" DAT_SPHERE, {"expected a number, found 'x'"}},
        BadText{"half_a_number",
                DAT_SCENE "Sphere Center 0 $1x 0 Rad 1 t\n" DAT_SPHERE,
                {"expected a number, found '1x'"}},
        BadText{
            "not_a_number", DAT_SCENE "Sphere Center 0 $nan 0 Rad 1 t\n", {"expected a number, found 'nan'"}},
        BadText{"far",
                DAT_SCENE "Sphere Center 0 $1e13 0 Rad 1 " DAT_TEXTURE,
                {"expected a number from -1e12 to 1e12, found '1e13'"}},
        BadText{"radius",
                DAT_SCENE "Sphere Center 0 0 0 Rad $-1 " DAT_TEXTURE,
                {"expected a number > 0 and at most 1e12, found '-1'"}},
        BadText{"opacity",
                DAT_SCENE "Sphere Center 0 0 0 Rad 1 Texture Ambient 0 Diffuse 1 Specular 0 Opacity $2 Color "
                          "1 1 1\nTexFunc "
                          "0\n",
                {"expected a number from 0 to 1, found '2'"}},
        BadText{"index",
                DAT_SCENE
                "VertexArray Numverts 1 Coords 0 0 0 Normals 0 0 1 TriMesh 1 0 $1 0 End_VertexArray",
                {"expected the index of a vertex, from 0, found '1'"}},
        BadText{"many_vertices",
                DAT_SCENE "VertexArray Numverts 4000000000 Coords 0 0 0 $Normals 0 0 1 End_VertexArray",
                {"expected a number, found 'Normals'"}},
        BadText{
            "up",
            DAT_BEGIN
            "Camera Zoom 1 Aspectratio 1 Antialiasing 0 Raydepth 5 Center 0 0 0 Viewdir 0 1 0\nUpdir $0 2 0 "
            "End_Camera " DAT_LIGHT DAT_SPHERE,
            {"the camera's `Updir` is along its `Viewdir`: they must differ"}}),
    test_name);

#define DAT_CRS "Center 0 0 0 Rotate 0 0 0 Scale 1 1 1 "
#define DAT_BODY \
    "Sphere Center 0 0 0 Rad 1 Texture Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 1 1\nTexFunc "

INSTANTIATE_TEST_SUITE_P(
    Refused, TachyonMistakes,
    testing::Values(
        BadText{"noise",
                DAT_SCENE DAT_BODY "$5 " DAT_CRS DAT_SPHERE,
                {"glint does not render the noise as a texture (`TexFunc 5`); the option skip-unsupported "
                 "draws the objects without it"}},
        BadText{"round_checker",
                DAT_SCENE DAT_BODY "$6 " DAT_CRS DAT_SPHERE,
                {"glint does not render the checker on a cylinder as a texture (`TexFunc 6`); the option "
                 "skip-unsupported draws the objects without it"}},
        BadText{"image",
                DAT_SCENE DAT_BODY "$7 a.ppm " DAT_CRS DAT_BODY "7 a.ppm " DAT_CRS DAT_BODY
                                   "$9 b.ppm " DAT_CRS "Uaxis 1 0 0 Vaxis 0 1 0 ",
                {"glint does not render an image on a cylinder 'a.ppm' as a texture (`TexFunc 7`); the "
                 "option skip-unsupported draws the objects without it",
                 "glint does not render an image on a plane 'b.ppm' as a texture (`TexFunc 9`); the option "
                 "skip-unsupported draws the objects without it"}},
        BadText{"image_mistake",
                DAT_SCENE DAT_BODY "7 a.ppm Center 0 0 0 $Scale 1 1 1 ",
                {"expected `Rotate`, found 'Scale'"}},
        BadText{"scape",
                DAT_SCENE "$Scape Res 4 4 Scale 1 1 Center 0 0 0 t\n" DAT_SPHERE,
                {"glint does not render a random landscape (`Scape`); the option skip-unsupported leaves it "
                 "out and draws the rest"}},
        BadText{"volume",
                DAT_SCENE "$ScalarVol Min 0 0 0 Max 1 1 1 Dim 2 2 2 File v t\n" DAT_SPHERE,
                {"glint does not render volumes (`ScalarVol`); the option skip-unsupported leaves it out and "
                 "draws the rest"}},
        BadText{"clipping",
                DAT_SCENE "$Start_ClipGroup NumPlanes 1 1 0 0 0\n" DAT_SPHERE "End_ClipGroup",
                {"glint does not render clipping planes (`Start_ClipGroup`); the option skip-unsupported "
                 "draws the objects without them"}},
        BadText{"fisheye",
                DAT_BEGIN
                "Camera Projection $Fisheye Zoom 1 Aspectratio 1 Antialiasing 0 Raydepth 5 Center 0 0 "
                "0 Viewdir 0 0 1 Updir 0 2 0 End_Camera " DAT_LIGHT DAT_SPHERE,
                {"glint does not render the projection `Fisheye`"}},
        BadText{"depth_of_field",
                DAT_BEGIN
                "Camera Projection $Perspective_DoF FocalLength 1 Aperture 64 Zoom 1 Aspectratio 1 "
                "Antialiasing 0 "
                "Raydepth 5 Center 0 0 0 Viewdir 0 0 1 Updir 0 2 0 End_Camera " DAT_LIGHT DAT_SPHERE,
                {"glint does not render depth of field (`Perspective_DoF`); `Perspective` is sharp "
                 "everywhere, without FocalLength and Aperture"}}),
    test_name);

}  // namespace
}  // namespace glint::test
