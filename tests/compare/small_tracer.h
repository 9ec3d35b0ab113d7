// SPDX-License-Identifier: Apache-2.0
#pragma once
// A ray tracer of spheres and a floor as a student writes it, in scalar code of its own, with mistakes to
// switch on. The pictures of its scene without a mistake are those of glint within rounding.
#include <cmath>
#include <optional>
#include <vector>

#include "glint/glint.h"
#include "math/transform.h"

namespace glint::test {

struct Mistakes {
    bool l_raw = false, h_raw = false, n_raw = false;  ///< not normalised
    bool h_of_difference = false;                      ///< L - V in place of L + V
    bool n_reversed = false, r_negated = false, v_from_origin = false, v_fixed = false;
    bool v_is_p = false;  ///< P, not the eye's way from P
    bool v_raw = false;   ///< not normalised
    bool v_is_eye = false;
    bool n_from_origin = false;                           ///< of balls
    bool of_n_r = false, of_r_l = false, of_h_v = false;  ///< in place of R.V and N.H
    bool diffuse_of_view = false, diffuse_squared = false;
    /// Also in mirrors: the wrong V, and in their rays, N that is not normalised.
    bool v_anywhere = false, n_raw_in_mirrors = false;
    bool balls_reversed = false;  ///< N of balls only
    bool no_ambient_in_shadow = false;
    bool integer_sum = false;  ///< the color of a surface is an integer
    bool specular_times_cosine = false, diffuse_to_power = false, black_shadow = false;
    bool no_cosine = false;  ///< in the diffuse term
    bool mirror_plus = false, mirror_negated = false, mirror_along = false;
    bool local_clamped = false;  ///< before mirrors mix it
    bool last_hit = false, first_hit = false, accepts_behind = false;
    bool integer_colors = false;
    bool exponent_squared = false, fades_from_eye = false;
    bool mirror_colored = false, specular_is_diffuse = false;
    bool specular_colored = false;
    /// By the mean of white and the surface's color.
    bool mirror_half_colored = false, specular_half_colored = false;
    bool mirror_lit = false;  ///< by the lit color of the surface, not by its own
    bool h_halved = false, l_from_eye = false;
    /// Parts of the local color that are not times 1 - a, and what mirrors show, not times a.
    bool mirror_whole_shine = false, mirror_whole_ambient = false, mirror_whole_seen = false;
    /// What mirrors show: without shadows, without highlights, or in its own color.
    bool mirror_unshadowed = false, mirror_dull = false, mirror_flat = false;
    double schlick_power = 0;      ///< if not 0, mirrors reflect more at grazing angles
    double lambert_offset = 0;     ///< (N.L + this) / (1 + this)
    double shadow_limit = 0;       ///< if not 0, shapes further away cast no shadow
    double shadow_least = 0;       ///< shapes that are nearer cast none
    bool shadow_negated = false;   ///< shadow rays go away from the light
    bool last_casts_none = false;  ///< the last ball casts no shadow
    double dimming = 1;            ///< of the ambient term, for each lamp that does not reach
    bool root_of_radius = false;
    bool rays_to_corners = false;
    int distance_power = 0;             ///< light divided by d^this...
    double distance_offset = 0;         ///< ... plus this
    double x_factor = 1, y_factor = 1;  ///< of the picture plane
    double plane_factor = 1;            ///< of both
};

struct SmallBall {
    Vec3 center;
    double radius;
    Color color;
    double specular, shininess, mirror;
};

struct SmallScene {
    Vec3 eye;  ///< looks along -z
    double fov_y = 40;
    Color background{0.2, 0.3, 0.5};
    double ambient = 0.2;
    std::vector<Vec3> lamps;
    double lamp = 0.5;
    bool blinn = false;
    bool floor = true;  ///< y = 0, grey
    std::vector<SmallBall> balls;
    int width = 80, height = 60;
};

/// The scene in glint's language.
inline std::string text_of(const SmallScene& s) {
    const auto v = [](Vec3 p) {
        return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) + ")";
    };
    const auto n = [](double x) { return std::to_string(x); };
    std::string text = "background = " + v({s.background.r, s.background.g, s.background.b}) +
                       "\ncamera { position = " + v(s.eye) +
                       "  look_at = " + v({s.eye.x, s.eye.y, s.eye.z - 1}) + "  fov_y = " + n(s.fov_y) +
                       " }\n";
    text += "light { type = ambient  intensity = 1 }\n";
    for (const Vec3& lamp : s.lamps)
        text += "light { type = point  position = " + v(lamp) + "  intensity = " + n(s.lamp) + " }\n";
    if (s.floor)
        text +=
            "plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.6)  diffuse = 1  "
            "specular = 0  shininess = 1  ambient = " +
            n(s.ambient) + " }\n";
    for (const SmallBall& b : s.balls)
        text += "sphere { center = " + v(b.center) + "  radius = " + n(b.radius) +
                "  color = " + v({b.color.r, b.color.g, b.color.b}) +
                "  diffuse = 1  ambient = " + n(s.ambient) +
                "  specular_color = " + v({b.specular, b.specular, b.specular}) +
                "  shininess = " + n(b.shininess) + "  mirror = " + n(b.mirror) + " }\n";
    text += std::string("conventions { mirror_miss = background  facing = none }\nrender { size = ") +
            n(s.width).substr(0, 2) + " x " + n(s.height).substr(0, 2) +
            "  reflections = 3  shading = " + (s.blinn ? "blinn-phong" : "phong") + " }\n";
    return text;
}

