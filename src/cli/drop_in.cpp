// SPDX-License-Identifier: Apache-2.0
#include "cli/drop_in.h"

#include <algorithm>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/print_error.h"
#include "cli/program.h"

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
    return run_program(program.name, program.failure, [&] {
        return run(program, {values + std::min(count, 1), values + count});
    });
}

}  // namespace glint::cli
