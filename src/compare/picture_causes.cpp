// SPDX-License-Identifier: Apache-2.0
// The causes that can be seen in the pictures alone, as a table.
#include "compare/picture_causes.h"

#include "glint/compare.h"
#include "image/quantize.h"
#include "math/elementary.h"

namespace glint {
namespace {

// What has no free parameter is believed earlier than what is fitted to the picture.
constexpr double k_moved = k_min_explained, k_curved = 0.7, k_fitted = 0.85, k_specks = 0.4;

}  // namespace

const std::vector<PictureCause>& picture_causes() {
    static const std::vector<PictureCause> table = {
        {"upside-down",
         "The picture is upside down: rows are counted from the bottom where the file counts from the top "
         "(or y "
         "points the other way). Write row H - 1 - y.",
         k_moved, upside_down(), 0, true, true},
        {"mirrored",
         "The picture is mirrored left to right: the camera's x axis points the other way (handedness). Swap "
         "the "
         "factors of the cross product that makes it, or negate x.",
         k_moved, mirrored(), 0, true, true},
        {"rotated", "The picture is turned by half a turn: both x and y count the wrong way.", k_moved,
         rotated(), 0, true, true},
        {"transposed", "Rows and columns are swapped: the pixel (x, y) was written to (y, x).", k_moved,
         transposed(), 0, true, true},
        {"transposed",
         "Rows and columns are swapped and both count the wrong way: the pixel (x, y) was written to "
         "(H - 1 - y, W - 1 - x).",
         k_moved, transposed_back(), 0, true, true},
        {"turned-left",
         "The picture is turned by a quarter turn to the left (counterclockwise): the pixel (x, y) was "
         "written "
         "to (y, W - 1 - x).",
         k_moved, turned_left(), 0, true},
        {"turned-right",
         "The picture is turned by a quarter turn to the right (clockwise): the pixel (x, y) was written to "
         "(H - 1 - y, x).",
         k_moved, turned_right(), 0, true},
        {"rows-missing",
         "Rows are missing ({}): nothing was written there. Look at the loop over y, and at the length of a "
         "row "
         "in bytes.",
         k_moved, unwritten(Lines::rows)},
        {"columns-missing", "Columns are missing ({}): nothing was written there. Look at the loop over x.",
         k_moved, unwritten(Lines::columns)},
        {"red-blue-swapped",
         "Red and blue are swapped: the file wants R, G, B and was given B, G, R (or the other way round).",
         k_moved, permuted(2, 1, 0), 0, false, true},
        {"red-green-swapped", "Red and green are swapped.", k_moved, permuted(1, 0, 2), 0, false, true},
        {"green-blue-swapped", "Green and blue are swapped.", k_moved, permuted(0, 2, 1), 0, false, true},
        {"channels-rotated", "The channels have moved on by one: R, G, B arrive as G, B, R.", k_moved,
         permuted(1, 2, 0)},
        {"channels-rotated", "The channels have moved on by one: R, G, B arrive as B, R, G.", k_moved,
         permuted(2, 0, 1)},
        {"channel-missing", "Red is 0 everywhere: it is never added up, or never written.", k_moved,
         channels_left(false, true, true)},
        {"channel-missing", "Green is 0 everywhere: it is never added up, or never written.", k_moved,
         channels_left(true, false, true)},
        {"channel-missing", "Blue is 0 everywhere: it is never added up, or never written.", k_moved,
         channels_left(true, true, false)},
        {"channel-missing", "There is only red: the other two channels are 0 everywhere.", k_moved,
         channels_left(true, false, false)},
        {"channel-missing", "There is only green: the other two channels are 0 everywhere.", k_moved,
         channels_left(false, true, false)},
        {"channel-missing", "There is only blue: the other two channels are 0 everywhere.", k_moved,
         channels_left(false, false, true)},
        {"grey", "All three channels hold red.", k_moved, grey(1, 0, 0)},
        {"grey", "All three channels hold green.", k_moved, grey(0, 1, 0)},
        {"grey", "All three channels hold blue.", k_moved, grey(0, 0, 1)},
        {"grey", "The picture is grey: all three channels hold the mean of red, green and blue.", k_moved,
         grey(1.0 / 3, 1.0 / 3, 1.0 / 3)},
        {"grey", "The picture is grey: all three channels hold 0.299 R + 0.587 G + 0.114 B.", k_moved,
         grey(0.299, 0.587, 0.114)},
        {"grey", "The picture is grey: all three channels hold 0.2126 R + 0.7152 G + 0.0722 B.", k_moved,
         grey(0.2126, 0.7152, 0.0722)},
        {"inverted", "The picture is a negative: 1 - value was written.", k_moved,
         curved([](double v) { return 1 - v; })},
        {"shifted-one-pixel",
         "Everything is one pixel {}: an index begins at 1, or a half too many is rounded.", k_curved,
         shifted()},
        {"gamma-applied",
         "The sRGB curve was applied once more than in the reference: leave it out (or, if the reference has "
         "it, "
         "apply it once, at the very end).",
         k_curved, curved(srgb_encode)},
        {"gamma-applied",
         "A gamma of 1/2.2 was applied once more than in the reference: leave it out (or, if the reference "
         "has "
         "it, apply it once, at the very end).",
         k_curved, curved([](double v) { return pow(v, 1 / 2.2); })},
        {"gamma-missing",
         "The reference has the sRGB curve and the picture has not (or its colours were decoded once too "
         "often): "
         "apply it once, at the very end.",
         k_curved, curved(srgb_decoded)},
        {"gamma-missing",
         "The reference has a gamma of 1/2.2 and the picture has not (or it was decoded once too often): "
         "apply "
         "it once, at the very end.",
         k_curved, curved([](double v) { return pow(v, 2.2); })},
        {"gamma-twice",
         "The sRGB curve was applied twice more than in the reference: leave it out (or, if the reference "
         "has "
         "it, apply it once, at the very end).",
         k_curved, curved([](double v) { return srgb_encode(srgb_encode(v)); })},
        {"gamma-twice",
         "A gamma of 1/2.2 was applied twice more than in the reference: leave it out (or, if the reference "
         "has it, apply it once, at the very end).",
         k_curved, curved([](double v) { return pow(v, 1 / (2.2 * 2.2)); })},
        {"rounded-down",
         "Bytes are cut off and not rounded: write floor(255 v + 0.5). The difference is 1/255 at most.",
         k_curved, whole_part(255, false)},
        {"rounded-down", "Bytes are floor(256 v) in place of 255 v rounded. The difference is 1/255 at most.",
         k_curved, whole_part(256, false)},
        {"not-clamped",
         "Colours above 1 begin again at black: clamp to 1 before making a byte of 255 times the value.",
         k_moved, whole_part(255, true)},
        {"light-intensity",
         "Everything is {} times as bright: a light's intensity, or a factor of all lights.", k_fitted,
         scaled()},
        {"constant-added",
         "{} of 255 was added to every channel: something lights what nothing should, or is added twice.",
         k_fitted, raised()},
        {"background", "One colour is another, and nothing else: {}. Most often the background.", k_fitted,
         recolored()},
        {"shifted-half-pixel",
         "Everything is half a pixel {}: rays pass through a pixel's middle (x + 0.5) here and its corner "
         "there.",
         k_fitted, half_shifted(), 1},
        {"acne",
         "Dark specks on lit surfaces (acne): a shadow ray hits the very surface it leaves. Start it a "
         "little off "
         "the surface, or ignore hits with t below a small epsilon.",
         k_specks, dark_specks(), 1},
        {"anti-aliasing",
         "Only edges differ: the number or the places of the samples in a pixel, not the lighting.", k_fitted,
         anti_aliased(), 2},
        {"rim",
         "Only the outermost pixels differ ({}): a loop over the pixels begins or ends one too early or too "
         "late, or what is beyond the rim is taken for 0.",
         k_moved, rim_differs(), 2},
    };
    return table;
}

}  // namespace glint
