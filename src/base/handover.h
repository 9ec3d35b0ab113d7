#pragma once
// oneTBB is not compiled with the thread sanitizer, which cannot see in it that a task starts after its
// caller and ends before the caller goes on. Under that sanitizer, and only there, a Handover says so with
// atomics of its own.
#include <atomic>

namespace glint {

class Handover {
#if defined(__SANITIZE_THREAD__)
  public:
    void task_starts() { started_.load(std::memory_order_acquire); }
    void task_ends() { ended_.fetch_add(1, std::memory_order_release); }
    void all_ended() { ended_.load(std::memory_order_acquire); }
    Handover() { started_.store(1, std::memory_order_release); }

  private:
    std::atomic<int> started_{0}, ended_{0};
#else
  public:
    void task_starts() {}
    void task_ends() {}
    void all_ended() {}
#endif
};

}  // namespace glint
