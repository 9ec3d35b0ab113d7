// SPDX-License-Identifier: Apache-2.0
// Faults of textures, planted in two scenes, are the first that find_causes() names, and are sure; what only
// resembles them is not.
#include <functional>

#include "compare/planted_faults.h"
#include "compare/scene_causes.h"
#include "math/srgb.h"

namespace glint::test {
namespace {

const std::string k_room = R"(
background = (0.35, 0.45, 0.6)
camera { position = (0.5, 2.4, 7)  look_at = (0, 0.7, 0)  fov_x = 46 }
light { type = ambient  intensity = 0.5 }
light "lamp" { position = (1.5, 5, 4)  intensity = 0.7 }
render { size = 96 x 72  shading = phong  reflections = 2 }
)";
// A picture without symmetry.
const std::string k_texels =
    "texels = (\"f0e0c0 a02010 d0a040 209060\", \"208030 e0d020 604080 c0c0d0\", \"1040c0 30b0b0 e08080 "
    "404040\")  ";

// A ball and a floor, by the place of the point.
const std::string k_projected = k_room + "texture globe { encoding = srgb  " + k_texels +
                                "mapping = spherical  translate = (-1.2, 0.9, 0.4) }\n" +
                                "texture tiles { encoding = srgb  " + k_texels +
                                "mapping = planar  rotate = (-90, 0, 0)  scale = 2 }\n" +
                                R"(
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.9, 0.9, 0.8)  ambient = 0.3  diffuse = 0.8  texture = tiles }
sphere { center = (-1.2, 0.9, 0.4)  radius = 0.9  color = (1, 1, 1)  ambient = 0.2  diffuse = 0.7  specular = 0.2  shininess = 25  texture = globe }
box { min = (0.7, 0, -0.8)  max = (1.7, 1.5, 0.2)  color = (0.3, 0.4, 0.8)  ambient = 0.2  diffuse = 0.8 }
)";
// A wall with coordinates beyond the picture.
const std::string k_mesh = k_room + "texture poster { encoding = srgb  " + k_texels + "}\n" +
                           R"(
mesh { vertices = ((-2.4, 0, 0), (2, 0, -1), (2, 2.6, -1), (-2.4, 2.6, 0))  triangles = ((0, 1, 2), (0, 2, 3))
  texture_coordinates = ((-0.4, -0.3), (1.7, -0.3), (1.7, 1.5), (-0.4, 1.5))
  color = (0.95, 0.9, 1)  ambient = 0.3  diffuse = 0.7  texture = poster }
sphere { center = (0.4, 0.5, 1.6)  radius = 0.5  color = (0.8, 0.5, 0.3)  ambient = 0.2  diffuse = 0.7  specular = 0.3  shininess = 30 }
)";

// Texels with alpha, beside 0.5 and far from it.
const std::string k_clear_texels =
    "texels = (\"f0e0c0ff a0201000 d0a040ff 20906050\", \"208030b0 e0d020ff 60408000 c0c0d0ff\", \"1040c000 "
    "30b0b0ff e0808020 404040e0\")  ";
// A globe with holes around a ball, over a floor.
const std::string k_globe = k_room + "texture globe { encoding = srgb  " + k_clear_texels +
                            "mapping = spherical  translate = (-0.4, 1.1, 0.4) }\n" +
                            R"(
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.7, 0.8, 0.6)  ambient = 0.3  diffuse = 0.8 }
sphere { center = (-0.4, 1.1, 0.4)  radius = 1.1  color = (1, 1, 1)  ambient = 0.3  diffuse = 0.7  texture = globe }
sphere { center = (-0.4, 1.1, 0.4)  radius = 0.5  color = (0.9, 0.3, 0.2)  ambient = 0.3  diffuse = 0.7  specular = 0.3  shininess = 20 }
box { min = (1.2, 0, -0.8)  max = (2.2, 1.5, 0.2)  color = (0.3, 0.4, 0.8)  ambient = 0.2  diffuse = 0.8 }
)";
// A fence before a wall.
const std::string k_fence = k_room + "texture fence { filter = nearest  " + k_clear_texels + "}\n" +
                            R"(
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.5, 0.5, 0.4)  ambient = 0.3  diffuse = 0.8 }
box { min = (-3, 0, -3)  max = (1.6, 2.6, -2)  color = (0.7, 0.5, 0.4)  ambient = 0.3  diffuse = 0.7 }
mesh { vertices = ((-2.4, 0, 1), (2, 0, 0), (2, 1.6, 0), (-2.4, 1.6, 1))  triangles = ((0, 1, 2), (0, 2, 3))
  texture_coordinates = ((0, 0), (2.5, 0), (2.5, 1), (0, 1))
  color = (0.95, 0.9, 1)  ambient = 0.3  diffuse = 0.7  texture = fence }
)";

