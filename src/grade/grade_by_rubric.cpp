// SPDX-License-Identifier: Apache-2.0
#include "grade/grade_by_rubric.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include "base/status.h"
#include "base/text.h"
#include "grade/part_renderer.h"

namespace glint {
namespace {

constexpr std::size_t k_batch = 32;  // pictures in memory at a time

using Wanted = std::shared_ptr<const WantedPicture>;

// A picture that does not get all points.
struct Faulty {
    std::size_t submission = 0;
    Image picture;
    Wanted judged_by;  // the picture with the faults of earlier parts; null: the plain one
};

class RubricGrader {
  public:
    RubricGrader(const Scene& scene, const std::vector<RubricRow>& rows, const std::string& rubric,
                 Submissions& submissions, const RubricOptions& options)
        : rows_(rows),
          rubric_(rubric),
          submissions_(submissions),
          options_(options),
          renderer_(scene, options.threads) {
        for (std::string& name : submissions.names())
            graded_.push_back({std::move(name), std::vector<GradedPart>(rows.size())});
        chains_.resize(graded_.size());
    }

    Result<std::vector<GradedSubmission>> run() {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const std::size_t same = first_like(k);
            if (same < k) {
                copy_part(same, k);
            } else if (Status status = grade_part(k); !status) {
                return status;
            }
            with_faults_.clear();
        }
        return std::move(graded_);
    }

  private:
    bool is_cancelled() const { return options_.cancel.is_set(); }

    // The first row with the same pictures.
    std::size_t first_like(std::size_t k) const {
        const RubricRow& row = rows_[k];
        const auto is_like = [&](const RubricRow& r) {
            return r.file == row.file && r.settings == row.settings && r.without == row.without;
        };
        return static_cast<std::size_t>(std::find_if(rows_.begin(), rows_.end(), is_like) - rows_.begin());
    }

    void copy_part(std::size_t from, std::size_t to) {
        submissions_.show_same(from, to);
        for (auto& graded : graded_) {
            GradedPart& part = graded.parts[to];
            part = graded.parts[from];
            part.points_alone = points_of(rows_[to].points, part.points_alone / rows_[from].points);
            part.score.points = points_of(rows_[to].points, part.score.factor);
        }
        report(to, static_cast<double>(graded_.size()));
    }

    Status grade_part(std::size_t k) {
        const RubricRow& row = rows_[k];
        const WantedPicture plain = renderer_.render(row);
        if (!plain.error.empty()) {
            return invalid_argument(
                fmt::format("{}:{}: part {}: {}", rubric_, row.line, quoted(row.part), plain.error));
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
                find_causes_of(group, k, plain, [&](double fraction) { report(k, start + fraction * part); });
                done += group.size();
            }
            if (is_cancelled()) return cancelled();
            report(k, static_cast<double>(last));
        }
        return {};
    }

    static double share(std::size_t whole, std::size_t part, std::size_t of) {
        return static_cast<double>(whole) * static_cast<double>(part) / static_cast<double>(of);
    }
    void report(std::size_t k, double submissions) const {
        if (!options_.progress) return;
        const auto count = static_cast<double>(std::max<std::size_t>(1, graded_.size()));
        options_.progress((static_cast<double>(k) + submissions / count) / static_cast<double>(rows_.size()));
    }

