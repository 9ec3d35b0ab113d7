// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parallel loops whose calls need memory.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "base/parallel_for.h"

namespace glint {

/// Calls body(i, s) once for each i < count, on one thread for each element s of `scratch`. So the memory is
/// allocated before the threads start.
template <class Scratch, class Body>
void parallel_scratch(std::size_t count, std::vector<Scratch>& scratch, const Body& body) {
    std::atomic<std::size_t> next{0};
    parallel_for(scratch.size(), static_cast<int>(scratch.size()), [&](std::size_t worker) {
        for (std::size_t i = next++; i < count; i = next++) body(i, scratch[worker]);
    });
}

/// The number of elements of `scratch` for a loop of this many calls.
inline std::size_t scratch_count(std::size_t count, int threads) {
    return std::clamp<std::size_t>(count, 1, static_cast<std::size_t>(thread_count(threads)));
}

}  // namespace glint
