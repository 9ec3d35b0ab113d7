// SPDX-License-Identifier: Apache-2.0
// One scene of RT2 "Lighting and light rays": camera, materials, lights, spheres, planes, cylinders.
// docs/formats/epfl.md.
#include "formats/epfl.h"

#include <algorithm>
#include <set>

#include "base/text.h"
#include "formats/data_reader.h"
#include "formats/registry.h"
#include "math/number.h"

namespace glint {
namespace {

// The material of a shape; it is resolved when the whole text has been read.
struct MaterialUse {
    std::uint32_t shape;
    std::uint32_t length;
    std::size_t offset;
};

class SceneReader {
  public:
    SceneReader(LoadState& reading, const ReadText& text, Parser& parser)
        : reading_(reading), scene_(reading.scene), text_(text), p_(parser), data_(parser) {}

    bool read() {
        enum { k_name, k_camera, k_materials, k_lights, k_spheres, k_planes, k_cylinders };
        FieldSet set("scene", k_epfl_scene_fields);
        const Token begin = p_.token();
        std::string name;  // only for choosing among scenes
        add_ambient_light();
        const bool whole = data_.object(set, [&](int field, const Token& key) {
            switch (field) {
                case k_camera:
                    return read_camera(key);
                case k_materials:
                    return data_.list("materials", [&] { return read_material(); });
                case k_lights:
                    return data_.list("lights", [&] { return read_light(); });
                case k_spheres:
                    return data_.list("spheres", [&] { return read_sphere(); });
                case k_planes:
                    return data_.list("planes", [&] { return read_plane(); });
                case k_cylinders:
                    return data_.list("cylinders", [&] { return read_cylinder(); });
                default:
                    return read_name(name);
            }
        });
        if (!set.has(k_camera) && !reading_.camera_wanted) {
            reading_.camera_wanted = make_diagnostic(Severity::error, text_.place, begin.offset, begin.length,
                                                     "expected `camera` in the scene");
        }
        if (whole) resolve_materials();
        return whole;
    }

  private:
    // RT2 uses I_a = (1, 1, 1) for every scene.
    void add_ambient_light() {
        if (reading_.own_ambient_light) return;
        reading_.own_ambient_light = true;
        Light light;
        light.kind = LightKind::ambient;
        note(scene_.light_texts, scene_.lights.size(), {}, "ambient");
        scene_.lights.push_back(light);
    }

    bool read_name(std::string& name) {
        if (p_.token().kind != TokenKind::string) {
            p_.expected("a name in quotes");
            return false;
        }
        name = p_.name(p_.take());
        return true;
    }

    bool read_point(Vec3& point) { return p_.point(point, k_coordinate, '[', ']'); }

    bool read_direction(Vec3& direction) {
        const Token at = p_.token();
        const auto errors = reading_.diagnostics.error_count();
        if (!read_point(direction)) return false;
        if (direction == Vec3{0, 0, 0} && errors == reading_.diagnostics.error_count()) {
            p_.error(at, "expected a direction other than [0, 0, 0]");
        }
        return true;
    }

    bool read_color(Color& color) {
        double v[3] = {};
        if (!p_.triple(v, k_channel, '[', ']')) return false;
        color = {v[0], v[1], v[2]};
        return true;
    }

    bool read_camera(const Token& key) {
        enum { k_position, k_target, k_up, k_fov };
        static constexpr Field fields[] = {{"position", true}, {"target", true}, {"up", true}, {"fov", true}};
        FieldSet set("camera", fields);
        Camera camera;
        const bool whole = data_.object(set, [&](int field, const Token&) {
            switch (field) {
                case k_position:
                    return read_point(camera.position);
                case k_target:
                    return read_point(camera.look_at);
                case k_up:
                    return read_direction(camera.up);
                default:
                    return p_.number(camera.fov_degrees, k_angle);
            }
        });
        if (!whole) return false;
        p_.check_required(set, key);
        if (reading_.camera_given) p_.warn(key, "a second camera: the last one holds");
        reading_.camera_given = true;
        scene_.camera = camera;
        scene_.camera_place = source_place(text_, key);
        return true;
    }

    bool read_material() {
        enum { k_name, k_color, k_ambient, k_diffuse, k_specular, k_shininess, k_mirror };
        static constexpr Field fields[] = {{"name", true}, {"color", true}, {"ambient"}, {"diffuse"},
                                           {"specular"},   {"shininess"},   {"mirror"}};
        FieldSet set("material", fields);
        const Token begin = p_.token();
        std::string name;
        Material m;
        double ambient = 0, diffuse = 0, specular = 0;
        m.shininess = 1;
        const bool whole = data_.object(set, [&](int field, const Token&) {
            switch (field) {
                case k_name:
                    return read_name(name);
                case k_color:
                    return read_color(m.color);
                case k_ambient:
                    return p_.number(ambient, k_channel);
                case k_diffuse:
                    return p_.number(diffuse, k_channel);
                case k_specular:
                    return p_.number(specular, k_channel);
                case k_shininess:
                    return p_.number(m.shininess, k_exponent);
                default:
                    return p_.number(m.mirror, k_fraction);
            }
        });
        if (!whole) return false;
        if (!p_.check_required(set, begin)) return true;
        for (const int field : {k_ambient, k_diffuse, k_specular, k_shininess}) {
            if (set.has(field)) continue;
            p_.warn(begin, fmt::format("material {} has no `{}`: {} is taken", quoted(name),
                                       fields[field].name, field == k_shininess ? 1 : 0));
        }
        m.ambient = m.color * ambient;
        m.diffuse = m.color * diffuse;
        m.specular = m.color * specular;
        const auto index = static_cast<std::uint32_t>(scene_.materials.size());
        if (!own_materials_.insert(name).second) {
            p_.warn(begin, fmt::format("a second material {}: the last one holds", quoted(name)));
        }
        reading_.materials.insert_or_assign(name, index);
        scene_.materials.push_back(m);
        note(scene_.material_texts, index, source_place(text_, begin), std::move(name));
        return true;
    }

