// SPDX-License-Identifier: Apache-2.0
#include "shape_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace glint::python {
namespace {

// If more than 1 / k_few of the shapes have changed, the World is prepared anew, as by splice_shapes().
constexpr std::size_t k_few = 8;

}  // namespace

void ShapeHistory::add(std::size_t count) {
    if (is_sealed_ || steps_.empty() || !steps_.back().removed.empty())
        steps_.push_back({version_, 0, {}, 0});
    is_sealed_ = false;
    steps_.back().added += count;
    steps_.back().to = ++version_;
}

void ShapeHistory::remove(std::vector<std::uint32_t> numbers) {
    is_sealed_ = false;
    const std::uint64_t from = version_++;
    steps_.push_back({from, version_, std::move(numbers), 0});
}

void ShapeHistory::forget(std::uint64_t version, std::size_t shapes) {
    std::erase_if(steps_, [&](const Step& step) { return step.to <= version; });
    std::size_t changed = 0;
    for (const Step& step : steps_) changed += step.removed.size() + step.added;
    if (changed * k_few > shapes) steps_.clear();
}

std::optional<ShapeHistory::Change> ShapeHistory::since(std::uint64_t version, std::size_t shapes) const {
    Change change;
    if (version == version_) return change;
    const auto first =
        std::find_if(steps_.begin(), steps_.end(), [&](const Step& step) { return step.from == version; });
    if (first == steps_.end()) return std::nullopt;
    std::size_t kept = shapes;  // of the old list; the others were added
    for (auto step = first; step != steps_.end(); ++step) {
        change.added += step->added;
        std::vector<std::uint32_t> old, both;  // numbers of the old list
        std::size_t before = 0;                // shapes that were removed earlier
        for (const std::uint32_t number : step->removed) {
            if (number >= kept) {
                --change.added;
                continue;
            }
            while (before < change.removed.size() && change.removed[before] <= number + before) ++before;
            old.push_back(static_cast<std::uint32_t>(number + before));
        }
        kept -= old.size();
        std::merge(old.begin(), old.end(), change.removed.begin(), change.removed.end(),
                   std::back_inserter(both));
        change.removed = std::move(both);
    }
    return change;
}

}  // namespace glint::python
