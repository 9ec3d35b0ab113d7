// SPDX-License-Identifier: Apache-2.0
#pragma once
// The values of POV-Ray's language: what an identifier can stand for.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/memory_budget.h"
#include "formats/povray/lexer.h"
#include "glint/scene.h"

namespace glint::povray {

/// A color without its filter and transmit.
inline Color rgb_of(const std::array<double, 5>& c) { return {c[0], c[1], c[2]}; }

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

/// The value with this number of terms: a single number fills them all, else zeros are added.
Numbers promoted(const Numbers& value, int terms);

/// A feature that is not rendered, and its place: reported if something that has it becomes part of the
/// scene.
struct Missing {
    std::string_view name;     ///< "normal"
    std::string_view meaning;  ///< "a bumpy normal"; may be empty
    Token at;
    bool is_error = false;  ///< without it the scene has no meaning
};

/// The features of one thing that are not rendered; of each name the first, and at most a few.
class MissingList {
  public:
    void add(const Missing& missing);
    bool empty() const { return list_.empty(); }
    bool has_error() const;
    auto begin() const { return list_.begin(); }
    auto end() const { return list_.end(); }

  private:
    CountedVector<Missing> list_;
};

struct ColorMapEntry {
    double at = 0;
    std::array<double, 5> color{};
};

/// The pattern `gradient`, which a sky can have: x = axis · p, axis of length 1, p the point in the pigment's
/// space.
struct GradientPattern {
    Vec3 axis{0, 1, 0};
    CountedVector<ColorMapEntry> map;
    std::optional<Affine> transform;  ///< of the pattern
};

struct Pigment {
    std::array<double, 5> color{0, 0, 0, 0, 0};
    std::optional<Missing> missing;  ///< a pattern that is not rendered
    std::shared_ptr<const GradientPattern> gradient;
    friend bool operator==(const Pigment& a, const Pigment& b) { return a.color == b.color; }
};

/// The defaults are POV-Ray's.
struct Opaque;

struct Finish {
    Color ambient{0.1, 0.1, 0.1}, emission{0, 0, 0};
    double diffuse = 0.6, brilliance = 1;
    double phong = 0, phong_size = 40, specular = 0, roughness = 0.05, metallic = 0;
    Color reflection_min{0, 0, 0}, reflection_max{0, 0, 0};
    double reflection_exponent = 1, reflection_falloff = 1, reflection_metallic = 0;
    bool reflection_fresnel = false, conserve_energy = false;
    double crand = 0, diffuse_back = 0;
    bool has_no_refraction = false;  ///< `refraction 0`
    /// `albedo`: the number before is of all the light that the surface sends back, not of its brightest
    /// place.
    bool diffuse_albedo = false, phong_albedo = false, specular_albedo = false;
    std::shared_ptr<const Opaque> interior{};  ///< of `ior` in a finish: an old place of it
    MissingList missing;

