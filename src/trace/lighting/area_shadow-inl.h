// SPDX-License-Identifier: Apache-2.0
// The shadow of an area light that shines from its centre (AreaShading::center): which of its samples are
// visible from the surfaces, and the part of the light that they stand for.
#if defined(GLINT_TRACE_AREA_SHADOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_AREA_SHADOW_INL_H_
#undef GLINT_TRACE_AREA_SHADOW_INL_H_
#else
#define GLINT_TRACE_AREA_SHADOW_INL_H_
#endif

#include <array>
#include <bit>
#include <type_traits>
#include <vector>

#include "glint/render.h"
#include "trace/lighting/direct_lighting-inl.h"
#include "trace/lighting/shadow_visibility-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The light of one color and strength at a surface, for the question whether it differs between two samples:
/// by more than 0.1 in the sum of the channels (POV-Ray, measured).
class LightDifference {
  public:
    LightDifference(Color light, double strength)
        : light_{abs(light.r), abs(light.g), abs(light.b)},
          strength_(strength),
          lit_and_dark_((light_.r + light_.g + light_.b) * strength > 0.1) {}
    /// a, b: 1 if the sample is visible, else 0.
    bool exists(double a, double b) const { return lit_and_dark_ && a != b; }
    /// a, b: the factors of the samples' light.
    bool exists(Color a, Color b) const {
        return (light_.r * abs(a.r - b.r) + light_.g * abs(a.g - b.g) + light_.b * abs(a.b - b.b)) *
                   strength_ >
               0.1;
    }

  private:
    Color light_;
    double strength_;
    bool lit_and_dark_;
};

/// The visible part of an area light at one surface (POV-Ray, measured): the value of a region of the grid is
/// the mean of the values of its four corners, or of its quarters if it is divided. A region is divided if
/// its level is below `adaptive`, or if the light of two neighbouring corners differs. Value: double for
/// visible samples, 1 or 0, whose sums are exact; Color with colored shadows.
template <class Value> class VisiblePart {
  public:
    VisiblePart(const AreaGrid& grid, AreaShadowBatch& shadow, int surface, const LightDifference& difference)
        : grid_(grid), shadow_(shadow), surface_(surface), difference_(difference) {}

    /// The value of the grid. If it needs samples that have not been traced, they are wanted, and the value
    /// has no meaning.
    Value value() { return value_of(whole()); }
    bool wants_samples() const { return wants_; }
    /// Adds to weights[sample] the factor with which the sample counts in value(), which wants no samples.
    void add_weights(std::vector<double>& weights) const { add_weights(whole(), 1, weights); }

  private:
    struct Region {
        int u1, v1, u2, v2, level;  // the first and the last column and row
    };
    struct Corners {
        int sample[4];  // neighbours follow each other
        Value value[4];
        bool traced;
    };

    Region whole() const { return {0, 0, grid_.columns - 1, grid_.rows - 1, 0}; }

    Corners corners_of(const Region& r) const {
        Corners corners{
            {sample(r.u1, r.v1), sample(r.u2, r.v1), sample(r.u2, r.v2), sample(r.u1, r.v2)}, {}, true};
        for (int k = 0; k < 4; ++k) {
            corners.traced = corners.traced && shadow_.is_traced(corners.sample[k], surface_);
            corners.value[k] = value_of(corners.sample[k]);
        }
        return corners;
    }

    bool is_divided(const Region& r, const Corners& corners) const {
        if (r.u2 - r.u1 <= 1 && r.v2 - r.v1 <= 1) return false;
        return r.level < grid_.adaptive || (corners.traced && neighbours_differ(corners.value));
    }

    static std::array<Region, 4> quarters_of(const Region& r) {
        const int u = (r.u1 + r.u2) / 2, v = (r.v1 + r.v2) / 2, next_u = (r.u1 + r.u2 + 1) / 2,
                  next_v = (r.v1 + r.v2 + 1) / 2, level = r.level + 1;
        return {Region{r.u1, r.v1, u, v, level}, Region{next_u, r.v1, r.u2, v, level},
                Region{r.u1, next_v, u, r.v2, level}, Region{next_u, next_v, r.u2, r.v2, level}};
    }

    Value value_of(const Region& r) {
        const Corners corners = corners_of(r);
        if (!corners.traced) want(corners.sample);
        if (!is_divided(r, corners))
            return (corners.value[0] + corners.value[1] + corners.value[2] + corners.value[3]) * 0.25;
        const std::array<Region, 4> quarters = quarters_of(r);
        return (value_of(quarters[0]) + value_of(quarters[1]) + value_of(quarters[2]) +
                value_of(quarters[3])) *
               0.25;
    }

    void add_weights(const Region& r, double weight, std::vector<double>& weights) const {
        const Corners corners = corners_of(r);
        if (is_divided(r, corners)) {
            for (const Region& quarter : quarters_of(r)) add_weights(quarter, 0.25 * weight, weights);
            return;
        }
        for (const int corner : corners.sample) weights[static_cast<std::size_t>(corner)] += 0.25 * weight;
    }

    int sample(int u, int v) const { return v * grid_.columns + u; }

    Value value_of(int corner) const {
        if (!shadow_.is_visible(corner, surface_)) return Value{};
        if constexpr (std::is_same_v<Value, Color>) {
            return shadow_.filter_of(corner, surface_);
        } else {
            return 1;
        }
    }

    bool neighbours_differ(const Value (&values)[4]) const {
        for (int k = 0; k < 4; ++k) {
            if (difference_.exists(values[k], values[(k + 1) % 4])) return true;
        }
        return false;
    }

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
    const LightDifference& difference_;
    bool wants_ = false;
};

