#include "inspect/byte_picture.h"

#include <algorithm>
#include <cstdlib>

#include "base/parallel_for.h"
#include "image/levels.h"
#include "image/quantize.h"

namespace glint {

BytePicture to_bytes(const Image& image, int threads, Transfer transfer) {
    BytePicture picture{image.width, image.height, std::vector<std::uint8_t>(image.rgb.size())};
    const std::size_t row = std::size_t{3} * image.width;
    parallel_for(static_cast<std::size_t>(image.height), threads, [&](std::size_t y) {
        quantize_row(&image.rgb[y * row], row, 8, transfer, &picture.rgb[y * row]);
    });
    return picture;
}

std::vector<std::uint8_t> edges_of(const BytePicture& picture, int threads) {
    const Levels levels{{picture.rgb.begin(), picture.rgb.end()}, 1, picture.width, picture.height};
    return find_edges(levels, threads);
}

Distance distance(const BytePicture& a, const BytePicture& b, const std::vector<std::uint8_t>& edges) {
    std::uint64_t sum = 0, calm_sum = 0, pixels = 0, calm_pixels = 0;
    const std::int32_t rim = std::min(b.width, b.height) > 2 ? 1 : 0;
    for (std::int32_t y = rim; y < b.height - rim; ++y) {
        const std::uint8_t *of_a = a.pixel(0, y), *of_b = b.pixel(0, y);
        const std::uint8_t* on_edge = &edges[static_cast<std::size_t>(y) * b.width];
        for (std::int32_t x = rim; x < b.width - rim; ++x) {
            std::uint32_t here = 0, calm = 0;
            for (int c = 0; c < 3; ++c) {
                const auto d =
                    static_cast<std::uint32_t>(std::abs(int{of_a[3 * x + c]} - int{of_b[3 * x + c]}));
                here += d;
                calm += d > k_noise ? d - k_noise : 0;
            }
            sum += here;
            ++pixels;
            calm_sum += on_edge[x] != 0 ? 0 : calm;
            calm_pixels += on_edge[x] == 0;
        }
    }
    const auto mean = [](std::uint64_t total, std::uint64_t count) {
        return count == 0 ? 0 : static_cast<double>(total) / (3 * static_cast<double>(count));
    };
    return {mean(sum, pixels), mean(calm_sum, calm_pixels)};
}

}  // namespace glint
