// SPDX-License-Identifier: Apache-2.0
#pragma once
// Callers' functions and flags in options. The standard headers for them, <functional> and <atomic>, would
// take every file that includes glint as long as all else that it includes.
#include <cstddef>
#include <type_traits>
#include <utility>

namespace glint {

template <class Signature> class Function;

/// Holds any callable object that can be copied, as std::function does, or nothing. A lambda, a function
/// pointer or a std::function can be assigned.
template <class R, class... Args> class Function<R(Args...)> {
    template <class F>
    static constexpr bool is_other =
        !std::is_same_v<std::decay_t<F>, Function> && std::is_invocable_r_v<R, std::decay_t<F>&, Args...>;

  public:
    Function() = default;
    Function(std::nullptr_t) {}  // NOLINT: intended conversion
    template <class F, std::enable_if_t<is_other<F>, int> = 0>
    Function(F&& callable) {  // NOLINT: intended conversion
        using Held = std::decay_t<F>;
        Held held(std::forward<F>(callable));
        if constexpr (std::is_constructible_v<Held, std::nullptr_t> && std::is_constructible_v<bool, Held&>) {
            if (!static_cast<bool>(held)) return;  // a pointer or a std::function that holds nothing
        }
        object_ = new Held(std::move(held));
        use_ = &use<Held>;
        call_ = &call<Held>;
    }
    Function(const Function& other) : use_(other.use_), call_(other.call_) {
        if (other.object_ != nullptr) object_ = use_(other.object_, true);
    }
    Function(Function&& other) noexcept { swap(other); }
    Function& operator=(Function other) noexcept {
        swap(other);
        return *this;
    }
    ~Function() {
        if (object_ != nullptr) use_(object_, false);
    }

    explicit operator bool() const { return object_ != nullptr; }
    /// Calls what it holds. It must hold something.
    R operator()(Args... args) const { return call_(object_, std::forward<Args>(args)...); }

  private:
    // Copies the object, or deletes it.
    template <class Held> static void* use(void* object, bool is_copied) {
        if (is_copied) return new Held(*static_cast<Held*>(object));
        delete static_cast<Held*>(object);
        return nullptr;
    }
    template <class Held> static R call(void* object, Args... args) {
        return static_cast<R>((*static_cast<Held*>(object))(std::forward<Args>(args)...));
    }
    void swap(Function& other) noexcept {
        std::swap(object_, other.object_);
        std::swap(use_, other.use_);
        std::swap(call_, other.call_);
    }

    void* object_ = nullptr;
    void* (*use_)(void*, bool) = nullptr;
    R (*call_)(void*, Args...) = nullptr;
};

/// Refers to a std::atomic<bool> of the caller, whose value ends a call that has begun; or to nothing. The
/// flag must outlive the call.
class CancelFlag {
  public:
    constexpr CancelFlag(std::nullptr_t = nullptr) {}  // NOLINT: intended conversion
    template <class Flag>
    constexpr CancelFlag(const Flag* flag)  // NOLINT: intended conversion
        : flag_(flag), load_([](const void* f) -> bool { return static_cast<const Flag*>(f)->load(); }) {}

    /// Whether there is a flag, and its value is true.
    bool is_set() const { return flag_ != nullptr && load_(flag_); }
    friend constexpr bool operator==(const CancelFlag& flag, std::nullptr_t) { return flag.flag_ == nullptr; }

  private:
    const void* flag_ = nullptr;
    bool (*load_)(const void*) = nullptr;
};

}  // namespace glint
