// SPDX-License-Identifier: Apache-2.0
#pragma once
// The faults of a student's program.
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

}  // namespace glint
