// SPDX-License-Identifier: Apache-2.0
#pragma once
// What receives the finished tiles of a picture: memory, the strips of a file, a journal, or another process.
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <string>

#include "glint/render.h"

namespace glint {

/// How many tiles a sink is to have in the end, and how many of them it lacks when rendering begins.
struct TileWork {
    std::size_t expected = 0, missing = 0;
    RayCounts rays_before;  ///< traced for the tiles that it has
};

/// Receives the tiles of one picture. render_into() calls the functions in the order in which they stand
/// here, next_tile() and receive() many times. What ends the file is a matter of each sink.
class TileSink {
  public:
    explicit TileSink(const TileWork& work) : work_(work) {}
    virtual ~TileSink() = default;
    TileSink(const TileSink&) = delete;
    TileSink& operator=(const TileSink&) = delete;

    const TileWork& work() const { return work_; }

    /// The next tile to render, each that is missing once; nothing after the last one. Any number of threads
    /// may call it at the same time. It may wait for a tile that another thread renders.
    virtual std::optional<std::uint32_t> next_tile() = 0;
    /// Takes a tile, whose memory is used again when this returns. One call at a time. Throws only bad_alloc:
    /// see failed().
    virtual void receive(const FinishedTile& tile) = 0;
    /// Writes what has been received to its file, if that is not done while other tiles are rendered. One
    /// call at a time. Does not throw.
    virtual void write_received() {}

    /// Becomes true when a tile could not be kept: rendering ends, and rethrow() says why.
    const std::atomic<bool>& failed() const { return failed_; }
    void rethrow() const;

  protected:
    /// Keeps the first failure. Any thread.
    void fail(std::exception_ptr failure);

  private:
    const TileWork work_;
    std::mutex failing_;
    std::exception_ptr failure_;  // written before failed_ is set, and not after
    std::atomic<bool> failed_{false};
};

/// A sink that other processes bring tiles to. receive() and receive_record() may be called at the same time.
class RecordSink : public TileSink {
  public:
    using TileSink::TileSink;
    /// Whether receive_record() needs records with checksums.
    virtual bool needs_checksums() const = 0;
    /// Takes the record of a tile (journal/journal.h). One call at a time. Returns the rays that were traced
    /// for the tile; nothing if the record is damaged. Throws only bad_alloc.
    virtual std::optional<RayCounts> receive_record(std::string record) = 0;
};

/// Renders the tiles that the sink lacks. The Rendering has the rays of all its tiles, and no pixels; the
/// progress counts the tiles that it had; options.cancel is not used. Throws what the sink failed with.
Result<Rendering> render_into(TileSink& sink, const World& world, RenderOptions options);

}  // namespace glint
