// SPDX-License-Identifier: Apache-2.0
// Faults of spots, area lights, fog, transparency and occlusion, planted in a scene, are the first that
// find_causes() names, and none of them is named where another fault is planted.
#include <algorithm>
#include <functional>
#include <limits>

#include "compare/planted_faults.h"

namespace glint::test {
namespace {

struct Planted {
    const char* cause;
    std::function<void(Scene&)> fault;
    const char* says = "";                  // a part of the explanation
    std::function<void(Scene&)> both = {};  // what the reference needs for the fault to show
};

const std::string k_room = R"(
background = (0.35, 0.45, 0.6)
camera { position = (0.5, 2.4, 7)  look_at = (0, 0.7, 0)  fov_x = 46 }
light { type = ambient  intensity = 0.3 }
material red { color = (0.9, 0.25, 0.2)  ambient = 0.2  diffuse = 0.7  specular = 0.3  shininess = 25 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.55)  ambient = 0.2  diffuse = 0.8 }
sphere "ball" { center = (-1.2, 0.9, 0.4)  radius = 0.9  material = red }
box { min = (0.7, 0, -0.8)  max = (1.7, 1.5, 0.2)  color = (0.3, 0.4, 0.8)  ambient = 0.2  diffuse = 0.8 }
render { size = 96 x 72  shading = phong  reflections = 2 }
)";
const std::string k_panel = k_room +
                            "light \"panel\" { type = parallelogram  position = (1.5, 5, 2)  side_u = (1.6, "
                            "0, 0)  side_v = (0, 0, 1.6)\n"
                            "  intensity = 0.7  samples_u = 4  samples_v = 4 }\n";
const std::string k_lamp_disc =
    k_room +
    "light \"lamp\" { type = disc  position = (2, 5, 3)  target = (0, 0, 0)  radius = 0.8  one_sided = true\n"
    "  intensity = 0.8  samples_u = 4  samples_v = 8 }\n";
const std::string k_point = k_room + "light \"lamp\" { position = (1.5, 5, 2)  intensity = 0.7 }\n";
const std::string k_spots =
    k_room +
    "light { type = spot  position = (-2, 5, 3)  target = (-0.8, 0, 0)  inner_angle = 10  outer_angle = 20\n"
    "  tightness = 3  intensity = 0.8 }\n"
    "light \"right\" { type = spot  position = (3, 4, 3)  target = (1, 0, 0.3)  inner_angle = 12  "
    "outer_angle = 18\n"
    "  intensity = 0.6 }\n";
const std::string k_foggy =
    k_point + "fog { type = exp  color = (0.7, 0.7, 0.8)  density = 0.08  start = 3 }\n";
const std::string k_glass =
    k_point +
    "disc { center = (-0.4, 1.3, 2)  normal = (0.3, 0.9, 0.5)  radius = 0.8  color = (0.9, 0.6, 0.1)\n"
    "  ambient = 0.3  diffuse = 0.5  specular = 0.5  shininess = 30  filter = 0.5  transmit = 0.2 }\n"
    "sphere { center = (1.3, 0.6, 1.6)  radius = 0.6  color = (0.2, 0.8, 0.4)  ambient = 0.2  diffuse = 0.6\n"
    "  transmit = 0.6 }\n";
const std::string k_occluded = k_point + "occlusion { samples = 12  color = (0.5, 0.5, 0.6)  reach = 2.5 }\n";

template <class Change> void change_lights(Scene& s, Change&& change) {
    for (Light& l : s.lights) {
        if (!l.is_ambient()) change(l);
    }
}
template <class Change> void change_materials(Scene& s, Change&& change) {
    for (Material& m : s.materials) change(m);
}

