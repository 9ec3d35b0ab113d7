// SPDX-License-Identifier: Apache-2.0
// Textures that are so fine that they are noise.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check/checks.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr std::size_t k_textured_pixels = 4096;  // pixels in which textures are looked at
constexpr std::size_t k_min_hits = 20;           // of them, of one texture
constexpr double k_max_texels = 20;              // along the longer side of a sample of a pixel
constexpr double k_max_deviation = 0.08;         // of the colors of a pixel's samples
constexpr int k_places_in_pixel = 16;
constexpr std::int32_t k_alpha_picture = 160;  // longest side of the pictures with and without alpha
constexpr double k_min_changed = 0.1;          // of the texture's pixels: those that its alpha changes

double middle_of(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// By pixel that shows a texture: the texels along the longer side of a sample, and how much the pixel's color
// and its opacity are off because it has few samples.
struct Fineness {
    std::vector<double> texels, color, opacity;
};

// A hit, and those of the rays that are one pixel of the picture to the right of its ray, and below it.
struct PixelHits {
    const SurfaceHit* here;
    std::array<const SurfaceHit*, 2> beside{};
};

double deviation_of(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    const auto count = static_cast<double>(values.size());
    for (const double value : values) sum += value;
    for (const double value : values) squares += (value - sum / count) * (value - sum / count);
    return number::sqrt(squares / count);
}

// What a texture shows at some places of a pixel: three channels, and the opacity.
using SeenValues = std::array<std::vector<double>, 4>;

// x, y: from a pixel to the next ones.
SeenValues values_in_pixel(const PreparedTexture& texture, TexturePlace at, TexturePlace x, TexturePlace y) {
    SeenValues values;
    for (int i = 0; i < k_places_in_pixel; ++i) {
        // The R2 sequence: in a grid, many places would have one u or one v.
        const double a = 0.7548776662466927 * i, b = 0.5698402909980532 * i;
        const double right = a - std::floor(a) - 0.5, down = b - std::floor(b) - 0.5;
        const auto sample =
            sample_texture(texture, {at.u + right * x.u + down * y.u, at.v + right * x.v + down * y.v});
        if (!sample) continue;
        const double shown[4] = {sample->color.r, sample->color.g, sample->color.b,
                                 texture.opacity(sample->alpha)};
        for (std::size_t c = 0; c < 4; ++c) values[c].push_back(shown[c]);
    }
    return values;
}

// The most that a texture's color of 1 adds to a channel.
double color_factor(const WorldParts& world, const SurfaceHit& hit, const PreparedTexture& texture) {
    if (texture.mix == TextureMix::replace) return 1;
    const double* const values = world.material(hit.material);
    double factor = 0;
    for (int c = 0; c < 3; ++c) factor = number::max(factor, values[k_ambient + c] + values[k_diffuse + c]);
    return number::min(factor, 1.0);
}

void add_fineness(const WorldParts& world, const PixelHits& hits, Fineness& to) {
    const PreparedTexture& texture = *world.texture_of(hits.here->material);
    const auto place_of = [&](const SurfaceHit& hit) {
        return texture_place(*world.geometry, texture, hit.surface, hit.point);
    };
    const auto at = place_of(*hits.here), right = place_of(*hits.beside[0]),
               below = place_of(*hits.beside[1]);
    if (!texture.image || !at || !right || !below || !sample_texture(texture, *at)) return;
    const TexturePlace x{right->u - at->u, right->v - at->v}, y{below->u - at->u, below->v - at->v};
    const double samples = world.settings.samples;
    const auto texels = [&](TexturePlace way) {
        return length(Vec3{way.u * texture.image->width, way.v * texture.image->height, 0});
    };
    const SeenValues values = values_in_pixel(texture, *at, x, y);
    double color = 0, opacity = 0;
    if (!values[3].empty()) {
        double sum = 0;
        for (const double part : values[3]) sum += part;
        for (std::size_t c = 0; c < 3; ++c) color = number::max(color, deviation_of(values[c]));
        color *= color_factor(world, *hits.here, texture) * sum / static_cast<double>(values[3].size());
        opacity = deviation_of(values[3]);
    }
    to.texels.push_back(number::max(texels(x), texels(y)) / samples);
    to.color.push_back(color / samples);
    to.opacity.push_back(opacity / samples);
}

// Whether it matters where the texture is transparent: what is behind it looks different.
bool shows_alpha(CheckContext& context, const VisibleHits& visible, std::size_t texture) {
    World opaque = context.prepared();
    WorldAccess::own(opaque).textures.own()[texture].alpha = TextureAlpha::ignore;
    const Image with = context.render_small(k_alpha_picture),
                without = context.render_small(opaque, k_alpha_picture);
    std::size_t rays = 0;
    for (const SurfaceHit& hit : visible.seen())
        rays += context.world().texture_of(hit.material) == &(*context.world().textures)[texture] ? 1 : 0;
    const double pixels = static_cast<double>(rays) / static_cast<double>(visible.rays()) * with.width *
                          static_cast<double>(with.height);
    const auto changed = static_cast<double>(count_differing(with, without, k_max_deviation));
    return changed > 0 && changed >= k_min_changed * pixels;
}

}  // namespace

