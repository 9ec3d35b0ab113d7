// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the shapes of CSC 473's .pov have in common: pigment, finish, and maps.
#include <optional>

#include "formats/load_state.h"

namespace glint {

/// A finish; what a text does not say is as here.
struct PovFinish {
    double ambient = 0, diffuse = 0, specular = 0, roughness = 1, reflection = 0, refraction = 0, ior = 1;
    friend bool operator==(const PovFinish&, const PovFinish&) = default;
};

struct PovColor {
    Color rgb;
    double filter = 0;
    friend bool operator==(const PovColor&, const PovColor&) = default;
};

/// What stands in a shape's block after its parameters.
struct PovAttributes {
    PovColor pigment;
    PovFinish finish;
    std::optional<Affine> map;        ///< world_from_object
    std::optional<Token> refraction;  ///< where it was given
};

/// "`#declare` is of POV-Ray's own language ...", or "expected X, found Y", at the current token.
void refuse_word(Parser& parser, std::string_view expected, std::span<const std::string_view> known);

/// Reads <x, y, z>. False after a mistake.
bool read_pov_vector(Parser& parser, Vec3& value);

/// Reads [color] rgb <r, g, b> or rgbf <r, g, b, f>. False after a mistake.
bool read_pov_color(Parser& parser, PovColor& color);

/// Reads to the `}` of the shape, `what` being its word, and over it. False after a mistake that leaves the
/// rest unread.
bool read_pov_attributes(Parser& parser, std::string_view what, PovAttributes& attributes);

}  // namespace glint
