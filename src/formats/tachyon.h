// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the texts of a Tachyon scene have set so far. docs/formats/tachyon.md.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/load_state.h"
#include "formats/number_table.h"

namespace glint {

/// The number after TexFunc.
enum class TachyonFunction : std::uint8_t { none, checker, grit, marble, wood };

/// The body of a texture. The defaults are Tachyon's for a name that is not defined.
struct TachyonTexture {
    double ambient = 0.1, diffuse = 0.9, specular = 0, opacity = 1;
    double outline = 0, outline_width = 0;
    double phong = 0, phong_size = 100;
    bool is_metal = false;         ///< the highlight has the surface's color
    bool fades_at_angles = false;  ///< TransMode R3D
    Color color{1, 1, 1};          ///< white if the function has colors of its own
    TachyonFunction function = TachyonFunction::none;
    Vec3 center;  ///< of the checker and the wood

    /// All fields, as a key.
    std::array<double, 17> numbers() const {
        return {ambient,
                diffuse,
                specular,
                opacity,
                outline,
                outline_width,
                phong,
                phong_size,
                is_metal ? 1. : 0.,
                fades_at_angles ? 1. : 0.,
                color.r,
                color.g,
                color.b,
                static_cast<double>(function),
                center.x,
                center.y,
                center.z};
    }
};

/// A camera, whose frame depends on the picture's size.
struct TachyonCamera {
    Projection projection = Projection::perspective;
    double zoom = 1, aspect_ratio = 1;
    Vec3 center, view, up;
    struct Frustum {
        double left, right, bottom, top;
    };
    std::optional<Frustum> frustum;  ///< at distance 1, in place of `zoom` and `aspect_ratio`
};

enum class TachyonShader : std::uint8_t { full, medium, low, lowest };

/// Rules of Tachyon's that glint has only a part of, or none; in the order of k_limit_texts.
enum class TachyonLimit : std::uint8_t {
    fogged_light,
    endless_cylinder,
    box_normals,
    normal_lengths,
    grain,
    rings,
    bright_highlight,
    count
};

/// Shared by the texts of one load().
struct TachyonState {
    // A texture is an index into Scene::materials, which finish_tachyon() fills from `textures`.
    // No choice of names or numbers makes the tables slow.
    CountedMap<std::string, std::uint32_t> names;
    NumberTable<17> materials;                                         ///< by TachyonTexture::numbers()
    CountedVector<std::pair<std::uint32_t, TachyonTexture>> textures;  ///< by material

    std::optional<TachyonCamera> camera;
    TachyonShader shader = TachyonShader::full;
    SourcePlace shader_place;
    bool is_raster3d = false;            ///< Trans_Raster3D
    std::optional<Occlusion> occlusion;  ///< Ambient_Occlusion or Sky_Light, without `direct`
    SourcePlace occlusion_place;
    bool has_header = false;            ///< Begin_Scene
    double light_scale = 1;             ///< Rescale_Direct
    std::vector<std::uint32_t> lights;  ///< in Scene::lights, those that light_scale applies to

    /// Where each limit was met first.
    struct Place {
        InputText text;
        std::size_t offset = 0, length = 0;
    };
    std::array<std::optional<Place>, static_cast<std::size_t>(TachyonLimit::count)> limits;

    std::optional<Place>& limit(TachyonLimit which) { return limits[static_cast<std::size_t>(which)]; }
};

/// The texture that a function other than none stands for. tint: of grit. The place is not set.
Texture tachyon_pattern(TachyonFunction function, Vec3 center, Color tint, TextureMix mix);

}  // namespace glint
