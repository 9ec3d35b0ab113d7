// .nff: Eric Haines' Neutral File Format, of the Standard Procedural Databases. docs/formats/nff.md.
#include <fmt/format.h>

#include <vector>

#include "base/text.h"
#include "formats/registry.h"
#include "math/number.h"

namespace glint {
namespace {

constexpr std::string_view k_entities[] = {"b", "v", "l", "f", "c", "s", "p", "pp"};
constexpr std::string_view k_entity_list =
    "`b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp` (background, view, light, fill, cone, sphere, polygon, patch)";
constexpr Range k_size{1, k_max_size, false, false, "a number from 1 to 65536"};
constexpr Range k_vertex_count{3, k_max_polygon_vertices, false, false,
                               "a number of vertices from 3 to 4096"};
constexpr Range k_any_radius{-1e12, 1e12, false, false, "a radius"};

class NffReader {
  public:
    NffReader(Reading& reading, const ReadText& text)
        : reading_(reading),
          scene_(reading.scene),
          text_(text),
          p_(text.place, {.hash_comments = true}, reading.diagnostics) {}

    void read() {
        if (p_.at_end()) p_.expected(k_entity_list);
        while (!p_.at_end() && p_.alive()) read_entity();
        // A light without a colour is as bright as all lights together allow.
        const double intensity =
            1 / number::sqrt(static_cast<double>(number::max<std::size_t>(scene_.lights.size(), 1)));
        for (const std::size_t i : plain_lights_) {
            scene_.lights[i].color = scene_.lights[i].specular_color = {intensity, intensity, intensity};
        }
    }

  private:
    void read_entity() {
        const Token word = p_.token();
        if (word.kind != TokenKind::word) {
            p_.expected(k_entity_list);
            return skip_entity();
        }
        const auto name = p_.text(word);
        p_.take();
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

    // To the next word, which is the next entity's.
    void skip_entity() {
        if (p_.token().kind != TokenKind::word && !p_.at_end()) p_.take();
        while (!p_.at_end() && p_.token().kind != TokenKind::word) p_.take();
    }

    bool number(double& value, const Range& range = k_coordinate) { return p_.number(value, range); }
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

    bool read_view(const Token& word) {
        Camera camera;
        camera.fov_axis = FovAxis::y;
        camera.fov_degrees = 45;
        double near_plane = 0, width = scene_.settings.width, height = scene_.settings.height;
        bool has_from = false, has_at = false, has_size = false;
        while (p_.token().kind == TokenKind::word) {
            const auto key = p_.text(p_.token());
            const bool known = key == "from" || key == "at" || key == "up" || key == "angle" ||
                               key == "hither" || key == "resolution";
            if (!known) break;
            p_.take();
            bool ok = true;
            if (key == "from") ok = has_from = point(camera.position);
            if (key == "at") ok = has_at = point(camera.look_at);
            if (key == "up") ok = point(camera.up);
            if (key == "angle") ok = number(camera.fov_degrees, k_angle);
            if (key == "hither") ok = number(near_plane);  // of a scan-line program; a ray tracer has none
            if (key == "resolution") ok = has_size = number(width, k_size) && number(height, k_size);
            if (!ok) return false;
        }
        if (!has_from || !has_at) {
            p_.error(word, fmt::format("expected `{}` in the view", has_from ? "at" : "from"));
            return true;
        }
        scene_.camera = camera;
        scene_.camera_place = source_place(text_, word);
        reading_.camera_given = true;
        if (has_size) set_size(word, width, height);
        return true;
    }

    void set_size(const Token& word, double width, double height) {
        const auto size = fmt::format("{}x{}", static_cast<int>(width), static_cast<int>(height));
        const std::string wrong = set_setting(scene_, *find_setting("size"), size,
                                              {SettingOrigin::Kind::file, source_place(text_, word)});
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
        if (!(m.ior > 0)) m.ior = 1;  // the databases write 0 where nothing is transmitted
        note(scene_.material_texts, scene_.materials.size(), source_place(text_, word));
        scene_.materials.push_back(m);
        return true;
    }

    template <class T> void add(const T& shape, const Token& word) {
        const auto material =
            scene_.materials.empty() ? k_none : static_cast<std::uint32_t>(scene_.materials.size() - 1);
        note(scene_.shape_texts, scene_.shapes.size(), source_place(text_, word));
        scene_.add(shape, material);
    }

    double outer_radius(const Token& word, double radius) {
        if (radius >= 0) return radius;
        if (!has_negative_radius_)
            p_.warn(word, "glint draws both sides of a surface with a negative radius");
        has_negative_radius_ = true;
        return -radius;
    }

    bool read_sphere(const Token& word) {
        Sphere s;
        if (!point(s.center) || !number(s.radius, k_any_radius)) return false;
        s.radius = outer_radius(word, s.radius);
        add(s, word);
        return true;
    }

    bool read_cone(const Token& word) {
        Cone c;
        if (!point(c.from) || !number(c.from_radius, k_any_radius) || !point(c.to) ||
            !number(c.to_radius, k_any_radius))
            return false;
        c.from_radius = outer_radius(word, c.from_radius);
        c.to_radius = outer_radius(word, c.to_radius);
        if (c.from_radius == c.to_radius) {
            add(Cylinder{c.from, c.to, c.from_radius, false}, word);
        } else {
            add(c, word);
        }
        return true;
    }

    // The count of a `p` or `pp`, which has to be whole.
    bool vertex_count(std::uint32_t& count) {
        const Token token = p_.token();
        double n = 0;
        if (!number(n, k_vertex_count)) return false;
        count = static_cast<std::uint32_t>(n);
        if (static_cast<double>(count) == n) return true;
        p_.error(token, fmt::format("expected {}, found {}", k_vertex_count.text, n));
        return false;
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

    // Vertices and normals in turn. The databases' patches are triangles; a larger one is a fan.
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

    Reading& reading_;
    Scene& scene_;
    const ReadText& text_;
    Parser p_;
    std::vector<std::size_t> plain_lights_;
    std::vector<Vec3> patch_;
    bool has_negative_radius_ = false;  // and was told
};

}  // namespace

void set_nff_defaults(Scene&) {}

void read_nff(Reading& reading, const ReadText& text) { NffReader(reading, text).read(); }

}  // namespace glint
