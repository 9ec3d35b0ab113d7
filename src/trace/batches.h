// SPDX-License-Identifier: Apache-2.0
#pragma once
// The batches that the stages of a tile read and write, each with its columns. Entry i of all columns of a
// batch belongs to the same ray, hit or highlight. docs/architecture.md lists the stages.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/rays.h"
#include "glint/layers.h"
#include "glint/tiles.h"
#include "glint/vec.h"
#include "trace/columns.h"

namespace glint {

inline constexpr int k_tile_pixels = k_tile_side * k_tile_side;
/// Rays that are traced together, at most: a stream.
inline constexpr int k_stream_size = k_tile_pixels;
/// Rays of a stream whose hits are shaded together, at most: their columns stay in the first-level cache.
inline constexpr int k_batch_size = 256;
/// The distance from a pixel of a layer of the film to the same pixel of the next layer.
inline constexpr int k_layer_stride = k_tile_pixels + k_ray_padding;

template <class T> using StreamColumn = FixedColumn<T, k_stream_size>;
template <class T> using BatchColumn = FixedColumn<T, k_batch_size>;

/// The columns of rays that wait to be traced. Column: GrowingColumn, or a pointer into one.
template <class Column> struct RayFields {
    Column origin[3], direction[3], t_min, t_max;
    // Of secondary rays only. Camera rays have weight 1, the order of their pixels, and start in air.
    Column weight[3];
    Column target;  // the pixel in the tile; + k_layer_stride: its light goes to the transmission layer
    Column medium;  // with Beer's law: the material that the ray travels in; k_none: air
};

/// Calls visit(column...) for each column, with the same column of all arguments.
template <class Visit, class... Columns> void for_each_column(const Visit& visit, Columns&... of) {
    for (int c = 0; c < 3; ++c) visit(of.origin[c]...);
    for (int c = 0; c < 3; ++c) visit(of.direction[c]...);
    visit(of.t_min...);
    visit(of.t_max...);
    for (int c = 0; c < 3; ++c) visit(of.weight[c]...);
    visit(of.target...);
    visit(of.medium...);
}

/// The rays of one generation, in groups: a pixel has at most one ray in a group, and its groups come in the
/// order in which its light is added up.
class RayBatch : public RayFields<GrowingColumn> {
  public:
    int generation = 0;
    int count = 0;

    void clear() {
        count = 0;
        group_ends_.clear();
    }
    /// Makes room for this many rays and their padding.
    void reserve(int rays) {
        ensure_capacity(rays);
        uniform_rays_ = 0;
    }
    /// Begins with camera rays that share these numbers. They are written unless they are still here, from a
    /// tile whose rays all missed.
    void start_uniform(int rays, Vec3 shared_origin, double shared_t_min, double shared_t_max);

    /// Where ray `count` is to be written, within what is reserved.
    RayFields<double*> end();
    /// The rays since the last group become one.
    void end_group() {
        if (group_ends_.empty() ? count > 0 : group_ends_.back() < count) group_ends_.push_back(count);
    }
    /// Moves the rays of the other batch to the end of this one, as a group.
    void append_group(RayBatch& other);

    /// The number of the group that a ray belongs to.
    std::size_t group_of(int ray) const {
        return static_cast<std::size_t>(std::upper_bound(group_ends_.begin(), group_ends_.end(), ray) -
                                        group_ends_.begin());
    }
    /// The ray after the group's last.
    int group_end(std::size_t group) const { return group_ends_[group]; }

    /// The rays from number `first` on.
    RaySpan span(int first) const {
        const auto at = [&](const GrowingColumn& column) { return column.data() + first; };
        return {at(origin[0]),    at(origin[1]),    at(origin[2]), at(direction[0]),
                at(direction[1]), at(direction[2]), at(t_min),     at(t_max)};
    }

  private:
    void ensure_capacity(int rays) {
        const auto needed = static_cast<std::size_t>(rays) + k_ray_padding;
        if (t_min.size() >= needed) return;
        for_each_column([&](GrowingColumn& column) { column.resize(2 * needed); }, *this);
        uniform_rays_ = 0;
    }

    std::array<double, 5> uniform_{};  // see start_uniform
    int uniform_rays_ = 0;             // so many have them
    std::vector<int> group_ends_;
};

/// The nearest hits of a stream: entry i is of ray first + i of a RayBatch.
struct HitBatch {
    int first = 0;
    int count = 0;
    StreamColumn<double> t;            // the ray's t_max if it misses
    StreamColumn<std::uint32_t> slot;  // k_none if it misses
};

/// Entries [begin, end) of a HitBatch, at most k_batch_size: the rays whose hits are shaded together.
struct RayRange {
    int begin, end;
};

/// The surface points that rays hit, without the rays that miss, in the order of their rays.
struct SurfaceBatch {
    int generation = 0;  // of the rays
    int count = 0;

