// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parallel loops with short bodies.
#include <algorithm>
#include <cstddef>

#include "base/parallel_for.h"

namespace glint {

/// Like parallel_for, in chunks of 16384.
template <class Body> void parallel_chunks(std::size_t count, int threads, const Body& body) {
    constexpr std::size_t chunk = 16384;
    parallel_for((count + chunk - 1) / chunk, threads, [&](std::size_t block) {
        const std::size_t end = std::min(count, (block + 1) * chunk);
        for (std::size_t i = block * chunk; i < end; ++i) body(i);
    });
}

}  // namespace glint
