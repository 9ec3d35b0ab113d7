// SPDX-License-Identifier: Apache-2.0
// Checks every number and index of a scene, so that later modules need not.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "base/parallel_for.h"
#include "base/status.h"
#include "base/text.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/camera_fields.h"
#include "scene/fog_fields.h"
#include "scene/light_fields.h"
#include "scene/material_fields.h"
#include "scene/mistakes.h"
#include "scene/parallel.h"
#include "scene/ranges.h"
#include "scene/settings.h"
#include "scene/sky_fields.h"
#include "scene/texture_fields.h"
#include "scene/validate_shapes.h"
#include "scene/validate_texture.h"
#include "scene/validate_transform.h"

namespace glint {
namespace {

constexpr std::size_t k_max_errors = 20;
constexpr double k_rounding = 1e-9;  // of a sum of decimal numbers

class Validator {
  public:
    explicit Validator(const Scene& scene) : scene_(scene), shapes_(scene) {}

    std::vector<Mistake> run() {
        for (const ScenePart part : {ScenePart::settings, ScenePart::camera, ScenePart::background,
                                     ScenePart::lights, ScenePart::materials})
            check_part(part);
        for (std::uint32_t i = 0; !full() && i < scene_.transforms.size(); ++i) check_transform(i, {});
        for (std::uint32_t i = 0; !full() && i < scene_.textures.size(); ++i) check_texture(i);
        for (std::uint32_t i = 0; !full() && i < scene_.materials.size(); ++i) check_texture_index(i);
        check_counts();
        for (std::size_t i = 0; !full() && i < scene_.shapes.size(); ++i)
            check_shape(static_cast<std::uint32_t>(i), scene_.materials.size());
        if (mistakes_.empty()) warn();
        return std::move(mistakes_);
    }

    std::vector<Mistake> run(ScenePart part) {
        check_part(part);
        return std::move(mistakes_);
    }

    std::vector<Mistake> run(const Material& material, std::uint32_t index) {
        check_material(material, index);
        return std::move(mistakes_);
    }

    std::vector<Mistake> run(std::span<const ShapeColor> colors) {
        for (std::size_t i = 0; !full() && i < colors.size(); ++i) {
            begin(SceneItem::shape, i);
            check_shape_color(colors[i], {},
                              [&] { return item("shape", static_cast<std::uint32_t>(i), {}); });
        }
        return std::move(mistakes_);
    }

    std::vector<Mistake> run(std::span<const std::uint32_t> shapes, std::size_t materials) {
        for (std::size_t i = 0; !full() && i < shapes.size(); ++i) {
            if (shapes[i] >= scene_.shapes.size()) {
                begin(SceneItem::shape, shapes[i]);
                error({}, fmt::format("there is no shape {}: the scene has {}", std::uint64_t{shapes[i]} + 1,
                                      scene_.shapes.size()));
                continue;
            }
            check_shape(shapes[i], materials);
            const std::uint32_t transform = scene_.shapes[shapes[i]].transform;
            if (transform < scene_.transforms.size())
                check_transform(transform, scene_.shape_texts.place(shapes[i]));
        }
        return std::move(mistakes_);
    }

  private:
    void check_part(ScenePart part) {
        switch (part) {
            case ScenePart::settings:
                return check_settings();
            case ScenePart::camera:
                begin(SceneItem::camera);
                return check_camera();
            case ScenePart::background:
                begin(SceneItem::background);
                check_color(k_channel, scene_.background, scene_.background_place, "the scene", "background");
                check_fog();
                check_gradient();
                return check_occlusion();
            case ScenePart::lights:
                for (std::uint32_t i = 0; !full() && i < scene_.lights.size(); ++i) check_light(i);
                return;
            case ScenePart::materials:
                for (std::uint32_t i = 0; !full() && i < scene_.materials.size(); ++i)
                    check_material(scene_.materials[i], i);
        }
    }

    bool full() const { return mistakes_.size() >= k_max_errors; }

    void error(SourcePlace place, std::string message) {
        if (!full()) mistakes_.push_back({Severity::error, place, std::move(message), item_, index_});
    }

    // Sets the item of the following errors.
    void begin(SceneItem item, std::size_t index = 0) {
        item_ = item;
        index_ = static_cast<std::uint32_t>(index);
    }

    void check(const Range& range, double x, SourcePlace place, std::string_view of, std::string_view what) {
        if (!range.contains(x))
            error(place, fmt::format("{}: {}: expected {}, found {}", of, what, range.text, x));
    }

