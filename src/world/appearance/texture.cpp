// SPDX-License-Identifier: Apache-2.0
#include "world/appearance/texture.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"
#include "math/number.h"
#include "math/srgb.h"
#include "math/transform.h"
#include "world/appearance/color_map.h"
#include "world/appearance/noise.h"
#include "world/appearance/patterns.h"
#include "world/geometry/mesh_surface.h"

namespace glint {
namespace {

constexpr double k_two_pi = 0x1.921fb54442d18p+2;

TexelValues make_values(int most, bool is_srgb) {
    auto values = std::make_shared<std::vector<double>>();
    values->reserve(static_cast<std::size_t>(most) + 1);
    for (int word = 0; word <= most; ++word) {
        const double linear = static_cast<double>(word) / most;
        values->push_back(is_srgb ? srgb_decode(linear) : linear);
    }
    return values;
}

// The values of 8 and of 16 bits, linear and of the sRGB curve, made when the first texture needs them.
class ValueTables {
  public:
    TexelValues of(const TextureImage& image, bool is_srgb) {
        const bool is_long = image.words.index() == 1;
        TexelValues& values = values_[is_long][is_srgb];
        if (!values) values = make_values(is_long ? 65535 : 255, is_srgb);
        return values;
    }

  private:
    TexelValues values_[2][2];
};

// Doubles of this size and larger have no fraction: they are at the border of texels.
constexpr double k_whole = 0x1p52;

// u or v in the picture, from 0 to 1 unless `once`; nothing beside it.
std::optional<double> wrapped(double x, TextureWrap wrap) {
    if (!(number::abs(x) < k_whole)) x = 0;  // no picture has texels that small; NaN too
    switch (wrap) {
        case TextureWrap::repeat:
            return x - std::floor(x);
        case TextureWrap::mirror: {
            const double pair = x - 2 * std::floor(x / 2);  // 0 to 2
            return pair > 1 ? 2 - pair : pair;
        }
        case TextureWrap::clamp:
            return x < 0 ? 0 : x > 1 ? 1 : x;
        case TextureWrap::once:
        case TextureWrap::clip:
            if (x < 0 || x > 1) return std::nullopt;
            return x;
    }
    return x;
}

// The number of a texel beside the picture's first or last.
std::int32_t neighbour(std::int32_t i, std::int32_t size, TextureWrap wrap) {
    if (i >= 0 && i < size) return i;
    if (wrap == TextureWrap::repeat) return i < 0 ? size - 1 : 0;
    return i < 0 ? 0 : size - 1;
}

// The texels along one direction: `at` from 0 to 1 in the picture.
struct Pair {
    std::array<std::int32_t, 2> texels;
    double second = 0;  // the weight of the second one
};
Pair texels_at(double at, std::uint32_t count, TextureWrap wrap, TextureFilter filter) {
    const auto size = static_cast<std::int32_t>(count);
    const double x = at * count;
    if (filter == TextureFilter::nearest) {
        const std::int32_t i = std::min(static_cast<std::int32_t>(x), size - 1);
        return {{i, i}};
    }
    const double from_middle = x - 0.5, first = std::floor(from_middle);
    const auto i = static_cast<std::int32_t>(first);
    return {{neighbour(i, size, wrap), neighbour(i + 1, size, wrap)}, from_middle - first};
}

struct Channels {
    double values[4] = {0, 0, 0, 1};
};
Channels mixed(const Channels& a, const Channels& b, double second) {
    Channels c;
    for (int i = 0; i < 4; ++i) c.values[i] = glint::mixed(a.values[i], b.values[i], second);
    return c;
}

// The weights of the second texel in the upper and in the lower row, and of the lower row.
struct TexelWeights {
    std::array<double, 2> right;
    double lower;
};
// By 1 / d, where d is the square of the distance: of the weights 1 / d and 1 / e of two, the second is d /
// (d + e) of the sum. At most one d is 0.
TexelWeights weights_by_distance(double right, double lower) {
    const double left = (1 - right) * (1 - right), upper = (1 - lower) * (1 - lower);
    right *= right, lower *= lower;
    // Squares: the left texel's distance is `right`.
    const double a = right + lower, b = left + lower, c = right + upper, d = left + upper;
    const double of_upper = (a + b) * (c * d), of_lower = (c + d) * (a * b);
    return {{a / (a + b), c / (c + d)}, of_lower / (of_upper + of_lower)};
}

Channels texel(const PreparedTexture& texture, std::int32_t column, std::int32_t row) {
    const TextureImage& image = *texture.image;
    const std::size_t first =
        (static_cast<std::size_t>(row) * image.width + static_cast<std::size_t>(column)) * image.channels();
    Channels channels;
    std::visit(
        [&](const auto& words) {
            for (std::size_t c = 0; c < 3; ++c) channels.values[c] = (*texture.colors)[words[first + c]];
            if (image.has_alpha) channels.values[3] = (*texture.alphas)[words[first + 3]];
        },
        image.words);
    return channels;
}

// u around the y axis: 0.5 at +z, 0.75 at +x.
double around(Vec3 p) { return 0.5 + atan2(p.x, p.z) / k_two_pi; }

// From 0 at -y to 1 at +y.
double up(Vec3 p) {
    const double beside = number::sqrt(p.x * p.x + p.z * p.z);
    return 0.5 + atan2(p.y, beside) * 2 / k_two_pi;
}

// The color map at u from 0 to 1.
TextureSample sample_colors(const PreparedTexture& texture, TexturePlace place, double u) {
    const MapColor found = map_color(texture.color_map, u, texture.filter);
    TextureSample sample{place, {}, {}, found.weight, 0, found.color, found.alpha};
    sample.columns = {static_cast<std::int32_t>(found.first), static_cast<std::int32_t>(found.second)};
    return sample;
}

// u and v of the surface, before Texture::uv_map.
std::optional<TexturePlace> surface_uv(const PackedGeometry& geometry, const PreparedTexture& texture,
                                       SurfaceId id, Vec3 point) {
    if (texture.needs_uv()) {
        const std::optional<Vec3> uv = mesh_texture_coordinates(geometry, id, point);
        if (!uv) return std::nullopt;
        if (!texture.from_uv) return TexturePlace{uv->x, uv->y};
        point = {uv->x, uv->y, 0};
    }
    return place_on(texture, transform_point(texture.texture_from_world, point));
}

// Whether all layers from this one on may be transparent.
bool shows_behind(std::span<const Texture> textures, const Texture& front) {
    const Texture* layer = &front;
    for (; layer->over != k_none; layer = &textures[layer->over]) {
        const bool may_be_missing = layer->needs_uv() || layer->has_wrap(TextureWrap::once);
        if (!may_be_missing && !layer->has_alpha()) return false;
    }
    return layer->has_alpha();
}

}  // namespace

std::vector<PreparedTexture> prepare_textures(std::span<const Texture> textures) {
    std::vector<PreparedTexture> prepared;
    ValueTables tables;
    for (const Texture& texture : textures) {
        PreparedTexture& p = prepared.emplace_back();
        static_cast<Texture&>(p) = texture;
        p.texture_from_world = inverse(texture.world_from_texture).value_or(Affine{});
        p.shows_behind = shows_behind(textures, texture);
        if (!texture.image) {
            if (texture.encoding == TextureEncoding::srgb)
                for (TextureColor& c : p.color_map)
                    c.color = {srgb_decode(c.color.r), srgb_decode(c.color.g), srgb_decode(c.color.b)};
            continue;
        }
        p.colors = tables.of(*texture.image, texture.encoding == TextureEncoding::srgb);
        if (texture.image->has_alpha) p.alphas = tables.of(*texture.image, false);
    }
    return prepared;
}

TexturePlace place_on(const Texture& texture, Vec3 p) {
    if (!(texture.turbulence == Vec3{})) {
        const Vec3 d = noise_displacement(texture, p), amount = texture.turbulence;
        p = p + Vec3{amount.x * d.x, amount.y * d.y, amount.z * d.z};
    }
    switch (texture.mapping) {
        case TextureMapping::spherical:
            return TexturePlace{around(p), up(p)};
        case TextureMapping::cylindrical:
            return TexturePlace{around(p), p.y};
        case TextureMapping::checker:
            return TexturePlace{checker(p), 0};
        case TextureMapping::onion:
            return TexturePlace{length(p), 0};
        case TextureMapping::rings:
            return TexturePlace{number::sqrt(p.x * p.x + p.z * p.z), 0};
        case TextureMapping::boxes:
            return TexturePlace{
                number::max(number::max(number::abs(p.x), number::abs(p.y)), number::abs(p.z)), 0};
        case TextureMapping::slabs:
            return TexturePlace{number::abs(p.x), 0};
        case TextureMapping::leopard:
            return TexturePlace{leopard(p), 0};
        case TextureMapping::bricks:
            return TexturePlace{bricks(p, texture.mortar), 0};
        case TextureMapping::hexagons:
            return TexturePlace{hexagons(p), 0};
        case TextureMapping::noise:
            return TexturePlace{noise_pattern(p), 0};
        case TextureMapping::granite:
            return TexturePlace{granite(p), 0};
        case TextureMapping::wrinkles:
            return TexturePlace{wrinkles(p), 0};
        case TextureMapping::spiral:
            return TexturePlace{number::sqrt(p.x * p.x + p.z * p.z) + p.y, around(p)};
        case TextureMapping::mandelbrot:
            return TexturePlace{mandelbrot(p, texture.iterations), 0};
        case TextureMapping::planar:
        case TextureMapping::uv:
            break;
    }
    return TexturePlace{p.x, p.y};
}

std::optional<TexturePlace> texture_place(const PackedGeometry& geometry, const PreparedTexture& texture,
                                          SurfaceId id, Vec3 point) {
    const std::optional<TexturePlace> at = surface_uv(geometry, texture, id, point);
    if (!at) return std::nullopt;
    const auto& m = texture.uv_map.m;
    return TexturePlace{m[0][0] * at->u + m[0][1] * at->v + m[0][2],
                        m[1][0] * at->u + m[1][1] * at->v + m[1][2]};
}

namespace {

std::optional<TextureSample> sample_color(const PreparedTexture& texture, TexturePlace place) {
    const auto u = wrapped(place.u, texture.wrap_u), v = wrapped(place.v, texture.wrap_v);
    if ((!u && texture.wrap_u == TextureWrap::once) || (!v && texture.wrap_v == TextureWrap::once))
        return std::nullopt;
    if (!u || !v) return TextureSample{place, {-1, -1}, {-1, -1}, 0, 0, {}, 0};
    if (!texture.image) return sample_colors(texture, place, *u);
    const TextureImage& image = *texture.image;
    const Pair columns = texels_at(*u, image.width, texture.wrap_u, texture.filter),
               rows = texels_at(1 - *v, image.height, texture.wrap_v, texture.filter);
    TextureSample sample{place, columns.texels, rows.texels, columns.second, rows.second, {}, 1};
    const TexelWeights weights = texture.filter == TextureFilter::distance
                                     ? weights_by_distance(sample.right, sample.lower)
                                     : TexelWeights{{sample.right, sample.right}, sample.lower};
    const auto row = [&](std::size_t i) {
        const Channels left = texel(texture, sample.columns[0], sample.rows[i]);
        if (texture.filter == TextureFilter::nearest) return left;
        return mixed(left, texel(texture, sample.columns[1], sample.rows[i]), weights.right[i]);
    };
    Channels found = row(0);
    if (texture.filter != TextureFilter::nearest) found = mixed(found, row(1), weights.lower);
    sample.color = {found.values[0], found.values[1], found.values[2]};
    sample.alpha = found.values[3];
    return sample;
}

}  // namespace

std::optional<TextureSample> sample_texture(const PreparedTexture& texture, TexturePlace place) {
    std::optional<TextureSample> sample = sample_color(texture, place);
    if (!sample) return sample;
    sample->ambient = sample->color * texture.ambient;
    sample->diffuse = sample->color * texture.diffuse;
    return sample;
}

std::optional<TextureSample> sample_layers(const PackedGeometry& geometry,
                                           std::span<const PreparedTexture> textures, std::uint32_t front,
                                           SurfaceId id, Vec3 point, std::vector<TextureLayer>* layers) {
    std::optional<TextureSample> sum;
    Color color, ambient, diffuse;
    double left = 1;
    for (std::uint32_t i = front; i != k_none && left > 0; i = textures[i].over) {
        const PreparedTexture& texture = textures[i];
        std::optional<TextureSample> sample;
        if (const auto place = texture_place(geometry, texture, id, point))
            sample = sample_texture(texture, *place);
        if (!sample) continue;
        if (!sum) sum = i == front ? *sample : TextureSample{{}, {-1, -1}, {-1, -1}, 0, 0, {}, 0};
        const double weight = left * texture.own_opacity(sample->alpha);
        color = color + sample->color * weight;
        ambient = ambient + sample->ambient * weight;
        diffuse = diffuse + sample->diffuse * weight;
        left -= weight;
        if (layers) layers->push_back({i, *sample, weight});
    }
    if (!sum) return sum;
    sum->alpha = 1 - left;
    const double whole = sum->alpha > 0 ? 1 / sum->alpha : 0;
    sum->color = color * whole;
    sum->ambient = ambient * whole;
    sum->diffuse = diffuse * whole;
    return sum;
}

}  // namespace glint
