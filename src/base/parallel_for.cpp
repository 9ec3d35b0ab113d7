#include "base/parallel_for.h"

#include <algorithm>
#include <optional>

#include "base/fp_environment.h"
#include "base/handover.h"
#if !defined(__wasm__)
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace glint {

#if defined(__wasm__)

int thread_count(int) { return 1; }

void parallel_for(std::size_t count, int, const std::function<void(std::size_t)>& body) {
    for (std::size_t i = 0; i < count; ++i) body(i);
}

void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b) {
    a();
    b();
}

void run_with_threads(int, const std::function<void()>& body) { body(); }

#else

namespace {

// More threads than processors: oneTBB would give fewer and print a warning.
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

template <class Body> void run_as_task(Handover& handover, const Body& body) {
    handover.task_starts();
    const DefaultFpEnvironment environment;
    body();
    handover.task_ends();
}

}  // namespace

int thread_count(int requested) {
    return requested > 0 ? std::min(requested, 1024) : std::max(1, oneapi::tbb::info::default_concurrency());
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    const int n = thread_count(threads);
    if (n == 1 || count <= 1) {
        const DefaultFpEnvironment environment;
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    const AllowThreads allow(n);
    oneapi::tbb::task_arena arena(n);
    Handover handover;
    arena.execute([&] {
        oneapi::tbb::parallel_for(
            oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
                run_as_task(handover, [&] {
                    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                });
            },
            oneapi::tbb::simple_partitioner{});
    });
    handover.all_ended();
}

void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b) {
    Handover handover;
    oneapi::tbb::parallel_invoke([&] { run_as_task(handover, a); }, [&] { run_as_task(handover, b); });
    handover.all_ended();
}

void run_with_threads(int threads, const std::function<void()>& body) {
    const AllowThreads allow(thread_count(threads));
    oneapi::tbb::task_arena arena(thread_count(threads));
    Handover handover;
    arena.execute([&] { run_as_task(handover, body); });
    handover.all_ended();
}

#endif

}  // namespace glint
