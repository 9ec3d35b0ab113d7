// SPDX-License-Identifier: Apache-2.0
// The shapes of .glint: one block per shape.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "formats/glint_blocks.h"
#include "formats/glint_item.h"
#include "formats/glint_mesh.h"

namespace glint {
namespace {

// The keys of all kinds of shapes: those that groups have, too, and the last one.
constexpr auto k_shape_fields = [] {
    std::array<Field, std::size(k_item_fields) + 1> all{};
    std::copy(std::begin(k_item_fields), std::end(k_item_fields), all.begin());
    all.back() = {"shape_color"};
    return all;
}();

// The keys of one kind of shape, and those of all kinds.
template <std::size_t N> constexpr auto with_shape_fields(const Field (&own)[N]) {
    std::array<Field, N + std::size(k_shape_fields)> all{};
    std::copy(std::begin(own), std::end(own), all.begin());
    std::copy(std::begin(k_shape_fields), std::end(k_shape_fields), all.begin() + N);
    return all;
}

constexpr auto k_axial_fields = with_shape_fields({{"from", true}, {"to", true}, {"radius", true}, {"caps"}});
constexpr auto k_box_fields = with_shape_fields({{"min", true}, {"max", true}});
constexpr auto k_triangle_fields = with_shape_fields({{"vertices", true}, {"normals"}});
constexpr auto k_polygon_fields = with_shape_fields({{"vertices", true}});
constexpr auto k_mesh_fields = with_shape_fields({{"file"},
                                                  {"vertices"},
                                                  {"triangles"},
                                                  {"normals"},
                                                  {"normal_corners"},
                                                  {"colors"},
                                                  {"color_corners"},
                                                  {"texture_coordinates"},
                                                  {"texture_corners"}});

// The spelling hints for a shape and its material.
template <std::size_t N> std::span<const SpellingHint> with_material_hints(const SpellingHint (&own)[N]) {
    static const std::vector<SpellingHint> all = [&own] {
        std::vector<SpellingHint> list(std::begin(own), std::end(own));
        list.insert(list.end(), material_hints().begin(), material_hints().end());
        return list;
    }();
    return all;
}

class ShapeReader {
  public:
    ShapeReader(GlintText& t, const Token& word, GlintContext& context)
        : t_(t), word_(word), context_(context) {}

    template <class Shape> static std::span<const Field> listed_fields() {
        static const std::vector<Field> fields = [] {
            std::vector<Field> all;
            Shape shape;
            Shape::fields(shape, FieldNames{all});
            for (const Field& field : k_shape_fields) all.push_back(field);
            return all;
        }();
        return fields;
    }

    /// A kind that consists only of the fields in fields().
    template <class Shape> void listed() {
        Shape shape;
        if (keys(listed_fields<Shape>(), [&](int field, const Token&) {
                FieldValue value{*this, field};
                Shape::fields(shape, value);
                return value.is_read;
            }))
            add(shape);
    }

    void cylinder() {
        Cylinder s;
        axial(s, [&] { return length(s.radius); });
    }

    void cone() {
        Cone s;
        axial(s, [&] { return cone_radius(s); });
    }

    void box() {
        Box s;
        if (keys(k_box_fields,
                 [&](int field, const Token&) { return read_point(t_, field == 0 ? s.min : s.max); }))
            add(s);
    }

    void triangle() {
        SmoothTriangle s;
        bool is_smooth = false;
        if (!keys(k_triangle_fields, [&](int field, const Token&) {
                is_smooth = is_smooth || field == 1;
                return three(field == 0 ? s.vertices : s.normals, field == 1);
            }))
            return;
        if (is_smooth) {
            add(s);
        } else {
            add(Triangle{{s.vertices[0], s.vertices[1], s.vertices[2]}});
        }
    }

    void polygon() {
        auto& all = t_.scene.polygon_vertices;
        const auto first = static_cast<std::uint32_t>(all.size());
        Polygon s{first, 0};
        if (!keys(k_polygon_fields, [&](int, const Token& key) {
                all.resize(first);  // the last list contains
                s.count = 0;
                return vertices(key, s);
            }))
            return;
        add(s);
    }

    // Of a file, or of the lists in the block.
    void mesh() {
        MeshText text(t_);
        if (!keys(k_mesh_fields, [&](int field, const Token& key) { return text.read_key(field, key); }))
            return;
        if (const auto index = text.mesh_index(word_)) add(Mesh{*index});
    }