    /// diffuse, phong and specular as factors of the brightest place.
    double brightest_diffuse() const;
    double brightest_phong() const;
    double brightest_specular() const;
};

struct Texture {
    Pigment pigment;
    Finish finish;
    MissingList missing;      ///< a normal, a texture map, ...
    bool is_layered = false;  ///< below it are other textures
};

/// A block that has a meaning only where it is used, and is not rendered: normal, interior, color_map, ...
struct Opaque {
    Word word = Word::k_none;
    Token at;
    double ior = 1;       ///< of an interior
    MissingList missing;  ///< what else of an interior counts
};

enum class ObjectKind : std::uint8_t {
    sphere,
    cylinder,
    cone,
    box,
    plane,
    disc,
    triangle,
    smooth_triangle,
    mesh,
    polygon,
    group,
    light,
    refused
};

struct Mesh {
    struct Face {
        std::array<std::uint32_t, 3> vertices{}, normals{}, textures{};
        bool has_normals = false, has_texture = false, has_textures = false;  // one texture, or one a corner
    };
    CountedVector<Vec3> vertices, normals;
    CountedVector<Face> faces;
    CountedVector<std::shared_ptr<const Texture>> textures;
};

struct LightSource {
    Light light;  ///< position, color and kind; the direction of spots and parallel lights is point_at -
                  ///< position
    Vec3 point_at{0, 0, 1};
    bool is_parallel = false, is_area = false;
    MissingList missing;
};

/// What clipped_by cuts off a shape: nothing that is seen, or the scene has no meaning.
struct Clip {
    struct HalfSpace {
        Vec3 n;
        double d = 0;  ///< dot(n, p) <= d is kept
    };
    CountedVector<HalfSpace> halves;  ///< those that cut, in world space; empty: not known
    double reach = 0;                 ///< of the shape's points, the greatest distance from 0
    std::optional<Affine> map;        ///< Object::map where the clip was read
    Missing missing;
};

struct Object;
using ObjectPart = std::shared_ptr<const Object>;

/// An object: a shape, a group of objects, a light, or one that is not rendered. Parts are shared.
struct Object {
    ObjectKind kind = ObjectKind::group;
    Vec3 a, b, c;         ///< points; sphere: center; plane, disc: normal in b
    double r = 0, s = 0;  ///< radii; plane: the distance
    bool is_open = false, is_no_shadow = false, is_merge = false;
    Token at;
    std::optional<Affine> map;  ///< world_from_object
    std::shared_ptr<const Texture> texture;
    std::shared_ptr<const std::array<Vec3, 3>> normals;  ///< of a smooth triangle
    std::shared_ptr<const CountedVector<ObjectPart>> parts;
    std::shared_ptr<const Mesh> mesh;  ///< of a polygon: its vertices
    std::shared_ptr<const LightSource> light;
    std::shared_ptr<const Clip> clip;
    std::shared_ptr<const Opaque> interior;
    std::optional<bool> hollow;
    std::optional<Token> no_reflection;
    MissingList missing;      ///< what is not rendered of it
    std::uint64_t count = 1;  ///< of shapes in it
    int depth = 1;            ///< of groups
};

/// The width of the default camera's picture, whose height is 1: not 4/3 (POV-Ray, measured).
inline constexpr double k_default_right = 1.33;

/// Of a smooth triangle: POV-Ray leaves those out (measured).
bool has_normals_on_both_sides(const std::array<Vec3, 3>& vertices, const std::array<Vec3, 3>& normals);

struct CameraItems {
    bool is_orthographic = false, has_right = false, has_up = false, has_angle = false;
    std::optional<Vec3> look_at;
    Vec3 location{0, 0, 0}, direction{0, 0, 1}, up{0, 1, 0}, right{k_default_right, 0, 0}, sky{0, 1, 0};
    double angle = 0;
    std::optional<Affine> map;
    Token at;
    MissingList missing;
};

struct Array;

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

struct MaterialValue {
    std::shared_ptr<const Texture> texture;
    std::shared_ptr<const Opaque> interior;
    MissingList missing;
};

using Value = std::variant<
    std::monostate, Numbers, String, std::shared_ptr<Array>, std::shared_ptr<const Pigment>,
    std::shared_ptr<const Finish>, std::shared_ptr<const Texture>, std::shared_ptr<const MaterialValue>,
    std::shared_ptr<const Object>, std::shared_ptr<const CameraItems>, std::shared_ptr<const Affine>,
    std::shared_ptr<const Macro>, Reference, std::shared_ptr<const Opaque>, std::shared_ptr<const Function>>;

/// Elements in row order; unset ones are monostate. Copies share it until one of them is modified.
struct Array {
    CountedVector<std::uint32_t> sizes;
    CountedVector<Value> elements;
    int depth = 1;  ///< of arrays within each other
};

/// "a number", "a texture", ...
std::string_view describe(const Value& value);

}  // namespace glint::povray
