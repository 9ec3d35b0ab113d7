// .pov as CSC 473 writes it: a right-handed, small part of POV-Ray's language. docs/formats/csc473.md.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "formats/registry.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr std::string_view k_blocks[] = {"camera",   "light_source", "sphere", "plane",
                                         "triangle", "box",          "cone"};
constexpr std::string_view k_block_list =
    "`camera`, `light_source`, `sphere`, `plane`, `triangle`, `box` or `cone`";
constexpr std::string_view k_items[] = {"pigment", "finish", "translate", "rotate", "scale"};
constexpr std::string_view k_finish[] = {"ambient",    "diffuse",    "specular", "roughness",
                                         "reflection", "refraction", "ior"};
constexpr Range k_roughness{0, 1e6, true, false, "a number > 0"};

// What a shape of the text says of its surface.
struct Finish {
    double ambient = 0, diffuse = 0, specular = 0, roughness = 1, reflection = 0, refraction = 0, ior = 1;
};

class Csc473Reader {
  public:
    Csc473Reader(Reading& reading, const ReadText& text)
        : reading_(reading),
          scene_(reading.scene),
          text_(text),
          p_(text.place, {.slash_comments = true, .block_comments = true}, reading.diagnostics) {}

    void read() {
        if (p_.at_end()) p_.expected(k_block_list);
        while (!p_.at_end() && p_.alive()) read_block();
    }

  private:
    void read_block() {
        const Token word = p_.token();
        if (word.is('#')) return refuse_directive();
        if (word.kind != TokenKind::word) {
            p_.expected(k_block_list);
            if (p_.at_closing_bracket() || !p_.skip_value()) p_.take();
            return;
        }
        p_.take();
        const auto name = p_.text(word);
        if (std::find(std::begin(k_blocks), std::end(k_blocks), name) == std::end(k_blocks))
            return refuse(word, name);
        if (!p_.expect('{')) return;
        if (name == "camera") read_camera(word);
        if (name == "light_source") read_light(word);
        if (name == "sphere") read_sphere(word);
        if (name == "plane") read_plane(word);
        if (name == "triangle") read_triangle(word);
        if (name == "box") read_box(word);
        if (name == "cone") read_cone(word);
    }

    // POV-Ray's own language is left-handed and far larger: drawing the rest would be drawing something else.
    void refuse_directive() {
        const Token hash = p_.take();
        const auto name = p_.text(p_.token());
        p_.error(hash, fmt::format(
                           "`#{}` is of POV-Ray's own language; glint reads the part of it that CSC 473 uses",
                           name));
        p_.stop();
    }
    void refuse(const Token& word, std::string_view name) {
        const std::string hint = did_you_mean(name, k_blocks);
        if (!hint.empty() || !p_.token().is('{')) {
            p_.error(word, fmt::format("expected {}, found {}{}", k_block_list, quoted(name), hint));
        } else {
            p_.error(word,
                     fmt::format(
                         "{} is of POV-Ray's own language; glint reads the part of it that CSC 473 uses: {}",
                         quoted(name), k_block_list));
        }
        if (p_.token().is('{')) p_.skip_value();
    }

    bool vector(Vec3& v) { return p_.point(v, k_coordinate, '<', '>'); }
    void comma() { p_.accept(','); }

    // After a mistake within a block.
    void give_up() { p_.skip_to_close('}'); }

    void read_camera(const Token& word) {
        Vec3 location{0, 0, 0}, up{0, 1, 0}, right{1.33333, 0, 0}, look_at{0, 0, -1};
        while (!p_.accept('}')) {
            const Token key = p_.token();
            const auto name = p_.text(key);
            Vec3* value = name == "location"  ? &location
                          : name == "up"      ? &up
                          : name == "right"   ? &right
                          : name == "look_at" ? &look_at
                                              : nullptr;
            if (value == nullptr) {
                p_.expected("`location`, `up`, `right`, `look_at` or `}`");
                return give_up();
            }
            p_.take();
            if (!vector(*value)) return give_up();
            comma();
        }
        if (look_at == location)
            return p_.error(word, "expected a camera that looks somewhere, found `look_at` at its location");
        scene_.camera.position = location;
        scene_.camera.look_at = look_at;
        scene_.camera.up = up;
        scene_.camera.frame = CameraFrame{right, up, normalize(look_at - location)};
        scene_.camera_place = source_place(text_, word);
        reading_.camera_given = true;
    }

