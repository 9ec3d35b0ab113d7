// SPDX-License-Identifier: Apache-2.0
#pragma once
// A value that its copies share until one of them is modified.
#include <memory>
#include <utility>

namespace glint {

/// Whether `pointer` is the only owner, so that its value may be modified. Reads by other threads through
/// copies that no longer exist happen before the modification.
template <class T> bool is_sole_owner(const std::shared_ptr<T>& pointer) {
    if (pointer.use_count() != 1) return false;
    // use_count() does not synchronise with other threads. Creating and destroying a reference synchronises
    // with the threads that destroyed theirs before.
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
    [[maybe_unused]] const std::shared_ptr<T> pin = pointer;
    return true;
}

/// Copying costs one increment. Never empty; a moved-from object may only be assigned to.
template <class T> class CopyOnWrite {
  public:
    CopyOnWrite() : value_(std::make_shared<T>()) {}
    CopyOnWrite(T value) : value_(std::make_shared<T>(std::move(value))) {}  // intended conversion

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }
    bool is_shared() const { return !is_sole_owner(value_); }
    /// For modification: the shared value if there is no other owner, else a copy. Throws std::bad_alloc.
    T& own() {
        if (is_shared()) value_ = std::make_shared<T>(std::as_const(*value_));
        return *value_;
    }

  private:
    std::shared_ptr<T> value_;
};

}  // namespace glint
