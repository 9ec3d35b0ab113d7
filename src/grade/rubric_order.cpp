// SPDX-License-Identifier: Apache-2.0
#include "grade/rubric_order.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/sort_stably.h"

namespace glint {

std::vector<EqualRows> judging_order(const std::vector<RubricRow>& rows) {
    const auto key = [&](std::size_t k) {
        const RubricRow& row = rows[k];
        return std::tie(row.points, row.part, row.file, row.settings, row.without);
    };
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    sort_stably(order, [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    std::vector<EqualRows> groups;
    for (const std::size_t k : order) {
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const EqualRows& group) {
            const RubricRow& first = rows[group.first()];
            return first.file == rows[k].file && first.settings == rows[k].settings &&
                   first.without == rows[k].without;
        });
        if (same == groups.end()) {
            groups.push_back({{k}});
        } else {
            same->rows.push_back(k);
        }
    }
    return groups;
}

}  // namespace glint
