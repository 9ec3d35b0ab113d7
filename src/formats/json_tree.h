// SPDX-License-Identifier: Apache-2.0
#pragma once
// A text of JSON as a tree of values that keep their places, for formats whose parts refer to one another.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/memory_budget.h"

namespace glint {

class JsonTree;

enum class JsonKind : std::uint8_t { null, boolean, number, string, list, object };

/// A value of a tree, which must outlive it, or none.
class JsonValue {
  public:
    JsonValue() = default;
    JsonValue(const JsonTree& tree, std::uint32_t node) : tree_(&tree), node_(node) {}

    bool exists() const { return tree_ != nullptr; }
    bool is(JsonKind kind) const;
    double number() const;  ///< of a number; of a boolean, 0 or 1
    std::string_view text() const;
    std::string string() const;  ///< of a string, decoded
    /// What a message says was found: "'1.5'", "a list".
    std::string description() const;
    std::size_t offset() const;
    std::size_t length() const;  ///< of its text in bytes; of lists and objects, of their bracket
    std::uint32_t line() const;
    std::uint32_t column() const;

    /// The number of elements or members.
    std::uint32_t size() const;
    /// The value of a member; none, if this is no object or has no such member.
    JsonValue find(std::string_view key) const;
    /// Visits the elements of a list: visit(value). Nothing of other values.
    template <class Visit> void for_each(Visit&& visit) const;
    /// Visits the members of an object: visit(key, value).
    template <class Visit> void for_each_member(Visit&& visit) const;

    friend bool operator==(const JsonValue&, const JsonValue&) = default;

  private:
    const JsonTree* tree_ = nullptr;
    std::uint32_t node_ = 0;
};

class JsonTree {
  public:
    struct Node {
        JsonKind kind = JsonKind::null;
        std::uint32_t line = 1, column = 1;
        std::uint32_t count = 0;  ///< of elements or members
        std::uint32_t end = 0;    ///< the node after this value and all that is in it
        std::size_t offset = 0, length = 0;
        double number = 0;
    };

    explicit JsonTree(InputText where) : where_(where) {}
    JsonValue root() const { return {*this, 0}; }
    InputText where() const { return where_; }
    const Node& node(std::uint32_t index) const { return nodes_[index]; }

  private:
    friend class JsonReader;
    InputText where_;
    CountedVector<Node> nodes_;  // a value is followed by its elements, or its keys and values in turn
};

/// Reads the part of a text from `offset` as one value. Nothing after an error: brackets that do not match,
/// words that JSON does not have, or brackets that are nested more than k_max_nesting deep.
std::optional<JsonTree> read_json(Diagnostics& diagnostics, InputText where, std::size_t offset,
                                  std::size_t length);

inline bool JsonValue::is(JsonKind kind) const { return exists() && tree_->node(node_).kind == kind; }

template <class Visit> void JsonValue::for_each(Visit&& visit) const {
    if (!is(JsonKind::list)) return;
    const std::uint32_t end = tree_->node(node_).end;
    for (std::uint32_t i = node_ + 1; i < end; i = tree_->node(i).end) visit(JsonValue(*tree_, i));
}

template <class Visit> void JsonValue::for_each_member(Visit&& visit) const {
    if (!is(JsonKind::object)) return;
    const std::uint32_t end = tree_->node(node_).end;
    for (std::uint32_t i = node_ + 1; i < end; i = tree_->node(i + 1).end)
        visit(JsonValue(*tree_, i), JsonValue(*tree_, i + 1));
}

}  // namespace glint
