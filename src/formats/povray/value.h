// SPDX-License-Identifier: Apache-2.0
#pragma once
// The values of POV-Ray's language: what an identifier can stand for.
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "base/memory_budget.h"
#include "formats/povray/lexer.h"
#include "glint/scene.h"

namespace glint::povray {

/// A string; copies share it.
using String = std::shared_ptr<const CountedString>;

/// A number (1 term), a vector (2 to 4), or a color (5: red, green, blue, filter, transmit).
struct Numbers {
    std::array<double, 5> v{};
    int terms = 1;

    Numbers() = default;
    Numbers(double x) : v{x} {}  // NOLINT: a number is a value of the language
    explicit Numbers(Vec3 p) : v{p.x, p.y, p.z}, terms(3) {}
    bool is_color() const { return terms == 5; }
};

/// Whether a number counts as false.
inline bool is_false(double x) { return x <= 1e-10 && x >= -1e-10; }

/// The value with this number of terms: a single number fills them all, else zeros are added.
Numbers promoted(const Numbers& value, int terms);

/// A macro: its parameters and its body, as tokens.
struct Macro {
    CountedVector<std::uint32_t> parameters;
    std::uint16_t text = 0;
    std::uint32_t begin = 0, end = 0;
};

/// A parameter that was given an identifier: stands for it, in the scopes up to `depth`.
struct Reference {
    std::uint32_t name = 0;
    std::uint32_t depth = 0;
};

/// A function of numbers: its expression in round brackets, as tokens, and one that ends it.
struct Function {
    CountedVector<std::uint32_t> parameters;
    CountedVector<Token> body;
    std::string problem;  ///< what glint does not evaluate; else empty
};

/// A spline: its values by t, which rises.
struct ValueSpline {
    struct Point {
        double t = 0;
        Numbers value;  ///< of `terms`
    };
    std::size_t kind = 0;  ///< linear, quadratic, cubic, natural
    int terms = 1;
    CountedVector<Point> points;  ///< at least one
};

struct Array;
// texture.h
struct Pigment;
struct Finish;
struct Texture;
struct MaterialValue;
struct Opaque;
// object.h
struct Object;
struct CameraItems;

using Value =
    std::variant<std::monostate, Numbers, String, std::shared_ptr<Array>, std::shared_ptr<const Pigment>,
                 std::shared_ptr<const Finish>, std::shared_ptr<const Texture>,
                 std::shared_ptr<const MaterialValue>, std::shared_ptr<const Object>,
                 std::shared_ptr<const CameraItems>, std::shared_ptr<const Affine>,
                 std::shared_ptr<const Macro>, Reference, std::shared_ptr<const Opaque>,
                 std::shared_ptr<const Function>, std::shared_ptr<const ValueSpline>>;

/// Elements in row order; unset ones are monostate. Copies share it until one of them is modified.
struct Array {
    CountedVector<std::uint32_t> sizes;
    CountedVector<Value> elements;
    int depth = 1;  ///< of arrays within each other
};

/// "a number", "a texture", ...
std::string_view describe(const Value& value);

}  // namespace glint::povray
