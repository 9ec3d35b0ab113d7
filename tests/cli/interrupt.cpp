// Ctrl-C: exit 130 within a second, and no file.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <thread>

#include "cli/process.h"

namespace glint::test {
namespace {

using namespace std::chrono_literals;

// Whether the process has a handler of its own for the signal, by what the kernel says.
bool catches(int process, int signal) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("SigCgt:")) {
            return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
        }
    }
    return false;
}

void interrupt(const std::vector<std::string>& arguments, std::chrono::milliseconds after) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    Process process(folder, arguments);
    for (int i = 0; i < 500 && !catches(process.id(), SIGINT); ++i) std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(after);
    const auto start = std::chrono::steady_clock::now();
    ::kill(process.id(), SIGINT);
    const Finished r = process.finish();
    EXPECT_LT(std::chrono::steady_clock::now() - start, 1s);
    EXPECT_EQ(r.code, 130) << r.err;
    EXPECT_TRUE(contains(r.err, "interrupted")) << r.err;
    EXPECT_EQ(folder.count(), 1) << "only the scene";
}

TEST(Interrupt, WhileTracing) {
    const std::vector<std::string> long_render = {"render", "a.cgfs", "-s", "8000x8000", "--aa", "64"};
    interrupt(long_render, 300ms);
    interrupt(long_render, 0ms);
}

TEST(Interrupt, WhileWaitingForInput) {
    const Folder folder;
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    interrupt({"render", folder.path("pipe"), "--format", "cgfs"}, 50ms);
}

TEST(Interrupt, TheHelperTellsAHandledSignal) { EXPECT_FALSE(catches(::getpid(), SIGUSR2)); }

}  // namespace
}  // namespace glint::test
