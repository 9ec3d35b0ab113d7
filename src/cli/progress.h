// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <mutex>
#include <string>

namespace glint::cli {

/// Prints on standard error how much is done and how long the rest will take. A terminal shows one line that
/// is updated; elsewhere (a log, a dumb terminal) a new line is printed every ten seconds. Short work prints
/// nothing.
class ProgressBar {
  public:
    using Clock = std::chrono::steady_clock;

    /// `now`: the clock; tests pass their own.
    explicit ProgressBar(bool wanted, Clock::time_point (*now)() = Clock::now);
    ~ProgressBar();  // erases the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Sets the fraction done, 0 to 1. Any thread may call it.
    void update(double fraction);

  private:
    const bool wanted_, redraws_;
    Clock::time_point (*const now_)();
    bool shown_ = false;
    double highest_ = 0;
    Clock::time_point start_, next_;
    std::mutex mutex_;
};

/// The text of the bar: "[######                  ]  25%  0:12 left". It is shortened to fit into `columns`
/// characters, down to "  25%".
std::string progress_text(double fraction, double seconds_so_far, int columns);

}  // namespace glint::cli
