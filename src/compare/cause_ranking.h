// SPDX-License-Identifier: Apache-2.0
#pragma once
// The causes that have been found for a picture, and which of them are named.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "compare/byte_picture.h"
#include "compare/fitted_cause.h"
#include "compare/scene_renderer.h"
#include "glint/compare.h"

namespace glint {

struct CauseCandidate {
    Cause cause;
    double least = k_min_explained;
    int freedom = 0;     ///< PictureCause::freedom
    Distance left = {};  ///< from the picture to explain
    /// Seen in the pictures alone: the place in picture_causes(). Then `left` may be estimated by a sample of
    /// rows.
    std::optional<std::size_t> of_pictures = {};
    bool is_estimated = false;
    bool is_turn = false;       ///< PictureCause::is_turn
    bool is_strange = false;    ///< the steps of its picture are not those of the picture to explain
    int parameters = 0;         ///< numbers that are fitted to the picture
    bool is_confirmed = false;  ///< judged by all pixels
    bool is_exact = false;      ///< the difference that it leaves has no structure
    /// If it is exact and the scene gives the reference: the pixels that it does not give, wrong_pixels().
    std::optional<std::size_t> wrong = {};
    bool is_vague = false;  ///< FittedCause::is_vague, of `values`
    /// Whether its numbers are only near the right ones: not those that are fitted to bytes.
    bool is_near() const { return parameters > 0 && !(fitted && fitted->fits_bytes); }
    /// Of a scene: its place in scene_causes(); the largest number if it is none of these.
    std::size_t row = SIZE_MAX;
    MakePicture make = {};  ///< the picture of a scene with it; empty if it is of pictures
    FaultEdit edit = {};    ///< the same as a change of the scene, if it is one
    /// If its numbers are fitted: how, and the numbers.
    std::shared_ptr<const FittedCause> fitted = {};
    std::vector<double> values = {};

    void set_edit(FaultEdit put) {
        edit = put;
        make = [put = std::move(put)](const FaultyScene& base, const RenderFaulty& render) {
            FaultyScene scene = base;
            put(scene);
            return render(scene);
        };
    }
    /// Sets the numbers of `fitted`, the explanation and the change of the scene. `about`: FittedCause::text.
    void set_values(std::vector<double> numbers, bool about) {
        values = std::move(numbers);
        parameters = static_cast<int>(values.size());
        is_vague = fitted->is_vague(values);
        cause.explanation = fitted->text(values, about);
        set_edit([fitted = fitted, numbers = values](FaultyScene& scene) { fitted->put(scene, numbers); });
    }
};

/// A candidate with fitted numbers.
CauseCandidate fitted_candidate(std::shared_ptr<const FittedCause> fitted, std::vector<double> values,
                                bool about, double least);

/// One picture to explain, and what has been found about it.
struct Search {
    BytePicture faulty;
    const BytePicture* target = nullptr;  ///< what the causes are to make out of the reference
    /// The scene's own picture, if it is the reference's within little; else null.
    const BytePicture* original = nullptr;
    Area area, sample;  ///< all of the picture, and where causes are tried first
    CauseReport report;
    Status status;   ///< why there is no report
    Distance whole;  ///< what there is to explain
    std::vector<CauseCandidate> found;
    std::vector<CauseCandidate> pair;  ///< those that the search of pairs named

    /// Pixels with a difference that is no rounding, in groups: what there is to explain.
    std::size_t structure = 0;
    /// Pixels in which a byte differs at all, by more than rounding, and by more than quantisation does.
    std::size_t differing = 0, beyond_rounding = 0, beyond_faint = 0;
    bool is_on_edges = true;  ///< those beyond rounding are on edges of the reference

    bool same_view = true;      ///< picture and reference show the same things
    bool has_content = true;    ///< neither of them is one color throughout
    bool is_one_color = false;  ///< the picture is, whether the reference is or not
    /// The flip or turn after which they show the same things, if only then, and how well their steps agree.
    std::optional<Cause> turn;
    double agreement_turned = 0;

    bool is_open() const { return status.ok() && whole.all > 0; }
    /// The candidate of a cause that the report names; null if there is none.
    const CauseCandidate* found_as(const Cause& cause) const;
    /// `made` is what the candidate makes of the reference.
    void judge(const BytePicture& made, CauseCandidate candidate) {
        candidate.left = distance(made, *target, area);
        add(made, std::move(candidate));
    }
    /// The same, of a candidate whose `left` is known.
    void add(const BytePicture& made, CauseCandidate candidate);
    /// Sets what a candidate leaves of the whole picture, and whether that has structure.
    /// `is_near`: numbers of it, or of what it is paired with, are near the right ones, not the same.
    /// `numbers`: those that became the bytes `made`, or these, by `rule`.
    void confirm(const BytePicture& made, const PictureView& numbers, const ByteRule& rule,
                 CauseCandidate& candidate, bool is_near) const;
};

/// The search for causes of the same picture on a grid of pixels. `target` has all pixels; the others are the
/// grid's: the edges, which must outlive it, and the picture that becomes `target`. What is to be explained
/// becomes Search::faulty.
Search search_on(const PixelGrid& grid, const BytePicture& target, const std::vector<std::uint8_t>& edges,
                 const BytePicture& from, const Search& search);

/// What a candidate leaves, plus a part of the whole difference for each fitted number: of two that leave
/// about the same, the one with fewer of them is more likely.
double rated(const CauseCandidate& candidate, double remaining, double whole);

/// The candidates that leave least, by rated(), one of each name.
std::vector<CauseCandidate> best_of(const Search& search, std::size_t most);

/// What explains enough, the best first, one of each name. `away_from_edges` becomes
/// CauseReport::away_from_edges.
std::vector<CauseCandidate> ranked(const Search& search, bool& away_from_edges);

/// Fills in the report by what was found.
void name_causes(Search& search);

}  // namespace glint
