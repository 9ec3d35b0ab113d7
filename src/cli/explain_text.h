// SPDX-License-Identifier: Apache-2.0
#pragma once
// An explanation as text, for the terminal or in the layout of CSC 473.
#include <string>

#include "glint/explain.h"

namespace glint::cli {

/// --aa up to which samples are listed one by one.
constexpr int k_max_listed_samples = 8;

/// Half a step of a byte: what less adds is not visible.
inline constexpr double k_default_fold = 0.5;

struct ExplainStyle {
    bool colors = false;      ///< print swatches in 24-bit terminal colors
    bool from_below = false;  ///< rows are counted from the bottom
    int sample = 0;           ///< the sample whose rays are printed: row * n + column
    /// Secondary rays that add less than this to each channel, with the rays that follow them, are one line;
    /// in 255ths. 0: all rays are printed.
    double fold = k_default_fold;
    EncodeOptions file;  ///< the encoding of the file's numbers
};

/// The ray tree of a sample, then the pixel's sum.
std::string explanation_text(const Explanation& explanation, const Scene& scene, const ExplainStyle& style);

/// One line per sample: its value and what its camera ray hits. Requires an explanation of all samples.
std::string samples_text(const Explanation& explanation, const Scene& scene, const ExplainStyle& style);

/// What one light (an index in Scene::lights) adds where the sample's camera ray hits, and what would change
/// it.
std::string why_not_text(const Explanation& explanation, const Scene& scene, std::uint32_t light,
                         const ExplainStyle& style);

/// `printrays` of CSC 473: one block per ray, followed by its secondary rays. y: the pixel's row as the user
/// counts it.
std::string print_rays(const Explanation& explanation, const Scene& scene, int y, const ExplainStyle& style);

/// The index of a sample's camera ray.
std::size_t camera_ray(const Explanation& explanation, int sample);

/// "(0.5, 0.25, 0)", or one number for grey.
std::string color_text(Color c);
/// A colored block if the style has colors, else an empty text.
std::string swatch(const ExplainStyle& style, Color c);

/// "sphere 'ball' (castle.json:12:5)"; without the parts that are unknown.
std::string shape_text(const Scene& scene, std::uint32_t shape);
/// "point light 'key' (castle.json:40:3)"; a light without a name gets its number in the scene, from 1.
std::string light_text(const Scene& scene, std::uint32_t light);
/// "texture 'wood' (castle.glint:3:1)"
std::string texture_item_text(const Scene& scene, std::uint32_t texture);

}  // namespace glint::cli
