// SPDX-License-Identifier: Apache-2.0
// Ctrl-C ends the command by the signal within a second, and leaves no file.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <thread>

#include "cli/process.h"

namespace glint::test {
namespace {

using namespace std::chrono_literals;

// Whether the process has its own handler for the signal, as the kernel reports it.
bool catches(int process, int signal) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("SigCgt:")) {
            return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
        }
    }
    return false;
}

void interrupt(const std::vector<std::string>& arguments, std::chrono::milliseconds after,
               int signal = SIGINT) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    Process process(folder, arguments);
    for (int i = 0; i < 500 && !catches(process.id(), SIGINT); ++i) std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(after);
    const auto start = std::chrono::steady_clock::now();
    ::kill(process.id(), signal);
    const Finished r = process.finish();
    EXPECT_LT(std::chrono::steady_clock::now() - start, 1s);
    EXPECT_EQ(r.code, 1000 + signal) << r.err;
    EXPECT_EQ(contains(r.err, "interrupted"), signal == SIGINT) << r.err;
    EXPECT_EQ(folder.count(), 1) << "only the scene";
}

TEST(Interrupt, WhileTracing) {
    const std::vector<std::string> long_render = {"render", "a.cgfs", "-s", "8000x8000", "--aa", "64"};
    interrupt(long_render, 300ms);
    interrupt(long_render, 0ms);
    interrupt(long_render, 50ms, SIGTERM);
    interrupt(long_render, 50ms, SIGHUP);
}

// A terminal sends the signal to the shell and to the command. bash ends its loop if the signal ended the
// command, and continues if the command exited, with any exit code.
TEST(Interrupt, EndsALoopOfTheShell) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    folder.write("loop.bash",
                 "for i in 1 2 3; do\n"
                 "  touch round$i\n"
                 "  '" GLINT_COMMAND
                 "' render a.cgfs -s 8000x8000 --aa 64 -q\n"
                 "done\n");
    const pid_t shell = ::fork();
    if (shell == 0) {
        ::setpgid(0, 0);
        ::signal(SIGINT, SIG_DFL);
        if (::chdir(folder.path().c_str()) == 0) ::execlp("bash", "bash", "loop.bash", nullptr);
        ::_exit(99);
    }
    ::setpgid(shell, shell);
    const auto command_of_shell = [&] {
        std::ifstream children("/proc/" + std::to_string(shell) + "/task/" + std::to_string(shell) +
                               "/children");
        int child = -1;
        return children >> child ? child : -1;
    };
    for (int i = 0; i < 500 && (!folder.has("round1") || !catches(command_of_shell(), SIGINT)); ++i)
        std::this_thread::sleep_for(10ms);
    // At the timeout, all remaining child processes of the shell are ended, so that no test hangs.
    ::kill(-shell, SIGINT);
    int status = 0;
    bool ended = false;
    for (int i = 0; i < 300 && !ended; ++i) {
        ended = ::waitpid(shell, &status, WNOHANG) == shell;
        if (!ended) std::this_thread::sleep_for(10ms);
    }
    if (!ended) {
        ::kill(-shell, SIGKILL);
        ::waitpid(shell, &status, 0);
    }
    EXPECT_TRUE(ended);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
    EXPECT_FALSE(folder.has("round2"));
}

TEST(Interrupt, WhileWaitingForInput) {
    const Folder folder;
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    interrupt({"render", folder.path("pipe"), "--format", "cgfs"}, 50ms);
}

TEST(Interrupt, TheHelperTellsAHandledSignal) { EXPECT_FALSE(catches(::getpid(), SIGUSR2)); }

}  // namespace
}  // namespace glint::test
