// SPDX-License-Identifier: Apache-2.0
// libFuzzer over diagnose(): fuzz_trace_log tests/fuzz/corpus/trace_log
#include "fuzz/fuzz_trace_log.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string wrong = glint::test::fuzz_trace_log({reinterpret_cast<const char*>(data), size});
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
