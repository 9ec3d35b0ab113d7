// SPDX-License-Identifier: Apache-2.0
// libFuzzer over all readers with a small LoadOptions::max_memory: aborts if more than twice as much, and
// what every load takes, is allocated at a time. The first line of a text is the name of its format.
#include <sanitizer/allocator_interface.h>
#include <sanitizer/asan_interface.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "fuzz/fuzz_load.h"

namespace {

constexpr std::uint64_t k_budget = 16u << 20;
constexpr std::uint64_t k_most = 2 * k_budget + (8u << 20);

bool is_counting = false;
std::int64_t held = 0, peak = 0;

void count_malloc(const volatile void*, std::size_t bytes) {
    if (!is_counting) return;
    held += static_cast<std::int64_t>(bytes);
    peak = std::max(peak, held);
}

void count_free(const volatile void* memory) {
    if (is_counting && memory != nullptr) {
        held -= static_cast<std::int64_t>(__sanitizer_get_allocated_size(const_cast<const void*>(memory)));
    }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    __sanitizer_install_malloc_and_free_hooks(count_malloc, count_free);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const glint::test::NamedText named =
        glint::test::split_format({reinterpret_cast<const char*>(data), size});
    const auto has_its_name = [&](const glint::FormatInfo& format) { return format.name == named.format; };
    if (std::ranges::none_of(glint::formats(), has_its_name)) return 0;  // an error without a place
    glint::LoadOptions options;
    options.max_memory = k_budget;
    held = peak = 0;
    is_counting = true;
    const std::string wrong = glint::test::fuzz_load(named.text, named.format, options);
    is_counting = false;
    if (wrong.empty() && peak <= static_cast<std::int64_t>(k_most)) return 0;
    std::fprintf(stderr, "%s\n%lld bytes at a time\n", wrong.c_str(), static_cast<long long>(peak));
    std::abort();
}
