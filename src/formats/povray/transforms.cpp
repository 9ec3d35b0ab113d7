// SPDX-License-Identifier: Apache-2.0
// Transforms: translate, rotate, scale, matrix, transform.
#include "formats/povray/texture_parser.h"
#include "math/transform.h"

namespace glint::povray {

// translate, rotate, scale, matrix, transform: false if none of them is next.
bool TextureParser::read_transform_item(std::optional<Affine>& map, std::optional<Affine>* also,
                                        Affine* found) {
    const Token at = peek();
    Affine step;
    switch (at.word()) {
        case Word::k_translate:
            take();
            step = translation(vector());
            break;
        case Word::k_rotate: {
            take();
            const Vec3 by = vector();
            step = compose(rotation_z(by.z), compose(rotation_y(by.y), rotation_x(by.x)));
            break;
        }
        case Word::k_scale: {
            take();
            Vec3 by = vector();
            if (by.x == 0 || by.y == 0 || by.z == 0) {
                warn_once("scale", at, "a scale by 0 counts as 1, as in POV-Ray");
                by = {by.x == 0 ? 1 : by.x, by.y == 0 ? 1 : by.y, by.z == 0 ? 1 : by.z};
            }
            step = scaling(by);
            break;
        }
        case Word::k_matrix:
            take();
            step = read_matrix();
            break;
        case Word::k_transform:
            take();
            step = read_transform_block();
            break;
        default:
            return false;
    }
    if (found != nullptr) *found = step;
    if (step == Affine()) return true;
    map = map ? compose(step, *map) : step;
    if (also != nullptr) *also = *also ? compose(step, **also) : step;
    for (const auto& row : map->m) {
        for (const double x : row) {
            if (!(x <= 1e150 && x >= -1e150) && !failed()) {
                error(at, "the transform's numbers are above 1e150");
            }
        }
    }
    return true;
}

// < 12 numbers >: the rows of p' = p M, and then the translation.
Affine TextureParser::read_matrix() {
    Affine map;
    if (!expect('<')) return map;
    for (int i = 0; i < 12 && !failed(); ++i) {
        map.m[i % 3][i / 3] = number();
        accept(',');
    }
    expect('>');
    return map;
}

// { transforms }, or an identifier, after `transform`.
Affine TextureParser::read_transform_block() {
    std::optional<Affine> map;
    const auto read_identifier = [&] {
        const Token name = peek();
        const Value* value = find_value(name);
        const auto* held = value ? std::get_if<std::shared_ptr<const Affine>>(value) : nullptr;
        if (held == nullptr) return false;
        map = map ? compose(**held, *map) : **held;
        take();
        return true;
    };
    if (!peek().is('{')) {
        if (!read_identifier()) expected("`{` or a transform");
        return map.value_or(Affine());
    }
    take();
    bool is_inverse = false;
    while (!failed() && !accept('}')) {
        if (accept(Word::k_inverse)) {
            is_inverse = true;
        } else if (!read_transform_item(map) && !read_identifier()) {
            expected("`translate`, `rotate`, `scale`, `matrix` or `}`");
        }
    }
    if (is_inverse && map) {
        const auto turned = inverse(*map);
        if (!turned) error(peek(), "the transform has no inverse");
        map = turned;
    }
    return map.value_or(Affine());
}

}  // namespace glint::povray
