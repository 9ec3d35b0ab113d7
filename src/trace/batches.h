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
#include "trace/hits/hit_columns.h"

namespace glint {

inline constexpr int k_tile_pixels = k_tile_side * k_tile_side;
/// Rays that are traced together, at most: a stream.
inline constexpr int k_stream_size = k_tile_pixels;
/// Rays of a stream whose hits are shaded together, at most: their columns stay in the first-level cache.
inline constexpr int k_batch_size = 256;
/// The distance between the entries of one pixel in two consecutive layers of the film.
inline constexpr int k_layer_stride = k_tile_pixels + k_ray_padding;

/// The least t of rays that start at the limit of reflections, with LimitRule::background: they hit nothing.
inline constexpr double k_blind_t_min = 1e36;

template <class T> using StreamColumn = FixedColumn<T, k_stream_size>;
template <class T> using BatchColumn = FixedColumn<T, k_batch_size>;

/// The columns of rays to be traced. Column: GrowingColumn, or a pointer into one.
template <class Column> struct RayFields {
    Column origin[3], direction[3], t_min, t_max;
    // Only for secondary rays. Camera rays have weight 1, are in the order of their pixels, and start in air.
    Column weight[3];
    Column target;    // the pixel in the tile; + k_layer_stride: light is added to the transmission layer
    Column straight;  // if alpha is wanted: 1 if the path has no mirror ray, else 0
    // If the scene has transparent surfaces: t where the ray starts on its line (0 unless it goes straight
    // through a surface), its generation by the conventions, and the transparent surfaces shaded before.
    Column start, level, passed;
    Column medium;  // for Beer's law: the index of the material inside which the ray travels; k_none: air
    Column path;    // for sampled numbers: the path of math/sample_hash.h
    // Of all rays, if tracked: the objects that the ray is inside (Interiors), and the last one of them
    // (pass_surface() of trace/secondary/transparent_refraction-inl.h).
    Column interiors;
};

/// Calls visit(column...) for each column, with the same column of all arguments. Inlined, so that the
/// columns that the caller does not use cost nothing.
template <class Visit, class... Columns>
[[gnu::always_inline]] inline void for_each_column(const Visit& visit, Columns&... of) {
    for (int c = 0; c < 3; ++c) visit(of.origin[c]...);
    for (int c = 0; c < 3; ++c) visit(of.direction[c]...);
    visit(of.t_min...);
    visit(of.t_max...);
    for (int c = 0; c < 3; ++c) visit(of.weight[c]...);
    visit(of.target...);
    visit(of.straight...);
    visit(of.start...);
    visit(of.level...);
    visit(of.passed...);
    visit(of.medium...);
    visit(of.path...);
    visit(of.interiors...);
}

/// The rays of one generation, in groups. A pixel has at most one ray in each group. The order of the groups
/// is the order in which the light of a pixel is summed.
class RayBatch : public RayFields<GrowingColumn> {
  public:
    int generation = 0;
    int count = 0;
    bool alpha = false;        // alpha is wanted
    bool transparent = false;  // the scene has transparent surfaces
    bool hashed = false;       // hashes are wanted (trace/rays/ray_hash-inl.h)
    bool tracked = false;      // rays know the objects that they are inside (Interiors)

    void clear() {
        count = 0;
        group_ends_.clear();
    }
    /// Allocates memory for this number of rays and their padding.
    void reserve(int rays) {
        ensure_capacity(rays);
        uniform_rays_ = 0;
    }
    /// Starts a batch of camera rays with these common values. Skips writing them if the batch still holds
    /// them, as after a tile whose rays all missed.
    void start_uniform(int rays, Vec3 shared_origin, double shared_t_min, double shared_t_max);

    /// The entry after the last ray, where the next ray is written. It must have been reserved.
    RayFields<double*> end();
    /// Makes a group of the rays after the last group.
    void end_group() {
        if (group_ends_.empty() ? count > 0 : group_ends_.back() < count) group_ends_.push_back(count);
    }
    /// Moves the rays of the other batch to the end of this batch, as one group.
    void append_group(RayBatch& other);

    /// The index of a ray's group.
    std::size_t group_of(int ray) const {
        return static_cast<std::size_t>(std::upper_bound(group_ends_.begin(), group_ends_.end(), ray) -
                                        group_ends_.begin());
    }
    /// The index after the group's last ray.
    int group_end(std::size_t group) const { return group_ends_[group]; }

