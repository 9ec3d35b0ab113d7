// SPDX-License-Identifier: Apache-2.0
// libFuzzer over parse_journal(): fuzz_journal tests/fuzz/corpus/journal
#include "fuzz/fuzz_journal.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string wrong = glint::test::fuzz_journal({reinterpret_cast<const char*>(data), size});
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
