// SPDX-License-Identifier: Apache-2.0
// .pov as used by CSC 473: a small, right-handed part of POV-Ray's language. docs/formats/csc473.md.
#include "formats/csc473.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray_keywords.h"
#include "formats/registry.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr std::string_view k_blocks[] = {"camera",   "light_source", "sphere", "plane",
                                         "triangle", "box",          "cone"};
constexpr std::string_view k_block_list =
    "`camera`, `light_source`, `sphere`, `plane`, `triangle`, `box` or `cone`";
constexpr Field k_camera[] = {{"location"}, {"up"}, {"right"}, {"look_at"}};
constexpr std::string_view k_camera_names[] = {"location", "up", "right", "look_at"};

class Csc473Reader {
  public:
    Csc473Reader(LoadState& reading, const ReadText& text)
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
        if (!is_block(word)) return refuse_block();
        const auto name = p_.text(word);
        p_.take();
        if (!p_.expect('{')) return skip_to_block();
        const bool ok = name == "camera"         ? read_camera(word)
                        : name == "light_source" ? read_light(word)
                        : name == "sphere"       ? read_sphere(word)
                        : name == "plane"        ? read_plane(word)
                        : name == "triangle"     ? read_triangle(word)
                        : name == "box"          ? read_box(word)
                                                 : read_cone(word);
        if (!ok) p_.skip_to_close('}');
    }

    bool is_block(const Token& token) const {
        return token.kind == TokenKind::word &&
               std::find(std::begin(k_blocks), std::end(k_blocks), p_.text(token)) != std::end(k_blocks);
    }

    void refuse_block() {
        refuse_word(p_, k_block_list, k_blocks);
        if (!p_.token().is('{')) p_.take();
        skip_to_block();
    }

    // Skips to the next token that looks like a block or a directive.
    void skip_to_block() {
        const auto is_beginning = [&] {
            return p_.token().is('#') || is_block(p_.token()) ||
                   (p_.token().kind == TokenKind::word && p_.peek().is('{'));
        };
        while (!p_.at_end() && !is_beginning()) {
            if (!p_.token().is('{')) {
                p_.take();
            } else if (!p_.skip_value()) {
                return;
            }
        }
    }

    // POV-Ray's own language is left-handed and far larger: ignoring the rest would give another picture.
    void refuse_directive() {
        const Token hash = p_.take();
        const auto name = p_.text(p_.token());
        if (is_povray_directive(name)) {
            p_.error(hash,
                     fmt::format("`#{}` is of POV-Ray's own language, which is left-handed and larger; of it "
                                 "glint reads what CSC 473 uses",
                                 name));
        } else {
            p_.error(hash, fmt::format("expected {}, found '#'", k_block_list));
        }
        p_.stop();
    }

    bool vector(Vec3& v) {
        if (!read_pov_vector(p_, v)) return false;
        p_.accept(',');
        return true;
    }
    bool number(double& value, const Range& range) {
        if (!p_.number(value, range)) return false;
        p_.accept(',');
        return true;
    }

    bool read_camera(const Token& word) {
        if (reading_.camera_given) p_.warn(word, "a second camera: the last one holds");
        // In the order of k_camera.
        Vec3 values[4] = {{0, 0, 0}, {0, 1, 0}, {1.33333, 0, 0}, {0, 0, -1}};
        FieldSet keys("camera", k_camera);
        while (!p_.accept('}')) {
            const Token key = p_.token();
            const auto name = p_.text(key);
            if (std::find(std::begin(k_camera_names), std::end(k_camera_names), name) ==
                std::end(k_camera_names)) {
                refuse_word(p_, "`location`, `up`, `right`, `look_at` or `}`", k_camera_names);
                return false;
            }
            p_.take();
            if (!vector(values[p_.field(keys, key, name)])) return false;
        }
        const auto& [location, up, right, look_at] = values;
        if (look_at == location) {
            p_.error(word, "expected a camera that looks somewhere, found `look_at` at its location");
            return true;
        }
        scene_.camera.position = location;
        scene_.camera.look_at = look_at;
        scene_.camera.up = up;
        scene_.camera.frame = CameraFrame{right, up, normalize(look_at - location)};
        scene_.camera_place = source_place(text_, word);
        reading_.camera_given = true;
        return true;
    }

    bool read_light(const Token& word) {
        Light light;
        PovColor color;
        if (!vector(light.position) || !read_pov_color(p_, color)) return false;
        if (!p_.accept('}')) {
            refuse_word(p_, "`}` after the light's color", {});
            return false;
        }
        light.color = light.specular_color = color.rgb;
        note(scene_.light_texts, scene_.lights.size(), source_place(text_, word));
        scene_.lights.push_back(light);
        return true;
    }

    bool read_sphere(const Token& word) {
        Sphere s;
        return vector(s.center) && number(s.radius, k_length) && finish_shape(s, word);
    }

    // <n>, d: the points with n·p = d, n as written.
    bool read_plane(const Token& word) {
        Plane plane;
        double distance = 0;
        const Token normal = p_.token();
        if (!vector(plane.normal) || !number(distance, k_coordinate)) return false;
        if (plane.normal == Vec3{0, 0, 0}) {
            p_.error(normal, "expected a normal other than <0, 0, 0>");
        } else {
            plane.point = Vec3{0, 0, 0} + plane.normal * (distance / dot(plane.normal, plane.normal));
        }
        return finish_shape(plane, word);
    }

    bool read_triangle(const Token& word) {
        Triangle t;
        return vector(t.vertices[0]) && vector(t.vertices[1]) && vector(t.vertices[2]) &&
               finish_shape(t, word);
    }

    // Two opposite corners, in any order.
    bool read_box(const Token& word) {
        Vec3 a, b;
        if (!vector(a) || !vector(b)) return false;
        return finish_shape(Box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                                {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}},
                            word);
    }

    bool read_cone(const Token& word) {
        Cone c;
        c.caps = true;
        return vector(c.from) && number(c.from_radius, k_not_negative) && vector(c.to) &&
               number(c.to_radius, k_not_negative) && finish_shape(c, word);
    }

    template <class T> bool finish_shape(const T& shape, const Token& word) {
        PovAttributes attributes;
        if (!read_pov_attributes(p_, p_.text(word), attributes)) return false;
        std::uint32_t transform = k_none;
        if (attributes.map) {
            transform = static_cast<std::uint32_t>(scene_.transforms.size());
            scene_.transforms.push_back(*attributes.map);
        }
        if (attributes.refraction && attributes.finish.refraction != 0 && attributes.pigment.filter == 0) {
            reading_.diagnostics.warn_once(
                "refraction", text_.place, attributes.refraction->offset, attributes.refraction->length,
                "glint ignores `refraction`, as CSC 473's own program does: what passes through a surface is "
                "the fourth number of its `rgbf`");
        }
        if (attributes.refraction && attributes.finish.refraction != 0 && attributes.pigment.filter > 0 &&
            attributes.finish.ior == 1) {
            reading_.diagnostics.warn_once(
                "ior", text_.place, attributes.refraction->offset, attributes.refraction->length,
                "`refraction` without an `ior` other than 1, which is that of air: rays go straight through; "
                "expected, for example, `ior 1.33` (water) or `ior 1.5` (glass)");
        }
        const auto material = material_of(attributes.pigment, attributes.finish, word);
        note(scene_.shape_texts, scene_.shapes.size(), source_place(text_, word));
        scene_.add(shape, material, transform);
        return true;
    }

    // In a mesh, every triangle has the same surface: neighbours share its material.
    std::uint32_t material_of(const PovColor& pigment, const PovFinish& f, const Token& word) {
        if (material_ != k_none && pigment == pigment_ && f == finish_) return material_;
        Material m;
        m.color = pigment.rgb;
        m.ambient = pigment.rgb * f.ambient;
        m.diffuse = pigment.rgb * f.diffuse;
        m.specular = pigment.rgb * f.specular;
        m.shininess = std::clamp(2 / (f.roughness * f.roughness) - 2, 0.0, 1e9);
        m.mirror = f.reflection;
        m.transmission = pigment.filter;
        if (f.reflection > 0 || pigment.filter > 0) m.mirror_tint = m.transmission_tint = pigment.rgb;
        m.ior = f.ior;
        note(scene_.material_texts, scene_.materials.size(), source_place(text_, word));
        material_ = static_cast<std::uint32_t>(scene_.materials.size());
        scene_.materials.push_back(m);
        pigment_ = pigment;
        finish_ = f;
        return material_;
    }

    LoadState& reading_;
    Scene& scene_;
    const ReadText& text_;
    Parser p_;
    std::uint32_t material_ = k_none;  // the last material, made from these
    PovColor pigment_;
    PovFinish finish_;
};

}  // namespace