    /// The rays from index `first`.
    RaySpan span(int first) const {
        const auto at = [&](const GrowingColumn& column) { return column.data() + first; };
        return {at(origin[0]),    at(origin[1]),    at(origin[2]), at(direction[0]),
                at(direction[1]), at(direction[2]), at(t_min),     at(t_max)};
    }

  private:
    void ensure_capacity(int rays) {
        const auto needed = static_cast<std::size_t>(rays) + k_ray_padding;
        if (t_min.size() < needed) grow(2 * needed);
    }
    void grow(std::size_t size) {
        for_each_column([&](GrowingColumn& column) { column.resize(size); }, *this);
        uniform_rays_ = 0;
    }

    std::array<double, 5> uniform_{};  // see start_uniform
    int uniform_rays_ = 0;             // the number of rays with these values
    std::vector<int> group_ends_;
};

/// The nearest hits of a stream. Entry i belongs to ray first + i of a RayBatch.
struct HitBatch {
    int first = 0;
    int count = 0;
    StreamColumn<double> t;                     // t_max for a miss
    StreamColumn<std::uint32_t> slot, element;  // of the surface; k_none and 0 for a miss

    HitColumns columns() { return {t.data(), slot.data(), element.data()}; }
    SurfaceId surface(int i) const {
        return {slot[static_cast<std::size_t>(i)], element[static_cast<std::size_t>(i)]};
    }
};

/// Entries [begin, end) of a HitBatch, at most k_batch_size, whose hits are shaded together.
struct RayRange {
    int begin, end;
};

/// The surface points at the hits, in the order of the rays. Rays that miss are omitted.
struct SurfaceBatch {
    int generation = 0;  // of the rays
    int count = 0;
    bool alpha = false, transparent = false, hashed = false, tracked = false;  // as in RayBatch

    // The end of a group of rays (RayBatch): the index after its last entry in the HitBatch, and here.
    struct GroupEnd {
        int rays, hits;
    };
    int groups = 0;
    std::array<GroupEnd, k_batch_size> group_end;

    BatchColumn<std::uint32_t> slot, material;
    BatchColumn<std::uint32_t> element;  // 0 throughout if no shape has several (start())
    // The values of the materials as lighting reads them (MaterialLanes): hit h has row[h] of `rows`. These
    // are the World's rows and `material`, or, in scenes with colors by shape, the two columns below.
    const double* rows = nullptr;
    const std::uint32_t* row = nullptr;
    std::vector<double> colored_rows;
    BatchColumn<std::uint32_t> colored_row;
    // The same for the values of the second table (ExtendedLanes): with textures that have alpha or color the
    // emission, as colored_row.
    const double* extended = nullptr;
    const std::uint32_t* extended_row = nullptr;
    std::vector<double> faded_rows;
    BatchColumn<double> behind;  // 1: the ray hit the back of the shape; else 0
    // For Beer's law, fog, fading and sees_back(): t of the hit, from RayFields::start on.
    BatchColumn<double> hit_t;
    BatchColumn<double> fog[3], visibility;  // the fog's weighted light, and f; if the scene has fog
    BatchColumn<double> straight;            // the ray's, if alpha is wanted
    // If the scene has transparent surfaces: the ray's origin, its t here, and RayFields.
    BatchColumn<double> origin[3], t, level, passed;
    BatchColumn<double> interiors;                  // the ray's, if tracked
    BatchColumn<double> path, hash;                 // the ray's, if hashes are wanted: 32-bit words
    BatchColumn<double> weight[3], target, medium;  // the ray's (RayFields)
    BatchColumn<double> point[3], normal[3], incoming[3], to_eye[3], magnitude;

    /// Before the surfaces of a World's tile are collected.
    void start(bool has_elements) {
        if (!has_elements) element.fill(0);
    }
    SurfaceId surface(int h) const {
        return {slot[static_cast<std::size_t>(h)], element[static_cast<std::size_t>(h)]};
    }
};

/// The diffuse and specular light reflected by the surfaces, summed over the lights.
struct RadianceBatch {
    BatchColumn<double> diffuse[3], specular[3];
    BatchColumn<double> sky[3];  // k_d color f; if the scene has occlusion
};

/// The light from all directions that arrives at the surfaces of a stream, by samples. Its entries are the
/// surfaces in the order of their slots, so that rays that are traced together start near each other. Blocks
/// of k_batch_size entries are traced together.
struct SkyBatch {
    int count = 0;
    int first = 0;                      // the number in the stream of the first surface of the SurfaceBatch
    StreamColumn<std::uint32_t> order;  // the surface of each entry, by its number in the stream
    StreamColumn<std::uint32_t> place;  // the entry of each surface
    // Those of the surface: point, normal, incoming and magnitude; and the hash.
    static constexpr int k_normal = 3, k_incoming = 6, k_magnitude = 9;
    StreamColumn<double> surface[10], hash;
    // The sum over the samples that are not blocked: 1, or N·D. With colored shadows: times the factor of the
    // light, by channel; else the first column alone.
    StreamColumn<double> arrived[3];
    StreamColumn<double> blocked;  // the number of the others
    // Of each ray in the ShadowRayBatch: its entry, and what it adds if it is not blocked.
    BatchColumn<double> entry, cosine;

