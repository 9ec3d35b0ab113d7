// SPDX-License-Identifier: Apache-2.0
// Runs the functions of the fuzzers on every text of the corpora, in the normal build.
#include <gtest/gtest.h>

#include "fuzz/corpus.h"
#include "fuzz/fuzz_journal.h"
#include "fuzz/fuzz_load.h"
#include "fuzz/fuzz_picture.h"
#include "fuzz/fuzz_scene.h"
#include "fuzz/fuzz_texture.h"
#include "fuzz/fuzz_trace_log.h"

namespace {

using glint::test::corpus_folder;
using glint::test::for_each_text;

class Corpus : public testing::TestWithParam<std::string> {};

TEST_P(Corpus, EveryTextGivesASceneOrAnError) {
    EXPECT_GE(for_each_text(GetParam(),
                            [](const std::string& text, const std::string& path) {
                                EXPECT_EQ(glint::test::fuzz_load(text, GetParam()), "") << path;
                            }),
              10);
}

TEST_P(Corpus, EverySceneIsWrittenAndRendered) {
    for_each_text(GetParam(), [](const std::string& text, const std::string& path) {
        EXPECT_EQ(glint::test::fuzz_convert(text, GetParam()), "") << path;
        EXPECT_EQ(glint::test::fuzz_render(text, GetParam()), "") << path;
    });
}

TEST(PictureCorpus, EveryFileGivesAPictureOrAnError) {
    EXPECT_GE(for_each_text("decode",
                            [](const std::string& bytes, const std::string& path) {
                                const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
                                EXPECT_EQ(glint::test::fuzz_decode({data, bytes.size()}), "") << path;
                            }),
              10);
}

TEST(TextureCorpus, EveryFileGivesAPictureOrAnError) {
    EXPECT_GE(for_each_text("texture",
                            [](const std::string& bytes, const std::string& path) {
                                const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
                                EXPECT_EQ(glint::test::fuzz_texture({data, bytes.size()}), "") << path;
                            }),
              10);
}

TEST(JournalCorpus, EveryFileHasAnAnswer) {
    EXPECT_GE(for_each_text("journal",
                            [](const std::string& bytes, const std::string& path) {
                                EXPECT_EQ(glint::test::fuzz_journal(bytes), "") << path;
                            }),
              10);
}

TEST(TraceLogCorpus, EveryLogHasAnAnswer) {
    EXPECT_GE(for_each_text("trace_log",
                            [](const std::string& text, const std::string& path) {
                                EXPECT_EQ(glint::test::fuzz_trace_log(text), "") << path;
                            }),
              10);
}

// One folder per reader, with the name of its format.
std::vector<std::string> readers() {
    std::vector<std::string> names;
    for (const glint::FormatInfo& format : glint::formats()) {
        if (std::filesystem::exists(corpus_folder(std::string(format.name)))) names.emplace_back(format.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Formats, Corpus, testing::ValuesIn(readers()),
                         [](const auto& param) { return param.param; });

}  // namespace
