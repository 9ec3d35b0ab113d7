// SPDX-License-Identifier: Apache-2.0
#pragma once
// The layout of .glint: word "name" { key = value  key = value }, in one line where it fits.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/fields.h"

namespace glint {

/// The shortest text that reads back as the same double, a negative zero included.
void append(std::string& out, double number);
void append(std::string& out, std::int32_t value);
void append(std::string& out, std::uint32_t value);
void append(std::string& out, bool value);
/// (x, y, z)
void append(std::string& out, Vec3 v);
/// (r, g, b), or rgb255(r, g, b) if it is shorter and exact.
void append(std::string& out, Color c);
/// The same; the numbers have the digits of single precision.
void append(std::string& out, const ShapeColor& c);
/// (c0, c1, c2)
void append(std::string& out, const Attenuation& a);
/// ((a, b, c), (d, e, f))
void append(std::string& out, const UvMap& map);
/// "text" with the escapes that the tokenizer reads.
void append_quoted(std::string& out, std::string_view text);
/// The name as a bare word if it is one, else quoted.
void append_name(std::string& out, std::string_view name);

class BlockWriter {
  public:
    explicit BlockWriter(std::string& out) : out_(out) {}

    /// From now on, each block is written on one line.
    void keep_lines_whole() { one_line_ = true; }

    /// Begins a block. head: the text before its `{`, padded to `width`; empty: keys without a block.
    void begin(std::string_view head, std::size_t width = 0);
    /// Begins `word "name" {`, or `word {` if the name is empty.
    void begin(std::string_view word, std::string_view name, std::size_t width = 0);
    /// Begins `key = ` and returns the text that the value is appended to.
    std::string& key(std::string_view name);
    /// Allows a line break here, within a value.
    void allow_break() { breaks_.push_back({line_.size(), Where::value}); }
    /// The next key starts a new line if the block needs several lines.
    void begin_part() { part_begins_ = true; }
    /// Ends the block. above: comments before it; after: comments on its last line, or before it if they do
    /// not fit.
    void end(std::span<const std::string_view> above = {}, std::span<const std::string_view> after = {});

    /// `head {`, and `}`: a block of blocks.
    void open(std::string_view head);
    void close();

    /// Writes comments, one per line.
    void comments(std::span<const std::string_view> lines);

  private:
    enum class Where : std::uint8_t { key, part, value };
    struct Break {
        std::size_t at;
        Where where;
    };
    void append_filled(std::size_t indent);

    std::string& out_;
    bool one_line_ = false;
    bool part_begins_ = false;
    std::size_t indent_ = 0;
    std::string head_, line_, after_;
    std::vector<Break> breaks_;
};

/// Writes the key and the value of a field, unless the value is absent.
template <class Item> void write_field(BlockWriter& block, const ItemField<Item>& field, const Item& item) {
    visit_field(field, item, [&](const auto& type, const auto& value) {
        if constexpr (requires { type.words; }) {
            block.key(field.key) += type.words[static_cast<std::size_t>(value)];
        } else {
            append(block.key(field.key), value);
        }
    });
}

/// True if two maps have the same bits.
bool same_bits(const Affine& a, const Affine& b);

/// Writes a map as `translate`, `scale` or `matrix`.
void write_map(BlockWriter& block, const Affine& map);

}  // namespace glint
