// SPDX-License-Identifier: Apache-2.0
// Faults of cylinders, of the numbers of colors, and of attenuation that a scene does not have.
#include <cmath>

#include "compare/scene_faults.h"

namespace glint {
namespace {

constexpr double k_unbounded = 1000;  // lengths of a cylinder that is not cut

// The renderer leaves out a fault that changes no shape.
template <class Change> void for_each_cylinder(Scene& s, Change&& change) {
    for (Cylinder& cylinder : s.get<Cylinder>()) change(cylinder);
}
// Both ends, by so many lengths of the axis.
void extend(Cylinder& c, double from, double to) {
    const Vec3 axis = c.to - c.from;
    c.from = c.from - axis * from;
    c.to = c.to + axis * to;
}
void remove_caps(Scene& s) {
    for_each_cylinder(s, [](Cylinder& c) { c.caps = false; });
    for (Cone& cone : s.get<Cone>()) cone.caps = false;
}
bool always(const Scene&) { return true; }

bool has_part(const Color& c) { return (c.r > 0 && c.r < 1) || (c.g > 0 && c.g < 1) || (c.b > 0 && c.b < 1); }
Color whole(const Color& c) { return {std::floor(c.r), std::floor(c.g), std::floor(c.b)}; }
double divided(double part, double was, double now) { return was > 0 ? part / was * now : part; }
Color with_color(const Color& coefficient, const Color& was, const Color& now) {
    return {divided(coefficient.r, was.r, now.r), divided(coefficient.g, was.g, now.g),
            divided(coefficient.b, was.b, now.b)};
}
void divide_as_integers(Material& m) {
    const Color was = m.color, now = whole(m.color);
    m.ambient = with_color(m.ambient, was, now);
    m.diffuse = with_color(m.diffuse, was, now);
    m.color = now;
}

bool has_plain_lights(const Scene& s) {
    return is_lit(s) && any_light(s, [](const Light& l) { return !is_ambient(l) && l.has_position(); }) &&
           !any_light(s, [](const Light& l) { return !(l.attenuation == Attenuation{}); });
}
void attenuate(Scene& s, const Attenuation& attenuation) {
    for_each_light(s, [&](Light& l) {
        if (l.has_position()) l.attenuation = attenuation;
    });
    s.conventions.clamp_attenuation = false;
}

constexpr SceneFault k_shapes[] = {
    {.name = "cylinder-height",
     .applies = always,
     .explanation = "Cylinders are twice as long as they should be: cut them at half the height on each side "
                    "of the centre.",
     .reshape = [](Scene& s) { for_each_cylinder(s, [](Cylinder& c) { extend(c, 0.5, 0.5); }); }},
    {.name = "cylinder-height",
     .applies = always,
     .explanation = "Cylinders have half of their length: their centre's distance from both ends is half the "
                    "height, not a quarter of it.",
     .reshape = [](Scene& s) { for_each_cylinder(s, [](Cylinder& c) { extend(c, -0.25, -0.25); }); }},
    {.name = "cylinder-height",
     .applies = always,
     .explanation =
         "Cylinders are twice as long as they should be, at their second end: cut them at the height.",
     .reshape = [](Scene& s) { for_each_cylinder(s, [](Cylinder& c) { extend(c, 0, 1); }); }},
    {.name = "cylinder-height",
     .applies = always,
     .explanation = "Cylinders are twice as long as they should be, at their first end: cut them there, too.",
     .reshape = [](Scene& s) { for_each_cylinder(s, [](Cylinder& c) { extend(c, 1, 0); }); }},
    {.name = "cylinder-height",
     .applies = always,
     .explanation =
         "Cylinders have half of their length, up to the middle: cut them at the height, not at half of it.",
     .reshape = [](Scene& s) { for_each_cylinder(s, [](Cylinder& c) { extend(c, 0, -0.5); }); }},
    {.name = "cylinder-height",
     .applies = always,
     .explanation = "Cylinders have half of their length, from the middle: cut them at their first end, not "
                    "half the height after it.",
     .reshape = [](Scene& s) { for_each_cylinder(s, [](Cylinder& c) { extend(c, -0.5, 0); }); }},
    {.name = "cylinder-unbounded",
     .applies = always,
     .explanation =
         "Cylinders have no end: ignore hits further from the centre, along the axis, than half the "
         "height.",
     .reshape =
         [](Scene& s) {
             for_each_cylinder(s, [](Cylinder& c) {
                 extend(c, k_unbounded, k_unbounded);
                 c.caps = false;
             });
         }},
    {.name = "caps-missing",
     .applies = always,
     .explanation = "The caps of cylinders and cones are missing: test the discs at their ends, too.",
     .reshape = remove_caps},
    {.name = "caps-missing",
     .applies = [](const Scene& s) { return s.conventions.facing == Facing::open; },
     .put = [](Scene& s) { s.conventions.facing = Facing::none; },
     .explanation = "The caps of cylinders and cones are missing, and their inner sides are dark: test the "
                    "discs at their ends, too.",
     .reshape = remove_caps},
    {"colors-truncated",
     [](const Scene& s) { return any_material(s, [](const Material& m) { return has_part(m.color); }); },
     [](Scene& s) {
         for_each_material(s, divide_as_integers);
         s.background = whole(s.background);
     },
     "Colors are divided as integers, so that each channel is 0 or 1: divide by 255.0."},
    {"colors-truncated",
     [](const Scene& s) {
         return has_part(s.background) &&
                any_material(s, [](const Material& m) { return has_part(m.color); });
     },
     [](Scene& s) { for_each_material(s, divide_as_integers); },
     "Colors of materials are divided as integers, so that each channel is 0 or 1: divide by 255.0."},
    {"attenuation-added", has_plain_lights,
     [](Scene& s) {
         attenuate(s, {0, 1, 0});
     },
     "Light is divided by the distance, and in the reference it is not."},
    {"attenuation-added", has_plain_lights,
     [](Scene& s) {
         attenuate(s, {0, 0, 1});
     },
     "Light is divided by the square of the distance, and in the reference it is not."},
    {"attenuation-added", has_plain_lights,
     [](Scene& s) {
         attenuate(s, {1, 1, 0});
     },
     "Light is divided by 1 + the distance, and in the reference it is not."},
};

}  // namespace

std::span<const SceneFault> shape_faults() { return k_shapes; }

}  // namespace glint
