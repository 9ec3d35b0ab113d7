// SPDX-License-Identifier: Apache-2.0
#pragma once
// The comparison of two pictures, and the classic causes of a difference.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/callback.h"
#include "glint/export.h"
#include "glint/image.h"
#include "glint/result.h"
#include "glint/scene.h"

namespace glint {

// ---- Figures ----

/// In 255ths: a pixel of the reference is on an edge if a channel varies by more than this in its 3x3
/// neighbourhood. (Edges of the other picture do not count, or a fault could hide itself.)
inline constexpr double k_edge_step = 25;

struct CompareOptions {
    /// false: compare the bytes that encode() writes. true: compare floats without clamping; pixels are equal
    /// if the numbers are.
    bool as_floats = false;
    double within = 2;  ///< in 255ths, 0 to 255
    int threads = 0;
    /// Bytes that compare() may take beyond the pictures; it uses fewer threads to keep to it. 0: 64 MiB, and
    /// 1 byte for each pixel.
    std::uint64_t max_memory = 0;
};

/// Numbers of pixels by the largest difference of their channels.
struct PixelCounts {
    std::uint64_t pixels = 0, equal = 0;
    std::uint64_t within_1 = 0;  ///< at most 1/255, equal ones included
    std::uint64_t within = 0;    ///< at most CompareOptions::within 255ths
};

/// The difference of one channel of one pixel.
struct LargestDifference {
    double value = 0;            ///< in 255ths
    std::int32_t x = 0, y = 0;   ///< from the top left
    float a[3] = {}, b[3] = {};  ///< the pixel's colors
};

struct PictureDifference {
    PixelCounts all, edges, interiors;
    /// Pixels with a channel that is infinite or NaN in either picture. They are never equal, nor within any
    /// limit; the figures below count such a channel as 0.
    std::uint64_t not_finite = 0;
    double mean = 0, rms = 0;    ///< over all channels, in 255ths
    std::optional<double> psnr;  ///< decibels relative to 1.0; absent for equal pictures
    /// Structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004) of the luminance 0.299 R + 0.587 G +
    /// 0.114 B: windows of 11 x 11 with a Gaussian of sigma 1.5, K1 = 0.01, K2 = 0.03, only those completely
    /// inside the picture. Absent if a side is shorter than 11 pixels.
    std::optional<double> ssim;
    LargestDifference largest;
};

/// Compares picture a with the reference b. An error if their sizes differ, or if max_memory is exceeded.
/// Never throws.
GLINT_API Result<PictureDifference> compare(const Image& a, const Image& b,
                                            const CompareOptions& options = {});

/// |a - b| as a picture: every channel is multiplied by `gain` (0: the factor that makes the largest 1) and
/// clamped to 1. Channels that are not finite become 1. An error if the sizes differ. Never throws.
GLINT_API Result<Image> difference_image(const Image& a, const Image& b, double gain = 0);

// ---- Causes ----

/// A cause is reported if it explains at least this fraction of a difference.
inline constexpr double k_min_explained = 0.6;

/// One explanation of a difference.
struct Cause {
    std::string name;         ///< an id: "ambient-missing"
    std::string explanation;  ///< what it is and how to correct it, in one or two sentences
    double explained = 0;     ///< fraction of the mean difference that it removes, k_min_explained to 1
    double remaining = 0;     ///< remaining mean difference, in 255ths
    bool rendered = false;    ///< found by rendering the scene with the fault
    bool perhaps = false;     ///< likely, not certain: the remaining difference is more than rounding
};

struct CauseReport {
    /// The mean difference of the pictures in 255ths. The border of one pixel counts only if nothing else
    /// differs.
    double difference = 0;
    /// True if the pictures agree: no channel of a byte differs by more than 1, as rounding does. Then no
    /// cause is named, unless the bytes were truncated.
    bool agrees = false;
    /// An observation without a cause: "The picture is one color throughout, (0, 0, 0)."; empty if none.
    std::string remark;
    std::vector<Cause> causes;  ///< the best first; none if no cause explains enough
    /// A second cause, if one cause does not explain the whole difference: it explains it together with the
    /// first. `explained` is that of both; of the first alone it may be less than k_min_explained.
    std::vector<Cause> then;
    /// With a scene, if no cause is certain: the shapes at the difference, and the fraction at each.
    std::string where;
    /// If there are no causes: the best candidate, which explains too little and may be unrelated.
    std::optional<Cause> nearest;
    int tried = 0;  ///< number of causes tried
    /// True if only differences away from edges and above 2/255 are counted, because another renderer's
    /// samples and roundings hide the rest.
    bool away_from_edges = false;
    /// With a scene: the mean difference between its rendering and each picture, in 255ths.
    std::optional<double> scene_from_a, scene_from_b;
    /// True if the scene gives a, not b: the causes then explain b's difference from a.
    bool swapped = false;
};

struct CauseOptions {
    /// Compares the pictures as floats. Differences that bytes do not show (above 1, or too small) are then
    /// explained only by a factor. Otherwise the pictures are compared as bytes.
    bool as_floats = false;
    int threads = 0;
    /// Called on the calling thread, at intervals, with the fraction done (0 to 1). Must not throw.
    Function<void(double)> progress = {};
    CancelFlag cancel = {};  ///< checked between causes
    /// Bytes that find_causes() may take beyond the pictures and the prepared scene. It needs 7 for each
    /// pixel of the reference and 3 for each pixel of a picture, and with a scene 30 more for each of the
    /// reference; if too few pixels differ for a sample, another 100. 0: all that, and 256 MiB.
    std::uint64_t max_memory = 0;
};

/// Finds the causes that best explain how picture `a` differs from the reference `b`. Without a scene, only
/// causes that are visible in the pictures are tried (flipped, shifted, channels, gamma, scale). With the
/// scene of b, faults of lighting and tracing are tried too, by rendering the scene with each.
/// docs/compare.md lists the causes and their ranking. An error if the sizes differ, the scene cannot be
/// rendered, or max_memory is exceeded. Never throws.
GLINT_API Result<CauseReport> find_causes(const Image& a, const Image& b, const Scene* scene = nullptr,
                                          const CauseOptions& options = {});

/// The same for many pictures and one reference; each fault is rendered only once. The results are in the
/// order of `pictures`, each with its own error.
GLINT_API std::vector<Result<CauseReport>> find_causes(std::span<const Image> pictures, const Image& b,
                                                       const Scene* scene, const CauseOptions& options = {});

}  // namespace glint
