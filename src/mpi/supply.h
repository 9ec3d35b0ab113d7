// SPDX-License-Identifier: Apache-2.0
#pragma once
// How many tiles a process asks for in advance.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>

#include "base/parallel_for.h"

namespace glint::mpi {

/// Between two looks for messages of the main thread. The rendering threads look too, after each tile, so
/// that this matters for tiles that take longer.
inline constexpr std::chrono::milliseconds k_pause{5};
/// Seconds of work that a process asks for in advance, and the most tiles for each of its threads.
inline constexpr double k_ahead = 0.02;
inline constexpr std::size_t k_max_ahead = 128;

/// How many tiles are to wait for the threads of a process, and how many do.
struct Demand {
    std::size_t threads = 1, ahead = 1, waiting = 0;
};

/// The demand of this process: one tile for each thread, or what they render in k_ahead, so that cheap tiles
/// do not run out while more are on their way.
class Supply {
  public:
    explicit Supply(int threads) : threads_(static_cast<std::size_t>(thread_count(threads))) {}
    /// May be called at any time; so may demand().
    void count_finished() { ++finished_; }
    Demand demand(std::size_t waiting) const {
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        const double rate = seconds > 0 ? static_cast<double>(finished_) / seconds : 0;
        const auto tiles = static_cast<std::size_t>(rate * k_ahead);
        return {threads_, std::clamp(tiles, threads_, k_max_ahead * threads_), waiting};
    }

  private:
    const std::size_t threads_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::atomic<std::size_t> finished_{0};
};

}  // namespace glint::mpi