    /// Of surface h of the SurfaceBatch.
    double blocked_of(std::size_t h) const { return blocked[place[static_cast<std::size_t>(first) + h]]; }
};

/// The hashed directions of some samples of the light from all directions are sorted together: at most so
/// many. Part of the pictures if shadows are colored: the light of a surface is summed in this order.
inline constexpr int k_sky_group_samples = 64;
/// Directions are sorted by the cell of a grid of so many rows and columns.
inline constexpr int k_sky_cell_rows = 16, k_sky_cells = k_sky_cell_rows * k_sky_cell_rows;

/// Hashed directions of a block of a SkyBatch: the block's entry i of sample s at s * k_batch_size + i.
struct SkyGroup {
    int count = 0;
    GrowingColumn direction[3];
    std::vector<std::uint8_t> cell;
    std::vector<std::uint32_t> sorted;  // the places of the directions, by cell
    std::array<std::uint32_t, k_sky_cells> end;

    void start() {
        constexpr std::size_t size = std::size_t{k_sky_group_samples} * k_batch_size + k_ray_padding;
        end.fill(0);
        if (cell.size() == size) return;
        for (GrowingColumn& column : direction) column.resize(size);
        cell.resize(size);
        sorted.resize(size);
    }
};

/// The values of one light at the surfaces.
struct LightSampleBatch {
    BatchColumn<double> n_l, s, strength;  // N·L; R·V or N·H; f_att, times the spot's factor
    BatchColumn<double> phong_s;           // R·V, for second highlights only
    BatchColumn<double> filter[3];         // with colored shadows: the factor of the light
    BatchColumn<std::uint8_t> lit;         // by vector: a bit for each surface that the light may light
};

/// The nonzero highlights of one light, compacted.
struct HighlightBatch {
    BatchColumn<double> power, shininess;  // S^n; n
};

/// The shadow rays of one light, in the order of the surfaces that the light may light.
struct ShadowRayBatch {
    int count = 0;
    BatchColumn<double> origin[3], direction[3], t_min, t_max;
    bool from_light = false;             // t is 1 at the surface; else 0
    BatchColumn<std::uint8_t> occluded;  // 1: a shape is between the surface and the light; else 0
    BatchColumn<double> filter[3];       // with colored shadows: the factor of the light

    RaySpan span() const {
        return {origin[0].data(),    origin[1].data(),    origin[2].data(), direction[0].data(),
                direction[1].data(), direction[2].data(), t_min.data(),     t_max.data()};
    }
};

/// Rays that go on from hit to hit, along the same lines.
struct SteppedRays {
    int count = 0;
    BatchColumn<double> origin[3], direction[3], t_min, t_max;
    // The nearest hits, as in HitBatch.
    BatchColumn<double> t;
    BatchColumn<std::uint32_t> slot, element;
    std::array<int, k_batch_size> number;
    // By number, in worlds whose materials fade: the last surface that was passed, and its t.
    std::array<SurfaceId, k_batch_size> passed;
    BatchColumn<double> t_passed;