/// I_a is 1: k_a alone gives the ambient term.
void set_csc473_defaults(Scene& scene) {
    scene.camera.frame = CameraFrame{{1.33333, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    Light ambient;
    ambient.kind = LightKind::ambient;
    scene.lights.push_back(ambient);
    scene.light_texts.places.emplace_back();
    scene.unit_normals.of_planes = true;
    scene.unit_normals.reason = "n.p = d then puts the plane at d / |n| from the origin, not at d";
}

void read_csc473(LoadState& reading, const ReadText& text) { Csc473Reader(reading, text).read(); }

std::optional<Diagnostic> first_csc473_error(const SceneText& text) {
    LoadOptions options;
    if (const MemoryBudget* memory = MemoryBudget::current()) options.max_memory = memory->limit();
    LoadState reading(options, nullptr, 1, text.text.size());
    reading.diagnostics.set_watcher(
        [&](InputText where, std::size_t offset) { return reading.is_within_memory(where, offset); });
    reading.texts.push_back({text.name, text.text});
    read_csc473(reading, {{text.name, text.text}, 0});
    if (reading.is_memory_reported) return std::nullopt;  // the reader of the format reports it
    for (Diagnostic& diagnostic : reading.diagnostics.take()) {
        if (diagnostic.severity == Severity::error) return std::move(diagnostic);
    }
    return std::nullopt;
}

}  // namespace glint
