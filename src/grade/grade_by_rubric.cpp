// SPDX-License-Identifier: Apache-2.0
#include "grade/grade_by_rubric.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "base/status.h"
#include "base/text.h"
#include "grade/part_renderer.h"
#include "grade/program_faults.h"
#include "grade/rubric_order.h"

namespace glint {
namespace {

constexpr std::size_t k_batch = 32;     // pictures in memory at a time
constexpr double k_search_share = 0.9;  // of the progress, for the first pass

using Wanted = std::shared_ptr<const WantedPicture>;

// A picture that does not get all points.
struct Faulty {
    std::size_t submission = 0;
    Image picture;
    Wanted judged_by;                // the picture with known faults; null: the plain one
    std::optional<std::size_t> set;  // of the faults
};

// The same, with the faults by their number in ProgramFaults::all.
struct JudgedWith {
    JudgedPart part;
    Wanted wanted;
    std::optional<std::size_t> set;
    double factor = 0;  // of the points, also by pictures that do not show the part any more
};

std::vector<Cause> all_causes(const GradedPart& part) {
    std::vector<Cause> causes;
    if (part.cause) causes.push_back(*part.cause);
    causes.insert(causes.end(), part.then.begin(), part.then.end());
    return causes;
}

bool is_named(const std::vector<Cause>& causes, const std::string& name) {
    return std::any_of(causes.begin(), causes.end(), [&](const Cause& c) { return c.name == name; });
}

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
          renderer_(scene, options.threads),
          order_(judging_order(rubric.rows)) {
        for (std::string& name : submissions.names())
            graded_.push_back({std::move(name), std::vector<GradedPart>(rows_.size()), {}});
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
        const WantedPicture plain = renderer_.render(row);
        if (!plain.error.empty()) {
            return invalid_argument(
                fmt::format("{}:{}: part {}: {}", rubric_.name, row.line, quoted(row.part), plain.error));
        }
        submissions_.show_wanted(k, plain.image);
        with_faults_.clear();
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
        if (!part.error.empty()) return std::nullopt;
        Faulty faulty{i, std::move(found.image), nullptr, std::nullopt};
        part.error = size_fault(faulty.picture, plain.image);
        if (!part.error.empty()) {
            submissions_.show(i, k, faulty.picture, nullptr);
            return std::nullopt;
        }
        plain_scores_[i][k] = part.score = grade(faulty.picture, plain, row.points, options_.threads);
        part.points_alone = part.score.points;
        submissions_.show(i, k, faulty.picture, &plain.image);
        if (part.score.points >= row.points || part.score.not_finite > 0) return std::nullopt;
        const JudgedWith judged = judge(i, k, faulty.picture, plain, std::nullopt);
        part.score = judged.part.score;
        if (part.score.points >= row.points) return std::nullopt;
        if (judged.wanted && judged.wanted->has_scene) {
            faulty.judged_by = judged.wanted;
            faulty.set = judged.set;
        }
        return faulty;
    }

    // The row's picture with the faults: the same for all students with equal faults.
    Wanted render_with(const FaultChain& chain, const Image& picture, std::size_t k) {
        const auto render = [&]() -> Wanted {
            auto made = renderer_.render(rows_[k], chain, picture);
            return made ? std::make_shared<WantedPicture>(*std::move(made)) : nullptr;
        };
        if (chain.needs_picture()) return render();
        const auto [at, is_new] = with_faults_.try_emplace(chain.key());
        if (is_new) at->second = render();
        return at->second;
    }

    // The set without a fault. Those that count lights in a scene with the fault are left out with it.
    FaultSet without(const ProgramFaults& program, FaultSet set, std::size_t fault) const {
        const auto at = std::find(set.faults.begin(), set.faults.end(), fault);
        if (at == set.faults.end()) return set;
        const bool keeps = renderer_.keeps_lights({{program.all[fault]}, set.lights});
        set.faults.erase(at, keeps ? at + 1 : set.faults.end());
        return set;
    }

