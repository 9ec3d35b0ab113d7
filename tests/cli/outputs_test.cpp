// SPDX-License-Identifier: Apache-2.0
// A file is written completely or not at all.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "cli/process.h"

namespace glint::test {
namespace {

TEST(Outputs, AFullDiskLeavesNothing) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Finished r = run(folder, {"render", "a.cgfs", "-s", "200x200"}, with_full_disk(500));
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "cannot write 'a.png'")) << r.err;
    EXPECT_EQ(folder.count(), 1) << "neither a picture nor a temporary file";
}

TEST(Outputs, AFullDiskLeavesTheOldFile) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    folder.write("a.png", "old");
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "200x200"}, with_full_disk(500)).code, 1);
    EXPECT_EQ(folder.read("a.png"), "old");
    EXPECT_EQ(folder.count(), 2);
}

TEST(Outputs, UnwritableTargets) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    std::filesystem::create_directory(folder.path("folder.png"));
    const std::pair<const char*, const char*> cases[] = {{"/dev/full", "No space left"},
                                                         {"none/a.png", "there is no folder 'none'"},
                                                         {"/proc/a.png", "cannot write '/proc/a.png'"},
                                                         {"folder.png", "is a folder"},
                                                         {"a.cgfs/a.png", "'a.cgfs' is not a folder"}};
    for (const auto& [path, message] : cases) {
        const Finished r = run(folder, {"render", "a.cgfs", "-s", "10x10", "-o", path});
        EXPECT_EQ(r.code, 1) << path;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
    }
    EXPECT_EQ(folder.count(), 2);
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "--stats", "/dev/full"}).code, 1);
    const auto full = with_output_to("/dev/full");
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "-o", "-"}, full).code, 1);
    EXPECT_EQ(run(folder, {"info", "a.cgfs"}, full).code, 1);
}

// Messages on standard error may be lost; the output is not.
TEST(Outputs, StandardErrorThatCannotBeWritten) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    folder.write("warned.cgfs", "light { type = ambient  intensity = 0.4 }\n");
    RunOptions full;
    full.error_path = "/dev/full";
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10"}, full).code, 0);
    EXPECT_TRUE(folder.has("a.png"));
    EXPECT_EQ(run(folder, {"check", "warned.cgfs"}, full).code, 0);
    EXPECT_EQ(run(folder, {"render", "nothere.cgfs"}, full).code, 1);
    EXPECT_EQ(run(folder, {"render", "--bogus"}, full).code, 2);
    EXPECT_EQ(run(folder, {"rendre"}, full).code, 2);
}

TEST(Outputs, AnOldFileKeepsItsModeAndItsLinks) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    folder.write("real.png", "old");
    std::filesystem::create_symlink("real.png", folder.path("link.png"));
    ::chmod(folder.path("real.png").c_str(), 0640);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "-o", "link.png"}).code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.png")));
    EXPECT_NE(folder.read("real.png"), "old");
    struct stat about {};
    ASSERT_EQ(::stat(folder.path("real.png").c_str(), &about), 0);
    EXPECT_EQ(about.st_mode & 0777, 0640u);
}

// A link that names no file yet: the file is made, and the link is kept.
TEST(Outputs, ALinkWithoutAFileGetsOne) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    std::filesystem::create_directory(folder.path("elsewhere"));
    std::filesystem::create_symlink("elsewhere/real.png", folder.path("link.png"));
    std::filesystem::create_symlink("nowhere/real.png", folder.path("lost.png"));
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "-o", "link.png"}).code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.png")));
    EXPECT_TRUE(std::filesystem::is_regular_file(folder.path("elsewhere/real.png")));
    const Finished lost = run(folder, {"render", "a.cgfs", "-s", "10x10", "-o", "lost.png"});
    EXPECT_EQ(lost.code, 1);
    EXPECT_TRUE(contains(lost.err, "there is no folder")) << lost.err;
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("lost.png")));
    std::filesystem::create_symlink("circle.png", folder.path("circle.png"));
    const Finished circle = run(folder, {"render", "a.cgfs", "-s", "10x10", "-o", "circle.png"});
    EXPECT_EQ(circle.code, 1);
    EXPECT_TRUE(contains(circle.err, "cannot write 'circle.png': Too many levels")) << circle.err;
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("circle.png")));
}

TEST(Outputs, ANamedPipeIsWrittenDirectly) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10"}).code, 0);
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    const int reader = ::open(folder.path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "-o", "pipe"}).code, 0);
    std::string bytes(65536, '\0');
    const ssize_t count = ::read(reader, bytes.data(), bytes.size());
    ::close(reader);
    ASSERT_GT(count, 0);
    bytes.resize(static_cast<std::size_t>(count));
    EXPECT_EQ(bytes, folder.read("a.png"));
    EXPECT_TRUE(std::filesystem::is_fifo(folder.path("pipe")));
}

// `glint ... | head`: a filter whose reader has gone ends by SIGPIPE, without a message.
TEST(Outputs, EndsWithItsReader) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    RunOptions options;
    options.reader_is_gone = true;
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"render", "a.cgfs", "-s", "64x64", "-o", "-"},
          {"info", "a.cgfs", "--json"},
          {"render", "--help"},
          {"man"}}) {
        const Finished r = run(folder, arguments, options);
        EXPECT_EQ(r.code, 1000 + SIGPIPE) << arguments.front();
        EXPECT_FALSE(contains(r.err, "Broken pipe") || contains(r.err, "cannot write")) << r.err;
    }
}

}  // namespace
}  // namespace glint::test