/// The shadow rays of one sample and a vector of surfaces.
HWY_INLINE ShadowRay<Doubles> sample_ray(const WorldParts& world, const PreparedLight& light, int sample,
                                         Vec3 fixed, const SurfaceBatch& surfaces, int i) {
    const SurfacePoint<Doubles> surface = surface_at(surfaces, i);
    const Vector3<Doubles> from =
        light.moves_samples() ? moved_sample(world, light, sample, surfaces, i) : lanes_of(fixed);
    return shadow_ray_from(surface, from, from - surface.point, world.conventions);
}

/// Calls visit(surface) for each surface that wants a sample, in the order of its shadow rays.
template <class Visit>
inline void for_each_wanting(const AreaShadowBatch& shadow, int sample, const Visit& visit) {
    for (int first = 0; first < k_batch_size; first += 64) {
        for (std::uint64_t bits = shadow.wanted[AreaShadowBatch::word_of(sample, first)]; bits != 0;
             bits &= bits - 1)
            visit(first + std::countr_zero(bits));
    }
}

/// With colored shadows: stores the factors of the light of one sample, and records the transparent surfaces.
inline void store_sample_filters(const ShadowRayBatch& rays, int sample, AreaShadowBatch& shadow,
                                 TileRecord* record) {
    int ray = 0;
    for_each_wanting(shadow, sample, [&](int surface) {
        const auto r = static_cast<std::size_t>(ray);
        shadow.filter_of(sample, surface) = {rays.filter[0][r], rays.filter[1][r], rays.filter[2][r]};
        if (record != nullptr) {
            for (const TileRecord::ShadowStep& step : record->shadow_steps) {
                if (step.ray == ray) record->sample_steps.push_back({sample, surface, step});
            }
        }
        ++ray;
    });
    if (record != nullptr) record->shadow_steps.clear();
}

