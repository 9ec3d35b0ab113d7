// SPDX-License-Identifier: Apache-2.0
// Pairs of which one is a fault of pictures.
#include <string_view>

#include "compare/geometry_search.h"
#include "compare/pair_search.h"
#include "compare/picture_causes.h"

namespace glint {
namespace {

constexpr std::size_t k_seconds = 3;  // are kept for each fault of pictures
constexpr std::size_t k_fitted_numbers = 3;
// A picture without a curve may differ this many times as much.
constexpr double k_hidden = 1.5;
constexpr std::string_view k_shift = "shifted-one-pixel";  // is a fault of the scene, too

}  // namespace

// Faults of pictures that can be undone, unless that makes the difference larger.
std::vector<PairSearch::Undone> PairSearch::undone_faults(const Trial& trial) const {
    std::vector<Undone> undone;
    const BytePicture& target = *trial.whole.target;
    const PictureView floats = view_of(target);
    const Rows rows = rows_of(coarse_);
    const PictureSource source{floats, target, reference_, trial.whole.area, rows, false};
    for (std::size_t i = 0; i < picture_causes().size(); ++i) {
        const PictureCause& cause = picture_causes()[i];
        BytePicture made = target;
        const PictureFault& undo = cause.is_own_inverse ? cause.make : cause.undo;
        if (!undo || !undo(source, made)) continue;
        Search search = coarse_search(made, trial.whole);
        // Light that is missing and a curve may hide each other.
        const double most = cause.is_own_inverse ? 1 : k_hidden;
        if (search.whole.all >= most * trial.coarse.whole.all) continue;
        const double whole = search.whole.all;
        search.whole = trial.coarse.whole;
        undone.push_back({i, std::move(search), whole});
    }
    return undone;
}

// All causes of the scene for the picture, and for the picture without a fault of pictures.
void PairSearch::try_undone(Trial& trial) const {
    trial.undone = undone_faults(trial);
    std::vector<Undone>& undone = trial.undone;
    trial.coarse.target = &trial.coarse.faulty;
    std::vector<Search*> searches = {&trial.coarse};
    for (Undone& u : undone) {
        u.search.target = &u.search.faulty;
        searches.push_back(&u.search);
    }
    for (std::size_t i = 0; i < causes_.size() && !renderer_.is_cancelled(); ++i)
        causes_.try_cause(i, searches);
    for (const Undone& u : undone) {
        const bool is_own_inverse = picture_causes()[u.row].is_own_inverse;
        if (is_own_inverse) try_two_of_pictures(u.row, u.search, trial);
        for (CauseCandidate& before : best_of(u.search, k_seconds)) {
            PairCandidate pair{std::move(before), fault_of_pictures(u.row)};
            pair.after.left = pair.before.left;
            if (!is_own_inverse) {  // what remains has been measured without the curve
                const auto made = render_pair(renderer_, coarse_, trial.coarse, pair);
                if (!made) continue;
                pair.after.left = distance(made->bytes, trial.coarse.faulty, trial.coarse.area);
            }
            add(trial, std::move(pair.before), std::move(pair.after));
        }
    }
}

// Numbers of the scene that are fitted to the picture without a flip, the one that leaves least.
void PairSearch::try_undone_geometry(Trial& trial) const {
    Undone* best = nullptr;
    for (Undone& u : trial.undone) {
        if (picture_causes()[u.row].is_own_inverse && (best == nullptr || u.whole < best->whole)) best = &u;
    }
    if (best == nullptr) return;
    Search search = best->search;
    search.target = &search.faulty;
    search.found.clear();
    const auto shares =
        shares_of_shapes(shapes_of_pixels(renderer_, coarse_), causes_.rendered()->bytes, search.faulty);
    const auto render = [&](const FaultyScene& scene) { return renderer_.render(scene, coarse_); };
    fit_geometry(geometry_causes(renderer_, shares), coarse_, renderer_.scene(), render, k_fitted_numbers,
                 search);
    for (CauseCandidate& before : best_of(search, 1)) {
        CauseCandidate after = fault_of_pictures(best->row);
        after.left = before.left;
        add(trial, std::move(before), std::move(after));
    }
}

// `undone` is the search for the picture without that fault of pictures.
void PairSearch::try_two_of_pictures(std::size_t after, const Search& undone, Trial& trial) const {
    BytePicture made = undone.faulty;
    const RenderedScene& plain = *causes_.rendered();
    const PictureSource from{plain.image,
                             plain.bytes,
                             undone.faulty,
                             undone.area,
                             undone.area.rows,
                             true,
                             &renderer_.background(coarse_)};
    for (std::size_t i = 0; i < picture_causes().size(); ++i) {
        const PictureCause& cause = picture_causes()[i];
        if (i == after || cause.freedom > 0 || cause.name == k_shift || !cause.make(from, made)) continue;
        CauseCandidate second = fault_of_pictures(after);
        second.left = distance(made, undone.faulty, undone.area);
        add(trial, fault_of_pictures(i), std::move(second));
    }
}

// A fault of pictures after each of the scene.
void PairSearch::try_pictures(Trial& trial) {
    const Search& coarse = trial.coarse;
    BytePicture made = coarse.faulty;
    for (std::size_t i = 0; i < picture_causes().size() && !renderer_.is_cancelled(); ++i) {
        const PictureCause& cause = picture_causes()[i];
        if (cause.is_own_inverse || cause.freedom > 0 || cause.name == k_shift) continue;
        Search second = coarse_search(*trial.whole.target, trial.whole);
        second.whole = coarse.whole;
        CauseCandidate after = fault_of_pictures(i);
        for (const CauseEffect& effect : effects_) {
            const PictureSource from{effect.rendered.image,
                                     effect.rendered.bytes,
                                     coarse.faulty,
                                     coarse.area,
                                     coarse.area.rows,
                                     true,
                                     &renderer_.background(coarse_)};
            if (!cause.make(from, made)) continue;
            CauseCandidate candidate = effect.candidate;
            candidate.left = distance(made, coarse.faulty, coarse.area);
            second.found.push_back(std::move(candidate));
        }
        for (CauseCandidate& before : best_of(second, k_seconds)) {
            after.left = before.left;
            add(trial, std::move(before), after);
        }
    }
}

}  // namespace glint
