// SPDX-License-Identifier: Apache-2.0
#include "cli/rubric_notes.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/compare_report.h"
#include "cli/grade_json.h"

namespace glint::cli {
namespace {

std::vector<std::string> each_once(const std::vector<std::string>& names) {
    std::vector<std::string> once;
    for (const std::string& name : names) {
        if (!name.empty() && std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
    }
    return once;
}

// "the mistake ambient-missing is counted in ambient, not here".
std::string followed_text(const GradedPart& part) {
    const std::vector<std::string> names = each_once(part.followed), where = each_once(part.counted_in);
    return fmt::format("the mistake{} {} {} {}, not here", names.size() == 1 ? "" : "s",
                       fmt::join(names, " and "), names.size() == 1 ? "is" : "are",
                       where.empty() ? std::string("counted once")
                                     : fmt::format("counted in {}", fmt::join(where, " and ")));
}

}  // namespace

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

std::string penalty_text(const RubricPenalty& penalty, bool with_causes) {
    if (!with_causes) return fmt::format("{} points off", points_text(penalty.points));
    return fmt::format("{} points off for {}", points_text(penalty.points), penalty.cause);
}

std::string part_note(const RubricRow& row, const GradedPart& part, bool with_causes) {
    if (!part.error.empty()) return part.error;
    std::vector<std::string> notes;
    if (part.score.not_finite > 0) notes.push_back(not_finite_text(part.score.not_finite));
    if (with_causes && !part.followed.empty())
        notes.push_back(
            fmt::format("{} (otherwise {} points)", followed_text(part), points_text(part.points_alone)));
    if (part.score.points < row.points) {
        std::string shares = share_text(part.score.share) + " of all pixels are right";
        if (!row.without.empty())
            shares +=
                fmt::format(", and {} of those that this part changes", share_text(part.score.part_share));
        notes.push_back(std::move(shares));
        if (!part.note.empty() && part.score.not_finite == 0) notes.push_back(part.note);
        if (with_causes && part.cause) {
            notes.push_back(fmt::format("{}: {}", cause_text(*part.cause), part.cause->explanation));
            for (const Cause& cause : part.then)
                notes.push_back(fmt::format("and then also {}: {}", cause_text(cause), cause.explanation));
        } else if (with_causes && part.score.not_finite == 0) {
            notes.push_back(part.remark.empty() ? "no classic cause" : part.remark);
        }
    }
    return fmt::format("{}", fmt::join(notes, "; "));
}

std::string loss_name(const GradedPart& part) {
    if (!part.error.empty()) return part.path.empty() ? "not handed in" : "not readable, or another size";
    if (part.score.not_finite > 0) return "NaN or infinite";
    return part.cause ? part.cause->name : "no classic cause";
}

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
    for (const RubricPenalty& penalty : submission.penalties)
        losses.push_back({penalty.cause, penalty.points});
    const auto most = std::max_element(losses.begin(), losses.end(),
                                       [](const Loss& a, const Loss& b) { return a.points < b.points; });
    return most == losses.end() ? Loss{} : *most;
}

}  // namespace glint::cli
