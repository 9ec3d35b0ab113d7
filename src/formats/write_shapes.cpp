// SPDX-License-Identifier: Apache-2.0
#include "formats/write_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "math/transform.h"
#include "scene/solid_steps.h"

namespace glint {
namespace {

std::string_view word_of(ShapeKind kind) {
    return kind == ShapeKind::smooth_triangle ? "triangle" : to_string(kind);
}

struct FieldWriter {
    BlockWriter& block;
    void point(std::string_view key, const Vec3& value) { append(block.key(key), value); }
    void direction(std::string_view key, const Vec3& value) { append(block.key(key), value); }
    void length(std::string_view key, double value) { append(block.key(key), value); }
    void radius(std::string_view key, double value) {
        if (value != 0) append(block.key(key), value);
    }
    void coefficients(std::string_view key, const Vec3& value) {
        if (!glint::same_bits(value, Vec3{})) append(block.key(key), value);
    }
    void coefficient(std::string_view key, double value) {
        if (!glint::same_bits(value, 0.0)) append(block.key(key), value);
    }
};

class ShapeWriter {
  public:
    ShapeWriter(BlockWriter& block, const Scene& scene, const MaterialPlan& materials,
                const SceneComments& comments, std::span<const std::string> mesh_files)
        : block_(block), scene_(scene), materials_(materials), comments_(comments), mesh_files_(mesh_files) {}

    void run() {
        bool kinds[k_shape_kinds] = {};
        for (const Shape& s : scene_.shapes) kinds[static_cast<std::size_t>(s.kind)] = true;
        for (int k = 0; k < k_shape_kinds; ++k) {
            if (kinds[k]) word_width_ = std::max(word_width_, word_of(static_cast<ShapeKind>(k)).size());
        }
        const auto count = static_cast<std::uint32_t>(scene_.shapes.size());
        for (std::uint32_t i = 0; i < count;) {
            std::uint32_t end = i + 1;
            while (end < count && have_same_transform(i, end)) ++end;
            const std::uint32_t transform = scene_.shapes[i].transform;
            const bool is_group = transform != k_none && end - i > 1;
            if (is_group) {
                block_.open("group");
                block_.begin({});
                write_map(block_, scene_.transforms[transform]);
                block_.end();
            }
            for (; i < end; ++i) write_shape(i, is_group ? k_none : transform);
            if (is_group) block_.close();
        }
    }

  private:
    bool have_same_transform(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t ta = scene_.shapes[a].transform, tb = scene_.shapes[b].transform;
        if (ta == tb || ta == k_none || tb == k_none) return ta == tb;
        return same_bits(scene_.transforms[ta], scene_.transforms[tb]);
    }

    void write_shape(std::uint32_t i, std::uint32_t transform) {
        const Shape& s = scene_.shapes[i];
        if (s.kind == ShapeKind::solid) return write_solid(i, transform);
        block_.begin(word_of(s.kind), scene_.shape_texts.name(i), word_width_);
        write_parameters(s);
        const ItemComments* const material_comments = write_material(s, true);
        if (scene_.shape_color(i)) append(block_.key("shape_color"), scene_.shape_colors[i]);
        if (transform != k_none) write_map(block_, scene_.transforms[transform]);
        write_comments(material_comments);
        comments_.end_block(block_, ItemKind::shape, i);
    }

    void write_parameters(const Shape& s) {
        switch (s.kind) {
#define GLINT_KIND(Type, word)                   \
    case ShapeKind::word:                        \
        write_keys(scene_.get<Type>()[s.index]); \
        break;
            GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
        }
    }

    // The keys of the material in the block, or its name. Returns its comments if they are to be here.
    const ItemComments* write_material(const Shape& s, bool is_part) {
        if (s.material == k_none) return nullptr;
        if (materials_.is_named(s.material)) {
            append_name(block_.key("material"), materials_.name(s.material));
            return nullptr;
        }
        if (glint::same_bits(scene_.materials[s.material], Material{})) return nullptr;
        if (is_part) block_.begin_part();
        write_material_keys(block_, materials_, scene_.materials[s.material]);
        return comments_.of(ItemKind::material, s.material);
    }
    void write_comments(const ItemComments* of) {
        if (of == nullptr) return;
        block_.comments(of->above);
        block_.comments(of->after);
    }

    // A block of its parts. Its keys are in lines before them.
    void write_solid(std::uint32_t i, std::uint32_t transform) {
        const Shape& s = scene_.shapes[i];
        const SolidTree& tree = scene_.solids[scene_.get<Solid>()[s.index].solid];
        std::string head(to_string(tree.steps.back().operation));
        // A solid of one shape.
        if (tree.steps.back().operation == SolidOperation::operand) head = to_string(SolidOperation::merge);
        if (!scene_.shape_texts.name(i).empty()) {
            head += ' ';
            append_name(head, scene_.shape_texts.name(i));
        }
        block_.open(head);
        const bool has_material =
            s.material != k_none &&
            (materials_.is_named(s.material) || !glint::same_bits(scene_.materials[s.material], Material{}));
        if (has_material || scene_.shape_color(i) || transform != k_none ||
            comments_.of(ItemKind::shape, i) != nullptr) {
            block_.begin({});
            const ItemComments* const material_comments = write_material(s, false);
            if (scene_.shape_color(i)) append(block_.key("shape_color"), scene_.shape_colors[i]);
            if (transform != k_none) write_map(block_, scene_.transforms[transform]);
            write_comments(material_comments);
            comments_.end_block(block_, ItemKind::shape, i);
        }
        const SolidSteps steps(tree);
        write_parts(tree, steps, steps.root());
        block_.close();
    }

