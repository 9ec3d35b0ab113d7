// SPDX-License-Identifier: Apache-2.0
#include "base/one_at_a_time.h"

#if !defined(__wasm__)
#include <oneapi/tbb/mutex.h>
#endif

namespace glint {

#if defined(__wasm__)

struct OneAtATime::Lock {};
void OneAtATime::run(const std::function<void()>& body) { body(); }

#else

struct OneAtATime::Lock {
    oneapi::tbb::mutex mutex;
};

void OneAtATime::run(const std::function<void()>& body) {
    const oneapi::tbb::mutex::scoped_lock lock(lock_->mutex);
    body();
}

#endif

OneAtATime::OneAtATime() : lock_(std::make_unique<Lock>()) {}
OneAtATime::~OneAtATime() = default;

}  // namespace glint
