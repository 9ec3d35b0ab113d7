// SPDX-License-Identifier: Apache-2.0
#include "cli/validators.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "base/text.h"
#include "cli/text.h"

namespace glint::cli {

CLI::Validator one_of(std::vector<std::string> words) {
    return CLI::Validator(
        [words = std::move(words)](const std::string& word) -> std::string {
            if (std::find(words.begin(), words.end(), word) != words.end()) return {};
            const std::vector<std::string_view> views(words.begin(), words.end());
            return fmt::format("expected {}, found {}{}", joined(views, "or"), glint::quoted(word),
                               did_you_mean(word, views));
        },
        "");
}

CLI::Validator number_between(double least, double most) {
    return CLI::Validator(
        [=](const std::string& text) -> std::string {
            char* end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            if (!text.empty() && *end == '\0' && value >= least && value <= most) return {};
            return fmt::format("expected a number from {} to {}, found {}", least, most, glint::quoted(text));
        },
        "");
}

CLI::Validator whole_number(long least, long most) {
    return CLI::Validator(
        [=](const std::string& text) -> std::string {
            long value = 0;
            const char* end = text.data() + text.size();
            const auto [at, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && at == end && value >= least && value <= most) return {};
            return fmt::format("expected a whole number from {} to {}, found {}", least, most,
                               glint::quoted(text));
        },
        "");
}

}  // namespace glint::cli
