// SPDX-License-Identifier: Apache-2.0
#pragma once
// The names of a list of items, of which most have none.
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "glint/export.h"

namespace glint {

/// Names by the index of their item, in the order of the indices. A name for a larger index than all others
/// takes constant time; one before others, time proportional to their number.
class ItemNames {
  public:
    using value_type = std::pair<std::uint32_t, std::string>;
    using const_iterator = std::vector<value_type>::const_iterator;

    ItemNames() = default;
    /// Of several names for one index, the first counts.
    GLINT_API ItemNames(std::initializer_list<value_type> names);

    std::size_t size() const { return names_.size(); }
    bool empty() const { return names_.empty(); }
    const_iterator begin() const { return names_.begin(); }
    const_iterator end() const { return names_.end(); }
    void clear() { names_.clear(); }

    /// The entry with this index; end() if there is none.
    GLINT_API const_iterator find(std::uint32_t index) const;
    /// Adds a name, unless the item has one.
    GLINT_API void emplace(std::uint32_t index, std::string name);
    /// The item's name, which is added, empty, if there is none.
    GLINT_API std::string& operator[](std::uint32_t index);
    GLINT_API void erase(std::uint32_t index);

  private:
    std::vector<value_type> names_;
};

}  // namespace glint