    void check_point(Vec3 p, SourcePlace place, std::string_view of, std::string_view what) {
        if (!is_coordinate(p)) {
            error(place, fmt::format("{}: {}: expected coordinates from -1e12 to 1e12, found {}", of, what,
                                     text(p)));
        }
    }

    void check_direction(Vec3 v, SourcePlace place, std::string_view of, std::string_view what) {
        check_point(v, place, of, what);
        if (is_zero(v)) error(place, fmt::format("{}: {}: expected a direction, found (0, 0, 0)", of, what));
    }

    void check_color(const Range& range, Color c, SourcePlace place, std::string_view of,
                     std::string_view what) {
        if (!range.contains(c.r) || !range.contains(c.g) || !range.contains(c.b)) {
            error(place, fmt::format("{}: {}: expected each channel to be {}, found ({}, {}, {})", of, what,
                                     range.text, c.r, c.g, c.b));
        }
    }

    // A setting is valid if its text form is.
    void check_settings() {
        Scene copy;
        const auto keys = setting_keys();
        for (std::size_t i = 0; i < keys.size(); ++i) {
            begin(SceneItem::setting, i);
            const std::string wrong = set_setting(copy, i, get_setting(scene_, i), {}).message;
            const SourcePlace place = i < scene_.origins.size() ? scene_.origins[i].place : SourcePlace{};
            if (!wrong.empty()) error(place, fmt::format("{}: {}", keys[i].name, wrong));
        }
    }

    void check_fog() {
        if (!scene_.fog) return;
        begin(SceneItem::fog);
        const Fog& fog = *scene_.fog;
        if (fog.kind > FogKind::exp2) error(scene_.fog_place, "the fog: no such kind of fog");
        check_fields<Fog>(k_fog_fields, fog, scene_.fog_place, "the fog");
        if (fog.has_end() && !(fog.end > fog.start))
            error(scene_.fog_place, fmt::format("the fog: end: expected a number above start {}, found {}",
                                                fog.start, fog.end));
    }

    void check_gradient() {
        if (!scene_.gradient) return;
        begin(SceneItem::background);
        const BackgroundGradient& gradient = *scene_.gradient;
        const SourcePlace place = scene_.gradient_place;
        constexpr std::string_view of = "the background gradient";
        if (gradient.kind > GradientKind::plane) error(place, fmt::format("{}: no such kind", of));
        check_fields<BackgroundGradient>(k_gradient_fields, gradient, place, of);
        if (const std::string mistake = glint::mistake_in(gradient.color_map); !mistake.empty())
            error(place, fmt::format("{}: {}", of, mistake));
        for (const TextureColor& color : gradient.color_map) {
            if (color.alpha == 1) continue;
            error(place, fmt::format("{}: color_map: expected colors without alpha, found an alpha of {}", of,
                                     color.alpha));
            break;
        }
        if (!(gradient.top > gradient.bottom))
            error(place, fmt::format("{}: top: expected a number above bottom {}, found {}", of,
                                     gradient.bottom, gradient.top));
    }

    void check_occlusion() {
        if (!scene_.occlusion) return;
        begin(SceneItem::background);
        const SourcePlace place = scene_.occlusion_place;
        if (scene_.occlusion->method > OcclusionMethod::fixed) error(place, "the occlusion: no such method");
        check_fields<Occlusion>(k_occlusion_fields, *scene_.occlusion, place, "the occlusion");
    }

    void check_camera() {
        const Camera& c = scene_.camera;
        const SourcePlace place = scene_.camera_place;
        constexpr std::string_view of = "the camera";
        if (c.projection > Projection::orthographic || c.fov_axis > FovAxis::y) {
            error(place, "the camera: no such projection or fov axis");
        }
        check_fields<Camera>(k_camera_fields, c, place, of);
        if (c.frame) {
            check_frame(*c.frame, place);
            return;
        }
        const Vec3 forward = c.look_at - c.position;
        if (is_zero(forward)) {
            error(place, "the camera is at the point that it looks at: the two must differ");
        } else if (!is_zero(c.up) && are_parallel(forward, c.up)) {
            error(place, fmt::format("the camera's up {} is along its view direction {}", text(c.up),
                                     text(forward)));
        }
    }

