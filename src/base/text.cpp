// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glint {
namespace {

constexpr std::size_t k_max_quoted = 40;  // bytes
constexpr std::size_t k_max_word = 32;    // longer words get no suggestion
constexpr std::size_t k_max_candidates = 1000;
constexpr std::size_t k_min_beginning = 3;  // letters from which a longer word can be guessed

// Optimal string alignment distance: insertions, deletions, changes, swaps of neighbours; f for ph is one
// change, as in "fong".
std::size_t distance(std::string_view a, std::string_view b) {
    using Row = std::array<std::size_t, k_max_word + 1>;
    Row before{}, above{}, row{};
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
            if (j > 1 && a[i - 1] == 'f' && b.substr(j - 2, 2) == "ph") {
                row[j] = std::min(row[j], above[j - 2] + 1);
            }
            if (i > 1 && a.substr(i - 2, 2) == "ph" && b[j - 1] == 'f') {
                row[j] = std::min(row[j], before[j - 1] + 1);
            }
        }
        before = above;
        above = row;
    }
    return above[b.size()];
}

// U+202A to U+202E and U+2066 to U+2069 change the direction of what follows.
bool is_direction(std::string_view character) {
    return (character >= "\xe2\x80\xaa" && character <= "\xe2\x80\xae") ||
           (character >= "\xe2\x81\xa6" && character <= "\xe2\x81\xa9");
}

std::string escape(std::string_view text, std::string_view kept) {
    std::string out;
    while (!text.empty()) {
        const Character c = first_character(text);
        const std::string_view bytes = text.substr(0, c.length);
        text.remove_prefix(c.length);
        if (c.is_printable || kept.find(bytes) != std::string_view::npos) {
            out += bytes;
        } else {
            for (const char byte : bytes) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
        }
    }
    return out;
}

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

}  // namespace

bool is_absolute_path(std::string_view name) {
#if defined(_WIN32)
    if (name.size() > 1 && name[1] == ':') return true;
#endif
    return name.starts_with('/');
}

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char c = byte(0);
    if (c < 0x80) return 1;
    const std::size_t length = c >= 0xc2 && c <= 0xdf   ? 2
                               : (c & 0xf0) == 0xe0     ? 3
                               : c >= 0xf0 && c <= 0xf4 ? 4
                                                        : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if (!is_continuation(text[i])) return 0;
    }
    // Overlong encodings, surrogates, and values above U+10FFFF.
    if ((c == 0xe0 && byte(1) < 0xa0) || (c == 0xed && byte(1) > 0x9f)) return 0;
    if ((c == 0xf0 && byte(1) < 0x90) || (c == 0xf4 && byte(1) > 0x8f)) return 0;
    return length;
}

Character first_character(std::string_view text) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return {false, 1};
    const std::string_view bytes = text.substr(0, length);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    // U+0080 to U+009F are control characters too.
    const bool is_control =
        byte(0) < 0x20 || byte(0) == 0x7f || (length == 2 && byte(0) == 0xc2 && byte(1) < 0xa0);
    return {!is_control && !is_direction(bytes), length};
}

std::string printable(std::string_view text) { return escape(text, {}); }

std::string printable_lines(std::string_view text) { return escape(text, "\n\t"); }

std::string quoted(std::string_view text) {
    std::string out = "'";
    while (!text.empty() && out.size() <= k_max_quoted) {
        const std::size_t length = first_character(text).length;
        out += printable(text.substr(0, length));
        text.remove_prefix(length);
    }
    return out + (text.empty() ? "'" : "...'");
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates) {
    std::string_view best;
    std::size_t best_distance = word.size() / 3 + 1;
    if (word.empty() || word.size() > k_max_word) return best;
    for (const auto candidate : candidates.first(std::min(candidates.size(), k_max_candidates))) {
        if (candidate.size() > k_max_word) continue;
        const std::size_t d = distance(word, candidate);
        if (d < best_distance) {
            best = candidate;
            best_distance = d;
        }
    }
    if (!best.empty() || word.size() < k_min_beginning) return best;
    for (const auto candidate : candidates.first(std::min(candidates.size(), k_max_candidates))) {
        if (!candidate.starts_with(word)) continue;
        if (!best.empty()) return {};
        best = candidate;
    }
    return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
    const auto near = nearest_word(word, candidates);
    // The candidate may come from the user's text, and a message may be unable to show it.
    const bool shown = !near.empty() && quoted(near) == fmt::format("'{}'", near);
    return shown ? fmt::format("; did you mean `{}`?", near) : std::string();
}

std::string one_of(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += fmt::format("{}`{}`", i == 0 ? "" : i + 1 < words.size() ? ", " : " or ", words[i]);
    return text;
}

int hex_digit(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

std::string with_article(std::string_view word) {
    const bool has_vowel =
        !word.empty() && std::string_view("aeiou").find(word.front()) != std::string_view::npos;
    return fmt::format("{} {}", has_vowel ? "an" : "a", word);
}

}  // namespace glint
