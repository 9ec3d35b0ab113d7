// SPDX-License-Identifier: Apache-2.0
#pragma once
// The command line of glint-mpi. Without MPI, so that tests read command lines without mpirun.
#include <CLI/CLI.hpp>

#include "cli/commands.h"
#include "cli/render_hooks.h"

namespace glint::mpi {

/// Adds the options and the command `render` to an app with the name `k_program`. The hooks must outlive what
/// is returned, which holds the values of the options and must outlive the app.
[[nodiscard]] cli::Run add_command_line(CLI::App& app, const cli::RenderHooks& hooks);

inline constexpr const char* k_program = "glint-mpi";

}  // namespace glint::mpi
