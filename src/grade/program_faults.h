// SPDX-License-Identifier: Apache-2.0
#pragma once
// The faults of a student's program, and the parts of the rubric that each costs.
#include <optional>
#include <string>
#include <vector>

#include "grade/part_renderer.h"

namespace glint {

/// Faults that pictures show together.
struct FaultSet {
    std::vector<std::size_t>
        faults;                ///< indices in ProgramFaults::all, in the order in which they are applied
    std::vector<bool> lights;  ///< as FaultChain::lights
};

/// What was found in the pictures of a submission.
struct ProgramFaults {
    std::vector<NamedFault> all;
    std::vector<FaultSet> sets;  ///< one for each combination that a picture shows

    bool empty() const { return all.empty(); }
    FaultChain chain_of(const FaultSet& set) const;
    /// The set with more faults; those that are known already keep their index.
    FaultSet joined(const FaultSet& set, const std::vector<NamedFault>& more);
    void add(FaultSet set);
};

/// A part judged with some of the faults.
struct JudgedPart {
    PartScore score;
    std::vector<std::size_t> followed;  ///< these faults; none: by the plain picture
};

/// Why a part does not have its points, by fault of the program.
struct PartLosses {
    bool is_handed_in = true;
    JudgedPart best;                   ///< with all faults that help
    std::vector<JudgedPart> lacking;   ///< by fault: with all but this one
    std::vector<double> lost_factors;  ///< by fault: of the points, what is lost without it, 0 to 1
};

/// The part that each fault costs: of the parts without another fault's cost, the one that it spoils most,
/// and of equally spoiled ones the first. `parts` are in judging order; `is_free` marks the faults that cost
/// none. Nothing for a fault that spoils no part.
std::vector<std::optional<std::size_t>> parts_that_pay(const std::vector<PartLosses>& parts,
                                                       const std::vector<bool>& is_free);

}  // namespace glint
