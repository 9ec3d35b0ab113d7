// glint grade: every picture of a folder held against a reference, or every part of a rubric.
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/draw.h"
#include "cli/failure.h"
#include "cli/grade_report.h"
#include "cli/output_file.h"
#include "cli/picture_file.h"
#include "cli/progress.h"
#include "cli/scene_option.h"
#include "cli/submissions.h"
#include "image/contact_sheet.h"

namespace glint::cli {
namespace {

constexpr auto k_examples = R"(Examples:
  glint grade handed_in --scene castle.json --reference castle.png
  glint grade handed_in --scene castle.json --csv grades.csv --sheet sheet.png
  glint grade handed_in --scene castle.json --rubric rt2.rubric --csv grades.csv)";

constexpr std::size_t k_batch = 32;  // pictures in memory at a time
constexpr double k_gain = 4;         // of the differences on the sheet
constexpr std::int32_t k_thumb = 160, k_least_thumb = 16, k_sheet_height = 30000;  // pixels

struct GradeArguments {
    std::string folder, reference, rubric, csv, json, sheet;
    SceneOption scene;
    bool quiet = false;
    int threads = 0;
};

// Where the results go besides standard output, found out before the work begins.
struct Outputs {
    std::optional<OutputFile> csv, json, sheet;
    // Then the table for people is left out: standard output is one file.
    bool take_standard_output() const {
        return (csv && csv->is_standard_output()) || (json && json->is_standard_output());
    }
};

void write_text(const std::optional<OutputFile>& file, const std::string& text) {
    if (file) file->write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void write_sheet(const Outputs& outputs, const std::vector<SheetCell>& cells, std::size_t columns,
                 int threads) {
    if (outputs.sheet) write_png(contact_sheet(cells, columns), *outputs.sheet, threads);
}

// Small enough for that many rows of cells, each a picture above another.
std::int32_t thumb_side(std::size_t rows) {
    return std::clamp(static_cast<std::int32_t>(k_sheet_height / (2 * rows)) - 8, k_least_thumb, k_thumb);
}

std::size_t square_columns(std::size_t cells) {
    std::size_t columns = 1;
    while (columns * columns < 2 * cells) ++columns;  // cells are twice as high as wide
    return columns;
}

std::string size_fault(const Image& picture, const Image& wanted) {
    if (picture.width == wanted.width && picture.height == wanted.height) return {};
    return fmt::format("{}x{} pixels, expected {}x{}", picture.width, picture.height, wanted.width,
                       wanted.height);
}

CauseOptions cause_options(int threads, std::function<void(double)> progress) {
    CauseOptions options;
    options.threads = threads;
    options.progress = std::move(progress);
    return options;
}

Image draw_reference(const Scene& scene, int threads) {
    WantedPicture wanted = draw_wanted(scene, {}, threads);
    if (!wanted.error.empty()) throw Failure(k_bad_input, wanted.error);
    return std::move(wanted.image);
}

// ---- Pictures against one reference ----

int grade_pictures(const GradeArguments& arguments, const Scene* scene, const Image& reference,
                   const Outputs& outputs) {
    const std::vector<Submission> submissions = list_pictures(arguments.folder);
    if (submissions.empty())
        throw Failure(k_bad_input, fmt::format("folder '{}' holds no pictures", arguments.folder));
    const std::size_t count = submissions.size(), columns = square_columns(count + 1);
    const std::int32_t side = thumb_side((count + columns) / columns);
    std::vector<GradedPicture> graded;
    std::vector<SheetCell> cells = {{scaled_down(reference, side), {}, 0}};
    auto bar = std::make_unique<ProgressBar>(!arguments.quiet);
    for (std::size_t first = 0; first < count; first += k_batch) {
        const std::size_t last = std::min(first + k_batch, count);
        std::vector<Image> pictures;
        for (std::size_t i = first; i < last; ++i) {
            GradedPicture entry;
            entry.name = submissions[i].name;
            entry.path = submissions[i].path;
            DecodeResult read = try_picture(entry.path);
            entry.error = read.image ? size_fault(*read.image, reference) : read.error;
            SheetCell cell{{}, {}, static_cast<int>(i + 1)};
            if (read.image) cell.picture = scaled_down(*read.image, side);
            if (entry.error.empty()) {
                CompareOptions options;
                options.threads = arguments.threads;
                entry.difference = compare(*read.image, reference, options);
                cell.difference = scaled_down(difference_image(*read.image, reference, k_gain), side);
                pictures.push_back(std::move(*read.image));
            }
            cells.push_back(std::move(cell));
            graded.push_back(std::move(entry));
        }
        auto reports = find_causes(
            pictures, reference, scene, cause_options(arguments.threads, [&](double fraction) {
                bar->update((static_cast<double>(first) + fraction * static_cast<double>(last - first)) /
                            static_cast<double>(count));
            }));
        auto report = reports.begin();
        for (std::size_t i = first; i < last; ++i) {
            if (graded[i].error.empty()) graded[i].causes = std::move(*report++);
        }
    }
    bar.reset();  // its line is free again
    if (!outputs.take_standard_output()) fmt::print("{}", text_table(graded));
    write_text(outputs.csv, csv_table(graded));
    write_text(outputs.json, json_table(graded));
    write_sheet(outputs, cells, columns, arguments.threads);
    return k_done;
}

// ---- By a rubric ----

std::vector<RubricRow> load_rubric(const std::string& path) {
    std::string why;
    const auto file = InputFile::open(path, why);
    if (!file) throw Failure(k_bad_input, fmt::format("{}: {}", path, why));
    RubricResult rubric = read_rubric(path, file->text());
    print(rubric.diagnostics);
    if (!rubric.diagnostics.empty()) throw Failure(k_bad_input, {});
    return std::move(rubric.rows);
}

// One part of all submissions; the sheet's cells of it go to its column.
class PartGrader {
  public:
    PartGrader(const RubricRow& row, const Scene& scene, const GradeArguments& arguments)
        : row_(row), arguments_(arguments), wanted_(draw_wanted(scene, row, arguments.threads)) {
        if (!wanted_.error.empty())
            throw Failure(k_bad_input, fmt::format("{}: {}", row.part, wanted_.error));
    }

    const Image& wanted() const { return wanted_.image; }

    // Grades submissions [first, last) into their part k.
    void grade_batch(const std::vector<Submission>& submissions, std::size_t first, std::size_t last,
                     std::size_t k, std::vector<GradedSubmission>& graded,
                     const std::function<void(std::size_t, SheetCell)>& show, std::int32_t side) const {
        std::vector<Image> faulty;
        std::vector<std::size_t> whose;
        for (std::size_t i = first; i < last; ++i) {
            GradedPart& part = graded[i].parts[k];
            part.path = find_file(submissions[i].path, row_.file);
            if (part.path.empty()) {
                part.error = fmt::format("no file {}", row_.file);
                continue;
            }
            DecodeResult read = try_picture(part.path);
            if (!read.image) {
                part.error = read.error;
                continue;
            }
            part.error = size_fault(*read.image, wanted_.image);
            SheetCell cell{scaled_down(*read.image, side), {}, static_cast<int>(i + 1)};
            if (part.error.empty()) {
                part.score = grade(*read.image, wanted_, row_.points, arguments_.threads);
                cell.difference = scaled_down(difference_image(*read.image, wanted_.image, k_gain), side);
                if (part.score.points < row_.points) {
                    faulty.push_back(std::move(*read.image));
                    whose.push_back(i);
                }
            }
            show(i, std::move(cell));
        }
        auto reports =
            find_causes(faulty, wanted_.image, &wanted_.scene, cause_options(arguments_.threads, {}));
        for (std::size_t i = 0; i < reports.size(); ++i) {
            if (!reports[i].causes.empty())
                graded[whose[i]].parts[k].cause = std::move(reports[i].causes.front());
        }
    }

  private:
    const RubricRow& row_;
    const GradeArguments& arguments_;
    WantedPicture wanted_;
};

int grade_by_rubric(const GradeArguments& arguments, const Scene& scene, const std::vector<RubricRow>& rows,
                    const Outputs& outputs) {
    const std::vector<Submission> submissions = list_folders(arguments.folder);
    const std::size_t count = submissions.size(), columns = rows.size();
    const std::int32_t side = thumb_side(count + 1);
    std::vector<GradedSubmission> graded;
    for (const Submission& s : submissions) graded.push_back({s.name, std::vector<GradedPart>(columns)});
    std::vector<SheetCell> cells((count + 1) * columns);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i].number = static_cast<int>(i / columns);
    auto bar = std::make_unique<ProgressBar>(!arguments.quiet);
    for (std::size_t k = 0; k < columns; ++k) {
        const PartGrader grader(rows[k], scene, arguments);
        cells[k].picture = scaled_down(grader.wanted(), side);
        const auto show = [&](std::size_t i, SheetCell cell) {
            cells[(i + 1) * columns + k] = std::move(cell);
        };
        for (std::size_t first = 0; first < count; first += k_batch) {
            const std::size_t last = std::min(first + k_batch, count);
            grader.grade_batch(submissions, first, last, k, graded, show, side);
            bar->update((static_cast<double>(k) + static_cast<double>(last) / static_cast<double>(count)) /
                        static_cast<double>(columns));
        }
    }
    bar.reset();  // its line is free again
    if (!outputs.take_standard_output()) fmt::print("{}", text_table(rows, graded));
    write_text(outputs.csv, csv_table(rows, graded));
    write_text(outputs.json, json_table(rows, graded));
    write_sheet(outputs, cells, columns, arguments.threads);
    return k_done;
}

int grade_command(GradeArguments& arguments) {
    if (arguments.reference.empty() && arguments.scene.scene.files.empty())
        throw Failure(k_usage, "expected --scene FILE, or --reference PICTURE, or both");
    if (!arguments.rubric.empty() && arguments.scene.scene.files.empty())
        throw Failure(k_usage, "--rubric needs --scene FILE, which draws its parts");
    Outputs outputs;
    if (!arguments.csv.empty()) outputs.csv.emplace(arguments.csv);
    if (!arguments.json.empty()) outputs.json.emplace(arguments.json);
    if (!arguments.sheet.empty()) outputs.sheet.emplace(arguments.sheet);

    std::vector<RubricRow> rows;
    if (!arguments.rubric.empty()) rows = load_rubric(arguments.rubric);
    std::optional<LoadedScene> loaded = load_scene_option(arguments.scene, arguments.quiet);
    Image reference;
    if (!arguments.reference.empty()) reference = std::move(*read_picture(arguments.reference).image);
    if (loaded && !reference.rgb.empty()) {
        loaded->scene.settings.width = reference.width;
        loaded->scene.settings.height = reference.height;
    }
    if (!rows.empty()) return grade_by_rubric(arguments, loaded->scene, rows, outputs);
    if (reference.rgb.empty()) reference = draw_reference(loaded->scene, arguments.threads);
    return grade_pictures(arguments, loaded ? &loaded->scene : nullptr, reference, outputs);
}

}  // namespace

