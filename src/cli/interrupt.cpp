// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.h"

#include <atomic>
#include <cstring>
#include <string_view>

#include "cli/failure.h"
#include "os/files.h"
#include "os/process.h"

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

// A failure here cannot be reported.
void write_to_stderr(std::string_view text) { os::write(os::k_standard_error, text.data(), text.size()); }

// Leaves nothing incomplete, and says why the program ends. Only async-signal-safe calls. Loading, preparing
// and rendering hold nothing that outlives the process, so they need no request to stop.
int clean_up(os::Ending ending) {
    for (const Unfinished& file : unfinished) {
        if (file.is_there) os::remove_now(file.path);
    }
    if (progress_shown) write_to_stderr("\r\x1b[K");
    if (ending == os::Ending::file_shrank)
        write_to_stderr("glint: a scene file became shorter while it was read\n");
    if (ending == os::Ending::interrupt) {
        write_to_stderr("glint: interrupted");
        write_to_stderr(interrupt_advice);
        write_to_stderr("\n");
    }
    return k_bad_input;
}

}  // namespace

void handle_signals() { os::on_ending(clean_up); }

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
