#include "inspect/byte_picture.h"

#include <cstdlib>
#include <stdexcept>

namespace glint {

BytePicture to_bytes(const Image& image, int threads, Transfer transfer) {
    EncodeOptions options;
    options.format = FileFormat::ppm;
    options.threads = threads;
    options.transfer = transfer;
    EncodeResult encoded = encode(image, options);
    if (!encoded.error.empty()) throw std::runtime_error(encoded.error);
    BytePicture picture{image.width, image.height, std::move(encoded.bytes)};
    const std::size_t header = picture.rgb.size() - image.rgb.size();
    picture.rgb.erase(picture.rgb.begin(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(header));
    return picture;
}

double mean_difference(const BytePicture& a, const BytePicture& b) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < b.rgb.size(); ++i)
        sum += static_cast<std::uint64_t>(std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
    return static_cast<double>(sum) / static_cast<double>(b.rgb.size());
}

}  // namespace glint