/// Traces the shadow rays of one sample to the surfaces that want it.
inline void trace_sample_rays(const WorldParts& world, const PreparedLight& light, int sample,
                              const SurfaceBatch& surfaces, AreaShadowBatch& shadow,
                              ShadowRayBatch& shadow_rays, SteppedRays& steps, TileRecord* record) {
    const Vec3 fixed = fixed_sample(world, light.area, sample);
    const bool one_origin = !light.moves_samples() && world.conventions.shadow_stops_at_light;
    shadow_rays.count = 0;
    shadow_rays.from_light = comes_from_light(light, world.conventions);
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
    find_visibility(world, shadow_rays, steps, record);
    if (world.colors_shadows()) store_sample_filters(shadow_rays, sample, shadow, record);
    const std::uint8_t* occluded = shadow_rays.occluded.data();
    for (std::size_t word = 0; word < AreaShadowBatch::k_words; ++word) {
        const std::size_t at = static_cast<std::size_t>(sample) * AreaShadowBatch::k_words + word;
        for (std::uint64_t bits = shadow.wanted[at]; bits != 0; bits &= bits - 1)
            shadow.visible[at] |= *occluded++ == 0 ? bits & (0 - bits) : 0;
        shadow.traced[at] |= shadow.wanted[at];
        shadow.wanted[at] = 0;
    }
}

/// Stores the visible part of the light at a surface.
inline void store_part(double part, std::size_t at, LightSampleBatch&, AreaShadowBatch& shadow) {
    shadow.fraction[at] = part;
}
/// With colored shadows: also the factor of the light, whose mean over the channels is the visible part.
inline void store_part(Color part, std::size_t at, LightSampleBatch& samples, AreaShadowBatch& shadow) {
    samples.filter[0][at] = part.r;
    samples.filter[1][at] = part.g;
    samples.filter[2][at] = part.b;
    shadow.fraction[at] = number::min((part.r + part.g + part.b) / 3, 1.0);
}

/// Finds the visible part of the light at each lit surface. Returns whether samples are wanted.
template <class Value>
inline bool find_visible_parts(const PreparedLight& light, const SurfaceBatch& surfaces,
                               LightSampleBatch& samples, AreaShadowBatch& shadow) {
    bool wants = false;
    for (int h = 0; h < surfaces.count; ++h) {
        const auto at = static_cast<std::size_t>(h);
        if ((lit_bits(samples, h) >> (h % lane_count<double>()) & 1) == 0) {
            store_part(Value{}, at, samples, shadow);
            continue;
        }
        const LightDifference difference(light.color, samples.strength[at]);
        VisiblePart<Value> part(light.area, shadow, h, difference);
        store_part(part.value(), at, samples, shadow);
        wants = wants || part.wants_samples();
    }
    return wants;
}

/// Traces the shadow rays to the samples of an area light. Its strength at each surface is multiplied by the
/// part that is visible; with colored shadows, LightSampleBatch::filter is that part. Surfaces that see none
/// of the light are no longer lit.
inline void sample_area_shadow(const WorldParts& world, const PreparedLight& light,
                               const SurfaceBatch& surfaces, LightSampleBatch& samples,
                               AreaShadowBatch& shadow, ShadowRayBatch& shadow_rays, SteppedRays& steps,
                               RayCounts& counts, TileRecord* record) {
    const bool colored = world.colors_shadows();
    shadow.start(light.area.count(), colored);
    while (colored ? find_visible_parts<Color>(light, surfaces, samples, shadow)
                   : find_visible_parts<double>(light, surfaces, samples, shadow)) {
        for (int sample = 0; sample < light.area.count(); ++sample) {
            trace_sample_rays(world, light, sample, surfaces, shadow, shadow_rays, steps, record);
            counts.shadow += static_cast<std::uint64_t>(shadow_rays.count);
        }
    }
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        std::uint8_t& lit = samples.lit[static_cast<std::size_t>(h / lane_count<double>())];
        if (lit == 0) continue;
        const auto at = static_cast<std::size_t>(h);
        const Doubles fraction = load(shadow.fraction.data() + at);
        lit = static_cast<std::uint8_t>(lit & to_bits(fraction > Doubles(0)));
        if (!colored) store(load(samples.strength.data() + at) * fraction, samples.strength.data() + at);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
