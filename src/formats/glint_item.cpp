// SPDX-License-Identifier: Apache-2.0
#include "formats/glint_item.h"

#include "math/transform.h"

namespace glint {
namespace {

constexpr int k_first_transform = 1 + static_cast<int>(k_material_keys.size());
enum { k_translate, k_rotate, k_scale, k_matrix };
static_assert(std::size(k_transform_fields) == k_matrix + 1);

bool read_scale(GlintText& t, const Token& key, Vec3& scale) {
    if (t.p.token().kind == TokenKind::number) {
        if (!t.p.number(scale.x, k_coordinate)) return false;
        scale.y = scale.z = scale.x;
    } else if (!t.p.token().is('(')) {
        t.p.expected("a number or `(x, y, z)`");
        return false;
    } else if (!read_point(t, scale)) {
        return false;
    }
    if (scale.x == 0 || scale.y == 0 || scale.z == 0) {
        t.p.error(key, "expected a scale without 0, which would leave nothing of the shape");
    }
    return true;
}

bool read_matrix(GlintText& t, Affine& map) {
    int row = 0;
    const Token at = t.p.token();
    const auto errors = t.reading.diagnostics.error_count();
    const bool is_list = read_list(t, "three rows `(a, b, c, t)`", [&] {
        if (row == 3) {
            t.p.expected("`)` after three rows");
            return false;
        }
        return t.p.numbers(map.m[row++], k_coordinate, '(', ')');
    });
    if (is_list && row < 3 && errors == t.reading.diagnostics.error_count()) {
        t.p.error(at, fmt::format("expected three rows `(a, b, c, t)`, found {}", row));
    }
    return is_list;
}

}  // namespace

bool read_item_key(GlintText& t, int field, const Token& key, GlintItem& item) {
    if (field == 0) {
        Token name;
        if (!read_name(t, "the name of a material", name)) return false;
        item.material = t.materials.named(t, name);
        return true;
    }
    if (field < k_first_transform) return read_material_key(t, field - 1, item.keys);
    return read_transform_key(t, field - k_first_transform, key, item);
}

bool read_transform_key(GlintText& t, int field, const Token& key, GlintItem& item) {
    Affine step;
    Vec3 v;
    switch (field) {
        case k_translate:
            if (!read_point(t, v)) return false;
            step = translation(v);
            break;
        case k_rotate:
            if (!read_point(t, v)) return false;
            step = compose(rotation_z(v.z), compose(rotation_y(v.y), rotation_x(v.x)));
            break;
        case k_scale:
            if (!read_scale(t, key, v)) return false;
            step = scaling(v);
            break;
        default:
            if (!read_matrix(t, step)) return false;
    }
    item.map = compose_maps(step, item.map);
    return true;
}

// A single map keeps its numbers: composition with the identity may turn -0 into 0.
std::optional<Affine> compose_maps(const std::optional<Affine>& outer, const std::optional<Affine>& inner) {
    if (!outer || (inner && *outer == Affine{})) return inner;
    if (!inner || *inner == Affine{}) return outer;
    return compose(*outer, *inner);
}

std::uint32_t transform_index(Scene& scene, GlintContext& context) {
    if (context.map && context.transform == k_none) {
        context.transform = static_cast<std::uint32_t>(scene.transforms.size());
        scene.transforms.push_back(*context.map);
    }
    return context.transform;
}

}  // namespace glint