    void check_frame(const CameraFrame& frame, SourcePlace place) {
        check_fields<CameraFrame>(k_frame_fields, frame, place, "the camera");
        if (is_zero(frame.right) || is_zero(frame.up) || is_zero(frame.forward)) return;
        const Vec3 normal = cross(unit_or_zero(frame.right), unit_or_zero(frame.up));
        const double volume = dot(normal, unit_or_zero(frame.forward));
        if (!(number::abs(volume) >= k_parallel)) {
            error(place, fmt::format("the camera's right {}, up {} and forward {} lie in one plane",
                                     text(frame.right), text(frame.up), text(frame.forward)));
        }
    }

    // The valid values of fields, by type.
    struct ValueCheck {
        Validator& validator;
        SourcePlace place;
        std::string_view of, label;
        void operator()(const NumberType& type, double x) const {
            validator.check(type.range, x, place, of, label);
        }
        void operator()(const WholeType& type, std::int32_t n) const {
            validator.check(type.range, n, place, of, label);
        }
        template <class Choice> void operator()(const ChoiceType& type, Choice choice) const {
            if (static_cast<std::size_t>(choice) >= type.words.size())
                validator.error(place, fmt::format("{}: {}: expected one of {}, found number {}", of, label,
                                                   fmt::join(type.words, ", "), static_cast<int>(choice)));
        }
        void operator()(TextureType, std::uint32_t) const {}  // check_texture_index()
        void operator()(UvMapType, const UvMap& map) const {
            for (const double x : numbers_of(map)) validator.check(k_coordinate, x, place, of, label);
        }
        void operator()(BoolType, bool) const {}
        void operator()(PointType, Vec3 p) const { validator.check_point(p, place, of, label); }
        void operator()(DirectionType, Vec3 d) const { validator.check_direction(d, place, of, label); }
        void operator()(const ColorType& type, Color c) const {
            validator.check_color(type.range, c, place, of, label);
        }
        void operator()(AttenuationType, const Attenuation& a) const {
            for (const double c : numbers_of(a)) validator.check(k_attenuation, c, place, of, label);
            if (a == Attenuation{0, 0, 0})
                validator.error(place,
                                fmt::format("{}: {}: expected one of its numbers to be > 0", of, label));
        }
    };

    template <class Item>
    void check_fields(std::span<const ItemField<Item>> fields, const Item& item, SourcePlace place,
                      std::string_view of) {
        for (const ItemField<Item>& field : fields) {
            if (applies(field, item)) visit_field(field, item, ValueCheck{*this, place, of, field.label});
        }
    }

    void check_light(std::uint32_t i) {
        begin(SceneItem::light, i);
        const Light& l = scene_.lights[i];
        const SourcePlace place = scene_.light_texts.place(i);
        const std::string of = item("light", i, scene_.light_texts.name(i));
        if (static_cast<int>(l.kind) >= k_light_kinds) error(place, of + ": no such kind of light");
        check_fields<Light>(k_light_fields, l, place, of);
        if (l.is_spot() && l.inner_angle > l.outer_angle)
            error(place,
                  fmt::format("{}: inner angle: expected at most the outer angle of {} degrees, found {}", of,
                              l.outer_angle, l.inner_angle));
        if (l.is_parallelogram() && !is_zero(l.side_u) && !is_zero(l.side_v) &&
            are_parallel(l.side_u, l.side_v))
            error(place, fmt::format("{}: expected sides that are not parallel, found {} and {}", of,
                                     text(l.side_u), text(l.side_v)));
    }

    void check_texture(std::uint32_t i) {
        begin(SceneItem::texture, i);
        const Texture& texture = scene_.textures[i];
        const SourcePlace place = scene_.texture_texts.place(i);
        const std::string of = item("texture", i, scene_.texture_texts.name(i));
        check_fields<Texture>(k_texture_fields, texture, place, of);
        if (const std::string mistake = mistake_in(texture); !mistake.empty())
            error(place, fmt::format("{}: {}", of, mistake));
        if (const std::string_view mistake = mistake_in(texture.world_from_texture); !mistake.empty())
            error(place, fmt::format("{}: its transform{}", of, mistake));
        check_layers(i, place, of);
    }

    // The layers from this texture on.
    void check_layers(std::uint32_t i, SourcePlace place, const std::string& of) {
        int layers = 1;
        for (std::uint32_t below = i; (below = scene_.textures[below].over) != k_none;) {
            if (below >= scene_.textures.size()) return error(place, of + ": over: no such texture");
            if (below == i) return error(place, of + ": over: the texture is over itself");
            if (++layers > k_max_texture_layers)
                return error(place,
                             fmt::format("{}: over: expected at most {} layers, found more, or a circle", of,
                                         k_max_texture_layers));
        }
        if (layers > 1 && scene_.textures[i].alpha == TextureAlpha::mask)
            error(place, of + ": over: expected an alpha other than mask");
    }

