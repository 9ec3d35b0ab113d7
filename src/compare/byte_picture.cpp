// SPDX-License-Identifier: Apache-2.0
#include "compare/byte_picture.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "base/parallel_scratch.h"
#include "glint/compare.h"
#include "image/levels.h"
#include "image/quantize.h"

namespace glint {

BytePicture to_bytes(const PictureView& picture, int threads, const ByteRule& rule) {
    if (const auto bytes = picture.bytes(); rule == ByteRule{} && !bytes.empty())
        return {picture.width, picture.height, {bytes.begin(), bytes.end()}};
    BytePicture made{picture.width, picture.height, std::vector<std::uint8_t>(picture.size())};
    const std::size_t row = std::size_t{3} * picture.width;
    parallel_for(static_cast<std::size_t>(picture.height), threads, [&](std::size_t y) {
        float buffer[k_values_at_a_time];
        for (std::size_t first = y * row, end = first + row; first < end; first += k_values_at_a_time) {
            const std::size_t count = std::min(k_values_at_a_time, end - first);
            quantize_row(picture.values(first, count, buffer), count, 8, rule, &made.rgb[first]);
        }
    });
    return made;
}

std::vector<std::uint8_t> edges_of(const BytePicture& picture, int threads) {
    const std::int32_t width = picture.width, last = picture.height - 1;
    std::vector<std::uint8_t> edges(picture.rgb.size() / 3);
    const auto rows = static_cast<std::size_t>(picture.height);
    std::vector<std::vector<std::uint8_t>> scratch(scratch_count(rows, threads),
                                                   std::vector<std::uint8_t>(std::size_t{6} * width));
    parallel_scratch(rows, scratch, [&](std::size_t row, std::vector<std::uint8_t>& extremes) {
        const auto y = static_cast<std::int32_t>(row);
        mark_edges<std::uint8_t>({picture.pixel(0, std::max(y - 1, 0)), picture.pixel(0, y),
                                  picture.pixel(0, std::min(y + 1, last))},
                                 width, 1, extremes.data(), &edges[row * width]);
    });
    return edges;
}

Rows all_rows(std::int32_t height) {
    Rows rows(static_cast<std::size_t>(height));
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

Rows sample_of(const Rows& rows, std::int32_t width) {
    const std::size_t most = std::max<std::size_t>(k_sample / static_cast<std::size_t>(width), 1),
                      step = (rows.size() + most - 1) / most;
    Rows sample;
    std::uint32_t state = 1;
    for (std::size_t first = 0; first < rows.size(); first += step) {
        state = state * 1664525u + 1013904223u;
        sample.push_back(rows[first + (state >> 16) % std::min(step, rows.size() - first)]);
    }
    return sample;
}

Distance distance(const BytePicture& a, const BytePicture& b, const Area& area) {
    struct Sums {
        std::uint64_t all = 0, pixels = 0, calm = 0, calm_pixels = 0;
    };
    std::vector<Sums> sums(area.rows.size());
    parallel_for(area.rows.size(), area.threads, [&](std::size_t i) {
        const std::int32_t y = area.rows[i];
        if (y < area.rim || y >= b.height - area.rim) return;
        const std::uint8_t *of_a = a.pixel(0, y), *of_b = b.pixel(0, y);
        const std::uint8_t* on_edge = &(*area.edges)[static_cast<std::size_t>(y) * b.width];
        Sums row;
        for (std::int32_t x = area.rim; x < b.width - area.rim; ++x) {
            std::uint32_t here = 0, calm = 0;
            for (int c = 0; c < 3; ++c) {
                const auto d =
                    static_cast<std::uint32_t>(std::abs(int{of_a[3 * x + c]} - int{of_b[3 * x + c]}));
                here += d;
                calm += d > k_noise ? d - k_noise : 0;
            }
            row.all += here;
            ++row.pixels;
            row.calm += on_edge[x] != 0 ? 0 : calm;
            row.calm_pixels += on_edge[x] == 0;
        }
        sums[i] = row;
    });
    Sums total;
    for (const Sums& row : sums) {
        total.all += row.all;
        total.pixels += row.pixels;
        total.calm += row.calm;
        total.calm_pixels += row.calm_pixels;
    }
    const auto mean = [](std::uint64_t sum, std::uint64_t count) {
        return count == 0 ? 0 : static_cast<double>(sum) / (3 * static_cast<double>(count));
    };
    return {mean(total.all, total.pixels), mean(total.calm, total.calm_pixels)};
}

std::size_t beyond_rounding(const BytePicture& a, const BytePicture& b) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        sum += static_cast<std::size_t>(std::max(std::abs(int{a.rgb[i]} - int{b.rgb[i]}) - k_rounding, 0));
    return sum;
}

bool equal_rows(const BytePicture& a, const BytePicture& b, const Rows& rows) {
    const std::ptrdiff_t row = std::ptrdiff_t{3} * b.width;
    return std::all_of(rows.begin(), rows.end(), [&](std::int32_t y) {
        return std::equal(a.pixel(0, y), a.pixel(0, y) + row, b.pixel(0, y));
    });
}

}  // namespace glint
