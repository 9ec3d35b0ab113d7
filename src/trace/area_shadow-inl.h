// SPDX-License-Identifier: Apache-2.0
// The shadow of an area light that shines from its centre (AreaShading::center): which of its samples are
// visible from the surfaces, and the part of the light that they stand for.
#if defined(GLINT_TRACE_AREA_SHADOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_AREA_SHADOW_INL_H_
#undef GLINT_TRACE_AREA_SHADOW_INL_H_
#else
#define GLINT_TRACE_AREA_SHADOW_INL_H_
#endif

#include "glint/render.h"
#include "trace/direct_lighting-inl.h"
#include "trace/intersect-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The visible part of an area light at one surface (POV-Ray, measured): the value of a region of the grid is
/// the mean of the visibility of its four corners, or of the values of its quarters if it is divided. A
/// region is divided if its level is below `adaptive`, or if the light of two neighbouring corners differs by
/// more than 0.1 in the sum of the channels. Values are multiples of powers of 1/2, so that sums are exact.
class VisiblePart {
  public:
    VisiblePart(const AreaGrid& grid, AreaShadowBatch& shadow, int surface, double light)
        : grid_(grid), shadow_(shadow), surface_(surface), differ_(light > 0.1) {}

    /// The value of the grid. If it needs samples that have not been traced, they are wanted, and the value
    /// has no meaning.
    double value() { return region(0, 0, grid_.columns - 1, grid_.rows - 1, 0); }
    bool wants_samples() const { return wants_; }

  private:
    double region(int u1, int v1, int u2, int v2, int level) {
        const int corners[4] = {sample(u1, v1), sample(u2, v1), sample(u2, v2), sample(u1, v2)};
        int traced = 0, visible = 0;
        for (const int corner : corners) {
            traced += shadow_.is_traced(corner, surface_) ? 1 : 0;
            visible += shadow_.is_visible(corner, surface_) ? 1 : 0;
        }
        if (traced < 4) want(corners);
        const bool small = u2 - u1 <= 1 && v2 - v1 <= 1;
        // Of corners that are not all equal, two neighbours differ.
        const bool divided = level < grid_.adaptive || (traced == 4 && differ_ && visible % 4 != 0);
        if (small || !divided) return visible * 0.25;
        const int u = (u1 + u2) / 2, v = (v1 + v2) / 2, next_u = (u1 + u2 + 1) / 2,
                  next_v = (v1 + v2 + 1) / 2;
        return (region(u1, v1, u, v, level + 1) + region(next_u, v1, u2, v, level + 1) +
                region(u1, next_v, u, v2, level + 1) + region(next_u, next_v, u2, v2, level + 1)) *
               0.25;
    }

    int sample(int u, int v) const { return v * grid_.columns + u; }

    void want(const int (&corners)[4]) {
        wants_ = true;
        for (const int corner : corners) {
            if (!shadow_.is_traced(corner, surface_))
                shadow_.wanted[AreaShadowBatch::word_of(corner, surface_)] |=
                    AreaShadowBatch::bit_of(surface_);
        }
    }

    const AreaGrid& grid_;
    AreaShadowBatch& shadow_;
    const int surface_;
    const bool differ_;  // light and shadow differ enough
    bool wants_ = false;
};

/// The shadow rays of one sample and a vector of surfaces.
HWY_INLINE ShadowRay<Doubles> sample_ray(const WorldParts& world, const PreparedLight& light, int sample,
                                         Vec3 fixed, const SurfaceBatch& surfaces, int i) {
    const SurfacePoint<Doubles> surface = surface_at(surfaces, i);
    const Vector3<Doubles> from =
        light.jitter ? moved_sample(world, light, sample, surfaces, i) : lanes_of(fixed);
    return shadow_ray_from(surface, from, from - surface.point, world.conventions);
}

/// Traces the shadow rays of one sample to the surfaces that want it.
inline void trace_sample_rays(const WorldParts& world, const PreparedLight& light, int sample,
                              const SurfaceBatch& surfaces, AreaShadowBatch& shadow,
                              ShadowRayBatch& shadow_rays) {
    const Vec3 fixed = fixed_sample(world, light.area, sample);
    const bool one_origin = !light.jitter && world.conventions.shadow_stops_at_light;
    shadow_rays.count = 0;
    const auto wanted = [&](int i) {
        return static_cast<std::uint32_t>(shadow.wanted[AreaShadowBatch::word_of(sample, i)] >> (i % 64)) &
               first_bits(lane_count<double>());
    };
    for (int i = 0; i < surfaces.count; i += lane_count<double>()) {
        if (wanted(i) == 0) continue;
        const auto set = from_bits<double>(wanted(i));
        store_shadow_rays(sample_ray(world, light, sample, fixed, surfaces, i), one_origin, set, shadow_rays,
                          shadow_rays.count);
        shadow_rays.count += count(set);
    }
    if (shadow_rays.count == 0) return;
    intersect_shadow(world, shadow_rays);
    const std::uint8_t* occluded = shadow_rays.occluded.data();
    for (std::size_t word = 0; word < AreaShadowBatch::k_words; ++word) {
        const std::size_t at = static_cast<std::size_t>(sample) * AreaShadowBatch::k_words + word;
        for (std::uint64_t bits = shadow.wanted[at]; bits != 0; bits &= bits - 1)
            shadow.visible[at] |= *occluded++ == 0 ? bits & (0 - bits) : 0;
        shadow.traced[at] |= shadow.wanted[at];
        shadow.wanted[at] = 0;
    }
}

/// Traces the shadow rays to the samples of an area light, and multiplies its strength at each surface by the
/// part that is visible. Surfaces that see none of it are no longer lit.
inline void sample_area_shadow(const WorldParts& world, const PreparedLight& light,
                               const SurfaceBatch& surfaces, LightSampleBatch& samples,
                               AreaShadowBatch& shadow, ShadowRayBatch& shadow_rays, RayCounts& counts) {
    shadow.start(light.area.count());
    const double light_sum = abs(light.color.r) + abs(light.color.g) + abs(light.color.b);
    for (bool wants = true; wants;) {
        wants = false;
        for (int h = 0; h < surfaces.count; ++h) {
            const auto at = static_cast<std::size_t>(h);
            if ((lit_bits(samples, h) >> (h % lane_count<double>()) & 1) == 0) continue;
            VisiblePart part(light.area, shadow, h, light_sum * samples.strength[at]);
            shadow.fraction[at] = part.value();
            wants = wants || part.wants_samples();
        }
        if (!wants) break;
        for (int sample = 0; sample < light.area.count(); ++sample) {
            trace_sample_rays(world, light, sample, surfaces, shadow, shadow_rays);
            counts.shadow += static_cast<std::uint64_t>(shadow_rays.count);
        }
    }
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        std::uint8_t& lit = samples.lit[static_cast<std::size_t>(h / lane_count<double>())];
        if (lit == 0) continue;
        const auto at = static_cast<std::size_t>(h);
        const Doubles fraction = load(shadow.fraction.data() + at);
        lit = static_cast<std::uint8_t>(lit & to_bits(fraction > Doubles(0)));
        store(load(samples.strength.data() + at) * fraction, samples.strength.data() + at);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
