// SPDX-License-Identifier: Apache-2.0
// libFuzzer over the reader of GLINT_FUZZED_FORMAT: fuzz_cgfs tests/fuzz/corpus/cgfs
#include <cstdio>
#include <cstdlib>

#include "fuzz/fuzz_load.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string wrong =
        glint::test::fuzz_load({reinterpret_cast<const char*>(data), size}, GLINT_FUZZED_FORMAT);
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
