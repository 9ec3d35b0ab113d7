// SPDX-License-Identifier: Apache-2.0
#include "mpi/renderer.h"

#include <utility>

namespace glint::mpi {
namespace {

using Clock = std::chrono::steady_clock;

// How long a thread without a tile waits between two looks for messages.
constexpr std::chrono::microseconds k_idle{100};
// Threads with tiles look for messages at most as often: some tiles take only microseconds.
constexpr std::chrono::microseconds k_between{300};

}  // namespace

void Desk::add(const std::vector<std::uint32_t>& tiles) {
    const std::scoped_lock lock(mutex_);
    tiles_.insert(tiles_.end(), tiles.begin(), tiles.end());
    changed_.notify_all();
}

void Desk::close() {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    changed_.notify_all();
}

std::optional<std::uint32_t> Desk::next_tile() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, k_idle, [&] { return closed_ || !tiles_.empty(); });
    if (tiles_.empty()) return std::nullopt;
    const std::uint32_t tile = tiles_.front();
    tiles_.pop_front();
    return tile;
}

std::size_t Desk::waiting() {
    const std::scoped_lock lock(mutex_);
    return tiles_.size();
}

bool Desk::is_done() {
    const std::scoped_lock lock(mutex_);
    return closed_ && tiles_.empty();
}

Renderer::Renderer(const World& world, RenderOptions options, Desk& desk, Receive receive,
                   std::function<void()> exchange)
    : TileSink(TileWork{}), desk_(desk), receive_(std::move(receive)), exchange_(std::move(exchange)) {
    options.progress = {};  // that of all processes is reported elsewhere
    thread_ = std::thread([this, &world, options = std::move(options)] {
        result_ = render_into(*this, world, options);
        const std::scoped_lock lock(mutex_);
        ended_ = true;
        end_.notify_all();
    });
}

Renderer::~Renderer() { join(); }

void Renderer::join() {
    desk_.close();
    if (thread_.joinable()) thread_.join();
}

std::optional<std::uint32_t> Renderer::next_tile() {
    for (;;) {
        if (desk_.waiting() == 0 || Clock::now() - exchanged_.load() >= k_between) {
            if (const std::unique_lock lock(exchanging_, std::try_to_lock); lock) {
                exchange_();
                exchanged_ = Clock::now();
            }
        }
        if (const auto tile = desk_.next_tile()) return tile;
        if (desk_.is_done()) return std::nullopt;
    }
}

void Renderer::exchange() {
    const std::scoped_lock lock(exchanging_);
    exchange_();
    exchanged_ = Clock::now();
}

bool Renderer::wait(std::chrono::microseconds longest) {
    std::unique_lock lock(mutex_);
    return end_.wait_for(lock, longest, [&] { return ended_.load(); });
}

Result<Rendering> Renderer::result() {
    join();
    return std::move(result_);
}

}  // namespace glint::mpi
