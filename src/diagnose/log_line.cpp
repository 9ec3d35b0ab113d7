// SPDX-License-Identifier: Apache-2.0
#include "diagnose/log_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "formats/number_text.h"

namespace glint {
namespace {

constexpr std::array<bool, 256> k_separators = [] {
    std::array<bool, 256> is_one{};
    for (const char c : std::string_view(" \t\r,;()[]{}=:")) is_one[static_cast<unsigned char>(c)] = true;
    return is_one;
}();
bool separates_items(char c) { return k_separators[static_cast<unsigned char>(c)]; }

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string key_of(std::string_view written) {
    std::string key;
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (written.substr(i, 2) == "\xc2\xb7") {  // a middle dot
            ++i;
        } else if (const char c = written[i]; c != '_' && c != '.' && c != '*' && c != '-') {
            key += small_letter(written[i]);
        }
    }
    return key;
}

// A number that is written as a word.
std::optional<LogNumber> number_word(std::string_view token) {
    const std::string word = in_small_letters(token);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     infinity = std::numeric_limits<double>::infinity();
    if (word == "true" || word == "false") return LogNumber{word == "true" ? 1.0 : 0.0};
    if (word == "nan" || word == "-nan" || word == "null" || word == "+nan") return LogNumber{nan};
    if (word == "inf" || word == "+inf" || word == "infinity") return LogNumber{infinity};
    if (word == "-inf" || word == "-infinity") return LogNumber{-infinity};
    return std::nullopt;
}

std::optional<LogNumber> number_of(std::string_view token) {
    const char first = token.empty() ? '0' : token[token.size() > 1 && (token[0] == '-' || token[0] == '+')];
    if (!is_decimal_digit(first) && first != '.') return number_word(token);
    if (token.starts_with('+')) token.remove_prefix(1);
    // The suffix of a literal in C.
    if (token.size() > 1 && (token.back() == 'f' || token.back() == 'F')) token.remove_suffix(1);
    if (token.empty()) return std::nullopt;
    LogNumber number;
    if (read_any_number(token.data(), token.data() + token.size(), number.v) != token.data() + token.size())
        return std::nullopt;
    bool is_leading = true;
    std::size_t exponent_at = token.size();
    for (std::size_t i = 0; i < token.size(); ++i) {
        const char c = token[i];
        if (c == 'e' || c == 'E') {
            exponent_at = i;
            break;
        }
        if (c == '.') number.has_point = true;
        if (!is_decimal_digit(c)) continue;
        if (c != '0') is_leading = false;
        if (!is_leading) ++number.significant;
        if (number.has_point) ++number.decimals;
    }
    if (exponent_at < token.size()) {
        std::string_view digits = token.substr(exponent_at + 1);
        if (digits.starts_with('+')) digits.remove_prefix(1);
        double exponent = 0;
        read_any_number(digits.data(), digits.data() + digits.size(), exponent);
        number.decimals =
            std::max(0, number.decimals - static_cast<int>(std::clamp(exponent, -400.0, 400.0)));
    }
    return number;
}

}  // namespace

std::string in_small_letters(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = small_letter(c);
    return result;
}

std::vector<LogItem> split_items(std::string_view line,
                                 const std::function<bool(std::string_view)>& takes_word) {
    std::vector<LogItem> items;
    std::size_t at = 0;
    while (at < line.size()) {
        if (separates_items(line[at])) {
            ++at;
            continue;
        }
        if (line[at] == '#') break;
        const std::size_t first = at;
        std::string_view token;
        const bool is_quoted = line[at] == '"' || line[at] == '\'';
        if (is_quoted) {
            const std::size_t end = std::min(line.find(line[at], at + 1), line.size());
            token = line.substr(at + 1, end - at - 1);
            at = std::min(end + 1, line.size());
        } else {
            while (at < line.size() && !separates_items(line[at]) && line[at] != '#') ++at;
            token = line.substr(first, at - first);
        }
        if (const auto number = number_of(token)) {
            if (!items.empty()) items.back().numbers.push_back(*number);
            continue;
        }
        if (token.find_first_not_of("-<>|") == std::string_view::npos) continue;  // a rule, an arrow
        if (token == "ind" || token == "snan") continue;                          // of -nan(ind)
        if (!items.empty() && items.back().word.empty() && items.back().numbers.empty() &&
            takes_word(items.back().key)) {
            items.back().word = in_small_letters(token);
            continue;
        }
        LogItem& item = items.emplace_back();
        item.written = token;
        item.key = key_of(token);
        item.offset = first;
    }
    return items;
}

