// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shared by the shapes of CSC 473's .pov: pigment, finish and transforms.
#include <optional>

#include "formats/load_state.h"

namespace glint {

/// A finish; these are the defaults.
struct PovFinish {
    double ambient = 0, diffuse = 0, specular = 0, roughness = 1, reflection = 0, refraction = 0, ior = 1;
    friend bool operator==(const PovFinish&, const PovFinish&) = default;
};

struct PovColor {
    Color rgb;
    double filter = 0;
    friend bool operator==(const PovColor&, const PovColor&) = default;
};

/// The items in a shape's block after its parameters.
struct PovAttributes {
    PovColor pigment;
    PovFinish finish;
    std::optional<Affine> map;        ///< world_from_object
    std::optional<Token> refraction;  ///< the place where it was given
};

/// The first mistake in a text that is read as a scene of CSC 473; nothing if there is none.
std::optional<Diagnostic> first_csc473_error(const SceneText& text);

/// "`#declare` is of POV-Ray's own language ...", or "expected X, found Y", at the current token.
void refuse_word(Parser& parser, std::string_view expected, std::span<const std::string_view> known);

/// Reads <x, y, z>. False after an error.
bool read_pov_vector(Parser& parser, Vec3& value);

/// Reads [color] rgb <r, g, b> or rgbf <r, g, b, f>. False after an error.
bool read_pov_color(Parser& parser, PovColor& color);

/// Reads up to and including the `}` of the shape, whose word is `what`. False after an error that leaves the
/// rest unread.
bool read_pov_attributes(Parser& parser, std::string_view what, PovAttributes& attributes);

}  // namespace glint
