// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace glint {

/// 0 to count - 1, sorted stably by less(context, a, b). At most 2^32 - 1 numbers.
std::vector<std::uint32_t> stable_order(std::size_t count,
                                        bool (*less)(const void*, std::uint32_t, std::uint32_t),
                                        const void* context);

/// Puts item order[i] at i. `order` becomes 0, 1, 2...
template <class T> void move_to_order(std::span<T> items, std::uint32_t* order) {
    for (std::uint32_t first = 0; first < items.size(); ++first) {
        if (order[first] == first) continue;
        T moved = std::move(items[first]);
        std::uint32_t to = first;
        for (std::uint32_t from; (from = std::exchange(order[to], to)) != first; to = from)
            items[to] = std::move(items[from]);
        items[to] = std::move(moved);
    }
}

/// Sorts as std::stable_sort does. All types of items share one sort, of their numbers: each std::stable_sort
/// takes 2 kB of the browser's build, this 0.3.
template <class Items, class Less> void sort_stably(Items&& items, const Less& less) {
    const std::span all(items);
    const auto less_at = [&](std::uint32_t a, std::uint32_t b) { return less(all[a], all[b]); };
    std::vector<std::uint32_t> order = stable_order(
        all.size(),
        [](const void* context, std::uint32_t a, std::uint32_t b) {
            return (*static_cast<const decltype(less_at)*>(context))(a, b);
        },
        &less_at);
    move_to_order(all, order.data());
}

}  // namespace glint
