// SPDX-License-Identifier: Apache-2.0
#pragma once
// Checks of option values, with glint's own messages.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace glint::cli {

/// One of these words.
CLI::Validator one_of(std::vector<std::string> words);

/// A number from least to most. CLI::Range accepts "nan", this does not.
CLI::Validator number_between(double least, double most);

/// A whole number from least to most.
CLI::Validator whole_number(long least, long most);

}  // namespace glint::cli
