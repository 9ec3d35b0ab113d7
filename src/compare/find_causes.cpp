// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "base/fp_environment.h"
#include "base/memory_limit.h"
#include "base/status.h"
#include "compare/cause_finder.h"
#include "compare/find_stored.h"
#include "compare/named_faults.h"
#include "glint/compare.h"
#include "image/levels.h"

namespace glint {
namespace {

// Bytes for each pixel: of the reference (its bytes, its edges, and what a cause makes of it), of the scene's
// picture and of that of a cause, and of causes that are tried on all pixels.
constexpr std::size_t k_reference_bytes = 7, k_scene_bytes = 30, k_all_bytes = k_scene_bytes + k_trial_bytes;
constexpr std::size_t k_memory = std::size_t{1} << 28;  // for the samples, by default

// What a picture takes that has other numbers than bytes.
std::size_t other_bytes(const StoredPicture& picture) {
    return PictureView(picture).bytes().empty() ? picture.bytes() : 0;
}

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
    if (const CauseCandidate* first = search.found_as(search.report.causes.front())) {
        add(*first);
        faults.front().cause = search.report.causes.front();  // with what it explains
    }
    return faults;
}

// The bytes of a picture, which is empty then if it has no other numbers.
BytePicture take_bytes(StoredPicture& picture, int threads) {
    if (PictureView(picture).bytes().empty()) return to_bytes(picture, threads);
    return {picture.width, picture.height, std::get<std::vector<std::uint8_t>>(std::move(picture.rgb))};
}

// An error if the search takes more than options.max_memory, which becomes the default if it is 0. held:
// bytes of numbers other than bytes.
Status check_memory(const PictureView& b, std::size_t pictures, std::size_t held, const Scene* scene,
                    CauseOptions& options) {
    const std::size_t pixels = b.size() / 3;
    if (options.max_memory == 0) {
        options.max_memory =
            k_memory + held +
            pixels * (k_reference_bytes + 3 * pictures + (scene != nullptr ? k_all_bytes : 0));
    }
    const std::size_t each = k_reference_bytes + 3 * pictures + (scene != nullptr ? k_scene_bytes : 0);
    return memory_fault(held + pixels * each, options.max_memory, "searching for causes");
}

// Ends the searches. `results` are in their order.
void report(CauseFinder& finder, std::vector<Search>& searches, std::vector<Result<FaultReport>>& results) {
    finder.find(searches);
    for (std::size_t i = 0; i < searches.size(); ++i) {
        if (searches[i].status.ok()) {
            std::vector<NamedFault> faults = named_faults(searches[i]);
            results[i] = FaultReport{std::move(searches[i].report), std::move(faults)};
        } else {
            results[i] = std::move(searches[i].status);
        }
    }
}

Result<CauseReport> causes_of(Result<FaultReport>&& found) {
    if (!found) return Status(found);
    return std::move(found->report);
}

}  // namespace

std::vector<Result<FaultReport>> find_faults(std::span<const Image> pictures, const Image& b,
                                             const Scene* scene, const CauseOptions& given) {
    std::vector<Result<FaultReport>> results(pictures.size());
    const Status status = result_of([&]() -> Status {
        const DefaultFpEnvironment environment;
        if (b.width < 1 || b.height < 1 || b.rgb.size() != std::size_t{3} * b.width * b.height)
            return invalid_argument("the reference has no pixels, or their numbers do not fit its size");
        CauseOptions options = given;
        if (Status fault = check_memory(b, pictures.size(), 0, scene, options); !fault.ok()) return fault;
        CauseFinder finder(b, to_bytes(b, options.threads), scene, options);
        std::vector<Search> searches(pictures.size());
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            if (std::string wrong = pair_fault(pictures[i], b); !wrong.empty())
                searches[i].status = invalid_argument(std::move(wrong));
            else
                searches[i] = finder.start(pictures[i], to_bytes(pictures[i], options.threads));
        }
        report(finder, searches, results);
        return {};
    });
    if (!status.ok()) {
        for (Result<FaultReport>& result : results) result = status;
    }
    return results;
}

Result<CauseReport> find_causes(StoredPicture a, StoredPicture b, const Scene* scene,
                                const CauseOptions& given) {
    return result_of([&]() -> Result<CauseReport> {
        const DefaultFpEnvironment environment;
        if (std::string wrong = pair_fault(a, b); !wrong.empty()) return invalid_argument(std::move(wrong));
        CauseOptions options = given;
        const std::size_t held = other_bytes(a) + other_bytes(b);
        if (Status fault = check_memory(b, 1, held, scene, options); !fault.ok()) return fault;
        BytePicture bytes = take_bytes(b, options.threads);
        auto finder = other_bytes(b) > 0 ? std::make_unique<CauseFinder>(b, std::move(bytes), scene, options)
                                         : std::make_unique<CauseFinder>(std::move(bytes), scene, options);
        std::vector<Search> searches;
        BytePicture bytes_of_a = take_bytes(a, options.threads);
        searches.push_back(other_bytes(a) > 0 ? finder->start(a, std::move(bytes_of_a))
                                              : finder->start(std::move(bytes_of_a)));
        a = {};
        std::vector<Result<FaultReport>> results(1);
        report(*finder, searches, results);
        return causes_of(std::move(results.front()));
    });
}

std::vector<Result<CauseReport>> find_causes(std::span<const Image> pictures, const Image& b,
                                             const Scene* scene, const CauseOptions& options) {
    std::vector<Result<CauseReport>> results;
    for (Result<FaultReport>& found : find_faults(pictures, b, scene, options))
        results.push_back(causes_of(std::move(found)));
    return results;
}

Result<CauseReport> find_causes(const Image& a, const Image& b, const Scene* scene,
                                const CauseOptions& options) {
    return std::move(find_causes({&a, 1}, b, scene, options).front());
}

}  // namespace glint
