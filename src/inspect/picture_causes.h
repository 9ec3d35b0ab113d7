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
    bool unclamped = false;     ///< the reference comes from the scene
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
};

/// The table, simple causes first: of two that explain the same, the earlier is named.
const std::vector<PictureCause>& picture_causes();

/// How many times as bright `faulty` is as `reference`, by least squares over the channels that differ and
/// are clamped in neither; nothing if that is 1, or there are too few.
std::optional<double> fit_scale(const Image& reference, const BytePicture& bytes, const BytePicture& faulty);

}  // namespace glint
