// SPDX-License-Identifier: Apache-2.0
#pragma once
// A value that its copies share until one of them is written to.
#include <memory>
#include <utility>

namespace glint {

/// Whether `pointer` is the only owner, so that what it points to may be written to. What other threads read
/// through copies that are gone by now happens before the write.
template <class T> bool is_sole_owner(const std::shared_ptr<T>& pointer) {
    if (pointer.use_count() != 1) return false;
    // use_count() synchronises with nobody; a reference that is taken and dropped does, with those that were
    // dropped before.
    [[maybe_unused]] const std::shared_ptr<T> pin = pointer;
    return true;
}

/// Copying one costs an increment. Never empty; one that was moved from may only be assigned to.
template <class T> class CopyOnWrite {
  public:
    CopyOnWrite() : value_(std::make_shared<T>()) {}
    CopyOnWrite(T value) : value_(std::make_shared<T>(std::move(value))) {}  // NOLINT: a value like any other

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }
    bool is_shared() const { return !is_sole_owner(value_); }
    /// For writing: the value itself if nobody shares it, else a copy of one's own. Throws std::bad_alloc.
    T& own() {
        if (is_shared()) value_ = std::make_shared<T>(std::as_const(*value_));
        return *value_;
    }

  private:
    std::shared_ptr<T> value_;
};

}  // namespace glint
