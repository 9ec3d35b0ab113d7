// SPDX-License-Identifier: Apache-2.0
#pragma once
// The ids of causes.
#include <string_view>
#include <vector>

namespace glint {

/// The ids of all causes that find_causes() can name, sorted.
const std::vector<std::string_view>& cause_names();

}  // namespace glint