    void write_parts(const SolidTree& tree, const SolidSteps& steps, std::size_t step) {
        if (steps.is_operand(step)) return write_operand(tree.operands[steps.operand(step)]);
        for (const std::size_t part : steps.parts(step)) {
            if (!steps.is_operand(part)) block_.open(to_string(steps.operation(part)));
            write_parts(tree, steps, part);
            if (!steps.is_operand(part)) block_.close();
        }
    }

    void write_operand(const Shape& s) {
        block_.begin(word_of(s.kind), std::string_view());
        write_parameters(s);
        write_material(s, true);
        if (s.transform != k_none) write_map(block_, scene_.transforms[s.transform]);
        block_.end();
    }

    // The kinds that consist only of the fields in fields().
    template <class T> void write_keys(const T& shape) { T::fields(shape, FieldWriter{block_}); }
    void write_keys(const Cylinder& c) {
        append(block_.key("from"), c.from);
        append(block_.key("to"), c.to);
        append(block_.key("radius"), c.radius);
        if (!c.caps) block_.key("caps") += "false";
    }
    void write_keys(const Cone& c) {
        append(block_.key("from"), c.from);
        append(block_.key("to"), c.to);
        fmt::format_to(std::back_inserter(block_.key("radius")), "({}, {})", c.from_radius, c.to_radius);
        if (!c.caps) block_.key("caps") += "false";
    }
    void write_keys(const Box& c) {
        append(block_.key("min"), c.min);
        append(block_.key("max"), c.max);
    }
    void write_keys(const Triangle& t) { write_points("vertices", t.vertices); }
    void write_keys(const SmoothTriangle& t) {
        write_points("vertices", t.vertices);
        write_points("normals", t.normals);
    }
    void write_keys(const Polygon& p) {
        write_points("vertices", std::span(scene_.polygon_vertices).subspan(p.first, p.count));
    }

    void write_keys(const Solid&) {}

    void write_keys(const Mesh& m) {
        if (m.mesh < mesh_files_.size() && !mesh_files_[m.mesh].empty()) {
            append_quoted(block_.key("file"), mesh_files_[m.mesh]);
            return;
        }
        const MeshData& mesh = *scene_.meshes[m.mesh];
        write_list("vertices", mesh.vertex_count(),
                   [&](std::size_t i) { return mesh.position(static_cast<std::uint32_t>(i)); });
        write_corners("triangles", mesh.triangles);
        write_values("normals", "normal_corners", mesh.normals);
        write_values("colors", "color_corners", mesh.colors);
        write_texture_coordinates(mesh.texture_coordinates);
    }
    void write_values(std::string_view key, std::string_view corners_key, const CornerValues& of) {
        if (of.empty()) return;
        write_list(key, of.values.size(), [&](std::size_t i) { return to_vec3(of.values[i]); });
        if (!of.corners.empty()) write_corners(corners_key, of.corners);
    }
    void write_texture_coordinates(const CornerValues& of) {
        if (of.empty()) return;
        std::string& text = begin_list("texture_coordinates");
        for (const Float3& f : of.values) {
            next_item(text);
            fmt::format_to(std::back_inserter(text), "({}, {})", double{f.x}, double{f.y});
        }
        text += ')';
        if (!of.corners.empty()) write_corners("texture_corners", of.corners);
    }
    void write_corners(std::string_view key, std::span<const TriangleCorners> corners) {
        std::string& text = begin_list(key);
        for (const TriangleCorners& triangle : corners) {
            next_item(text);
            const auto number = [](std::uint32_t n) {
                return n == CornerValues::k_none ? -1 : static_cast<std::int64_t>(n);
            };
            fmt::format_to(std::back_inserter(text), "({}, {}, {})", number(triangle[0]), number(triangle[1]),
                           number(triangle[2]));
        }
        text += ')';
    }

    void write_points(std::string_view key, std::span<const Vec3> points) {
        write_list(key, points.size(), [&](std::size_t i) { return points[i]; });
    }
    template <class Point> void write_list(std::string_view key, std::size_t count, const Point& point) {
        std::string& text = begin_list(key);
        for (std::size_t i = 0; i < count; ++i) {
            next_item(text);
            append(text, point(i));
        }
        text += ')';
    }
    std::string& begin_list(std::string_view key) {
        std::string& text = block_.key(key);
        text += '(';
        is_first_ = true;
        return text;
    }
    void next_item(std::string& text) {
        if (!is_first_) {
            text += ", ";
            block_.allow_break();
        }
        is_first_ = false;
    }

    BlockWriter& block_;
    const Scene& scene_;
    const MaterialPlan& materials_;
    const SceneComments& comments_;
    const std::span<const std::string> mesh_files_;
    std::size_t word_width_ = 0;
    bool is_first_ = true;  // the next item of the list
};

}  // namespace

void write_shapes(BlockWriter& block, const Scene& scene, const MaterialPlan& materials,
                  const SceneComments& comments, std::span<const std::string> mesh_files) {
    ShapeWriter(block, scene, materials, comments, mesh_files).run();
}

}  // namespace glint
