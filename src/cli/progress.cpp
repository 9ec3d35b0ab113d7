// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/interrupt.h"
#include "cli/print_error.h"
#include "os/files.h"
#include "os/process.h"

namespace glint::cli {

namespace {

constexpr auto k_first_bar = std::chrono::milliseconds(300), k_next_bar = std::chrono::milliseconds(100);
constexpr auto k_next_line = std::chrono::seconds(10);

// "  0:12 left"; empty while there is no estimate.
std::string time_left(double fraction, double seconds_so_far) {
    if (fraction <= 0.005) return {};
    const long seconds = std::lround(std::min(seconds_so_far * (1 - fraction) / fraction, 3.6e6));
    if (seconds < 3600) return fmt::format("  {}:{:02} left", seconds / 60, seconds % 60);
    return fmt::format("  {}:{:02}:{:02} left", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

}  // namespace

ProgressBar::ProgressBar(bool wanted, Clock::time_point (*now)())
    : wanted_(wanted),
      redraws_(os::can_redraw(os::k_standard_error)),
      now_(now),
      start_(now()),
      next_(start_ + (redraws_ ? Clock::duration(k_first_bar) : Clock::duration(k_next_line))) {}

ProgressBar::~ProgressBar() {
    if (shown_) std::fputs("\r\x1b[K", stderr);
    set_progress_shown(false);
}

void ProgressBar::update(double fraction) {
    if (!wanted_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || fraction < highest_) return;
    highest_ = fraction;
    const auto now = now_();
    if (now < next_) return;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    if (redraws_) {
        next_ = now + k_next_bar;
        shown_ = true;
        set_progress_shown(true);
        // Some terminals wrap the line when the last column is used.
        fmt::print(stderr, "\r{}\x1b[K",
                   progress_text(fraction, seconds, os::terminal_columns(os::k_standard_error) - 1));
    } else {
        next_ = now + k_next_line;
        print_error("glint: {:.0f}%{}\n", 100 * fraction, time_left(fraction, seconds));
    }
    std::fflush(stderr);
}

std::string progress_text(double fraction, double seconds_so_far, int columns) {
    constexpr int widest = 30, narrowest = 5;
    const std::string percent = fmt::format(" {:3.0f}%", 100 * fraction);
    const std::string rest = percent + time_left(fraction, seconds_so_far);
    const int width = std::min(widest, columns - 2 - static_cast<int>(rest.size()));
    if (width < narrowest) return static_cast<int>(rest.size()) <= columns ? rest : percent;
    const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
    return fmt::format("[{:<{}}]{}", std::string(static_cast<std::size_t>(filled), '#'), width, rest);
}

}  // namespace glint::cli
