// SPDX-License-Identifier: Apache-2.0
// glint diagnose: compares the log of another ray tracer with a scene, quantity by quantity.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "cli/commands.h"
#include "cli/explain_text.h"
#include "cli/failure.h"
#include "cli/input_file.h"
#include "cli/picture_arguments.h"
#include "cli/print_text.h"
#include "cli/scene_arguments.h"
#include "cli/text.h"
#include "glint/diagnose.h"
#include "world/prepare.h"

namespace glint::cli {
namespace {

constexpr auto k_diagnose_examples = R"(Examples:
  glint diagnose castle.json glint.log                 the first quantity that differs, and its cause
  glint diagnose castle.json glint.log --size 320x240  the log is of a picture of this size
  glint diagnose castle.json glint.log --tree 120,80   all quantities of a pixel: yours and what they should be
  glint diagnose castle.json glint.log --json)";

struct DiagnoseArguments {
    SceneArguments scene;
    PictureArguments picture;
    std::string tree;
    bool json = false;
    int threads = 0;
};

std::string number_text(double v) {
    if (std::isnan(v)) return "nan";
    return fmt::format("{:.7g}", v == 0 ? 0.0 : v);
}

std::string value_text(const DiagnosedRow& row, const DiagnosedValue& value) {
    if (value.count == 0) return "-";
    if (row.quantity == "shape")
        return value.numbers[0] < 1 ? "a miss" : fmt::format("shape {:.0f}", value.numbers[0]);
    if (row.quantity == "children")
        return value.numbers[0] == 0   ? "none"
               : value.numbers[0] == 1 ? "a mirror ray"
               : value.numbers[0] == 2 ? "a glass ray"
                                       : "a mirror and a glass ray";
    if (value.count == 1) return number_text(value.numbers[0]);
    return fmt::format("({}, {}, {})", number_text(value.numbers[0]), number_text(value.numbers[1]),
                       number_text(value.numbers[2]));
}

std::string place_text(const DiagnosedRow& row, const Scene& scene) {
    std::string text = fmt::format("pixel {},{}", row.x, row.y);
    if (row.ray >= 0 && row.generation > 0)
        text += fmt::format(", {} ray (generation {})", row.ray_kind, row.generation);
    if (row.light < scene.lights.size()) text += ", " + light_text(scene, row.light);
    if (row.line != 0) text += fmt::format(", line {} of the log", row.line);
    return text;
}

std::string finding_text(const DiagnosisFinding& finding, const Diagnosis& diagnosis, const Scene& scene) {
    std::string text;
    auto out = std::back_inserter(text);
    std::string word(finding.word);
    if (word.starts_with("the ") || word.starts_with("whether "))
        word.front() = static_cast<char>(word.front() - 'a' + 'A');
    fmt::format_to(
        out, "{}{} {} wrong in {} of {}", word, finding.quantity == "children" ? " (its number)" : "",
        finding.quantity == "bytes" ? "are" : "is", finding.pixels, counted(diagnosis.pixels, "pixel"));
    if (finding.first_pixels > 0)
        fmt::format_to(out, ", in {} as the first difference", finding.first_pixels);
    if (!finding.only.empty()) fmt::format_to(out, "; only {}", finding.only);
    text += ".\n";
    const DiagnosedRow& row = finding.example;
    fmt::format_to(out, "  {}: yours {}, it should be {}\n", place_text(row, scene),
                   value_text(row, row.yours), value_text(row, row.expected));
    if (!finding.relation.empty() && finding.causes.empty())
        fmt::format_to(out, "  everywhere {}\n", finding.relation);
    if (finding.is_sure) {
        fmt::format_to(out, "  cause: {} ({})\n", finding.causes[0].explanation, finding.causes[0].id);
    } else if (!finding.causes.empty()) {
        fmt::format_to(out, "  {}\n",
                       finding.causes.size() == 1 ? "possible cause, which gives these numbers:"
                                                  : "possible causes, each of which gives these numbers:");
        for (const DiagnosedCause& cause : finding.causes)
            fmt::format_to(out, "    {} ({})\n", cause.explanation, cause.id);
    } else {
        text += "  cause unknown: no known mistake gives these numbers\n";
        if (finding.pixels * 500 < diagnosis.pixels)
            text += "  so few may be rounding, which grows behind mirrors and glass\n";
    }
    fmt::format_to(out, "  {} = {}{}{}\n", finding.quantity, finding.formula,
                   finding.where.empty() ? "" : "; see ", finding.where);
    return text;
}

std::string tree_text(const Diagnosis& diagnosis, const Scene& scene, std::int32_t x, std::int32_t y) {
    std::string text;
    auto out = std::back_inserter(text);
    std::int32_t ray = -2;
    std::uint32_t light = k_none;
    for (const DiagnosedRow& row : diagnosis.rows) {
        if (row.x != x || row.y != y) continue;
        const std::string indent(static_cast<std::size_t>(2 * row.generation), ' ');
        if (row.ray != ray) {
            if (row.ray < 0) {
                text += "the pixel\n";
            } else {
                fmt::format_to(out, "{}{} ray\n", indent, row.ray_kind);
            }
        }
        if (row.light != light && row.light < scene.lights.size())
            fmt::format_to(out, "{}  {}\n", indent, light_text(scene, row.light));
        ray = row.ray, light = row.light;
        constexpr std::string_view marks[] = {"  ", "! ", "? "};
        fmt::format_to(out, "{}{}{}{:<12} {:<38} {}\n", indent, row.light < scene.lights.size() ? "  " : "",
                       marks[static_cast<std::size_t>(row.verdict)], row.quantity, value_text(row, row.yours),
                       row.verdict == DiagnosedRow::Verdict::wrong ? value_text(row, row.expected) : "");
    }
    if (text.empty()) return fmt::format("the log has no pixel {},{}\n", x, y);
    return fmt::format(
        "pixel {},{}: the log's values; after those that are wrong (!), what they should be; ?: not "
        "judged\n{}",
        x, y, text);
}

std::string diagnosis_text(const Diagnosis& d, const Scene& scene) {
    std::string text;
    auto out = std::back_inserter(text);
    for (const std::string& sentence : d.conventions) text += sentence + "\n";
    fmt::format_to(out, "{} values of {} in {} were compared", with_commas(d.judged), counted(d.rays, "ray"),
                   counted(d.pixels, "pixel"));
    if (d.unknown > 0) fmt::format_to(out, "; {} could not be judged", with_commas(d.unknown));
    text += ".\n";
    if (d.outside > 0)
        fmt::format_to(
            out, "{} not in the picture.\n",
            d.outside == 1 ? "One pixel of the log is" : fmt::format("{} pixels of the log are", d.outside));
    if (d.findings.empty() && d.judged == 0)
        return text + "Nothing could be compared: the log has too little, or it is not of this scene.\n";
    if (d.findings.empty() && d.unknown > d.judged / 4)
        return text +
               "None of the values that could be compared differs: each follows from the scene, up to "
               "rounding.\n";
    if (d.findings.empty())
        return text + "Nothing differs: each value follows from the scene, up to rounding.\n";
    for (const DiagnosisFinding& finding : d.findings) text += "\n" + finding_text(finding, d, scene);
    const DiagnosedRow& first = d.findings.front().example;
    fmt::format_to(out, "\nAll quantities of such a pixel: --tree {},{}\n", first.x, first.y);
    return text;
}

int diagnose_command(DiagnoseArguments& arguments) {
    if (arguments.scene.files.size() < 2) throw Failure(k_usage, "expected the scene and the log");
    const std::string name = arguments.scene.files.back();
    arguments.scene.files.pop_back();
    std::optional<Size> tree;
    if (!arguments.tree.empty()) {
        std::string pair = arguments.tree;
        std::replace(pair.begin(), pair.end(), ',', 'x');
        tree = parse_size(pair);
        if (!tree)
            throw Failure(k_usage,
                          fmt::format("--tree: expected X,Y, as 320,200, found '{}'", arguments.tree));
    }
    add_settings(arguments.picture, PictureMemory::some, arguments.scene);
    LoadedScene loaded = load_scene(arguments.scene);
    std::string why;
    const std::optional<InputFile> log = InputFile::open(name, why);
    if (!log) throw Failure(k_bad_input, fmt::format("{}: {}", name, why));
    const Result<World> prepared = prepare(loaded.scene);
    add_warnings(loaded.warnings, prepared.diagnostics);
    print(loaded.warnings);
    if (!prepared) throw_failure(prepared);
    const Scene& scene = *loaded.scene;
    DiagnoseOptions options;
    options.name = name;
    options.threads = arguments.threads;
    if (tree) options.max_rows = 10'000'000;
    const Result<Diagnosis> diagnosis = diagnose(scene, *prepared, log->text(), options);
    print(diagnosis.diagnostics);
    if (!diagnosis) throw_failure(diagnosis);
    if (arguments.json) {
        print_json(diagnosis_json(*diagnosis, scene).value() + "\n");
    } else if (tree) {
        print_text(tree_text(*diagnosis, scene, static_cast<std::int32_t>(tree->width),
                             static_cast<std::int32_t>(tree->height)));
    } else {
        print_text(diagnosis_text(*diagnosis, scene));
    }
    return diagnosis->findings.empty() && diagnosis->judged > 0 ? k_done : k_bad_input;
}

}  // namespace

Run add_diagnose(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("diagnose", "Find the mistake in another ray tracer by its log");
    const auto arguments = std::make_shared<DiagnoseArguments>();
    add_scene_arguments(command, arguments->scene);
    add_picture_arguments(command, arguments->picture);
    command
        .add_option("--tree", arguments->tree,
                    "Print all quantities of a pixel of the log, beside what they should be")
        ->option_text("X,Y");
    add_threads_argument(command, arguments->threads, ". The answer does not depend on it");
    command.add_flag("--json", arguments->json, "Print the answer as JSON (docs/diagnose.md)");
    command.footer(k_diagnose_examples);
    return [arguments] { return diagnose_command(*arguments); };
}

}  // namespace glint::cli
