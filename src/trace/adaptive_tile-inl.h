// SPDX-License-Identifier: Apache-2.0
// Adaptive sampling (docs/lighting.md): one sample for each pixel, then n x n samples for those whose color
// differs from that of a neighbour.
#if defined(GLINT_TRACE_ADAPTIVE_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_ADAPTIVE_TILE_INL_H_
#undef GLINT_TRACE_ADAPTIVE_TILE_INL_H_
#else
#define GLINT_TRACE_ADAPTIVE_TILE_INL_H_
#endif

#include "trace/uniform_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The numbers of a color with one sample: with the setting alpha, alpha is the fourth, else 0.
constexpr int k_compared = 4;

/// Traces n x n samples of the listed pixels, and writes their colors to `rgb`, one after the other.
inline void trace_listed(const WorldParts& world, const TileJob& job, const PixelList& pixels, int n,
                         TileScratch& s, float* rgb) {
    if (!trace_samples(world, job, &pixels, n, s))
        add_misses(world, s.rays, s.hits, {0, s.hits.count}, s.film);
    resolve_row(s.film, static_cast<double>(n) * n, 0, pixels.count, rgb);
}

/// The tile and the pixels around it.
inline TileJob with_border(const TileJob& job) {
    TileJob wider = job;
    --wider.x;
    --wider.y;
    wider.width += 2;
    wider.height += 2;
    return wider;
}

/// The colors with one sample of the tile's pixels and of those around it.
class OneSampleColors {
  public:
    OneSampleColors(const WorldParts& world, const TileJob& job, float* memory)
        : settings_(world.settings), job_(job), memory_(memory) {}

    /// (x, y) in the tile, from -1.
    float* at(int x, int y) const { return memory_ + k_compared * ((y + 1) * (k_tile_side + 2) + x + 1); }
    void set(int x, int y, const float* rgb, float alpha) const {
        std::copy_n(rgb, 3, at(x, y));
        at(x, y)[3] = alpha;
    }

    bool is_in_picture(int x, int y) const {
        const int px = job_.x + x, py = job_.y + y;
        return px >= 0 && py >= 0 && px < settings_.width && py < settings_.height;
    }

    /// Visits the neighbours of the tile's pixels that are in the picture and not in the tile.
    template <class Visit> void for_each_on_border(const Visit& visit) const {
        for_each_around([&](int x, int y) {
            if (is_in_picture(x, y)) visit(x, y);
        });
    }

    /// Gives neighbours outside the picture the colors of the tile's pixels, which then do not differ from
    /// them.
    void fill_outside() const {
        for_each_around([&](int x, int y) {
            if (is_in_picture(x, y)) return;
            const int nearest_x = number::min(number::max(x, 0), job_.width - 1);
            const int nearest_y = number::min(number::max(y, 0), job_.height - 1);
            std::copy_n(at(nearest_x, nearest_y), k_compared, at(x, y));
        });
    }

    /// Of up to 8 pixels of a row: bit k_compared i + c is set if number c of pixel x + i differs by more
    /// than `limit` from that of a neighbour. Bits beyond `width` have no meaning. After fill_outside().
    HWY_INLINE std::uint32_t differing(int x, int y, int width, double limit) const {
        std::uint32_t bits = 0;
        for (int i = 0; i < k_compared * width; i += lane_count<double>()) {
            const Doubles own = widen(at(x, y) + i);
            const auto differs = [&](const float* other)
                                     HWY_ATTR { return abs(own - widen(other + i)) > Doubles(limit); };
            const auto differ = differs(at(x - 1, y)) || differs(at(x + 1, y)) || differs(at(x, y - 1)) ||
                                differs(at(x, y + 1));
            bits |= to_bits(differ) << i;
        }
        return bits;
    }

