// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a program of several processes does in its own way when it renders.
#include <functional>

#include "cli/input_file.h"
#include "cli/journal_file.h"
#include "glint/glint.h"

namespace glint::cli {

struct RenderHooks {
    TextReader* reader = nullptr;  ///< where the scene's texts come from
    std::function<void()> loaded;  ///< called when the scene is loaded
    /// Whether this process writes the picture and prints messages. The others only help to render.
    bool is_writer = true;
    /// Renders the picture, or the tiles that the journal lacks; the journal may be null. Only the writer's
    /// result is used.
    std::function<Result<Rendering>(const World&, RenderOptions, const JournalHeader&, JournalFile*)> render;
};

}  // namespace glint::cli