class SmallTracer {
  public:
    SmallTracer(const SmallScene& scene, const Mistakes& mistakes) : s_(scene), m_(mistakes) {}

    Image draw() const {
        Image image{s_.width, s_.height, {}};
        const double half = std::tan(s_.fov_y / 2 * k_pi / 180) * m_.plane_factor;
        const double aspect = static_cast<double>(s_.width) / s_.height;
        for (int y = 0; y < s_.height; ++y) {
            for (int x = 0; x < s_.width; ++x) {
                double u = 2 * (x + 0.5) / s_.width - 1, v = 1 - 2 * (y + 0.5) / s_.height;
                if (m_.rays_to_corners) u = 2.0 * x / (s_.width - 1) - 1, v = 1 - 2.0 * y / (s_.height - 1);
                const Vec3 d{u * half * aspect * m_.x_factor, v * half * m_.y_factor, -1};
                const Color c = trace(s_.eye, normalize(d), 0);
                for (const double w : {c.r, c.g, c.b}) image.rgb.push_back(static_cast<float>(w));
            }
        }
        return image;
    }

  private:
    static constexpr double k_pi = 3.14159265358979323846, k_epsilon = 1e-6;
    struct Hit {
        double t;
        int shape;  // -1: the floor
    };

    // Shape i, where 0 is the floor.
    std::optional<double> hit(int i, Vec3 o, Vec3 d, double least) const {
        if (i == 0) {
            if (!s_.floor || d.y == 0) return std::nullopt;
            const double t = -o.y / d.y;
            return t > least ? std::optional(t) : std::nullopt;
        }
        const SmallBall& b = s_.balls[static_cast<std::size_t>(i - 1)];
        const Vec3 co = o - b.center;
        const double a = dot(d, d), half = dot(co, d),
                     c = dot(co, co) - (m_.root_of_radius ? b.radius : b.radius * b.radius);
        const double root = half * half - a * c;
        if (root < 0) return std::nullopt;
        for (const double t : {(-half - std::sqrt(root)) / a, (-half + std::sqrt(root)) / a}) {
            if (t > least) return t;
        }
        return std::nullopt;
    }
    std::optional<Hit> nearest(Vec3 o, Vec3 d) const {
        std::optional<Hit> best;
        const double least = m_.accepts_behind ? -1e300 : k_epsilon;
        for (int i = 0; i <= static_cast<int>(s_.balls.size()); ++i) {
            const std::optional<double> t = hit(i, o, d, least);
            if (!t || (best && m_.first_hit)) continue;
            if (!best || m_.last_hit || *t < best->t) best = Hit{*t, i};
        }
        return best;
    }
    bool is_blocked(Vec3 from, Vec3 to) const {
        const int count = static_cast<int>(s_.balls.size()) - (m_.last_casts_none ? 1 : 0);
        const Vec3 way = m_.shadow_negated ? from - to : to - from;
        const double least = std::max(k_epsilon, m_.shadow_least / length(way));
        const double most = m_.shadow_limit > 0 ? std::min(1.0, m_.shadow_limit / length(way)) : 1;
        for (int i = 0; i <= count; ++i) {
            const std::optional<double> t = hit(i, from, way, least);
            if (t && *t < most) return true;
        }
        return false;
    }
    static double whole(double v) { return std::floor(v); }

