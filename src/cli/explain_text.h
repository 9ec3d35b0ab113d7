// SPDX-License-Identifier: Apache-2.0
#pragma once
// An explanation as text: for people in a terminal, and in CSC 473's own layout.
#include <string>

#include "glint/explain.h"

namespace glint::cli {

struct ExplainStyle {
    bool colors = false;      ///< swatches, by the terminal's 24-bit colours
    bool from_below = false;  ///< rows are counted from the bottom
    int sample = 0;           ///< the one whose rays are told: row n + column
    EncodeOptions file;       ///< whose numbers are told
};

/// The tree of rays of a sample, then the pixel's sum.
std::string explanation_text(const Explanation& explanation, const Scene& scene, const ExplainStyle& style);

/// A line a sample: its value, and what its camera ray hits. The explanation must be of all samples.
std::string samples_text(const Explanation& explanation, const Scene& scene, const ExplainStyle& style);

/// What one light (a number in Scene::lights) does where the sample's camera ray hits, and what would change
/// it.
std::string why_not_text(const Explanation& explanation, const Scene& scene, std::uint32_t light,
                         const ExplainStyle& style);

/// CSC 473's `printrays`: a block a ray, each followed by those it lets go. y: the pixel's row as the user
/// counts it.
std::string print_rays(const Explanation& explanation, const Scene& scene, int y, const ExplainStyle& style);

/// The number of a sample's camera ray.
std::size_t camera_ray(const Explanation& explanation, int sample);

/// "(0.5, 0.25, 0)", or one number for grey.
std::string color_text(Color c);
/// A piece of line in that colour, where the style has colours.
std::string swatch(const ExplainStyle& style, Color c);

/// "sphere 'ball' (castle.json:12:5)", as far as it is known.
std::string shape_text(const Scene& scene, std::uint32_t shape);
/// "point light 'key' (castle.json:40:3)"; one without a name has its number in the scene, from 1.
std::string light_text(const Scene& scene, std::uint32_t light);

}  // namespace glint::cli
