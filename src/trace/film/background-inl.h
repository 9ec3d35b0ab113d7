// SPDX-License-Identifier: Apache-2.0
// What rays see that hit nothing: the background, or its gradient.
#if defined(GLINT_TRACE_BACKGROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_BACKGROUND_INL_H_
#undef GLINT_TRACE_BACKGROUND_INL_H_
#else
#define GLINT_TRACE_BACKGROUND_INL_H_
#endif

#include "simd/vec3-inl.h"
#include "trace/batches.h"
#include "world/appearance/color_map.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Whether the background differs from ray to ray.
HWY_INLINE bool has_gradient(const WorldParts& world) {
    return world.gradient.has_value() && world.settings.shading != Shading::normals;
}

/// Whether all camera rays that hit nothing see the same.
HWY_INLINE bool is_background_uniform(const WorldParts& world) {
    return !has_gradient(world) && world.interiors.cutting.empty() &&
           !(world.fog && world.fog->is_on_ground());
}

/// Whether the rays at the limit of reflections see the part of the background that is in the direction of
/// the rays before them, seen from where these start (Tachyon).
HWY_INLINE bool sees_back(const WorldParts& world) {
    return has_gradient(world) && world.conventions.limit == LimitRule::background;
}

/// The color of rays that hit nothing, without gradient.
HWY_INLINE Color miss_color(const WorldParts& world) {
    return world.settings.shading == Shading::normals ? Color{0, 0, 1} : world.background;
}

/// The colors of a map at a vector of numbers.
HWY_NOINLINE inline Vector3<Doubles> map_colors(const std::vector<TextureColor>& map, Doubles v) noexcept {
    alignas(k_ray_alignment) double at[lane_count<double>()], columns[3][lane_count<double>()];
    store(v, at);
    for (int k = 0; k < lane_count<double>(); ++k) {
        const Color color = map_color(map, at[k], TextureFilter::bilinear).color;
        columns[0][k] = color.r, columns[1][k] = color.g, columns[2][k] = color.b;
    }
    return {load(columns[0]), load(columns[1]), load(columns[2])};
}

/// The colors of a vector of rays that hit nothing.
HWY_INLINE Vector3<Doubles> gradient_color(const BackgroundGradient& gradient, const RayBatch& rays,
                                           int ray) {
    Vector3<Doubles> from = load_vector3(rays.direction, ray);
    if (gradient.kind == GradientKind::sphere) {
        from = normalize(from);
    } else {
        // A ray that goes straight through a surface starts there.
        const Vector3<Doubles> origin = load_vector3(rays.origin, ray);
        const bool passed = rays.transparent && rays.generation > 0;
        from = passed ? origin + from * load(rays.start.data() + ray) : origin;
    }
    Doubles v = (dot(from, lanes_of(gradient.up)) - Doubles(gradient.bottom)) /
                Doubles(gradient.top - gradient.bottom);
    if (gradient.repeats) {
        const Doubles nearest = round_to_integer(v);
        v = v - select(nearest > v, nearest - Doubles(1), nearest);
    }
    v = min(max(v, Doubles(0)), Doubles(1));
    if (!gradient.color_map.empty()) return map_colors(gradient.color_map, v);
    return lanes_of(gradient.top_color) * v + lanes_of(gradient.bottom_color) * (Doubles(1) - v);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