const Planted k_of_panel[] = {
    {"shadows-hard", [](Scene& s) { change_lights(s, [](Light& l) { l.kind = LightKind::point; }); },
     "Shadows have hard edges"},
    {"shadows-missing", [](Scene& s) { s.settings.shadows = false; }},
    {"area-light-samples",
     [](Scene& s) { change_lights(s, [](Light& l) { l.samples_u = l.samples_v = 2; }); },
     "2 x 2 samples, and in the scene 4 x 4"},
    {"area-light-samples",
     [](Scene& s) { change_lights(s, [](Light& l) { l.samples_u = l.samples_v = 8; }); }, "8 x 8"},
    {"area-light-scaled",
     [](Scene& s) {
         change_lights(s, [](Light& l) {
             l.side_u = l.side_u * 2;
             l.side_v = l.side_v * 2;
         });
     },
     "twice"},
    {"area-light-jitter", [](Scene& s) { change_lights(s, [](Light& l) { l.jitter = true; }); }},
    {"area-light-one-sided", [](Scene& s) { change_lights(s, [](Light& l) { l.one_sided = true; }); }},
    {"area-light-shading", [](Scene& s) { s.conventions.area_shading = AreaShading::center; }},
};
const Planted k_of_disc[] = {
    {"shadows-hard", [](Scene& s) { change_lights(s, [](Light& l) { l.kind = LightKind::point; }); }},
    {"shadows-hard",  // with the emitter's cosine
     [](Scene& s) {
         change_lights(s, [](Light& l) {
             const Vec3 axis = l.axis;
             l.kind = LightKind::parallelogram;
             l.side_u = {axis.y, -axis.x, 0};
             l.side_v = {axis.y * 0 - axis.z * -axis.x, axis.z * axis.y - axis.x * 0,
                         -axis.x * axis.x - axis.y * axis.y};
             l.samples_u = l.samples_v = 1;
         });
     }},
    {"area-light-two-sided", [](Scene& s) { change_lights(s, [](Light& l) { l.one_sided = false; }); }},
    {"area-light-samples",
     [](Scene& s) { change_lights(s, [](Light& l) { l.samples_u = 2, l.samples_v = 4; }); },
     "2 x 4 samples, and in the scene 4 x 8"},
    {"light-moved", [](Scene& s) { change_lights(s, [](Light& l) { l.position.x += 0.6; }); }},
};
const Planted k_of_point[] = {
    {"shadows-soft",
     [](Scene& s) {
         change_lights(s, [](Light& l) {
             l.kind = LightKind::sphere;
             l.radius = 0.6;
         });
     },
     "a radius of about 0.6 in place of light 2 (\"lamp\""},
    {"shadows-missing", [](Scene& s) { s.settings.shadows = false; }},
    {"light-moved", [](Scene& s) { change_lights(s, [](Light& l) { l.position.z += 0.5; }); }},
};
const Planted k_of_spots[] = {
    {"spot-missing", [](Scene& s) { change_lights(s, [](Light& l) { l.kind = LightKind::point; }); },
     "Spots shine in all directions"},
    {"spot-edge-hard",
     [](Scene& s) {
         change_lights(s, [](Light& l) {
             l.inner_angle = l.outer_angle;
             l.tightness = 0;
         });
     },
     "ends abruptly"},
    {"spot-falloff", [](Scene& s) { s.conventions.spot_falloff = SpotFalloff::linear; }},
    {"spot-tightness-missing", [](Scene& s) { change_lights(s, [](Light& l) { l.tightness = 0; }); }},
    {"spot-angle-scaled",
     [](Scene& s) { change_lights(s, [](Light& l) { l.inner_angle /= 2, l.outer_angle /= 2; }); }, "half"},
    {"spot-turned",
     [](Scene& s) {
         s.lights[2].axis = s.lights[2].axis + Vec3{0.4, 0, 0};
     },
     "(\"right\""},
    {"light-missing",
     [](Scene& s) {
         s.lights[2].color = s.lights[2].specular_color = {0, 0, 0};
     }},
};
const Planted k_of_fog[] = {
    {"fog-missing", [](Scene& s) { s.fog.reset(); }, "The fog is missing"},
    {"fog-background", [](Scene& s) { s.conventions.fog_background = false; }},
    {"fog-distance", [](Scene& s) { s.conventions.fog_distance = FogDistance::depth; }},
    {"fog-start-missing", [](Scene& s) { s.fog->start = 0; }},
    {"fog-scaled", [](Scene& s) { s.fog->density *= 1.7; }, "The fog is 1.7 times as dense"},
    {"fog-kind", [](Scene& s) { s.fog->kind = FogKind::exp2; }, "exp(-x^2)"},
    {"fog-kind",
     [](Scene& s) {
         s.fog->kind = FogKind::linear;
         s.fog->end = 30;
     },
     "linearly"},
    {"fog-color",
     [](Scene& s) {
         s.fog->color = {0.4, 0.5, 0.9};
     },
     "(0.4, 0.5, 0.9)"},
    {"specular-missing", [](Scene& s) { change_materials(s, [](Material& m) {
                                            m.specular = {0, 0, 0};
                                        }); }},
    {"not-normalized", [](Scene& s) { s.conventions.normalize = false; }},
};
const Planted k_of_glass[] = {
    {"fog-extent", [](Scene& s) { s.conventions.fog_extent = FogExtent::everywhere; },
     "Inside transparent objects there is fog",
     [](Scene& s) {
         s.fog = Fog{FogKind::exp, {0.9, 0.2, 0.1}, 0.1, 0, 0, 0};
         s.conventions.fog_extent = FogExtent::outside_objects;
     }},
    {"transparency-missing",
     [](Scene& s) { change_materials(s, [](Material& m) { m.filter = m.transmit = 0; }); },
     "times transmit + filter * color."},
    {"transparency-missing",
     [](Scene& s) { change_materials(s, [](Material& m) { m.filter = m.transmit = 0; }); },
     "with `angled_opacity`, times 1 - the opacity at this angle",
     [](Scene& s) {
         change_materials(s, [](Material& m) {
             m.transmit += m.filter;
             m.filter = 0;
             m.angled_opacity = true;
         });
     }},
    {"transparent-shadow-opaque",
     [](Scene& s) { s.conventions.transparent_shadow = TransparentShadow::opaque; }},
    {"transparent-shadow-missing",
     [](Scene& s) { s.conventions.transparent_shadow = TransparentShadow::none; }},
    {"transparent-shadow-colored",
     [](Scene& s) { s.conventions.transparent_shadow = TransparentShadow::colored; }, "",
     [](Scene& s) { s.conventions.transparent_shadow = TransparentShadow::opaque; }},
    {"filter-not-tinted",
     [](Scene& s) {
         change_materials(s, [](Material& m) {
             m.transmit += m.filter;
             m.filter = 0;
         });
     }},
    {"transmit-tinted",
     [](Scene& s) {
         change_materials(s, [](Material& m) {
             m.filter += m.transmit;
             m.transmit = 0;
         });
     }},
    {"transparency-added", [](Scene& s) { s.conventions.transparency = Transparency::add; }},
    {"transparency-blended", [](Scene& s) { s.conventions.transparency = Transparency::blend; }},
    {"transparency-highlights", [](Scene& s) { s.conventions.transparency = Transparency::highlights; }, "",
     [](Scene& s) { s.conventions.transparency = Transparency::add; }},
    {"transparency-opacity", [](Scene& s) { s.conventions.opacity = OpacityRule::brightest; }},
    {"transparency-counts", [](Scene& s) { s.conventions.transparency_counts = true; }, "",
     [](Scene& s) { s.settings.reflections = 1; }},
    {"specular-missing", [](Scene& s) { change_materials(s, [](Material& m) {
                                            m.specular = {0, 0, 0};
                                        }); }},
    {"light-missing", [](Scene& s) { s.lights.pop_back(); }, "",
     [](Scene& s) {
         s.lights.push_back(s.lights.back());
         s.lights.back().position = {-4, 5, 3};
     }},
};
const Planted k_of_occlusion[] = {
    {"occlusion-missing", [](Scene& s) { s.occlusion.reset(); }, "The light from all directions is missing"},
    {"occlusion-missing", [](Scene& s) { s.occlusion.reset(); }, "`direct`",
     [](Scene& s) { s.occlusion->direct = 0.6; }},
    {"occlusion-missing",
     [](Scene& s) {
         s.occlusion->color = {0, 0, 0};
     },
     "times its color", [](Scene& s) { s.occlusion->direct = 0.6; }},
    {"occlusion-scaled", [](Scene& s) { s.occlusion->color = s.occlusion->color * 0.5; }, "0.5 times"},
    {"occlusion-unblocked", [](Scene& s) { s.occlusion->reach = 1e-12; }},
    {"occlusion-reach", [](Scene& s) { s.occlusion->reach = std::numeric_limits<double>::infinity(); }},
    {"occlusion-method", [](Scene& s) { s.occlusion->method = OcclusionMethod::fixed; }},
    {"ambient-missing",
     [](Scene& s) {
         s.lights.front().color = {0, 0, 0};
     }},
};
const Planted k_of_finish[] = {
    {"emission-missing", [](Scene& s) { change_materials(s, [](Material& m) {
                                            m.emission = {0, 0, 0};
                                        }); }},
    {"emission-scaled",
     [](Scene& s) { change_materials(s, [](Material& m) { m.emission = m.emission * 2; }); }, "2 times"},
    {"specular-missing",
     [](Scene& s) { change_materials(s, [](Material& m) {
                        m.specular = m.phong = {0, 0, 0};
                    }); }},
    {"exponent",
     [](Scene& s) { change_materials(s, [](Material& m) { m.shininess *= 2, m.phong_shininess *= 2; }); },
     "twice"},
};

