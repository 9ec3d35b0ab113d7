// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `glint render` prints about a run.
#include <string>

#include "cli/render_arguments.h"
#include "glint/glint.h"

namespace glint::cli {

/// Seconds of the stages of a run.
struct Times {
    double load = 0, prepare = 0, trace = 0, encode = 0;
};

/// The value of --stats.
std::string stats_text(const Rendering& rendering, const Times& times);

/// The line that ends a run. size: "640x480"; whole: seconds.
void print_result(const RenderArguments& arguments, const std::string& path, const std::string& size,
                  const Rendering& result, const Times& times, double whole,
                  const std::vector<Diagnostic>& warnings);

/// Warns of rays that were cut. Throws Failure with --strict.
void report_cut_rays(const RenderArguments& arguments, const RayCounts& rays);

[[noreturn]] void fail_strict(std::size_t warnings);

}  // namespace glint::cli
