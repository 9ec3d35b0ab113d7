// SPDX-License-Identifier: Apache-2.0
// The values of a ray that the tests of all triangles use, computed once per ray.
#if defined(GLINT_TRACE_SHEARED_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SHEARED_RAYS_INL_H_
#undef GLINT_TRACE_SHEARED_RAYS_INL_H_
#else
#define GLINT_TRACE_SHEARED_RAYS_INL_H_
#endif

#include "bvh/slab-inl.h"
#include "geometry/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The rays of a chunk in the sheared space of TriangleGeometry, computed for groups of rays when first
/// needed.
class ShearedRays {
  public:
    explicit ShearedRays(const RaySpan& rays) : rays_(rays) {}

    /// Ray i in all lanes.
    HWY_INLINE TriangleGeometry::ShearedRay<Doubles> one(int i) {
        prepare(i);
        return {{Doubles(column_[0][i]), Doubles(column_[1][i]), Doubles(column_[2][i])},
                Doubles(column_[3][i]),
                Doubles(column_[4][i]),
                Doubles(column_[5][i])};
    }
    /// Rays [i, i + lanes).
    HWY_INLINE TriangleGeometry::ShearedRay<Doubles> lanes(int i) {
        prepare(i), prepare(i + lane_count<double>() - 1);
        return {{load(column_[0] + i), load(column_[1] + i), load(column_[2] + i)},
                load(column_[3] + i),
                load(column_[4] + i),
                load(column_[5] + i)};
    }
    /// The major axis of ray i, or of rays [i, i + lanes); -1 if they differ. The rays must be prepared.
    HWY_INLINE int axis(int i) const { return axis_[i]; }
    HWY_INLINE int common_axis(int i) const {
        for (int k = 1; k < lane_count<double>(); ++k)
            if (axis_[i + k] != axis_[i]) return -1;
        return axis_[i];
    }

  private:
    // The vector of the last ray may extend into the next group, whose rays must then be valid padding.
    static constexpr int k_group = k_ray_padding / 2;
    static_assert(k_group % lane_count<double>() == 0);

    HWY_INLINE void prepare(int i) {
        const int group = i / k_group;
        if ((ready_ >> group & 1) == 0) prepare_group(group);
    }
    HWY_NOINLINE void prepare_group(int group) {
        ready_ |= std::uint64_t{1} << group;
        for (int i = group * k_group; i < (group + 1) * k_group; i += lane_count<double>()) {
            const Ray<Doubles> ray{{load(rays_.ox + i), load(rays_.oy + i), load(rays_.oz + i)},
                                   {load(rays_.dx + i), load(rays_.dy + i), load(rays_.dz + i)}};
            const auto permutation = TriangleGeometry::AxisPermutation<Doubles>::of(ray.direction);
            const auto s = TriangleGeometry::shear_ray(ray, permutation);
            const Doubles values[6] = {s.origin.x, s.origin.y, s.origin.z, s.start, s.shear_x, s.shear_y};
            for (int k = 0; k < 6; ++k) store(values[k], column_[k] + i);
            const std::uint32_t along_x = to_bits(permutation.along_x),
                                along_y = to_bits(permutation.along_y);
            for (int k = 0; k < lane_count<double>(); ++k)
                axis_[i + k] = static_cast<std::uint8_t>(along_x >> k & 1 ? 0 : along_y >> k & 1 ? 1 : 2);
        }
    }

    const RaySpan& rays_;
    alignas(64) double column_[6][SlabRays::k_size];
    std::uint8_t axis_[SlabRays::k_size];
    std::uint64_t ready_ = 0;
    static_assert(SlabRays::k_size / k_group <= 64);
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
