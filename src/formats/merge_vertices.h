// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles that have no vertices in common to a mesh that has.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "formats/load_state.h"
#include "glint/mesh.h"

namespace glint {

/// A corner of a triangle: corners 3 i to 3 i + 2 are those of triangle i.
template <class T> struct LooseCorner {
    T x = 0, y = 0, z = 0;
    std::uint32_t index = 0;
};

/// Sorts the corners and makes one vertex of all corners with equal numbers (0 equals -0), in the order of
/// their first corners. No choice of numbers makes that slow, as it could with a hash table. False, and an
/// error, if the memory's budget has no room.
template <class T, class Position>
bool merge_vertices(CountedVector<LooseCorner<T>>& corners, std::vector<Position>& positions,
                    std::vector<TriangleCorners>& triangles, LoadState& reading, InputText where) {
    const auto has_room = [&](std::size_t count, std::size_t size) {
        return reading.has_room(MemoryBudget::list_bytes(count, size), where, 0);
    };
    if (!has_room(corners.size() / 3, sizeof(TriangleCorners))) return false;
    std::sort(corners.begin(), corners.end(), [](const LooseCorner<T>& a, const LooseCorner<T>& b) {
        return std::tie(a.x, a.y, a.z, a.index) < std::tie(b.x, b.y, b.z, b.index);
    });
    // The first corner of each vertex moves to the front.
    triangles.resize(corners.size() / 3);
    std::size_t count = 0;
    for (const LooseCorner<T>& c : corners) {
        const bool is_same = count > 0 && corners[count - 1].x == c.x && corners[count - 1].y == c.y &&
                             corners[count - 1].z == c.z;
        const std::uint32_t index = c.index;
        if (!is_same) corners[count++] = c;
        triangles[index / 3][index % 3] = static_cast<std::uint32_t>(count - 1);
    }
    if (!has_room(count, sizeof(Position))) return false;
    positions.reserve(count);
    // `index` of a vertex is now its number in the order of the file.
    for (std::size_t i = 0; i < count; ++i) corners[i].index = CornerValues::k_none;
    for (TriangleCorners& triangle : triangles) {
        for (std::uint32_t& vertex : triangle) {
            LooseCorner<T>& c = corners[vertex];
            if (c.index == CornerValues::k_none) {
                c.index = static_cast<std::uint32_t>(positions.size());
                using Number = decltype(Position::x);
                positions.push_back(
                    {static_cast<Number>(c.x), static_cast<Number>(c.y), static_cast<Number>(c.z)});
            }
            vertex = c.index;
        }
    }
    return true;
}

}  // namespace glint
