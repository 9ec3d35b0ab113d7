// SPDX-License-Identifier: Apache-2.0
#pragma once
// The keys by which .glint gives the fields of an item.
#include <initializer_list>
#include <span>
#include <vector>

#include "formats/glint_text.h"

namespace glint {

/// Keys of a block's own, then those of the fields: a field's other key comes right after its first.
template <class Item> class FieldKeys {
  public:
    FieldKeys(std::initializer_list<Field> own, std::span<const ItemField<Item>> fields)
        : keys_(own), fields_(own.size(), nullptr) {
        for (const ItemField<Item>& field : fields) {
            add(field.key, field);
            if (!field.other_key.empty()) add(field.other_key, field);
        }
    }

    std::span<const Field> all() const { return keys_; }
    /// The field of a key, or nullptr if the key is one of the block's own.
    const ItemField<Item>* field(int key) const { return fields_[static_cast<std::size_t>(key)]; }
    /// The first key of a member's field.
    template <class Value> int key_of(Value Item::*member) const {
        std::size_t key = 0;
        while (fields_[key] == nullptr || !is_field_of(*fields_[key], member)) ++key;
        return static_cast<int>(key);
    }
    /// Whether the text gives a field, by any of its keys.
    bool is_given(const FieldSet& set, const ItemField<Item>& field) const {
        for (std::size_t key = 0; key < fields_.size(); ++key) {
            if (fields_[key] == &field && set.has(static_cast<int>(key))) return true;
        }
        return false;
    }

  private:
    void add(std::string_view key, const ItemField<Item>& field) {
        keys_.push_back({key});
        fields_.push_back(&field);
    }

    std::vector<Field> keys_;
    std::vector<const ItemField<Item>*> fields_;  // by key
};

}  // namespace glint
