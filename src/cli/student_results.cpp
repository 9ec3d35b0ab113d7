// SPDX-License-Identifier: Apache-2.0
#include "cli/student_results.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "cli/grade_json.h"
#include "cli/html_text.h"
#include "cli/rubric_notes.h"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* k_provisional_text = "The points are provisional: a person reviews them.";
// PrairieLearn refuses more than 1 MB. The rest is for the texts.
constexpr std::size_t k_max_picture_bytes = 900'000;

std::string part_text(const RubricRow& row, const GradedPart& part, bool with_causes) {
    const std::string note = part_note(row, part, with_causes);
    return note.empty() ? "All points." : printable(note);
}

const PartPicture* picture_of(const StudentResultOptions& options, std::size_t row) {
    return options.pictures == nullptr ? nullptr : options.pictures->find(row);
}

std::string points_lost_text(const Rubric& rubric, const GradedSubmission& submission, bool with_causes) {
    const Loss most = costliest(rubric.rows, submission);
    if (most.cause.empty()) return "All parts have all their points.";
    std::string text;
    if (with_causes) {
        text = fmt::format("Most points are lost by: {} ({} of {}). ", most.cause, points_text(most.points),
                           points_text(all_points(rubric.rows)));
    }
    return text + k_provisional_text;
}

std::string summary_text(const Rubric& rubric, const GradedSubmission& submission,
                         const StudentResultOptions& options) {
    std::string text = points_lost_text(rubric, submission, options.with_causes);
    if (!options.log.empty()) text += " The log, which gives no points: " + printable(options.log) + ".";
    return text;
}

std::string html_of(const std::string& text, const PartPicture& picture) {
    std::string html =
        fmt::format("<p>{}</p><p><img alt=\"The picture\" src=\"{}\">", html_text(text), picture.picture);
    if (!picture.difference.empty()) {
        html += fmt::format(
            " <img alt=\"Its difference from the right picture, four times as bright\" src=\"{}\">",
            picture.difference);
    }
    return html + "</p>";
}

}  // namespace

std::string gradescope_results(const Rubric& rubric, const GradedSubmission& submission,
                               const StudentResultOptions& options) {
    Json json;
    if (!submission.penalties.empty()) json["score"] = submission.total();  // instead of the tests' sum
    json["output"] = summary_text(rubric, submission, options);
    json["output_format"] = "text";
    json["test_output_format"] = "text";
    json["visibility"] = options.visibility;
    json["tests"] = Json::array();
    for (std::size_t k = 0; k < rubric.rows.size(); ++k) {
        const RubricRow& row = rubric.rows[k];
        const GradedPart& part = submission.parts[k];
        const bool is_right = part.score.points >= row.points;
        const std::string text = part_text(row, part, options.with_causes);
        Json test = {{"name", row.part},
                     {"number", std::to_string(k + 1)},
                     {"score", part.score.points},
                     {"max_score", row.points},
                     {"status", is_right ? "passed" : "failed"},
                     {"output", text},
                     {"visibility", options.visibility}};
        const PartPicture* picture = picture_of(options, k);
        if (!is_right && picture != nullptr) {
            test["output"] = html_of(text, *picture);
            test["output_format"] = "html";
        }
        json["tests"].push_back(std::move(test));
    }
    for (const RubricPenalty& penalty : submission.penalties) {
        json["tests"].push_back({{"name", "penalty"},
                                 {"status", "failed"},
                                 {"output", penalty_text(penalty, options.with_causes)},
                                 {"visibility", options.visibility}});
    }
    return dumped(json);
}

std::string prairielearn_results(const Rubric& rubric, const GradedSubmission& submission,
                                 const StudentResultOptions& options) {
    const auto is_missing = [](const GradedPart& part) { return !part.error.empty(); };
    const std::vector<GradedPart>& parts = submission.parts;
    if (std::all_of(parts.begin(), parts.end(), is_missing)) {
        Json errors = Json::array();
        for (std::size_t k = 0; k < parts.size(); ++k)
            errors.push_back(printable(fmt::format("{}: {}", rubric.rows[k].part, parts[k].error)));
        return dumped({{"gradable", false}, {"format_errors", std::move(errors)}});
    }
    std::string message = summary_text(rubric, submission, options);
    for (const RubricPenalty& penalty : submission.penalties)
        message += " " + penalty_text(penalty, options.with_causes) + ".";
    Json tests = Json::array();
    std::size_t bytes = 0;
    bool has_left_out = false;
    for (std::size_t k = 0; k < rubric.rows.size(); ++k) {
        const RubricRow& row = rubric.rows[k];
        Json test = {{"name", row.part},
                     {"points", parts[k].score.points},
                     {"max_points", row.points},
                     {"message", part_text(row, parts[k], options.with_causes)}};
        const PartPicture* picture = picture_of(options, k);
        if (parts[k].score.points < row.points && picture != nullptr) {
            const std::size_t size = picture->picture.size() + picture->difference.size();
            if (bytes + size <= k_max_picture_bytes) {
                bytes += size;
                test["images"] = Json::array({{{"label", "The picture"}, {"url", picture->picture}}});
                if (!picture->difference.empty()) {
                    test["images"].push_back(
                        {{"label", "Its difference from the right picture, four times as bright"},
                         {"url", picture->difference}});
                }
            } else {
                has_left_out = true;
            }
        }
        tests.push_back(std::move(test));
    }
    if (has_left_out) message += " Some pictures are left out, because the results may have 1 MB.";
    return dumped({{"gradable", true},
                   {"score", std::clamp(submission.total() / all_points(rubric.rows), 0.0, 1.0)},
                   {"message", message},
                   {"tests", std::move(tests)}});
}

}  // namespace glint::cli
