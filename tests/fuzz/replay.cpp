// Every text of the corpus through the functions that the fuzzers call, in the ordinary build.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "fuzz/fuzz_load.h"

namespace {

class Corpus : public testing::TestWithParam<const char*> {};

TEST_P(Corpus, EveryTextHasAnAnswer) {
    const std::string folder = GLINT_SOURCE_DIR "/tests/fuzz/corpus/" + std::string(GetParam());
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        std::stringstream text;
        text << file.rdbuf();
        EXPECT_EQ(glint::fuzz_load(text.str(), GetParam()), "") << entry.path();
        ++files;
    }
    EXPECT_GE(files, 10);
}

INSTANTIATE_TEST_SUITE_P(Formats, Corpus, testing::Values("cgfs", "csc473", "epfl", "glint", "nff"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
