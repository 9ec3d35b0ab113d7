// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <iterator>
#include <span>

#include "scene/fields.h"

namespace glint {

template <> struct FieldMembers<Material> {
    using Any =
        std::variant<FieldMember<Material, double, NumberType>, FieldMember<Material, bool, BoolType>,
                     FieldMember<Material, std::int32_t, WholeType>, FieldMember<Material, Color, ColorType>,
                     FieldMember<Material, std::uint32_t, TextureType>>;
};

/// In the order in which they are written.
inline constexpr ItemField<Material> k_material_fields[] = {
    {"color", "color", "color", color_field(&Material::color, k_channel, ColorUse::surface),
     "the surface's color"},
    {.key = "ambient_color",
     .name = "ambient",
     .label = "ambient",
     .member = color_field(&Material::ambient, k_channel, ColorUse::coefficient),
     .description = "k_a itself",
     .otherwise = "ambient * color"},
    {.key = "diffuse_color",
     .name = "diffuse",
     .label = "diffuse",
     .member = color_field(&Material::diffuse, k_channel, ColorUse::coefficient),
     .description = "k_d itself",
     .otherwise = "diffuse * color"},
    {.key = "specular_color",
     .name = "specular",
     .label = "specular",
     .member = color_field(&Material::specular, k_channel, ColorUse::coefficient),
     .description = "k_s itself: white gives white highlights on colored plastic",
     .otherwise = "specular * color"},
    {"shininess", "shininess", "shininess", number_field(&Material::shininess, k_exponent),
     "the exponent n of the highlight"},
    {"mirror", "mirror", "mirror", number_field(&Material::mirror, k_fraction),
     "a, the part of the light that is reflected"},
    {"mirror_color", "mirror_tint", "mirror tint",
     color_field(&Material::mirror_tint, k_tint, ColorUse::surface), "the tint of what the mirror shows"},
    {"transmission", "transmission", "transmission", number_field(&Material::transmission, k_fraction),
     "the part of the light that is transmitted"},
    {"transmission_color", "transmission_tint", "transmission tint",
     color_field(&Material::transmission_tint, k_tint, ColorUse::surface), "the tint of what is transmitted"},
    {"ior", "ior", "index of refraction", number_field(&Material::ior, k_index_of_refraction),
     "the index of refraction"},
    {"casts_shadow", "casts_shadow", "casts a shadow", bool_field(&Material::casts_shadow),
     "false: the surface blocks no light"},
    // From here on: the fields of WorldParts::extended (world/appearance/extended_materials.h).
    {.key = "emission_color",
     .name = "emission",
     .label = "emission",
     .member = color_field(&Material::emission, k_channel, ColorUse::coefficient),
     .description = "k_e itself: light that the surface emits; it lights no other surface",
     .otherwise = "emission * color"},
    {"brilliance", "brilliance", "brilliance", number_field(&Material::brilliance, k_exponent),
     "the diffuse term is k_d (N.L)^brilliance"},
    {"metallic", "metallic", "metallic", number_field(&Material::metallic, k_fraction),
     "how far highlights have the surface's color, except at grazing light"},
    {.key = "phong_color",
     .name = "phong",
     .label = "second highlight",
     .member = color_field(&Material::phong, k_channel, ColorUse::coefficient),
     .description = "k_p: a second highlight, k_p (R.V)^phong_shininess, whatever the shading"},
    {"phong_shininess", "phong_shininess", "shininess of the second highlight",
     number_field(&Material::phong_shininess, k_exponent), "the exponent of the second highlight"},
    {"tinted_highlight", "tinted_highlight", "tinted highlight", bool_field(&Material::tinted_highlight),
     "false: highlights do not have the light's color"},
    {"mirror_falloff", "mirror_falloff", "falloff of the mirror",
     number_field(&Material::mirror_falloff, k_exponent),
     "if > 0, the mirror is mirror_min + (mirror - mirror_min) (1 - cos)^mirror_falloff"},
    {"mirror_min", "mirror_min", "least mirror", number_field(&Material::mirror_min, k_fraction),
     "the mirror for rays along the normal, if mirror_falloff > 0; with mirror_fresnel, the least mirror"},
    {"mirror_fresnel", "mirror_fresnel", "Fresnel mirror", bool_field(&Material::mirror_fresnel),
     "true: the mirror is mirror_min + (mirror - mirror_min) F, with F of Fresnel's equations by the ior"},
    {"conserve_energy", "conserve_energy", "conserve energy", bool_field(&Material::conserve_energy),
     "true: what filter and transmit let through is reduced by what the mirror reflects"},
    {"mirror_metallic", "mirror_metallic", "metallic mirror",
     number_field(&Material::mirror_metallic, k_fraction),
     "how far the mirror tints what it shows with the surface's color, except at grazing rays"},
    {"filter", "filter", "filter", number_field(&Material::filter, k_fraction),
     "transparency without refraction: the part of the light from behind that the color tints"},
    {"transmit", "transmit", "transmit", number_field(&Material::transmit, k_fraction),
     "the part that is not tinted"},
    {"outline", "outline", "outline", number_field(&Material::outline, k_fraction),
     "how dark diffuse light is where the surface turns away from the ray"},
    {"outline_width", "outline_width", "width of the outline",
     number_field(&Material::outline_width, k_fraction), "from 0, a thin outline, to 1, the whole surface"},
    {"angled_opacity", "angled_opacity", "opacity by the angle", bool_field(&Material::angled_opacity),
     "transmit grows where the surface turns to the ray, as in Raster3D"},
    {"hollow", "hollow", "hollow", bool_field(&Material::hollow),
     "fog_extent = outside_objects: rays inside are in the fog"},
    {"interior", "interior", "interior", whole_field(&Material::interior, k_interior),
     "above 0: the shapes of materials with the same number are one object for fog_extent"},
    {.key = "texture",
     .name = "texture",
     .label = "texture",
     .member = texture_field(&Material::texture),
     .description = "a picture that changes the color",
     .otherwise = "none"},
    {"one_sided", "one_sided", "one-sided", bool_field(&Material::one_sided),
     "true: rays that come from behind pass the surface; without effect if transmission > 0"},
    {"refracts", "refracts", "refracts", bool_field(&Material::refracts),
     "true: ior refracts the rays that filter and transmit let through"},
    {"fade_distance", "fade_distance", "fade distance",
     number_field(&Material::fade_distance, k_not_negative),
     "above 0: what filter and transmit let out fades with its distance in the shape"},
    {"fade_power", "fade_power", "fade power", number_field(&Material::fade_power, k_not_negative),
     "the power of the distance over fade_distance; from 1000 on the light falls exponentially"},
    {"fade_color", "fade_color", "fade color", color_field(&Material::fade_color, k_tint, ColorUse::surface),
     "what is left of white light after a long way"},
    {"caustics", "caustics", "caustics", number_field(&Material::caustics, k_not_negative),
     "above 0: the shadow's light that filter and transmit let through is times 1 + cos^caustics, of its "
     "angle to the normal"},
};

/// A key of .glint that gives a field as a factor of the color.
struct MaterialCoefficient {
    std::string_view key;
    Color Material::*field;
    double usual;  ///< the coefficient if only the color is given
    Range range;
    std::string_view description;
    bool if_given = false;  ///< without the key, the color does not set the field
};
inline constexpr Range k_coefficient{0, 1e6, false, false, "a coefficient from 0 to 1e6"};
inline constexpr MaterialCoefficient k_material_coefficients[] = {
    {"ambient", &Material::ambient, 0.1, k_coefficient, "k_a = ambient * color"},
    {"diffuse", &Material::diffuse, 0.8, k_coefficient, "k_d = diffuse * color"},
    {"specular", &Material::specular, 0, k_fraction, "k_s = specular * color, as in CGFS and RT2"},
    {"emission", &Material::emission, 0, k_coefficient, "k_e = emission * color", true},
};

/// The number of a member's row.
template <class Value> constexpr std::size_t material_field(Value Material::*member) {
    std::size_t i = 0;
    while (!is_field_of(k_material_fields[i], member)) ++i;
    return i;
}

/// The fields of the second table.
inline constexpr std::size_t k_first_extended_field = material_field(&Material::emission);
inline constexpr std::span<const ItemField<Material>> k_extended_fields{
    k_material_fields + k_first_extended_field, std::size(k_material_fields) - k_first_extended_field};

/// The coefficient that gives a field, or nullptr.
constexpr const MaterialCoefficient* coefficient_of(const ItemField<Material>& field) {
    for (const MaterialCoefficient& c : k_material_coefficients) {
        if (is_field_of(field, c.field)) return &c;
    }
    return nullptr;
}

/// Some order of all materials; of two with the same bits, neither is less.
inline bool less_bits(const Material& a, const Material& b) {
    for (const ItemField<Material>& field : k_material_fields) {
        // NOLINTNEXTLINE(modernize-use-nullptr): of clang-tidy 14, which takes the 0 of <=> for a pointer
        if (const auto order = compare_bits(field, a, b); order != 0) return order < 0;
    }
    return false;
}

}  // namespace glint
