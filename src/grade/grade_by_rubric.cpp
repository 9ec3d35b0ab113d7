// SPDX-License-Identifier: Apache-2.0
#include "grade/grade_by_rubric.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/status.h"
#include "base/text.h"
#include "grade/count_faults.h"
#include "grade/part_judge.h"
#include "grade/rubric_order.h"

namespace glint {
namespace {

constexpr std::size_t k_batch = 32;     // pictures in memory at a time
constexpr double k_search_share = 0.9;  // of the progress, for the first pass

// A picture that does not get all points.
struct Faulty {
    std::size_t submission = 0;
    Image picture;
    Wanted judged_by;                // the picture with known faults; null: the plain one
    std::optional<std::size_t> set;  // of the faults
};

// Two passes over the rows, both in judging_order(). The first finds the faults of each program: a picture is
// judged by the plain one and by those with faults that are known already, and what remains is searched for
// causes. The second judges the pictures of programs with faults again, with all of them, and settles which
// part each fault costs.
class RubricGrader {
  public:
    RubricGrader(const Scene& scene, const Rubric& rubric, Submissions& submissions,
                 const RubricOptions& options)
        : rows_(rubric.rows),
          rubric_(rubric),
          submissions_(submissions),
          options_(options),
          judge_(scene, options.threads),
          order_(judging_order(rubric.rows)) {
        for (std::string& name : submissions.names())
            graded_.push_back({std::move(name), std::vector<GradedPart>(rows_.size()), {}, {}});
        programs_.resize(graded_.size());
        plain_scores_.assign(graded_.size(), std::vector<PartScore>(rows_.size()));
    }

    Result<std::vector<GradedSubmission>> run() {
        for (std::size_t n = 0; n < order_.size(); ++n) {
            if (Status status = grade_part(n); !status) return status;
        }
        if (Status status = settle(); !status) return status;
        for (const EqualRows& equal : order_) {
            for (const std::size_t row : equal.rows) copy_part(equal.first(), row);
        }
        if (options_.progress) options_.progress(1);
        return std::move(graded_);
    }

  private:
    bool is_cancelled() const { return options_.cancel.is_set(); }

    void copy_part(std::size_t from, std::size_t to) {
        if (from == to) return;
        submissions_.show_same(from, to);
        for (auto& graded : graded_) {
            GradedPart& part = graded.parts[to];
            part = graded.parts[from];
            part.points_alone = points_of(rows_[to].points, part.points_alone / rows_[from].points);
            part.score.points = points_of(rows_[to].points, part.score.factor);
        }
    }

    // ---- The first pass ----

    Status grade_part(std::size_t n) {
        const std::size_t k = order_[n].first();
        const RubricRow& row = rows_[k];
        const WantedPicture& plain = judge_.begin(row);
        if (!plain.error.empty()) {
            return invalid_argument(
                fmt::format("{}:{}: part {}: {}", rubric_.name, row.line, quoted(row.part), plain.error));
        }
        submissions_.show_wanted(k, plain.image);
        const std::size_t count = graded_.size();
        for (std::size_t first = 0; first < count; first += k_batch) {
            const std::size_t last = std::min(first + k_batch, count);
            std::map<Wanted, std::vector<Faulty>> groups;
            for (std::size_t i = first; i < last; ++i) {
                if (is_cancelled()) return cancelled();
                auto faulty = grade_one(i, k, plain);
                if (!faulty) continue;
                std::vector<Faulty>& group = groups[faulty->judged_by];
                group.push_back(*std::move(faulty));
            }
            std::size_t done = 0, all = 0;
            for (const auto& [judged_by, group] : groups) all += group.size();
            for (auto& [judged_by, group] : groups) {
                const double start = static_cast<double>(first) + share(last - first, done, all),
                             part = share(last - first, group.size(), all);
                find_causes_of(group, k, plain, [&](double fraction) { report(n, start + fraction * part); });
                done += group.size();
            }
            if (is_cancelled()) return cancelled();
            report(n, static_cast<double>(last));
        }
        return {};
    }

    static double share(std::size_t whole, std::size_t part, std::size_t of) {
        return static_cast<double>(whole) * static_cast<double>(part) / static_cast<double>(of);
    }
    void report(std::size_t n, double submissions) const {
        if (!options_.progress) return;
        const auto count = static_cast<double>(std::max<std::size_t>(1, graded_.size()));
        options_.progress(k_search_share * (static_cast<double>(n) + submissions / count) /
                          static_cast<double>(order_.size()));
    }

    // The picture, if its causes are to be searched.
    std::optional<Faulty> grade_one(std::size_t i, std::size_t k, const WantedPicture& plain) {
        const RubricRow& row = rows_[k];
        GradedPart& part = graded_[i].parts[k];
        HandedIn found = submissions_.find(i, row);
        part.path = std::move(found.path);
        part.error = std::move(found.error);
        part.note = std::move(found.note);
        if (!part.error.empty()) return std::nullopt;
        Faulty faulty{i, std::move(found.image), nullptr, std::nullopt};
        part.error = size_fault(faulty.picture, plain.image);
        if (!part.error.empty()) {
            submissions_.show(i, k, faulty.picture, nullptr);
            return std::nullopt;
        }
        plain_scores_[i][k] = part.score = judge_.grade_plainly(faulty.picture);
        part.points_alone = part.score.points;
        submissions_.show(i, k, faulty.picture, &plain.image);
        if (part.score.points >= row.points || part.score.not_finite > 0) return std::nullopt;
        const Judgement judged = judge_.judge(programs_[i], faulty.picture, plain_scores_[i][k]);
        part.score = judged.part.score;
        if (part.score.points >= row.points) return std::nullopt;
        if (judged.wanted && judged.wanted->has_scene) {
            faulty.judged_by = judged.wanted;
            faulty.set = judged.set;
        }
        return faulty;
    }

