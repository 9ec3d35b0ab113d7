// SPDX-License-Identifier: Apache-2.0
#pragma once
// Rays waiting to be traced, as columns that grow; their memory is kept from tile to tile.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "bvh/rays.h"
#include "glint/vec.h"

namespace glint {

/// The columns of a queue. All are numbers in double, so that all are compacted in the same way.
enum RayColumn : int {
    k_ray_origin = 0,
    k_ray_direction = 3,
    k_ray_t_min = 6,
    k_ray_t_max = 7,
    // Of mirror and glass rays only: camera rays weigh 1, in order of their pixels, and start in air.
    k_ray_weight = 8,   // what the ray finds counts for this much
    k_ray_target = 11,  // the pixel in the tile, + k_layer_stride after a first transmission
    k_ray_medium = 12,  // with Beer's law: the material it travels in; k_none: air
    k_ray_columns = 13
};

inline constexpr std::size_t k_ray_alignment = 64;  // bytes: a line of the cache, the widest vector

/// Memory that begins with a line of the cache.
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

/// Rays in groups: a pixel has at most one ray in a group, and its groups come in the order in which its
/// light is added up.
class RayQueue {
  public:
    int size() const { return size_; }
    void clear() {
        size_ = 0;
        group_ends_.clear();
    }

    /// Makes room for this many rays and their padding.
    void reserve(int rays) {
        ensure_capacity(rays);
        uniform_rays_ = 0;
    }
    /// Begins with camera rays that share these numbers. They are written unless they are still here, from a
    /// tile whose rays all missed.
    void start_uniform(int rays, Vec3 origin, double t_min, double t_max) {
        clear();
        ensure_capacity(rays);
        const std::array<double, 5> numbers{origin.x, origin.y, origin.z, t_min, t_max};
        using Bits = std::array<std::uint64_t, 5>;  // -0 is not 0
        if (uniform_rays_ >= rays && std::bit_cast<Bits>(numbers) == std::bit_cast<Bits>(uniform_)) return;
        constexpr int columns[] = {k_ray_origin, k_ray_origin + 1, k_ray_origin + 2, k_ray_t_min,
                                   k_ray_t_max};
        for (std::size_t i = 0; i < numbers.size(); ++i) std::fill_n(column(columns[i]), rays, numbers[i]);
        uniform_ = numbers;
        uniform_rays_ = rays;
    }
    /// To be written from size() on, within what is reserved; grow() makes rays of it.
    double* column(int c) { return columns_[c].data(); }
    const double* column(int c) const { return columns_[c].data(); }
    void grow(int rays) { size_ += rays; }

    /// The rays since the last group become one.
    void end_group() {
        if (group_ends_.empty() ? size_ > 0 : group_ends_.back() < size_) group_ends_.push_back(size_);
    }

    /// Moves the rays of the other queue to the end of this one, as a group.
    void append_group(RayQueue& other) {
        if (other.size_ == 0) return;
        reserve(size_ + other.size_);
        for (int c = 0; c < k_ray_columns; ++c) {
            std::copy_n(other.columns_[c].begin(), other.size_, columns_[c].begin() + size_);
        }
        size_ += other.size_;
        other.clear();
        end_group();
    }

    /// The number of the group that a ray belongs to.
    std::size_t group_of(int ray) const {
        return static_cast<std::size_t>(std::upper_bound(group_ends_.begin(), group_ends_.end(), ray) -
                                        group_ends_.begin());
    }
    /// The ray after the group's last.
    int group_end(std::size_t group) const { return group_ends_[group]; }

    /// The rays from number `first` on.
    RaySpan rays(int first) const {
        const auto at = [&](int c) { return columns_[c].data() + first; };
        return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
    }

  private:
    void ensure_capacity(int rays) {
        const auto needed = static_cast<std::size_t>(rays) + k_ray_padding;
        if (columns_[0].size() >= needed) return;
        for (auto& column : columns_) column.resize(2 * needed);
        uniform_rays_ = 0;
    }

    std::array<double, 5> uniform_{};  // see start_uniform
    int uniform_rays_ = 0;             // so many have them
    std::vector<double, AlignedMemory<double>> columns_[k_ray_columns];
    std::vector<int> group_ends_;
    int size_ = 0;
};

}  // namespace glint
