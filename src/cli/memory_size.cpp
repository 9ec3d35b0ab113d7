// SPDX-License-Identifier: Apache-2.0
#include "cli/memory_size.h"

#include <fmt/format.h>

#include <charconv>

#include "base/text.h"

namespace glint::cli {

std::optional<std::uint64_t> parse_memory_size(std::string_view text) {
    constexpr std::string_view letters = "KMGT";
    int shift = 0;
    if (!text.empty()) {
        const char last = text.back();
        const std::size_t at =
            letters.find(last >= 'a' && last <= 'z' ? static_cast<char>(last - 'a' + 'A') : last);
        if (at != std::string_view::npos) {
            shift = 10 * (static_cast<int>(at) + 1);
            text.remove_suffix(1);
        }
    }
    std::uint64_t number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || number == 0 || number > (UINT64_MAX >> shift))
        return std::nullopt;
    return number << shift;
}

void add_memory_argument(CLI::App& command, std::uint64_t& bytes, const std::string& description) {
    command
        .add_option_function<std::string>(
            "--max-memory",
            [&bytes](const std::string& text) { bytes = parse_memory_size(text).value_or(0); }, description)
        ->check(CLI::Validator(
            [](const std::string& text) -> std::string {
                if (parse_memory_size(text)) return {};
                return fmt::format("expected a size as 500M or 4G, found {}", glint::quoted(text));
            },
            ""))
        ->option_text("SIZE");
}

}  // namespace glint::cli