void change_textures(Scene& s, const std::function<void(Texture&)>& change) {
    for (Texture& t : s.textures) change(t);
}
using Row = double[3];
void map_row(Row& row, double a, double b, double c) { row[0] = a, row[1] = b, row[2] = c; }

// The texels with another meaning, as 16 bits.
void change_texels(Scene& s, const std::function<double(double)>& curve) {
    change_textures(s, [&](Texture& t) {
        TextureImage image{t.image->width, t.image->height, false, {}};
        std::vector<std::uint16_t> words;
        for (const std::uint8_t word : std::get<0>(t.image->words))
            words.push_back(static_cast<std::uint16_t>(65535 * curve(word / 255.0) + 0.5));
        image.words = std::move(words);
        t.image = std::make_shared<const TextureImage>(std::move(image));
    });
}

void map_textures(Scene& s) {
    change_textures(s, [](Texture& t) {
        map_row(t.uv_map.m[0], 1.5, 0, 0.25);
        map_row(t.uv_map.m[1], 0.25, 0.75, 0.5);
    });
}
template <TextureAlpha alpha> void set_alpha(Scene& s) {
    change_textures(s, [](Texture& t) { t.alpha = alpha; });
}

struct Planted {
    const char* cause;
    std::function<void(Scene&)> fault;
    const char* says = "";
    std::function<void(Scene&)> both = {};
};

const Planted k_faults[] = {
    {"texture-missing",
     [](Scene& s) {
         for (Material& m : s.materials) m.texture = k_none;
     }},
    {"texture-upside-down",
     [](Scene& s) { change_textures(s, [](Texture& t) { map_row(t.uv_map.m[1], 0, -1, 1); }); }},
    {"texture-mirrored",
     [](Scene& s) { change_textures(s, [](Texture& t) { map_row(t.uv_map.m[0], -1, 0, 1); }); }},
    {"texture-half-texel",
     [](Scene& s) {
         change_textures(s, [](Texture& t) {
             map_row(t.uv_map.m[0], 1, 0, 0.125);
             map_row(t.uv_map.m[1], 0, 1, -1.0 / 6);
         });
     }},
    {"texture-swapped",
     [](Scene& s) {
         change_textures(s, [](Texture& t) {
             map_row(t.uv_map.m[0], 0, 1, 0);
             map_row(t.uv_map.m[1], 1, 0, 0);
         });
     },
     "goes to the right in the picture"},
    {"texture-swapped",
     [](Scene& s) {
         change_textures(s, [](Texture& t) {
             map_row(t.uv_map.m[0], 0, 1.5, 0.25);
             map_row(t.uv_map.m[1], 0.75, 0.25, 0.5);
         });
     },
     "before `uv_map`", map_textures},
    {"texture-swapped",
     [](Scene& s) {
         change_textures(s, [](Texture& t) {
             map_row(t.uv_map.m[0], 0.25, 0.75, 0.5);
             map_row(t.uv_map.m[1], 1.5, 0, 0.25);
         });
     },
     "are exchanged: ", map_textures},
    {"texture-map-missing",
     [](Scene& s) {
         change_textures(s, [](Texture& t) {
             map_row(t.uv_map.m[0], 1, 0, 0);
             map_row(t.uv_map.m[1], 0, 1, 0);
         });
     },
     "", map_textures},
    {"texture-replaces",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.mix = TextureMix::replace; }); }},
    {"texture-multiplies",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.mix = TextureMix::multiply; }); }, "",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.mix = TextureMix::replace; }); }},
    {"texture-not-decoded",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.encoding = TextureEncoding::linear; }); }},
    {"texture-decoded",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.encoding = TextureEncoding::srgb; }); }, "",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.encoding = TextureEncoding::linear; }); }},
    {"texture-decoded-twice", [](Scene& s) { change_texels(s, srgb_decode); }},
    {"texture-wrap",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.wrap_u = t.wrap_v = TextureWrap::mirror; }); },
     "every other time reversed"},
    {"texture-wrap",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.wrap_u = t.wrap_v = TextureWrap::clamp; }); },
     "is continued"},
    {"texture-wrap",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.wrap_u = t.wrap_v = TextureWrap::once; }); },
     "have no texture"},
    {"texture-wrap",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.wrap_u = t.wrap_v = TextureWrap::repeat; }); },
     "is repeated, unlike",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.wrap_u = t.wrap_v = TextureWrap::clamp; }); }},
    {"texture-filter",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.filter = TextureFilter::nearest; }); },
     "the nearest texel"},
    {"texture-filter",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.filter = TextureFilter::bilinear; }); },
     "and in the reference it is the nearest one's",
     [](Scene& s) { change_textures(s, [](Texture& t) { t.filter = TextureFilter::nearest; }); }},
};

