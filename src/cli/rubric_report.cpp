// SPDX-License-Identifier: Apache-2.0
// The results of a rubric for the teacher: a table, CSV and JSON.
#include <fmt/format.h>

#include "base/text.h"
#include "cli/diagnosis_text.h"
#include "cli/grade_json.h"
#include "cli/grade_report.h"
#include "cli/rubric_notes.h"
#include "cli/table_text.h"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

double total_alone(const GradedSubmission& submission) {
    double sum = 0;
    for (const GradedPart& part : submission.parts) sum += part.points_alone;
    return rounded_points(sum);
}

Json log_json(const LogFeedback& log) {
    Json json = {{"file", log.file}};
    if (!log.diagnosis) {
        json["error"] = log.error;
        return json;
    }
    json["text"] = feedback_text(*log.diagnosis, true);
    json["findings"] = Json::array();
    for (const DiagnosisFinding& finding : log.diagnosis->findings) {
        Json causes = Json::array();
        for (const DiagnosedCause& cause : finding.causes) causes.push_back(cause.id);
        json["findings"].push_back({{"quantity", finding.quantity},
                                    {"sure", finding.is_sure},
                                    {"causes", causes},
                                    {"pixels", finding.pixels},
                                    {"first_pixels", finding.first_pixels}});
    }
    return json;
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
        for (const RubricPenalty& penalty : s.penalties)
            notes += printable(fmt::format("{}: {}", s.name, penalty_text(penalty))) + "\n";
        rows.back().push_back(points_text(s.total()));
        const Loss most = costliest(rubric, s);
        rows.back().push_back(
            most.cause.empty() ? "" : fmt::format("{} ({})", most.cause, points_text(most.points)));
    }
    return aligned(rows, 2) + (notes.empty() ? "" : "\n" + notes) + "\n" + k_review_text + "\n";
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
        for (const RubricPenalty& penalty : s.penalties)
            notes += (notes.empty() ? "" : " | ") + penalty_text(penalty);
        cells.insert(cells.end(),
                     {fmt::format("{:.2f}", s.total()), fmt::format("{:.2f}", all_points(rubric)), notes});
        const Loss most = costliest(rubric, s);
        cells.insert(cells.end(), {most.cause, most.cause.empty() ? "" : fmt::format("{:.2f}", most.points),
                                   fmt::format("{:.2f}", total_alone(s))});
        text += csv_line(cells);
    }
    return text;
}

std::string json_table(const std::vector<RubricRow>& rubric, const std::vector<GradedSubmission>& submissions,
                       const std::vector<LogFeedback>& logs) {
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
            entry["counted_in"] = part.counted_in;
            entry["points_alone"] = part.points_alone;
            item["parts"].push_back(std::move(entry));
        }
        item["penalties"] = Json::array();
        for (const RubricPenalty& penalty : s.penalties)
            item["penalties"].push_back({{"cause", penalty.cause}, {"points", penalty.points}});
        const Loss most = costliest(rubric, s);
        item["costs_most"] =
            most.cause.empty() ? Json(nullptr) : Json{{"cause", most.cause}, {"points", most.points}};
        item["total_alone"] = total_alone(s);
        if (!logs.empty()) item["log"] = log_json(logs[json.size()]);
        json.push_back(std::move(item));
    }
    return dumped(json);
}

}  // namespace glint::cli
