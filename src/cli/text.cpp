// SPDX-License-Identifier: Apache-2.0
#include "cli/text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <limits>

#include "base/text.h"

namespace glint::cli {
namespace {

// Removes a whole number and the character `after` (0: the end of the text) from the front.
std::optional<std::int64_t> take_number(std::string_view& text, char after) {
    std::int64_t number = 0;
    const char* end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || (after == 0) != (at == end) || (at != end && *at != after))
        return std::nullopt;
    text = std::string_view(at, static_cast<std::size_t>(end - at));
    if (after != 0) text.remove_prefix(1);
    return number;
}

}  // namespace

std::optional<Size> parse_size(std::string_view text) {
    const auto width = take_number(text, 'x');
    const auto height = width ? take_number(text, 0) : std::nullopt;
    if (!height) return std::nullopt;
    return Size{*width, *height};
}

std::string_view file_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

std::optional<Pair> parse_pair(std::string_view text) {
    const auto x = take_number(text, ',');
    const auto y = x ? take_number(text, 0) : std::nullopt;
    const auto is_int = [](std::int64_t v) { return v == static_cast<std::int32_t>(v); };
    if (!y || !is_int(*x) || !is_int(*y)) return std::nullopt;
    return Pair{static_cast<std::int32_t>(*x), static_cast<std::int32_t>(*y)};
}

std::optional<Crop> parse_crop(std::string_view text) {
    std::array<std::int64_t, 4> numbers{};
    constexpr std::array after = {'x', '+', '+', '\0'};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto number = take_number(text, after[i]);
        if (!number || *number < (i < 2 ? 1 : 0) || *number > k_max_size) return std::nullopt;
        numbers[i] = *number;
    }
    const auto at = [&](std::size_t i) { return static_cast<std::int32_t>(numbers[i]); };
    return Crop{at(0), at(1), at(2), at(3)};
}

std::string with_commas(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
    return digits;
}

std::string counted(std::uint64_t number, std::string_view noun) {
    if (noun.ends_with("us") && number != 1)
        return fmt::format("{} {}i", with_commas(number), noun.substr(0, noun.size() - 2));
    const std::string_view plural = noun.ends_with('x') || noun.ends_with("sh") ? "es" : "s";
    return fmt::format("{} {}{}", with_commas(number), noun, number == 1 ? "" : plural);
}

std::string bytes_text(double bytes) {
    constexpr std::array units = {"kB", "MB", "GB", "TB", "PB", "EB"};
    if (bytes < 1000) return fmt::format("{:.0f} bytes", bytes);
    std::size_t unit = 0;
    for (bytes /= 1000; bytes >= 1000 && unit + 1 < units.size(); ++unit) bytes /= 1000;
    return fmt::format("{:.1f} {}", bytes, units[unit]);
}

std::string joined(std::span<const std::string_view> words, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i != 0) text += i + 1 == words.size() ? fmt::format(" {} ", last) : ", ";
        text += words[i];
    }
    return text;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
    const std::string near = did_you_mean(word, known);
    return near.empty() ? fmt::format("; there are {}", joined(known))
                        : fmt::format("{} (there are {})", near, joined(known));
}

std::string stem(std::string_view path) {
    const std::string_view name = file_name(path);
    const std::size_t dot = name.rfind('.');
    return std::string(dot == 0 ? name : name.substr(0, dot));
}

std::string extension(std::string_view path) {
    const std::string_view name = file_name(path);
    const std::size_t dot = name.rfind('.');
    if (dot == 0 || dot == std::string_view::npos) return {};
    std::string text(name.substr(dot));
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    return text;
}

}  // namespace glint::cli