    // Visitors for fields() of a kind: for the names of the fields, ...
    struct FieldNames {
        std::vector<Field>& names;
        void point(std::string_view name, const Vec3&) { names.push_back({name, true}); }
        void direction(std::string_view name, const Vec3&) { names.push_back({name, true}); }
        void length(std::string_view name, double) { names.push_back({name, true}); }
        void radius(std::string_view name, double) { names.push_back({name}); }
        void coefficients(std::string_view name, const Vec3&) { names.push_back({name}); }
        void coefficient(std::string_view name, double) { names.push_back({name}); }
    };
    // ... and for the value of field number `field`.
    struct FieldValue {
        ShapeReader& reader;
        int field;
        bool is_read = false;
        void point(std::string_view, Vec3& p) {
            if (field-- == 0) is_read = read_point(reader.t_, p);
        }
        void direction(std::string_view, Vec3& d) {
            if (field-- == 0) is_read = read_direction(reader.t_, d);
        }
        void length(std::string_view, double& x) {
            if (field-- == 0) is_read = reader.length(x);
        }
        void radius(std::string_view, double& x) {
            if (field-- == 0) is_read = reader.t_.p.number(x, k_not_negative);
        }
        void coefficients(std::string_view, Vec3& v) {
            if (field-- == 0) is_read = read_point(reader.t_, v);
        }
        void coefficient(std::string_view, double& x) {
            if (field-- == 0) is_read = reader.t_.p.number(x, k_coordinate);
        }
    };

  private:
    using ReadOwn = std::function<bool(int, const Token&)>;

    // Reads the block. False if there is no shape to add.
    bool keys(std::span<const Field> fields, const ReadOwn& read_own) {
        const int own = static_cast<int>(fields.size() - std::size(k_shape_fields));
        name_ = block_name(t_);
        FieldSet set(t_.p.text(word_), fields, hints());
        const bool whole = t_.blocks.fields(set, word_, [&](int field, const Token& key) {
            if (field < own) return read_own(field, key);
            if (field - own < static_cast<int>(std::size(k_item_fields)))
                return read_item_key(t_, field - own, key, item_);
            return read_color(t_, color_.emplace(), k_channel, ColorUse::surface);
        });
        return whole && t_.p.check_required(set, word_);
    }

    // Reads a solid between the two ends of an axis.
    template <class Shape, class ReadRadius> void axial(Shape& s, ReadRadius&& read_radius) {
        s.caps = true;
        if (keys(k_axial_fields, [&](int field, const Token&) {
                switch (field) {
                    case 0:
                        return read_point(t_, s.from);
                    case 1:
                        return read_point(t_, s.to);
                    case 2:
                        return read_radius();
                    default:
                        return read_bool(t_, s.caps);
                }
            }))
            add(s);
    }

    static std::span<const SpellingHint> hints() {
        static constexpr SpellingHint own[] = {
            {"centre", "`center`"},
            {"position", "`center`, or `translate`"},
            {"location", "`center`"},
            {"diameter", "`radius`"},
            {"r", "`radius`"},
            {"r1", "`radius = (from, to)`"},
            {"major_radius", "`radius`"},
            {"minor_radius", "`tube`"},
            {"inner_radius", "`hole`"},
            {"outer_radius", "`radius`"},
            {"base", "`from`"},
            {"apex", "`to`"},
            {"top", "`to`"},
            {"axis", "`from` and `to`"},
            {"height", "`from` and `to`"},
            {"size", "`min` and `max`"},
            {"corner", "`min` and `max`"},
            {"points", "`vertices`"},
            {"vertex", "`vertices`"},
            {"distance", "`point` and `normal`"},
            {"rotation", "`rotate`, in degrees"},
            {"transform", "`matrix`, or `translate`, `rotate` and `scale`"},
            {"capped", "`caps = true`"},
            {"open", "`caps = false`"},
        };
        return with_material_hints(own);
    }

    template <class Shape> void add(const Shape& shape) {
        const auto [material, transform] = find_look();
        finish(t_.scene.add(shape, material, transform));
    }
    std::pair<std::uint32_t, std::uint32_t> find_look() {
        auto& scene = t_.scene;
        std::uint32_t transform = k_none;
        if (const auto map = compose_maps(std::nullopt, item_.map)) {
            GlintContext own{k_none, k_none, compose_maps(context_.map, map)};
            transform = transform_index(scene, own);
        } else {
            transform = transform_index(scene, context_);
        }
        const std::uint32_t base = item_.material != k_none ? item_.material : context_.material;
        return {t_.materials.changed(t_, word_, base, item_.keys, true), transform};
    }
    void finish(std::uint32_t index) {
        t_.scene.set_shape_color(index, color_);
        note(t_.scene.shape_texts, index, source_place(t_.text, word_), std::move(name_));
    }

