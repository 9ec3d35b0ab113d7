// SPDX-License-Identifier: Apache-2.0
#include "os/process.h"

#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): POSIX, for sigaction
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string_view>

namespace glint::os {
namespace {

int (*clean_up_at_end)(Ending) = nullptr;

Ending ending_of(int signal) {
    return signal == SIGINT ? Ending::interrupt : signal == SIGBUS ? Ending::file_shrank : Ending::other;
}

// Uses only async-signal-safe calls.
void end_at_once(int signal) {
    const int code = clean_up_at_end(ending_of(signal));
    if (signal == SIGBUS) ::_exit(code);
    // Ends by the signal itself: a shell ends its loop only if a signal ended the child process.
    ::signal(signal, SIG_DFL);
    sigset_t set;
    ::sigemptyset(&set);
    ::sigaddset(&set, signal);
    ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    ::raise(signal);
    ::_exit(128 + signal);
}

}  // namespace

std::vector<std::string> arguments(int count, char** values) { return {values, values + count}; }

std::string name_of_program(std::string file) { return file; }

void prepare_streams() {}

bool is_terminal(int descriptor) { return ::isatty(descriptor) == 1; }

bool can_redraw(int descriptor) {
    const char* kind = std::getenv("TERM");
    return is_terminal(descriptor) && kind != nullptr && *kind != '\0' && std::string_view(kind) != "dumb";
}

int terminal_columns(int descriptor) {
    winsize size{};
    int columns = 0;
    if (::ioctl(descriptor, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
    if (columns <= 0) {
        const char* wanted = std::getenv("COLUMNS");
        columns = wanted != nullptr ? std::atoi(wanted) : 0;
    }
    return columns <= 0 ? 80 : std::min(columns, 4096);
}

void on_ending(int (*clean_up)(Ending)) {
    clean_up_at_end = clean_up;
    struct sigaction action {};
    action.sa_handler = end_at_once;
    ::sigfillset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGBUS}) {
        struct sigaction before {};
        // A signal that the parent process ignores (nohup, a background job of a shell) stays ignored.
        if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
        ::sigaction(signal, &action, nullptr);
    }
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
}

#if defined(__EMSCRIPTEN__)
// node has the signals: src/node/glint.cjs.
extern "C" __attribute__((used, visibility("default"), export_name("glint_interrupted"))) void
glint_interrupted(int signal) {
    if (clean_up_at_end != nullptr) clean_up_at_end(ending_of(signal));
}
#endif

bool reader_is_gone(int error) {
    if (error != 0) return error == EPIPE;
    pollfd output{STDOUT_FILENO, POLLOUT, 0};
    return ::poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

void end_by_broken_pipe() {
    ::signal(SIGPIPE, SIG_DFL);
    ::raise(SIGPIPE);
    std::_Exit(128 + SIGPIPE);  // if the signal is blocked
}

std::uint64_t peak_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

double physical_memory() {
    return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE));
}

std::filesystem::path program() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

}  // namespace glint::os
