// SPDX-License-Identifier: Apache-2.0
#include "cli/light_argument.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "cli/explain_text.h"
#include "cli/failure.h"
#include "cli/text.h"

namespace glint::cli {

std::uint32_t find_light(const std::string& option, const std::string& text, const Scene& scene) {
    const auto count = static_cast<std::uint32_t>(scene.lights.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        if (scene.light_texts.name(i) == text) return i;
    }
    std::uint32_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec == std::errc() && read.ptr == text.data() + text.size() && number >= 1 && number <= count)
        return number - 1;
    std::string known;
    for (std::uint32_t i = 0; i < std::min(count, 20u); ++i)
        known += fmt::format("\n  {}: {}", i + 1, light_text(scene, i));
    throw Failure(k_usage, fmt::format("{}: there is no light '{}'; there {} {}{}", option, text,
                                       count == 1 ? "is" : "are", counted(count, "light"), known));
}

}  // namespace glint::cli
