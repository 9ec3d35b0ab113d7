// .cgfs: the listings of "Computer Graphics from Scratch", and a camera beside them. docs/formats/cgfs.md.
#include <fmt/format.h>

#include <tuple>

#include "base/text.h"
#include "formats/registry.h"

namespace glint {
namespace {

constexpr Range k_byte_channel{-1e6, 1e6, false, false, "a number from 0 to 255"};
constexpr Range k_book_specular{-1, 1e9, false, false, "-1 (matte) or a number from 0 to 1e9"};

constexpr std::string_view k_top_level[] = {"sphere",     "light",         "camera",
                                            "background", "viewport_size", "projection_plane_d"};

class CgfsReader {
  public:
    CgfsReader(Reading& reading, const ReadText& text)
        : reading_(reading),
          scene_(reading.scene),
          text_(text),
          p_(text.place, {.hash_comments = true, .slash_comments = true}, reading.diagnostics) {}

    void read() {
        if (p_.at_end()) p_.expected("`sphere`, `light`, `camera` or `background`");
        while (!p_.at_end() || pending_) read_item();
        if (has_view_) set_camera_frame();
    }

  private:
    void read_item() {
        if (!pending_ && (p_.accept(',') || p_.accept(';'))) return;
        if (!pending_ && p_.token().kind != TokenKind::word) {
            p_.expected("`sphere`, `light`, `camera` or `background`");
            if (p_.at_closing_bracket() || !p_.skip_value()) p_.take();
            return;
        }
        const Token word = pending_ ? *pending_ : p_.take();
        pending_.reset();
        const auto name = p_.text(word);
        if (p_.token().is('{')) return read_block(word, name);
        if (p_.accept('=')) return read_setting(word, name);
        p_.error(p_.token(), fmt::format("expected `{{` or `=` after {}, found {}", quoted(name),
                                         p_.describe(p_.token())));
        while (!p_.at_end() && p_.token().line == word.line) p_.take();
    }

    void read_block(const Token& word, std::string_view name) {
        if (name == "sphere") return read_sphere(word);
        if (name == "light") return read_light(word);
        if (name == "camera") return read_camera(word);
        p_.warn_once(std::string(name), word,
                     fmt::format("glint ignores {}{}", quoted(name), did_you_mean(name, k_top_level)));
        if (!p_.skip_value()) p_.skip_to_close('}');
    }

    void read_setting(const Token& word, std::string_view name) {
        bool ok = true;
        if (name == "background") {
            Color color;
            ok = read_color(color);
            if (reading_.background_given) p_.warn(word, "a second background: the last one holds");
            reading_.background_given = true;
            scene_.background = color;
            scene_.background_place = source_place(text_, word);
        } else if (name == "viewport_size") {
            ok = p_.number(viewport_[0], k_length);
            if (ok && p_.token().kind == TokenKind::word && p_.text(p_.token()) == "x") {
                p_.take();
                ok = p_.number(viewport_[1], k_length);
            } else if (ok) {
                p_.expected("`x` and the viewport's height");
                ok = false;
            }
            has_view_ = true;
        } else if (name == "projection_plane_d") {
            ok = p_.number(viewport_[2], k_length);
            has_view_ = true;
        } else {
            p_.warn_once(std::string(name), word,
                         fmt::format("glint ignores {}{}", quoted(name), did_you_mean(name, k_top_level)));
            ok = skip_value();
        }
        if (!ok) skip_bad_value();
    }

    // direction = rotation * viewport point: the columns are where x, y and z go.
    void set_camera_frame() {
        const auto& r = rotation_;
        reading_.camera_given = true;
        scene_.camera.frame = CameraFrame{viewport_[0] * Vec3{r[0].x, r[1].x, r[2].x},
                                          viewport_[1] * Vec3{r[0].y, r[1].y, r[2].y},
                                          viewport_[2] * Vec3{r[0].z, r[1].z, r[2].z}};
    }

    // The keys and values of the block that begins here; read_field(key, name) reads a value, or returns
    // false before what is none. False if the block has no end.
    template <class ReadField> bool read_fields(const Token& block, ReadField&& read_field) {
        p_.expect('{');
        while (!p_.accept('}')) {
            if (p_.accept(',') || p_.accept(';')) continue;
            if (p_.at_end()) {
                p_.expected(fmt::format("`}}`: the block that begins in line {} has no end", block.line));
                return false;
            }
            if (p_.token().kind != TokenKind::word) {
                p_.expected("a key or `}`");
                return recover();
            }
            const Token key = p_.take();
            if (p_.token().is('{')) {
                p_.error(key,
                         fmt::format("expected `}}` before {}: the block that begins in line {} has no end",
                                     p_.describe(key), block.line));
                pending_ = key;
                return false;
            }
            if (!p_.expect('=')) return recover();
            if (!read_field(key, p_.text(key))) skip_bad_value();
        }
        return true;
    }

    // After a mistake: to the end of the block, or to a block that begins before it.
    bool recover() {
        Token last;
        while (!p_.at_end() && !p_.accept('}')) {
            if (p_.token().is('{') && last.kind == TokenKind::word) {
                pending_ = last;
                break;
            }
            last = p_.take();
        }
        return false;
    }

