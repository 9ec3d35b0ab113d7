// SPDX-License-Identifier: Apache-2.0
// Pictures that are written while they are rendered: the bytes of those that are rendered in memory.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/process.h"

namespace glint::test {
namespace {

// 58 MB, more than the 16 MiB that are kept in memory.
const std::vector<std::string> k_large{"render", "a.cgfs", "-s", "2500x1920", "-t", "3"};

Finished render_large(const Folder& folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = k_large;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(folder, arguments);
}

double peak_memory(const Folder& folder) {
    return nlohmann::json::parse(folder.read("s.json")).at("peak_rss_bytes").get<double>();
}

TEST(Large, PicturesHaveTheBytesOfThoseInMemory) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    std::vector<std::string> in_memory = k_large;
    in_memory.insert(in_memory.end(), {"-o", "-", "--stats", "s.json"});
    const Finished whole = run(folder, in_memory);
    ASSERT_EQ(whole.code, 0) << whole.err;
    EXPECT_GT(peak_memory(folder), 58e6);
    const Finished streamed = render_large(folder, {"-o", "b.png", "--stats", "s.json"});
    ASSERT_EQ(streamed.code, 0) << streamed.err;
    EXPECT_TRUE(folder.read("b.png") == whole.out);
    EXPECT_LT(peak_memory(folder), 45e6);
    EXPECT_EQ(folder.count(), 3);
}

TEST(Large, AlphaIsStreamedToo) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::vector<std::string> arguments{"render", "a.cgfs", "-s", "2000x1700", "--alpha", "-o"};
    const auto with = [&](const char* output) {
        auto all = arguments;
        all.emplace_back(output);
        return all;
    };
    const Finished whole = run(folder, with("-"));
    ASSERT_EQ(whole.code, 0) << whole.err;
    ASSERT_EQ(run(folder, with("b.png")).code, 0);
    EXPECT_TRUE(folder.read("b.png") == whole.out);
}

TEST(Large, LayersGoThroughATemporaryJournal) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::vector<std::string> arguments{"render", "a.cgfs",  "-s",     "3000x2000", "--aov",
                                             "all",    "--stats", "s.json", "-o"};
    auto with = arguments;
    with.push_back("b.exr");
    const Finished streamed = run(folder, with);
    ASSERT_EQ(streamed.code, 0) << streamed.err;
    EXPECT_LT(peak_memory(folder), 150e6);
    EXPECT_EQ(folder.count(), 3) << "the journal is removed";
}

TEST(Large, AFullDiskLeavesNothing) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    std::vector<std::string> arguments = k_large;
    arguments.insert(arguments.end(), {"-o", "b.png"});
    const Finished r = run(folder, arguments, with_full_disk(1 << 16));
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "cannot write 'b.png'")) << r.err;
    EXPECT_EQ(folder.count(), 1);
}

}  // namespace
}  // namespace glint::test
