// SPDX-License-Identifier: Apache-2.0
#pragma once
// Comparison with golden pictures: both the largest difference and the number of differing pixels are
// limited, so that neither many small errors nor a small missing object passes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "glint/image.h"
#include "image/read_png.h"

namespace glint::test {

struct GoldenLimits {
    int largest = 0;    ///< of any channel of any pixel, in units of the file's samples
    int differing = 0;  ///< pixels that are not equal
};

inline void write_bytes(const std::string& path, const std::vector<std::uint8_t>& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
}

/// Two pictures of one size and depth. On failure a picture of the differences, scaled so that the largest is
/// white, is written to `difference_path`.
inline ::testing::AssertionResult compare(const Picture& golden, const Picture& found, GoldenLimits limits,
                                          const std::string& difference_path) {
    if (!golden.error.empty()) return ::testing::AssertionFailure() << "the golden picture: " << golden.error;
    if (!found.error.empty()) return ::testing::AssertionFailure() << "the picture: " << found.error;
    if (golden.width != found.width || golden.height != found.height || golden.bits != found.bits) {
        return ::testing::AssertionFailure()
               << "expected " << golden.width << "x" << golden.height << " of " << golden.bits
               << " bits, found " << found.width << "x" << found.height << " of " << found.bits;
    }
    int largest = 0, differing = 0, worst = 0;
    const int pixels = golden.width * golden.height;
    Image difference{golden.width, golden.height, std::vector<float>(golden.samples.size())};
    for (int p = 0; p < pixels; ++p) {
        int most = 0;
        for (int i = 3 * p; i < 3 * p + 3; ++i) {
            const int d = std::abs(golden.samples[i] - found.samples[i]);
            difference.rgb[i] = static_cast<float>(d);
            most = std::max(most, d);
        }
        differing += most != 0;
        if (most > largest) {
            largest = most;
            worst = p;
        }
    }
    if (largest <= limits.largest && differing <= limits.differing) return ::testing::AssertionSuccess();
    for (float& v : difference.rgb) v /= static_cast<float>(largest);
    write_bytes(difference_path, encode(difference).value());
    return ::testing::AssertionFailure()
           << differing << " of " << pixels << " pixels differ (at most " << limits.differing
           << " may), the largest difference is " << largest << " (at most " << limits.largest << ") at x "
           << worst % golden.width << ", y " << worst / golden.width << "; see " << difference_path;
}

/// Compares a rendered image with the golden PNG at `golden_path`, as `encode` would write it. With
/// GLINT_UPDATE_GOLDEN set in the environment, the golden file is written instead (inspect it before you
/// commit it).
inline ::testing::AssertionResult matches_golden(const Image& image, const std::string& golden_path,
                                                 GoldenLimits limits = {}) {
    const Result<std::vector<std::uint8_t>> encoded = encode(image);
    if (!encoded) return ::testing::AssertionFailure() << encoded.message;
    if (std::getenv("GLINT_UPDATE_GOLDEN") != nullptr) {
        write_bytes(golden_path, *encoded);
        return ::testing::AssertionSuccess();
    }
    if (!std::filesystem::exists(golden_path)) {
        return ::testing::AssertionFailure() << "no " << golden_path << "; GLINT_UPDATE_GOLDEN=1 writes it";
    }
    const std::string stem = std::filesystem::path(golden_path).stem().string();
    const auto verdict =
        compare(read_png(golden_path), decode_png(*encoded), limits, stem + ".difference.png");
    if (!verdict) write_bytes(stem + ".found.png", *encoded);
    return verdict;
}

}  // namespace glint::test