    // What stands where a value should: all before the next key, block, or end of this block.
    void skip_bad_value() {
        while (!p_.at_end() && !p_.at_closing_bracket() && !p_.peek().is('=') && !p_.peek().is('{')) {
            const bool in_brackets = p_.token().is('(');
            p_.take();
            if (in_brackets) p_.skip_to_close(')');
        }
    }

    bool skip_value() {
        if (p_.at_end() || p_.token().is('}')) {
            p_.expected("a value");
            return false;
        }
        if (!p_.skip_value()) return false;
        if (p_.token().kind == TokenKind::word && p_.text(p_.token()) == "x" && !p_.peek().is('=')) {
            p_.take();  // 1 x 1
            return p_.skip_value();
        }
        return true;
    }

    bool read_color(Color& color) {
        const Token at = p_.token();
        double v[3] = {};
        if (!p_.triple(v, k_byte_channel, '(', ')')) return false;
        for (double& x : v) {
            if (!(x >= 0 && x <= 255)) {
                p_.warn(at, "a color's numbers go from 0 to 255; this one is drawn as it is written");
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
        const bool whole = read_fields(word, [&](const Token& key, std::string_view name) {
            switch (p_.field(set, key, name)) {
                case k_center:
                    return p_.point(sphere.center, k_coordinate, '(', ')');
                case k_radius:
                    return p_.number(sphere.radius, k_length);
                case k_color:
                    return read_color(color);
                case k_specular:
                    return read_specular(specular);
                case k_reflective:
                    return p_.number(reflective, k_fraction);
                default:
                    return skip_value();
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

    // Spheres that look the same share a material.
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
        const bool whole = read_fields(word, [&](const Token& key, std::string_view name) {
            switch (p_.field(set, key, name)) {
                case k_type:
                    return read_light_type(light.kind);
                case k_intensity:
                    return p_.number(intensity, k_channel);
                case k_position:
                    position_key = key;
                    return p_.point(light.position, k_coordinate, '(', ')');
                case k_direction:
                    direction_key = key;
                    return p_.point(light.to_light, k_coordinate, '(', ')');
                default:
                    return skip_value();
            }
        });
        if (!whole || !p_.check_required(set, word)) return;
        const bool wants_position = light.kind == LightKind::point;
        const bool wants_direction = light.kind == LightKind::directional;
        if (wants_position && !set.has(k_position)) p_.error(word, "expected `position` in the point light");
        if (wants_direction && !set.has(k_direction))
            p_.error(word, "expected `direction` in the directional light");
        if (wants_direction && set.has(k_direction) && light.to_light == Vec3{0, 0, 0}) {
            p_.error(direction_key, "expected a direction other than (0, 0, 0)");
        }
        const auto warn_unused = [&](int field, bool wanted, const Token& key) {
            if (set.has(field) && !wanted) {
                p_.warn(key, fmt::format("glint ignores the {} of {} light", p_.describe(key),
                                         wants_position    ? "a point"
                                         : wants_direction ? "a directional"
                                                           : "an ambient"));
            }
        };
        warn_unused(k_position, wants_position, position_key);
        warn_unused(k_direction, wants_direction, direction_key);
        light.color = light.specular_color = Color{1, 1, 1} * intensity;
        note(scene_.light_texts, scene_.lights.size(), source_place(text_, word));
        scene_.lights.push_back(light);
    }

    bool read_light_type(LightKind& kind) {
        static constexpr std::string_view words[] = {"ambient", "point", "directional"};
        const Token token = p_.token();
        if (token.kind != TokenKind::word && token.kind != TokenKind::string) {
            p_.expected("`ambient`, `point` or `directional`");
            return false;
        }
        const std::string name = p_.name(token);
        for (int i = 0; i < 3; ++i) {
            if (name != words[i]) continue;
            kind = static_cast<LightKind>(i);
            p_.take();
            return true;
        }
        p_.error(token, fmt::format("expected `ambient`, `point` or `directional`, found {}{}",
                                    p_.describe(token), did_you_mean(name, words)));
        return false;
    }

    void read_camera(const Token& word) {
        enum { k_position, k_rotation };
        static constexpr Field fields[] = {{"position"}, {"rotation"}};
        FieldSet set("camera", fields);
        Camera camera;
        for (int i = 0; i < 3; ++i)
            rotation_[i] = {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
        const bool whole = read_fields(word, [&](const Token& key, std::string_view name) {
            switch (p_.field(set, key, name)) {
                case k_position:
                    return p_.point(camera.position, k_coordinate, '(', ')');
                case k_rotation:
                    return read_rotation(rotation_);
                default:
                    return skip_value();
            }
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

    Reading& reading_;
    Scene& scene_;
    const ReadText& text_;
    Parser p_;
    std::optional<Token> pending_;  // the word of a block, taken when its `{` was met
    std::map<Look, std::uint32_t> looks_;
    bool has_view_ = false;           // the text says something about its camera
    double viewport_[3] = {1, 1, 1};  // width, height, distance
    Vec3 rotation_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};

}  // namespace

void set_cgfs_defaults(Scene& scene) {
    scene.camera.frame = CameraFrame{};
    scene.background = {1, 1, 1};
}

void read_cgfs(Reading& reading, const ReadText& text) { CgfsReader(reading, text).read(); }

}  // namespace glint
