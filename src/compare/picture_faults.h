// SPDX-License-Identifier: Apache-2.0
#pragma once
// Faults of pictures: what a reference would be with each.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/byte_picture.h"
#include "compare/lines.h"

namespace glint {

/// What a fault is applied to, and which rows of it.
struct PictureSource {
    const PictureView reference;  ///< unclamped if the scene was rendered, else the numbers of the file
    const BytePicture& bytes;     ///< the same as bytes
    const BytePicture& faulty;    ///< the picture to explain
    const Area& fit;              ///< where what is fitted to `faulty` is fitted
    const Rows& rows;             ///< to make
    bool unclamped = false;       ///< the reference comes from the scene
    /// One mark per pixel of the reference: whether the scene's camera sees no shape there. Null: unknown.
    const std::vector<bool>* background = nullptr;
};

/// Makes these rows of `made`, a picture of the reference's size, as they would be with the fault. Nothing if
/// the fault does not apply; else what fills in {} of its explanation.
using PictureFault = std::function<std::optional<std::string>(const PictureSource&, BytePicture& made)>;

// ---- Where a pixel comes from ----

PictureFault upside_down();
PictureFault mirrored();
PictureFault rotated();
/// Of square pictures: by a quarter turn, and rows and columns swapped, along either diagonal.
PictureFault turned_left();
PictureFault turned_right();
PictureFault transposed();
PictureFault transposed_back();
/// By a pixel, in the best of eight directions.
PictureFault shifted();
PictureFault half_shifted();
PictureFault anti_aliased();
/// Blocks of 2 x 2 pixels have one color. Only if all of the picture to explain has.
PictureFault halved();
/// What is not of a shape has the color of the pixel before it.
PictureFault repeated();
/// Except in whole rows or columns that differ.
PictureFault dark_specks();
/// Rows or columns that were never written. regular: MissingLines::is_regular.
PictureFault unwritten(Lines lines, bool regular);
/// Only if the pictures differ nowhere else.
PictureFault rim_differs();

// ---- What a channel becomes ----

/// Red, green and blue are those channels of the reference: 0 to 2.
PictureFault permuted(int red, int green, int blue);
/// All channels are this weighted sum of the reference's. Only if the picture to explain is grey.
PictureFault grey(double red, double green, double blue);
/// The other channels are 0.
PictureFault channels_left(bool red, bool green, bool blue);
/// Each channel value, clamped to 0 to 1, through a monotonic curve.
PictureFault curved(std::function<double(double)> curve);
/// To a fitted power, 1 / gamma if `encodes`, else gamma, which is 1.2 to 3 in tenths. Only if that gives
/// nearly all of the picture to explain.
PictureFault to_a_power(bool encodes);
/// All values times a fitted factor.
PictureFault scaled();
/// A fitted number is added to all values.
PictureFault raised();
/// floor(value * scale) as a byte: its lowest eight bits if it wraps, else at most 255.
PictureFault whole_part(double scale, bool wraps);
/// Each channel value of surfaces becomes 0 or 1, rounded down, and that of the background, too, or not. Only
/// if the picture to explain has hardly other values there.
PictureFault truncated(bool background);
/// One color is replaced by another: the commonest change of the pixels that differ.
PictureFault recolored();

/// The factor k by which `part` must be multiplied for rest + k part to be `faulty`, by least
/// absolute differences over the channels of these rows that differ from `bytes` and are clamped in neither;
/// nothing if that is 1 or not above 0, or there are too few. `rest` may be empty: 0. It is as
/// Image::rgb.
std::optional<double> fit_factor(const std::vector<float>& rest, const PictureView& part,
                                 const BytePicture& bytes, const BytePicture& faulty, const Rows& rows);

}  // namespace glint
