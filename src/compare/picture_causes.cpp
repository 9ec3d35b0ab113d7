// SPDX-License-Identifier: Apache-2.0
// The causes that can be seen in the pictures alone, as a table.
#include "compare/picture_causes.h"

#include "glint/compare.h"
#include "image/quantize.h"
#include "math/elementary.h"
#include "math/srgb.h"

namespace glint {
namespace {

// A cause without a free parameter needs to explain less than one that is fitted to the picture.
constexpr double k_moved = k_min_explained, k_curved = 0.7, k_min_fit = 0.85, k_specks = 0.4;

PictureFault power(double exponent) {
    return curved([=](double v) { return pow(v, exponent); });
}

}  // namespace

const std::vector<PictureCause>& picture_causes() {
    static const std::vector<PictureCause> table = {
        {"upside-down",
         "The picture is upside down: rows are counted from the bottom and the file counts from the top (or "
         "y points the other way). Write row H - 1 - y.",
         k_moved, upside_down(), 0, true, true},
        {"mirrored",
         "The picture is mirrored left to right: the camera's x axis points the other way (handedness). Swap "
         "the factors of the cross product that gives it, or negate x.",
         k_moved, mirrored(), 0, true, true},
        {"rotated", "The picture is rotated by 180 degrees: x and y both count in the wrong direction.",
         k_moved, rotated(), 0, true, true},
        {"transposed", "Rows and columns are swapped: the pixel (x, y) was written to (y, x).", k_moved,
         transposed(), 0, true, true},
        {"transposed",
         "Rows and columns are swapped and both count in the wrong direction: the pixel (x, y) was written "
         "to (H - 1 - y, W - 1 - x).",
         k_moved, transposed_back(), 0, true, true},
        {"turned-left",
         "The picture is rotated by 90 degrees to the left (counterclockwise): the pixel (x, y) was written "
         "to (y, W - 1 - x).",
         k_moved, turned_left(), 0, true},
        {"turned-right",
         "The picture is rotated by 90 degrees to the right (clockwise): the pixel (x, y) was written to "
         "(H - 1 - y, x).",
         k_moved, turned_right(), 0, true},
        {"rows-missing",
         "Rows are missing ({}): the program wrote nothing there. Check the loop over y, and the length of a "
         "row in bytes.",
         k_moved, unwritten(Lines::rows, true)},
        {"rows-missing",
         "Rows are missing ({}): the program wrote nothing there, or nothing is visible there. Check the "
         "loop over y, and the camera and the shapes.",
         k_moved, unwritten(Lines::rows, false), 1},
        {"columns-missing",
         "Columns are missing ({}): the program wrote nothing there. Check the loop over x.", k_moved,
         unwritten(Lines::columns, true)},
        {"columns-missing",
         "Columns are missing ({}): the program wrote nothing there, or nothing is visible there. Check the "
         "loop over x, and the camera and the shapes.",
         k_moved, unwritten(Lines::columns, false), 1},
        {"red-blue-swapped",
         "Red and blue are swapped: the file stores R, G, B, and B, G, R was written (or the reverse).",
         k_moved, permuted(2, 1, 0), 0, false, true},
        {"red-green-swapped", "Red and green are swapped.", k_moved, permuted(1, 0, 2), 0, false, true},
        {"green-blue-swapped", "Green and blue are swapped.", k_moved, permuted(0, 2, 1), 0, false, true},
        {"channels-rotated", "The channels are rotated: R, G, B are written as G, B, R.", k_moved,
         permuted(1, 2, 0)},
        {"channels-rotated", "The channels are rotated: R, G, B are written as B, R, G.", k_moved,
         permuted(2, 0, 1)},
        {"channel-copied", "Blue is a copy of green: a line was copied and not changed.", k_moved,
         permuted(0, 1, 1)},
        {"channel-copied", "Blue is a copy of red: a line was copied and not changed.", k_moved,
         permuted(0, 1, 0)},
        {"channel-copied", "Green is a copy of red: a line was copied and not changed.", k_moved,
         permuted(0, 0, 2)},
        {"channel-missing", "Red is 0 everywhere: it is not computed, or not written.", k_moved,
         channels_left(false, true, true)},
        {"channel-missing", "Green is 0 everywhere: it is not computed, or not written.", k_moved,
         channels_left(true, false, true)},
        {"channel-missing", "Blue is 0 everywhere: it is not computed, or not written.", k_moved,
         channels_left(true, true, false)},
        {"channel-missing", "There is only red: the other two channels are 0 everywhere.", k_moved,
         channels_left(true, false, false)},
        {"channel-missing", "There is only green: the other two channels are 0 everywhere.", k_moved,
         channels_left(false, true, false)},
        {"channel-missing", "There is only blue: the other two channels are 0 everywhere.", k_moved,
         channels_left(false, false, true)},
        {"grey", "All three channels contain red.", k_moved, grey(1, 0, 0)},
        {"grey", "All three channels contain green.", k_moved, grey(0, 1, 0)},
        {"grey", "All three channels contain blue.", k_moved, grey(0, 0, 1)},
        {"grey", "The picture is grey: all three channels contain the mean of red, green and blue.", k_moved,
         grey(1.0 / 3, 1.0 / 3, 1.0 / 3)},
        {"grey", "The picture is grey: all three channels contain 0.299 R + 0.587 G + 0.114 B.", k_moved,
         grey(0.299, 0.587, 0.114)},
        {"grey", "The picture is grey: all three channels contain 0.2126 R + 0.7152 G + 0.0722 B.", k_moved,
         grey(0.2126, 0.7152, 0.0722)},
        {"inverted", "The picture is a negative: 1 - value was written.", k_moved,
         curved([](double v) { return 1 - v; })},
        {"shifted-one-pixel", k_shift_text, k_curved, shifted()},
        {"gamma-applied",
         "The sRGB curve was applied once more than in the reference: omit it (or, if the reference has it, "
         "apply it only once, at the end).",
         k_curved, curved(srgb_encode)},
        {"gamma-applied",
         "A gamma of 1/2.2 was applied once more than in the reference: omit it (or, if the reference has "
         "it, apply it only once, at the end).",
         k_curved, power(1 / 2.2)},
        {"gamma-missing",
         "The reference has the sRGB curve and the picture does not (or its colors were decoded once too "
         "often): apply the curve once, at the end.",
         k_curved, curved(srgb_decode)},
        {"gamma-missing",
         "The reference has a gamma of 1/2.2 and the picture does not (or it was decoded once too often): "
         "apply it once, at the end.",
         k_curved, power(2.2)},
        {"gamma-applied",
         "A gamma of 1/{} was applied once more than in the reference: omit it (or, if the reference has it, "
         "apply it only once, at the end).",
         k_min_fit, to_a_power(true), 0, false, false, false, 1},
        {"gamma-missing",
         "The reference has a gamma of 1/{} and the picture does not (or it was decoded once too often): "
         "apply it once, at the end.",
         k_min_fit, to_a_power(false), 0, false, false, false, 1},
        {"gamma-twice",
         "The sRGB curve was applied two times more than in the reference: omit it (or, if the reference has "
         "it, apply it only once, at the end).",
         k_curved, curved([](double v) { return srgb_encode(srgb_encode(v)); })},
        {"gamma-twice",
         "A gamma of 1/2.2 was applied two times more than in the reference: omit it (or, if the reference "
         "has it, apply it only once, at the end).",
         k_curved, power(1 / (2.2 * 2.2))},
        {k_rounded_down,
         "Values are truncated and not rounded to bytes: write floor(255 v + 0.5). The difference is 1/255 "
         "at most.",
         k_curved, whole_part(255, false)},
        {k_rounded_down, "Bytes are floor(256 v) and not 255 v rounded. The difference is 1/255 at most.",
         k_curved, whole_part(256, false)},
        {"not-clamped", "Colors above 1 wrap around to black: clamp to 1 before converting to a byte.",
         k_moved, whole_part(255, true)},
        {"colors-truncated",
         "The color of a pixel is truncated to 0 or 1: multiply by 255 before converting to an integer.",
         k_curved, truncated(true)},
        {"colors-truncated",
         "The color of surfaces is truncated to 0 or 1: multiply by 255 before converting to an integer.",
         k_curved, truncated(false)},
        {"light-intensity",
         "Everything is {} times as bright: a light's intensity, or a factor of all lights.", k_min_fit,
         scaled()},
        {"constant-added",
         "{} of 255 was added to every channel: a constant light was added, or a term was added twice.",
         k_min_fit, raised()},
        {"background",
         "One color was replaced by another and nothing else differs: {}. Usually it is the background.",
         k_min_fit, recolored(), 0, false, false, false, k_detail_parameters},
        {"background",
         "Where a ray hits nothing, the pixel before it is repeated: set its color to the background's.",
         k_moved, repeated()},
        {"half-resolution", "Blocks of 2 x 2 pixels have one color: the picture has half the resolution.",
         k_min_fit, halved(), 1},
        {"shifted-half-pixel", k_half_shift_text, k_min_fit, half_shifted(), 1, false, false, true},
        {"acne",
         "Dark specks on lit surfaces (acne): a shadow ray hits the surface that it starts from. Move its "
         "origin off the surface, or ignore hits with t below a small epsilon.",
         k_specks, dark_specks(), 1},
        {"anti-aliasing",
         "Only edges differ: the number or the positions of the samples in a pixel, not the lighting.",
         k_min_fit, anti_aliased(), 2},
        {"rim",
         "Only the outermost pixels differ ({}): a loop over the pixels begins or ends one pixel too early "
         "or too late, or pixels outside the picture are taken as 0.",
         k_moved, rim_differs(), 2},
    };
    return table;
}

}  // namespace glint
