// SPDX-License-Identifier: Apache-2.0
// The values of rays that the spheres' quick tests use, computed once per ray.
#if defined(GLINT_TRACE_QUICK_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_QUICK_RAYS_INL_H_
#undef GLINT_TRACE_QUICK_RAYS_INL_H_
#else
#define GLINT_TRACE_QUICK_RAYS_INL_H_
#endif

#include <limits>

#include "bvh/slab-inl.h"
#include "geometry/sphere-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The rays of a chunk for SphereGeometry::quick_test and ParallelTest, computed when first needed.
class QuickRays {
  public:
    /// Rays [0, count), 1 <= count <= SlabRays::k_max_rays. parallel: all have the same direction.
    QuickRays(const RaySpan& rays, int count, bool parallel)
        : rays_(rays), count_(count), parallel_(parallel) {}

    /// Whether the tests are valid: no direction is very short or long. Must be called before the functions
    /// below.
    HWY_INLINE bool usable() {
        if (!ready_) prepare();
        return usable_;
    }
    /// At least t_min d·d of each ray; infinite if a ray has a limit.
    double start() const { return start_; }
    /// 0; infinite if a ray has a negative t_min.
    double away() const { return away_; }
    /// d·d of ray i, in all lanes.
    HWY_INLINE Doubles length_2(int i) const { return Doubles(length_2_[i]); }

    /// Whether the tests of parallel rays are valid. Must be called before the functions below.
    HWY_INLINE bool parallel() { return parallel_ && usable() && away_ == 0; }
    const ParallelFrame& frame() const { return frame_; }
    /// At least the distance t_min |d| of each ray; infinite if a ray has a limit.
    double start_along() const { return start_along_; }
    /// The origin of ray i in the frame, in all lanes.
    HWY_INLINE Vector3<Doubles> one(int i) const {
        return {Doubles(coordinate_[0][i]), Doubles(coordinate_[1][i]), Doubles(coordinate_[2][i])};
    }
    /// Those of rays [i, i + lanes), rounded.
    HWY_INLINE Vector3<Floats> narrow(int i) const {
        return {load(narrow_[0] + i), load(narrow_[1] + i), load(narrow_[2] + i)};
    }

  private:
    HWY_NOINLINE void prepare() {
        ready_ = true;
        const Doubles infinity(std::numeric_limits<double>::infinity());
        Doubles start(0), away(0), magnitude(0);
        bool usable = true;
        for (int i = 0; i < count_; i += lane_count<double>()) {
            const Vector3<Doubles> o = origin(i),
                                   d{load(rays_.dx + i), load(rays_.dy + i), load(rays_.dz + i)};
            const Doubles d_2 = dot(d, d), t_min = load(rays_.t_min + i);
            store(d_2, length_2_ + i);
            const auto here = first_lanes<double>(count_ - i);
            const auto in_range = d_2 > Doubles(1e-30) && d_2 < Doubles(1e30);
            usable = usable && !any(and_not(here, in_range));
            // The slab expression changes components of a direction below 1e-30. A t_min may be NaN.
            const auto usual = load(rays_.t_max + i) == infinity && t_min >= -infinity &&
                               d_2 > Doubles(1e-12) && d_2 < Doubles(1e12);
            const Doubles from = select(usual, t_min * d_2 * Doubles(1 + 1e-12), infinity);
            start = select(here, max(start, from), start);
            magnitude = select(here, max(magnitude, abs(o.x) + abs(o.y) + abs(o.z)), magnitude);
            away = select(here && t_min < Doubles(0), infinity, away);
        }
        start_ = max_of_lanes(start);
        away_ = max_of_lanes(away);
        usable_ = usable;
        if (parallel_) set_coordinates(max_of_lanes(magnitude));
    }
    HWY_INLINE void set_coordinates(double magnitude) {
        start_along_ = start_ / number::sqrt(length_2_[0]);
        frame_ = ParallelFrame({rays_.dx[0], rays_.dy[0], rays_.dz[0]}, magnitude);
        for (int i = 0; i < count_; i += lane_count<double>()) {
            const Vector3<Doubles> at = frame_.coordinates(origin(i));
            const Doubles columns[3] = {at.x, at.y, at.z};
            for (int a = 0; a < 3; ++a) {
                store(columns[a], coordinate_[a] + i);
                store_narrow(columns[a], narrow_[a] + i);
            }
        }
    }
    HWY_INLINE Vector3<Doubles> origin(int i) const {
        return {load(rays_.ox + i), load(rays_.oy + i), load(rays_.oz + i)};
    }

    const RaySpan& rays_;
    const int count_;
    const bool parallel_;
    bool ready_ = false, usable_;
    double start_, start_along_, away_;
    ParallelFrame frame_;
    alignas(64) double length_2_[SlabRays::k_size], coordinate_[3][SlabRays::k_size];
    alignas(64) float narrow_[3][SlabRays::k_size];
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
