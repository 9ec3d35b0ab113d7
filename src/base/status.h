// SPDX-License-Identifier: Apache-2.0
#pragma once
// Makes the Results of the library's functions. Exceptions of other libraries and bad_alloc are caught here.
// The browser build has no exceptions.
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "glint/result.h"

namespace glint {

inline Status failure(ErrorCode code, std::string message) { return {code, std::move(message), {}}; }
inline Status invalid_argument(std::string message) {
    return failure(ErrorCode::invalid_argument, std::move(message));
}
inline Status cancelled() { return failure(ErrorCode::cancelled, "cancelled"); }

/// The Status of diagnostics with an error. Its message is that of the first error, with its place.
Status failure(ErrorCode code, std::vector<Diagnostic> diagnostics);
inline Status invalid_scene(std::vector<Diagnostic> diagnostics) {
    return failure(ErrorCode::invalid_scene, std::move(diagnostics));
}

/// Ends result_of()'s body from within, where a Status cannot be returned.
class StatusError : public std::exception {
  public:
    explicit StatusError(Status status) : status_(std::move(status)) {}
    const char* what() const noexcept override { return status_.message.c_str(); }
    const Status& status() const { return status_; }

  private:
    Status status_;
};

/// Returns the result of body(), a Status or a Result. An exception becomes a failure. doing: appended to its
/// message, " while preparing the scene".
template <class Body>
auto result_of(Body&& body, [[maybe_unused]] const char* doing = "") -> decltype(body()) {
#if defined(__cpp_exceptions)
    const auto failed = [doing](ErrorCode code, std::string message) {
        try {
            message += doing;
        } catch (const std::bad_alloc&) {  // the message is shorter then
        }
        return failure(code, std::move(message));
    };
    try {
        return body();
    } catch (const std::bad_alloc&) {
        return failed(ErrorCode::out_of_memory, "out of memory");
    } catch (const StatusError& e) {
        return e.status();
    } catch (const std::exception& e) {
        return failed(ErrorCode::internal, e.what());
    } catch (...) {
        return failed(ErrorCode::internal, "unknown failure");
    }
#else
    return body();
#endif
}

/// The same for a body without a return value.
template <class Body> Status status_of(Body&& body, const char* doing = "") {
    return result_of(
        [&] {
            body();
            return Status{};
        },
        doing);
}

}  // namespace glint