    // Judges the part by the picture that gives most points, and of those most right pixels: the plain one,
    // or one with known faults other than `lacking`.
    JudgedWith judge(std::size_t i, std::size_t k, const Image& picture, const WantedPicture& plain,
                     std::optional<std::size_t> lacking) {
        const ProgramFaults& program = programs_[i];
        JudgedWith best{{plain_scores_[i][k], {}}, nullptr, std::nullopt, plain_scores_[i][k].factor};
        for (std::size_t s = program.sets.size(); s-- > 0;) {
            const FaultSet set = lacking ? without(program, program.sets[s], *lacking) : program.sets[s];
            if (set.faults.empty()) continue;
            const Wanted wanted = render_with(program.chain_of(set), picture, k);
            if (!wanted) continue;
            const PartScore score = grade(picture, *wanted, rows_[k].points, options_.threads);
            best.factor = std::max(best.factor, score.factor);
            // The faults may make the right picture nearly as empty as one that shows nothing.
            if (plain_scores_[i][k].is_empty || !still_shows(*wanted, plain)) continue;
            const PartScore& so_far = best.part.score;
            if (score.points > so_far.points || (score.points == so_far.points && score.share > so_far.share))
                best = {{score, set.faults}, wanted, s, best.factor};
        }
        return best;
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
            if (!reports[n] || reports[n]->report.causes.empty()) continue;
            const std::size_t i = group[n].submission;
            GradedPart& part = graded_[i].parts[k];
            part.cause = reports[n]->report.causes.front();
            part.then = reports[n]->report.then;
            adopt(reports[n]->faults, group[n].set, pictures[n], i, k);
        }
    }

    // Whether the picture is right by the row's picture with the faults.
    bool is_explained(const FaultChain& chain, const Image& picture, std::size_t k) {
        const Wanted wanted = render_with(chain, picture, k);
        return wanted && grade(picture, *wanted, 1, options_.threads).share >= k_full_share;
    }

