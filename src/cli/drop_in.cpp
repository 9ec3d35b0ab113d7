// SPDX-License-Identifier: Apache-2.0
#include "cli/drop_in.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/print_error.h"

namespace glint::cli {
namespace {

int run(const DropInProgram& program, const std::vector<std::string>& arguments) {
    try {
        DropIn parsed = program.parse(arguments);
        if (parsed.wants_help || parsed.wants_version) {
            fmt::print("{}", parsed.wants_help ? drop_in_help(program)
                                               : fmt::format("{} ({})\n", program.name, k_version));
            return k_done;
        }
        for (const std::string& warning : parsed.warnings)
            print_error("{}: warning: {}\n", program.name, warning);
        return render_picture(parsed.render) == k_done ? k_done : program.failure;
    } catch (const Failure& e) {
        const std::string message = e.what();
        if (!message.empty()) print_error("{}: {}\n", program.name, message);
        return program.failure;
    }
}

}  // namespace

int run_drop_in(const DropInProgram& program, int count, char** values) {
    handle_signals();
    int code = program.failure;
    try {
        code = run(program, {values + std::min(count, 1), values + count});
    } catch (const std::bad_alloc&) {
        std::fputs("glint: out of memory\n", stderr);
    } catch (const std::exception& e) {
        print_error("{}: {}\n", program.name, e.what());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        print_error("{}: cannot write to standard output\n", program.name);
        if (code == k_done) code = program.failure;
    }
    return code;
}

}  // namespace glint::cli
