// SPDX-License-Identifier: Apache-2.0
#include "mpi/command_line.h"

namespace glint::mpi {
namespace {

constexpr auto k_description =
    "glint-mpi renders a picture on all processes that mpirun starts, with the options of `glint render`.";
constexpr auto k_examples = R"(Examples:
  mpirun -n 8 glint-mpi render castle.json -s 1920x1080 --aa 4
  mpirun -n 8 glint-mpi render castle.json --resume      goes on after a process has died)";

}  // namespace

cli::Run add_command_line(CLI::App& app, const cli::RenderHooks& hooks) {
    app.description(k_description);
    app.set_version_flag("-V,--version", cli::k_version, "Print the version and end");
    app.footer(k_examples);
    app.require_subcommand(0, 1);  // parse_command_line() says that there is none
    return cli::add_render(app, hooks);
}

}  // namespace glint::mpi