void check_texture_fineness(CheckContext& context, const VisibleHits& visible) {
    const WorldParts& world = context.world();
    if (world.settings.shading == Shading::normals) return;
    std::vector<PixelHits> hits;
    for (const SurfaceHit& hit : visible.seen())
        if (world.texture_of(hit.material) != nullptr) hits.push_back({&hit});
    const std::size_t step = hits.size() / k_textured_pixels + 1;
    PixelPositions beside[2];
    std::size_t kept = 0;
    const double pixel = static_cast<double>(visible.size.width) / world.settings.width;
    for (std::size_t i = 0; i < hits.size(); i += step) {
        hits[kept++] = hits[i];
        const auto width = static_cast<std::size_t>(visible.size.width);
        const auto x = static_cast<double>(hits[i].here->ray % width),
                   y = static_cast<double>(hits[i].here->ray / width);
        beside[0].add(x + pixel, y);
        beside[1].add(x, y + pixel);
    }
    if (kept < k_min_hits) return;
    hits.resize(kept);
    WorldParts of_size = world;
    set_size(of_size, visible.size);
    SurfaceRecord found[2];
    for (std::size_t way = 0; way < 2; ++way) {
        found[way] = follow_pixels(of_size, beside[way], 1, context.threads());
        for (const SurfaceHit& hit : found[way][0])
            if (hit.shape == hits[hit.ray].here->shape) hits[hit.ray].beside[way] = &hit;
    }
    std::map<std::size_t, Fineness> textures;
    for (const PixelHits& pixel_hits : hits) {
        if (pixel_hits.beside[0] == nullptr || pixel_hits.beside[1] == nullptr) continue;
        const auto index = world.texture_of(pixel_hits.here->material) - world.textures->data();
        add_fineness(world, pixel_hits, textures[static_cast<std::size_t>(index)]);
    }
    for (auto& [index, fineness] : textures) {
        if (fineness.texels.size() < k_min_hits) continue;
        const double texels = middle_of(fineness.texels), color = middle_of(fineness.color),
                     opacity = middle_of(fineness.opacity);
        if (!(texels > k_max_texels)) continue;
        const bool has_color_noise = color > k_max_deviation;
        if (!has_color_noise && !(opacity > k_max_deviation && shows_alpha(context, visible, index)))
            continue;
        const auto number = static_cast<std::uint32_t>(index);
        const double samples = world.settings.samples;
        context.report(
            "texture-too-fine", context.at_texture(number),
            fmt::format("{} is so fine that it is noise in this picture: about {:.{}f} texels lie along the "
                        "side of a "
                        "pixel; their {} by {:.0f} of 255 from their mean, and the pixel shows {}",
                        context.texture(number), texels * samples, texels * samples < 9.5 ? 1 : 0,
                        has_color_noise ? "colors differ" : "alpha differs",
                        255 * samples * (has_color_noise ? color : opacity),
                        samples > 1 ? fmt::format("{:.0f} of them", samples * samples) : "one of them"),
            "enlarge it: smaller numbers in `uv_map` or of the texture coordinates, or a larger `scale`; or "
            "give it a picture of fewer texels");
    }
}

}  // namespace glint
