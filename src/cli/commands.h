#pragma once
// The commands of glint. Each adds its subcommand and returns what runs it: the exit code, or a Failure.
#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace glint::cli {

/// Runs a command that has been parsed; returns the exit code.
using Run = std::function<int()>;

/// The check of an option that takes one of these words.
CLI::Validator one_of(std::vector<std::string> words);

Run add_render(CLI::App& app);
Run add_info(CLI::App& app);
Run add_convert(CLI::App& app);
Run add_check(CLI::App& app);
Run add_explain(CLI::App& app);
Run add_compare(CLI::App& app);
Run add_versus(CLI::App& app);
Run add_grade(CLI::App& app);
Run add_completion(CLI::App& app);

}  // namespace glint::cli
