// SPDX-License-Identifier: Apache-2.0
#pragma once
// Serialises the caller's callbacks, which need not be thread-safe.
#include <functional>
#include <memory>

namespace glint {

/// Runs the bodies that several threads pass to run() one at a time, each on its caller's thread.
class OneAtATime {
  public:
    OneAtATime();
    ~OneAtATime();
    OneAtATime(const OneAtATime&) = delete;
    OneAtATime& operator=(const OneAtATime&) = delete;
    void run(const std::function<void()>& body);

  private:
    struct Lock;
    std::unique_ptr<Lock> lock_;
};

}  // namespace glint
