// SPDX-License-Identifier: Apache-2.0
#include "run.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace glint::python {
namespace {

constexpr auto k_interval = std::chrono::milliseconds(50);

}  // namespace

void run_and_wait(Running& running, const py::object& progress, const std::function<void()>& body) {
    std::mutex mutex;
    std::condition_variable finished;
    bool done = false;
    std::exception_ptr failure, python_error;
    // A thread of its own, since signal handlers of Python run on the main thread only.
    std::thread worker([&] {
        try {
            body();
        } catch (...) {
            failure = std::current_exception();
        }
        const std::lock_guard lock(mutex);
        done = true;
        finished.notify_one();
    });
    const auto wait = [&](bool to_the_end) {
        const py::gil_scoped_release release;
        std::unique_lock lock(mutex);
        if (to_the_end) {
            finished.wait(lock, [&] { return done; });
            return true;
        }
        return finished.wait_for(lock, k_interval, [&] { return done; });
    };
    while (!wait(false)) {
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (!progress.is_none()) progress(running.fraction.load(std::memory_order_relaxed));
        } catch (...) {
            python_error = std::current_exception();
            running.cancel = true;
            wait(true);
            break;
        }
    }
    worker.join();
    if (python_error) std::rethrow_exception(python_error);
    if (failure) std::rethrow_exception(failure);
    if (!progress.is_none()) progress(1.0);
}

}  // namespace glint::python
