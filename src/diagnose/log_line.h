// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tokens of a line of a log, and the digits that its numbers were printed with.
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/trace_log.h"

namespace glint {

/// A number, with its digits: significant ones, and those after the point (counted for the exponent 0).
struct LogNumber {
    double v = 0;
    int significant = 0, decimals = 0;
    bool has_point = false;
};

/// A key and its values.
struct LogItem {
    std::string written, key;  ///< as it is in the log; in small letters, without `_`, `.`, `*`, `-`
    std::size_t offset = 0;    ///< in the line
    std::string word;          ///< the value that is a word, in small letters if it is not quoted
    std::vector<LogNumber> numbers;
};

/// ASCII letters made small, as names and words of a log are.
std::string in_small_letters(std::string_view text);

/// The keys of a line with their values. takes_word: whether a word after this key is its value.
std::vector<LogItem> split_items(std::string_view line,
                                 const std::function<bool(std::string_view)>& takes_word);

/// Whether a text is the output of CSC 473's `printrays`.
bool is_printrays(std::string_view text);
/// A line of it, as a line of keys.
std::string translate_printrays(std::string_view line);

/// How the numbers of each quantity were printed, from which the error of each follows: with a fixed number
/// of decimals (%f), or with as many significant digits as the longest has (%g).
class LogDigits {
  public:
    void add(Quantity quantity, const LogNumber& number);
    /// Numbers of one quantity turn out to be of another.
    void merge(Quantity from, Quantity to);
    /// Sets the errors of all values of a log.
    void set_errors(TraceLog& log) const;

  private:
    struct Digits {
        int least_decimals = 99, most_decimals = 0, significant = 0;
        std::size_t count = 0;
    };
    Approx with_error(const Digits& digits, Approx value) const;

    std::array<Digits, k_quantities> digits_;
    Digits all_;  // of all numbers but bytes and flags
};

}  // namespace glint