    /// The neighbour from which a pixel of the tile differs most.
    SampleDifference greatest_difference(int x, int y) const {
        SampleDifference greatest;
        const float* const own = at(x, y);
        constexpr int steps[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
        for (const auto& [dx, dy] : steps) {
            if (!is_in_picture(x + dx, y + dy)) continue;
            const float* const other = at(x + dx, y + dy);
            double difference = 0;
            for (int c = 0; c < k_compared; ++c) {
                const double d = static_cast<double>(own[c]) - static_cast<double>(other[c]);
                difference = number::max(difference, d < 0 ? -d : d);
            }
            if (greatest.x >= 0 && !(difference > greatest.difference)) continue;
            greatest = {job_.x + x + dx,
                        job_.y + y + dy,
                        difference,
                        {own[0], own[1], own[2]},
                        {other[0], other[1], other[2]}};
        }
        return greatest;
    }

  private:
    template <class Visit> void for_each_around(const Visit& visit) const {
        for (int x = 0; x < job_.width; ++x) visit(x, -1);
        for (int x = 0; x < job_.width; ++x) visit(x, job_.height);
        for (int y = 0; y < job_.height; ++y) visit(-1, y);
        for (int y = 0; y < job_.height; ++y) visit(job_.width, y);
    }

    const RenderSettings& settings_;
    const TileJob& job_;
    float* const memory_;
};

/// Traces one sample of each pixel around the tile, into `colors`.
inline void trace_border(const WorldParts& world, const TileJob& job, const OneSampleColors& colors,
                         TileScratch& s) {
    s.pixels.count = 0;
    colors.for_each_on_border([&](int x, int y) { s.pixels.add(job.x + x, job.y + y); });
    if (s.pixels.count == 0) return;
    float rgb[3 * 4 * k_tile_side];
    trace_listed(world, job, s.pixels, 1, s, rgb);
    std::size_t p = 0;
    colors.for_each_on_border([&](int x, int y) {
        colors.set(x, y, rgb + 3 * p, world.settings.alpha ? alpha_value(s.film, p, 1) : 0);
        ++p;
    });
}

/// Renders the pixels of s.refined with n x n samples.
inline void refine(const WorldParts& world, const TileJob& job, TileScratch& s) {
    const int n = world.settings.samples;
    float rgb[3 * k_tile_pixels];
    s.first_hits.wanted = job.layers != nullptr;
    if (s.first_hits.wanted) clear_first_hits(s.first_hits);
    trace_listed(world, job, s.refined, n, s, rgb);
    if (is_cancelled(job)) return;
    const auto for_each_pixel = [&](const auto& visit) {
        for (int p = 0; p < s.refined.count; ++p) {
            const auto i = static_cast<std::size_t>(p);
            visit(static_cast<int>(s.refined.x[i]) - job.x, static_cast<int>(s.refined.y[i]) - job.y, p);
        }
    };
    for_each_pixel([&](int x, int y, int p) {
        std::copy_n(rgb + 3 * p, 3, pixel_in(job.rgb, job.row_pixels, 3, x, y));
    });
    if (s.first_hits.wanted) write_layers(job, s.film, s.first_hits, n, for_each_pixel);
}

/// Renders the pixels of a tile. Stops early if the render is cancelled.
inline void render_adaptive_pixels(const WorldParts& world, const TileJob& job, TileScratch& s) {
    TileRecord* const record = s.record;
    if (record == nullptr && job.layers == nullptr && is_background_uniform(world) &&
        is_tile_empty(world, with_border(job))) {
        s.counts.camera += static_cast<std::uint64_t>(job.width * job.height);
        if (!job.same_refinement) s.refined.count = 0;
        return fill_background(world, job, 1);
    }
    if (job.same_refinement) {
        render_uniform_tile(world, job, 1, s);
        if (s.refined.count > 0 && !is_cancelled(job)) refine(world, job, s);
        return;
    }
    s.record = nullptr;
    const bool has_alpha = render_uniform_tile(world, job, 1, s) && world.settings.alpha;
    s.first_hits.wanted = false;
    if (is_cancelled(job)) {
        s.record = record;
        return;
    }
    const OneSampleColors colors(world, job, s.one_sample.data());
    for_each_row(job, [&](int x, int y, int first, int width) {
        for (int i = 0; i < width; ++i)
            colors.set(x + i, y, pixel_in(job.rgb, job.row_pixels, 3, x + i, y),
                       has_alpha ? alpha_value(s.film, static_cast<std::size_t>(first + i), 1) : 0);
    });
    trace_border(world, job, colors, s);
    if (is_cancelled(job)) {
        s.record = record;
        return;
    }

    s.refined.count = 0;
    colors.fill_outside();
    for_each_row(job, [&](int x, int y, int, int width) HWY_ATTR {
        const std::uint32_t bits = colors.differing(x, y, width, *world.settings.aa_threshold);
        for (int i = 0; i < width; ++i) {
            if ((bits >> (k_compared * i) & 15u) != 0) s.refined.add(job.x + x + i, job.y + y);
        }
    });
    const bool refined = s.refined.count > 0;
    s.record = record;
    if (record != nullptr) record->decide(colors.greatest_difference(0, 0), refined);
    if (refined) {
        refine(world, job, s);
    } else if (record != nullptr) {
        render_uniform_tile(world, job, 1, s);
    }
}

/// Renders a tile with adaptive sampling. A one-pixel tile of explain() is recorded with its final samples.
/// The picture's memory is written at the end, unless the render is cancelled.
inline void render_adaptive_tile(const WorldParts& world, const TileJob& picture_job, TileScratch& s) {
    float pixels[3 * k_tile_pixels];
    TileJob job = picture_job;
    job.rgb = pixels;
    job.row_pixels = k_tile_side;
    render_adaptive_pixels(world, job, s);
    if (is_cancelled(job)) return;
    for (int y = 0; y < job.height; ++y) {
        std::copy_n(pixel_in(pixels, k_tile_side, 3, 0, y), 3 * job.width,
                    pixel_in(picture_job.rgb, picture_job.row_pixels, 3, 0, y));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
