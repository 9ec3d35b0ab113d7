// SPDX-License-Identifier: Apache-2.0
#pragma once
// Rays in columns, and the results of the kernels for them.
#include <cstdint>
#include <limits>
#include <vector>

#include "bvh/rays.h"
#include "trace/kernels.h"

namespace glint::test {

class Rays {
  public:
    Rays() {
        for (auto& c : columns_) c.resize(k_ray_padding);
    }
    void push(Vec3 o, Vec3 d, double t_min = 0, double t_max = std::numeric_limits<double>::infinity()) {
        const double values[8] = {o.x, o.y, o.z, d.x, d.y, d.z, t_min, t_max};
        for (int c = 0; c < 8; ++c) {
            columns_[c][static_cast<std::size_t>(size_)] = values[c];
            columns_[c].push_back(0);
        }
        ++size_;
    }
    int size() const { return size_; }
    RaySpan span() const {
        return {columns_[0].data(), columns_[1].data(), columns_[2].data(), columns_[3].data(),
                columns_[4].data(), columns_[5].data(), columns_[6].data(), columns_[7].data()};
    }
    Vec3 origin(int i) const { return {at(0, i), at(1, i), at(2, i)}; }
    Vec3 direction(int i) const { return {at(3, i), at(4, i), at(5, i)}; }
    double t_min(int i) const { return at(6, i); }
    double t_max(int i) const { return at(7, i); }

  private:
    double at(int c, int i) const { return columns_[c][static_cast<std::size_t>(i)]; }
    std::vector<double> columns_[8];
    int size_ = 0;
};

struct Hits {
    std::vector<double> t;
    std::vector<std::uint32_t> slot, element;
};

inline Hits nearest_hits(const Kernels& kernels, const World& world, const Rays& rays, int packet) {
    const auto padded = static_cast<std::size_t>(rays.size() + k_ray_padding);
    Hits hits{std::vector<double>(padded), std::vector<std::uint32_t>(padded),
              std::vector<std::uint32_t>(padded)};
    kernels.nearest_hit(world.parts(), rays.span(), rays.size(), packet,
                        {hits.t.data(), hits.slot.data(), hits.element.data()});
    hits.t.resize(static_cast<std::size_t>(rays.size()));
    hits.slot.resize(static_cast<std::size_t>(rays.size()));
    hits.element.resize(static_cast<std::size_t>(rays.size()));
    return hits;
}

inline std::vector<std::uint8_t> any_hits(const Kernels& kernels, const World& world, const Rays& rays,
                                          int packet) {
    std::vector<std::uint8_t> occluded(static_cast<std::size_t>(rays.size() + k_ray_padding));
    kernels.any_hit(world.parts(), rays.span(), rays.size(), packet, occluded.data());
    occluded.resize(static_cast<std::size_t>(rays.size()));
    return occluded;
}

}  // namespace glint::test
