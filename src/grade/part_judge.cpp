// SPDX-License-Identifier: Apache-2.0
#include "grade/part_judge.h"

#include <algorithm>

namespace glint {

const WantedPicture& PartJudge::begin(const RubricRow& row) {
    row_ = &row;
    with_faults_.clear();
    plain_ = renderer_.render(row);
    return plain_;
}

PartScore PartJudge::grade_plainly(const Image& picture) const {
    return grade(picture, plain_, row_->points, threads_);
}

Wanted PartJudge::render_with(const FaultChain& chain, const Image& picture) {
    const auto render = [&]() -> Wanted {
        auto made = renderer_.render(*row_, chain, picture);
        return made ? std::make_shared<WantedPicture>(*std::move(made)) : nullptr;
    };
    if (chain.needs_picture()) return render();
    const auto [at, is_new] = with_faults_.try_emplace(chain.key());
    if (is_new) at->second = render();
    return at->second;
}

// The set without a fault. Those that count lights in a scene with the fault are left out with it.
FaultSet PartJudge::without(const ProgramFaults& program, FaultSet set, std::size_t fault) const {
    const auto at = std::find(set.faults.begin(), set.faults.end(), fault);
    if (at == set.faults.end()) return set;
    const bool keeps = renderer_.keeps_lights({{program.all[fault]}, set.lights});
    set.faults.erase(at, keeps ? at + 1 : set.faults.end());
    return set;
}

Judgement PartJudge::judge(const ProgramFaults& program, const Image& picture, const PartScore& plain,
                           std::optional<std::size_t> lacking) {
    Judgement best{{plain, {}}, nullptr, std::nullopt, plain.factor};
    for (std::size_t s = program.sets.size(); s-- > 0;) {
        const FaultSet set = lacking ? without(program, program.sets[s], *lacking) : program.sets[s];
        if (set.faults.empty()) continue;
        const Wanted wanted = render_with(program.chain_of(set), picture);
        if (!wanted) continue;
        const PartScore score = grade(picture, *wanted, row_->points, threads_);
        best.factor = std::max(best.factor, score.factor);
        // The faults may make the right picture nearly as empty as one that shows nothing.
        if (plain.is_empty || !still_shows(*wanted, plain_)) continue;
        const PartScore& so_far = best.part.score;
        if (score.points > so_far.points || (score.points == so_far.points && score.share > so_far.share))
            best = {{score, set.faults}, wanted, s, best.factor};
    }
    return best;
}

bool PartJudge::is_explained(const FaultChain& chain, const Image& picture) {
    const Wanted wanted = render_with(chain, picture);
    return wanted && grade(picture, *wanted, 1, threads_).share >= k_full_share;
}

double PartJudge::factor_with(const ProgramFaults& program, std::size_t fault) {
    double factor = 1;
    for (const FaultSet& set : program.sets) {
        const FaultChain alone{{program.all[fault]}, set.lights};
        if (std::find(set.faults.begin(), set.faults.end(), fault) == set.faults.end()) continue;
        if (const Wanted with = render_with(alone, plain_.image))
            factor = std::min(factor, grade(with->image, plain_, 1, threads_).factor);
    }
    return factor;
}

}  // namespace glint
