// SPDX-License-Identifier: Apache-2.0
#include "cli/drop_in_animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "os/files.h"

namespace glint::cli {
namespace {

// A frame's number, or below 1 a fraction of all frames.
long frame_number(double value, long first, long count) {
    const double number = value < 1 ? value * static_cast<double>(count) : value;
    return std::max(static_cast<long>(number), first);
}

}  // namespace

std::vector<DropInFrame> frames_of(const Animation& a, const std::string& output) {
    const long first = static_cast<long>(a.first_frame.value_or(1));
    const long last = std::max(static_cast<long>(a.last_frame.value_or(static_cast<double>(first))), first);
    const bool has_frames = a.first_frame || a.last_frame.value_or(0) >= 1;
    if (!has_frames) return {};
    const long final = last + (a.is_cyclic ? 1 : 0);
    const double span = static_cast<double>(final - first);
    // With one frame POV-Ray divides by 0; its clock is then not a number.
    const double delta = span > 0 ? (a.last_clock - a.first_clock) / span : 0;
    // A cycle's final frame, which repeats the first one, counts in fractions; it is rendered if it is asked
    // for.
    const long count = final - first + 1;
    const long from = a.subset_first ? frame_number(*a.subset_first, first, count) : first;
    // A part that ends before it begins is one frame; frames beyond the last one go on with its clock
    // (measured).
    const long to = std::max(from, a.subset_last ? frame_number(*a.subset_last, first, count) : last);
    const std::filesystem::path path = os::to_path(output);
    const std::size_t digits = std::to_string(final).size();
    std::vector<DropInFrame> frames;
    for (long n = from; n <= to; n += std::max(1L, static_cast<long>(a.step))) {
        const std::string name =
            fmt::format("{}{:0{}}{}", os::to_string(path.stem()), n, digits, os::to_string(path.extension()));
        frames.push_back(
            {output == "/dev/null" ? output : os::to_string(path.parent_path() / os::to_path(name)),
             {{"clock", a.first_clock + delta * static_cast<double>(n - first)},
              {"frame_number", static_cast<double>(n)},
              {"initial_frame", static_cast<double>(first)},
              {"final_frame", static_cast<double>(final)},
              {"initial_clock", a.first_clock},
              {"final_clock", a.last_clock},
              {"clock_delta", delta}}});
    }
    return frames;
}

std::optional<PixelRange> pixels_of(const PartOfSide& part, int pixels) {
    const double whole = pixels, first = part.first.value_or(1), last = part.last.value_or(whole);
    const int from = static_cast<int>(first < 1 ? first * whole : first - 1);
    const int end = static_cast<int>(part.last && last <= 1 ? last * whole : last);
    if (from >= pixels || end > pixels || end <= from) return std::nullopt;
    return PixelRange{from, end - from};
}

}  // namespace glint::cli
