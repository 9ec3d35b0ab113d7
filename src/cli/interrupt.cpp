// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.h"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): POSIX, for sigaction
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <string_view>

#include "cli/failure.h"

namespace glint::cli {
namespace {

// Read by a signal handler, so not a std::string.
constexpr int k_unfinished = 4;
struct Unfinished {
    char path[4200];
    std::atomic<bool> is_used{false}, is_there{false};
} unfinished[k_unfinished];
char interrupt_advice[201];
std::atomic<bool> progress_shown{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void write_to_stderr(std::string_view text) {
    // A failure here cannot be reported.
    [[maybe_unused]] const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
}

// Leaves nothing incomplete, and says why the program ends.
void clean_up(int signal) {
    for (const Unfinished& file : unfinished) {
        if (file.is_there) ::unlink(file.path);
    }
    if (progress_shown) write_to_stderr("\r\x1b[K");
    if (signal == SIGBUS) {
        write_to_stderr("glint: a scene file became shorter while it was read\n");
        ::_exit(k_bad_input);
    }
    if (signal == SIGINT) {
        write_to_stderr("glint: interrupted");
        write_to_stderr(interrupt_advice);
        write_to_stderr("\n");
    }
}

// Uses only async-signal-safe calls. Loading, preparing and rendering hold nothing that outlives the
// process, so they need no request to stop.
void end_at_once(int signal) {
    clean_up(signal);
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

void handle_signals() {
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
    clean_up(signal);
}
#endif

UnfinishedFile::UnfinishedFile(const std::string& path) {
    if (path.size() >= sizeof unfinished[0].path) return;
    for (int slot = 0; slot < k_unfinished && slot_ < 0; ++slot) {
        if (!unfinished[slot].is_used.exchange(true)) slot_ = slot;
    }
    if (slot_ < 0) return;
    std::memcpy(unfinished[slot_].path, path.c_str(), path.size() + 1);
    unfinished[slot_].is_there = true;
}

UnfinishedFile::~UnfinishedFile() {
    if (slot_ < 0) return;
    unfinished[slot_].is_there = false;
    unfinished[slot_].is_used = false;
}

void set_interrupt_advice(const std::string& advice) {
    std::strncpy(interrupt_advice, advice.c_str(), sizeof interrupt_advice - 1);
}

void set_progress_shown(bool shown) { progress_shown = shown; }

}  // namespace glint::cli
