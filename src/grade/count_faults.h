// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which part of a rubric each fault of a program costs.
#include <optional>
#include <vector>

#include "grade/grade_by_rubric.h"
#include "grade/program_faults.h"
#include "grade/rubric_order.h"

namespace glint {

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

/// Settles points, causes and penalties of a submission. `losses`: of each of `order`.
void count_faults(const ProgramFaults& program, const Rubric& rubric, const std::vector<EqualRows>& order,
                  const std::vector<PartLosses>& losses, GradedSubmission& graded);

}  // namespace glint
