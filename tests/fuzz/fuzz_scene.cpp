// SPDX-License-Identifier: Apache-2.0
// libFuzzer over GLINT_FUZZED, fuzz_convert or fuzz_render: a format's name in the first line, then its text.
// tools/run-fuzzers makes such texts of every reader's corpus.
#include "fuzz/fuzz_scene.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const glint::test::NamedText named =
        glint::test::split_format({reinterpret_cast<const char*>(data), size});
    const std::string wrong = glint::test::GLINT_FUZZED(named.text, named.format);
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
