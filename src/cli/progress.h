#pragma once
#include <chrono>
#include <mutex>
#include <string>

namespace glint::cli {

/// A line on standard error that says how much is done and how long the rest will take; nothing if standard
/// error is no terminal, or the work is done before one would read it.
class ProgressBar {
  public:
    explicit ProgressBar(bool wanted);
    ~ProgressBar();  // erases the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// From any thread: the fraction done, 0 to 1.
    void update(double fraction);

  private:
    using Clock = std::chrono::steady_clock;
    const bool wanted_;
    bool shown_ = false;
    double highest_ = 0;
    Clock::time_point start_ = Clock::now(), next_ = start_ + std::chrono::milliseconds(300);
    std::mutex mutex_;
};

/// What the bar shows: "[######                  ]  25%  0:12 left".
std::string progress_text(double fraction, double seconds_so_far);

}  // namespace glint::cli
