// SPDX-License-Identifier: Apache-2.0
#pragma once
// Checks of options' values, in the command's own words.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace glint::cli {

/// One of these words.
CLI::Validator one_of(std::vector<std::string> words);

/// A number from least to most. CLI::Range takes "nan" for one.
CLI::Validator number_between(double least, double most);

/// A whole number from least to most.
CLI::Validator whole_number(long least, long most);

}  // namespace glint::cli
