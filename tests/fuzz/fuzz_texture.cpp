// SPDX-License-Identifier: Apache-2.0
// libFuzzer over decode_texture(): fuzz_texture tests/fuzz/corpus/texture tests/image/textures
#include "fuzz/fuzz_texture.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string wrong = glint::test::fuzz_texture({data, size});
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
