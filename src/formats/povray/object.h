// SPDX-License-Identifier: Apache-2.0
#pragma once
// Objects and cameras as the text has them.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "formats/povray/texture.h"
#include "glint/mesh.h"
#include "glint/solid.h"
#include "scene/ranges.h"

namespace glint::povray {

enum class ObjectKind : std::uint8_t {
    sphere,
    cylinder,
    cone,
    box,
    plane,
    disc,
    torus,
    quadric,
    quartic,
    triangle,
    smooth_triangle,
    mesh,
    polygon,
    height_field,
    group,
    solid,
    light,
    refused
};

/// A mesh as its text has it, in single precision, as in POV-Ray.
struct ReadMesh {
    CountedVector<Float3> vertices;
    CountedVector<Float3> normals;  ///< unit vectors
    CountedVector<TriangleCorners> triangles;
    /// By triangle, or empty: no triangle has any. A triangle's normals are all set or all
    /// CornerValues::k_none, and so are its textures: one at each corner.
    CountedVector<TriangleCorners> normal_corners, texture_corners;
    CountedVector<Float3> uv;                   ///< `uv_vectors`; z is 0
    CountedVector<TriangleCorners> uv_corners;  ///< likewise
    CountedVector<std::shared_ptr<const Texture>> textures;
    bool has_inside = false;  ///< a ray that begins in it is inside: by `inside_vector`
    /// What closed_mesh() has found.
    struct Closed {
        bool is_known = false, is_closed = false, is_outward = false;
        std::shared_ptr<const ReadMesh> changed;  ///< if the mesh is not closed or not turned outwards
    };
    mutable Closed closed{};
    /// The first vertex beyond what glint renders, as the text has it, and its number.
    std::optional<std::pair<std::size_t, Vec3>> far;

    /// Within what glint renders.
    static Float3 stored_uv(Vec3 uv) {
        const auto within = [](double x) { return x >= -1e12 && x <= 1e12 ? x : 0; };
        return to_single({within(uv.x), within(uv.y), 0});
    }
    void note_if_far(std::size_t vertex, Vec3 position) {
        if (!far && !is_coordinate(position)) far.emplace(vertex, position);
    }
    static Float3 stored_position(Vec3 v) {
        constexpr double most = std::numeric_limits<float>::max();
        return to_single(
            {std::clamp(v.x, -most, most), std::clamp(v.y, -most, most), std::clamp(v.z, -most, most)});
    }
    /// Returns the vertex's number.
    std::uint32_t add_vertex(Vec3 position) {
        note_if_far(vertices.size(), position);
        vertices.push_back(stored_position(position));
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }
    /// The values of all triangles can be set afterwards.
    static void set(CountedVector<TriangleCorners>& list, std::size_t triangle,
                    const TriangleCorners& corners) {
        if (list.size() <= triangle)
            list.resize(triangle + 1, {CornerValues::k_none, CornerValues::k_none, CornerValues::k_none});
        list[triangle] = corners;
    }
    static bool has(const CountedVector<TriangleCorners>& list, std::size_t triangle) {
        return triangle < list.size() && list[triangle][0] != CornerValues::k_none;
    }
};

struct HeightField;  // field_mesh.h
struct LatheLines;   // solid_lathe.h

struct LightSource {
    Light light;  ///< position, color and kind; the direction of spots and parallel lights is point_at -
                  ///< position
    Vec3 point_at{0, 0, 1};
    bool is_parallel = false, is_area = false;
    std::optional<Token> media_attenuation{};  ///< fog takes away of its light
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

/// An object of clipped_by. The transforms that follow it apply to both.
struct ClipObject {
    ObjectPart object;
    std::optional<Affine> map;  ///< Object::map where it was read
};

/// An object: a shape, a group of objects or a solid, a light, or one that is not rendered. Parts are shared.
struct Object {
    ObjectKind kind = ObjectKind::group;
    SolidOperation operation = SolidOperation::unite;  ///< of a solid
    Vec3 a, b, c;  ///< points; sphere: center; plane, disc: normal in b; quadric: coefficients
    double r = 0,
           s = 0;  ///< radii; plane: the distance; disc: that of the hole in s; quadric: the constant in s
    bool is_open = false, is_no_shadow = false, is_merge = false, is_inverse = false, is_uv = false,
         is_cutaway = false, is_bounded = false, leaves_bounds = false;
    bool is_curve = false;            ///< a sphere_sweep with a curved spline
    bool is_moved_by_matrix = false;  ///< by `matrix` or `transform`
    Token at;
    /// The word of a shape that this mesh or these parts stand for, as "prism"; else empty.
    std::string_view stands_for;
    std::optional<Affine> map;    ///< world_from_object
    CountedVector<Affine> steps;  ///< of groups, solids and meshes: the transforms of `map` one by one
    std::shared_ptr<const Texture> texture;
    std::optional<Affine> texture_map;                   ///< of the texture's images: the transforms after it
    std::shared_ptr<const std::array<Vec3, 3>> normals;  ///< of a smooth triangle
    std::shared_ptr<const Quartic> quartic;
    std::shared_ptr<const CountedVector<ObjectPart>> parts;
    std::shared_ptr<const ReadMesh> mesh;
    std::shared_ptr<const CountedVector<Vec3>> outline;  ///< of a polygon
    std::shared_ptr<const HeightField> field;
    std::shared_ptr<const LatheLines> lathe;
    std::shared_ptr<const LightSource> light;
    std::shared_ptr<const Clip> clip;
    CountedVector<ClipObject> clips;  ///< all that cut
    std::shared_ptr<const Opaque> interior;
    std::optional<bool> hollow;
    std::optional<Token> no_reflection;
    MissingList missing;      ///< what is not rendered of it
    std::uint64_t count = 1;  ///< of shapes in it
    int depth = 1;            ///< of groups
};

/// Whether an object can be an operand of a solid: all shapes in it have an inside that glint knows.
bool encloses_space(const Object& object);
/// Adds what is an error of an object and its parts as operands of a solid. stands_for: of the object that it
/// is a part of.
void add_operand_errors(const Object& object, MissingList& missing, std::string_view stands_for = {});

/// The width of the default camera's picture, whose height is 1: not 4/3 (POV-Ray, measured).
inline constexpr double k_default_right = 1.33;

/// The factor of a map that keeps all angles, or 0.
double similarity(const Affine& map);
/// Whether a map only scales and moves along the axes.
bool is_diagonal(const Affine& map);

/// Of a smooth triangle outside of a mesh: POV-Ray leaves those out (measured).
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

}  // namespace glint::povray
