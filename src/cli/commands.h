// SPDX-License-Identifier: Apache-2.0
#pragma once
// The commands of glint. Each function adds a subcommand and returns the function that runs it.
#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/glint.h"

namespace glint::cli {

struct RenderHooks;

/// Runs a command that has been parsed; returns the exit code. Throws Failure.
using Run = std::function<int()>;

inline constexpr const char* k_version = "glint " GLINT_VERSION;

/// The command with this name; null if there is none.
const CLI::App* find_command(const CLI::App& app, std::string_view name);

/// The commands that --help lists.
std::vector<const CLI::App*> shown_commands(const CLI::App& app);

Run add_render(CLI::App& app);
/// In a program of several processes; the hooks must outlive what is returned.
Run add_render(CLI::App& app, const RenderHooks& hooks);
Run add_info(CLI::App& app);
Run add_convert(CLI::App& app);
Run add_check(CLI::App& app);
Run add_explain(CLI::App& app);
Run add_compare(CLI::App& app);
Run add_versus(CLI::App& app);
Run add_pixels(CLI::App& app);
Run add_diagnose(CLI::App& app);
Run add_grade(CLI::App& app);
Run add_join(CLI::App& app);
Run add_install_drop_ins(CLI::App& app);
Run add_completion(CLI::App& app);
Run add_man(CLI::App& app);
Run add_help(CLI::App& app);
Run add_version(CLI::App& app);

}  // namespace glint::cli
