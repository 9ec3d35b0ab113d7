// SPDX-License-Identifier: Apache-2.0
#pragma once
// Judges pictures of one row of a rubric, by the right picture and by those with faults of a program.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grade/program_faults.h"

namespace glint {

/// Shared by all submissions with equal faults.
using Wanted = std::shared_ptr<const WantedPicture>;

/// What judge() finds.
struct Judgement {
    JudgedPart part;
    Wanted wanted;                   ///< the picture with faults that it is judged by; null: the plain one
    std::optional<std::size_t> set;  ///< of these faults, in ProgramFaults::sets
    double factor = 0;  ///< of the points, also by pictures with faults that do not show the part any more
};

class PartJudge {
  public:
    /// `scene` must outlive the PartJudge.
    PartJudge(const Scene& scene, int threads) : renderer_(scene, threads), threads_(threads) {}

    /// Begins a row, which must live until the next. Its plain picture may have an error.
    const WantedPicture& begin(const RubricRow& row);

    PartScore grade_plainly(const Image& picture) const;
    /// By the picture that gives most points, and of those most right pixels: the plain one, or one with
    /// faults of the program other than `lacking`. `plain`: what grade_plainly() gives.
    Judgement judge(const ProgramFaults& program, const Image& picture, const PartScore& plain,
                    std::optional<std::size_t> lacking = std::nullopt);
    /// Whether the picture is right by the row's picture with the faults.
    bool is_explained(const FaultChain& chain, const Image& picture);
    /// The factor of the points that a picture with this fault alone would get.
    double factor_with(const ProgramFaults& program, std::size_t fault);

    const PartRenderer& renderer() const { return renderer_; }

  private:
    Wanted render_with(const FaultChain& chain, const Image& picture);
    FaultSet without(const ProgramFaults& program, FaultSet set, std::size_t fault) const;

    const PartRenderer renderer_;
    const int threads_;
    const RubricRow* row_ = nullptr;
    WantedPicture plain_;
    std::map<std::string, Wanted> with_faults_;  // by the chain's key
};

}  // namespace glint
