// SPDX-License-Identifier: Apache-2.0
// .cgfs: the listings of "Computer Graphics from Scratch", extended by a camera. docs/formats/cgfs.md.
#include <fmt/format.h>

#include <tuple>

#include "formats/block_reader.h"
#include "formats/registry.h"

namespace glint {
namespace {

constexpr Range k_cgfs_channel{-1e6, 1e6, false, false, "a number from 0 to 255"};
constexpr Range k_book_specular{-1, 1e9, false, false, "-1 (matte) or a number from 0 to 1e9"};

constexpr std::string_view k_words[] = {"sphere",     "light",         "camera",
                                        "background", "viewport_size", "projection_plane_d"};

class CgfsReader {
  public:
    CgfsReader(LoadState& reading, const ReadText& text)
        : reading_(reading),
          scene_(reading.scene),
          text_(text),
          p_(text.place, {.hash_comments = true, .slash_comments = true}, reading.diagnostics) {}

    void read() {
        blocks_.read([&](const Token& word, std::string_view name) { return read_block(word, name); },
                     [&](const Token& word, std::string_view name) { return read_setting(word, name); });
        if (has_view_) set_camera_frame();
    }

  private:
    bool read_block(const Token& word, std::string_view name) {
        if (name == "sphere") {
            read_sphere(word);
        } else if (name == "light") {
            read_light(word);
        } else if (name == "camera") {
            read_camera(word);
        } else {
            return false;
        }
        return true;
    }

    bool read_setting(const Token& word, std::string_view name) {
        if (name == "background") return read_background(word);
        has_view_ = true;
        if (name == "viewport_size") return read_viewport_size();
        if (name == "projection_plane_d") return p_.number(viewport_[2], k_length);
        p_.error(word, fmt::format("expected a block `{} {{ ... }}`", name));
        return false;
    }

    bool read_background(const Token& word) {
        if (reading_.background_given) p_.warn(word, "a second background: the last one holds");
        reading_.background_given = true;
        scene_.background_place = source_place(text_, word);
        return read_color(scene_.background);
    }

    bool read_viewport_size() {
        if (!p_.number(viewport_[0], k_length)) return false;
        if (p_.token().kind != TokenKind::word || p_.text(p_.token()) != "x") {
            p_.expected("`x` and the viewport's height");
            return false;
        }
        p_.take();
        return p_.number(viewport_[1], k_length);
    }

    // direction = rotation * viewport point: the columns are the images of x, y and z.
    void set_camera_frame() {
        const auto& r = rotation_;
        reading_.camera_given = true;
        scene_.unit_normals.frame_lengths = Vec3{viewport_[0], viewport_[1], viewport_[2]};
        scene_.camera.frame = CameraFrame{viewport_[0] * Vec3{r[0].x, r[1].x, r[2].x},
                                          viewport_[1] * Vec3{r[0].y, r[1].y, r[2].y},
                                          viewport_[2] * Vec3{r[0].z, r[1].z, r[2].z}};
    }

    bool read_color(Color& color) {
        const Token at = p_.token();
        double v[3] = {};
        if (!p_.triple(v, k_cgfs_channel, '(', ')')) return false;
        for (double& x : v) {
            if (!(x >= 0 && x <= 255)) {
                p_.warn(at, "a color's numbers go from 0 to 255; this one is used unchanged");
                break;
            }
        }
        color = {v[0] / 255, v[1] / 255, v[2] / 255};
        return true;
    }

    void read_sphere(const Token& word) {
        enum { k_center, k_radius, k_color, k_specular, k_reflective };
        static constexpr Field fields[] = {
            {"center", true}, {"radius", true}, {"color", true}, {"specular"}, {"reflective"}};
        FieldSet set("sphere", fields);
        Sphere sphere;
        Color color;
        double specular = -1, reflective = 0;
        const bool whole = blocks_.fields(set, word, [&](int field, const Token&) {
            switch (field) {
                case k_center:
                    return p_.point(sphere.center, k_coordinate, '(', ')');
                case k_radius:
                    return p_.number(sphere.radius, k_length);
                case k_color:
                    return read_color(color);
                case k_specular:
                    return read_specular(specular);
                default:
                    return p_.number(reflective, k_fraction);
            }
        });
        if (!whole || !p_.check_required(set, word)) return;
        const std::uint32_t index = scene_.add(sphere, material(word, color, specular, reflective));
        note(scene_.shape_texts, index, source_place(text_, word));
    }

    bool read_specular(double& specular) {
        if (p_.token().kind == TokenKind::word && p_.text(p_.token()) == "none") {
            p_.take();
            specular = -1;
            return true;
        }
        const Token at = p_.token();
        if (!p_.number(specular, k_book_specular)) return false;
        if (specular > -1 && specular < 0) {
            p_.error(at, fmt::format("expected {}, found {}", k_book_specular.text, p_.describe(at)));
        }
        return true;
    }

