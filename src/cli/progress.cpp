#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/interrupt.h"
#include "cli/tell.h"
#include "cli/terminal.h"

namespace glint::cli {

ProgressBar::ProgressBar(bool wanted) : wanted_(wanted && is_terminal(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
    if (shown_) tell("\r\x1b[K");
    set_progress_shown(false);
}

void ProgressBar::update(double fraction) {
    if (!wanted_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || fraction < highest_) return;
    highest_ = fraction;
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    shown_ = true;
    set_progress_shown(true);
    tell("\r{}\x1b[K", progress_text(fraction, std::chrono::duration<double>(now - start_).count()));
    std::fflush(stderr);
}

std::string progress_text(double fraction, double seconds_so_far) {
    constexpr int width = 30;
    const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
    std::string left;
    if (fraction > 0.005) {
        const long seconds = std::lround(std::min(seconds_so_far * (1 - fraction) / fraction, 3.6e6));
        left = seconds >= 3600
                   ? fmt::format("  {}:{:02}:{:02} left", seconds / 3600, seconds / 60 % 60, seconds % 60)
                   : fmt::format("  {}:{:02} left", seconds / 60, seconds % 60);
    }
    return fmt::format("[{:<{}}] {:3.0f}%{}", std::string(filled, '#'), width, 100 * fraction, left);
}

}  // namespace glint::cli
