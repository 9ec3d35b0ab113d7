// SPDX-License-Identifier: Apache-2.0
#pragma once
// The threads of this process that render. Between two tiles they exchange messages with the other processes,
// which costs less than waking another thread for it.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "glint/glint.h"
#include "output/tile_sink.h"

namespace glint::mpi {

/// Tiles that wait for the rendering threads.
class Desk {
  public:
    void add(const std::vector<std::uint32_t>& tiles);
    /// There are no more tiles.
    void close();
    /// A tile; waits a short time for one.
    std::optional<std::uint32_t> next_tile();
    std::size_t waiting();
    /// Whether all tiles have been taken, and there are no more.
    bool is_done();

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::uint32_t> tiles_;
    bool closed_ = false;
};

/// Renders what comes to the desk. It is the sink of this process's tiles: it hands them on.
class Renderer final : private TileSink {
  public:
    /// Where finished tiles go; one call at a time.
    using Receive = std::function<void(const FinishedTile&)>;
    /// `exchange` sends and takes in messages. It is called by the rendering threads and by exchange(), one
    /// call at a time. It and `receive` must not throw, and their objects must outlive the Renderer.
    Renderer(const World& world, RenderOptions options, Desk& desk, Receive receive,
             std::function<void()> exchange);
    /// Waits for the end, for which it closes the desk.
    ~Renderer() override;

    /// Exchanges messages on the calling thread.
    void exchange();
    /// Waits for the end of the render, at most so long. Returns whether it has ended.
    bool wait(std::chrono::microseconds longest);
    /// Waits for the end, for which it closes the desk. Call it once.
    Result<Rendering> result();
    bool has_failed() const { return ended_ && !result_; }

  private:
    std::optional<std::uint32_t> next_tile() override;
    void receive(const FinishedTile& tile) override { receive_(tile); }
    void join();

    Desk& desk_;
    const Receive receive_;
    const std::function<void()> exchange_;
    std::mutex exchanging_;
    std::atomic<std::chrono::steady_clock::time_point> exchanged_{};
    Result<Rendering> result_;
    std::atomic<bool> ended_{false};
    std::mutex mutex_;
    std::condition_variable end_;
    std::thread thread_;
};

}  // namespace glint::mpi
