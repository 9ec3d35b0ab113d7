// SPDX-License-Identifier: Apache-2.0
// Runs the function of the .ini files' fuzzer on every text of its corpus, in the normal build.
#include <gtest/gtest.h>

#include "fuzz/corpus.h"
#include "fuzz/fuzz_ini.h"

namespace {

TEST(IniCorpus, EveryTextGivesArgumentsOrAMessage) {
    EXPECT_GE(glint::test::for_each_text("ini",
                                         [](const std::string& text, const std::string& path) {
                                             EXPECT_EQ(glint::test::fuzz_ini(text), "") << path;
                                         }),
              10);
}

}  // namespace
