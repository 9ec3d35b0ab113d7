// A tile from its camera rays to its pixels: nearest hit, surface, light, next rays, again.
#if defined(GLINT_TRACE_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_TILE_INL_H_
#undef GLINT_TRACE_TILE_INL_H_
#else
#define GLINT_TRACE_TILE_INL_H_
#endif

#include "trace/branch-inl.h"
#include "trace/camera_rays-inl.h"
#include "trace/hit_declarations-inl.h"
#include "trace/light-inl.h"
#include "trace/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

HWY_INLINE void add_to(TileScratch& s, std::uint32_t pixel, int layer, Color c) {
    double* sum = s.pixels[pixel].data() + 3 * layer;
    sum[0] += c.r, sum[1] += c.g, sum[2] += c.b;
}

/// The layer of light found along a ray: its own, before the first branch.
HWY_INLINE int layer_of(Branch branch, Layer own) {
    if (branch == Branch::camera) return own;
    return branch == Branch::reflected ? k_layer_reflected : k_layer_transmitted;
}

/// What the rays that hit nothing see.
inline void add_misses(const World& world, TileScratch& s, int first, int count) {
    for (int i = 0; i < count; ++i) {
        if (s.slot[i] != k_none) continue;
        const RayPath& path = s.rays.path(first + i);
        if (path.branch != Branch::camera && world.conventions.mirror_miss == MissRule::black) continue;
        const Color seen = world.settings.shading == Shading::normals ? Color{0, 0, 1} : world.background;
        add_to(s, path.pixel, layer_of(path.branch, k_layer_background), path.weight * seen);
    }
}

/// Shading modes that look no further than the first surface.
inline void add_unlit(const World& world, TileScratch& s, int first) {
    for (int h = 0; h < s.hits; ++h) {
        const double* material = material_of(world, s.material[h]);
        Color c = material_color(material, k_color);
        if (world.settings.shading == Shading::normals) {
            c = Color{s.normal[0][h] + 1, s.normal[1][h] + 1, s.normal[2][h] + 1} * 0.5;
        }
        add_to(s, s.rays.path(first + s.ray[h]).pixel, k_layer_ambient, c);
    }
}

/// Adds the hits' light to their pixels, weighted.
inline void add_hits(const World& world, TileScratch& s, int first, int generation) {
    for (int h = 0; h < s.hits; ++h) {
        const RayPath& path = s.rays.path(first + s.ray[h]);
        const double* material = material_of(world, s.material[h]);
        const Color weight = path.weight * local_share(world, material, generation);
        const Color ambient = material_color(material, k_ambient) * world.ambient;
        const Color diffuse{s.diffuse[0][h], s.diffuse[1][h], s.diffuse[2][h]};
        const Color specular{s.specular[0][h], s.specular[1][h], s.specular[2][h]};
        add_to(s, path.pixel, layer_of(path.branch, k_layer_ambient), weight * ambient);
        add_to(s, path.pixel, layer_of(path.branch, k_layer_diffuse), weight * diffuse);
        add_to(s, path.pixel, layer_of(path.branch, k_layer_specular), weight * specular);
    }
}

/// The pixel's fold (docs/architecture.md): each layer averaged over the samples and rounded to float, then
/// background + ambient + diffuse + specular + reflected + transmitted, in that order.
inline void fold_pixels(const World& world, const TileJob& job, const TileScratch& s) {
    const double samples = static_cast<double>(world.settings.samples) * world.settings.samples;
    for (int y = 0; y < job.height; ++y) {
        for (int x = 0; x < job.width; ++x) {
            const auto& pixel = s.pixels[static_cast<std::size_t>(y * k_tile_side + x)];
            float* rgb =
                job.rgb + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(job.row_pixels) +
                               static_cast<std::size_t>(x));
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (int layer = 0; layer < k_layers; ++layer) {
                    double part = pixel[static_cast<std::size_t>(3 * layer + c)] / samples;
                    if (!(part == part)) part = 0;  // no NaN reaches the film
                    sum += static_cast<float>(number::min(number::max(part, -1e30), 1e30));
                }
                rgb[c] = sum;
            }
        }
    }
}

void render_tile(const World& world, const TileJob& job, TileScratch& s) {
    const Shading shading = world.settings.shading;
    const bool lit = shading != Shading::color && shading != Shading::normals;
    for (auto& pixel : s.pixels) pixel.fill(0);
    for (int j = 0; j < world.settings.samples; ++j) {
        for (int i = 0; i < world.settings.samples; ++i) {
            make_camera_rays(world, job, i, j, s.rays);
            s.counts.camera += static_cast<std::uint64_t>(s.rays.size());
            s.sample_rays.fill(0);
            for (int generation = 0; s.rays.size() > 0; ++generation) {
                s.next_rays.clear();
                for (int first = 0; first < s.rays.size(); first += k_stream) {
                    const int count = number::min(k_stream, s.rays.size() - first);
                    nearest_hit(world, s.rays.rays(first), count, k_beam, s.t.data(), s.slot.data());
                    add_misses(world, s, first, count);
                    find_surfaces(world, s, first, count);
                    absorb(world, s, first);
                    if (lit) {
                        light_hits(world, s);
                        add_hits(world, s, first, generation);
                        queue_branches(world, s, first, generation);
                    } else {
                        add_unlit(world, s, first);
                    }
                }
                std::swap(s.rays, s.next_rays);
            }
        }
    }
    fold_pixels(world, job, s);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
