// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <mutex>
#include <string>

namespace glint::cli {

/// Says on standard error how much is done and how long the rest will take: on a terminal by a line that is
/// written again and again, elsewhere (a log, a dumb terminal) by a new line every ten seconds; nothing if
/// the work is done before one would read it.
class ProgressBar {
  public:
    using Clock = std::chrono::steady_clock;

    /// `now`: the time, for tests.
    explicit ProgressBar(bool wanted, Clock::time_point (*now)() = Clock::now);
    ~ProgressBar();  // erases the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// From any thread: the fraction done, 0 to 1.
    void update(double fraction);

  private:
    const bool wanted_, redraws_;
    Clock::time_point (*const now_)();
    bool shown_ = false;
    double highest_ = 0;
    Clock::time_point start_, next_;
    std::mutex mutex_;
};

/// What the bar shows: "[######                  ]  25%  0:12 left", less of it where it would not fit into
/// `columns` characters, and at least "  25%".
std::string progress_text(double fraction, double seconds_so_far, int columns);

}  // namespace glint::cli
