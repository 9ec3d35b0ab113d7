// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/fp_environment.h"
#include "base/status.h"
#include "compare/cause_finder.h"
#include "compare/named_faults.h"
#include "glint/compare.h"

namespace glint {
namespace {

// The candidates that the report names first.
std::vector<NamedFault> named_faults(const Search& search) {
    std::vector<NamedFault> faults;
    const auto add = [&](const CauseCandidate& c) {
        NamedFault fault{c.cause, c.edit, {}, c.of_pictures};
        if (!fault.edit) fault.make = c.make;
        faults.push_back(std::move(fault));
    };
    if (!search.pair.empty()) {
        for (const CauseCandidate& c : search.pair) add(c);
        return faults;
    }
    if (search.report.causes.empty()) return faults;
    const Cause& first = search.report.causes.front();
    const auto it = std::find_if(search.found.begin(), search.found.end(), [&](const CauseCandidate& c) {
        return c.cause.name == first.name && c.cause.explanation == first.explanation;
    });
    if (it != search.found.end()) add(*it);
    return faults;
}

}  // namespace

std::vector<Result<FaultReport>> find_faults(std::span<const Image> pictures, const Image& b,
                                             const Scene* scene, const CauseOptions& options) {
    std::vector<Result<FaultReport>> results(pictures.size());
    const Status status = result_of([&]() -> Status {
        const DefaultFpEnvironment environment;
        if (b.width < 1 || b.height < 1 || b.rgb.size() != std::size_t{3} * b.width * b.height)
            return invalid_argument("the reference has no pixels, or their numbers do not fit its size");
        CauseFinder finder(b, scene, options);
        std::vector<Search> searches;
        for (const Image& picture : pictures) searches.push_back(finder.start(picture));
        finder.find(searches);
        for (std::size_t i = 0; i < searches.size(); ++i) {
            if (searches[i].status.ok()) {
                std::vector<NamedFault> faults = named_faults(searches[i]);
                results[i] = FaultReport{std::move(searches[i].report), std::move(faults)};
            } else {
                results[i] = std::move(searches[i].status);
            }
        }
        return {};
    });
    if (!status.ok()) {
        for (Result<FaultReport>& result : results) result = status;
    }
    return results;
}

std::vector<Result<CauseReport>> find_causes(std::span<const Image> pictures, const Image& b,
                                             const Scene* scene, const CauseOptions& options) {
    std::vector<Result<CauseReport>> results;
    for (Result<FaultReport>& found : find_faults(pictures, b, scene, options)) {
        if (found)
            results.emplace_back(std::move(found->report));
        else
            results.emplace_back(Status(found));
    }
    return results;
}

Result<CauseReport> find_causes(const Image& a, const Image& b, const Scene* scene,
                                const CauseOptions& options) {
    return std::move(find_causes({&a, 1}, b, scene, options).front());
}

}  // namespace glint
