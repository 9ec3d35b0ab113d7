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

/// What a fault is made from, and how much of it.
struct PictureSource {
    const Image& reference;     ///< floats: unclamped if the scene was drawn, else what the file holds
    const BytePicture& bytes;   ///< the same as bytes
    const BytePicture& faulty;  ///< the picture to explain
    const Area& fit;            ///< where what is fitted to `faulty` is fitted
    const Rows& rows;           ///< to make
    bool unclamped = false;     ///< the reference comes from the scene
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
/// Where they are not whole rows or columns.
PictureFault dark_specks();
/// Rows or columns that were never written.
PictureFault unwritten(Lines lines);
/// Of pictures that differ nowhere else.
PictureFault rim_differs();

// ---- What a channel becomes ----

/// Red, green and blue are those channels of the reference: 0 to 2.
PictureFault permuted(int red, int green, int blue);
/// Red, green and blue are that sum of the reference's.
PictureFault grey(double red, double green, double blue);
/// A channel that is not there is 0.
PictureFault channels_left(bool red, bool green, bool blue);
/// Each channel value, clamped to 0 to 1, through a curve.
PictureFault curved(std::function<double(double)> curve);
double srgb_decoded(double v);
/// Everything by a factor that is fitted.
PictureFault scaled();
/// A number is added to everything, which is fitted.
PictureFault raised();
/// The whole part of value * scale, of which a byte keeps the lowest bits, or the most it can hold.
PictureFault whole_part(double scale, bool wraps);
/// One colour is another: of the different pixels, what most have.
PictureFault recolored();

/// The factor k by which `part` must be multiplied for rest + k part to be `faulty`, by least
/// absolute differences over the channels of these rows that differ from `bytes` and are clamped in neither;
/// nothing if that is 1 or not above 0, or there are too few. `rest` may be empty: 0. The vectors are as
/// Image::rgb.
std::optional<double> fit_factor(const std::vector<float>& rest, const std::vector<float>& part,
                                 const BytePicture& bytes, const BytePicture& faulty, const Rows& rows);

}  // namespace glint
