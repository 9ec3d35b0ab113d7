// SPDX-License-Identifier: Apache-2.0
#include "grade/count_faults.h"

#include <algorithm>
#include <string>

namespace glint {
namespace {

std::vector<Cause> all_causes(const GradedPart& part) {
    std::vector<Cause> causes;
    if (part.cause) causes.push_back(*part.cause);
    causes.insert(causes.end(), part.then.begin(), part.then.end());
    return causes;
}

bool is_named(const std::vector<Cause>& causes, const std::string& name) {
    return std::any_of(causes.begin(), causes.end(), [&](const Cause& c) { return c.name == name; });
}

// `paid`: the causes of the faults that the part pays for; those found in it come after them, if they are
// of what no known fault explains.
void name_causes(GradedPart& part, const std::vector<Cause>& paid, bool is_all_explained) {
    const std::vector<Cause> found = all_causes(part);
    std::vector<Cause> causes;
    for (const Cause& cause : paid) {  // with the share that it explains here, if it was found here
        const auto here =
            std::find_if(found.begin(), found.end(), [&](const Cause& c) { return c.name == cause.name; });
        causes.push_back(here == found.end() ? cause : *here);
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

}  // namespace

std::vector<std::optional<std::size_t>> parts_that_pay(const std::vector<PartLosses>& parts,
                                                       const std::vector<bool>& is_free) {
    std::vector<std::optional<std::size_t>> pays(is_free.size());
    std::vector<bool> is_taken(parts.size());
    for (std::size_t fault = 0; fault < is_free.size(); ++fault) {
        if (is_free[fault]) continue;
        // A part that pays for another fault only if no other part is spoiled.
        for (const bool of_taken : {false, true}) {
            if (pays[fault]) break;
            double most = 0;
            for (std::size_t k = 0; k < parts.size(); ++k) {
                if (is_taken[k] != of_taken || !(parts[k].lost_factors[fault] > most)) continue;
                most = parts[k].lost_factors[fault];
                pays[fault] = k;
            }
        }
        if (pays[fault]) is_taken[*pays[fault]] = true;
    }
    return pays;
}

void count_faults(const ProgramFaults& program, const Rubric& rubric, const std::vector<EqualRows>& order,
                  const std::vector<PartLosses>& losses, GradedSubmission& graded) {
    for (const NamedFault& fault : program.all) graded.faults.push_back(fault.cause);
    std::vector<bool> is_free(program.all.size());
    for (std::size_t fault = 0; fault < program.all.size(); ++fault) {
        const std::string& name = program.all[fault].cause.name;
        for (const RubricPenalty& penalty : rubric.penalties) {
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
        return pays[fault] ? rubric.rows[order[*pays[fault]].first()].part : std::string();
    };
    for (std::size_t n = 0; n < order.size(); ++n) {
        if (!losses[n].is_handed_in) continue;
        GradedPart& part = graded.parts[order[n].first()];
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
        name_causes(part, causes, losses[n].best.score.factor >= 1);
    }
}

}  // namespace glint
