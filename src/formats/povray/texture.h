// SPDX-License-Identifier: Apache-2.0
#pragma once
// Textures as the text has them, and notes of what is not rendered.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "formats/povray/value.h"
#include "glint/texture.h"

namespace glint::povray {

/// A color without its filter and transmit.
inline Color rgb_of(const std::array<double, 5>& c) { return {c[0], c[1], c[2]}; }

/// A feature that is not rendered, and its place: reported if something that has it becomes part of the
/// scene.
struct Missing {
    std::string_view name;     ///< "normal"
    std::string_view meaning;  ///< "a bumpy normal"; may be empty
    Token at;
    bool is_error = false;  ///< without it the scene has no meaning
};

/// The features of one thing that are not rendered; of each name the first, and at most a few.
class MissingList {
  public:
    void add(const Missing& missing);
    bool empty() const { return list_.empty(); }
    bool has_error() const;
    auto begin() const { return list_.begin(); }
    auto end() const { return list_.end(); }

  private:
    CountedVector<Missing> list_;
};

struct ColorMapEntry {
    double at = 0;
    std::array<double, 5> color{};
};

/// The pattern `gradient`, which a sky can have: x = axis · p, axis of length 1, p the point in the pigment's
/// space.
struct GradientPattern {
    Vec3 axis{0, 1, 0};
    CountedVector<ColorMapEntry> map;
    std::optional<Affine> transform;  ///< of the pattern
};

struct PatternSource;

struct Pigment {
    std::array<double, 5> color{0, 0, 0, 0, 0};  ///< with an image: white, and its filter and transmit
    std::optional<Missing> missing;              ///< a pattern that is not rendered
    std::shared_ptr<const GradientPattern> gradient;
    /// `image_map`, without what depends on the place of the surface.
    std::shared_ptr<const glint::Texture> image;
    std::optional<Affine> map;  ///< of the image's pattern, or of u and v with `uv_mapping`
    bool is_uv = false;         ///< `uv_mapping`
    std::shared_ptr<const PatternSource>
        pattern{};  ///< what the text says of it, to be changed by more words
    /// Of an `average`: the others, of which this one, with less opacity, lets the rest be seen. Of a pattern
    /// of pigments: the one that has a pattern itself.
    std::shared_ptr<const Pigment> under{};
    double image_number = 0;  ///< the same for the same image and map, and average; 0: no image
    friend bool operator==(const Pigment& a, const Pigment& b) {
        return a.color == b.color && a.image_number == b.image_number;
    }
};

struct Opaque;

/// The defaults are POV-Ray's.
struct Finish {
    Color ambient{0.1, 0.1, 0.1}, emission{0, 0, 0};
    double diffuse = 0.6, brilliance = 1;
    double phong = 0, phong_size = 40, specular = 0, roughness = 0.05, metallic = 0;
    Color reflection_min{0, 0, 0}, reflection_max{0, 0, 0};
    double reflection_exponent = 1, reflection_falloff = 1, reflection_metallic = 0;
    bool reflection_fresnel = false, conserve_energy = false;
    double crand = 0, diffuse_back = 0;
    double refraction = 1;                     ///< a factor of the light that passes the surface
    std::shared_ptr<const Opaque> interior{};  ///< of `ior` in a finish: an old place of it
    MissingList missing;
};

struct Texture {
    Pigment pigment;
    Finish finish;
    MissingList missing;                     ///< a normal, a texture map, ...
    bool is_uv = false;                      ///< `uv_mapping`
    std::shared_ptr<const Texture> below{};  ///< what is seen where this layer is transparent
    int layers = 1;                          ///< with those below
    double layers_number = 0;                ///< the same for the same layers at the same place; 0: one layer

    /// Whether transforms of what has the texture do not apply to it.
    bool has_own_place() const { return is_uv || pigment.is_uv; }
};

/// What a `sky_sphere` has.
struct SkyItems {
    CountedVector<Pigment> pigments;
    std::optional<Affine> map;
    bool is_known = true;  ///< has nothing else
};

/// A block that has a meaning only where it is used: normal, interior, color_map, sky_sphere, ... Most are
/// not rendered.
struct Fade {
    double distance = 0, power = 0;
    Color color{0, 0, 0};
    friend bool operator==(const Fade&, const Fade&) = default;
};

struct Opaque {
    Word word = Word::k_none;
    Token at;
    double ior = 1;                      ///< of an interior
    Fade fade{};                         ///< of an interior
    double caustics = 0;                 ///< of an interior
    MissingList missing{};               ///< what else of an interior counts
    CountedVector<ColorMapEntry> map{};  ///< of a color_map
    SkyItems sky{};                      ///< of a sky_sphere
};

/// The numbers of a texture that decide what its surface looks like; the pigment's red, green and blue come
/// first.
using TextureNumbers = std::array<double, 33>;
TextureNumbers numbers_of(const Texture& texture);
/// What filter and transmit leave.
inline double opacity_of(const std::array<double, 5>& color) {
    return std::clamp(1 - color[3] - color[4], 0.0, 1.0);
}
inline double largest(Color c) { return std::max({c.r, c.g, c.b}); }
/// Whether light passes the layer, or may.
inline bool is_clear(const Texture& layer) {
    const Pigment& p = layer.pigment;
    return !p.under && (p.color[3] != 0 || p.color[4] != 0 || (p.image && p.image->has_alpha()));
}
/// Whether the pigment hides all that is behind it.
inline bool lets_nothing_through(const Pigment& pigment) {
    if (pigment.under) return true;
    if (pigment.color[3] != 0 || pigment.color[4] != 0) return false;
    return !pigment.image || !pigment.image->has_alpha();
}
/// Whether something of the texture is not rendered, beyond what its numbers say.
bool has_warnings(const Texture& texture);

struct MaterialValue {
    std::shared_ptr<const Texture> texture;
    std::shared_ptr<const Opaque> interior;
    MissingList missing;
};

}  // namespace glint::povray