    // The picture, if its causes are to be searched.
    std::optional<Faulty> grade_one(std::size_t i, std::size_t k, const WantedPicture& plain) {
        const RubricRow& row = rows_[k];
        GradedPart& part = graded_[i].parts[k];
        HandedIn found = submissions_.find(i, row);
        part.path = std::move(found.path);
        part.error = std::move(found.error);
        if (!part.error.empty()) return std::nullopt;
        Faulty faulty{i, std::move(found.image), nullptr};
        part.error = size_fault(faulty.picture, plain.image);
        if (!part.error.empty()) {
            submissions_.show(i, k, faulty.picture, nullptr);
            return std::nullopt;
        }
        part.score = grade(faulty.picture, plain, row.points, options_.threads);
        part.points_alone = part.score.points;
        submissions_.show(i, k, faulty.picture, &plain.image);
        if (part.score.points < row.points && !chains_[i].empty()) {
            const Wanted with_faults = judge_with(chains_[i], faulty.picture, i, k, plain);
            if (with_faults && with_faults->has_scene) faulty.judged_by = with_faults;
        }
        if (part.score.points >= row.points || part.score.not_finite > 0) return std::nullopt;
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

    // Judges the part by the picture with the faults if that gives more points, or as many and more right
    // pixels, and returns that picture.
    Wanted judge_with(const FaultChain& chain, const Image& picture, std::size_t i, std::size_t k,
                      const WantedPicture& plain) {
        Wanted wanted = render_with(chain, picture, k);
        if (!wanted || !still_shows(*wanted, plain)) return nullptr;
        GradedPart& part = graded_[i].parts[k];
        const PartScore score = grade(picture, *wanted, rows_[k].points, options_.threads);
        const bool is_better = score.points > part.score.points ||
                               (score.points == part.score.points && score.share > part.score.share);
        if (!is_better) return nullptr;
        part.score = score;
        part.followed.clear();
        for (const NamedFault& fault : chain.faults) part.followed.push_back(fault.cause.name);
        return wanted;
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
            adopt(reports[n]->faults, judged_by != nullptr, pictures[n], i, k, plain);
        }
    }

    // Whether the picture is right by the row's picture with the faults.
    bool is_explained(const FaultChain& chain, const Image& picture, std::size_t k) {
        const Wanted wanted = render_with(chain, picture, k);
        return wanted && grade(picture, *wanted, 1, options_.threads).share >= k_full_share;
    }

    // Takes the faults that were found in part k for those of the student's program. A fault that has cost an
    // earlier part its points does not cost this one.
    void adopt(const std::vector<NamedFault>& faults, bool found_with_chain, const Image& picture,
               std::size_t i, std::size_t k, const WantedPicture& plain) {
        if (faults.empty()) return;
        FaultChain& chain = chains_[i];
        const FaultChain alone{faults, renderer_.lights_of(rows_[k])};
        FaultChain both = chain;
        both.faults.insert(both.faults.end(), faults.begin(), faults.end());
        const bool may_join = chain.empty() || found_with_chain ||
                              (chain.lights == alone.lights && renderer_.keeps_lights(chain));
        if (chain.empty()) both = alone;
        // NOLINTNEXTLINE(bugprone-branch-clone): what explains the picture comes before what may
        if (may_join && is_explained(both, picture, k)) {
            chain = std::move(both);
        } else if (is_explained(alone, picture, k)) {
            chain = alone;
        } else if (may_join && !faults.front().cause.perhaps) {
            chain = std::move(both);
        } else {
            return;
        }
        if (has_cost_earlier_part(alone, picture, i, k)) judge_with(chain, picture, i, k, plain);
    }

    // Whether the faults alone would have cost an earlier part all its points, which was not handed in.
    bool has_cost_earlier_part(const FaultChain& chain, const Image& picture, std::size_t i, std::size_t k) {
        for (std::size_t j = 0; j < k; ++j) {
            const GradedPart& part = graded_[i].parts[j];
            if (!part.path.empty() || part.error.empty()) continue;
            const auto [at, is_new] = costs_all_.try_emplace({j, chain.key()}, false);
            if (is_new) {
                const auto with_faults = renderer_.render(rows_[j], chain, picture);
                at->second =
                    with_faults &&
                    grade(with_faults->image, renderer_.render(rows_[j]), 1, options_.threads).points == 0;
            }
            if (at->second) return true;
        }
        return false;
    }

    const std::vector<RubricRow>& rows_;
    const std::string& rubric_;
    Submissions& submissions_;
    const RubricOptions& options_;
    const PartRenderer renderer_;
    std::vector<GradedSubmission> graded_;
    std::vector<FaultChain> chains_;             // by submission
    std::map<std::string, Wanted> with_faults_;  // of this part, by the chain's key
    std::map<std::pair<std::size_t, std::string>, bool> costs_all_;
};

}  // namespace

double GradedSubmission::total() const {
    double sum = 0;
    for (const GradedPart& part : parts) sum += part.score.points;
    return rounded_points(sum);
}

Result<std::vector<GradedSubmission>> grade_by_rubric(const Scene& scene, const std::vector<RubricRow>& rows,
                                                      const std::string& rubric, Submissions& submissions,
                                                      const RubricOptions& options) {
    return result_of([&] { return RubricGrader(scene, rows, rubric, submissions, options).run(); });
}

}  // namespace glint
