// SPDX-License-Identifier: Apache-2.0
#include "base/sort_stably.h"

#include <algorithm>
#include <numeric>

namespace glint {

std::vector<std::uint32_t> stable_order(std::size_t count,
                                        bool (*less)(const void*, std::uint32_t, std::uint32_t),
                                        const void* context) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [=](std::uint32_t a, std::uint32_t b) { return less(context, a, b); });
    return order;
}

}  // namespace glint
