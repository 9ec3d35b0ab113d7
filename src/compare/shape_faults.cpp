// SPDX-License-Identifier: Apache-2.0
// Faults of cylinders, of the numbers of colors, and of attenuation that a scene does not have.
#include <cmath>

#include "compare/scene_faults.h"
#include "math/srgb.h"

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
void change_color(Material& m, const Color& now) {
    const Color was = m.color;
    m.ambient = with_color(m.ambient, was, now);
    m.diffuse = with_color(m.diffuse, was, now);
    m.color = now;
}

void divide_as_integers(Material& m) { change_color(m, whole(m.color)); }
void decode_materials(Scene& s, double (*decode)(double)) {
    for_each_material(s, [=](Material& m) {
        change_color(m, {decode(m.color.r), decode(m.color.g), decode(m.color.b)});
    });
}
bool has_part_of_color(const Scene& s) {
    return any_material(s, [](const Material& m) { return has_part(m.color); });
}

// Triangles with corner p and sides e1 and e2 as parallelograms with the sides e1 and `factor` e2.
void fill_triangles(Scene& s, double factor) {
    const std::size_t count = s.shapes.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Shape shape = s.shapes[i];
        if (shape.kind != ShapeKind::triangle) continue;
        Vec3(&v)[3] = s.get<Triangle>()[shape.index].vertices;
        const Vec3 side = (v[2] - v[0]) * factor;
        const Triangle other{{v[0], v[1] + side, v[0] + side}};
        v[2] = v[1] + side;
        s.add(other, shape.material, shape.transform);
    }
}

// Of spheres of one size, that is a factor, as of a diameter.
void change_radii(Scene& s, double (*change)(double)) {
    std::vector<Sphere>& spheres = s.get<Sphere>();
    const auto has_other = [&](const Sphere& sphere) { return sphere.radius != spheres[0].radius; };
    if (std::none_of(spheres.begin(), spheres.end(), has_other)) return;
    for (Sphere& sphere : spheres) sphere.radius = change(sphere.radius);
}

// Of each material a second one follows, which casts no shadow.
void add_shadowless(Scene& s) {
    const std::size_t count = s.materials.size();
    s.materials.resize(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        s.materials[count + i] = s.materials[i];
        s.materials[count + i].casts_shadow = false;
    }
}
void give_shadowless(Scene& s, std::size_t shape) {
    s.shapes[shape].material += static_cast<std::uint32_t>(s.materials.size());
    add_shadowless(s);
}

template <ShapeKind kind> void give_kind_shadowless(Scene& s) {
    for (Shape& shape : s.shapes) {
        if (shape.kind == kind) shape.material += static_cast<std::uint32_t>(s.materials.size());
    }
    add_shadowless(s);
}

bool has_lamps(const Scene& s) {
    return is_lit(s) && any_light(s, [](const Light& l) { return !is_ambient(l) && l.has_position(); });
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
    {.name = "triangle-as-parallelogram",
     .applies = always,
     .explanation = "Triangles are parallelograms: a point is inside if u and v are not negative and u + v "
                    "is not above 1.",
     .reshape = [](Scene& s) { fill_triangles(s, 1); }},
    {.name = "triangle-as-parallelogram",
     .applies = always,
     .explanation = "Triangles have no third side: a point is inside if u and v are not negative and u + v "
                    "is not above 1.",
     .reshape = [](Scene& s) { fill_triangles(s, k_unbounded); }},
    {.name = "radius-squared",
     .applies = always,
     .explanation = "Spheres have the radius sqrt(r): c is (O - C).(O - C) - r^2, not - r.",
     .reshape = [](Scene& s) { change_radii(s, [](double r) { return std::sqrt(r); }); }},
    {.name = "radius-squared",
     .applies = always,
     .explanation = "Spheres have the radius r^2: c is (O - C).(O - C) - r^2.",
     .reshape = [](Scene& s) { change_radii(s, [](double r) { return r * r; }); }},
    {.name = "shadow-of-shape-missing",
     .applies = has_shadows,
     .put = add_shadowless,
     .explanation = "The last shape casts no shadow: test all shapes with shadow rays, too.",
     .reshape = [](Scene& s) { give_shadowless(s, s.shapes.size() - 1); }},
    {.name = "shadow-of-shape-missing",
     .applies = has_shadows,
     .put = add_shadowless,
     .explanation = "The first shape casts no shadow: test all shapes with shadow rays, too.",
     .reshape = [](Scene& s) { give_shadowless(s, 0); }},
    {.name = "shadow-of-shape-missing",
     .applies = has_shadows,
     .put = add_shadowless,
     .explanation = "Spheres cast no shadow: test all kinds of shapes with shadow rays.",
     .reshape = give_kind_shadowless<ShapeKind::sphere>},
    {.name = "shadow-of-shape-missing",
     .applies = has_shadows,
     .put = add_shadowless,
     .explanation = "Cylinders cast no shadow: test all kinds of shapes with shadow rays.",
     .reshape = give_kind_shadowless<ShapeKind::cylinder>},
    {.name = "shadow-of-shape-missing",
     .applies = has_shadows,
     .put = add_shadowless,
     .explanation = "Triangles cast no shadow: test all kinds of shapes with shadow rays.",
     .reshape = give_kind_shadowless<ShapeKind::triangle>},
    {.name = "shadow-of-shape-missing",
     .applies = has_shadows,
     .put = add_shadowless,
     .explanation = "Planes cast no shadow: test all kinds of shapes with shadow rays.",
     .reshape = give_kind_shadowless<ShapeKind::plane>},
    {"color-decoded", has_part_of_color, [](Scene& s) { decode_materials(s, decode_power); },
     "The colors of materials are decoded, by the power 2.2: use them as they are."},
    {"color-decoded", has_part_of_color, [](Scene& s) { decode_materials(s, srgb_decode); },
     "The colors of materials are decoded, by the sRGB curve: use them as they are."},
    {"colors-truncated", has_part_of_color,
     [](Scene& s) {
         for_each_material(s, divide_as_integers);
         s.background = whole(s.background);
     },
     "Colors are divided as integers, so that each channel is 0 or 1: divide by 255.0."},
    {"colors-truncated", [](const Scene& s) { return has_part(s.background) && has_part_of_color(s); },
     [](Scene& s) { for_each_material(s, divide_as_integers); },
     "Colors of materials are divided as integers, so that each channel is 0 or 1: divide by 255.0."},
    {"attenuation-added", has_lamps,
     [](Scene& s) {
         attenuate(s, {0, 1, 0});
     },
     "Light is divided by the distance, and not as in the reference."},
    {"attenuation-added", has_lamps,
     [](Scene& s) {
         attenuate(s, {0, 0, 1});
     },
     "Light is divided by the square of the distance, and not as in the reference."},
    {"attenuation-added", has_lamps,
     [](Scene& s) {
         attenuate(s, {1, 1, 0});
     },
     "Light is divided by 1 + the distance, and not as in the reference."},
};

}  // namespace

std::span<const SceneFault> shape_faults() { return k_shapes; }

}  // namespace glint
