// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures and patterns on surfaces: what a Texture is, and the pixels or colors that it shows.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "glint/shapes.h"
#include "glint/vec.h"

namespace glint {

/// The greatest width and height of a TextureImage.
inline constexpr std::uint32_t k_max_texture_size = 32768;

/// The pixels of a texture ("texels"), as they are in the picture's file. A Scene and its copies share it
/// (Texture::image), so it must not change once it is in a Scene.
struct TextureImage {
    std::uint32_t width = 0, height = 0;  ///< 1 to k_max_texture_size
    bool has_alpha = false;               ///< r, g, b, a for each texel; otherwise r, g, b
    /// Rows from the top, texels from the left. The alpha is not multiplied into the colors.
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>> words;

    std::uint32_t channels() const { return has_alpha ? 4 : 3; }
    friend bool operator==(const TextureImage&, const TextureImage&) = default;
};

/// What is beside the picture, where u or v is below 0 or above 1. repeat: the picture again. mirror: the
/// picture again, every other one reversed. clamp: the texels of its border. once: nothing; the surface
/// has no texture there. clip: black texels of alpha 0.
enum class TextureWrap : std::uint8_t { repeat, mirror, clamp, once, clip };

/// nearest: the texel that contains the point. bilinear: between the middles of the four nearest texels.
/// distance: their mean by 1 over the square of the distance, in texels; with a color_map as bilinear.
enum class TextureFilter : std::uint8_t { nearest, bilinear, distance };

/// What the texture's color does. multiply: the material's color, k_a and k_d are multiplied by it, channel
/// by channel; k_s is not. replace: the surface looks as if it had with_color(its material, the texture's
/// color). multiply_all: as multiply, and k_e is multiplied, too.
enum class TextureMix : std::uint8_t { multiply, replace, multiply_all };

/// What the texels' words are. linear: word / 255, or word / 65535, as colors are written in scenes whose
/// picture has Transfer::none. srgb: decoded by the sRGB curve (IEC 61966-2-1), before they are mixed; for
/// pictures with Transfer::srgb. Alpha is always linear.
enum class TextureEncoding : std::uint8_t { linear, srgb };

/// What the texels' alpha A does. blend: the surface is transparent where A is below 1: of its opacity, the
/// part A is left. mask: A counts as 1 from Texture::alpha_cutoff on, and below it there is no surface.
/// ignore: nothing.
enum class TextureAlpha : std::uint8_t { blend, mask, ignore };

/// Where u and v come from. uv: the numbers at a mesh's vertices (MeshData::texture_coordinates); shapes
/// without them have no texture. The others depend on the point p in the texture's coordinates
/// (Texture::world_from_texture). planar: u = p.x, v = p.y. spherical: u goes around the y axis, v from the
/// pole at -y to that at +y. cylindrical: u goes around the y axis, v = p.y. Around the axis, u = 0.5 is at
/// +z, 0.75 at +x.
///
/// The patterns have a u at each point of space, and v = 0. checker: cubes of side 1, u = 0 and 0.5 in turn;
/// a point less than k_checker_margin below a border is above it, so that a surface on a border has one
/// color. onion: u = |p|. rings: u is the distance from the y axis. boxes: u = max(|p.x|, |p.y|, |p.z|).
/// slabs: u = |p.x|. leopard: u = ((sin p.x + sin p.y + sin p.z) / 3)^2. bricks: u = 0 in
/// the mortar (Texture::mortar), and 0.5 in the bricks, boxes of side 1 in layers along y; those of odd
/// layers are moved by 0.5 in x, those of even layers in z. hexagons: u = 0, 0.25 and 0.5 in turn, in prisms
/// along y whose hexagons have sides of length 1; neighbours differ, and a corner is at +x of the middle.
/// noise: u is 0.5 + half of gradient noise (Perlin, 2002), from 0 to below 1. granite: u is the sum of
/// |noise(4 k p)| / k for k = 1, 2, 4 ... 32, below 1. wrinkles: half the sum of u of noise at k p, over k,
/// for k = 1, 2 ... 512.
///
/// spiral: u is the distance from the y axis plus p.y, and v is u of cylindrical, so that UvMap makes arms: u
/// + n v has n of them. mandelbrot: u = n / Texture::iterations, where n is how many of the numbers z of the
/// sequence z^2 + p, from z = p on, are within 2 of 0 before the first that is not (p.x + i p.y; all: u = 1).
enum class TextureMapping : std::uint8_t {
    uv,
    planar,
    spherical,
    cylindrical,
    checker,
    onion,
    rings,
    boxes,
    slabs,
    leopard,
    bricks,
    hexagons,
    noise,
    granite,
    wrinkles,
    spiral,
    mandelbrot
};

inline constexpr double k_checker_margin = 1e-10;

/// A color at a place of Texture::color_map.
struct TextureColor {
    double at = 0;  ///< u, 0 to 1
    Color color{0, 0, 0};
    double alpha = 1;  ///< 0 to 1
    friend bool operator==(const TextureColor&, const TextureColor&) = default;
};
/// The greatest number of colors in a Texture::color_map.
inline constexpr std::size_t k_max_texture_colors = 256;

/// The most textures in front of each other (Texture::over), the lowest one included.
inline constexpr int k_max_texture_layers = 16;

/// An affine map of u and v, as rows.
struct UvMap {
    double m[2][3] = {{1, 0, 0}, {0, 1, 0}};
    friend bool operator==(const UvMap&, const UvMap&) = default;
};

/// A picture or a map of colors on a surface (Material::texture). u goes to the right and v up; (0, 0) is the
/// lower left corner of the picture, (1, 1) its upper right corner.
struct Texture {
    std::shared_ptr<const TextureImage> image;  ///< null with a color_map
    /// In place of an image, 1 to k_max_texture_colors colors by u, in the order of `at`. filter: bilinear:
    /// between the two colors beside u; nearest: the last color whose `at` is not above u. Before the first
    /// and after the last place it is the first and the last color.
    std::vector<TextureColor> color_map{};
    TextureMapping mapping = TextureMapping::uv;
    /// With a color_map and a mapping other than uv: the mapping's point is (u, v, 0) in place of one in the
    /// world, of the numbers at a mesh's vertices; shapes without them have no texture.
    bool from_uv = false;
    TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
    TextureFilter filter = TextureFilter::bilinear;
    TextureMix mix = TextureMix::multiply;
    TextureEncoding encoding = TextureEncoding::linear;
    TextureAlpha alpha = TextureAlpha::blend;
    double alpha_cutoff = 0.5;  ///< 0 to 1
    /// bricks: the parts of their length, height and depth at the upper ends that are mortar, 0 to 1.
    Vec3 mortar{0.1, 0.1, 0.1};
    /// Mappings other than uv; 0 with uv: p is moved by turbulence times the sum of gain^i noise(lacunarity^i
    /// p) for i from 0 below octaves, component by component. A fraction of octaves is the part of its last
    /// term.
    Vec3 turbulence;
    double octaves = 6;                 ///< 0 to 10
    double gain = 0.5, lacunarity = 2;  ///< 0 to 1; > 0
    /// mandelbrot: the greatest number of steps, 1 to 1e6; its fraction does not count.
    double iterations = 100;
    /// u and v in the picture from those of the surface: (a u + b v + c, d u + e v + f).
    UvMap uv_map{};
    Affine world_from_texture{};  ///< for mappings other than uv; invertible
    /// Into Scene::textures; k_none: none. The texture that is seen where this one is transparent, or is not:
    /// the color is the sum of those of the layers by what each shows, over the alpha of all. mix is that of
    /// the front one. Not with TextureAlpha::mask.
    std::uint32_t over = k_none;
    /// 0 to 1: the factors of its color in the surface's ambient and diffuse color. Layers that reflect light
    /// differently have different ones.
    double ambient = 1, diffuse = 1;
    std::string file{};  ///< the name of the picture's file; empty: none

