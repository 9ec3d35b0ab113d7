// SPDX-License-Identifier: Apache-2.0
// Scene to .glint, such that load() reads back the same scene. docs/formats/glint.md describes the language.
#include <fmt/format.h>

#include <algorithm>

#include "base/status.h"
#include "formats/block_writer.h"
#include "formats/comments.h"
#include "formats/registry.h"
#include "formats/write_materials.h"
#include "formats/write_shapes.h"
#include "formats/write_textures.h"
#include "glint/version.h"
#include "glint/write.h"
#include "scene/camera_fields.h"
#include "scene/fog_fields.h"
#include "scene/light_fields.h"
#include "scene/sky_fields.h"

namespace glint {
namespace {

constexpr std::size_t k_readable = 10000;  // shapes; in larger scenes each shape is one line
constexpr std::size_t k_widest_column = 24;
constexpr std::string_view k_origin = "Converted from ";

class GlintWriter {
  public:
    GlintWriter(const Scene& scene, std::span<const SceneText> texts, std::span<const std::string> mesh_files)
        : scene_(scene),
          texts_(texts),
          mesh_files_(mesh_files),
          comments_(scene, texts),
          materials_(scene),
          block_(out_) {}

    std::string run() {
        write_heading();
        write_settings();
        write_camera();
        write_fog();
        write_block("background_gradient", scene_.gradient, k_gradient_fields, "type", ItemKind::gradient,
                    [](const BackgroundGradient& g) { return to_string(g.kind); });
        write_block("occlusion", scene_.occlusion, k_occlusion_fields, "method", ItemKind::occlusion,
                    [](const Occlusion& o) { return to_string(o.method); });
        write_lights();
        write_textures(block_, scene_, materials_, comments_);
        write_materials();
        if (!scene_.shapes.empty()) out_ += '\n';
        if (scene_.shapes.size() > k_readable) block_.keep_lines_whole();
        write_shapes(block_, scene_, materials_, comments_, mesh_files_);
        if (!comments_.tail().empty()) out_ += '\n';
        block_.comments(comments_.tail());
        return std::move(out_);
    }

  private:
    void write_heading() {
        if (texts_.empty()) return;
        const auto& heading = comments_.heading();
        // A converted text that is converted again keeps its origin.
        if (texts_.size() > 1 || heading.empty() || !heading.front().starts_with(k_origin)) {
            fmt::format_to(std::back_inserter(out_), "# {}{} by glint {}\n", k_origin, origin(),
                           GLINT_VERSION);
            if (!heading.empty()) out_ += "#\n";
        }
        block_.comments(heading);
        out_ += '\n';
    }

