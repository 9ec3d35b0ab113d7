// SPDX-License-Identifier: Apache-2.0
// glint compare: compares a picture with a reference, and says why they differ.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <initializer_list>
#include <memory>
#include <mutex>

#include "base/parallel_scratch.h"
#include "cli/commands.h"
#include "cli/compare_report.h"
#include "cli/failure.h"
#include "cli/memory_size.h"
#include "cli/output_file.h"
#include "cli/picture_file.h"
#include "cli/print_error.h"
#include "cli/print_text.h"
#include "cli/progress.h"
#include "cli/render_or_fail.h"
#include "cli/scene_option.h"
#include "cli/text.h"
#include "cli/validators.h"
#include "cli/vary.h"
#include "compare/find_stored.h"
#include "image/levels.h"
#include "output/strip_writer.h"

namespace glint::cli {
namespace {

constexpr auto k_compare_examples = R"(Examples:
  glint compare mine.png reference.png                        figures, and the likeliest cause
  glint compare mine.png castle.png --scene castle.json       tests many more causes, by rendering
  glint compare mine.png castle.png --within 2 --fail-percent 1    exit code 0 if 99% are within 2/255
  glint compare mine.png castle.png --diff difference.png
  glint compare castle.json --vary reflections=0..6           the value after which nothing changes)";

struct CompareArguments {
    std::vector<std::string> files;
    SceneOption scene;
    std::optional<double> within, fail_percent, hard_fail;
    std::string diff, vary;
    bool no_causes = false, json = false, quiet = false;
    int threads = 0;
    std::uint64_t max_memory = 0;
};

// What is left of --max-memory, and at least a byte; 0 without the option.
std::uint64_t memory_beside(std::uint64_t max_memory, std::initializer_list<const StoredPicture*> pictures) {
    std::uint64_t left = max_memory;
    for (const StoredPicture* picture : pictures) left -= std::min<std::uint64_t>(left, picture->bytes());
    return max_memory > 0 ? std::max<std::uint64_t>(left, 1) : 0;
}

// What is infinite or NaN never passes. Without limits only identical pictures do. --within and
// --fail-percent go together; --hard-fail may stand alone.
bool passes(const CompareArguments& arguments, const PictureDifference& d) {
    if (d.not_finite > 0) return false;
    if (arguments.hard_fail && d.largest.value > *arguments.hard_fail) return false;
    if (!arguments.within && !arguments.fail_percent)
        return arguments.hard_fail || d.all.equal == d.all.pixels;
    const std::uint64_t good = arguments.within ? d.all.within : d.all.equal;
    const double failing = 100 * static_cast<double>(d.all.pixels - good) / static_cast<double>(d.all.pixels);
    return failing <= arguments.fail_percent.value_or(0);
}

// As difference_image(), strip by strip.
void write_difference(const OutputFile& output, const CompareArguments& arguments, const PictureView& a,
                      const PictureView& b, double largest) {
    const DifferenceRows rows(a, b, 0);
    StripWriter file(output.begin(), {.threads = 1}, b.width, b.height);
    const std::size_t count = std::size_t{3} * b.width;
    const auto strips = static_cast<std::size_t>(count_strips(b.height));
    struct Memory {
        std::vector<float> strip, row;
    };
    std::vector<Memory> scratch(scratch_count(strips, arguments.threads),
                                {std::vector<float>(count * k_strip_rows), std::vector<float>(count)});
    std::mutex mutex;
    std::exception_ptr failure;
    std::atomic<bool> has_failed = false;
    parallel_scratch(strips, scratch, [&](std::size_t strip, Memory& memory) {
        if (has_failed) return;  // strips that cannot be written would be kept
        try {
            const auto first = static_cast<std::int32_t>(strip) * k_strip_rows,
                       height = std::min(k_strip_rows, b.height - first);
            for (std::int32_t y = 0; y < height; ++y)
                rows.read(first + y, &memory.strip[count * static_cast<std::size_t>(y)], memory.row.data());
            file.put(static_cast<std::int32_t>(strip),
                     std::span(memory.strip).first(count * static_cast<std::size_t>(height)));
        } catch (...) {
            const std::scoped_lock lock(mutex);
            failure = std::current_exception();
            has_failed = true;
        }
    });
    if (failure) std::rethrow_exception(failure);
    file.finish(false);
    if (arguments.quiet) return;
    print_error("{}  |A - B|{}\n", arguments.diff,
                largest > 0 ? fmt::format(" times {:.4g}", 255 / largest) : ", all black");
}

std::string note_text(const std::string& file, const DecodedPicture& picture) {
    return picture.note.empty() ? "" : fmt::format("{}: {}\n", file, picture.note);
}

int compare_command(CompareArguments& arguments) {
    if (!arguments.vary.empty()) {
        if (!arguments.scene.scene.files.empty() || !arguments.diff.empty())
            throw Failure(k_usage,
                          "--vary takes a scene in place of two pictures, without --scene and --diff");
        arguments.scene.scene.files = arguments.files;
        return vary_command(arguments.scene, parse_variation(arguments.vary), arguments.threads,
                            arguments.json, arguments.quiet);
    }
    if (arguments.files.size() != 2)
        throw Failure(k_usage, fmt::format("expected two pictures, found {}; or SCENE --vary KEY=VALUES",
                                           arguments.files.size()));
    if (!arguments.scene.picture.size.empty())
        throw Failure(k_usage,
                      "--size belongs to --vary: beside two pictures, the scene is rendered in their size");
    std::optional<OutputFile> diff;
    if (!arguments.diff.empty()) {
        diff.emplace(png_output("--diff", arguments.diff));
        if (diff->is_standard_output() && !arguments.quiet)
            throw Failure(k_usage, "--diff - needs --quiet: the report goes to standard output, too");
    }
    arguments.scene.scene.max_memory = arguments.max_memory;
    const std::optional<LoadedScene> scene = load_scene_option(arguments.scene, arguments.quiet);
    DecodedPicture a = read_stored_picture(arguments.files[0], arguments.max_memory);
    DecodedPicture b =
        read_stored_picture(arguments.files[1], memory_beside(arguments.max_memory, {&a.picture}));
    if (!arguments.quiet)
        print_error("{}{}", note_text(arguments.files[0], a), note_text(arguments.files[1], b));

    CompareReport report;
    report.a = arguments.files[0];
    report.b = arguments.files[1];
    report.width = b.picture.width;
    report.height = b.picture.height;
    CompareOptions options;
    options.threads = arguments.threads;
    options.within = arguments.within.value_or(options.within);
    options.as_floats = report.as_floats = a.bits > 8 && a.bits == b.bits;
    report.within = options.within;
    options.max_memory = memory_beside(arguments.max_memory, {&a.picture, &b.picture});
    const Result<PictureDifference> compared =
        compare(PictureView(a.picture), PictureView(b.picture), options);
    if (!compared) throw_failure(compared);
    report.difference = *compared;
    report.passes = passes(arguments, report.difference);
    if (diff) write_difference(*diff, arguments, a.picture, b.picture, report.difference.largest.value);
    if (arguments.quiet) return report.passes ? k_done : k_bad_input;

    if (report.difference.not_finite > 0) {
        report.causes.emplace(CauseReport{})->remark =
            "Numbers that are infinite or NaN come of a division by 0, or of a vector without length that is "
            "made a unit vector. No other cause is looked for.";
    } else if (!arguments.no_causes && report.difference.all.equal != report.difference.all.pixels) {
        ProgressBar bar(true);
        CauseOptions cause_options;
        cause_options.as_floats = options.as_floats;
        cause_options.threads = arguments.threads;
        cause_options.progress = [&](double fraction) { bar.update(fraction); };
        report.with_scene = scene.has_value();
        cause_options.max_memory = arguments.max_memory;
        report.causes = find_causes(std::move(a.picture), std::move(b.picture),
                                    scene ? &*scene->scene : nullptr, cause_options);
    }
    arguments.json ? print_json(json_report(report)) : print_text(text_report(report));
    return report.passes ? k_done : k_bad_input;
}

}  // namespace

