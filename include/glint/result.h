// SPDX-License-Identifier: Apache-2.0
#pragma once
// The return types of functions that can fail: a value, or the reason of the failure.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glint/diagnostic.h"
#include "glint/export.h"

namespace glint {

/// Why a call failed.
enum class ErrorCode : std::uint8_t {
    none,              ///< it did not fail
    invalid_argument,  ///< an invalid option, index, size or picture
    invalid_scene,     ///< an invalid number or index in the scene; the diagnostics name each
    parse,             ///< a text or a file that violates its format
    io,                ///< a text or a file that cannot be read
    cancelled,         ///< the caller set the option `cancel`
    out_of_memory,
    internal,  ///< an exception of another library, or a Result to which nothing was assigned
};

/// The code as a word: "invalid_argument". "unknown" for any other number.
GLINT_API std::string_view to_string(ErrorCode code);

/// The outcome of a call. Functions without a value return this.
struct Status {
    ErrorCode code = ErrorCode::none;
    /// The reason of the failure, in one line without a newline; empty for success. With diagnostics, it is
    /// the first error among them, with its place.
    std::string message;
    /// Errors, warnings and notes; a successful call may have warnings and notes. Failures without a place in
    /// the input (invalid_argument, cancelled, out_of_memory but for a budget of load()) have a message only.
    std::vector<Diagnostic> diagnostics;

    bool ok() const { return code == ErrorCode::none; }
    explicit operator bool() const { return ok(); }
};

/// All diagnostics as text, then, if none of them is an error, "error: " and the message. Ends with a newline
/// unless there is nothing to say.
GLINT_API std::string to_string(const Status& status);

/// A Status, and the value of a successful call. Access is as for std::optional: operators * and -> require a
/// value; value() throws std::bad_optional_access if there is none. For a temporary Result, value() and
/// operator * return the value itself instead of a reference, so that `for (... : call().value())` is safe.
template <class T> struct [[nodiscard]] Result : Status {
    Result() : Status{ErrorCode::internal, {}, {}} {}
    Result(T value) : value_(std::move(value)) {}  // NOLINT: intended conversion
    /// If the Status is not a failure, the Result is one nevertheless, with the code internal.
    Result(Status failure) : Status(std::move(failure)) {  // NOLINT: intended conversion
        if (code == ErrorCode::none) code = ErrorCode::internal;
    }
    Result(T value, std::vector<Diagnostic> warnings)
        : Status{ErrorCode::none, {}, std::move(warnings)}, value_(std::move(value)) {}

    bool has_value() const { return value_.has_value(); }
    explicit operator bool() const { return has_value(); }

    T& value() & { return value_.value(); }
    const T& value() const& { return value_.value(); }
    T value() && { return std::move(value_).value(); }
    T& operator*() & { return *value_; }
    const T& operator*() const& { return *value_; }
    T operator*() && { return *std::move(value_); }
    T* operator->() { return &*value_; }
    const T* operator->() const { return &*value_; }
    T value_or(T other) const& { return value_.value_or(std::move(other)); }
    T value_or(T other) && { return std::move(value_).value_or(std::move(other)); }

  private:
    std::optional<T> value_;
};

}  // namespace glint
