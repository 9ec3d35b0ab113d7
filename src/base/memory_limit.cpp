// SPDX-License-Identifier: Apache-2.0
#include "base/memory_limit.h"

#include <fmt/format.h>

#include "base/status.h"

namespace glint {

std::string memory_text(std::uint64_t bytes) {
    constexpr const char* units[] = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
    auto number = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; number >= 1000 && unit + 1 < std::size(units); ++unit) number /= 1024;
    return fmt::format("{:.3g} {}", number, bytes == 1 ? "byte" : units[unit]);
}

Status memory_fault(std::uint64_t needed, std::uint64_t allowed, std::string_view doing) {
    if (needed <= allowed) return {};
    return failure(
        ErrorCode::out_of_memory,
        fmt::format("{} needs {} of memory, and {} are allowed; max_memory (--max-memory) allows more", doing,
                    memory_text(needed), memory_text(allowed)));
}

}  // namespace glint
