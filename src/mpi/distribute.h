// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tiles to processes: each asks rank 0 for tiles while it still has some to render, so that it does not wait.
#include "glint/glint.h"
#include "journal/header.h"
#include "output/tile_sink.h"

namespace glint::mpi {

/// What the distribution cost rank 0.
struct Costs {
    std::uint64_t received_bytes = 0, received_tiles = 0;
    double busy_seconds = 0;  ///< in which tiles were handed out and taken in
};

/// Rank 0: hands out the tiles that the sink lacks, renders some itself, and brings all to the sink. Returns
/// and throws as render_into().
Result<Rendering> lead(const World& world, const RenderOptions& options, const JournalHeader& header,
                       RecordSink& sink, Costs& costs);

/// The others: render what rank 0 hands out until there is no more. The result is empty. Fails if this
/// process would render another picture than rank 0.
Result<Rendering> follow(const World& world, const RenderOptions& options, const JournalHeader& header);

/// Rank 0, if it has nothing to render: releases those that follow.
void dismiss();

}  // namespace glint::mpi