    /// Adds ray i of the span, from t_min on.
    void add(const RaySpan& rays, int i, double from) {
        const double values[] = {rays.ox[i], rays.oy[i], rays.oz[i], rays.dx[i], rays.dy[i], rays.dz[i]};
        const auto k = static_cast<std::size_t>(count);
        for (std::size_t c = 0; c < 3; ++c) {
            origin[c][k] = values[c];
            direction[c][k] = values[3 + c];
        }
        t_min[k] = from;
        t_max[k] = rays.t_max[i];
        number[k] = i;
        ++count;
    }
    /// Leaves out this part of t at the beginning of the last ray, or at its end.
    void leave_out(double part, bool at_end) {
        const auto k = static_cast<std::size_t>(count - 1);
        if (at_end)
            t_max[k] -= part;
        else
            t_min[k] += part;
    }
    HitColumns hits() { return {t.data(), slot.data(), element.data()}; }
    SurfaceId surface(int i) const {
        return {slot[static_cast<std::size_t>(i)], element[static_cast<std::size_t>(i)]};
    }
    Vec3 point_of(int i) const {  // of the hit
        const auto k = static_cast<std::size_t>(i);
        return Vec3{origin[0][k], origin[1][k], origin[2][k]} + direction_of(i) * t[k];
    }
    Vec3 direction_of(int i) const {  // of any length
        const auto k = static_cast<std::size_t>(i);
        return {direction[0][k], direction[1][k], direction[2][k]};
    }
    /// Lets entry `from` go on behind its hit, at t's that are greater by more than `gap`, as entry `to` <=
    /// from.
    void go_on(int from, int to, double gap = 0) {
        const auto f = static_cast<std::size_t>(from), k = static_cast<std::size_t>(to);
        for (std::size_t c = 0; c < 3; ++c) {
            origin[c][k] = origin[c][f];
            direction[c][k] = direction[c][f];
        }
        t_min[k] = t[f] + gap;
        t_max[k] = t_max[f];
        number[k] = number[f];
    }
    RaySpan span() const {
        return {origin[0].data(),    origin[1].data(),    origin[2].data(), direction[0].data(),
                direction[1].data(), direction[2].data(), t_min.data(),     t_max.data()};
    }
};

/// The samples of an area light that shines from its centre: which of them are visible from the surfaces.
/// Sets of surfaces are bits.
struct AreaShadowBatch {
    static constexpr int k_words = k_batch_size / 64;    // for the surfaces of a batch
    std::vector<std::uint64_t> wanted, traced, visible;  // [sample * k_words + surface / 64]
    /// With colored shadows: the factor of the light of visible samples, [sample * k_batch_size + surface].
    std::vector<Color> filter;
    BatchColumn<double> fraction;  // the visible part of the light, by surface

    void start(int samples, bool colored) {
        for (auto* sets : {&wanted, &traced, &visible})
            sets->assign(static_cast<std::size_t>(samples) * k_words, 0);
        if (colored && filter.size() < static_cast<std::size_t>(samples) * k_batch_size)
            filter.resize(static_cast<std::size_t>(samples) * k_batch_size);
    }
    static std::size_t word_of(int sample, int surface) {
        return static_cast<std::size_t>(sample * k_words + surface / 64);
    }
    static std::uint64_t bit_of(int surface) { return std::uint64_t{1} << (surface % 64); }
    bool is_traced(int sample, int surface) const {
        return (traced[word_of(sample, surface)] & bit_of(surface)) != 0;
    }
    bool is_visible(int sample, int surface) const {
        return (visible[word_of(sample, surface)] & bit_of(surface)) != 0;
    }
    Color& filter_of(int sample, int surface) {
        return filter[static_cast<std::size_t>(sample * k_batch_size + surface)];
    }
    const Color& filter_of(int sample, int surface) const {
        return filter[static_cast<std::size_t>(sample * k_batch_size + surface)];
    }
};

/// The mirror and glass rays that start at the surfaces.
struct SecondaryRayBatch {
    RayBatch rays;         // the next generation
    RayBatch transmitted;  // the glass rays of the current group, appended after its mirror rays
    std::array<std::int32_t, k_tile_pixels>
        of_pixel;  // the number of rays in the pixel's current sample, at most k_max_sample_rays
};

/// The light of the pixels: sums over the samples, by layer and pixel. Pixels are in the order of the camera
/// rays.
struct Film {
    alignas(k_ray_alignment) std::array<double, k_light_layers * k_layer_stride> channel[3];
    std::array<bool, k_light_layers> touched;  // the sums of other layers are uninitialised and count as 0
    // If alpha is wanted: the weights with which the background is seen, directly or through glass.
    std::array<double, k_layer_stride> transparency;

    void clear(bool alpha) {
        touched.fill(false);
        if (alpha) transparency.fill(0);
    }
    /// Must be called before light is added to a layer. The first call sets the layer to 0.
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

/// The first hits of the camera rays, by pixel of the tile, for the layers. Empty unless layers are
/// requested.
struct FirstHits {
    std::vector<double> normal[3], position[3], albedo[3], depth, object, material;
    std::vector<double> tested, occluded;         // the numbers of lights, summed over the samples
    std::vector<double> sky_tested, sky_blocked;  // the numbers of occlusion samples
    bool wanted = false;
    bool is_middle = false;  // the current sample is the middle one
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