const Planted k_faults_of_alpha[] = {
    {"texture-alpha-ignored", set_alpha<TextureAlpha::ignore>, "", set_alpha<TextureAlpha::mask>},
    {"texture-alpha-ignored", set_alpha<TextureAlpha::ignore>, "", set_alpha<TextureAlpha::blend>},
    {"texture-alpha-mode", set_alpha<TextureAlpha::blend>, "in the reference they have holes",
     set_alpha<TextureAlpha::mask>},
    {"texture-alpha-mode", set_alpha<TextureAlpha::mask>, "in the reference they are as transparent",
     set_alpha<TextureAlpha::blend>},
};

#if defined(GLINT_SANITIZED)
constexpr std::size_t k_most_planted = 3;
#else
constexpr std::size_t k_most_planted = 100;
#endif

void expect_sure(const std::string& text, std::span<const Planted> all = k_faults) {
    for (const Planted& planted : all.first(std::min(all.size(), k_most_planted))) {
        Scene right = read_scene(text);
        if (planted.both) planted.both(right);
        Scene wrong = right;
        planted.fault(wrong);
        const Image reference = as_file(draw(right)), picture = as_file(draw(wrong));
        EXPECT_NE(reference.rgb, picture.rgb) << planted.cause << ": nothing was planted";
        const Result<CauseReport> report = find_causes(picture, reference, &right);
        EXPECT_EQ(first_cause(report), planted.cause) << all_causes(report);
        if (!report || report->causes.empty()) continue;
        const Cause& cause = report->causes.front();
        EXPECT_NE(cause.explanation.find(planted.says), std::string::npos) << cause.explanation;
        EXPECT_GT(cause.explained, 0.97) << cause.explanation;
        EXPECT_FALSE(cause.perhaps) << cause.explanation;
    }
}
TEST(CausesOfTextures, PlacedByThePoint) { expect_sure(k_projected); }
TEST(CausesOfTextures, PlacedByAMeshsCoordinates) { expect_sure(k_mesh); }

TEST(CausesOfTextures, AlphaPlacedByThePoint) { expect_sure(k_globe, k_faults_of_alpha); }
TEST(CausesOfTextures, AlphaPlacedByAMeshsCoordinates) { expect_sure(k_fence, k_faults_of_alpha); }

// What is none of them is not called one of them for sure.
void expect_not_sure(const std::string& text, const char* what, const std::function<void(Scene&)>& fault) {
    const Scene right = read_scene(text);
    Scene wrong = right;
    fault(wrong);
    const Image reference = as_file(draw(right)), picture = as_file(draw(wrong));
    EXPECT_NE(reference.rgb, picture.rgb) << what;
    const Result<CauseReport> report = find_causes(picture, reference, &right);
    ASSERT_TRUE(report);
    for (const Cause& cause : report->causes) EXPECT_TRUE(cause.perhaps) << what << all_causes(report);
}
void expect_silence(const std::string& scene) {
    const std::string text = replaced(scene, "96 x 72", "64 x 48");
    expect_not_sure(text, "u times width - 1", [](Scene& s) {
        change_textures(s, [](Texture& t) {
            map_row(t.uv_map.m[0], 0.75, 0, 0.125);
            map_row(t.uv_map.m[1], 0, 2.0 / 3, 1.0 / 6);
        });
    });
#if !defined(GLINT_SANITIZED)
    expect_not_sure(text, "upside down and shifted", [](Scene& s) {
        change_textures(s, [](Texture& t) { map_row(t.uv_map.m[1], 0, -1, 1.06); });
    });
    expect_not_sure(text, "shifted by half a texel in u alone",
                    [](Scene& s) { change_textures(s, [](Texture& t) { t.uv_map.m[0][2] += 0.125; }); });
    expect_not_sure(text, "u in place of v", [](Scene& s) {
        change_textures(s, [](Texture& t) { map_row(t.uv_map.m[1], 1, 0, 0); });
    });
    expect_not_sure(text, "v in place of u", [](Scene& s) {
        change_textures(s, [](Texture& t) { map_row(t.uv_map.m[0], 0, 1, 0); });
    });
    expect_not_sure(text, "turned by 45 degrees", [](Scene& s) {
        change_textures(s, [](Texture& t) {
            map_row(t.uv_map.m[0], 0.7, 0.7, 0);
            map_row(t.uv_map.m[1], -0.7, 0.7, 0.5);
        });
    });
    const std::string mapped =
        replaced(text, "encoding = srgb", "uv_map = ((1.5, 0, 0.25), (0, 0.75, 0.5))  encoding = srgb");
    expect_not_sure(mapped, "mapped without the offset", [](Scene& s) {
        change_textures(s, [](Texture& t) { t.uv_map.m[0][2] = t.uv_map.m[1][2] = 0; });
    });
    expect_not_sure(mapped, "mapped by the inverse", [](Scene& s) {
        change_textures(s, [](Texture& t) {
            map_row(t.uv_map.m[0], 1 / 1.5, 0, -0.25 / 1.5);
            map_row(t.uv_map.m[1], 0, 1 / 0.75, -0.5 / 0.75);
        });
    });
    expect_not_sure(text, "decoded by a square",
                    [](Scene& s) { change_texels(s, [](double x) { return srgb_encode(x * x); }); });
    expect_not_sure(text, "wrapped in u alone",
                    [](Scene& s) { change_textures(s, [](Texture& t) { t.wrap_u = TextureWrap::clamp; }); });
#endif
}
TEST(CausesOfTextures, NearMissesByThePoint) { expect_silence(k_projected); }
TEST(CausesOfTextures, NearMissesByAMeshsCoordinates) { expect_silence(k_mesh); }

