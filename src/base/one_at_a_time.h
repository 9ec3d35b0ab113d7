// SPDX-License-Identifier: Apache-2.0
#pragma once
// The caller's callbacks, which need not be ready for two threads at once.
#include <functional>
#include <memory>

namespace glint {

/// Runs bodies that several threads hand to it one after the other, each on the thread that brings it.
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
