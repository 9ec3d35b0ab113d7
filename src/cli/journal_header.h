// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which picture a command renders, as a journal's header says it.
#include <vector>

#include "cli/scene_arguments.h"
#include "journal/header.h"

namespace glint::cli {

/// All that decides the pixels: the texts' hashes, the settings in force, the crop and the layers. Threads,
/// instruction set and machine are no part of it.
JournalHeader journal_header(const SceneArguments& arguments, const LoadedScene& loaded, const Crop& picture,
                             const std::vector<Layer>& layers);

}  // namespace glint::cli
