// SPDX-License-Identifier: Apache-2.0
#pragma once
// The table of the terms of an explanation: the numbers, vectors, colors and flags that rays, hits, lights
// and samples have. JSON, its schema, the types of the npm package, the table of docs/explain.md, and the
// terms that the command and the page list without words of their own come from it (tools/write_terms.cpp).
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>
#include <variant>

#include "glint/explain.h"

namespace glint {

/// What decides whether a term is given, besides the values that it is a part of.
struct TermContext {
    const Scene& scene;
    const ExplainedHit* hit = nullptr;  // of a light's terms
};

/// A term of an Of.
template <class Of> struct ExplainedTerm {
    std::string_view name;  // in JSON
    std::variant<double Of::*, int Of::*, bool Of::*, Vec3 Of::*, Color Of::*> member;
    std::string_view description;
    bool (*is_given)(const Of&, const TermContext&) = nullptr;  // null: always
    bool may_be_infinite = false;                               // infinity is null in JSON
    /// If set, texts list the number under this label, unless it is `usual`.
    std::string_view label = {};
    double usual = 1;
};

/// Whether transparent surfaces color the light.
inline bool is_filtered(const LightTerms& terms) {
    if (!terms.filters.empty()) return true;
    for (const ShadowSample& sample : terms.samples)
        if (!sample.filters.empty()) return true;
    return false;
}

namespace terms {
inline bool has_second_highlight(const LightTerms&, const TermContext& of) {
    return !(material_of(*of.hit, of.scene).phong == Color{});
}
inline bool is_metallic(const LightTerms&, const TermContext& of) {
    return material_of(*of.hit, of.scene).metallic > 0;
}
inline bool has_filter(const LightTerms& terms, const TermContext&) { return is_filtered(terms); }
inline bool has_filters(const ShadowSample& sample, const TermContext&) { return !sample.filters.empty(); }
inline bool is_of_sample(const LightTerms& terms, const TermContext&) { return terms.sample >= 0; }
inline bool is_transparent(const ExplainedHit& hit, const TermContext&) { return hit.transparent; }
inline bool fades(const ExplainedHit& hit, const TermContext&) { return !(hit.fade == Color{1, 1, 1}); }
inline bool has_mesh(const ExplainedHit& hit, const TermContext&) { return hit.triangle >= 0; }
inline bool has_outline(const ExplainedHit& hit, const TermContext&) { return hit.outline != 1; }
template <bool ExplainedRay::*Flag> bool is_set(const ExplainedRay& ray, const TermContext&) {
    return ray.*Flag;
}
inline bool is_layer(const ExplainedTexture& texture, const TermContext&) { return texture.is_layer; }
inline bool has_shares(const ExplainedTexture& texture, const TermContext&) {
    return !(texture.ambient == texture.color && texture.diffuse == texture.color);
}
inline bool is_back(const ExplainedHole& hole, const TermContext&) { return hole.back; }
inline bool is_of_texture(const ExplainedHole& hole, const TermContext&) { return !hole.back; }
inline bool passes_holes(const ExplainedRay& ray, const TermContext&) { return ray.hole_count > 0; }
inline bool hits_nothing(const ExplainedRay& ray, const TermContext&) { return !ray.hit; }
}  // namespace terms

inline constexpr ExplainedTerm<LightTerms> k_light_terms[] = {
    {"to_light", &LightTerms::to_light, "not a unit vector"},
    {"distance", &LightTerms::distance, "the length of to_light"},
    {.name = "attenuation",
     .member = &LightTerms::attenuation,
     .description = "f_att",
     .label = "attenuation"},
    {"spot", &LightTerms::spot, "of a spot: the factor of its light in this direction; else 1"},
    {.name = "emitter",
     .member = &LightTerms::emitter,
     .description = "of a one-sided area light: the cosine off its normal, 0 behind it; else 1",
     .label = "emitter's cosine"},
    {"visible", &LightTerms::visible,
     "of an area light that shines from its centre: the visible part, with colored shadows the mean over the "
     "channels of filter; else 1"},
    {"sample", &LightTerms::sample,
     "of an area light each of whose samples is a light: row * samples_u + column", terms::is_of_sample},
    {"n_l", &LightTerms::n_l, "N·L", nullptr, true},
    {"s", &LightTerms::s, "R·V (Phong), N·H (Blinn-Phong)", nullptr, true},
    {"power", &LightTerms::power, "S^n where there is a highlight, blocked or not"},
    {"diffuse_factor", &LightTerms::diffuse_factor, "of k_d I: N·L, to the power of the brilliance", nullptr,
     true},
    {"phong_s", &LightTerms::phong_s, "R·V of a second highlight", terms::has_second_highlight},
    {"phong_power", &LightTerms::phong_power, "of a second highlight, as power", terms::has_second_highlight},
    {"highlight_tint", &LightTerms::highlight_tint, "of a metal's highlights; included in specular",
     terms::is_metallic},
    {"diffuse", &LightTerms::diffuse, "what it adds, before the hit's weight"},
    {"specular", &LightTerms::specular, "likewise"},
    {"filter", &LightTerms::filter,
     "the factor of the light that passes the transparent surfaces on its way; of an area light that shines "
     "from its centre, the mean of its samples; included in diffuse and specular",
     terms::has_filter},
};

inline constexpr ExplainedTerm<ShadowSample> k_shadow_sample_terms[] = {
    {"sample", &ShadowSample::sample, "row * samples_u + column"},
    {"weight", &ShadowSample::weight,
     "its factor in visible, which is the sum over the visible samples (with colored shadows, of weight "
     "times filter)"},
    {"position", &ShadowSample::position, "on the light"},
    {"blocked", &ShadowSample::blocked, "whether a shape blocks it"},
    {"filter", &ShadowSample::filter, "as of the light", terms::has_filters},
};

inline constexpr ExplainedTerm<ExplainedOcclusion> k_occlusion_terms[] = {
    {"samples", &ExplainedOcclusion::samples, "their number"},
    {"blocked", &ExplainedOcclusion::blocked, "how many of the samples are blocked"},
    {"factor", &ExplainedOcclusion::factor,
     "f, the part of the light that arrives; if transparent surfaces color it, the mean over the channels"},
    {"factors", &ExplainedOcclusion::factors, "f by channel"},
    {"light", &ExplainedOcclusion::light, "k_d color f"},
    {"part", &ExplainedOcclusion::part, "multiplied by weight and local_share: what is added to the pixel"},
};

inline constexpr ExplainedTerm<ExplainedTexture> k_texture_terms[] = {
    {"u", &ExplainedTexture::u, "u in the picture, to the right; with a `color_map`, the place in it"},
    {"v", &ExplainedTexture::v, "v in the picture, up"},
    {"column", &ExplainedTexture::column,
     "of the first texel, from the left, from 0; -1 beside the picture, with the wrap clip; with a "
     "`color_map`, the number of its color, from 0"},
    {"next_column", &ExplainedTexture::next_column,
     "of the texel, or color of the map, that is mixed with it"},
    {"row", &ExplainedTexture::row, "of the first texel, from the top, from 0; -1 as above"},
    {"next_row", &ExplainedTexture::next_row, "of the texel that is mixed with it"},
    {"next_column_weight", &ExplainedTexture::next_column_weight,
     "the weight of the next column; the first one has the rest"},
    {"next_row_weight", &ExplainedTexture::next_row_weight, "the weight of the next row"},
    {"color", &ExplainedTexture::color, "the color of the texels or of the map, decoded and mixed"},
    {"alpha", &ExplainedTexture::alpha, "their alpha, mixed; 1 without one"},
    {"ambient", &ExplainedTexture::ambient, "the color in k_a, if it is another one", terms::has_shares},
    {"diffuse", &ExplainedTexture::diffuse, "the color in k_d, if it or that in k_a is another one",
     terms::has_shares},
    {"weight", &ExplainedTexture::weight,
     "of one of the layers: its opacity, times what is left of those in front of it; alpha is their sum, and "
     "alpha times color is that of weight times color",
     terms::is_layer},
};

inline constexpr ExplainedTerm<ExplainedCrossing> k_crossing_terms[] = {
    {"operand", &ExplainedCrossing::operand, "the number of the solid's shape, from 0"},
    {"t", &ExplainedCrossing::t, "of the ray"},
    {"enters", &ExplainedCrossing::enters, "the shape begins there; otherwise it ends"},
    {"surface", &ExplainedCrossing::surface, "the solid has a surface there"},
    {"hit", &ExplainedCrossing::hit, "it is the surface that the ray hits"},
};
inline constexpr ExplainedTerm<ExplainedHole> k_hole_terms[] = {
    {"t", &ExplainedHole::t, "of the ray"},
    {"back", &ExplainedHole::back,
     "the ray meets the back of a one-sided surface (`one_sided`), which it passes; there is no texture then",
     terms::is_back},
    {"cutoff", &ExplainedHole::cutoff, "`alpha_cutoff` of the texture: its alpha is below it",
     terms::is_of_texture},
};

inline constexpr ExplainedTerm<ExplainedHit> k_hit_terms[] = {
    {"point", &ExplainedHit::point, "P"},
    {"normal", &ExplainedHit::normal, "N as used for the lighting, a unit vector"},
    {"to_eye", &ExplainedHit::to_eye, "V"},
    {"normal_turned", &ExplainedHit::turned, "whether N was flipped towards the ray"},
    {"triangle", &ExplainedHit::triangle, "of a mesh: the number of the triangle, from 0", terms::has_mesh},
    {"corner_weights", &ExplainedHit::corner_weights,
     "of a mesh: the weights of the triangle's corners, by which normals and colors are interpolated",
     terms::has_mesh},
    {"mesh_point", &ExplainedHit::mesh_point, "of a mesh: P in the mesh's coordinates", terms::has_mesh},
    {"weight", &ExplainedHit::weight, "the ray's weight, reduced by what glass and fog absorbed"},
    {"mirror", &ExplainedHit::mirror, "the part of the light that the mirror reflects towards the ray"},
    {"local_share", &ExplainedHit::local_share,
     "the share of the surface's own light; mirror and glass have the rest"},
    {"ambient", &ExplainedHit::ambient, "k_a I_a; for shadings without lights, the color shown"},
    {"diffuse", &ExplainedHit::diffuse, "the sum over the lights"},
    {"specular", &ExplainedHit::specular, "the sum over the lights"},
    {"emission", &ExplainedHit::emission, "k_e"},
    {"fresnel", &ExplainedHit::fresnel, "the share that glass reflects; 1: total internal reflection"},
    {"opacity", &ExplainedHit::opacity, "of a transparent surface (filter, transmit)", terms::is_transparent},
    {"through", &ExplainedHit::through,
     "of a transparent surface: the factor of what is behind it, transmit + filter * color; with "
     "angled_opacity, the transmit at this angle; with conserve_energy, times 1 - mirror * mirror_tint",
     terms::is_transparent},
    {"fade", &ExplainedHit::fade,
     "of a surface where light leaves an object that fades it (`fade_distance`): what is left of it",
     terms::fades},
    {"highlight_share", &ExplainedHit::highlight_share,
     "of a transparent surface: the share of its highlights, as local_share of the rest",
     terms::is_transparent},
    {"outline", &ExplainedHit::outline,
     "of a surface with an outline: the factor of its diffuse light and of the light from all directions",
     terms::has_outline},
};

inline constexpr ExplainedTerm<ExplainedRay> k_ray_terms[] = {
    {"generation", &ExplainedRay::generation, "0 for camera rays"},
    {"origin", &ExplainedRay::origin, "in the world"},
    {"direction", &ExplainedRay::direction, "not normalised: t is measured in units of its length"},
    {"t_min", &ExplainedRay::t_min, "the ray begins here"},
    {"t", &ExplainedRay::t, "of the hit; null: no hit", nullptr, true},
    {"weight", &ExplainedRay::weight, "the factor by which its light counts in the pixel"},
    {"straight", &ExplainedRay::straight,
     "true: it goes straight through a transparent surface, along the line of its parent, from t_min on",
     terms::is_set<&ExplainedRay::straight>},
    {"beyond_limit", &ExplainedRay::beyond_limit,
     "true: it starts at the limit of reflections, and sees the background",
     terms::is_set<&ExplainedRay::beyond_limit>},
    {"inside_object", &ExplainedRay::inside_object,
     "true: there is no fog, because the ray is inside an object (fog_extent = outside_objects)",
     terms::is_set<&ExplainedRay::inside_object>},
    {"hole_count", &ExplainedRay::hole_count,
     "how many holes of textures (`alpha = mask`) and backs of one-sided surfaces it passes; `holes` has the "
     "first 16",
     terms::passes_holes},
    {"background", &ExplainedRay::background, "what a ray without a hit adds", terms::hits_nothing},
    {"transparent", &ExplainedRay::transparent,
     "the ray shows the background directly or through glass: the mean of its weight, times 1 - "
     "`background_alpha`, is subtracted from alpha",
     terms::hits_nothing},
};

/// Calls visit(label, number) for the terms that have a label, where they are not the usual ones.
template <class Of, std::size_t n, class Visit>
void for_listed_terms(const ExplainedTerm<Of> (&table)[n], const Of& of, const Visit& visit) {
    for (const ExplainedTerm<Of>& term : table) {
        if (term.label.empty()) continue;
        const double value = of.*std::get<double Of::*>(term.member);
        if (value != term.usual) visit(term.label, value);
    }
}

}  // namespace glint