    void check_texture_index(std::uint32_t i) {
        const Material& m = scene_.materials[i];
        if (m.texture == k_none || m.texture < scene_.textures.size()) return;
        begin(SceneItem::material, i);
        error(scene_.material_texts.place(i),
              item("material", i, scene_.material_texts.name(i)) + ": no such texture");
    }

    void check_material(const Material& m, std::uint32_t i) {
        begin(SceneItem::material, i);
        const SourcePlace place = scene_.material_texts.place(i);
        const std::string of = item("material", i, scene_.material_texts.name(i));
        check_fields<Material>(k_material_fields, m, place, of);
        if (m.filter + m.transmit > 1 + k_rounding)
            error(place, fmt::format("{}: filter + transmit: expected at most 1, found {} + {}", of, m.filter,
                                     m.transmit));
        if (m.angled_opacity && m.filter > 0)
            error(place,
                  fmt::format("{}: expected `angled_opacity` or `filter`, found both: the angle changes "
                              "`transmit` alone",
                              of));
        if (m.is_transparent() && m.transmission > 0)
            error(place,
                  fmt::format("{}: expected `transmission` (with refraction) or `filter` and `transmit` "
                              "(without), found both",
                              of));
    }

    // place: nothing for a transform, whose place is that of the first shape with it.
    void check_transform(std::uint32_t i, std::optional<SourcePlace> place) {
        const std::string_view mistake = mistake_in(scene_.transforms[i]);
        if (mistake.empty()) return;
        begin(SceneItem::transform, i);
        error(place ? *place : place_of_transform(i), fmt::format("transform {}{}", i + 1, mistake));
    }

    // The place of the first shape with the transform.
    SourcePlace place_of_transform(std::uint32_t i) const {
        for (std::size_t s = 0; s < scene_.shapes.size(); ++s) {
            if (scene_.shapes[s].transform == i)
                return scene_.shape_texts.place(static_cast<std::uint32_t>(s));
        }
        return {};
    }

    void check_counts() {
        begin(SceneItem::none);
        const auto limited = [&](std::size_t n, std::string_view what) {
            if (n >= k_none) error({}, fmt::format("{} {}: at most {} are possible", n, what, k_none - 1));
        };
        limited(scene_.shapes.size(), "shapes");
        if (scene_.shape_colors.size() > scene_.shapes.size())
            error({}, fmt::format("{} colors of shapes: the scene has {} shapes", scene_.shape_colors.size(),
                                  scene_.shapes.size()));
        limited(scene_.materials.size(), "materials");
        limited(scene_.lights.size(), "lights");
        limited(scene_.transforms.size(), "transforms");
        limited(scene_.textures.size(), "textures");
    }

    void check_shape(std::uint32_t i, std::size_t materials) {
        const Shape& s = scene_.shapes[i];
        const auto indexed = [](std::uint32_t index, std::size_t n) { return index == k_none || index < n; };
        if (!indexed(s.material, materials)) shape_error(i, "no such material");
        if (!indexed(s.transform, scene_.transforms.size())) shape_error(i, "no such transform");
        for (const std::string& mistake : shapes_.mistakes(s)) shape_error(i, mistake);
        for (const Shape& operand : operands_of(scene_, s)) {
            if (!indexed(operand.material, materials)) shape_error(i, "an operand: no such material");
        }
        if (s.kind == ShapeKind::mesh && s.transform < scene_.transforms.size()) check_mesh_map(i);
        if (i >= scene_.shape_colors.size()) return;
        check_shape_color(scene_.shape_colors[i], scene_.shape_texts.place(i), [&] {
            begin(SceneItem::shape, i);
            return item(to_string(s.kind), i, scene_.shape_texts.name(i));
        });
    }

