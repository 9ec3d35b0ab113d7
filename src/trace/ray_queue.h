#pragma once
// Rays waiting to be traced, as columns that grow; their memory is kept from tile to tile.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "bvh/rays.h"
#include "glint/scene.h"

namespace glint {

/// The layer that a ray's light is added to: set by the first branch taken from the camera ray.
enum class Branch : std::uint8_t { camera, reflected, transmitted };

/// Whose ray it is, and how it came there.
struct RayPath {
    Color weight{1, 1, 1};  ///< what it finds counts for this much
    std::uint32_t pixel = 0;
    Branch branch = Branch::camera;
    std::uint32_t medium = k_none;  ///< the material it travels in, for Beer's law; k_none: air
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

    void push(Vec3 origin, Vec3 direction, double t_min, double t_max, const RayPath& path) {
        const int i = size_++;
        reserve(size_);
        const double values[k_columns] = {origin.x,    origin.y,    origin.z, direction.x,
                                          direction.y, direction.z, t_min,    t_max};
        for (int c = 0; c < k_columns; ++c) columns_[c][i] = values[c];
        paths_[i] = path;
    }

    /// The rays since the last group become one.
    void end_group() {
        if (group_ends_.empty() ? size_ > 0 : group_ends_.back() < size_) group_ends_.push_back(size_);
    }

    /// Moves the rays of the other queue to the end of this one, as a group.
    void take_group(RayQueue& other) {
        reserve(size_ + other.size_);
        for (int c = 0; c < k_columns; ++c) {
            std::copy_n(other.columns_[c].begin(), other.size_, columns_[c].begin() + size_);
        }
        std::copy_n(other.paths_.begin(), other.size_, paths_.begin() + size_);
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
    const RayPath& path(int i) const { return paths_[i]; }
    RayPath& path(int i) { return paths_[i]; }

  private:
    static constexpr int k_columns = 8;

    void reserve(int rays) {
        const auto needed = static_cast<std::size_t>(rays + k_ray_padding);
        if (columns_[0].size() >= needed) return;
        for (auto& column : columns_) column.resize(2 * needed);
        paths_.resize(2 * needed);
    }

    std::vector<double> columns_[k_columns];
    std::vector<RayPath> paths_;
    std::vector<int> group_ends_;
    int size_ = 0;
};

}  // namespace glint
