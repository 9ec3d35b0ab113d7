// SPDX-License-Identifier: Apache-2.0
#pragma once
// Allocation in large pages.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>
#if defined(__linux__)
#include <sys/mman.h>
#endif

#include "base/parallel_for.h"
#include "glint/callback.h"

namespace glint {

inline constexpr std::size_t k_huge_page = std::size_t{1} << 21;

/// The large pages that are completely inside a block of memory; none if the block is too small.
struct WholePages {
    char* begin = nullptr;
    std::size_t bytes = 0;

    WholePages(void* memory, std::size_t size) {
        constexpr std::size_t page = 4096;
        const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
        if (size < skipped + k_huge_page) return;
        begin = static_cast<char*>(memory) + skipped;
        bytes = (size - skipped) / page * page;
    }
};

/// Asks the system to use large pages for memory that has not been touched yet: fewer page faults. This is a
/// hint; if the system ignores it, only speed changes.
inline void advise_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t size) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    const WholePages pages(memory, size);
    if (pages.bytes > 0) madvise(pages.begin, pages.bytes, MADV_HUGEPAGE);
#endif
}

/// Touches new memory on all threads: filling large pages with zeros is most of the cost of a picture's
/// memory. Also a hint. Ends early if `cancel` becomes true; it may be null.
inline void prefault_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t size,
                           [[maybe_unused]] int threads, [[maybe_unused]] CancelFlag cancel = {}) {
#if defined(__linux__) && defined(MADV_POPULATE_WRITE)
    const WholePages pages(memory, size);
    // First up to the first boundary of a large page, then one page at a time.
    const std::size_t before =
        (k_huge_page - reinterpret_cast<std::uintptr_t>(pages.begin) % k_huge_page) % k_huge_page;
    if (pages.bytes <= before) return;
    parallel_for((pages.bytes - before + k_huge_page - 1) / k_huge_page + 1, threads, [&](std::size_t i) {
        if (cancel.is_set()) return;
        const std::size_t from = i == 0 ? 0 : before + (i - 1) * k_huge_page;
        const std::size_t to = std::min(pages.bytes, before + i * k_huge_page);
        madvise(pages.begin + from, to - from, MADV_POPULATE_WRITE);
    });
#endif
}

/// Makes an empty vector n values long, in large pages if it is large enough, which the system
/// fills on up to `threads` threads.
template <class T> void resize_in_huge_pages(std::vector<T>& values, std::size_t n, int threads = 1) {
    values.reserve(n);
    advise_huge_pages(values.data(), n * sizeof(T));
    prefault_pages(values.data(), n * sizeof(T), threads);
    values.resize(n);
}

}  // namespace glint