Run add_grade(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "grade", "Hold every picture of a folder against a reference, or a rubric's parts");
    const auto arguments = std::make_shared<GradeArguments>();
    GradeArguments& a = *arguments;
    command.add_option("DIR", a.folder, "Pictures, or a folder for each submission")->required();
    command
        .add_option(
            "--reference", a.reference,
            "The picture that is right; default: what the scene draws. With --rubric only its size counts")
        ->option_text("PICTURE");
    add_scene_option(command, a.scene, "The scene to be drawn: names the causes, and draws a rubric's parts");
    command
        .add_option("--rubric", a.rubric,
                    "Lines of PART POINTS FILE [KEY=VALUE...] (docs/teaching.md): points a part")
        ->option_text("FILE");
    command.add_option("--csv", a.csv, "Write the table as CSV")->option_text("OUT");
    command.add_option("--json", a.json, "Write all figures and causes as JSON")->option_text("OUT");
    command
        .add_option("--sheet", a.sheet,
                    "Write a PNG of all pictures, each above four times its difference, by the table's "
                    "numbers; 0: the "
                    "reference")
        ->option_text("OUT.png");
    command.add_option("-t,--threads", a.threads, "Threads; 0 (default): one a processor")
        ->check(CLI::Range(0, 1024))
        ->option_text("N");
    command.add_flag("-q,--quiet", a.quiet, "No warnings and no progress");
    command.footer(k_examples);
    return [arguments] { return grade_command(*arguments); };
}

}  // namespace glint::cli
