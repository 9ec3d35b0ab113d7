// SPDX-License-Identifier: Apache-2.0
#pragma once
// Renders a picture that is larger than memory should hold.
#include "cli/strip_file.h"
#include "glint/render.h"

namespace glint::cli {

/// Renders `picture` row of tiles by row of tiles, and puts each row into the file when it is complete. The
/// memory is that of a few rows. The only layer may be alpha: the picture's, which the file then has. The
/// Rendering has no pixels. Throws Failure if the file cannot be written.
Result<Rendering> render_strips(const World& world, RenderOptions options, const Crop& picture,
                                StripFile& file);

}  // namespace glint::cli