    // Takes the faults that were found in part k, with those of a set if any, for those of the student's
    // program.
    void adopt(const std::vector<NamedFault>& faults, std::optional<std::size_t> found_with,
               const Image& picture, std::size_t i, std::size_t k) {
        if (faults.empty()) return;
        ProgramFaults program = programs_[i];
        const std::vector<bool> lights = renderer_.lights_of(rows_[k]);
        std::vector<FaultSet> candidates;
        for (std::size_t s = program.sets.size(); s-- > 0;) {
            const FaultSet set = program.sets[s];
            const bool is_joinable =
                found_with ? s == *found_with
                           : set.lights == lights && renderer_.keeps_lights(program.chain_of(set));
            if (is_joinable) candidates.push_back(program.joined(set, faults));
        }
        candidates.push_back(program.joined({{}, lights}, faults));
        // What explains the picture comes before what may.
        const auto explains = std::find_if(candidates.begin(), candidates.end(), [&](const FaultSet& set) {
            return is_explained(program.chain_of(set), picture, k);
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
            with_faults_.clear();
            const WantedPicture plain = renderer_.render(rows_[k]);
            for (std::size_t i = 0; i < graded_.size(); ++i) {
                if (is_cancelled()) return cancelled();
                if (!programs_[i].empty()) losses[i].push_back(losses_of(i, k, plain));
            }
            if (options_.progress)
                options_.progress(k_search_share + (1 - k_search_share) * share(1, n + 1, order_.size()));
        }
        for (std::size_t i = 0; i < graded_.size(); ++i) {
            if (!programs_[i].empty()) settle(i, losses[i]);
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
                losses.lost_factors[fault] = 1 - factor_with(program, fault, k, plain);
            return losses;
        }
        JudgedWith best = judge(i, k, found.image, plain, std::nullopt);
        for (std::size_t fault = 0; fault < program.all.size(); ++fault) {
            JudgedWith lacking = judge(i, k, found.image, plain, fault);
            losses.lost_factors[fault] = best.factor - lacking.factor;
            losses.lacking.push_back(std::move(lacking.part));
        }
        losses.best = std::move(best.part);
        return losses;
    }

    // The factor of the points that a picture with this fault alone would get.
    double factor_with(const ProgramFaults& program, std::size_t fault, std::size_t k,
                       const WantedPicture& plain) {
        double factor = 1;
        for (const FaultSet& set : program.sets) {
            const FaultChain alone{{program.all[fault]}, set.lights};
            if (std::find(set.faults.begin(), set.faults.end(), fault) == set.faults.end()) continue;
            if (const Wanted with = render_with(alone, plain.image, k))
                factor = std::min(factor, grade(with->image, plain, 1, options_.threads).factor);
        }
        return factor;
    }

    void settle(std::size_t i, const std::vector<PartLosses>& losses) {
        const ProgramFaults& program = programs_[i];
        GradedSubmission& graded = graded_[i];
        std::vector<bool> is_free(program.all.size());
        for (std::size_t fault = 0; fault < program.all.size(); ++fault) {
            const std::string& name = program.all[fault].cause.name;
            for (const RubricPenalty& penalty : rubric_.penalties) {
                if (penalty.cause != name) continue;
                is_free[fault] = true;
                const bool is_counted = std::any_of(graded.penalties.begin(), graded.penalties.end(),
                                                    [&](const RubricPenalty& p) { return p.cause == name; });
                if (!is_counted) graded.penalties.push_back(penalty);
            }
        }
        const auto pays = parts_that_pay(losses, is_free);
        const auto counted_in = [&](std::size_t fault) -> std::string {
            if (is_free[fault]) return "a penalty";
            return pays[fault] ? rows_[order_[*pays[fault]].first()].part : std::string();
        };
        for (std::size_t n = 0; n < order_.size(); ++n) {
            if (!losses[n].is_handed_in) continue;
            GradedPart& part = graded.parts[order_[n].first()];
            JudgedPart judged = losses[n].best;
            std::vector<Cause> causes;
            for (std::size_t fault = 0; fault < program.all.size(); ++fault) {
                if (pays[fault] != n) continue;
                causes.push_back(program.all[fault].cause);
                const JudgedPart& lacking = losses[n].lacking[fault];
                if (lacking.score.factor < judged.score.factor) judged = lacking;
            }
            part.score = judged.score;
            for (const std::size_t fault : judged.followed) {
                part.followed.push_back(program.all[fault].cause.name);
                part.counted_in.push_back(counted_in(fault));
            }
            name_causes(part, std::move(causes), losses[n].best.score.factor >= 1);
        }
    }

    // `paid`: the causes of the faults that the part pays for; those found in it come after them, if they are
    // of what no known fault explains.
    static void name_causes(GradedPart& part, std::vector<Cause> paid, bool is_all_explained) {
        const std::vector<Cause> found = all_causes(part);
        std::vector<Cause> causes;
        for (Cause& cause : paid) {  // with the share that it explains here, if it was found here
            const auto here = std::find_if(found.begin(), found.end(),
                                           [&](const Cause& c) { return c.name == cause.name; });
            causes.push_back(here == found.end() ? std::move(cause) : *here);
        }
        if (!is_all_explained) {
            for (const Cause& cause : found) {
                const bool is_followed =
                    std::find(part.followed.begin(), part.followed.end(), cause.name) != part.followed.end();
                if (!is_followed && !is_named(causes, cause.name)) causes.push_back(cause);
            }
            if (causes.empty()) causes = found;
        }
        part.cause.reset();
        part.then.clear();
        if (causes.empty()) return;
        part.cause = causes.front();
        part.then.assign(causes.begin() + 1, causes.end());
    }

    const std::vector<RubricRow>& rows_;
    const Rubric& rubric_;
    Submissions& submissions_;
    const RubricOptions& options_;
    const PartRenderer renderer_;
    const std::vector<EqualRows> order_;
    std::vector<GradedSubmission> graded_;
    std::vector<ProgramFaults> programs_;               // by submission
    std::vector<std::vector<PartScore>> plain_scores_;  // by submission and row: without any fault
    std::map<std::string, Wanted> with_faults_;         // of this part, by the chain's key
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