    bool length(double& value) {
        if (t_.p.token().is('(')) {
            t_.p.expected("a number: only a cone has two radii");
            return false;
        }
        return t_.p.number(value, k_length);
    }

    // A single number: a cone with an apex.
    bool cone_radius(Cone& cone) {
        cone.to_radius = 0;
        if (!t_.p.token().is('(')) return t_.p.number(cone.from_radius, k_not_negative);
        double radii[2] = {};
        if (!t_.p.numbers(radii, k_not_negative, '(', ')')) return false;
        cone.from_radius = radii[0];
        cone.to_radius = radii[1];
        return true;
    }

    bool three(Vec3 (&points)[3], bool are_normals) {
        const Token at = t_.p.token();
        const auto errors = t_.reading.diagnostics.error_count();
        int n = 0;
        const bool is_list = read_list(t_, "three of `(x, y, z)`", [&] {
            if (n == 3) {
                t_.p.expected("`)` after the third of a triangle");
                return false;
            }
            Vec3& p = points[n++];
            return are_normals ? read_direction(t_, p) : read_point(t_, p);
        });
        if (is_list && n < 3 && errors == t_.reading.diagnostics.error_count()) {
            t_.p.error(at, fmt::format("expected three of `(x, y, z)`, found {}", n));
        }
        return is_list;
    }

    bool vertices(const Token& key, Polygon& polygon) {
        auto& all = t_.scene.polygon_vertices;
        const auto errors = t_.reading.diagnostics.error_count();
        std::size_t n = 0;
        const bool is_list = read_list(t_, "at least three of `(x, y, z)`", [&] {
            Vec3 p;
            if (!read_point(t_, p)) return false;
            if (++n <= k_max_polygon_vertices) all.push_back(p);
            return true;
        });
        polygon.count = static_cast<std::uint32_t>(all.size() - polygon.first);
        if (is_list && errors == t_.reading.diagnostics.error_count()) {
            if (n < 3) t_.p.error(key, fmt::format("expected at least 3 vertices, found {}", n));
            if (n > k_max_polygon_vertices) {
                t_.p.error(key,
                           fmt::format("expected at most {} vertices, found {}: cut it into smaller polygons",
                                       k_max_polygon_vertices, n));
            }
        }
        return is_list;
    }

    GlintText& t_;
    const Token word_;
    GlintContext& context_;
    GlintItem item_;
    std::optional<Color> color_;
    std::string name_;
};

struct ShapeWord {
    std::string_view word;
    void (ShapeReader::*read)();
    std::span<const Field> fields;
};

template <class Shape>
concept Listed = requires(Shape shape, ShapeReader::FieldNames names) {
    Shape::fields(shape, names);
};

// Reads the shapes of a kind that consists only of the fields in fields().
template <class Shape> constexpr void (ShapeReader::*listed_reader())() {
    if constexpr (Listed<Shape>) {
        return &ShapeReader::listed<Shape>;
    } else {
        return nullptr;
    }
}

template <class Shape> std::span<const Field> listed_fields() {
    if constexpr (Listed<Shape>) {
        return ShapeReader::listed_fields<Shape>();
    } else {
        return {};
    }
}

std::span<const ShapeWord> shape_words() {
    static const ShapeWord words[] = {
#define GLINT_KIND(Type, word) {#word, listed_reader<Type>(), listed_fields<Type>()},
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
            {"cylinder", &ShapeReader::cylinder, k_axial_fields},
        {"cone", &ShapeReader::cone, k_axial_fields},
        {"box", &ShapeReader::box, k_box_fields},
        {"triangle", &ShapeReader::triangle, k_triangle_fields},
        {"polygon", &ShapeReader::polygon, k_polygon_fields},
        {"mesh", &ShapeReader::mesh, k_mesh_fields}};
    return words;
}

const ShapeWord* find_shape(std::string_view word) {
    for (const ShapeWord& shape : shape_words()) {
        if (shape.word == word && shape.read != nullptr) return &shape;
    }
    return nullptr;
}

}  // namespace

bool is_shape_word(std::string_view word) { return find_shape(word) != nullptr; }

void add_shape_blocks(std::vector<GlintBlock>& blocks) {
    for (const ShapeWord& shape : shape_words()) {
        if (shape.read != nullptr) blocks.push_back({shape.word, key_names(shape.fields)});
    }
}

void read_glint_shape(GlintText& t, const Token& word, GlintContext& context) {
    ShapeReader reader(t, word, context);
    (reader.*find_shape(t.p.text(word))->read)();
}

}  // namespace glint
