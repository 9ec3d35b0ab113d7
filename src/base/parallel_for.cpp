// SPDX-License-Identifier: Apache-2.0
#include "base/parallel_for.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/mutex.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/fp_environment.h"
#include "base/status.h"
#include "base/tsan_ordering.h"

namespace glint {

namespace {

// Allows more threads than processors; oneTBB would otherwise use fewer and print a warning.
class AllowThreads {
  public:
    explicit AllowThreads(int threads) {
        using oneapi::tbb::global_control;
        if (threads > oneapi::tbb::info::default_concurrency()) {
            control_.emplace(global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
        }
    }

  private:
    std::optional<oneapi::tbb::global_control> control_;
};

using Arena = oneapi::tbb::task_arena;
using ArenaPtr = std::unique_ptr<Arena>;

// Arenas of finished calls, for reuse: oneTBB 2021.8 does not free every arena that is destroyed (its issue
// 967), so that memory would grow by some kilobytes with each call that creates one.
class IdleArenas {
  public:
    ArenaPtr take(int threads) {
        const Mutex::scoped_lock lock(mutex_);
        const auto found = std::find_if(idle_.rbegin(), idle_.rend(),
                                        [&](const auto& a) { return a->max_concurrency() == threads; });
        if (found == idle_.rend()) return std::make_unique<Arena>(threads);
        ArenaPtr arena = std::move(*found);
        idle_.erase(std::next(found).base());
        slots_ -= threads;
        return arena;
    }
    void put_back(ArenaPtr arena) {
        const Mutex::scoped_lock lock(mutex_);
        idle_.push_back(std::move(arena));
        slots_ += idle_.back()->max_concurrency();
        while (slots_ > k_max_slots) {
            slots_ -= idle_.front()->max_concurrency();
            idle_.erase(idle_.begin());
        }
    }

  private:
    using Mutex = oneapi::tbb::mutex;
    static constexpr int k_max_slots = 4096;  // a few kilobytes each

    Mutex mutex_;
    std::vector<ArenaPtr> idle_;  // the most recently used is last
    int slots_ = 0;
};

// Never destroyed: oneTBB may be unloaded before the destructor would run.
IdleArenas& idle_arenas() {
    static auto* const arenas = new IdleArenas;
    return *arenas;
}

// An arena for a single call: a thread that waits in it does not take up work of other calls.
class LentArena {
  public:
    explicit LentArena(int threads) : arena_(idle_arenas().take(threads)) {}
    ~LentArena() {
        status_of([&] {
            idle_arenas().put_back(std::move(arena_));
        });  // without memory to keep it, it is destroyed
    }
    LentArena(const LentArena&) = delete;
    LentArena& operator=(const LentArena&) = delete;
    Arena* operator->() { return arena_.get(); }

  private:
    ArenaPtr arena_;
};

template <class Body> void run_as_task(TsanOrdering& ordering, const Body& body) {
    ordering.task_starts();
    const DefaultFpEnvironment environment;
    body();
    ordering.task_ends();
}

}  // namespace

int thread_count(int requested) {
    // In a task_arena of the caller, its number; elsewhere the number of processors.
    return requested > 0 ? std::min(requested, 1024)
                         : std::max(1, oneapi::tbb::this_task_arena::max_concurrency());
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    const int n = thread_count(threads);
    if (n == 1 || count <= 1) {
        const DefaultFpEnvironment environment;
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    const AllowThreads allow(n);
    LentArena arena(n);
    TsanOrdering ordering;
    arena->execute([&] {
        oneapi::tbb::parallel_for(
            oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
                run_as_task(ordering, [&] {
                    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                });
            },
            oneapi::tbb::simple_partitioner{});
    });
    ordering.all_ended();
}

}  // namespace glint