    // color rgb <r, g, b> or color rgbf <r, g, b, f>; `color` may be left out.
    bool color(Color& c, double& filter) {
        if (p_.text(p_.token()) == "color") p_.take();
        const auto kind = p_.text(p_.token());
        if (kind != "rgb" && kind != "rgbf") {
            p_.expected("`rgb` or `rgbf`");
            return false;
        }
        p_.take();
        if (!p_.expect('<')) return false;
        double values[4] = {0, 0, 0, 0};
        const int count = kind == "rgb" ? 3 : 4;
        for (int i = 0; i < count; ++i) {
            if (i > 0 && !p_.expect(',')) return false;
            if (!p_.number(values[i], i < 3 ? k_channel : k_fraction)) return false;
        }
        if (!p_.expect('>')) return false;
        c = {values[0], values[1], values[2]};
        filter = values[3];
        return true;
    }

    void read_light(const Token& word) {
        Light light;
        double filter = 0;
        if (!vector(light.position)) return give_up();
        comma();
        if (!color(light.color, filter)) return give_up();
        if (!p_.accept('}')) {
            p_.expected("`}`");
            return give_up();
        }
        light.specular_color = light.color;
        note(scene_.light_texts, scene_.lights.size(), source_place(text_, word));
        scene_.lights.push_back(light);
    }

    void read_sphere(const Token& word) {
        Sphere s;
        if (!vector(s.center)) return give_up();
        comma();
        if (!p_.number(s.radius, k_length)) return give_up();
        finish_shape(s, word);
    }

    void read_plane(const Token& word) {
        Plane plane;
        double distance = 0;
        if (!vector(plane.normal)) return give_up();
        comma();
        if (!p_.number(distance, k_coordinate)) return give_up();
        // <n>, d: the points with n·p = d, n as written or unit: the course writes unit ones.
        if (!(plane.normal == Vec3{0, 0, 0}))
            plane.point = plane.normal * (distance / dot(plane.normal, plane.normal));
        finish_shape(plane, word);
    }

    void read_triangle(const Token& word) {
        Triangle t;
        for (Vec3& v : t.vertices) {
            if (!vector(v)) return give_up();
            comma();
        }
        finish_shape(t, word);
    }

    void read_box(const Token& word) {
        Vec3 a, b;
        if (!vector(a)) return give_up();
        comma();
        if (!vector(b)) return give_up();
        finish_shape(Cuboid{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                            {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}},
                     word);
    }

    void read_cone(const Token& word) {
        Cone c;
        c.caps = true;
        if (!vector(c.from)) return give_up();
        comma();
        if (!p_.number(c.from_radius, k_not_negative)) return give_up();
        comma();
        if (!vector(c.to)) return give_up();
        comma();
        if (!p_.number(c.to_radius, k_not_negative)) return give_up();
        finish_shape(c, word);
    }

    // The rest of a shape's block: pigment, finish, and maps in the order written.
    template <class T> void finish_shape(const T& shape, const Token& word) {
        Color pigment{0, 0, 0};
        double filter = 0;
        Finish finish;
        std::optional<Affine> map;
        comma();
        while (!p_.accept('}')) {
            const Token key = p_.token();
            const auto name = p_.text(key);
            bool ok = true;
            if (name == "pigment") {
                p_.take();
                ok = p_.expect('{') && color(pigment, filter) && p_.expect('}');
            } else if (name == "finish") {
                p_.take();
                ok = read_finish(finish);
            } else if (name == "translate" || name == "rotate" || name == "scale") {
                p_.take();
                ok = read_map(name, key, map);
            } else {
                p_.expected(fmt::format("`pigment`, `finish`, `translate`, `rotate`, `scale` or `}}`{}",
                                        key.kind == TokenKind::word ? did_you_mean(name, k_items) : ""));
                ok = false;
            }
            if (!ok) return give_up();
        }
        std::uint32_t transform = k_none;
        if (map) {
            transform = static_cast<std::uint32_t>(scene_.transforms.size());
            scene_.transforms.push_back(*map);
        }
        const auto material = add_material(pigment, filter, finish, word);
        note(scene_.shape_texts, scene_.shapes.size(), source_place(text_, word));
        scene_.add(shape, material, transform);
    }

