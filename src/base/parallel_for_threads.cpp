// SPDX-License-Identifier: Apache-2.0
// Where there is no oneTBB: threads of the standard library, which wait for the next call.
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "base/fp_environment.h"
#include "base/parallel_for.h"
#include "base/status.h"

namespace glint {
namespace {

struct Call {
    const std::function<void(std::size_t)>& body;
    std::size_t count;
    std::atomic<std::size_t> next{0};
    int helpers = 0;  // threads besides the caller that work at it now

    void work() {
        const DefaultFpEnvironment environment;
        for (std::size_t i = next++; i < count; i = next++) body(i);
    }
};

class Pool {
  public:
    // The caller works as well, so a call in a call ends even if no thread is free.
    void run(Call& call, int helpers) {
        {
            const std::lock_guard lock(mutex_);
            wanted_.insert(wanted_.end(), static_cast<std::size_t>(helpers), &call);
            add_threads();
        }
        wake_.notify_all();
        call.work();
        std::unique_lock lock(mutex_);
        std::erase(wanted_, &call);
        ended_.wait(lock, [&] { return call.helpers == 0; });
    }

  private:
    // Without further threads the caller does more of the work.
    void add_threads() {
        const Status started = status_of([&] {
            for (; idle_ < wanted_.size(); ++idle_) std::thread([this] { serve(); }).detach();
        });
        static_cast<void>(started);
    }
    void serve() {
        std::unique_lock lock(mutex_);
        for (;;) {
            wake_.wait(lock, [&] { return !wanted_.empty(); });
            Call& call = *wanted_.front();
            wanted_.pop_front();
            ++call.helpers;
            --idle_;
            lock.unlock();
            call.work();
            lock.lock();
            ++idle_;
            if (--call.helpers == 0) ended_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_, ended_;
    std::deque<Call*> wanted_;  // one entry for each thread that a call has room for
    std::size_t idle_ = 0;      // threads that wait, or have just been started
};

// Never destroyed: its threads wait in it until the program ends.
Pool& pool() {
    static auto* const threads = new Pool;
    return *threads;
}

}  // namespace

int thread_count(int requested) {
    return requested > 0 ? std::min(requested, 1024)
                         : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    Call call{body, count};
    const auto helpers = std::min(static_cast<std::size_t>(thread_count(threads)), count);
    if (helpers <= 1) return call.work();
    pool().run(call, static_cast<int>(helpers) - 1);
}

}  // namespace glint
