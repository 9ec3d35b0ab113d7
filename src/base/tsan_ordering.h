// SPDX-License-Identifier: Apache-2.0
#pragma once
// oneTBB is not compiled with the thread sanitizer. The sanitizer therefore does not know that a task starts
// after its caller and ends before the caller continues. In builds with that sanitizer, TsanOrdering states
// this order by its own atomic operations.
#include <atomic>

namespace glint {

/// This class is compiled with the sanitizer; parallel_for.cpp is not, because it contains oneTBB's headers.
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
