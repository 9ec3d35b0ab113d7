// SPDX-License-Identifier: Apache-2.0
// .nff: Eric Haines' Neutral File Format, of the Standard Procedural Databases. docs/formats/nff.md.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/text.h"
#include "formats/registry.h"
#include "math/number.h"

namespace glint {
namespace {

constexpr std::string_view k_entities[] = {"b", "v", "l", "f", "c", "s", "p", "pp"};
constexpr std::string_view k_entity_list =
    "`b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp` (background, view, light, fill, cone, sphere, polygon, patch)";
constexpr Field k_view[] = {{"from", true}, {"at", true}, {"up"}, {"angle"}, {"hither"}, {"resolution"}};
constexpr std::string_view k_view_names[] = {"from", "at", "up", "angle", "hither", "resolution"};
constexpr std::string_view k_view_list = "`from`, `at`, `up`, `angle`, `hither` or `resolution`";
constexpr Range k_size{1, k_max_size, false, false, "a whole number from 1 to 65536"};
constexpr Range k_vertex_count{3, k_max_polygon_vertices, false, false, "a whole number from 3 to 4096"};
constexpr Range k_any_radius{-1e12, 1e12, false, false, "a radius from -1e12 to 1e12"};

template <std::size_t N> bool is_one_of(const std::string_view (&names)[N], std::string_view name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

class NffReader {
  public:
    NffReader(LoadState& reading, const ReadText& text)
        : reading_(reading),
          scene_(reading.scene),
          text_(text),
          p_(text.place, {.hash_comments = true}, reading.diagnostics) {}

    void read() {
        if (p_.at_end()) p_.expected(k_entity_list);
        while (!p_.at_end() && p_.alive()) read_entity();
        if (!scene_.shapes.empty() && !reading_.camera_given && !reading_.camera_wanted) {
            reading_.camera_wanted = make_diagnostic(
                Severity::warning, text_.place, text_.place.text.size(), 1,
                "no view `v`: the camera is at the origin and looks along the negative z axis");
        }
        // Lights without a color have the intensity 1 / sqrt(number of lights), as the format defines.
        const double intensity =
            1 / number::sqrt(static_cast<double>(number::max<std::size_t>(scene_.lights.size(), 1)));
        for (const std::size_t i : plain_lights_) {
            scene_.lights[i].color = scene_.lights[i].specular_color = {intensity, intensity, intensity};
        }
    }

  private:
    void read_entity() {
        const Token word = p_.token();
        const auto name = p_.text(word);
        if (word.kind != TokenKind::word) p_.expected(k_entity_list);
        p_.take();
        if (word.kind != TokenKind::word) return skip_entity();
        bool ok = false;
        if (name == "s")
            ok = read_sphere(word);
        else if (name == "p")
            ok = read_polygon(word);
        else if (name == "pp")
            ok = read_patch(word);
        else if (name == "c")
            ok = read_cone(word);
        else if (name == "f")
            ok = read_fill(word);
        else if (name == "l")
            ok = read_light(word);
        else if (name == "b")
            ok = read_background(word);
        else if (name == "v")
            ok = read_view(word);
        else
            p_.error(word, fmt::format("expected {}, found {}{}", k_entity_list, quoted(name),
                                       did_you_mean(name, k_entities)));
        if (!ok) skip_entity();
    }

    // Skips to the next word that begins an entity or a line of the view.
    void skip_entity() {
        const auto is_beginning = [&] {
            const auto name = p_.text(p_.token());
            return p_.token().kind == TokenKind::word &&
                   (is_one_of(k_entities, name) || is_one_of(k_view_names, name));
        };
        while (!p_.at_end() && !is_beginning()) p_.take();
    }

    bool number(double& value, const Range& range = k_coordinate) { return p_.number(value, range); }
    bool whole_number(double& value, const Range& range) {
        const Token token = p_.token();
        if (!number(value, range)) return false;
        if (!range.contains(value)) return true;  // an error was reported
        if (value == static_cast<double>(static_cast<std::int64_t>(value))) return true;
        p_.error(token, fmt::format("expected {}, found {}", range.text, p_.describe(token)));
        return false;
    }
    bool point(Vec3& v) { return number(v.x) && number(v.y) && number(v.z); }
    bool color(Color& c) {
        return number(c.r, k_channel) && number(c.g, k_channel) && number(c.b, k_channel);
    }

    bool read_background(const Token& word) {
        if (!color(scene_.background)) return false;
        scene_.background_place = source_place(text_, word);
        reading_.background_given = true;
        return true;
    }

    // The lines may be in any order. The view ends where another entity begins.
    bool read_view(const Token& word) {
        if (reading_.camera_given) p_.warn(word, "a second view: the last one holds");
        Camera camera;
        camera.fov_axis = FovAxis::y;
        camera.fov_degrees = 45;
        double near_plane = 0;  // used by scan-line renderers only
        double width = 0, height = 0;
        FieldSet keys("view", k_view);
        while (p_.token().kind == TokenKind::word && !is_one_of(k_entities, p_.text(p_.token()))) {
            const Token key = p_.token();
            const auto name = p_.text(key);
            if (!is_one_of(k_view_names, name)) {
                p_.error(key, fmt::format("expected {}, or an entity, found {}{}", k_view_list, quoted(name),
                                          did_you_mean(name, k_view_names)));
                skip_entity();
                continue;
            }
            p_.take();
            p_.field(keys, key, name);
            const bool ok = name == "from"     ? point(camera.position)
                            : name == "at"     ? point(camera.look_at)
                            : name == "up"     ? point(camera.up)
                            : name == "angle"  ? number(camera.fov_degrees, k_angle)
                            : name == "hither" ? number(near_plane)
                                               : whole_number(width, k_size) && whole_number(height, k_size);
            if (!ok) skip_entity();
        }
        reading_.camera_given = true;
        if (!p_.check_required(keys, word)) return true;
        scene_.camera = camera;
        scene_.camera_place = source_place(text_, word);
        if (k_size.contains(width) && k_size.contains(height)) set_size(word, width, height);
        return true;
    }

    void set_size(const Token& word, double width, double height) {
        const auto size = fmt::format("{}x{}", static_cast<int>(width), static_cast<int>(height));
        const std::string wrong = set_setting(scene_, *find_setting("size"), size,
                                              {SettingOrigin::Kind::file, source_place(text_, word)})
                                      .message;
        if (!wrong.empty()) p_.error(word, wrong);
    }

    bool read_light(const Token& word) {
        Light light;
        if (!point(light.position)) return false;
        if (p_.token().kind == TokenKind::number) {
            if (!color(light.color)) return false;
            light.specular_color = light.color;
        } else {
            plain_lights_.push_back(scene_.lights.size());
        }
        note(scene_.light_texts, scene_.lights.size(), source_place(text_, word));
        scene_.lights.push_back(light);
        return true;
    }

    bool read_fill(const Token& word) {
        Material m;
        double k_d = 0, k_s = 0;
        if (!color(m.color) || !number(k_d, k_channel) || !number(k_s, k_channel) ||
            !number(m.shininess, k_exponent) || !number(m.transmission, k_fraction) ||
            !number(m.ior, k_not_negative)) {
            return false;
        }
        m.ambient = {0, 0, 0};
        m.diffuse = m.color * k_d;
        m.specular = {k_s, k_s, k_s};
        m.mirror = number::min(number::max(k_s, 0.0), 1.0);
        if (!(m.ior > 0)) m.ior = 1;  // the databases write 0 for opaque materials
        material_ = static_cast<std::uint32_t>(scene_.materials.size());
        note(scene_.material_texts, scene_.materials.size(), source_place(text_, word));
        scene_.materials.push_back(m);
        return true;
    }

    template <class T> void add(const T& shape, const Token& word) {
        if (material_ == k_none && !has_no_fill_) {
            p_.warn(word, "no `f` before the first shape: it has glint's default material");
            has_no_fill_ = true;
        }
        note(scene_.shape_texts, scene_.shapes.size(), source_place(text_, word));
        scene_.add(shape, material_);
    }

    // A negative radius turns the normals inward, which has no effect: both sides are lit.
    bool radius(double& value) {
        if (!number(value, k_any_radius)) return false;
        value = number::abs(value);
        return true;
    }

    bool read_sphere(const Token& word) {
        Sphere s;
        if (!point(s.center)) return false;
        const Token token = p_.token();
        if (!radius(s.radius)) return false;
        if (s.radius == 0) p_.error(token, "expected a radius other than 0");
        add(s, word);
        return true;
    }

    bool read_cone(const Token& word) {
        Cone c;
        if (!point(c.from) || !radius(c.from_radius) || !point(c.to) || !radius(c.to_radius)) return false;
        if (c.from_radius == c.to_radius) {
            add(Cylinder{c.from, c.to, c.from_radius, false}, word);
        } else {
            add(c, word);
        }
        return true;
    }

    bool vertex_count(std::uint32_t& count) {
        double n = 0;
        if (!whole_number(n, k_vertex_count) || !k_vertex_count.contains(n)) return false;
        count = static_cast<std::uint32_t>(n);
        return true;
    }

    bool read_polygon(const Token& word) {
        std::uint32_t count = 0;
        if (!vertex_count(count)) return false;
        const auto first = static_cast<std::uint32_t>(scene_.polygon_vertices.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            Vec3 v;
            if (!point(v)) {
                scene_.polygon_vertices.resize(first);
                return false;
            }
            scene_.polygon_vertices.push_back(v);
        }
        if (count > 3) {
            add(Polygon{first, count}, word);
            return true;
        }
        const Vec3* v = scene_.polygon_vertices.data() + first;
        add(Triangle{{v[0], v[1], v[2]}}, word);
        scene_.polygon_vertices.resize(first);
        return true;
    }

    // Alternating vertices and normals. The databases' patches are triangles; larger ones are cut into a fan.
    bool read_patch(const Token& word) {
        std::uint32_t count = 0;
        if (!vertex_count(count)) return false;
        patch_.clear();
        for (std::uint32_t i = 0; i < 2 * count; ++i) {
            Vec3 v;
            if (!point(v)) return false;
            patch_.push_back(v);
        }
        for (std::uint32_t i = 1; i + 1 < count; ++i) {
            add(SmoothTriangle{{patch_[0], patch_[2 * i], patch_[2 * i + 2]},
                               {patch_[1], patch_[2 * i + 1], patch_[2 * i + 3]}},
                word);
        }
        return true;
    }

    LoadState& reading_;
    Scene& scene_;
    const ReadText& text_;
    Parser p_;
    std::uint32_t material_ = k_none;          // of the last `f`
    CountedVector<std::size_t> plain_lights_;  // without a color
    CountedVector<Vec3> patch_;
    bool has_no_fill_ = false;  // an error was reported
};

}  // namespace

void set_nff_defaults(Scene& scene) {
    scene.unit_normals.of_vertices = true;
    scene.unit_normals.reason = "the format asks for normalised ones";
}

void read_nff(LoadState& reading, const ReadText& text) { NffReader(reading, text).read(); }

}  // namespace glint