// Sanitizers make the search slow, and a few faults run the same code as all.
#if defined(GLINT_SANITIZED)
constexpr std::size_t k_most_planted = 2;
#else
constexpr std::size_t k_most_planted = 100;
#endif

void expect_named(const std::string& text, std::span<const Planted> list) {
    list = list.first(std::min(list.size(), k_most_planted));
    for (const Planted& planted : list) {
        Scene right = read_scene(text);
        if (planted.both) planted.both(right);
        Scene wrong = right;
        planted.fault(wrong);
        const Image reference = as_file(draw(right)), picture = as_file(draw(wrong));
        EXPECT_NE(reference.rgb, picture.rgb) << planted.cause << ": nothing was planted";
        const Result<CauseReport> report = find_causes(picture, reference, &right);
        EXPECT_EQ(first_cause(report), planted.cause)
            << all_causes(report)
            << (report && report->nearest ? report->nearest->name + std::to_string(report->nearest->explained)
                                          : "");
        if (!report || report->causes.empty()) continue;
        const Cause& cause = report->causes.front();
        EXPECT_NE(cause.explanation.find(planted.says), std::string::npos) << cause.explanation;
        EXPECT_GT(cause.explained, 0.8) << cause.explanation;
    }
}

TEST(CausesOfLight, AnAreaLight) { expect_named(k_panel, k_of_panel); }
TEST(CausesOfLight, AOneSidedDisc) { expect_named(k_lamp_disc, k_of_disc); }
TEST(CausesOfLight, APointLight) { expect_named(k_point, k_of_point); }
#if !defined(GLINT_SANITIZED)
// A light of another form than the fitted sphere's is one of the causes.
TEST(CausesOfLight, ASoftShadowOfAPanel) {
    const Scene right = read_scene(k_point);
    Scene wrong = right;
    Light& lamp = wrong.lights.back();
    lamp.kind = LightKind::parallelogram;
    lamp.side_u = {1.2, 0, 0};
    lamp.side_v = {0, 0, 1.2};
    lamp.samples_u = lamp.samples_v = 8;
    const Result<CauseReport> report = find_causes(as_file(draw(wrong)), as_file(draw(right)), &right);
    EXPECT_NE(all_causes(report).find("shadows-soft"), std::string::npos) << all_causes(report);
}
#endif
TEST(CausesOfLight, Spots) { expect_named(k_spots, k_of_spots); }
TEST(CausesOfMedia, Fog) { expect_named(k_foggy, k_of_fog); }
TEST(CausesOfMedia, Transparency) { expect_named(k_glass, k_of_glass); }
TEST(CausesOfMedia, Occlusion) { expect_named(k_occluded, k_of_occlusion); }
TEST(CausesOfLight, Finishes) {
    expect_named(
        k_point +
            "sphere { center = (0.3, 0.5, 2)  radius = 0.5  color = (0.5, 0.5, 0.6)  emission = 0.3\n"
            "  phong_color = (0.6, 0.6, 0.6)  phong_shininess = 20 }\n",
        k_of_finish);
}

}  // namespace
}  // namespace glint::test
