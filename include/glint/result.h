// SPDX-License-Identifier: Apache-2.0
#pragma once
// What every function returns that can fail: a value or the reason why there is none.
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
    invalid_argument,  ///< an option, an index, a size or a picture that the function does not take
    invalid_scene,     ///< a number or an index of the scene; the diagnostics name each
    parse,             ///< a text or a file that breaks the rules of its format
    io,                ///< a text or a file that cannot be read
    cancelled,         ///< the caller set the option `cancel`
    out_of_memory,
    internal,  ///< an exception of another library; also a Result to which nothing was assigned
};

/// The code as a word: "invalid_argument". "unknown" for any other number.
GLINT_API std::string_view to_string(ErrorCode code);

/// How a call ended. Functions that return no value return this.
struct Status {
    ErrorCode code = ErrorCode::none;
    /// Why it failed, in one line without a newline; empty if it did not fail. With diagnostics it is the
    /// first error among them, with its place.
    std::string message;
    /// Errors, and also warnings and notes where the call succeeded. Failures that have no place in the input
    /// (invalid_argument, cancelled, out_of_memory) have a message only.
    std::vector<Diagnostic> diagnostics;

    bool ok() const { return code == ErrorCode::none; }
    explicit operator bool() const { return ok(); }
};

/// All diagnostics as text, then, if none of them is an error, "error: " and the message. Ends with a newline
/// unless there is nothing to say.
GLINT_API std::string to_string(const Status& status);

/// A Status, and the value if the call succeeded. Access is that of std::optional: operators * and -> need a
/// value; value() throws std::bad_optional_access if there is none. Of a Result that is a temporary, value()
/// and operator * give the value itself, so that `for (... : call().value())` is safe.
template <class T> struct [[nodiscard]] Result : Status {
    Result() : Status{ErrorCode::internal, {}, {}} {}
    Result(T value) : value_(std::move(value)) {}  // NOLINT: a value like any other
    /// With a Status that is no failure this is one nevertheless, of the code internal.
    Result(Status failure) : Status(std::move(failure)) {  // NOLINT: a failure like any other
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