    bool read_finish(Finish& finish) {
        if (!p_.expect('{')) return false;
        while (!p_.accept('}')) {
            const Token key = p_.token();
            const auto name = p_.text(key);
            double* value = nullptr;
            Range range = k_channel;
            if (name == "ambient") value = &finish.ambient;
            if (name == "diffuse") value = &finish.diffuse;
            if (name == "specular") value = &finish.specular;
            if (name == "roughness") value = &finish.roughness, range = k_roughness;
            if (name == "reflection") value = &finish.reflection, range = k_fraction;
            if (name == "refraction") value = &finish.refraction, range = k_fraction;
            if (name == "ior") value = &finish.ior, range = k_index_of_refraction;
            if (value == nullptr) {
                p_.expected(
                    fmt::format("`ambient`, `diffuse`, `specular`, `roughness`, `reflection`, `refraction`, "
                                "`ior` or `}}`{}",
                                key.kind == TokenKind::word ? did_you_mean(name, k_finish) : ""));
                p_.skip_to_close('}');
                return false;
            }
            p_.take();
            if (!p_.number(*value, range)) {
                p_.skip_to_close('}');
                return false;
            }
            comma();
        }
        return true;
    }

    // translate <v>, rotate <degrees about x, then y, then z>, scale <v> or scale number.
    bool read_map(std::string_view name, const Token& key, std::optional<Affine>& map) {
        Vec3 v;
        if (name == "scale" && p_.token().kind == TokenKind::number) {
            if (!p_.number(v.x, k_coordinate)) return false;
            v.y = v.z = v.x;
        } else if (!vector(v)) {
            return false;
        }
        Affine step;
        if (name == "translate") step = translation(v);
        if (name == "rotate") step = compose(rotation_z(v.z), compose(rotation_y(v.y), rotation_x(v.x)));
        if (name == "scale") {
            if (v.x == 0 || v.y == 0 || v.z == 0) {
                p_.error(key, "expected a scale without 0, which would leave nothing of the shape");
                return true;
            }
            step = scaling(v);
        }
        map = map ? compose(step, *map) : step;
        return true;
    }

    std::uint32_t add_material(Color pigment, double filter, const Finish& f, const Token& word) {
        Material m;
        m.color = pigment;
        m.ambient = pigment * f.ambient;
        m.diffuse = pigment * f.diffuse;
        m.specular = pigment * f.specular;
        m.shininess = std::clamp(2 / (f.roughness * f.roughness) - 2, 0.0, 1e9);
        m.mirror = f.reflection;
        m.mirror_tint = pigment;
        m.transmission = filter;
        m.transmission_tint = pigment;
        m.ior = f.ior;
        note(scene_.material_texts, scene_.materials.size(), source_place(text_, word));
        scene_.materials.push_back(m);
        return static_cast<std::uint32_t>(scene_.materials.size() - 1);
    }

    Reading& reading_;
    Scene& scene_;
    const ReadText& text_;
    Parser p_;
};

}  // namespace

/// I_a is 1: k_a alone stands for the ambient term.
void set_csc473_defaults(Scene& scene) {
    scene.camera.frame = CameraFrame{{1.33333, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    Light ambient;
    ambient.kind = LightKind::ambient;
    scene.lights.push_back(ambient);
    scene.light_texts.places.emplace_back();
}

void read_csc473(Reading& reading, const ReadText& text) { Csc473Reader(reading, text).read(); }

}  // namespace glint
