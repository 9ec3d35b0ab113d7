#pragma once
// The causes that can be seen in the pictures alone.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "inspect/byte_picture.h"

namespace glint {

/// What a cause of the pictures is made from.
struct PictureSource {
    const Image& reference;     ///< floats: unclamped if the scene was drawn, else what the file holds
    const BytePicture& bytes;   ///< the same as bytes
    const BytePicture& faulty;  ///< the picture to explain
    const std::vector<std::uint8_t>& edges;  ///< the reference's
    bool unclamped = false;                  ///< the reference comes from the scene
    int threads = 0;
};

/// What the reference would be with one fault.
struct FaultyPicture {
    BytePicture picture;
    std::string detail;  ///< fills in {} of the explanation
};

struct PictureCause {
    const char* name;
    const char* explanation;
    double least;  ///< explained share from which it is named
    std::function<std::optional<FaultyPicture>(const PictureSource&)> make;
    int freedom =
        0;  ///< how much it can be bent to fit anything: named only if nothing of less explains well
};

/// The table, simple causes first: of two that explain the same, the earlier is named.
const std::vector<PictureCause>& picture_causes();

/// The factor k by which `part` must be multiplied for rest + k part to be `faulty`, by least squares over
/// the channels that differ from `bytes` and are clamped in neither; nothing if that is 1 or not above 0, or
/// there are too few. `rest` may be empty: 0. The vectors are as Image::rgb.
std::optional<double> fit_factor(const std::vector<float>& rest, const std::vector<float>& part,
                                 const BytePicture& bytes, const BytePicture& faulty);

}  // namespace glint