    /// Whether it needs texture coordinates of meshes.
    bool needs_uv() const { return from_uv || mapping == TextureMapping::uv; }
    bool has_wrap(TextureWrap wrap) const { return wrap_u == wrap || wrap_v == wrap; }
    /// Whether surfaces may be transparent where it is.
    bool has_alpha() const {
        if (alpha == TextureAlpha::ignore) return false;
        for (const TextureColor& color : color_map)
            if (color.alpha < 1) return true;
        return has_wrap(TextureWrap::clip) || (image && image->has_alpha);
    }
    /// Whether there are places where surfaces have holes.
    bool has_holes() const { return alpha == TextureAlpha::mask && has_alpha(); }
    /// The part of a surface's opacity that is left where the texels have this alpha; with `over`, where the
    /// sum of the layers has it.
    double opacity(double texel_alpha) const {
        return over == k_none ? own_opacity(texel_alpha) : texel_alpha;
    }
    /// Without the layers below.
    double own_opacity(double texel_alpha) const {
        if (!has_alpha()) return 1;
        if (alpha == TextureAlpha::mask) return texel_alpha >= alpha_cutoff ? 1 : 0;
        return texel_alpha;
    }

    friend bool operator==(const Texture&, const Texture&) = default;
};

}  // namespace glint
