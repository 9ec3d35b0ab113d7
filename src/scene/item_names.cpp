// SPDX-License-Identifier: Apache-2.0
#include "glint/item_names.h"

#include <algorithm>

namespace glint {
namespace {

// The first entry whose index is not less; `names` is const or not.
template <class Names> auto place_of(Names& names, std::uint32_t index) {
    if (names.empty() || names.back().first < index) return names.end();
    return std::lower_bound(names.begin(), names.end(), index,
                            [](const auto& entry, std::uint32_t i) { return entry.first < i; });
}

}  // namespace

ItemNames::ItemNames(std::initializer_list<value_type> names) {
    for (const auto& [index, name] : names) emplace(index, name);
}

ItemNames::const_iterator ItemNames::find(std::uint32_t index) const {
    const auto at = place_of(names_, index);
    return at != end() && at->first == index ? at : end();
}

void ItemNames::emplace(std::uint32_t index, std::string name) {
    const auto at = place_of(names_, index);
    if (at == names_.end() || at->first != index) names_.emplace(at, index, std::move(name));
}

std::string& ItemNames::operator[](std::uint32_t index) {
    auto at = place_of(names_, index);
    if (at == names_.end() || at->first != index) at = names_.emplace(at, index, std::string());
    return at->second;
}

void ItemNames::erase(std::uint32_t index) {
    const auto at = find(index);
    if (at != end()) names_.erase(at);
}

}  // namespace glint
