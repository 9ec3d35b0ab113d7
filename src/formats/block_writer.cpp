// SPDX-License-Identifier: Apache-2.0
#include "formats/block_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "math/transform.h"

namespace glint {
namespace {

constexpr std::size_t k_columns = 100, k_step = 4;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_bare_word(std::string_view text) {
    return !text.empty() && is_letter(text.front()) &&
           std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

bool is_control(char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f; }

// n with n / 255 == channel in the channel's precision, or -1.
template <class Number> int byte_of(Number channel) {
    if (!(channel >= 0 && channel <= 1)) return -1;
    const int n = static_cast<int>(std::lround(channel * 255));
    return same_bits(static_cast<Number>(n / 255.0), channel) ? n : -1;
}

// The number with the fewest decimals that is `channel` in single precision.
double shortest(float channel) {
    double power = 1;
    for (int decimals = 0; decimals <= 9; ++decimals, power *= 10) {
        // Whole numbers below 2^53 over a power of ten are the doubles nearest to those decimals.
        const double number = std::round(double{channel} * power) / power;
        if (same_bits(static_cast<float>(number), channel)) return number;
    }
    return channel;
}

void append_color(std::string& out, Vec3 numbers, int r, int g, int b) {
    const std::size_t start = out.size();
    append(out, numbers);
    if (r < 0 || g < 0 || b < 0) return;
    const std::string bytes = fmt::format("rgb255({}, {}, {})", r, g, b);
    if (bytes.size() < out.size() - start) out.replace(start, std::string::npos, bytes);
}

// Replaces control characters by spaces: terminals would interpret them, and NUL may end a text.
void append_comment(std::string& out, std::string_view text) {
    for (const char c : text) out += is_control(c) ? ' ' : c;
}

}  // namespace

void append(std::string& out, double number) { fmt::format_to(std::back_inserter(out), "{}", number); }

void append(std::string& out, std::uint32_t value) { fmt::format_to(std::back_inserter(out), "{}", value); }

void append(std::string& out, std::int32_t value) { fmt::format_to(std::back_inserter(out), "{}", value); }

void append(std::string& out, bool value) { out += value ? "true" : "false"; }

void append(std::string& out, Vec3 v) {
    fmt::format_to(std::back_inserter(out), "({}, {}, {})", v.x, v.y, v.z);
}

void append(std::string& out, Color c) {
    append_color(out, {c.r, c.g, c.b}, byte_of(c.r), byte_of(c.g), byte_of(c.b));
}

void append(std::string& out, const ShapeColor& c) {
    append_color(out, {shortest(c.r), shortest(c.g), shortest(c.b)}, byte_of(c.r), byte_of(c.g),
                 byte_of(c.b));
}

void append(std::string& out, const UvMap& map) {
    const auto& m = map.m;
    fmt::format_to(std::back_inserter(out), "(({}, {}, {}), ({}, {}, {}))", m[0][0], m[0][1], m[0][2],
                   m[1][0], m[1][1], m[1][2]);
}

void append(std::string& out, const Attenuation& a) { append(out, Vec3{a.c0, a.c1, a.c2}); }

void append_quoted(std::string& out, std::string_view text) {
    out += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (is_control(c)) {
            fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned char>(c));
        } else {
            out += c;
        }
    }
    out += '"';
}

void append_name(std::string& out, std::string_view name) {
    if (is_bare_word(name)) {
        out += name;
    } else {
        append_quoted(out, name);
    }
}

void BlockWriter::begin(std::string_view head, std::size_t width) {
    head_.assign(head);
    if (head_.size() < width) head_.resize(width, ' ');
    line_.clear();
    breaks_.clear();
}

void BlockWriter::begin(std::string_view word, std::string_view name, std::size_t width) {
    begin(word);
    if (!name.empty()) {
        head_ += ' ';
        append_quoted(head_, name);
    }
    if (head_.size() < width) head_.resize(width, ' ');
}