    // Rays are mapped into the mesh's coordinates. Measured: of a stretched mesh that a map makes round
    // again, the picture is that of its triangles up to 1e7; at 1e8, thousands of pixels are others. Factors
    // along the mesh's own axes do no harm: they are left out.
    void check_mesh_map(std::uint32_t i) {
        const Affine& map = scene_.transforms[scene_.shapes[i].transform];
        const std::optional<Affine> inverted = inverse(map);
        if (!inverted) return;  // check_transform() says so
        Affine shear = map, back = *inverted;
        for (int k = 0; k < 3; ++k) {
            const double factor = length({map.m[0][k], map.m[1][k], map.m[2][k]});
            for (int i = 0; i < 3; ++i) shear.m[i][k] /= factor, back.m[k][i] *= factor;
        }
        const double condition = longest_row(shear) * longest_row(back);
        if (condition > 1e7) {
            shape_error(i, fmt::format("expected a transform with a condition number of at most 1e7, found "
                                       "{:.3g}",
                                       condition));
        }
    }

    static double longest_row(const Affine& map) {
        double most = 0;
        for (const auto& row : map.m) most = number::max(most, length({row[0], row[1], row[2]}));
        return most;
    }

    // name(): the shape's, called only for a message.
    template <class Name>
    void check_shape_color(const ShapeColor& color, SourcePlace place, const Name& name) {
        const auto valid = [](float x) { return k_channel.contains(x); };
        if (!color.is_set() || (valid(color.r) && valid(color.g) && valid(color.b))) return;
        check_color(k_channel, color.color(), place, name(), "color");
    }

    // The name of a shape is formatted only for a message: there may be millions of shapes.
    void shape_error(std::uint32_t i, std::string_view message) {
        begin(SceneItem::shape, i);
        const std::string of = item(to_string(scene_.shapes[i].kind), i, scene_.shape_texts.name(i));
        error(scene_.shape_texts.place(i), fmt::format("{}: {}", of, message));
    }

    static std::string item(std::string_view word, std::uint32_t i, std::string_view name) {
        return name.empty() ? fmt::format("{} {}", word, std::uint64_t{i} + 1)
                            : fmt::format("{} {}", word, quoted(name));
    }

    void warn() {
        const Shading shading = scene_.settings.shading;
        if (scene_.shapes.empty()) {
            mistakes_.push_back(
                {Severity::warning, {}, "the scene has no shapes: the picture shows only its background"});
        } else if (scene_.lights.empty() && shading != Shading::color && shading != Shading::normals) {
            mistakes_.push_back(
                {Severity::warning,
                 {},
                 "the scene has no lights: the picture will be black but for its background"});
        }
        if (!scene_.conventions.cones) note_omitted_cones();
    }

    void note_omitted_cones() {
        for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
            if (scene_.shapes[i].kind != ShapeKind::cone) continue;
            mistakes_.push_back(
                {Severity::note, scene_.shape_texts.place(static_cast<std::uint32_t>(i)),
                 fmt::format("the conventions of {} ignore cones; `--convention cones=true` renders them",
                             scene_.profile),
                 SceneItem::shape, static_cast<std::uint32_t>(i)});
            return;
        }
    }

    const Scene& scene_;
    ShapeCheck shapes_;
    SceneItem item_ = SceneItem::none;  // the item being checked
    std::uint32_t index_ = 0;
    std::vector<Mistake> mistakes_;
};

}  // namespace

std::vector<Mistake> find_mistakes(const Scene& scene) { return Validator(scene).run(); }

std::vector<Mistake> find_mistakes(const Scene& scene, ScenePart part) { return Validator(scene).run(part); }

std::vector<Mistake> find_mistakes(const Material& material, std::uint32_t index) {
    return Validator(Scene{}).run(material, index);
}

std::vector<Mistake> find_mistakes(std::span<const ShapeColor> colors) {
    return Validator(Scene{}).run(colors);
}

std::vector<Mistake> find_mistakes(const Scene& scene, std::span<const std::uint32_t> shapes,
                                   std::size_t materials, int threads) {
    constexpr std::size_t chunk = 16384;  // shapes per task
    if (shapes.size() <= chunk) return Validator(scene).run(shapes, materials);
    // Most scenes have no mistakes. Messages are made on this thread, where out-of-memory errors are handled.
    std::atomic<bool> valid{true};
    parallel_for((shapes.size() + chunk - 1) / chunk, threads, [&](std::size_t i) {
        const auto some = shapes.subspan(i * chunk, std::min(chunk, shapes.size() - i * chunk));
        const Status checked = status_of([&] {
            if (!Validator(scene).run(some, materials).empty()) valid = false;
        });
        if (!checked.ok()) valid = false;
    });
    if (valid) return {};
    return Validator(scene).run(shapes, materials);
}

}  // namespace glint
