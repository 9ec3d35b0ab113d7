// SPDX-License-Identifier: Apache-2.0
#include "grade/program_faults.h"

#include <algorithm>

namespace glint {

FaultChain ProgramFaults::chain_of(const FaultSet& set) const {
    FaultChain chain;
    for (const std::size_t fault : set.faults) chain.faults.push_back(all[fault]);
    chain.lights = set.lights;
    return chain;
}

FaultSet ProgramFaults::joined(const FaultSet& set, const std::vector<NamedFault>& more) {
    FaultSet both = set;
    for (const NamedFault& fault : more) {
        const auto known = std::find_if(all.begin(), all.end(), [&](const NamedFault& f) {
            return f.cause.name == fault.cause.name && f.cause.explanation == fault.cause.explanation;
        });
        const auto index = static_cast<std::size_t>(known - all.begin());
        if (known == all.end()) all.push_back(fault);
        if (std::find(both.faults.begin(), both.faults.end(), index) == both.faults.end())
            both.faults.push_back(index);
    }
    return both;
}

void ProgramFaults::add(FaultSet set) {
    const bool is_known = std::any_of(sets.begin(), sets.end(), [&](const FaultSet& s) {
        return s.faults == set.faults && s.lights == set.lights;
    });
    if (!is_known) sets.push_back(std::move(set));
}

}  // namespace glint