    Color trace(Vec3 o, Vec3 d, int depth) const {
        const std::optional<Hit> at = nearest(o, d);
        if (!at) return s_.background;
        const Vec3 p = o + d * at->t;
        const bool is_ball = at->shape > 0;
        const SmallBall b = is_ball ? s_.balls[static_cast<std::size_t>(at->shape - 1)]
                                    : SmallBall{{}, 1, {0.6, 0.6, 0.6}, 0, 1, 0};
        Color color = b.color;
        if (m_.integer_colors) color = {whole(color.r), whole(color.g), whole(color.b)};
        const Vec3 normal = is_ball ? normalize(p - b.center) : Vec3{0, 1, 0};
        Color shine;
        Color local = m_.mirror_flat && depth > 0 ? color
                                                  : light(p, d, m_.n_raw && is_ball ? p - b.center : normal,
                                                          b, color, depth, is_ball, shine);
        if (m_.local_clamped)
            local = {std::min(local.r, 1.0), std::min(local.g, 1.0), std::min(local.b, 1.0)};
        if (b.mirror <= 0 || depth == 3) return local;
        const Vec3 m = m_.n_raw_in_mirrors && is_ball ? p - b.center : normal;
        Vec3 r = d - m * (2 * dot(m, d));
        if (m_.mirror_plus) r = d + normal * (2 * dot(normal, d));
        if (m_.mirror_negated) r = -r;
        if (m_.mirror_along) r = d - normal * dot(normal, d);
        Color seen = trace(p, r, depth + 1);
        if (m_.mirror_colored) seen = seen * color;
        if (m_.mirror_lit) seen = seen * local;
        if (m_.mirror_half_colored) seen = seen * ((Color{1, 1, 1} + color) * 0.5);
        double a = b.mirror;
        if (m_.schlick_power > 0) a += (1 - a) * std::pow(1 - std::abs(dot(normal, d)), m_.schlick_power);
        Color more;
        if (m_.mirror_whole_shine) more = shine * a;
        if (m_.mirror_whole_ambient) more = color * (s_.ambient * a);
        return local * (1 - a) + more + seen * (m_.mirror_whole_seen ? 1 : a);
    }

    Color light(Vec3 p, Vec3 d, Vec3 n, const SmallBall& b, Color color, int depth, bool is_ball,
                Color& shines) const {
        Color sum = color * s_.ambient;
        Vec3 v = -d;
        const bool has_eye = depth == 0 || m_.v_anywhere;
        if (m_.v_from_origin && has_eye) v = normalize(-p);
        if (m_.v_fixed && has_eye) v = {0, 0, 1};
        if (m_.v_raw && depth == 0) v = s_.eye - p;
        if (m_.v_is_eye) v = normalize(s_.eye);
        if (m_.n_from_origin && is_ball) n = normalize(p);
        if (m_.v_is_p) v = normalize(p);
        if (m_.n_reversed || (m_.balls_reversed && is_ball)) n = -n;
        bool is_shadowed = false;
        double dimmed = 1;
        for (const Vec3& lamp : s_.lamps) {
            const Vec3 end = m_.l_from_eye ? p + (lamp - s_.eye) * 100.0 : lamp;
            if (!(m_.mirror_unshadowed && depth > 0) && is_blocked(p, end)) {
                if (m_.black_shadow) return {0, 0, 0};
                is_shadowed = true;
                dimmed *= m_.dimming;
                continue;
            }
            const Vec3 to_light = lamp - (m_.l_from_eye ? s_.eye : p);
            const Vec3 l = m_.l_raw ? to_light : normalize(to_light);
            double n_l = m_.diffuse_of_view ? dot(n, v) : dot(n, l);
            const bool is_lit = n_l > 0;
            n_l = (n_l + m_.lambert_offset) / (1 + m_.lambert_offset);
            if (n_l <= 0) continue;
            double s;
            if (s_.blinn) {
                const Vec3 h = m_.h_of_difference ? l - v : l + v;
                s = dot(m_.of_h_v ? v : n, m_.h_halved ? h / 2 : m_.h_raw ? h : normalize(h));
            } else {
                const Vec3 r = n * (2 * dot(n, l)) - l;
                s = dot(m_.r_negated ? -r : r, m_.of_n_r ? n : m_.of_r_l ? l : v);
            }
            const double strength = s_.lamp /
                                    (std::pow(length(to_light), m_.distance_power) + m_.distance_offset) /
                                    (m_.fades_from_eye ? length(s_.eye - p) : 1);
            const double power = m_.diffuse_to_power ? b.shininess : m_.diffuse_squared ? 2 : 1;
            const double diffuse = m_.no_cosine ? 1 : std::pow(n_l, power);
            double shine =
                s > 0 ? std::pow(s, m_.exponent_squared ? b.shininess * b.shininess : b.shininess) : 0;
            if (m_.specular_times_cosine) shine *= n_l;
            if (!is_lit || (m_.mirror_dull && depth > 0)) shine = 0;
            Color k_s{b.specular, b.specular, b.specular};
            if (m_.specular_is_diffuse && b.specular > 0) k_s = color;
            if (m_.specular_colored) k_s = k_s * color;
            if (m_.specular_half_colored) k_s = k_s * ((Color{1, 1, 1} + color) * 0.5);
            sum = sum + color * (diffuse * strength) + k_s * (shine * strength);
            shines = shines + k_s * (shine * strength);
        }
        sum = sum + color * (s_.ambient * (dimmed - 1));
        if (m_.no_ambient_in_shadow && is_shadowed) sum = sum + color * -s_.ambient;
        if (m_.integer_sum) sum = {whole(sum.r), whole(sum.g), whole(sum.b)};
        return sum;
    }

    const SmallScene& s_;
    const Mistakes m_;
};

}  // namespace glint::test
