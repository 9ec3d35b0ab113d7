#pragma once
// Memory in large pages.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel_for.h"
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace glint {

/// Asks the system to give memory that nobody has touched yet in large pages, where it has them: it is then
/// handed over in few steps. No more than a wish: whatever the system answers, the memory is the same.
inline void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t page = 4096, huge = std::uintptr_t{1} << 21;
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) & ~(page - 1);
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(page - 1);
    if (end > begin && end - begin >= huge)
        madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

/// Has the system hand over untouched memory now, on all threads: filling a large page with zeros is most of
/// what a picture's memory costs. No more than a wish, too.
inline void claim_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes,
                        [[maybe_unused]] int threads) {
#if defined(__linux__) && defined(MADV_POPULATE_WRITE)
    constexpr std::uintptr_t page = 4096, huge = std::uintptr_t{1} << 21;
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) & ~(page - 1);
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(page - 1);
    if (end <= begin || end - begin < huge) return;
    const std::uintptr_t first = begin & ~(huge - 1);
    parallel_for((end - first + huge - 1) / huge, threads, [&](std::size_t i) {
        const auto from = std::max(begin, first + i * huge), to = std::min(end, first + (i + 1) * huge);
        madvise(reinterpret_cast<void*>(from), to - from, MADV_POPULATE_WRITE);
    });
#endif
}

/// Makes an empty vector n values long, in large pages where they are worth it.
template <class T> void resize_in_huge_pages(std::vector<T>& values, std::size_t n) {
    values.reserve(n);
    prefer_huge_pages(values.data(), n * sizeof(T));
    values.resize(n);
}

}  // namespace glint
