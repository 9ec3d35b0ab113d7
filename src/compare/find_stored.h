// SPDX-License-Identifier: Apache-2.0
#pragma once
// The search for causes without copies of the pictures.
#include "glint/compare.h"
#include "image/stored_picture.h"

namespace glint {

/// As find_causes() of glint/compare.h. max_memory includes the pictures.
Result<CauseReport> find_causes(StoredPicture a, StoredPicture b, const Scene* scene,
                                const CauseOptions& options);

}  // namespace glint
