// SPDX-License-Identifier: Apache-2.0
// Smoothing groups: normals for the triangles of an .obj that have none.
#include <algorithm>

#include "formats/obj_data.h"
#include "math/transform.h"

namespace glint {
namespace {

// The normals of a file's smoothing groups. Each belongs to a vertex and a group.
class GroupNormals {
  public:
    explicit GroupNormals(const ObjData& data) : data_(data), by_vertex_(data.positions.size() + 1) {}

    // Most vertices are in one group: what repeats the last group of its vertex is not stored.
    void add_corner(std::uint32_t vertex, std::uint32_t group) {
        if (by_vertex_[vertex] == group) return;
        by_vertex_[vertex] = group;
        keys_.push_back(key(vertex, group));
    }
    // Sorted lists, because numbers can be chosen that make hash tables slow.
    void sort() {
        std::sort(keys_.begin(), keys_.end());
        keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
        sums_.resize(keys_.size());
        std::uint32_t at = 0;
        for (std::size_t vertex = 0; vertex < by_vertex_.size(); ++vertex) {
            while (at < keys_.size() && keys_[at] >> 32 < vertex) ++at;
            by_vertex_[vertex] = at;
        }
    }
    std::size_t size() const { return sums_.size(); }
    std::uint32_t find(std::uint32_t vertex, std::uint32_t group) const {
        const std::uint64_t* const keys = keys_.data();
        return static_cast<std::uint32_t>(std::lower_bound(keys + by_vertex_[vertex],
                                                           keys + by_vertex_[std::size_t{vertex} + 1],
                                                           key(vertex, group)) -
                                          keys);
    }
    void add_triangle(const TriangleCorners& t, std::uint32_t group) {
        const Vec3 &a = data_.positions[t[0]], &b = data_.positions[t[1]], &c = data_.positions[t[2]];
        const Vec3 normal = cross(b - a, c - a);  // twice as long as the triangle's area
        for (const std::uint32_t vertex : t) {
            Vec3& sum = sums_[find(vertex, group)];
            sum = sum + normal;
        }
    }
    // (0, 0, 0), so that the triangles there are flat, if they cancel each other.
    Float3 normal(std::size_t i) const {
        const double size = length(sums_[i]);
        if (!(size > 0)) return {};
        const Vec3 n = sums_[i] / size;
        return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    }

  private:
    static std::uint64_t key(std::uint32_t vertex, std::uint32_t group) {
        return std::uint64_t{vertex} << 32 | group;
    }
    const ObjData& data_;
    CountedVector<std::uint64_t> keys_;
    CountedVector<Vec3> sums_;                // by key
    CountedVector<std::uint32_t> by_vertex_;  // its last group; once sorted, its first key
};

template <class Visit> void for_each_smooth(ObjData& data, const Visit& visit) {
    for (ObjPart& part : data.parts) {
        for (std::size_t i = 0; i < part.normals.size(); ++i) {
            TriangleCorners& n = part.normals[i];
            if (n[0] == CornerValues::k_none && n[1] != 0) visit(part.triangles[i], n);
        }
    }
}

}  // namespace

bool smooth_groups(ObjData& data, LoadState& reading, InputText where) {
    std::uint64_t triangles = 0;
    for_each_smooth(data, [&](const TriangleCorners&, TriangleCorners&) { ++triangles; });
    if (triangles == 0) return true;
    const std::uint64_t bytes =
        MemoryBudget::list_bytes(3 * triangles, sizeof(std::uint64_t) + sizeof(Vec3) + sizeof(Float3)) +
        MemoryBudget::list_bytes(data.positions.size() + 1, sizeof(std::uint32_t));
    if (!reading.has_room(bytes, where, 0)) return false;
    GroupNormals groups(data);
    for_each_smooth(data, [&](const TriangleCorners& t, TriangleCorners& n) {
        for (const std::uint32_t vertex : t) groups.add_corner(vertex, n[1]);
    });
    groups.sort();
    for_each_smooth(data,
                    [&](const TriangleCorners& t, TriangleCorners& n) { groups.add_triangle(t, n[1]); });
    if (data.normals.size() + groups.size() >= CornerValues::k_none) {
        reading.diagnostics.error(where, 0, 1, "too many normals of smoothing groups");
        return false;
    }
    const auto first = static_cast<std::uint32_t>(data.normals.size());
    for (std::size_t i = 0; i < groups.size(); ++i) data.normals.push_back(groups.normal(i));
    for_each_smooth(data, [&](const TriangleCorners& t, TriangleCorners& n) {
        const std::uint32_t group = n[1];
        for (std::size_t i = 0; i < 3; ++i) n[i] = first + groups.find(t[i], group);
    });
    return true;
}

}  // namespace glint
