// SPDX-License-Identifier: Apache-2.0
// Shapes: spheres, boxes, cylinders ...
#include <fmt/format.h>

#include <vector>

#include "formats/povray/object_parser.h"

namespace glint::povray {

Object ObjectParser::read_shape(const Token& word) {
    Object object;
    object.at = word;
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    const auto next = [&] { return accept(','); };
    switch (word.word()) {
        case Word::k_sphere:
            object.kind = ObjectKind::sphere;
            object.a = vector();
            next();
            object.r = number();
            break;
        case Word::k_cylinder:
        case Word::k_cone:
            object.kind = word.word() == Word::k_cone ? ObjectKind::cone : ObjectKind::cylinder;
            object.a = vector();
            next();
            if (word.word() == Word::k_cone) {
                object.r = number();
                next();
            }
            object.b = vector();
            next();
            (word.word() == Word::k_cone ? object.s : object.r) = number();
            object.is_open = accept(Word::k_open);
            break;
        case Word::k_box:
            object.kind = ObjectKind::box;
            object.a = vector();
            next();
            object.b = vector();
            break;
        case Word::k_plane:
            object.kind = ObjectKind::plane;
            object.b = vector();
            next();
            object.s = number();
            break;
        case Word::k_disc:
            object.kind = ObjectKind::disc;
            object.a = vector();
            next();
            object.b = vector();
            next();
            object.r = number();
            if (next()) object.s = number();
            break;
        case Word::k_torus:
            object.kind = ObjectKind::torus;
            object.r = number();
            next();
            object.s = number();
            break;
        case Word::k_quadric:
            object.kind = ObjectKind::quadric;
            object.a = vector();
            next();
            object.b = vector();
            next();
            object.c = vector();
            next();
            object.s = number();
            break;
        case Word::k_cubic:
        case Word::k_poly:
        case Word::k_quartic:
            read_quartic(object);
            break;
        case Word::k_triangle:
            object.kind = ObjectKind::triangle;
            object.a = vector();
            next();
            object.b = vector();
            next();
            object.c = vector();
            break;
        default: {
            object.kind = ObjectKind::smooth_triangle;
            std::array<Vec3, 3> normals;
            object.a = vector();
            next();
            normals[0] = vector();
            next();
            object.b = vector();
            next();
            normals[1] = vector();
            next();
            object.c = vector();
            next();
            normals[2] = vector();
            object.normals = make_counted<const std::array<Vec3, 3>>(normals);
        }
    }
    check_shape(object);
    read_modifiers(object);
    return object;
}

// The coefficients of a cubic, quartic or poly are in the order of Quartic's, without those of higher
// degrees.
void ObjectParser::read_quartic(Object& object) {
    object.kind = ObjectKind::quartic;
    int order = object.at.word() == Word::k_cubic ? 3 : 4;
    if (object.at.word() == Word::k_poly) {
        const Token at = peek();
        const double number = this->number();
        if (failed()) return;
        if (!(number >= 2 && number < 36))
            return error(at, fmt::format("expected an order from 2 to 35, found {}", number));
        order = static_cast<int>(number);
        accept(',');
    }
    if (!expect('<')) return;
    std::vector<double> read;
    for (int left = (order + 1) * (order + 2) * (order + 3) / 6; !failed() && left > 0; --left) {
        read.push_back(number());
        if (left > 1) accept(',');
    }
    if (failed() || !expect('>')) return;
    if (order > 4) return object.missing.add({"poly", "of an order above 4", call_place(object.at), true});
    auto quartic = make_counted<Quartic>();
    double* to = quartic->coefficients;
    std::size_t used = 0;
    bool is_empty = true;
    for (int i = 0; i <= 4; ++i) {
        for (int j = 0; j <= i; ++j) {
            for (int k = 0; k <= j; ++k, ++to) {  // x^(4 - i) y^(i - j) z^(j - k)
                if (4 - k > order) continue;
                *to = read[used++];
                is_empty = is_empty && (k == 4 || *to == 0);
            }
        }
    }
    if (is_empty)
        object.missing.add(
            {to_string(object.at.word()), "without a coefficient", call_place(object.at), true});
    object.quartic = std::move(quartic);
}

// What POV-Ray refuses, and what glint has no shape for.
void ObjectParser::check_shape(Object& object) {
    if (failed()) return;
    const bool has_axis = object.kind == ObjectKind::cylinder || object.kind == ObjectKind::cone;
    if (has_axis && object.a == object.b) {
        error(object.at, fmt::format("expected two ends at different points of a {}", text_of(object.at)));
    }
    if (object.kind == ObjectKind::plane || object.kind == ObjectKind::disc) {
        if (object.b == Vec3{0, 0, 0}) error(object.at, "expected a normal other than 0");
    }
    // POV-Ray draws parts of it, or noise (measured).
    if (object.kind == ObjectKind::torus && (!(object.r > 0) || object.s < 0)) {
        object.missing.add({"torus", "with a radius that is not above 0", call_place(object.at), true});
    }
    if (object.kind == ObjectKind::quadric && object.a == Vec3{} && object.b == Vec3{} && object.c == Vec3{})
        object.missing.add({"quadric", "without a coefficient", call_place(object.at), true});
    if (object.r < 0) object.r = -object.r;
    if (object.s < 0 && (object.kind == ObjectKind::cone || object.kind == ObjectKind::disc))
        object.s = -object.s;
}

}  // namespace glint::povray
