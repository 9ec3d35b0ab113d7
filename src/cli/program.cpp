// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): POSIX
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/print_error.h"

namespace glint::cli {
namespace {

// Of the pipe that is standard output. The error of an earlier write is not known any more.
bool reader_is_gone() {
    pollfd output{STDOUT_FILENO, POLLOUT, 0};
    return ::poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

}  // namespace

void end_by_broken_pipe() {
    ::signal(SIGPIPE, SIG_DFL);
    ::raise(SIGPIPE);
    std::_Exit(128 + SIGPIPE);  // if the signal is blocked
}

int run_program(std::string_view name, int failure, const std::function<int()>& body) {
    handle_signals();
    int code = failure;
    try {
        code = body();
    } catch (const std::bad_alloc&) {
        print_error("{}: out of memory\n", name);
    } catch (const std::system_error& e) {
        // What fmt::print() throws. Nothing but standard output is written with it.
        if (e.code() == std::errc::broken_pipe) end_by_broken_pipe();
        print_error("{}: {}\n", name, e.what());
    } catch (const std::exception& e) {
        print_error("{}: {}\n", name, e.what());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {  // CLI11 flushes only its own output
        if (reader_is_gone()) end_by_broken_pipe();
        print_error("{}: cannot write to standard output\n", name);
        if (code == k_done) code = failure;
    }
    return code;
}

}  // namespace glint::cli
