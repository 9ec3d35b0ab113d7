// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/print_error.h"
#include "os/process.h"

namespace glint::cli {

int run_program(std::string_view name, int failure, const std::function<int()>& body) {
    os::prepare_streams();
    handle_signals();
    int code = failure;
    try {
        code = body();
    } catch (const std::bad_alloc&) {
        print_error("{}: out of memory\n", name);
    } catch (const std::system_error& e) {
        // What fmt::print() throws. Nothing but standard output is written with it.
        if (os::reader_is_gone(e.code().value())) os::end_by_broken_pipe();
        print_error("{}: {}\n", name, e.what());
    } catch (const std::exception& e) {
        print_error("{}: {}\n", name, e.what());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {  // CLI11 flushes only its own output
        if (os::reader_is_gone(0)) os::end_by_broken_pipe();
        print_error("{}: cannot write to standard output\n", name);
        if (code == k_done) code = failure;
    }
    return code;
}

}  // namespace glint::cli
