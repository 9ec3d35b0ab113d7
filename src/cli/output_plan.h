// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `glint render` writes. The plan is complete before rendering begins, and does not change.
#include <optional>
#include <string>
#include <vector>

#include "cli/parts.h"
#include "cli/picture_output.h"
#include "cli/render_arguments.h"
#include "journal/header.h"

namespace glint::cli {

/// The output as the arguments name it. It is checked before the scene is read, which may take long.
struct OutputRequest {
    std::string path;
    std::optional<Part> part;
    std::optional<PictureDestination> picture;  ///< none with --part
    std::optional<OutputFile> tiles;            ///< of --part
    std::optional<OutputFile> stats;
};

/// Throws Failure if nothing can be written there.
OutputRequest request_output(const RenderArguments& arguments);

/// Where finished tiles are until the output is written.
enum class TileStore {
    memory,
    strips,  ///< in the picture's file, row by row
    journal,
};

struct OutputPlan {
    std::string path;
    std::optional<PictureOutput> picture;  ///< none with --part
    std::optional<OutputFile> tiles;       ///< of --part: the journal itself is the output
    std::optional<OutputFile> stats;       ///< of --stats
    Crop area;                             ///< what is rendered, in the whole picture
    Crop written;                          ///< what is written: the area, or with keeps_size the whole
    TileStore store = TileStore::memory;
    /// Says which picture it is, where a journal or other processes are to know; otherwise empty.
    JournalHeader header;
    std::string kept_journal;  ///< that --resume goes on with; empty: a journal has no name and is not kept
    bool is_shown = false, is_quiet = false;

    /// "640x480" or "20 tiles".
    std::string size_text() const;
};

/// `layers`: what is rendered beside the picture, in this order; alpha last if the picture has it.
/// is_distributed: other processes render, too. Throws Failure if the outputs cannot hold that, or if this
/// machine has not the memory.
OutputPlan plan_output(OutputRequest request, const RenderArguments& arguments, const LoadedScene& loaded,
                       const Crop& area, const std::vector<Layer>& layers, bool is_distributed);

}  // namespace glint::cli
