#pragma once
// Rays waiting to be traced, as columns that grow; their memory is kept from tile to tile.
#include <cstdint>
#include <vector>

#include "bvh/rays.h"
#include "glint/vec.h"

namespace glint {

/// The layer that a ray's light is added to: set by the first branch taken from the camera ray.
enum class Branch : std::uint8_t { camera, reflected, transmitted };

class RayQueue {
  public:
    int size() const { return size_; }
    void clear() { size_ = 0; }

    void push(Vec3 origin, Vec3 direction, double t_min, double t_max, Color weight, std::uint32_t pixel,
              Branch branch) {
        const int i = size_++;
        const auto needed = static_cast<std::size_t>(size_ + k_ray_padding);
        if (columns_[0].size() < needed) {
            for (auto& column : columns_) column.resize(2 * needed);
            pixel_.resize(2 * needed);
            branch_.resize(2 * needed);
        }
        const double values[k_columns] = {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z,
                                          t_min,    t_max,    weight.r, weight.g,    weight.b};
        for (int c = 0; c < k_columns; ++c) columns_[c][i] = values[c];
        pixel_[i] = pixel;
        branch_[i] = branch;
    }

    /// The rays from number `first` on.
    RaySpan rays(int first) const {
        const auto at = [&](int c) { return columns_[c].data() + first; };
        return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
    }
    Color weight(int i) const { return {columns_[8][i], columns_[9][i], columns_[10][i]}; }
    std::uint32_t pixel(int i) const { return pixel_[i]; }
    Branch branch(int i) const { return branch_[i]; }

  private:
    static constexpr int k_columns = 11;
    std::vector<double> columns_[k_columns];
    std::vector<std::uint32_t> pixel_;
    std::vector<Branch> branch_;
    int size_ = 0;
};

}  // namespace glint