bool is_printrays(std::string_view text) {
    return text.substr(0, 4096).find("Iteration type:") != std::string_view::npos;
}

std::string translate_printrays(std::string_view line) {
    const auto after = [&](std::string_view label) -> std::optional<std::string_view> {
        const std::size_t at = line.find(label);
        if (at == std::string_view::npos ||
            line.substr(0, at).find_first_not_of(' ') != std::string_view::npos)
            return std::nullopt;
        return line.substr(at + label.size());
    };
    if (const auto rest = after("Iteration type:")) return fmt::format("ray {}", *rest);
    if (const auto rest = after("Ray:")) {
        const std::size_t arrow = rest->find("->");
        if (arrow == std::string_view::npos) return fmt::format("origin {}", *rest);
        return fmt::format("origin {} direction {}", rest->substr(0, arrow), rest->substr(arrow + 2));
    }
    if (const auto rest = after("Hit Object:")) {
        const std::size_t at = rest->find('#');
        return at == std::string_view::npos
                   ? ""
                   : fmt::format("shape {}", rest->substr(at + 1, rest->find(' ', at) - at - 1));
    }
    if (const auto rest = after("Intersection:")) {
        const std::size_t at = rest->find(" at ");
        if (at == std::string_view::npos) return fmt::format("P {}", *rest);
        return fmt::format("P {} {}", rest->substr(0, at), rest->substr(at + 4));
    }
    if (const auto rest = after("Extra Info:"))
        return rest->find("into-air") != std::string_view::npos ? "inside 1" : "inside 0";
    if (after("No intersection")) return "miss";
    for (const std::string_view label : {"Pixel:", "Normal:", "Ambient:", "Diffuse:", "Specular:"})
        if (after(label)) return std::string(line);
    return "";
}

void LogDigits::add(Quantity quantity, const LogNumber& number) {
    if (!std::isfinite(number.v)) return;
    const auto add = [&](Digits& digits) {
        digits.least_decimals = std::min(digits.least_decimals, number.decimals);
        digits.most_decimals = std::max(digits.most_decimals, number.decimals);
        digits.significant = std::max(digits.significant, number.significant);
        ++digits.count;
    };
    add(digits_[static_cast<std::size_t>(quantity)]);
    if (quantity != Quantity::bytes && info_of(quantity).kind != QuantityKind::flag) add(all_);
}

void LogDigits::merge(Quantity from, Quantity to) {
    const Digits& a = digits_[static_cast<std::size_t>(from)];
    Digits& b = digits_[static_cast<std::size_t>(to)];
    b.least_decimals = std::min(a.least_decimals, b.least_decimals);
    b.most_decimals = std::max(a.most_decimals, b.most_decimals);
    b.significant = std::max(a.significant, b.significant);
}

Approx LogDigits::with_error(const Digits& own, Approx value) const {
    const auto tens = [](int count) {
        double power = 1;
        for (int i = 0; i < count; ++i) power *= 10;
        return power;
    };
    if (!std::isfinite(value.v) || own.most_decimals == 0) return value;
    const bool is_fixed = own.least_decimals == own.most_decimals && own.count >= 3;
    // A few round numbers do not show how a quantity is printed: then as the others are.
    const Digits& digits = is_fixed || own.significant > 3 || own.count >= 20 ? own : all_;
    if (!is_fixed && digits.significant < 15) {
        // Half a unit of the last digit of the number itself, whose first digit may be 1.
        value.e = std::fabs(value.v) * 0.5 / tens(std::max(digits.significant, 1) - 1);
    }
    // Programs may round to a number of decimals and leave out zeros.
    if (is_fixed || (digits.significant < 15 && digits.most_decimals < 16))
        value.e = std::max(value.e, 0.5 / tens(digits.most_decimals));
    return value;
}

void LogDigits::set_errors(TraceLog& log) const {
    const auto set = [&](LoggedValues& of) {
        for (LoggedValue& value : of.list) {
            const Digits& digits = digits_[static_cast<std::size_t>(value.quantity)];
            value.value = {with_error(digits, value.value.x), with_error(digits, value.value.y),
                           with_error(digits, value.value.z)};
        }
    };
    for (LoggedPixel& pixel : log.pixels) {
        set(pixel);
        for (LoggedRay& ray : pixel.rays) {
            set(ray);
            for (LoggedLight& light : ray.lights) set(light);
        }
    }
}

}  // namespace glint