    bool read_light() {
        enum { k_position, k_color };
        static constexpr Field fields[] = {{"position", true}, {"color", true}};
        FieldSet set("light", fields);
        const Token begin = p_.token();
        Light light;
        const bool whole = data_.object(set, [&](int field, const Token&) {
            return field == k_position ? read_point(light.position) : read_color(light.color);
        });
        if (!whole) return false;
        if (!p_.check_required(set, begin)) return true;
        light.specular_color = light.color;
        note(scene_.light_texts, scene_.lights.size(), source_place(text_, begin));
        scene_.lights.push_back(light);
        return true;
    }

    bool read_sphere() {
        enum { k_center, k_radius, k_material };
        static constexpr Field fields[] = {{"center", true}, {"radius", true}, {"material", true}};
        FieldSet set("sphere", fields);
        Sphere sphere;
        return read_shape(set, sphere, k_material, [&](int field) {
            return field == k_center ? read_point(sphere.center) : p_.number(sphere.radius, k_length);
        });
    }

    bool read_plane() {
        enum { k_center, k_normal, k_material };
        static constexpr Field fields[] = {{"center", true}, {"normal", true}, {"material", true}};
        FieldSet set("plane", fields);
        Plane plane;
        return read_shape(set, plane, k_material, [&](int field) {
            return field == k_center ? read_point(plane.point) : read_direction(plane.normal);
        });
    }

    bool read_cylinder() {
        enum { k_center, k_axis, k_radius, k_height, k_material };
        static constexpr Field fields[] = {
            {"center", true}, {"axis", true}, {"radius", true}, {"height", true}, {"material", true}};
        FieldSet set("cylinder", fields);
        Vec3 center, axis{0, 0, 1};
        double height = 1;
        Cylinder cylinder;
        return read_shape(
            set, cylinder, k_material,
            [&](int field) {
                switch (field) {
                    case k_center:
                        return read_point(center);
                    case k_axis:
                        return read_direction(axis);
                    case k_radius:
                        return p_.number(cylinder.radius, k_length);
                    default:
                        return p_.number(height, k_length);
                }
            },
            [&] {
                // Divides by the largest component first, so that no square underflows.
                const double largest =
                    std::max({number::abs(axis.x), number::abs(axis.y), number::abs(axis.z)});
                const Vec3 scaled = axis / largest;
                const Vec3 half = scaled / number::sqrt(dot(scaled, scaled)) * (height / 2);
                cylinder.from = center - half;
                cylinder.to = center + half;
            });
    }

    template <class Shape, class ReadField, class Finish = void (*)()>
    bool read_shape(
        FieldSet& set, const Shape& shape, int material_field, ReadField&& read_field,
        Finish&& finish = [] {}) {
        const Token begin = p_.token();
        Token material;
        const bool whole = data_.object(set, [&](int field, const Token&) {
            if (field != material_field) return read_field(field);
            material = p_.token();
            if (material.kind != TokenKind::string) {
                p_.expected("a material's name in quotes");
                return false;
            }
            p_.take();
            return true;
        });
        if (!whole) return false;
        if (!p_.check_required(set, begin)) return true;
        finish();
        const std::uint32_t index = scene_.add(shape);
        note(scene_.shape_texts, index, source_place(text_, begin));
        if (material.kind == TokenKind::string) {
            const auto length =
                static_cast<std::uint32_t>(std::min<std::size_t>(material.length, 0xffffffffu));
            uses_.push_back({index, length, material.offset});
        }
        return true;
    }

    void resolve_materials() {
        std::string_view last;
        std::uint32_t last_index = k_none;
        for (const MaterialUse& use : uses_) {
            Token token;
            token.kind = TokenKind::string;
            token.offset = use.offset;
            token.length = use.length;
            if (p_.text(token) != last) {
                last = p_.text(token);
                const auto at = reading_.materials.find(p_.name(token));
                last_index = at == reading_.materials.end() ? k_none : at->second;
            }
            scene_.shapes[use.shape].material = last_index;
            if (last_index != k_none) continue;
            report_unknown_material(token);
            if (!p_.alive()) return;
        }
    }

    void report_unknown_material(const Token& token) {
        std::vector<std::string_view> names;
        for (const auto& [name, index] : reading_.materials) {
            if (names.size() < 1000) names.push_back(name);
        }
        const std::string name = p_.name(token);
        p_.error(token, fmt::format("no material is called {}{}", quoted(name), did_you_mean(name, names)));
    }

    LoadState& reading_;
    Scene& scene_;
    const ReadText& text_;
    Parser& p_;
    DataReader data_;
    std::set<std::string, std::less<>, Counted<std::string>> own_materials_;
    CountedVector<MaterialUse> uses_;
};

}  // namespace

void set_epfl_defaults(Scene& scene) {
    scene.background = {0, 0, 0};
    scene.unit_normals.of_planes = true;
    scene.unit_normals.reason = "RT2's lighting takes it as it is, and N.L with it";
}

bool read_epfl_scene(LoadState& reading, const ReadText& text, Parser& parser) {
    return SceneReader(reading, text, parser).read();
}

}  // namespace glint