    // A group of rays (RayBatch) ends before this entry of the HitBatch and this entry of the batch.
    struct GroupEnd {
        int rays, hits;
    };
    int groups = 0;
    std::array<GroupEnd, k_batch_size> group_end;

    BatchColumn<std::uint32_t> slot, material;
    BatchColumn<double> behind;                     // 1: the ray came from behind the shape's normal; else 0
    BatchColumn<double> hit_t;                      // with Beer's law
    BatchColumn<double> weight[3], target, medium;  // of the ray (RayFields)
    BatchColumn<double> point[3], normal[3], incoming[3], to_eye[3], magnitude;
};

/// The diffuse and specular light of the surfaces: sums over the lights.
struct RadianceBatch {
    BatchColumn<double> diffuse[3], specular[3];
};

/// One light as the surfaces see it.
struct LightSampleBatch {
    BatchColumn<double> n_l, s, attenuation;  // N·L; R·V or N·H; f_att
    BatchColumn<std::uint8_t> lit;            // a vector of surfaces: a bit each, the light may add something
};

/// The highlights of one light that are not zero, one after the other.
struct HighlightBatch {
    BatchColumn<double> power, shininess;  // S^n; n
};

/// The shadow rays of one light, in the order of the surfaces that it may light.
struct ShadowRayBatch {
    int count = 0;
    BatchColumn<double> origin[3], direction[3], t_min, t_max;
    BatchColumn<std::uint8_t> occluded;  // 1: something is between the surface and the light; else 0

    RaySpan span() const {
        return {origin[0].data(),    origin[1].data(),    origin[2].data(), direction[0].data(),
                direction[1].data(), direction[2].data(), t_min.data(),     t_max.data()};
    }
};

/// The mirror and glass rays that leave the surfaces.
struct SecondaryRayBatch {
    RayBatch rays;         // the next generation
    RayBatch transmitted;  // of the group at hand: they follow its mirror rays
    std::array<std::int32_t, k_tile_pixels>
        of_pixel;  // how many the sample of a pixel has: k_max_sample_rays
};

/// The light of the pixels: sums over the samples, by layer and pixel. Pixels have the order of the camera
/// rays, without gaps.
struct Film {
    alignas(k_ray_alignment) std::array<double, k_light_layers * k_layer_stride> channel[3];
    std::array<bool, k_light_layers> touched;  // others count as 0, whatever they hold

    void clear() { touched.fill(false); }
    /// To be called before anything is added to a layer.
    void touch(Layer layer) {
        if (touched[static_cast<std::size_t>(layer)]) return;
        touched[static_cast<std::size_t>(layer)] = true;
        for (auto& sums : channel) {
            const auto first = sums.begin() + static_cast<int>(layer) * k_layer_stride;
            std::fill(first, first + k_layer_stride, 0.0);
        }
    }
    double* of(Layer layer, int c) { return channel[c].data() + static_cast<int>(layer) * k_layer_stride; }
    const double* of(Layer layer, int c) const {
        return channel[c].data() + static_cast<int>(layer) * k_layer_stride;
    }
};

/// What the layers show of the first surfaces, by pixel of the tile. Empty unless asked for.
struct FirstHits {
    std::vector<double> normal[3], position[3], albedo[3], depth, object, material;
    std::vector<double> tested, occluded;  // lights, over the samples
    bool wanted = false;
    bool is_middle = false;  // the sample at hand is the middle one
};

inline void RayBatch::start_uniform(int rays, Vec3 shared_origin, double shared_t_min, double shared_t_max) {
    clear();
    ensure_capacity(rays);
    const std::array<double, 5> numbers{shared_origin.x, shared_origin.y, shared_origin.z, shared_t_min,
                                        shared_t_max};
    using Bits = std::array<std::uint64_t, 5>;  // -0 is not 0
    if (uniform_rays_ >= rays && std::bit_cast<Bits>(numbers) == std::bit_cast<Bits>(uniform_)) return;
    GrowingColumn* const to[] = {&origin[0], &origin[1], &origin[2], &t_min, &t_max};
    for (std::size_t i = 0; i < numbers.size(); ++i) std::fill_n(to[i]->begin(), rays, numbers[i]);
    uniform_ = numbers;
    uniform_rays_ = rays;
}

inline RayFields<double*> RayBatch::end() {
    RayFields<double*> at;
    for_each_column([&](double*& to, GrowingColumn& column) { to = column.data() + count; }, at, *this);
    return at;
}

inline void RayBatch::append_group(RayBatch& other) {
    if (other.count == 0) return;
    reserve(count + other.count);
    for_each_column(
        [&](GrowingColumn& to, const GrowingColumn& from) {
            std::copy_n(from.begin(), other.count, to.begin() + count);
        },
        *this, other);
    count += other.count;
    other.clear();
    end_group();
}

}  // namespace glint
