// SPDX-License-Identifier: Apache-2.0
// Checks every number and index of a scene, so that later modules need not.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "base/parallel_for.h"
#include "base/status.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/mistakes.h"
#include "scene/ranges.h"
#include "scene/validate_parts.h"
#include "scene/validate_shapes.h"
#include "scene/validate_transform.h"

namespace glint {
namespace {

class Validator : public PartValidator {
  public:
    explicit Validator(const Scene& scene) : PartValidator(scene), shapes_(scene) {}

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
        if (!has_mistakes()) warn();
        return take();
    }

    std::vector<Mistake> run(ScenePart part) {
        check_part(part);
        return take();
    }

    std::vector<Mistake> run(const Material& material, std::uint32_t index) {
        check_material(material, index);
        return take();
    }

    std::vector<Mistake> run(std::span<const ShapeColor> colors) {
        for (std::size_t i = 0; !full() && i < colors.size(); ++i) {
            begin(SceneItem::shape, i);
            check_shape_color(colors[i], {},
                              [&] { return item("shape", static_cast<std::uint32_t>(i), {}); });
        }
        return take();
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
        return take();
    }

  private:
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
            if (operand.kind == ShapeKind::mesh) check_mesh_map(i, compose(map_of(s), map_of(operand)));
        }
        if (s.kind == ShapeKind::mesh) check_mesh_map(i, map_of(s));
        if (i >= scene_.shape_colors.size()) return;
        check_shape_color(scene_.shape_colors[i], scene_.shape_texts.place(i), [&] {
            begin(SceneItem::shape, i);
            return item(to_string(s.kind), i, scene_.shape_texts.name(i));
        });
    }

    Affine map_of(const Shape& s) const {
        return s.transform < scene_.transforms.size() ? scene_.transforms[s.transform] : Affine{};
    }

    // Rays are mapped into the mesh's coordinates. Measured: of a stretched mesh that a map makes round
    // again, the picture is that of its triangles up to 1e7; at 1e8, thousands of pixels are others. Factors
    // along the mesh's own axes do no harm: they are left out.
    void check_mesh_map(std::uint32_t i, const Affine& map) {
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

    void warn() {
        const Shading shading = scene_.settings.shading;
        if (scene_.shapes.empty()) {
            add({Severity::warning, {}, "the scene has no shapes: the picture shows only its background"});
        } else if (scene_.lights.empty() && shading != Shading::color && shading != Shading::normals) {
            const bool emits =
                std::any_of(scene_.materials.begin(), scene_.materials.end(), [](const Material& m) {
                    return !(m.emission == Color{0, 0, 0});
                });
            add({Severity::warning,
                 {},
                 emits ? "the scene has no lights: only its background and what emits light will be seen"
                       : "the scene has no lights: the picture will be black but for its background"});
        }
        if (!scene_.conventions.cones) note_omitted_cones();
    }

    void note_omitted_cones() {
        for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
            if (scene_.shapes[i].kind != ShapeKind::cone) continue;
            add({Severity::note, scene_.shape_texts.place(static_cast<std::uint32_t>(i)),
                 fmt::format("the conventions of {} ignore cones; `--convention cones=true` renders them",
                             scene_.profile),
                 SceneItem::shape, static_cast<std::uint32_t>(i)});
            return;
        }
    }

    ShapeCheck shapes_;
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