    // "castle.json (epfl), lights.cgfs (cgfs)"
    std::string origin() const {
        constexpr std::size_t most = 10;
        std::string all;
        for (const SceneText& text : texts_.first(std::min(texts_.size(), most))) {
            std::string why;
            const Format* format = find_format(text, why);
            const std::string_view name = std::string_view(text.name).substr(text.name.rfind('/') + 1);
            all += all.empty() ? "" : ", ";
            all += name == "-" ? "standard input" : name;
            if (format != nullptr) all += fmt::format(" ({})", format->info.name);
        }
        std::replace_if(
            all.begin(), all.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
        return texts_.size() > most ? all + " and others" : all;
    }

    void end(ItemKind kind, std::uint32_t index) { comments_.end_block(block_, kind, index); }

    void write_settings() {
        Scene usual;
        const bool is_known = apply_profile(usual, scene_.profile).ok();
        fmt::format_to(std::back_inserter(out_), "glint = 1\nprofile = {}\n",
                       is_known ? std::string_view(scene_.profile) : usual.profile);
        const auto keys = setting_keys();
        for (const bool conventions : {true, false}) {
            block_.begin(conventions ? "conventions" : "render");
            bool any = false;
            for (std::size_t i = 0; i < keys.size(); ++i) {
                const std::string value = get_setting(scene_, i);
                if (keys[i].is_convention != conventions) continue;
                const bool is_written = !conventions && keys[i].name != "alpha" && keys[i].name != "seed";
                if (!is_written && value == get_setting(usual, i)) continue;
                write_setting(keys[i].name, value);
                any = true;
            }
            if (any) block_.end();
        }
        block_.begin({});
        append(block_.key("background"), scene_.background);
        end(ItemKind::background, 0);
    }

    void write_setting(std::string_view key, std::string_view value) {
        if (key == "size") {
            fmt::format_to(std::back_inserter(block_.key(key)), "{} x {}", scene_.settings.width,
                           scene_.settings.height);
        } else if (value.find(':') != std::string_view::npos) {  // aa = "adaptive:4:0.1"
            fmt::format_to(std::back_inserter(block_.key(key)), "\"{}\"", value);
        } else {
            block_.key(key) += value;
        }
    }

    void write_camera() {
        const Camera& c = scene_.camera;
        out_ += '\n';
        block_.begin("camera");
        if (c.projection == Projection::orthographic) block_.key("projection") += "orthographic";
        for (const ItemField<Camera>& field : k_camera_fields) {
            if (!applies(field, c)) continue;
            if (is_field_of(field, &Camera::fov_degrees)) {
                append(block_.key(c.fov_axis == FovAxis::x ? field.key : field.other_key), c.fov_degrees);
            } else {
                write_field(block_, field, c);
            }
            if (!c.frame || !is_field_of(field, &Camera::position)) continue;
            for (const ItemField<CameraFrame>& axis : k_frame_fields) write_field(block_, axis, *c.frame);
        }
        end(ItemKind::camera, 0);
    }

    void write_fog() {
        if (!scene_.fog) return;
        out_ += '\n';
        block_.begin("fog");
        block_.key("type") += to_string(scene_.fog->kind);
        for (const ItemField<Fog>& field : k_fog_fields) {
            if (applies(field, *scene_.fog) && !same_bits(field, *scene_.fog, Fog{}))
                write_field(block_, field, *scene_.fog);
        }
        end(ItemKind::fog, 0);
    }

    // A block that a scene has at most once: its word by `key`, then the fields that differ from the default.
    template <class Item, std::size_t n, class Word>
    void write_block(std::string_view name, const std::optional<Item>& item,
                     const ItemField<Item> (&fields)[n], std::string_view key, ItemKind kind,
                     const Word& word_of) {
        if (!item) return;
        out_ += '\n';
        block_.begin(name);
        block_.key(key) += word_of(*item);
        for (const ItemField<Item>& field : fields) {
            if (!same_bits(field, *item, Item{})) write_field(block_, field, *item);
        }
        if constexpr (requires { item->color_map; }) write_color_map(block_, item->color_map);
        end(kind, 0);
    }

    void write_lights() {
        if (!scene_.lights.empty()) out_ += '\n';
        for (std::uint32_t i = 0; i < scene_.lights.size(); ++i) {
            block_.begin("light", scene_.light_texts.name(i));
            write_keys(scene_.lights[i]);
            end(ItemKind::light, i);
        }
    }

    void write_keys(const Light& l) {
        block_.key("type") += to_string(l.kind);
        const auto write_fields = [&](bool required) {
            for (const ItemField<Light>& field : k_light_fields) {
                if (is_light_color(field) || field.required != required || !applies(field, l)) continue;
                if (required || !same_bits(field, l, Light{})) write_field(block_, field, l);
            }
        };
        write_fields(true);
        const bool one_color = !l.has_specular_color() || same_bits(l.color, l.specular_color);
        if (one_color && same_bits(l.color, Color{l.color.r, l.color.r, l.color.r})) {
            append(block_.key("intensity"), l.color.r);
        } else {
            append(block_.key("color"), l.color);
            if (!one_color) append(block_.key("specular_color"), l.specular_color);
        }
        write_fields(false);
    }

    void write_materials() {
        std::size_t width = 0, count = 0;
        const auto for_each_named = [&](auto&& visit) {
            for (std::uint32_t i = 0; i < scene_.materials.size(); ++i) {
                if (materials_.written(i) != i || !materials_.is_named(i)) continue;
                head_ = "material ";
                append_name(head_, materials_.name(i));
                visit(i);
            }
        };
        for_each_named([&](std::uint32_t) {
            ++count;
            if (head_.size() <= k_widest_column) width = std::max(width, head_.size());
        });
        if (count != 0) out_ += '\n';
        for_each_named([&](std::uint32_t i) {
            block_.begin(head_, width);
            write_material_keys(block_, materials_, scene_.materials[i]);
            end(ItemKind::material, i);
        });
    }

    const Scene& scene_;
    const std::span<const SceneText> texts_;
    const std::span<const std::string> mesh_files_;
    const SceneComments comments_;
    const MaterialPlan materials_;
    std::string out_, head_;
    BlockWriter block_;
};

}  // namespace

Result<std::string> write_glint(const Scene& scene, std::span<const SceneText> texts,
                                std::span<const std::string> mesh_files) {
    const auto body = [&]() -> Result<std::string> {
        std::vector<Diagnostic> diagnostics = validate(scene);
        if (has_errors(diagnostics)) return invalid_scene(std::move(diagnostics));
        return GlintWriter(scene, texts, mesh_files).run();
    };
    return result_of(body, " while writing the scene as text");
}

}  // namespace glint
