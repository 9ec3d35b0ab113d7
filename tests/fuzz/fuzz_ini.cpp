// SPDX-License-Identifier: Apache-2.0
// libFuzzer over glint-povray's .ini files: fuzz_ini tests/fuzz/corpus/ini
#include "fuzz/fuzz_ini.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string wrong = glint::test::fuzz_ini({reinterpret_cast<const char*>(data), size});
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
