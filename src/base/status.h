// SPDX-License-Identifier: Apache-2.0
#pragma once
// How the library's own code makes Results. Exceptions of libraries and bad_alloc stop at the public
// functions. The browser build has no exceptions.
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

/// Of diagnostics that have an error: its place and message are the Status's.
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

/// What body() returns, a Status or a Result; or the exception that it threw as a failure, with `doing` after
/// its message: " while preparing the scene".
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

/// The same of a body that returns nothing.
template <class Body> Status status_of(Body&& body, const char* doing = "") {
    return result_of(
        [&] {
            body();
            return Status{};
        },
        doing);
}

}  // namespace glint
