// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs the library's long functions so that Python's other threads, Ctrl-C and progress go on meanwhile.
#include <atomic>
#include <functional>
#include <optional>
#include <utility>

#include "values.h"

namespace glint::python {

/// What a long function of the library is given.
struct Running {
    std::atomic<bool> cancel{false};
    std::atomic<double> fraction{0};
    std::function<void(double)> report() {
        return [this](double done) { fraction.store(done, std::memory_order_relaxed); };
    }
};

/// Calls body() on another thread, without the GIL, and waits for it. Python's signal handlers run meanwhile,
/// and `progress`, if it is not None, is called with the fraction done about 20 times a second, on the
/// calling thread. If either throws, `running` is cancelled, and the exception comes from here once body()
/// has returned.
void run_and_wait(Running& running, const py::object& progress, const std::function<void()>& body);

/// The same with a result: body(running) must not touch Python.
template <class Body> auto run(const py::object& progress, const Body& body) {
    Running running;
    std::optional<decltype(body(running))> result;
    run_and_wait(running, progress, [&] { result.emplace(body(running)); });
    return *std::move(result);
}

}  // namespace glint::python
