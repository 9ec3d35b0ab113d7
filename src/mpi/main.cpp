// SPDX-License-Identifier: Apache-2.0
// glint-mpi: renders one picture on all processes that mpirun starts (docs/scale_out.md).
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/print_error.h"
#include "cli/render_hooks.h"
#include "cli/usage.h"
#include "mpi/distribute.h"
#include "mpi/messages.h"
#include "mpi/shared_texts.h"

namespace glint::mpi {
namespace {

constexpr auto k_description =
    "glint-mpi renders a picture on all processes that mpirun starts, with the options of `glint render`.";
constexpr auto k_examples = R"(Examples:
  mpirun -n 8 glint-mpi render castle.json -s 1920x1080 --aa 4
  mpirun -n 8 glint-mpi render castle.json --resume      goes on after a process has died)";

// As rank 0. Says what the distribution cost if GLINT_MPI_COSTS is set.
int run_leader(RecordingReader& reader, cli::RenderHooks& hooks, const cli::Run& run) {
    Costs costs;
    bool led = false;
    hooks.reader = &reader;
    hooks.loaded = [&] { reader.give(); };
    hooks.render = [&](const World& world, const RenderOptions& options, const JournalHeader& header,
                       cli::JournalFile* journal) {
        led = true;
        return lead(world, options, header, journal, costs);
    };
    const int code = run();
    if (!led) dismiss();
    if (led && std::getenv("GLINT_MPI_COSTS") != nullptr) {
        cli::print_error("rank 0: {} bytes in {} tiles received, {:.6f} s for all tiles\n",
                         costs.received_bytes, costs.received_tiles, costs.busy_seconds);
    }
    return code;
}

int run_follower(cli::RenderHooks& hooks, const cli::Run& run) {
    GivenReader reader;
    hooks.reader = &reader;
    hooks.is_writer = false;
    hooks.render = [](const World& world, const RenderOptions& options, const JournalHeader& header,
                      cli::JournalFile*) { return follow(world, options, header); };
    return run();
}

// Whether all processes have parsed their arguments; the largest of their exit codes.
int agree(int code) {
    int largest = code;
    MPI_Allreduce(&code, &largest, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return largest;
}

int run(std::vector<std::string> arguments) {
    CLI::App app(k_description, "glint-mpi");
    app.set_version_flag("-V,--version", cli::k_version, "Print the version and end");
    app.footer(k_examples);
    app.require_subcommand(1);
    cli::RenderHooks hooks;
    const cli::Run render = cli::add_render(app, hooks);
    const bool leads = rank() == 0;
    int code = cli::k_done;
    bool answered = false;
    try {
        std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the end
        app.parse(arguments);
    } catch (const CLI::Success& e) {
        answered = true;
        if (leads) app.exit(e);
    } catch (const CLI::ParseError& e) {
        code = cli::k_usage;
        if (leads)
            cli::print_error("glint-mpi: {}\nsee 'glint-mpi --help'\n",
                             cli::usage_message(*app.get_subcommands().front(), e));
    }
    code = agree(code);
    if (code != cli::k_done || answered) return code;
    RecordingReader reader;
    try {
        return leads ? run_leader(reader, hooks, render) : run_follower(hooks, render);
    } catch (const GivenUp&) {
        return cli::k_done;  // rank 0 has the exit code
    } catch (const cli::Failure& e) {
        const std::string message = e.what();
        if (!message.empty()) {
            cli::print_error("glint-mpi{}: {}\n", leads ? std::string() : fmt::format(" (rank {})", rank()),
                             message);
        }
        if (leads && reader.give_up()) return e.code();
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
