// SPDX-License-Identifier: Apache-2.0
#pragma once
// The only place that starts threads (oneTBB, or those of the standard library). In the browser, a worker has
// one thread and the loops are serial.
#include <cstddef>
#include <functional>

namespace glint {

/// The number of threads for `requested` (0: one per processor, or in a task_arena of the caller as many as
/// it has); at least 1, at most 1024.
int thread_count(int requested);

/// Calls body(i) once for each i < count, on up to `threads` threads; returns when all calls are done. Each
/// call runs with round-to-nearest and gradual underflow, whatever the caller's floating-point state. body
/// must not throw.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace glint
