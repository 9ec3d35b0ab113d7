// SPDX-License-Identifier: Apache-2.0
// libFuzzer over decode(): fuzz_decode tests/fuzz/corpus/decode
#include "fuzz/fuzz_picture.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string wrong = glint::test::fuzz_decode({data, size});
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