Run add_compare(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("compare", "Compare a picture with a reference and explain the difference");
    const auto arguments = std::make_shared<CompareArguments>();
    CompareArguments& a = *arguments;
    command
        .add_option(
            "FILE", a.files,
            "A and B: the picture and the reference, PNG, PPM, OpenEXR or JPEG; with --vary, scene files")
        ->option_text("...")
        ->required();
    command
        .add_option("--within", a.within,
                    "A pixel may differ by N 255ths (default: 2 for the report; no limit)")
        ->check(number_between(0, 1e6))
        ->option_text("N");
    command
        .add_option("--fail-percent", a.fail_percent,
                    "P percent of the pixels may differ by more than --within")
        ->check(number_between(0, 100))
        ->option_text("P");
    command.add_option("--hard-fail", a.hard_fail, "No pixel may differ by more than N 255ths")
        ->check(number_between(0, 1e6))
        ->option_text("N");
    command
        .add_option("--diff", a.diff,
                    "Write |A - B| as a PNG, amplified so that the largest difference is white")
        ->option_text("OUT.png");
    command
        .add_option("--vary", a.vary,
                    "Render a scene with each value of a setting; list the steps that change it")
        ->option_text("KEY=VALUES");
    add_scene_option(command, a.scene, "The scene of B: causes are tested by rendering it; may be repeated");
    add_threads_argument(command, a.threads);
    add_memory_argument(
        command, a.max_memory,
        "Use at most this memory for the pictures and the comparison: 500M, 4G (default: what "
        "they need)");
    command.add_flag("--no-causes", a.no_causes, "Print only the figures; do not search for causes");
    command.add_flag("--json", a.json, "Print JSON");
    command.add_flag("-q,--quiet", a.quiet, "Print only errors; the exit code is the result");
    command.footer(k_compare_examples);
    return [arguments] { return compare_command(*arguments); };
}

}  // namespace glint::cli
