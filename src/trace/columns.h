// SPDX-License-Identifier: Apache-2.0
#pragma once
// Columns: arrays with one number per ray, hit or pixel (structure of arrays).
#include <array>
#include <cstddef>
#include <new>
#include <vector>

#include "bvh/rays.h"
#include "glint/vec.h"

namespace glint {

/// In bytes: the size of a cache line and of the widest vector. Access to a vector in two lines is slower.
inline constexpr std::size_t k_ray_alignment = 64;

/// An allocator that aligns memory to cache lines.
template <class T> struct AlignedMemory {
    using value_type = T;
    AlignedMemory() = default;
    template <class U> AlignedMemory(const AlignedMemory<U>&) {}
    T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(k_ray_alignment)));
    }
    void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(k_ray_alignment)); }
    friend bool operator==(const AlignedMemory&, const AlignedMemory&) { return true; }
};

/// A column that grows. Its memory is reused for the next tile.
using GrowingColumn = std::vector<double, AlignedMemory<double>>;

/// A column of at most n entries, with padding.
template <class T, int n>
struct alignas(k_ray_alignment) FixedColumn : std::array<T, std::size_t{n + k_ray_padding}> {};

/// Entry i of three columns.
template <class Column> inline Vec3 vec3_at(const Column* from, int i) {
    return {(&from[0][0])[i], (&from[1][0])[i], (&from[2][0])[i]};
}

}  // namespace glint
