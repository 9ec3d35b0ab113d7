// SPDX-License-Identifier: Apache-2.0
// Faults of programs that take a number of another material or light, exchange two, or leave one out.
#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/scene_faults.h"
#include "math/srgb.h"

namespace glint {
namespace {

bool has_materials(const Scene& s) { return is_lit(s) && s.materials.size() > 1; }
bool has_shiny_materials(const Scene& s) { return has_highlights(s) && s.materials.size() > 1; }
bool has_ambient(const Scene& s) { return is_lit(s) && any_light(s, is_ambient); }

// k of part = k color, by the largest channel of the color.
double coefficient(const Color& part, const Color& color) {
    const double most = largest(color);
    if (most <= 0) return 0;
    return (most == color.r ? part.r : most == color.g ? part.g : part.b) / most;
}
double diffuse_of(const Material& m) { return coefficient(m.diffuse, m.color); }
Color grey(double level) { return {level, level, level}; }

bool has_colored_highlight(const Material& m) {
    const double k = coefficient(m.specular, m.color);
    const Color off = m.specular + m.color * -k;
    return k > 0 && !(m.color == grey(m.color.r)) &&
           std::abs(off.r) + std::abs(off.g) + std::abs(off.b) < 1e-9;
}

// k_s, and k_s as a color: highlights are white, or have the surface's color.
struct Highlights {
    bool colored;
    explicit Highlights(const Scene& s) : colored(any_material(s, has_colored_highlight)) {}
    double of(const Material& m) const {
        return colored ? coefficient(m.specular, m.color) : largest(m.specular);
    }
    Color with(const Material& m, double k) const { return colored ? m.color * k : grey(k); }
};

bool has_colored_highlights(const Scene& s) { return has_highlights(s) && Highlights(s).colored; }
void take_color_from_highlights(Scene& s) {
    for_each_material(s, [highlights = Highlights(s)](Material& m) { m.specular = grey(highlights.of(m)); });
}

// Lights that shine and are not ambient.
std::size_t count_lights(const Scene& s) {
    return static_cast<std::size_t>(std::count_if(
        s.lights.begin(), s.lights.end(), [](const Light& l) { return !is_ambient(l) && !is_off(l); }));
}
bool has_two_lights(const Scene& s) { return is_lit(s) && count_lights(s) > 1; }

// Of one of those lights.
void keep_term_of(Scene& s, std::size_t kept, Color Light::*term) {
    std::size_t number = 0;
    for_each_light(s, [&](Light& l) {
        if (number++ != kept) l.*term = {0, 0, 0};
    });
}

bool is_point(const Light& l) { return l.has_position() && !l.is_spot() && !l.is_area() && !is_off(l); }
bool is_sun(const Light& l) { return l.has_direction() && !is_off(l); }
bool has_points(const Scene& s) { return is_lit(s) && any_light(s, is_point); }
bool has_suns(const Scene& s) { return is_lit(s) && any_light(s, is_sun); }
bool has_both(const Scene& s) {
    return has_shadows(s) && has_suns(s) &&
           any_light(s, [](const Light& l) { return l.has_position() && !is_off(l); });
}

void make_directional(Light& l, Vec3 to_light) {
    l.kind = LightKind::directional;
    l.to_light = to_light;
    l.attenuation = {};
}

// Else a curve of their colors is a factor.
bool has_unlike_channels(const Scene& s) {
    std::vector<double> values;
    for (const Light& l : s.lights) {
        for (const double v : {l.color.r, l.color.g, l.color.b}) {
            if (!is_ambient(l) && v > 0) values.push_back(v);
        }
    }
    return is_lit(s) && !values.empty() &&
           std::count(values.begin(), values.end(), values[0]) < std::ssize(values);
}
void change_lights(Scene& s, double (*change)(double)) {
    for_each_light(s, [=](Light& l) {
        for (Color* const c : {&l.color, &l.specular_color}) *c = {change(c->r), change(c->g), change(c->b)};
    });
}

// Copies of the lights cast no shadows, and take over their light but for these parts of both terms.
void light_shadows(Scene& s, double diffuse, double specular) {
    const std::size_t count = s.lights.size();
    for (std::size_t i = 0; i < count; ++i) {
        Light& light = s.lights[i];
        if (is_ambient(light) || is_off(light) || !light.casts_shadows) continue;
        Light copy = light;
        copy.casts_shadows = false;
        copy.color = copy.color * (1 - diffuse);
        copy.specular_color = copy.specular_color * (1 - specular);
        light.color = light.color * diffuse;
        light.specular_color = light.specular_color * specular;
        s.lights.push_back(copy);
    }
}

void give_all(Scene& s, const Material& material) {
    const Material copy = material;
    for_each_material(s, [&](Material& m) { m = copy; });
}

constexpr SceneFault k_mixed_up[] = {
    {"material-of-another", has_materials, [](Scene& s) { give_all(s, s.materials.front()); },
     "All shapes have the first material: use that of the shape that the ray hits."},
    {"material-of-another", has_materials, [](Scene& s) { give_all(s, s.materials.back()); },
     "All shapes have the last material: use that of the shape that the ray hits."},
    {"material-of-another", has_shiny_materials,
     [](Scene& s) {
         for_each_material(s, [n = s.materials.front().shininess](Material& m) { m.shininess = n; });
     },
     "All shapes have the exponent of the first material: use that of the shape that the ray hits."},
    {"material-of-another",
     [](const Scene& s) { return has_shiny_materials(s) && !is_zero(s.materials.front().specular); },
     [](Scene& s) {
         for_each_material(s, [k = s.materials.front().specular](Material& m) { m.specular = k; });
     },
     "All shapes have the k_s of the first material: use that of the shape that the ray hits."},
    {"coefficients-exchanged", has_highlights,
     [](Scene& s) {
         for_each_material(s, [highlights = Highlights(s)](Material& m) {
             const double diffuse = diffuse_of(m);
             m.diffuse = m.color * highlights.of(m);
             m.specular = highlights.with(m, diffuse);
         });
     },
     "k_d and k_s are exchanged."},
    {"coefficients-exchanged", has_highlights,
     [](Scene& s) { for_each_material(s, [](Material& m) { std::swap(m.diffuse, m.specular); }); },
     "k_d and k_s are exchanged, with their colors."},
    {"coefficients-exchanged", has_highlights,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.diffuse = m.specular; }); },
     "The diffuse term is multiplied by k_s and its color, not by k_d."},
    {"coefficients-exchanged", has_highlights,
     [](Scene& s) {
         for_each_material(
             s, [highlights = Highlights(s)](Material& m) { m.diffuse = m.color * highlights.of(m); });
     },
     "The diffuse term is multiplied by k_s, not by k_d."},
    {"coefficients-exchanged", is_lit,
     [](Scene& s) {
         for_each_material(s, [highlights = Highlights(s)](Material& m) {
             m.specular = highlights.with(m, diffuse_of(m));
         });
     },
     "The specular term is multiplied by k_d, not by k_s."},
    {"mirror-coefficient", [](const Scene& s) { return has_mirrors(s) && has_highlights(s); },
     [](Scene& s) {
         for_each_material(s, [highlights = Highlights(s)](Material& m) {
             if (m.mirror > 0) m.mirror = std::min(highlights.of(m), 1.0);
         });
     },
     "The reflected color is multiplied by k_s, not by the mirrors' own coefficient."},
    {"mirror-coefficient", [](const Scene& s) { return has_mirrors(s) && has_highlights(s); },
     [](Scene& s) {
         for_each_material(
             s, [highlights = Highlights(s)](Material& m) { m.mirror = std::min(highlights.of(m), 1.0); });
     },
     "All shapes are mirrors: the reflected color is multiplied by k_s, not by their own coefficient."},
    {"coefficients-exchanged", has_ambient,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.ambient = m.diffuse; }); },
     "The ambient term is multiplied by k_d, not by k_a."},
    {"coefficients-exchanged", has_ambient,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.diffuse = m.ambient; }); },
     "The diffuse term is multiplied by k_a, not by k_d."},
    {"diffuse-without-color", is_lit,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.diffuse = grey(diffuse_of(m)); }); },
     "The diffuse term is not multiplied by the surface's color."},
    {"diffuse-without-color", is_lit,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.diffuse = grey(largest(m.diffuse)); }); },
     "The diffuse term has the largest channel of the surface's color in all three."},
    {"ambient-without-color", has_ambient,
     [](Scene& s) {
         for_each_material(s, [](Material& m) { m.ambient = grey(coefficient(m.ambient, m.color)); });
     },
     "The ambient term is not multiplied by the surface's color."},
    {"highlight-not-surface-color", has_colored_highlights, take_color_from_highlights,
     "Highlights are white, and in the reference they have the surface's color: multiply the specular term "
     "by it."},
    {"highlight-not-light-color", has_colored_highlights,
     [](Scene& s) {
         take_color_from_highlights(s);
         for_each_light(s, [](Light& l) { l.specular_color = {1, 1, 1}; });
     },
     "The specular term is k_s (R.V)^n, or k_s (N.H)^n, alone: multiply it by the color of the surface and "
     "by that of the light."},
    {"light-color-ignored", is_lit,
     [](Scene& s) { for_each_light(s, [](Light& l) {
                        l.color = {1, 1, 1};
                    }); },
     "The diffuse term is not multiplied by the lights' color and intensity: multiply the whole sum k_d "
     "(N.L) + k_s (R.V)^n by "
     "it."},
    {"ambient-without-material", has_ambient,
     [](Scene& s) { for_each_material(s, [](Material& m) {
                        m.ambient = {1, 1, 1};
                    }); },
     "Ambient light is added as it is: multiply it by the material's k_a."},
    {"ambient-without-material", has_ambient,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.ambient = m.color; }); },
     "Ambient light is multiplied by the surface's color, but not by k_a."},
    {"highlight-of-one-light", [](const Scene& s) { return has_highlights(s) && has_two_lights(s); },
     [](Scene& s) { keep_term_of(s, 0, &Light::specular_color); },
     "Only the first light has highlights: add the specular term for every light."},
    {"highlight-of-one-light", [](const Scene& s) { return has_highlights(s) && has_two_lights(s); },
     [](Scene& s) { keep_term_of(s, count_lights(s) - 1, &Light::specular_color); },
     "Only the last light has highlights: add the specular term for every light."},
    {"diffuse-of-one-light", has_two_lights, [](Scene& s) { keep_term_of(s, 0, &Light::color); },
     "Only the first light has a diffuse term: add it for every light."},
    {"light-color-twice", has_unlike_channels,
     [](Scene& s) { change_lights(s, [](double v) { return v * v; }); },
     "Lights are multiplied by their color or their intensity twice: once is enough."},
    {"color-decoded", has_unlike_channels, [](Scene& s) { change_lights(s, decode_power); },
     "The colors of lights are decoded, by the power 2.2: use them as they are."},
    {"color-decoded", has_unlike_channels, [](Scene& s) { change_lights(s, srgb_decode); },
     "The colors of lights are decoded, by the sRGB curve: use them as they are."},
    {"light-axes-exchanged", is_lit,
     [](Scene& s) {
         for_each_light(s, [](Light& l) {
             std::swap(l.position.y, l.position.z);
             std::swap(l.to_light.y, l.to_light.z);
         });
     },
     "y and z of the lights' positions and directions are exchanged."},
    {"light-vector", has_points,
     [](Scene& s) {
         for_each_light(s, [eye = s.camera.position](Light& l) {
             if (is_point(l)) make_directional(l, l.position - eye);
         });
     },
     "L goes from the eye to the light: it goes from the point P."},
    {"light-of-another", has_two_lights,
     [](Scene& s) {
         const Light* first = nullptr;
         for_each_light(s, [&](Light& l) {
             if (first == nullptr) first = &l;
             l.color = first->color;
             l.specular_color = first->specular_color;
         });
     },
     "All lights have the color and the intensity of the first: use those of each light."},
    {"light-vector", has_points,
     [](Scene& s) {
         for_each_light(s, [](Light& l) {
             if (is_point(l)) make_directional(l, l.position);
         });
     },
     "L is the position of a light: subtract P, as L goes from the point to the light."},
    {"light-vector", has_suns,
     [](Scene& s) {
         for_each_light(s, [](Light& l) {
             if (!is_sun(l)) return;
             l.kind = LightKind::point;
             l.position = l.to_light;
         });
     },
     "P is subtracted from the direction of a directional light: its L is that direction, at every point."},
    {"shadows-missing", has_both,
     [](Scene& s) {
         for_each_light(s, [](Light& l) {
             if (is_sun(l)) l.casts_shadows = false;
         });
     },
     "Directional lights cast no shadows: test their shadow rays, too, without a limit to t."},
    {"shadows-missing", has_both,
     [](Scene& s) {
         for_each_light(s, [](Light& l) {
             if (!is_sun(l)) l.casts_shadows = false;
         });
     },
     "Only directional lights cast shadows: test the shadow rays of the other lights, too."},
    {"shadow-of-one-term", [](const Scene& s) { return has_shadows(s) && has_highlights(s); },
     [](Scene& s) { light_shadows(s, 1, 0); },
     "Shadows darken the diffuse term alone: a light that does not reach a point has no highlight there."},
    {"shadow-of-one-term", [](const Scene& s) { return has_shadows(s) && has_highlights(s); },
     [](Scene& s) { light_shadows(s, 0, 1); },
     "Shadows remove the highlight alone: a light that does not reach a point has no diffuse term there."},
    {"shadow-part", has_shadows, [](Scene& s) { light_shadows(s, 0.5, 0.5); },
     "Half of a light remains in its shadow: a light that does not reach a point adds nothing."},
};

}  // namespace

std::span<const SceneFault> mixed_up_faults() { return k_mixed_up; }

}  // namespace glint