std::string& BlockWriter::key(std::string_view name) {
    if (!line_.empty()) {
        line_ += "  ";
        breaks_.push_back({line_.size(), part_begins_ ? Where::part : Where::key});
    }
    part_begins_ = false;
    line_ += name;
    line_ += " = ";
    return line_;
}

void BlockWriter::comments(std::span<const std::string_view> lines) {
    for (const std::string_view line : lines) {
        out_.append(indent_, ' ');
        out_ += line.empty() ? "#" : "# ";
        append_comment(out_, line);
        out_ += '\n';
    }
}

void BlockWriter::end(std::span<const std::string_view> above, std::span<const std::string_view> after) {
    comments(above);
    after_.clear();
    for (const std::string_view comment : after) {
        after_ += after_.empty() ? "  # " : "; ";
        append_comment(after_, comment);
    }
    const bool keys_only = head_.empty();
    const std::size_t length = indent_ + line_.size() + (keys_only ? 0 : head_.size() + 5);
    const bool fits = one_line_ || length <= k_columns;
    if (!after_.empty() && (fits ? length : indent_ + 1) + after_.size() > k_columns) {
        const std::string_view alone = std::string_view(after_).substr(4);
        comments({&alone, 1});
        after_.clear();
    }
    out_.append(indent_, ' ');
    if (keys_only) {
        append_filled(indent_);
    } else if (fits) {
        fmt::format_to(std::back_inserter(out_), "{} {{ {} }}", head_, line_);
    } else {
        while (head_.ends_with(' ')) head_.pop_back();
        fmt::format_to(std::back_inserter(out_), "{} {{\n", head_);
        out_.append(indent_ + k_step, ' ');
        append_filled(indent_ + k_step);
        out_ += '\n';
        out_.append(indent_, ' ');
        out_ += '}';
    }
    out_ += after_;
    out_ += '\n';
}

// Writes the keys in as many lines as they need. The indentation of the first line has been written.
void BlockWriter::append_filled(std::size_t indent) {
    std::size_t column = indent, from = 0;
    breaks_.push_back({line_.size(), Where::key});
    for (std::size_t i = 0; i < breaks_.size(); ++i) {
        std::string_view part = std::string_view(line_).substr(from, breaks_[i].at - from);
        std::size_t length = part.size();
        while (length > 0 && part[length - 1] == ' ') --length;
        const Where where = i > 0 ? breaks_[i - 1].where : Where::key;
        if (from > 0 && !one_line_ && (column + length > k_columns || where == Where::part)) {
            while (out_.ends_with(' ')) out_.pop_back();
            column = indent + (where == Where::value ? k_step : 0);
            out_ += '\n';
            out_.append(column, ' ');
        }
        out_ += part;
        column += part.size();
        from = breaks_[i].at;
    }
}

void BlockWriter::open(std::string_view head) {
    out_.append(indent_, ' ');
    out_ += head;
    out_ += " {\n";
    indent_ += k_step;
}

void BlockWriter::close() {
    indent_ -= k_step;
    out_.append(indent_, ' ');
    out_ += "}\n";
}

bool same_bits(const Affine& a, const Affine& b) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            if (!same_bits(a.m[row][column], b.m[row][column])) return false;
        }
    }
    return true;
}

void write_map(BlockWriter& block, const Affine& map) {
    const auto& m = map.m;
    const Vec3 move{m[0][3], m[1][3], m[2][3]}, factors{m[0][0], m[1][1], m[2][2]};
    if (same_bits(map, translation(move))) return append(block.key("translate"), move);
    const bool grows = factors.x > 0 && factors.y > 0 && factors.z > 0;
    if (grows && same_bits(map, scaling(factors))) {
        if (factors.x == factors.y && factors.x == factors.z) return append(block.key("scale"), factors.x);
        return append(block.key("scale"), factors);
    }
    std::string& text = block.key("matrix");
    text += '(';
    for (int r = 0; r < 3; ++r) {
        if (r > 0) {
            text += ", ";
            block.allow_break();
        }
        fmt::format_to(std::back_inserter(text), "({}, {}, {}, {})", m[r][0], m[r][1], m[r][2], m[r][3]);
    }
    text += ')';
}

}  // namespace glint
