// SPDX-License-Identifier: Apache-2.0
// The figures of the difference between two pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fp_environment.h"
#include "base/parallel_for.h"
#include "base/status.h"
#include "glint/compare.h"
#include "image/levels.h"
#include "image/quantize.h"
#include "math/elementary.h"

namespace glint {
namespace {

double decibels(double mean_square) { return 10 * log(255.0 * 255.0 / mean_square) / log(10); }

// The sums of one row.
struct RowSums {
    PixelCounts edges, interiors;
    std::uint64_t not_finite = 0;
    double sum = 0, squares = 0;
    double largest = 0;
    std::int32_t x = 0;
};

// `finite` marks the pixels that are finite in both pictures.
RowSums sum_row(const float* a, const float* b, const std::uint8_t* edges, const std::uint8_t* finite,
                std::int32_t width, double unit, double within) {
    RowSums row;
    for (std::int32_t x = 0; x < width; ++x) {
        double worst = 0;
        for (int c = 0; c < 3; ++c) {
            const double d =
                unit * std::fabs(static_cast<double>(a[3 * x + c]) - static_cast<double>(b[3 * x + c]));
            row.sum += d;
            row.squares += d * d;
            worst = std::max(worst, d);
        }
        PixelCounts& counts = edges[x] != 0 ? row.edges : row.interiors;
        ++counts.pixels;
        row.not_finite += finite[x] == 0;
        counts.equal += finite[x] != 0 && worst == 0;
        counts.within_1 += finite[x] != 0 && worst <= 1;
        counts.within += finite[x] != 0 && worst <= within;
        if (worst > row.largest) {
            row.largest = worst;
            row.x = x;
        }
    }
    return row;
}

void add(PixelCounts& to, const PixelCounts& more) {
    to.pixels += more.pixels;
    to.equal += more.equal;
    to.within_1 += more.within_1;
    to.within += more.within;
}

std::vector<std::uint8_t> finite_pixels(const Image& a, const Image& b, int threads) {
    std::vector<std::uint8_t> marks(a.rgb.size() / 3);
    parallel_for(static_cast<std::size_t>(a.height), threads, [&](std::size_t y) {
        for (std::size_t i = y * a.width; i < (y + 1) * a.width; ++i)
            marks[i] = is_finite_pixel(&a.rgb[3 * i]) && is_finite_pixel(&b.rgb[3 * i]);
    });
    return marks;
}

PictureDifference measure(const Image& a, const Image& b, const CompareOptions& options) {
    const std::int32_t width = b.width, height = b.height;
    const Levels of_a = levels_of(a, options.as_floats, options.threads),
                 of_b = levels_of(b, options.as_floats, options.threads);
    const auto edges = find_edges(of_b, options.threads);
    const auto finite = finite_pixels(a, b, options.threads);
    std::vector<RowSums> rows(static_cast<std::size_t>(height));
    parallel_for(rows.size(), options.threads, [&](std::size_t y) {
        const std::size_t start = y * width;
        rows[y] = sum_row(&of_a.values[3 * start], &of_b.values[3 * start], &edges[start], &finite[start],
                          width, of_a.unit, options.within);
    });
    PictureDifference result;
    double sum = 0, squares = 0;
    for (std::size_t y = 0; y < rows.size(); ++y) {
        const RowSums& row = rows[y];
        add(result.edges, row.edges);
        add(result.interiors, row.interiors);
        result.not_finite += row.not_finite;
        sum += row.sum;
        squares += row.squares;
        if (row.largest > result.largest.value) {
            result.largest.value = row.largest;
            result.largest.x = row.x;
            result.largest.y = static_cast<std::int32_t>(y);
        }
    }
    result.all = result.edges;
    add(result.all, result.interiors);
    const double channels = 3 * static_cast<double>(result.all.pixels);
    result.mean = sum / channels;
    result.rms = std::sqrt(squares / channels);
    if (squares > 0) result.psnr = decibels(squares / channels);
    const std::size_t at = 3 * (static_cast<std::size_t>(result.largest.y) * width + result.largest.x);
    for (int c = 0; c < 3; ++c) {
        result.largest.a[c] = of_a.values[at + c] * static_cast<float>(of_a.unit / 255);
        result.largest.b[c] = of_b.values[at + c] * static_cast<float>(of_b.unit / 255);
    }
    result.ssim = ssim(of_a, of_b, options.threads);
    return result;
}

}  // namespace

std::string pair_fault(const Image& a, const Image& b) {
    for (const Image* image : {&a, &b}) {
        if (image->width < 1 || image->height < 1 ||
            image->rgb.size() != std::size_t{3} * image->width * image->height) {
            return "a picture without pixels, or whose numbers do not fit its size";
        }
    }
    if (a.width == b.width && a.height == b.height) return {};
    return fmt::format("the pictures have different sizes: {}x{} and {}x{}{}", a.width, a.height, b.width,
                       b.height,
                       a.width == b.height && a.height == b.width
                           ? "; width and height are swapped, or one picture is turned"
                           : "");
}

Levels levels_of(const Image& image, bool as_floats, int threads) {
    Levels levels{std::vector<float>(image.rgb.size()), as_floats ? 255.0 : 1.0, image.width, image.height};
    const std::size_t row = std::size_t{3} * image.width;
    parallel_for(static_cast<std::size_t>(image.height), threads, [&](std::size_t y) {
        for (std::size_t i = y * row; i < (y + 1) * row; ++i) {
            const float value = is_finite(image.rgb[i]) ? image.rgb[i] : 0;
            levels.values[i] =
                as_floats ? value : static_cast<float>(quantize(static_cast<double>(value), 255));
        }
    });
    return levels;
}

std::vector<std::uint8_t> find_edges(const Levels& levels, int threads) {
    const std::int32_t width = levels.width, height = levels.height;
    std::vector<std::uint8_t> edges(static_cast<std::size_t>(width) * height);
    parallel_for(static_cast<std::size_t>(height), threads, [&](std::size_t row) {
        const auto y = static_cast<std::int32_t>(row);
        const std::int32_t top = std::max(y - 1, 0), bottom = std::min(y + 1, height - 1);
        for (std::int32_t x = 0; x < width; ++x) {
            const std::int32_t left = std::max(x - 1, 0), right = std::min(x + 1, width - 1);
            const float* here = &levels.values[3 * (row * width + x)];
            float least[3] = {here[0], here[1], here[2]}, most[3] = {here[0], here[1], here[2]};
            for (std::int32_t v = top; v <= bottom; ++v) {
                for (std::int32_t u = left; u <= right; ++u) {
                    const float* near = &levels.values[3 * (static_cast<std::size_t>(v) * width + u)];
                    for (int c = 0; c < 3; ++c) {
                        least[c] = std::min(least[c], near[c]);
                        most[c] = std::max(most[c], near[c]);
                    }
                }
            }
            bool is_edge = false;
            for (int c = 0; c < 3; ++c)
                is_edge = is_edge || levels.unit * static_cast<double>(most[c] - least[c]) > k_edge_step;
            edges[row * width + x] = is_edge;
        }
    });
    return edges;
}

Result<PictureDifference> compare(const Image& a, const Image& b, const CompareOptions& options) {
    return result_of([&]() -> Result<PictureDifference> {
        const DefaultFpEnvironment environment;
        std::string wrong = pair_fault(a, b);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        return measure(a, b, options);
    });
}

Result<Image> difference_image(const Image& a, const Image& b, double gain) {
    return result_of([&]() -> Result<Image> {
        const DefaultFpEnvironment environment;
        std::string wrong = pair_fault(a, b);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        Image image{b.width, b.height, std::vector<float>(b.rgb.size())};
        float largest = 0;
        for (std::size_t i = 0; i < b.rgb.size(); ++i) {
            image.rgb[i] = std::fabs(a.rgb[i] - b.rgb[i]);
            if (is_finite(image.rgb[i])) largest = std::max(largest, image.rgb[i]);
        }
        const auto most = static_cast<double>(std::numeric_limits<float>::max());  // infinity times 0 is NaN
        const float factor = gain > 0      ? static_cast<float>(std::min(gain, most))
                             : largest > 0 ? std::min(1 / largest, std::numeric_limits<float>::max())
                                           : 1;
        for (float& value : image.rgb) value = is_finite(value) ? std::min(value * factor, 1.0f) : 1;
        return image;
    });
}

}  // namespace glint
