// SPDX-License-Identifier: Apache-2.0
#pragma once
// The memory that one task may hold, and the containers that count theirs.
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace glint {

/// Counts the bytes that a task holds. While it exists, the Counted containers of its thread count in it, so
/// they must be destroyed before it. Not for more than one thread. Nothing is refused here: the task asks at
/// intervals whether the limit is exceeded.
class MemoryBudget {
  public:
    explicit MemoryBudget(std::uint64_t limit) : limit_(limit), outer_(t_current) { t_current = this; }
    ~MemoryBudget() { t_current = outer_; }
    MemoryBudget(const MemoryBudget&) = delete;
    MemoryBudget& operator=(const MemoryBudget&) = delete;

    std::uint64_t limit() const { return limit_; }
    void set_limit(std::uint64_t limit) { limit_ = limit; }
    void add(std::uint64_t bytes) {
        used_ += bytes;
        if (used_ > limit_) is_exceeded_ = true;
    }
    void remove(std::uint64_t bytes) { used_ -= bytes; }
    bool has_room(std::uint64_t bytes) const { return bytes <= limit_ && used_ <= limit_ - bytes; }
    /// The bytes that may be added, at least 1.
    std::uint64_t room() const { return used_ < limit_ ? limit_ - used_ : 1; }
    /// True from the first time that more than the limit was held.
    bool is_exceeded() const { return is_exceeded_; }

    /// What `n` items of a list count. Lists grow by copying: half of their size is added, so that what is
    /// held while one is copied stays below twice the limit. A block's own overhead is 16 bytes.
    static std::uint64_t list_bytes(std::uint64_t n, std::uint64_t item_size) {
        return n * item_size + (n > 1 ? n * item_size / 2 : 0) + 16;
    }
    /// The innermost budget of this thread, or null.
    static MemoryBudget* current() { return t_current; }

  private:
    std::uint64_t limit_, used_ = 0;
    bool is_exceeded_ = false;
    MemoryBudget* outer_;
    static inline constinit thread_local MemoryBudget* t_current = nullptr;
};

/// The allocator of containers that count in the current budget.
template <class T> struct Counted {
    using value_type = T;
    Counted() = default;
    template <class Other> Counted(const Counted<Other>&) {}  // NOLINT: as allocators must
    T* allocate(std::size_t n) {
        T* const memory = std::allocator<T>().allocate(n);
        if (MemoryBudget* budget = MemoryBudget::current()) budget->add(bytes_of(n));
        return memory;
    }
    void deallocate(T* memory, std::size_t n) {
        if (MemoryBudget* budget = MemoryBudget::current()) budget->remove(bytes_of(n));
        std::allocator<T>().deallocate(memory, n);
    }
    static std::uint64_t bytes_of(std::size_t n) {
        // NOLINTNEXTLINE(bugprone-sizeof-expression): T may be a pointer
        return MemoryBudget::list_bytes(n, sizeof(T));
    }
    friend bool operator==(const Counted&, const Counted&) { return true; }
};

template <class T> using CountedVector = std::vector<T, Counted<T>>;
template <class Key, class T>
using CountedMap = std::map<Key, T, std::less<>, Counted<std::pair<const Key, T>>>;
template <class Key, class T, class Hash = std::hash<Key>>
using CountedHashMap = std::unordered_map<Key, T, Hash, std::equal_to<Key>, Counted<std::pair<const Key, T>>>;
using CountedString = std::basic_string<char, std::char_traits<char>, Counted<char>>;

/// A shared value that counts.
template <class T, class... Arguments> std::shared_ptr<T> make_counted(Arguments&&... arguments) {
    return std::allocate_shared<T>(Counted<T>(), std::forward<Arguments>(arguments)...);
}

}  // namespace glint
