// SPDX-License-Identifier: Apache-2.0
// The results of a rubric: a table, CSV, JSON, and Gradescope's results.json.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "cli/compare_report.h"
#include "cli/grade_json.h"
#include "cli/grade_report.h"
#include "cli/table_text.h"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string points_text(double points) {
    std::string text = fmt::format("{:.2f}", points);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

double all_points(const std::vector<RubricRow>& rows) {
    double sum = 0;
    for (const RubricRow& row : rows) sum += row.points;
    return sum;
}

// "the mistake ambient-missing of an earlier part is", each name once.
std::string mistakes_text(const std::vector<std::string>& names) {
    std::vector<std::string_view> once;
    for (const std::string& name : names) {
        if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
    }
    const bool is_one = once.size() == 1;
    return fmt::format("the mistake{} {} of {} {}", is_one ? "" : "s", fmt::join(once, " and "),
                       is_one ? "an earlier part" : "earlier parts", is_one ? "is" : "are");
}

// The reason why a part does not have all its points, and whether it has pixels without a value; empty if
// there is nothing to report.
std::string part_note(const RubricRow& row, const GradedPart& part) {
    if (!part.error.empty()) return part.error;
    std::vector<std::string> notes;
    if (part.score.not_finite > 0) notes.push_back(not_finite_text(part.score.not_finite));
    if (!part.followed.empty())
        notes.push_back(fmt::format("{} not counted again (otherwise {} points)",
                                    mistakes_text(part.followed), points_text(part.points_alone)));
    if (part.score.points < row.points) {
        std::string shares = share_text(part.score.share) + " of all pixels are right";
        if (!row.without.empty())
            shares +=
                fmt::format(", and {} of those that this part changes", share_text(part.score.part_share));
        notes.push_back(std::move(shares));
        if (part.cause) {
            notes.push_back(fmt::format("{}: {}", cause_text(*part.cause), part.cause->explanation));
            for (const Cause& cause : part.then)
                notes.push_back(fmt::format("and then also {}: {}", cause_text(cause), cause.explanation));
        } else if (part.score.not_finite == 0) {
            notes.emplace_back("no classic cause");
        }
    }
    return fmt::format("{}", fmt::join(notes, "; "));
}

// What a lost point is counted under.
std::string loss_name(const GradedPart& part) {
    if (!part.error.empty()) return part.path.empty() ? "not handed in" : "not readable";
    if (part.score.not_finite > 0) return "NaN or infinite";
    return part.cause ? part.cause->name : "no classic cause";
}

struct Loss {
    std::string cause;
    double points = 0;
};

// The cause that costs most points; of equal ones the first. None if the submission has all points.
Loss costliest(const std::vector<RubricRow>& rubric, const GradedSubmission& submission) {
    std::vector<Loss> losses;
    for (std::size_t k = 0; k < rubric.size(); ++k) {
        const double lost = rubric[k].points - submission.parts[k].score.points;
        if (!(lost > 0)) continue;
        const std::string name = loss_name(submission.parts[k]);
        auto at = std::find_if(losses.begin(), losses.end(), [&](const Loss& l) { return l.cause == name; });
        if (at == losses.end()) at = losses.insert(losses.end(), {name, 0});
        at->points += lost;
    }
    const auto most = std::max_element(losses.begin(), losses.end(),
                                       [](const Loss& a, const Loss& b) { return a.points < b.points; });
    return most == losses.end() ? Loss{} : *most;
}

double total_alone(const GradedSubmission& submission) {
    double sum = 0;
    for (const GradedPart& part : submission.parts) sum += part.points_alone;
    return rounded_points(sum);
}

}  // namespace

std::string text_table(const std::vector<RubricRow>& rubric,
                       const std::vector<GradedSubmission>& submissions) {
    std::vector<std::vector<std::string>> rows = {{"#", "submission"}, {"", "of"}};
    for (const RubricRow& row : rubric) {
        rows[0].push_back(row.part);
        rows[1].push_back(points_text(row.points));
    }
    rows[0].insert(rows[0].end(), {"total", "costs most"});
    rows[1].insert(rows[1].end(), {points_text(all_points(rubric)), ""});
    std::string notes;
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        const GradedSubmission& s = submissions[i];
        rows.push_back({std::to_string(i + 1), s.name});
        for (std::size_t k = 0; k < rubric.size(); ++k) {
            rows.back().push_back(points_text(s.parts[k].score.points));
            const std::string note = part_note(rubric[k], s.parts[k]);
            if (!note.empty())
                notes += printable(fmt::format("{}, {}: {}", s.name, rubric[k].part, note)) + "\n";
        }
        rows.back().push_back(points_text(s.total()));
        const Loss most = costliest(rubric, s);
        rows.back().push_back(
            most.cause.empty() ? "" : fmt::format("{} ({})", most.cause, points_text(most.points)));
    }
    return aligned(rows, 2) + (notes.empty() ? "" : "\n" + notes);
}

