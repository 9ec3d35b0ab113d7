// SPDX-License-Identifier: Apache-2.0
#pragma once
// Exceptions of libraries and bad_alloc stop at the public functions. The browser build has no exceptions.
#include <exception>
#include <new>
#include <string>

namespace glint {

/// Runs body(); returns an empty string, or what went wrong if it threw.
template <class Body> std::string catch_exceptions(Body&& body) {
#if defined(__cpp_exceptions)
    try {
        body();
        return {};
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const std::exception& e) {
        return e.what();
    } catch (...) {
        return "unknown failure";
    }
#else
    body();
    return {};
#endif
}

}  // namespace glint
