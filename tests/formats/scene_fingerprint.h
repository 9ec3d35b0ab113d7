// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene as one text: everything that affects its picture, and its names. Two scenes render to the same bits
// if and only if their texts are equal. Numbers are written by their bits; unused items are omitted.
#include <bit>
#include <span>
#include <string>

#include "glint/glint.h"

namespace glint::test {

class SceneFingerprint {
  public:
    static std::string text(const Scene& scene) { return SceneFingerprint(scene).run(); }

  private:
    explicit SceneFingerprint(const Scene& scene) : s_(scene) {}

    void line(std::string_view what) {
        out_ += '\n';
        out_ += what;
    }
    void add(double x) {
        char buffer[40];
        std::snprintf(buffer, sizeof buffer, " %016llx", std::bit_cast<unsigned long long>(x));
        out_ += buffer;
    }
    void add(Vec3 v) { add(v.x), add(v.y), add(v.z); }
    void add(Color c) { add(Vec3{c.r, c.g, c.b}); }
    void add(bool b) { out_ += b ? " true" : " false"; }
    void add(std::span<const Vec3> points) {
        for (const Vec3& p : points) add(p);
    }
    void add(std::span<const TriangleCorners> triangles) {
        for (const TriangleCorners& t : triangles) {
            for (const std::uint32_t v : t) add(static_cast<double>(v));
        }
    }
    void add(const Sphere& s) { add(s.center), add(s.radius); }
    void add(const Plane& p) { add(p.point), add(p.normal); }
    void add(const Cylinder& c) { add(c.from), add(c.to), add(c.radius), add(c.caps); }
    void add(const Cone& c) { add(c.from), add(c.to), add(c.from_radius), add(c.to_radius), add(c.caps); }
    void add(const Disc& d) { add(d.center), add(d.normal), add(d.radius), add(d.hole); }
    void add(const Torus& t) { add(t.center), add(t.axis), add(t.radius), add(t.tube); }
    void add(const Quartic& q) {
        for (const double c : q.coefficients) add(c);
    }
    void add(const Quadric& q) { add(q.squares), add(q.products), add(q.linear), add(q.constant); }
    void add(const Box& c) { add(c.min), add(c.max); }
    void add(const Triangle& t) { add(std::span(t.vertices)); }
    void add(const SmoothTriangle& t) { add(std::span(t.vertices)), add(std::span(t.normals)); }
    void add(const Solid& solid) {
        const SolidTree& tree = s_.solids[solid.solid];
        for (const Shape& operand : tree.operands) {
            add_parameters(operand);
            if (operand.material != k_none) add(s_.materials[operand.material]);
            if (operand.transform != k_none) add(s_.transforms[operand.transform]);
        }
        for (const SolidStep& step : tree.steps)
            add(static_cast<double>(step.operation)), add(static_cast<double>(step.count));
    }
    void add(const Mesh& m) {
        const MeshData& mesh = *s_.meshes[m.mesh];
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) add(mesh.position(v));
        for (const CornerValues* values : {&mesh.normals, &mesh.colors}) {
            for (const Float3& v : values->values) add(to_vec3(v));
            add(std::span(values->corners));
        }
        add(std::span(mesh.triangles));
    }
    void add(const Polygon& p) { add(std::span(s_.polygon_vertices).subspan(p.first, p.count)); }
    void add(const Material& m) {
        add(m.color), add(m.ambient), add(m.diffuse), add(m.specular), add(m.shininess), add(m.mirror);
        add(m.mirror_tint), add(m.transmission), add(m.ior), add(m.transmission_tint);
        line(m.casts_shadow ? "casts a shadow" : "casts no shadow");
        add(m.emission), add(m.brilliance), add(m.metallic), add(m.phong), add(m.phong_shininess);
        add(m.tinted_highlight), add(m.mirror_falloff), add(m.mirror_min), add(m.mirror_metallic);
        add(m.mirror_fresnel), add(m.conserve_energy);
        add(m.filter), add(m.transmit), add(m.outline), add(m.outline_width), add(m.angled_opacity);
        add(m.fade_distance), add(m.fade_power), add(m.fade_color), add(m.caustics);
        add(m.hollow), add(m.one_sided), add(m.refracts), add(static_cast<double>(m.interior));
    }
    void add(const Affine& map) {
        for (const auto& row : map.m) {
            for (const double x : row) add(x);
        }
    }

