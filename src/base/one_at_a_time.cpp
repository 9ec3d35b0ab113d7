// SPDX-License-Identifier: Apache-2.0
#include "base/one_at_a_time.h"

#if !defined(GLINT_ONE_THREAD)
#include <mutex>
#endif

namespace glint {

#if defined(GLINT_ONE_THREAD)

struct OneAtATime::Lock {};
void OneAtATime::run(const std::function<void()>& body) { body(); }

#else

struct OneAtATime::Lock {
    std::mutex mutex;
};

void OneAtATime::run(const std::function<void()>& body) {
    const std::lock_guard lock(lock_->mutex);
    body();
}

#endif

OneAtATime::OneAtATime() : lock_(std::make_unique<Lock>()) {}
OneAtATime::~OneAtATime() = default;

}  // namespace glint
