// SPDX-License-Identifier: Apache-2.0
// The sides of a closed mesh, by the number of faces that a ray from a face meets: even on the outer side.
// The edges of faces need not be shared, as those of a prism's caps.
#include "formats/povray/outward_faces.h"

#include "math/number.h"

namespace glint::povray {
namespace {

struct Face {
    Vec3 a, ab, ac, normal;
};

// Not along an axis or a normal, where a line meets the edges of faces in regular meshes.
constexpr Vec3 k_askew{0.0137, -0.0171, 0.0113};

Face face_of(const ReadMesh& mesh, const TriangleCorners& corners) {
    const Vec3 a = to_vec3(mesh.vertices[corners[0]]), ab = to_vec3(mesh.vertices[corners[1]]) - a,
               ac = to_vec3(mesh.vertices[corners[2]]) - a;
    return {a, ab, ac, cross(ab, ac)};
}

// Whether the line origin + t direction meets the face, at t > 0.
bool meets(const Face& face, Vec3 origin, Vec3 direction) {
    const Vec3 p = cross(direction, face.ac), from_a = origin - face.a;
    const double determinant = dot(face.ab, p);
    if (determinant == 0) return false;
    const Vec3 q = cross(from_a, face.ab);
    const double u = dot(from_a, p) / determinant, v = dot(direction, q) / determinant,
                 t = dot(face.ac, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0;
}

CountedVector<Face> faces_of(const ReadMesh& mesh) {
    CountedVector<Face> faces;
    faces.reserve(mesh.triangles.size());
    for (const TriangleCorners& t : mesh.triangles) faces.push_back(face_of(mesh, t));
    return faces;
}

// Whether an odd number of the other faces is in this direction from the middle of a face.
bool is_odd(const CountedVector<Face>& faces, std::size_t of, Vec3 direction) {
    const Vec3 middle = faces[of].a + (faces[of].ab + faces[of].ac) * (1.0 / 3);
    bool odd = false;
    for (std::size_t i = 0; i < faces.size(); ++i)
        odd = odd != (i != of && meets(faces[i], middle, direction));
    return odd;
}

double largest(Vec3 v) {
    return number::max(number::max(number::abs(v.x), number::abs(v.y)), number::abs(v.z));
}

Vec3 outward_direction(const Face& face) { return face.normal * (1 / largest(face.normal)) + k_askew; }

}  // namespace

bool faces_outwards(const ReadMesh& mesh, std::size_t triangle) {
    const CountedVector<Face> faces = faces_of(mesh);
    if (!(largest(faces[triangle].normal) > 0)) return true;
    return !is_odd(faces, triangle, outward_direction(faces[triangle]));
}

bool is_in_mesh(const ReadMesh& mesh, Vec3 point) {
    bool odd = false;
    for (const TriangleCorners& t : mesh.triangles) odd = odd != meets(face_of(mesh, t), point, k_askew);
    return odd;
}

}  // namespace glint::povray