    std::string run() {
        for (std::size_t i = 0; i < setting_keys().size(); ++i) {
            line(setting_keys()[i].name);
            out_ += ' ' + get_setting(s_, i);
        }
        line("background");
        add(s_.background);
        if (s_.fog) {
            line("fog");
            out_ += ' ' + std::string(to_string(s_.fog->kind));
            add(s_.fog->color);
            add(s_.fog->start), add(s_.fog->transmit), add(s_.fog->filter);
            add(s_.fog->has_density() ? s_.fog->density : s_.fog->end);
        }
        if (s_.gradient) {
            const BackgroundGradient& g = *s_.gradient;
            line("gradient");
            out_ += ' ' + std::string(to_string(g.kind));
            add(g.up), add(g.bottom), add(g.top), add(g.bottom_color), add(g.top_color),
                add(g.repeats ? 1.0 : 0.0);
        }
        if (s_.occlusion) {
            const Occlusion& o = *s_.occlusion;
            line("occlusion");
            out_ += ' ' + std::string(to_string(o.method));
            add(static_cast<double>(o.samples)), add(o.color), add(o.reach), add(o.direct);
        }
        add_camera();
        for (std::uint32_t i = 0; i < s_.lights.size(); ++i) add_light(i);
        for (std::uint32_t i = 0; i < s_.shapes.size(); ++i) add_shape(i);
        return out_;
    }

    void add_camera() {
        const Camera& c = s_.camera;
        line(c.projection == Projection::perspective ? "perspective" : "orthographic");
        add(c.position);
        if (c.frame) {
            line("frame");
            add(c.frame->right), add(c.frame->up), add(c.frame->forward);
        } else {
            line(c.fov_axis == FovAxis::x || c.projection == Projection::orthographic ? "x" : "y");
            add(c.look_at), add(c.up);
            add(c.projection == Projection::perspective ? c.fov_degrees : c.width);
        }
        if (!c.lighting_eye) return;
        line("lighting_eye");
        add(*c.lighting_eye);
    }

    void add_light(std::uint32_t i) {
        const Light& l = s_.lights[i];
        line("light " + std::to_string(static_cast<int>(l.kind)));
        out_ += s_.light_texts.name(i);
        add(l.color);
        if (l.has_specular_color()) add(l.specular_color);
        if (l.has_direction()) add(l.to_light);
        if (l.has_position()) add(l.position);
        if (l.has_attenuation()) {
            add(Vec3{l.attenuation.c0, l.attenuation.c1, l.attenuation.c2});
            add(l.fade_distance), add(l.fade_power);
        }
        if (!l.is_ambient()) line(l.casts_shadows ? "casts shadows" : "casts no shadows");
        if (l.has_axis()) add(l.axis);
        if (l.is_parallelogram()) add(l.side_u), add(l.side_v);
        if (l.has_radius()) add(l.radius);
        if (l.may_be_one_sided()) add(l.one_sided ? 1.0 : 0.0);
        if (l.is_area()) {
            add(static_cast<double>(l.samples_u)), add(static_cast<double>(l.samples_v));
            add(static_cast<double>(l.adaptive)), add(l.jitter ? 1.0 : 0.0);
        }
        if (!l.is_spot()) return;
        add(l.inner_angle), add(l.outer_angle), add(l.tightness);
    }

    void add_parameters(const Shape& shape) {
        switch (shape.kind) {
#define GLINT_KIND(Type, word)            \
    case ShapeKind::word:                 \
        add(s_.get<Type>()[shape.index]); \
        break;
            GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
        }
    }

    void add_shape(std::uint32_t i) {
        const Shape& shape = s_.shapes[i];
        line(to_string(shape.kind));
        out_ += s_.shape_texts.name(i);
        add_parameters(shape);
        add(shape.material == k_none ? Material{} : s_.materials[shape.material]);
        if (const auto color = s_.shape_color(i)) line("own color"), add(*color);
        if (shape.transform != k_none) add(s_.transforms[shape.transform]);
    }

    const Scene& s_;
    std::string out_;
};

/// The first line in which the texts of two scenes differ, or an empty string.
inline std::string first_difference(const Scene& a, const Scene& b) {
    const std::string ta = SceneFingerprint::text(a), tb = SceneFingerprint::text(b);
    if (ta == tb) return {};
    std::size_t at = 0;
    while (at < ta.size() && at < tb.size() && ta[at] == tb[at]) ++at;
    const auto line = [&](const std::string& t) {
        const std::size_t begin = at == 0 ? 0 : t.rfind('\n', at - 1) + 1;
        return t.substr(begin, t.find('\n', at) - begin);
    };
    return line(ta) + "\n" + line(tb);
}

}  // namespace glint::test
