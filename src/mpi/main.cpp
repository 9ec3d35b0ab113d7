// SPDX-License-Identifier: Apache-2.0
// glint-mpi: renders one picture on all processes that mpirun starts (docs/scale_out.md).
#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cstdio>

#include "cli/command_line.h"
#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/print_error.h"
#include "cli/render_hooks.h"
#include "mpi/command_line.h"
#include "mpi/distribute.h"
#include "mpi/messages.h"
#include "mpi/shared_texts.h"

namespace glint::mpi {
namespace {

// As rank 0. Says what the distribution cost if GLINT_MPI_COSTS is set.
int run_leader(RecordingReader& reader, cli::RenderHooks& hooks, const cli::Run& run) {
    Costs costs;
    bool led = false;
    hooks.reader = &reader;
    hooks.loaded = [&] { reader.give(); };
    hooks.render = [&](const World& world, const RenderOptions& options, const JournalHeader& header,
                       RecordSink* sink) {
        led = true;
        return lead(world, options, header, *sink, costs);
    };
    const int code = run();
    if (!led) dismiss();
    if (led && std::getenv("GLINT_MPI_COSTS") != nullptr) {
        cli::print_error("rank 0: {} bytes in {} tiles received, {:.6f} s for all tiles\n",
                         costs.received_bytes, costs.received_tiles, costs.busy_seconds);
    }
    return code;
}

int run_follower(GivenReader& reader, cli::RenderHooks& hooks, const cli::Run& run) {
    hooks.reader = &reader;
    hooks.is_writer = false;
    hooks.render = [](const World& world, const RenderOptions& options, const JournalHeader& header,
                      RecordSink*) { return follow(world, options, header); };
    return run();
}

// Whether all processes have parsed their arguments; the largest of their exit codes.
int agree(int code) {
    int largest = code;
    MPI_Allreduce(&code, &largest, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return largest;
}

int run(const std::vector<std::string>& arguments) {
    CLI::App app("", k_program);
    cli::RenderHooks hooks;
    const cli::Run render = add_command_line(app, hooks);
    const cli::CommandLine line = cli::parse_command_line(app, arguments);
    const bool leads = rank() == 0;
    if (leads && !line.error.empty())
        cli::print_error("{}", cli::usage_error_text(k_program, line.command, line.error));
    if (leads) fmt::print("{}", line.answer);
    const int code = agree(line.error.empty() ? cli::k_done : cli::k_usage);
    const bool answered = !line.answer.empty();
    if (code != cli::k_done || answered) return code;
    RecordingReader texts;
    GivenReader given;
    try {
        return leads ? run_leader(texts, hooks, render) : run_follower(given, hooks, render);
    } catch (const GivenUp&) {
        return cli::k_done;  // rank 0 has the exit code
    } catch (const cli::Failure& e) {
        // What is wrong for all, rank 0 says.
        if (!leads && given.is_given_up()) return cli::k_done;
        const std::string message = e.what();
        const std::string program = leads ? k_program : fmt::format("{} (rank {})", k_program, rank());
        if (leads && e.code() == cli::k_usage) {
            cli::print_error("{}", cli::usage_error_text(program, line.command, message));
        } else if (!message.empty()) {
            cli::print_error("{}: {}\n", program, message);
        }
        if (leads && texts.give_up()) return e.code();
        MPI_Abort(MPI_COMM_WORLD, e.code());
        return e.code();
    }
}

}  // namespace
}  // namespace glint::mpi

int main(int count, char** values) {
    int support = 0;
    // The threads that render exchange messages, one at a time.
    MPI_Init_thread(&count, &values, MPI_THREAD_SERIALIZED, &support);
    glint::cli::handle_signals();
    int code = glint::cli::k_bad_input;
    if (support < MPI_THREAD_SERIALIZED) {
        glint::cli::print_error(
            "glint-mpi: this MPI does not allow several threads (MPI_THREAD_SERIALIZED)\n");
        MPI_Abort(MPI_COMM_WORLD, code);
    }
    try {
        code = glint::mpi::run({values + std::min(count, 1), values + count});
    } catch (const std::exception& e) {
        glint::cli::print_error("glint-mpi: {}\n", e.what());
        MPI_Abort(MPI_COMM_WORLD, code);
    }
    MPI_Finalize();
    return code;
}
