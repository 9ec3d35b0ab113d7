// SPDX-License-Identifier: Apache-2.0
#pragma once
// Columns: arrays that hold one number of each ray, hit or pixel (structure of arrays).
#include <array>
#include <cstddef>
#include <new>
#include <vector>

#include "bvh/rays.h"

namespace glint {

/// Bytes: a cache line, and the widest vector. A vector that straddles two lines costs twice.
inline constexpr std::size_t k_ray_alignment = 64;

/// An allocator of memory that begins with a cache line.
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

/// A column that grows. Its memory is kept from tile to tile.
using GrowingColumn = std::vector<double, AlignedMemory<double>>;

/// A column of at most n entries and their padding.
template <class T, int n>
struct alignas(k_ray_alignment) FixedColumn : std::array<T, std::size_t{n + k_ray_padding}> {};

}  // namespace glint
