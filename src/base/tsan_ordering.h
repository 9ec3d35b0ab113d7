// SPDX-License-Identifier: Apache-2.0
#pragma once
// oneTBB is not compiled with the thread sanitizer, which cannot see in it that a task starts after its
// caller and ends before the caller goes on. Under that sanitizer, and only there, a TsanOrdering says so
// with atomics of its own.
#include <atomic>

namespace glint {

/// Compiled with the sanitizer, where parallel_for.cpp is not: what oneTBB's headers do belongs to oneTBB.
class TsanOrdering {
  public:
    TsanOrdering();
    void task_starts();
    void task_ends();
    void all_ended();

  private:
    std::atomic<int> started_{0}, ended_{0};
};

}  // namespace glint