    void find_causes_of(std::vector<Faulty>& group, std::size_t k, const WantedPicture& plain,
                        const std::function<void(double)>& progress) {
        const Wanted judged_by = group.front().judged_by;
        const WantedPicture& wanted = judged_by ? *judged_by : plain;
        std::vector<Image> pictures;
        pictures.reserve(group.size());
        for (Faulty& faulty : group) pictures.push_back(std::move(faulty.picture));
        CauseOptions options;
        options.threads = options_.threads;
        options.progress = progress;
        options.cancel = options_.cancel;
        auto reports = find_faults(pictures, wanted.image, &wanted.scene, options);
        for (std::size_t n = 0; n < reports.size(); ++n) {
            if (!reports[n]) continue;
            const std::size_t i = group[n].submission;
            GradedPart& part = graded_[i].parts[k];
            if (reports[n]->report.causes.empty()) {
                part.remark = std::move(reports[n]->report.remark);
                continue;
            }
            part.cause = reports[n]->report.causes.front();
            part.then = reports[n]->report.then;
            adopt(reports[n]->faults, group[n].set, pictures[n], i, k);
        }
    }

    // Takes the faults that were found in part k, with those of a set if any, for those of the student's
    // program.
    void adopt(const std::vector<NamedFault>& faults, std::optional<std::size_t> found_with,
               const Image& picture, std::size_t i, std::size_t k) {
        if (faults.empty()) return;
        ProgramFaults program = programs_[i];
        const std::vector<bool> lights = judge_.renderer().lights_of(rows_[k]);
        std::vector<FaultSet> candidates;
        for (std::size_t s = program.sets.size(); s-- > 0;) {
            const FaultSet set = program.sets[s];
            const bool is_joinable =
                found_with ? s == *found_with
                           : set.lights == lights && judge_.renderer().keeps_lights(program.chain_of(set));
            if (is_joinable) candidates.push_back(program.joined(set, faults));
        }
        candidates.push_back(program.joined({{}, lights}, faults));
        // What explains the picture comes before what may.
        const auto explains = std::find_if(candidates.begin(), candidates.end(), [&](const FaultSet& set) {
            return judge_.is_explained(program.chain_of(set), picture);
        });
        if (explains == candidates.end() && faults.front().cause.perhaps) return;
        program.add(explains == candidates.end() ? candidates.front() : *explains);
        programs_[i] = std::move(program);
    }

    // ---- The second pass ----

    Status settle() {
        const bool has_faults =
            std::any_of(programs_.begin(), programs_.end(), [](const auto& p) { return !p.empty(); });
        if (!has_faults) return {};
        std::vector<std::vector<PartLosses>> losses(graded_.size());
        for (std::size_t n = 0; n < order_.size(); ++n) {
            const std::size_t k = order_[n].first();
            const WantedPicture& plain = judge_.begin(rows_[k]);
            for (std::size_t i = 0; i < graded_.size(); ++i) {
                if (is_cancelled()) return cancelled();
                if (!programs_[i].empty()) losses[i].push_back(losses_of(i, k, plain));
            }
            if (options_.progress)
                options_.progress(k_search_share + (1 - k_search_share) * share(1, n + 1, order_.size()));
        }
        for (std::size_t i = 0; i < graded_.size(); ++i) {
            if (!programs_[i].empty()) count_faults(programs_[i], rubric_, order_, losses[i], graded_[i]);
        }
        return {};
    }

    PartLosses losses_of(std::size_t i, std::size_t k, const WantedPicture& plain) {
        const ProgramFaults& program = programs_[i];
        PartLosses losses;
        losses.lost_factors.resize(program.all.size());
        HandedIn found;
        losses.is_handed_in = graded_[i].parts[k].error.empty();
        if (losses.is_handed_in) found = submissions_.find(i, rows_[k]);
        if (!found.error.empty() || !size_fault(found.image, plain.image).empty())
            losses.is_handed_in = false;
        if (!losses.is_handed_in) {
            for (std::size_t fault = 0; fault < program.all.size(); ++fault)
                losses.lost_factors[fault] = 1 - judge_.factor_with(program, fault);
            return losses;
        }
        const PartScore& score = plain_scores_[i][k];
        Judgement best = judge_.judge(program, found.image, score);
        for (std::size_t fault = 0; fault < program.all.size(); ++fault) {
            Judgement lacking = judge_.judge(program, found.image, score, fault);
            losses.lost_factors[fault] = best.factor - lacking.factor;
            losses.lacking.push_back(std::move(lacking.part));
        }
        losses.best = std::move(best.part);
        return losses;
    }

    const std::vector<RubricRow>& rows_;
    const Rubric& rubric_;
    Submissions& submissions_;
    const RubricOptions& options_;
    PartJudge judge_;
    const std::vector<EqualRows> order_;
    std::vector<GradedSubmission> graded_;
    std::vector<ProgramFaults> programs_;               // by submission
    std::vector<std::vector<PartScore>> plain_scores_;  // by submission and row: without any fault
};

}  // namespace

double GradedSubmission::total() const {
    double sum = 0;
    for (const GradedPart& part : parts) sum += part.score.points;
    for (const RubricPenalty& penalty : penalties) sum -= penalty.points;
    return rounded_points(std::max(sum, 0.0));
}

Result<std::vector<GradedSubmission>> grade_by_rubric(const Scene& scene, const Rubric& rubric,
                                                      Submissions& submissions,
                                                      const RubricOptions& options) {
    return result_of([&] { return RubricGrader(scene, rubric, submissions, options).run(); });
}

}  // namespace glint
