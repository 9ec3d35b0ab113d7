// SPDX-License-Identifier: Apache-2.0
#pragma once
// The only place that starts threads (oneTBB). In the browser a worker has one thread and the loops are
// serial.
#include <cstddef>
#include <functional>

namespace glint {

/// The number of threads that `requested` (0 = one a processor) stands for; at least 1, at most 1024.
int thread_count(int requested);

/// Calls body(i) for every i < count, each once, on up to `threads` threads; returns when all are done. Every
/// call runs with round-to-nearest and gradual underflow, whatever the caller's floating-point state. body
/// must not throw.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace glint
