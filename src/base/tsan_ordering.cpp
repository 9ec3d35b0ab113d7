// SPDX-License-Identifier: Apache-2.0
#include "base/tsan_ordering.h"

namespace glint {

#if defined(__SANITIZE_THREAD__)
TsanOrdering::TsanOrdering() { started_.store(1, std::memory_order_release); }
void TsanOrdering::task_starts() { started_.load(std::memory_order_acquire); }
void TsanOrdering::task_ends() { ended_.fetch_add(1, std::memory_order_release); }
void TsanOrdering::all_ended() { ended_.load(std::memory_order_acquire); }
#else
TsanOrdering::TsanOrdering() = default;
void TsanOrdering::task_starts() {}
void TsanOrdering::task_ends() {}
void TsanOrdering::all_ended() {}
#endif

}  // namespace glint
