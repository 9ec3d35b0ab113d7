// SPDX-License-Identifier: Apache-2.0
#include "base/handover.h"

namespace glint {

#if defined(__SANITIZE_THREAD__)
Handover::Handover() { started_.store(1, std::memory_order_release); }
void Handover::task_starts() { started_.load(std::memory_order_acquire); }
void Handover::task_ends() { ended_.fetch_add(1, std::memory_order_release); }
void Handover::all_ended() { ended_.load(std::memory_order_acquire); }
#else
Handover::Handover() = default;
void Handover::task_starts() {}
void Handover::task_ends() {}
void Handover::all_ended() {}
#endif

}  // namespace glint
