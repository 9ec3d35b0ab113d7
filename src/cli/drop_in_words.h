// SPDX-License-Identifier: Apache-2.0
#pragma once
// How POV-Ray's command lines and .ini files are taken apart into options.
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

/// Without blanks around it, and without the quotes " or ' that enclose the rest.
std::string trimmed_value(std::string_view text);
/// A line of an .ini file without its comment, which begins with a semicolon outside of quotes.
std::string_view without_comment(std::string_view line);
/// The options of a text: "+W60 +H40" are two, also "Width=60 Height=40" if `keys_end_values`, a quoted
/// blank separates nothing. In .ini files the value of a key goes to the end of the line.
std::vector<std::string> split_options(std::string_view text, bool keys_end_values);

}  // namespace glint::cli
