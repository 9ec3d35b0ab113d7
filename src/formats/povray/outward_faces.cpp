// SPDX-License-Identifier: Apache-2.0
// The sides of a closed mesh, by the number of faces that a ray from a face meets: even on the outer side.
// The edges of faces need not be shared, as those of a prism's caps.
#include "formats/povray/outward_faces.h"

#include <array>
#include <utility>

#include "math/number.h"

namespace glint::povray {
namespace {

struct Face {
    Vec3 a, ab, ac, normal;
};

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

// Whether an odd number of the other faces is in this direction from the middle of a face.
bool is_odd(const CountedVector<Face>& faces, std::size_t of, Vec3 direction) {
    const Vec3 middle = faces[of].a + (faces[of].ab + faces[of].ac) * (1.0 / 3);
    bool odd = false;
    for (std::size_t i = 0; i < faces.size(); ++i)
        odd = odd != (i != of && meets(faces[i], middle, direction));
    return odd;
}

}  // namespace

std::shared_ptr<const ReadMesh> facing_outwards(const ReadMesh& mesh) {
    auto turned = make_counted<ReadMesh>(mesh);
    CountedVector<Face> faces;
    for (const TriangleCorners& t : mesh.triangles) {
        const Vec3 a = to_vec3(mesh.vertices[t[0]]), ab = to_vec3(mesh.vertices[t[1]]) - a,
                   ac = to_vec3(mesh.vertices[t[2]]) - a;
        faces.push_back({a, ab, ac, cross(ab, ac)});
    }
    const auto turn = [](CountedVector<TriangleCorners>& corners, std::size_t i) {
        if (i < corners.size()) std::swap(corners[i][1], corners[i][2]);
    };
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Vec3 n = faces[i].normal;
        const double size = number::max(number::max(number::abs(n.x), number::abs(n.y)), number::abs(n.z));
        if (!(size > 0)) continue;
        // Not along the normal, which meets the edges of faces in regular meshes.
        const Vec3 direction = n * (1 / size) + Vec3{0.0137, -0.0171, 0.0113};
        const bool is_inside = is_odd(faces, i, direction);
        if (is_inside == is_odd(faces, i, -direction)) return nullptr;
        if (!is_inside) continue;
        for (auto* const corners :
             {&turned->triangles, &turned->normal_corners, &turned->texture_corners, &turned->uv_corners})
            turn(*corners, i);
    }
    return turned;
}

}  // namespace glint::povray
