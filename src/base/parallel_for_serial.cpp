// SPDX-License-Identifier: Apache-2.0
// In the browser a worker has one thread.
#include "base/parallel_for.h"

namespace glint {

int thread_count(int) { return 1; }

void parallel_for(std::size_t count, int, const std::function<void(std::size_t)>& body) {
    for (std::size_t i = 0; i < count; ++i) body(i);
}

}  // namespace glint
