// SPDX-License-Identifier: Apache-2.0
#include "cli/render_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/failure.h"
#include "cli/print_error.h"
#include "cli/text.h"
#include "os/process.h"

namespace glint::cli {

std::string stats_text(const Rendering& rendering, const Times& times) {
    nlohmann::ordered_json stats = {
        {"load_s", times.load},
        {"prepare_s", times.prepare},
        {"trace_s", times.trace},
        {"encode_s", times.encode},
        {"threads", rendering.threads},
        {"isa", rendering.isa},
        {"rays",
         {{"camera", rendering.rays.camera},
          {"shadow", rendering.rays.shadow},
          {"mirror", rendering.rays.mirror},
          {"transmitted", rendering.rays.transmitted},
          {"cut", rendering.rays.cut}}},
        {"peak_rss_bytes", os::peak_memory()},
    };
    return stats.dump(2) + "\n";
}

void fail_strict(std::size_t warnings) {
    throw Failure(k_bad_input,
                  fmt::format("--strict: {}, so no picture is written", counted(warnings, "warning")));
}

void report_cut_rays(const RenderArguments& arguments, const RayCounts& rays) {
    if (rays.cut == 0 || (arguments.quiet && !arguments.strict)) return;
    print_error(
        "warning: {} mirror and glass rays were not traced: a sample of a pixel has at most {}; "
        "a lower --reflections or a higher min_weight omits the faintest first\n",
        with_commas(rays.cut), k_max_sample_rays);
    if (arguments.strict) fail_strict(1);
}

void print_result(const RenderArguments& arguments, const std::string& path, const std::string& size,
                  const Rendering& result, const Times& times, double whole,
                  const std::vector<Diagnostic>& warnings) {
    if (arguments.quiet) return;
    print_error("{}  {}  {} rays  {:.3f} s  {:.1f} Mray/s  (total {:.3f} s, {}, {}, {})\n", path, size,
                with_commas(result.rays.total()), times.trace,
                static_cast<double>(result.rays.total()) / times.trace / 1e6, whole,
                counted(std::uint64_t(result.threads), "thread"), result.isa,
                counted(count_warnings(warnings), "warning"));
    std::uint64_t left_out = 0;
    for (const Diagnostic& d : warnings) left_out += d.left_out;
    if (left_out > 0)
        print_error("{}  is without {} that glint does not render{}\n", path, counted(left_out, "object"),
                    arguments.hides_warnings ? "" : "; the warnings name them");
}

}  // namespace glint::cli