    // Spheres with equal surfaces share a material.
    std::uint32_t material(const Token& word, Color color, double specular, double reflective) {
        const auto next = static_cast<std::uint32_t>(scene_.materials.size());
        const auto [at, is_new] = looks_.try_emplace({color.r, color.g, color.b, specular, reflective}, next);
        if (is_new) {
            Material m;
            m.color = m.ambient = m.diffuse = color;
            m.specular = specular < 0 ? Color{} : color;
            m.shininess = specular < 0 ? 1 : specular;
            m.mirror = reflective;
            scene_.materials.push_back(m);
            note(scene_.material_texts, next, source_place(text_, word));
        }
        return at->second;
    }

    void read_light(const Token& word) {
        enum { k_type, k_intensity, k_position, k_direction };
        static constexpr Field fields[] = {{"type", true}, {"intensity", true}, {"position"}, {"direction"}};
        FieldSet set("light", fields);
        Light light;
        double intensity = 0;
        Token position_key, direction_key;
        const bool whole = blocks_.fields(set, word, [&](int field, const Token& key) {
            switch (field) {
                case k_type:
                    return read_light_type(light.kind);
                case k_intensity:
                    return p_.number(intensity, k_cgfs_channel);
                case k_position:
                    position_key = key;
                    return p_.point(light.position, k_coordinate, '(', ')');
                default:
                    direction_key = key;
                    return p_.point(light.to_light, k_coordinate, '(', ')');
            }
        });
        if (!whole || !p_.check_required(set, word)) return;
        const bool wants_position = light.has_position();
        const bool wants_direction = light.has_direction();
        if (wants_position && !set.has(k_position)) p_.error(word, "expected `position` in the point light");
        if (wants_direction && !set.has(k_direction))
            p_.error(word, "expected `direction` in the directional light");
        if (wants_direction && set.has(k_direction) && light.to_light == Vec3{0, 0, 0}) {
            p_.error(direction_key, "expected a direction other than (0, 0, 0)");
        }
        const auto warn_unused = [&](int field, bool wanted, const Token& key) {
            if (set.has(field) && !wanted) {
                p_.warn(key, fmt::format("glint ignores the {} of {} light", p_.describe(key),
                                         with_article(to_string(light.kind))));
            }
        };
        warn_unused(k_position, wants_position, position_key);
        warn_unused(k_direction, wants_direction, direction_key);
        light.color = light.specular_color = Color{1, 1, 1} * intensity;
        note(scene_.light_texts, scene_.lights.size(), source_place(text_, word));
        scene_.lights.push_back(light);
    }

    bool read_light_type(LightKind& kind) {
        static constexpr LightKind kinds[] = {LightKind::ambient, LightKind::point, LightKind::directional};
        std::string_view words[std::size(kinds)];
        for (std::size_t i = 0; i < std::size(kinds); ++i) words[i] = to_string(kinds[i]);
        int index = 0;
        if (!p_.choice(words, one_of(words), index)) return false;
        kind = kinds[index];
        return true;
    }

    void read_camera(const Token& word) {
        enum { k_position, k_rotation };
        static constexpr Field fields[] = {{"position"}, {"rotation"}};
        FieldSet set("camera", fields);
        Camera camera;
        for (int i = 0; i < 3; ++i)
            rotation_[i] = {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
        const bool whole = blocks_.fields(set, word, [&](int field, const Token&) {
            return field == k_position ? p_.point(camera.position, k_coordinate, '(', ')')
                                       : read_rotation(rotation_);
        });
        if (!whole) return;
        if (reading_.camera_given) p_.warn(word, "a second camera: the last one holds");
        reading_.camera_given = true;
        scene_.camera = camera;
        scene_.camera_place = source_place(text_, word);
        has_view_ = true;
    }

    bool read_rotation(Vec3 (&rows)[3]) {
        if (!p_.token().is('(')) {
            p_.expected("`(` and three rows `(x, y, z)`");
            return false;
        }
        p_.take();
        for (int i = 0; i < 3; ++i) {
            if (i > 0) p_.accept(',');
            if (p_.point(rows[i], k_coordinate, '(', ')')) continue;
            p_.skip_to_close(')');
            return true;
        }
        p_.accept(',');
        if (p_.accept(')')) return true;
        p_.expected("`)` after three rows");
        p_.skip_to_close(')');
        return true;
    }

    using Look = std::tuple<double, double, double, double, double>;

    LoadState& reading_;
    Scene& scene_;
    const ReadText& text_;
    Parser p_;
    BlockReader blocks_{p_, k_words, "`sphere`, `light`, `camera` or `background`"};
    CountedMap<Look, std::uint32_t> looks_;
    bool has_view_ = false;           // the text sets a property of its camera
    double viewport_[3] = {1, 1, 1};  // width, height, distance
    Vec3 rotation_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};

}  // namespace

void set_cgfs_defaults(Scene& scene) {
    scene.camera.frame = CameraFrame{};
    scene.background = {1, 1, 1};
}

void read_cgfs(LoadState& reading, const ReadText& text) { CgfsReader(reading, text).read(); }

}  // namespace glint
