// SPDX-License-Identifier: Apache-2.0
// glint grade: compares every picture of a folder with a reference, or with the parts of a rubric.
#include <fmt/format.h>

#include <memory>

#include "base/text.h"
#include "cli/class_summary.h"
#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/grade_outputs.h"
#include "cli/grade_report.h"
#include "cli/grade_sheet.h"
#include "cli/graded_folders.h"
#include "cli/log_feedback.h"
#include "cli/memory_size.h"
#include "cli/picture_file.h"
#include "cli/picture_sizes.h"
#include "cli/print_text.h"
#include "cli/progress.h"
#include "cli/scene_option.h"
#include "cli/student_results.h"
#include "cli/submissions.h"
#include "grade/part_renderer.h"

namespace glint::cli {
namespace {

constexpr auto k_grade_examples = R"(Examples:
  glint grade handed_in --scene castle.json --reference castle.png
  glint grade handed_in --scene castle.json --csv grades.csv --sheet sheet.png
  glint grade handed_in --scene castle.json --rubric rt2.rubric --csv grades.csv
  glint grade handed_in --scene castle.json --rubric rt2.rubric --summary class.html
  glint grade ada --scene castle.json --rubric rt2.rubric --gradescope results.json)";
// In memory: of large pictures fewer.
constexpr std::size_t k_pictures_at_a_time = 32, k_pixels_at_a_time = std::size_t{1} << 26;

struct GradeArguments {
    std::string folder, reference, rubric, logs;
    GradeOutputNames outputs;
    SceneOption scene;
    std::string visibility = "visible";
    bool pictures = false, hide_causes = false;
    bool quiet = false;
    int threads = 0;
};

void write_text(const std::optional<OutputFile>& file, const std::string& text) {
    if (file) file->write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

CauseOptions cause_options(int threads, std::function<void(double)> progress) {
    CauseOptions options;
    options.threads = threads;
    options.progress = std::move(progress);
    return options;
}

Image render_reference(const Scene& scene, int threads) {
    WantedPicture wanted = PartRenderer(scene, threads).render(RubricRow{});
    if (!wanted.error.empty()) throw Failure(k_bad_input, wanted.error);
    return std::move(wanted.image);
}

// ---- Pictures against one reference ----

int grade_pictures(const GradeArguments& arguments, const Scene* scene, const Image& reference,
                   const GradeOutputs& outputs) {
    const std::vector<Submission> submissions = list_pictures(arguments.folder);
    if (submissions.empty())
        throw Failure(k_bad_input, fmt::format("folder '{}' holds no pictures", arguments.folder));
    const std::size_t count = submissions.size();
    std::vector<GradedPicture> graded;
    GradeSheet sheet(outputs.sheet, lay_out_list(count + 1), count + 1);
    PartPictures small(outputs.summary.has_value(), count);
    sheet.set_label(0, "0 reference");
    sheet.put(0, reference);
    PictureSizes sizes;
    sizes.set_wanted(reference);
    auto bar = std::make_unique<ProgressBar>(!arguments.quiet);
    const std::size_t at_a_time =
        std::clamp<std::size_t>(k_pixels_at_a_time / (reference.rgb.size() / 3), 1, k_pictures_at_a_time);
    for (std::size_t first = 0; first < count; first += at_a_time) {
        const std::size_t last = std::min(first + at_a_time, count);
        std::vector<Image> pictures;
        std::vector<std::size_t> whose;
        for (std::size_t i = first; i < last; ++i) {
            GradedPicture entry;
            entry.name = submissions[i].name;
            entry.path = submissions[i].path;
            entry.error = submissions[i].error;
            Result<DecodedImage> read;
            if (entry.error.empty()) {
                read = try_handed_in(entry.path);
                entry.error = read ? size_fault(read->image, reference) : read.message;
                if (read) entry.note = read->note;
            }
            if (read) sizes.add(read->image);
            sheet.set_label(i + 1, fmt::format("{} {}", i + 1, entry.name));
            if (read && !entry.error.empty()) {
                sheet.put(i + 1, read->image);
                small.put(i, read->image);
            }
            if (entry.error.empty()) {
                CompareOptions options;
                options.threads = arguments.threads;
                entry.difference = compare(read->image, reference, options).value();
                entry.not_finite = count_not_finite(read->image);
                sheet.put(i + 1, read->image, reference);
                small.put(i, read->image, reference);
                if (entry.not_finite == 0) {
                    pictures.push_back(std::move(read->image));
                    whose.push_back(i);
                }
            }
            graded.push_back(std::move(entry));
        }
        auto reports = find_causes(
            pictures, reference, scene, cause_options(arguments.threads, [&](double fraction) {
                bar->update((static_cast<double>(first) + fraction * static_cast<double>(last - first)) /
                            static_cast<double>(count));
            }));
        for (std::size_t i = 0; i < reports.size(); ++i) {
            GradedPicture& entry = graded[whose[i]];
            entry.causes_error = reports[i].message;
            if (reports[i]) entry.causes = *std::move(reports[i]);
        }
    }
    bar.reset();  // its line is free again
    sizes.check(!arguments.reference.empty());
    if (outputs.table) print_text(text_table(graded));
    write_text(outputs.csv, csv_table(graded));
    write_text(outputs.json, json_table(graded));
    if (outputs.summary) write_text(outputs.summary, class_summary(graded, small));
    sheet.write(arguments.threads);
    return k_done;
}

// ---- By a rubric ----

Rubric load_rubric(const std::string& path) {
    std::string why;
    const auto file = InputFile::open(path, why);
    if (!file) throw Failure(k_bad_input, fmt::format("{}: {}", path, why));
    RubricResult read = read_rubric(path, file->text());
    print(read.diagnostics);
    if (!read.diagnostics.empty()) throw Failure(k_bad_input, {});
    return std::move(read.rubric);
}

std::string logs_text(const std::vector<Submission>& submissions, const std::vector<LogFeedback>& logs) {
    std::string text = logs.empty() ? "" : "Logs, which give no points:\n";
    for (std::size_t i = 0; i < logs.size(); ++i)
        text += fmt::format("{:>3}  {}: {}\n", i + 1, submissions[i].name, log_text(logs[i], true));
    return text;
}

int grade_rubric(const GradeArguments& arguments, const Scene& scene, const Rubric& rubric,
                 const GradeOutputs& outputs) {
    const std::vector<RubricRow>& rows = rubric.rows;
    const std::vector<Submission> submissions =
        outputs.is_of_one() ? std::vector{Submission{arguments.folder, arguments.folder, {}}}
                            : list_folders(arguments.folder);
    const std::size_t cells = (submissions.size() + 1) * rows.size();
    GradeSheet sheet(outputs.sheet, lay_out_table(submissions.size(), rows.size()), cells);
    auto bar = std::make_unique<ProgressBar>(!arguments.quiet);
    PartPictures small(arguments.pictures || outputs.summary, submissions.size() * rows.size());
    GradedFolders folders(submissions, rows, sheet, small);
    RubricOptions options;
    options.threads = arguments.threads;
    options.progress = [&](double fraction) { bar->update(fraction); };
    const auto result = grade_by_rubric(scene, rubric, folders, options);
    bar.reset();  // its line is free again
    if (!result) throw_failure(result);
    if (!outputs.is_of_one()) folders.sizes().check(!arguments.reference.empty());
    const std::vector<GradedSubmission>& graded = *result;
    std::vector<LogFeedback> logs;
    if (!arguments.logs.empty()) logs = diagnose_logs(scene, submissions, arguments.logs, arguments.threads);
    if (outputs.table) print_text(text_table(rows, graded) + logs_text(submissions, logs));
    write_text(outputs.csv, csv_table(rows, graded));
    write_text(outputs.json, json_table(rows, graded, logs));
    if (outputs.summary) write_text(outputs.summary, class_summary(rubric, graded, small));
    const StudentResultOptions student{arguments.visibility, !arguments.hide_causes,
                                       logs.empty() ? "" : log_text(logs.front(), !arguments.hide_causes),
                                       arguments.pictures ? &small : nullptr};
    if (outputs.gradescope)
        write_text(outputs.gradescope, gradescope_results(rubric, graded.front(), student));
    if (outputs.prairielearn)
        write_text(outputs.prairielearn, prairielearn_results(rubric, graded.front(), student));
    sheet.write(arguments.threads);
    return k_done;
}

int grade_command(GradeArguments& arguments) {
    if (arguments.reference.empty() && arguments.scene.scene.files.empty())
        throw Failure(k_usage, "expected --scene FILE, or --reference PICTURE, or both");
    if (!arguments.rubric.empty() && arguments.scene.scene.files.empty())
        throw Failure(k_usage, "--rubric needs --scene FILE, which its parts are rendered from");
    if (!arguments.outputs.gradescope.empty() && arguments.rubric.empty())
        throw Failure(k_usage, "--gradescope needs --rubric FILE, whose parts are the tests");
    if (!arguments.outputs.prairielearn.empty() && arguments.rubric.empty())
        throw Failure(k_usage, "--prairielearn needs --rubric FILE, whose parts are the tests");
    const bool is_of_one = !arguments.outputs.gradescope.empty() || !arguments.outputs.prairielearn.empty();
    if ((arguments.pictures || arguments.hide_causes) && !is_of_one)
        throw Failure(k_usage, fmt::format("{} needs --gradescope OUT or --prairielearn OUT",
                                           arguments.pictures ? "--pictures" : "--hide-causes"));
    if (!arguments.logs.empty() && arguments.rubric.empty())
        throw Failure(k_usage, "--logs needs --rubric FILE: a submission is then a folder");
    const GradeOutputs outputs(arguments.outputs, arguments.folder);
    Rubric rubric;
    if (!arguments.rubric.empty()) rubric = load_rubric(arguments.rubric);
    arguments.scene.scene.is_confined = true;  // it may be a submission
    std::optional<Scene> scene;
    if (auto loaded = load_scene_option(arguments.scene, arguments.quiet))
        scene = std::move(loaded->scene).release();
    Image reference;
    if (!arguments.reference.empty()) reference = read_picture(arguments.reference).image;
    if (scene && !reference.rgb.empty()) {
        scene->settings.width = reference.width;
        scene->settings.height = reference.height;
    }
    if (!rubric.rows.empty()) return grade_rubric(arguments, *scene, rubric, outputs);
    if (reference.rgb.empty()) reference = render_reference(*scene, arguments.threads);
    return grade_pictures(arguments, scene ? &*scene : nullptr, reference, outputs);
}

}  // namespace

Run add_grade(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "grade", "Compare every picture of a folder with a reference, or with a rubric's parts");
    const auto arguments = std::make_shared<GradeArguments>();
    GradeArguments& a = *arguments;
    command.add_option("DIR", a.folder, "Pictures, or a folder for each submission")
        ->option_text(" ")
        ->required();
    command
        .add_option("--reference", a.reference,
                    "The right picture; default: the scene's own. With --rubric, only its size is used")
        ->option_text("PICTURE");
    add_scene_option(command, a.scene, "The scene of the task: for the causes and for a rubric's parts");
    add_memory_argument(command, a.scene.scene.max_memory,
                        "The most memory that reading the scene may take: 500M, 4G");
    command
        .add_option("--rubric", a.rubric,
                    "Lines of PART POINTS FILE [KEY=VALUE...] (docs/teaching.md): points per part")
        ->option_text("FILE");
    command
        .add_option(
            "--logs", a.logs,
            "Diagnose the file of each submission with this name, as '*.log': the log of its program at "
            "some pixels (glint diagnose). Feedback, never points. Needs --rubric")
        ->option_text("PATTERN");
    command.add_option("--csv", a.outputs.csv, "Write the table as CSV")->option_text("OUT");
    command.add_option("--json", a.outputs.json, "Write all figures and causes as JSON")->option_text("OUT");
    command
        .add_option("--gradescope", a.outputs.gradescope,
                    "Write Gradescope's results.json; DIR is the folder of one submission. Needs --rubric")
        ->option_text("OUT");
    command
        .add_option("--prairielearn", a.outputs.prairielearn,
                    "Write PrairieLearn's results.json; DIR is the folder of one submission. Needs --rubric")
        ->option_text("OUT");
    command.add_flag("--pictures", a.pictures,
                     "In these results: each wrong picture, and its difference from the right one");
    command.add_flag("--hide-causes", a.hide_causes,
                     "In these results: points, without the causes of what is wrong");
    command
        .add_option("--visibility", a.visibility,
                    "Of Gradescope's tests: visible, hidden, after_due_date or after_published")
        ->option_text("WHEN")
        ->check(CLI::IsMember({"visible", "hidden", "after_due_date", "after_published"}));
    command
        .add_option("--summary", a.outputs.summary,
                    "Write a web page: each mistake of the class with its submissions and some pictures")
        ->option_text("OUT.html");
    command
        .add_option("--sheet", a.outputs.sheet,
                    "Write a PNG of all pictures, each above four times its difference, with the table's "
                    "numbers and names; 0: the reference")
        ->option_text("OUT.png");
    add_threads_argument(command, a.threads);
    command.add_flag("-q,--quiet", a.quiet, "No warnings and no progress");
    command.footer(k_grade_examples);
    return [arguments] { return grade_command(*arguments); };
}

}  // namespace glint::cli
