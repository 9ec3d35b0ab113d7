// SPDX-License-Identifier: Apache-2.0
#pragma once
// A table whose keys are lists of numbers.
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "base/memory_budget.h"
#include "math/number.h"

namespace glint {

/// Finds 32-bit values by n numbers, of which 0 and -0 are the same. No choice of numbers makes it slow: a
/// key is in a group of slots that its hash chooses or, if that is full, in an ordered map.
template <std::size_t n> class NumberTable {
  public:
    using Key = std::array<double, n>;

    /// Null: the key is not there. The result is valid until the next add().
    const std::uint32_t* find(const Key& key) const { return const_cast<NumberTable*>(this)->find(key); }
    std::uint32_t* find(const Key& key) {
        if (slots_.empty()) return nullptr;
        const std::uint32_t hash = hash_of(key);
        const Slot* group = &slots_[group_of(hash)];
        for (std::size_t i = 0; i < k_group && group[i].entry != 0; ++i) {
            if (group[i].hash != hash) continue;
            Entry& entry = at(group[i].entry - 1);
            if (!number::comes_before(key, entry.key) && !number::comes_before(entry.key, key))
                return &entry.value;
        }
        const auto found = crowded_.find(key);
        return found == crowded_.end() ? nullptr : &found->second;
    }

    /// The key must not be there.
    void add(const Key& key, std::uint32_t value) {
        if (2 * (count_ + 1) > slots_.size()) grow();
        if (!place({hash_of(key), static_cast<std::uint32_t>(count_ + 1)})) {
            crowded_.emplace(key, value);
            return;
        }
        if (count_ % k_block == 0) {
            blocks_.emplace_back();
            blocks_.back().reserve(k_block);
        }
        blocks_.back().push_back({key, value});
        ++count_;
    }

  private:
    static constexpr std::size_t k_group = 16, k_block = 128;
    struct Entry {
        Key key;
        std::uint32_t value;
    };
    struct Slot {
        std::uint32_t hash = 0, entry = 0;  // entry: from 1; 0: free, and so are those after it in the group
    };
    struct Order {
        bool operator()(const Key& a, const Key& b) const { return number::comes_before(a, b); }
    };

    static std::uint32_t hash_of(const Key& key) {
        std::uint64_t hash = 0;
        for (const double x : key) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        return static_cast<std::uint32_t>(hash);
    }
    Entry& at(std::size_t entry) { return blocks_[entry / k_block][entry % k_block]; }
    std::size_t group_of(std::uint32_t hash) const { return hash * k_group & (slots_.size() - 1); }

    /// False if the group is full.
    bool place(Slot slot) {
        Slot* group = &slots_[group_of(slot.hash)];
        for (std::size_t i = 0; i < k_group; ++i) {
            if (group[i].entry != 0) continue;
            group[i] = slot;
            return true;
        }
        return false;
    }

    void grow() {
        const CountedVector<Slot> old = std::move(slots_);
        slots_ = CountedVector<Slot>(old.empty() ? k_group : 2 * old.size());
        for (const Slot& slot : old) {
            if (slot.entry != 0) place(slot);  // a group becomes two: there is room
        }
    }

    CountedVector<CountedVector<Entry>> blocks_;
    std::size_t count_ = 0;      // in `blocks_`
    CountedVector<Slot> slots_;  // their number is a power of 2
    std::map<Key, std::uint32_t, Order, Counted<std::pair<const Key, std::uint32_t>>> crowded_;
};

}  // namespace glint