std::string csv_table(const std::vector<RubricRow>& rubric,
                      const std::vector<GradedSubmission>& submissions) {
    std::vector<std::string> head = {"name"};
    for (const RubricRow& row : rubric) head.push_back(row.part);
    head.insert(head.end(), {"total", "of", "notes", "costs_most", "points_lost", "total_alone"});
    std::string text = csv_line(head);
    for (const GradedSubmission& s : submissions) {
        std::vector<std::string> cells = {s.name};
        std::string notes;
        for (std::size_t k = 0; k < rubric.size(); ++k) {
            cells.push_back(fmt::format("{:.2f}", s.parts[k].score.points));
            const std::string note = part_note(rubric[k], s.parts[k]);
            if (!note.empty())
                notes += fmt::format("{}{}: {}", notes.empty() ? "" : " | ", rubric[k].part, note);
        }
        cells.insert(cells.end(),
                     {fmt::format("{:.2f}", s.total()), fmt::format("{:.2f}", all_points(rubric)), notes});
        const Loss most = costliest(rubric, s);
        cells.insert(cells.end(), {most.cause, most.cause.empty() ? "" : fmt::format("{:.2f}", most.points),
                                   fmt::format("{:.2f}", total_alone(s))});
        text += csv_line(cells);
    }
    return text;
}

std::string json_table(const std::vector<RubricRow>& rubric,
                       const std::vector<GradedSubmission>& submissions) {
    Json json = Json::array();
    for (const GradedSubmission& s : submissions) {
        Json item = {
            {"name", s.name}, {"total", s.total()}, {"of", all_points(rubric)}, {"parts", Json::array()}};
        for (std::size_t k = 0; k < rubric.size(); ++k) {
            const GradedPart& part = s.parts[k];
            Json entry = {{"part", rubric[k].part},
                          {"points", part.score.points},
                          {"of", rubric[k].points},
                          {"file", part.path}};
            if (!part.error.empty()) {
                entry["error"] = part.error;
            } else {
                entry["not_finite"] = part.score.not_finite;
                entry["share"] = part.score.share;
                entry["part_share"] = part.score.part_share;
            }
            entry["cause"] = part.cause ? cause_json(*part.cause) : Json(nullptr);
            entry["then"] = Json::array();
            for (const Cause& cause : part.then) entry["then"].push_back(cause_json(cause));
            entry["followed"] = part.followed;
            entry["points_alone"] = part.points_alone;
            item["parts"].push_back(std::move(entry));
        }
        const Loss most = costliest(rubric, s);
        item["costs_most"] =
            most.cause.empty() ? Json(nullptr) : Json{{"cause", most.cause}, {"points", most.points}};
        item["total_alone"] = total_alone(s);
        json.push_back(std::move(item));
    }
    return dumped(json);
}

// https://gradescope-autograders.readthedocs.io/en/latest/specs/, "Output format".
std::string gradescope_results(const std::vector<RubricRow>& rubric, const GradedSubmission& submission) {
    const Loss most = costliest(rubric, submission);
    Json json = {{"output", most.cause.empty()
                                ? std::string("All parts have all their points.")
                                : fmt::format("Most points are lost by: {} ({} of {}).", most.cause,
                                              points_text(most.points), points_text(all_points(rubric)))},
                 {"output_format", "text"},
                 {"test_output_format", "text"},
                 {"visibility", "visible"},
                 {"tests", Json::array()}};
    for (std::size_t k = 0; k < rubric.size(); ++k) {
        const GradedPart& part = submission.parts[k];
        const std::string note = part_note(rubric[k], part);
        json["tests"].push_back({{"name", rubric[k].part},
                                 {"number", std::to_string(k + 1)},
                                 {"score", part.score.points},
                                 {"max_score", rubric[k].points},
                                 {"status", part.score.points >= rubric[k].points ? "passed" : "failed"},
                                 {"output", note.empty() ? "All points." : printable(note)},
                                 {"visibility", "visible"}});
    }
    return dumped(json);
}

}  // namespace glint::cli
