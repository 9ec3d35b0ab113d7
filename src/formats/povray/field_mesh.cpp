// SPDX-License-Identifier: Apache-2.0
// What was measured of POV-Ray: the texels are the vertices, the diagonal of a square of them is that from +x
// to +z; what is below water_level is cut off and left open.
#include "formats/povray/field_mesh.h"

#include <algorithm>

#include "math/transform.h"

namespace glint::povray {
namespace {

constexpr double k_height_steps = 65536;
constexpr int k_max_field_parts = 16;
constexpr double k_normal_tolerance = 0.002;           // of unit vectors
constexpr std::uint64_t k_most_triangles = 4'000'000;  // beyond which squares are divided less

std::uint64_t least_triangles(const HeightField& field) {
    return std::uint64_t{2} * (field.width - 1) * (field.depth - 1);
}

class FieldMesh {
  public:
    FieldMesh(const HeightField& field, const Affine& object_from_world)
        : field_(field), object_from_world_(object_from_world) {}

    FieldMeshResult make() {
        vertices().reserve(field_.heights.size());
        if (field_.is_smooth) normals().reserve(field_.heights.size());
        for (std::uint32_t z = 0; z < field_.depth; ++z) {
            for (std::uint32_t x = 0; x < field_.width; ++x) {
                vertices().push_back({static_cast<float>(x), height(x, z), static_cast<float>(z)});
                if (field_.is_smooth) normals().push_back(to_single(normal(x, z)));
            }
        }
        std::uint64_t triangles = least_triangles(field_);
        if (field_.is_smooth) {
            const std::uint64_t most = std::max(k_most_triangles, triangles);
            while ((triangles = count_triangles()) > most) tolerance_ *= 4;
        }
        mesh_->triangles.reserve(static_cast<std::size_t>(triangles));
        for_each_square([&](std::uint32_t x, std::uint32_t z) {
            const int n = field_.is_smooth ? parts_of(x, z) : 1;
            if (n > 1) return add_parts(x, z, n);
            add_square(z * field_.width + x, field_.width);
        });
        return {std::move(mesh_), tolerance_ > k_normal_tolerance};
    }

  private:
    std::uint64_t count_triangles() const {
        std::uint64_t triangles = 0;
        for_each_square([&](std::uint32_t x, std::uint32_t z) {
            const auto n = static_cast<std::uint64_t>(parts_of(x, z));
            triangles += 2 * n * n;
        });
        return triangles;
    }

    // The normals at the corners of a square.
    struct Corners {
        Vec3 here, right, up, across;
        Vec3 at(double x, double z) const {
            return here * ((1 - x) * (1 - z)) + right * (x * (1 - z)) + up * ((1 - x) * z) + across * (x * z);
        }
    };

    template <class Use> void for_each_square(Use&& use) const {
        for (std::uint32_t z = 0; z + 1 < field_.depth; ++z) {
            for (std::uint32_t x = 0; x + 1 < field_.width; ++x) use(x, z);
        }
    }

    Vec3 in_scene(Vec3 normal) const { return transform_normal(object_from_world_, normal); }
    std::vector<Float3>& vertices() { return mesh_->single_positions; }
    std::vector<Float3>& normals() { return mesh_->normals.values; }
    float height(std::uint32_t x, std::uint32_t z) const {
        return field_.heights[z * std::size_t{field_.width} + x];
    }

    // The mean of the unit normals of the triangles with two neighbours, in parts of 1/32767. In the scene,
    // all normals have the same length where they are mixed. (Measured)
    Vec3 normal(std::uint32_t x, std::uint32_t z) const {
        const double middle = height(x, z);
        Vec3 sum{0, 0, 0};
        for (const int dx : {-1, 1}) {
            if (dx < 0 ? x == 0 : x + 1 == field_.width) continue;
            const double slope_x = dx * (height(x + static_cast<std::uint32_t>(dx), z) - middle);
            for (const int dz : {-1, 1}) {
                if (dz < 0 ? z == 0 : z + 1 == field_.depth) continue;
                const double slope_z = dz * (height(x, z + static_cast<std::uint32_t>(dz)) - middle);
                sum = sum + normalize(Vec3{-slope_x, 1, -slope_z});
            }
        }
        const Vec3 n = normalize(sum) * 32767;
        const auto whole = [](double v) { return static_cast<double>(static_cast<std::int32_t>(v)); };
        const Vec3 rounded{whole(n.x), whole(n.y), whole(n.z)};
        return rounded / length(in_scene(rounded));
    }