#if !defined(GLINT_SANITIZED)
// The alpha of the texels by another curve.
void change_texel_alpha(Scene& s, const std::function<double(double)>& curve) {
    change_textures(s, [&](Texture& t) {
        TextureImage image = *t.image;
        std::vector<std::uint8_t>& words = std::get<0>(image.words);
        for (std::size_t i = 3; i < words.size(); i += 4)
            words[i] = static_cast<std::uint8_t>(255 * curve(words[i] / 255.0) + 0.5);
        t.image = std::make_shared<const TextureImage>(std::move(image));
    });
}
#endif
void expect_silence_of_alpha(const std::string& scene) {
    const std::string text = replaced(scene, "96 x 72", "64 x 48"),
                      mask = replaced(text, "texture ([a-z]+) \\{", "texture $1 { alpha = mask ");
    expect_not_sure(mask, "another cutoff",
                    [](Scene& s) { change_textures(s, [](Texture& t) { t.alpha_cutoff = 0.8; }); });
#if !defined(GLINT_SANITIZED)
    expect_not_sure(mask, "holes exchanged with the rest",
                    [](Scene& s) { change_texel_alpha(s, [](double a) { return 1 - a; }); });
    expect_not_sure(text, "alpha squared",
                    [](Scene& s) { change_texel_alpha(s, [](double a) { return a * a; }); });
    expect_not_sure(text, "half of the alpha",
                    [](Scene& s) { change_texel_alpha(s, [](double a) { return a / 2; }); });
    expect_not_sure(text, "holes at another cutoff than that of the texture", [](Scene& s) {
        change_textures(s, [](Texture& t) { t.alpha = TextureAlpha::mask, t.alpha_cutoff = 0.8; });
    });
#endif
}
TEST(CausesOfTextures, NearMissesOfAlphaByThePoint) { expect_silence_of_alpha(k_globe); }
TEST(CausesOfTextures, NearMissesOfAlphaByAMeshsCoordinates) { expect_silence_of_alpha(k_fence); }

TEST(CausesOfTextures, TwoAtOnce) {
    const Scene right = read_scene(replaced(k_mesh, "96 x 72", "64 x 48"));
    Scene wrong = right;
    change_textures(wrong, [](Texture& t) {
        map_row(t.uv_map.m[1], 0, -1, 1);
        t.encoding = TextureEncoding::linear;
    });
    const Result<CauseReport> report = find_causes(as_file(draw(wrong)), as_file(draw(right)), &right);
    EXPECT_EQ(first_cause(report), "texture-not-decoded") << all_causes(report);
    ASSERT_TRUE(report && !report->then.empty());
    EXPECT_EQ(report->then.front().name, "texture-upside-down");
}

// A turn by a right angle.
TEST(CausesOfTextures, ExchangedAndReversed) {
    const Scene right = read_scene(replaced(k_mesh, "96 x 72", "64 x 48"));
    Scene wrong = right;
    change_textures(wrong, [](Texture& t) {
        map_row(t.uv_map.m[0], 0, 1, 0);
        map_row(t.uv_map.m[1], -1, 0, 1);
    });
    const Result<CauseReport> report = find_causes(as_file(draw(wrong)), as_file(draw(right)), &right);
    EXPECT_EQ(first_cause(report), "texture-swapped") << all_causes(report);
    ASSERT_TRUE(report && !report->then.empty());
    EXPECT_EQ(report->then.front().name, "texture-upside-down");
}

TEST(CausesOfTextures, OnlyInScenesThatHaveThem) {
    const auto count = [](const Scene& scene) {
        const std::vector<SceneCause> causes = scene_causes(scene);
        return std::count_if(causes.begin(), causes.end(),
                             [](const SceneCause& c) { return c.name.starts_with("texture-"); });
    };
    Scene scene = read_scene(k_mesh);
    EXPECT_GE(count(scene), 9);
    for (Material& m : scene.materials) m.texture = k_none;
    EXPECT_EQ(count(scene), 0);
}

}  // namespace
}  // namespace glint::test
