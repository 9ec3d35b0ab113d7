// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a program of several processes does in its own way when it renders.
#include <functional>

#include "cli/input_file.h"
#include "glint/glint.h"
#include "journal/header.h"
#include "output/tile_sink.h"

namespace glint::cli {

struct RenderHooks {
    TextReader* reader = nullptr;  ///< where the scene's texts come from
    std::function<void()> loaded;  ///< called when the scene is loaded
    /// Whether this process writes the picture and prints messages. The others only help to render.
    bool is_writer = true;
    /// Renders what the sink lacks, as render_into(). Only the writer has a sink, and only its result is
    /// used.
    std::function<Result<Rendering>(const World&, RenderOptions, const JournalHeader&, RecordSink*)> render;
};

}  // namespace glint::cli
