// SPDX-License-Identifier: Apache-2.0
// The progress bar, on several kinds of terminals.
#include <gtest/gtest.h>
#include <sys/ioctl.h>

#include "cli/process.h"

namespace glint::test {
namespace {

// The output of `glint render` to a terminal in the first `seconds` of a long render, or until it contains an
// estimate of the remaining time.
std::string shown_on_terminal(const std::string& kind, unsigned short columns, int seconds) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) return "no terminal";
    const std::string name = ::ptsname(terminal);
    winsize size{};
    size.ws_row = 24;
    size.ws_col = columns;
    const int other_end =
        ::open(name.c_str(), O_RDWR | O_NOCTTY);  // so that the size is kept, and no end seen
    ::ioctl(other_end, TIOCSWINSZ, &size);
    const char* old = std::getenv("TERM");
    const std::string before = old != nullptr ? old : "";
    ::setenv("TERM", kind.c_str(), 1);
    RunOptions options;
    options.error_path = name;
    Process process(folder, {"render", "a.cgfs", "-s", "8000x8000", "--aa", "16"}, options);
    ::setenv("TERM", before.c_str(), 1);
    std::string text;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    while (std::chrono::steady_clock::now() < end && !contains(text, "left")) {
        pollfd file{terminal, POLLIN, 0};
        if (::poll(&file, 1, 50) <= 0) continue;
        char buffer[4096];
        const ssize_t count = ::read(terminal, buffer, sizeof buffer);
        if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
    }
    ::kill(process.id(), SIGKILL);
    process.finish();
    ::close(other_end);
    ::close(terminal);
    return text;
}

// The characters between two returns to the first column.
std::size_t longest_line(std::string text) {
    for (std::size_t at; (at = text.find("\x1b[K")) != std::string::npos;) text.erase(at, 3);
    std::size_t longest = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line, '\r');) longest = std::max(longest, line.size());
    return longest;
}

TEST(Progress, FitsIntoTheTerminal) {
    const std::string wide = shown_on_terminal("xterm", 100, 20), narrow = shown_on_terminal("xterm", 20, 20);
    EXPECT_TRUE(contains(wide, "\r[") && contains(wide, "% ")) << wide;
    EXPECT_GT(longest_line(wide), 30u);
    EXPECT_TRUE(contains(narrow, "% ")) << narrow;
    EXPECT_LT(longest_line(narrow), 20u) << narrow;
}

TEST(Progress, ADumbTerminalIsWrittenNoBar) { EXPECT_EQ(shown_on_terminal("dumb", 80, 2), ""); }

}  // namespace
}  // namespace glint::test
