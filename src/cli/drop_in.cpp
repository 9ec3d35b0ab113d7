// SPDX-License-Identifier: Apache-2.0
#include "cli/drop_in.h"

#include <algorithm>
#include <cstdio>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/output_file.h"
#include "cli/print_error.h"
#include "cli/program.h"
#include "os/process.h"

namespace glint::cli {
namespace {

// One picture, or those of an animation until one fails.
int render(DropIn& parsed) {
    if (parsed.frames.empty()) return render_picture(parsed.render);
    for (const DropInFrame& frame : parsed.frames) {
        RenderArguments arguments = parsed.render;
        arguments.output = frame.output;
        for (const auto& [name, value] : frame.declared) arguments.scene.declared.emplace_back(name, value);
        if (const int code = render_picture(arguments); code != k_done) return code;
    }
    return k_done;
}

int run(const DropInProgram& program, const std::vector<std::string>& arguments) {
    try {
        DropIn parsed = program.parse(arguments);
        if (parsed.wants_help || parsed.wants_version) {
            fmt::print("{}", parsed.wants_help ? drop_in_help(program)
                                               : fmt::format("{} ({})\n", program.name, k_version));
            return k_done;
        }
        const std::string& output = parsed.render.output;
        if (is_standard_output(output)) CopiesErrors::set(false);
        for (const std::string& warning : parsed.warnings)
            print_error("{}: warning: {}\n", program.name, warning);
        return render(parsed) == k_done ? k_done : program.failure;
    } catch (const Failure& e) {
        const std::string message = e.what();
        if (!message.empty()) print_error("{}: {}\n", program.name, message);
        return program.failure;
    }
}

std::string program_name(std::string_view path) {
    return os::name_of_program(std::string(path.substr(path.rfind('/') + 1)));
}

}  // namespace

const DropInProgram* called_drop_in(std::string_view called) { return find_drop_in(program_name(called)); }

int run_drop_in(const DropInProgram& program, std::string_view called,
                const std::vector<std::string>& words) {
    const bool stands = !program.stands_for.empty() && program_name(called) == program.stands_for;
    // Callers read standard output and look at its last line; others see standard error.
    CopiesErrors::set(stands);
    const int code = run_program(program.name, program.failure, [&] { return run(program, words); });
    if (!CopiesErrors::get() || code != program.failure) return code;
    fmt::print("{}\n", program.refusal);
    return std::fflush(stdout) == 0 ? k_done : code;
}

}  // namespace glint::cli