    Corners corners_of(std::uint32_t x, std::uint32_t z) const {
        const Float3* here = &mesh_->normals.values[std::size_t{z} * field_.width + x];
        const Float3* up = here + field_.width;
        return {to_vec3(here[0]), to_vec3(here[1]), to_vec3(up[0]), to_vec3(up[1])};
    }

    // In how many parts a side of a square is divided. POV-Ray's normals are bilinear in the square
    // (measured); a triangle's are linear, which differs from that most in its middle, by a quarter of the
    // twist.
    int parts_of(std::uint32_t x, std::uint32_t z) const {
        const Corners corners = corners_of(x, z);
        const double twist = length(in_scene(corners.across - corners.right - corners.up + corners.here));
        const double size = length(in_scene(corners.at(0.5, 0.5)));
        int n = 1;
        while (n < k_max_field_parts && twist > 4 * tolerance_ * size * n * n) n *= 2;
        return n;
    }

    // A square in n x n parts, of which n is a power of 2: their heights are exact in single precision, so
    // that they meet those of other squares without gaps.
    void add_parts(std::uint32_t x, std::uint32_t z, int n) {
        const Corners corners = corners_of(x, z);
        const double here = height(x, z), right = height(x + 1, z), up = height(x, z + 1),
                     across = height(x + 1, z + 1);
        const auto first = static_cast<std::uint32_t>(vertices().size());
        for (int j = 0; j <= n; ++j) {
            for (int i = 0; i <= n; ++i) {
                const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
                const double y = i + j <= n ? here + u * (right - here) + v * (up - here)
                                            : across + (1 - u) * (up - across) + (1 - v) * (right - across);
                vertices().push_back(to_single({x + u, y, z + v}));
                normals().push_back(to_single(corners.at(u, v)));
            }
        }
        const auto row = static_cast<std::uint32_t>(n + 1);
        for (std::uint32_t j = 0; j + 1 < row; ++j) {
            for (std::uint32_t i = 0; i + 1 < row; ++i) add_square(first + j * row + i, row);
        }
    }

    void add_square(std::uint32_t corner, std::uint32_t row) {
        add({corner, corner + row, corner + 1});
        add({corner + row + 1, corner + 1, corner + row});
    }

    // A triangle, or what is left of it above the water.
    void add(const TriangleCorners& corners) {
        std::uint32_t kept[4];
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = corners[i], to = corners[(i + 1) % 3];
            const bool is_from = is_above(from), is_to = is_above(to);
            if (is_from) kept[count++] = from;
            if (is_from != is_to) kept[count++] = cut(from, to);
        }
        if (count >= 3) mesh_->triangles.push_back({kept[0], kept[1], kept[2]});
        if (count == 4) mesh_->triangles.push_back({kept[0], kept[2], kept[3]});
    }

    bool is_above(std::uint32_t vertex) const { return mesh_->single_positions[vertex].y >= field_.water; }

    // The vertex where an edge meets the water: the same from both sides of it.
    std::uint32_t cut(std::uint32_t a, std::uint32_t b) {
        if (a > b) std::swap(a, b);
        const Vec3 from = to_vec3(vertices()[a]), to = to_vec3(vertices()[b]);
        const double share = (field_.water - from.y) / (to.y - from.y);
        vertices().push_back(to_single(from + (to - from) * share));
        if (!normals().empty()) {
            const Vec3 n = to_vec3(normals()[a]), m = to_vec3(normals()[b]);
            normals().push_back(to_single(n + (m - n) * share));
        }
        return static_cast<std::uint32_t>(vertices().size() - 1);
    }

    const HeightField& field_;
    const Affine& object_from_world_;
    double tolerance_ = k_normal_tolerance;
    std::shared_ptr<MeshData> mesh_ = std::make_shared<MeshData>();
};

}  // namespace

// Water cuts a triangle into two at most, with two more vertices.
std::uint64_t bytes_of_mesh(const HeightField& field) {
    const std::uint64_t least = least_triangles(field);
    const std::uint64_t divided = std::min(k_most_triangles, least * k_max_field_parts * k_max_field_parts);
    const std::uint64_t triangles = field.is_smooth ? std::max(divided, least) : least;
    const std::uint64_t vertex = sizeof(Float3) * (field.is_smooth ? 2 : 1);
    return triangles * (sizeof(TriangleCorners) + vertex) * (field.water > 0 ? 2 : 1);
}

FieldMeshResult mesh_of_field(const HeightField& field, const Affine& object_from_world) {
    return FieldMesh(field, object_from_world).make();
}

Affine cube_from_grid(const HeightField& field) {
    return scaling({1.0 / (field.width - 1), 1 / k_height_steps, 1.0 / (field.depth - 1)});
}

}  // namespace glint::povray
