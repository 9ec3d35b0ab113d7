// SPDX-License-Identifier: Apache-2.0
#include "formats/povray_keywords.h"

#include <algorithm>
#include <iterator>

namespace glint {
namespace {

struct Meaning {
    std::string_view what;
    std::string_view words;  // with a blank before and after each
};

// From the reserved words of POV-Ray 3.7.
constexpr Meaning k_meanings[] = {
    {"a solid made of others", " union intersection difference merge "},
    {"a shape",
     " bicubic_patch blob cubic cylinder disc height_field isosurface julia_fractal lathe lemon mesh mesh2 "
     "object ovus parametric poly polygon polynomial prism quadric quartic smooth_triangle sor sphere_sweep "
     "superellipsoid text torus "},
    {"a part of a shape",
     " bounded_by clipped_by component cutaway_textures face_indices hollow inside_vector inverse "
     "no_image no_radiosity no_reflection no_shadow normal_indices normal_vectors open smooth sturm "
     "threshold tightness double_illuminate uv_indices uv_mapping uv_vectors vertex_vectors "},
    {"a setting of a whole scene",
     " background default fog global_settings photons radiosity rainbow sky_sphere subsurface ambient_light "
     "assumed_gamma max_trace_level "},
    {"a material",
     " interior interior_texture material material_map media normal normal_map texture texture_list "
     "texture_map slope_map "},
    {"a pattern",
     " aoi agate average boxed bozo brick bumps cells checker crackle cubic_pattern cylindrical density "
     "density_file density_map "
     "dents facets fractal function gradient granite hexagon image_map image_pattern leopard magnet mandel "
     "marble onion pattern pigment_map pigment_pattern planar quilted radial ripples slope spherical "
     "spiral1 spiral2 spotted square tiles triangular turbulence warp waves wood wrinkles color_map "
     "colour_map quick_color quick_colour frequency phase "},
    {"a way to write a color", " colour filter green red blue rgbft rgbt srgb srgbf srgbft srgbt transmit "},
    {"a property of a finish",
     " albedo brilliance conserve_energy crand diffuse_albedo emission exponent fresnel irid metallic phong "
     "phong_size use_alpha "},
    {"a property of glass", " caustics dispersion dispersion_samples fade_color fade_colour "},
    {"a kind of light",
     " adaptive area_illumination area_light circular cylinder_light fade_distance fade_power falloff "
     "jitter light_group looks_like media_attenuation media_interaction orient parallel point_at "
     "projected_through radius shadowless spotlight "},
    {"a property of a camera",
     " angle aperture blur_samples confidence direction fisheye focal_point omnimax orthographic panoramic "
     "perspective sky ultra_wide_angle variance "},
    {"a map", " matrix transform "},
    {"a function", " vturbulence "},
};

constexpr std::string_view k_directives[] = {
    "break",  "case",       "debug",  "declare", "default", "else",    "elseif", "end",   "error", "fclose",
    "fopen",  "for",        "if",     "ifdef",   "ifndef",  "include", "local",  "macro", "range", "read",
    "render", "statistics", "switch", "undef",   "version", "warning", "while",  "write"};

bool holds(std::string_view words, std::string_view word) {
    for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
        if (words[at - 1] == ' ' && words[at + word.size()] == ' ') return true;
    }
    return false;
}

}  // namespace

std::string_view povray_meaning(std::string_view word) {
    if (word.empty() || word.find(' ') != std::string_view::npos) return {};
    for (const Meaning& m : k_meanings) {
        if (holds(m.words, word)) return m.what;
    }
    return {};
}

bool is_povray_directive(std::string_view word) {
    return std::find(std::begin(k_directives), std::end(k_directives), word) != std::end(k_directives);
}

}  // namespace glint
