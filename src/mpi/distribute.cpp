// SPDX-License-Identifier: Apache-2.0
#include "mpi/distribute.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "base/parallel_for.h"
#include "base/status.h"
#include "journal/journal.h"
#include "mpi/messages.h"

namespace glint::mpi {
namespace {

using Clock = std::chrono::steady_clock;

// Between two looks for messages. Much shorter than a tile takes, and long enough to leave the processor to
// the threads that render.
constexpr std::chrono::microseconds k_pause{1000};
// Seconds of work that a process asks for in advance, and the most tiles for each of its threads.
constexpr double k_ahead = 0.01;
constexpr std::size_t k_max_ahead = 64;

// Tiles that wait for the rendering threads, and records that wait to be taken from them.
class Desk {
  public:
    void add(const std::vector<std::uint32_t>& tiles) {
        const std::scoped_lock lock(mutex_);
        tiles_.insert(tiles_.end(), tiles.begin(), tiles.end());
        changed_.notify_all();
    }
    // There are no more tiles.
    void close() {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }
    std::optional<std::uint32_t> next_tile() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return closed_ || !tiles_.empty(); });
        if (tiles_.empty()) return std::nullopt;
        const std::uint32_t tile = tiles_.front();
        tiles_.pop_front();
        return tile;
    }
    std::size_t waiting() {
        const std::scoped_lock lock(mutex_);
        return tiles_.size();
    }
    void put_record(std::string record) {
        const std::scoped_lock lock(mutex_);
        records_.push_back(std::move(record));
    }
    std::vector<std::string> take_records() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(records_, {});
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::uint32_t> tiles_;
    std::vector<std::string> records_;
    bool closed_ = false;
};

// Renders what comes to the desk, in a thread beside the one that speaks with the other processes.
class Renderer {
  public:
    Renderer(const World& world, RenderOptions options, Desk& desk) : desk_(desk) {
        options.progress = {};
        options.keep_image = false;
        options.next_tile = [&desk] { return desk.next_tile(); };
        options.on_tile = [&desk](const FinishedTile& tile) { desk.put_record(record_bytes(tile)); };
        thread_ = std::thread([this, &world, options = std::move(options)] {
            result_ = render(world, options);
            ended_ = true;
        });
    }
    ~Renderer() {
        desk_.close();
        if (thread_.joinable()) thread_.join();
    }
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    bool ended() const { return ended_; }
    // Waits for the end. Call it once.
    Result<Rendering> result() {
        desk_.close();
        if (thread_.joinable()) thread_.join();
        return std::move(result_);
    }
    bool has_failed() const { return ended_ && !result_; }

  private:
    Desk& desk_;
    Result<Rendering> result_;
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

// How many tiles wait for the threads of this process: one for each, or what they render in k_ahead, so that
// cheap tiles do not run out while more are on their way.
class Supply {
  public:
    explicit Supply(const RenderOptions& options)
        : threads_(static_cast<std::size_t>(thread_count(options.threads))) {}
    void count_finished(std::size_t tiles) { finished_ += tiles; }
    std::size_t threads() const { return threads_; }
    std::size_t tiles_ahead() const {
        const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
        const double rate = seconds > 0 ? static_cast<double>(finished_) / seconds : 0;
        const auto tiles = static_cast<std::size_t>(rate * k_ahead);
        return std::clamp(tiles, threads_, k_max_ahead * threads_);
    }

  private:
    const std::size_t threads_;
    const Clock::time_point start_ = Clock::now();
    std::size_t finished_ = 0;
};

std::vector<std::uint32_t> all_tiles(const Crop& picture) {
    std::vector<std::uint32_t> tiles(count_tiles(picture));
    for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i] = static_cast<std::uint32_t>(i);
    return tiles;
}

// Rank 0's tiles that nobody has yet.
class Pool {
  public:
    explicit Pool(std::vector<std::uint32_t> tiles) : tiles_(std::move(tiles)) {}
    std::size_t size() const { return tiles_.size(); }
    // At most so many, and at the end fewer: no process is left with much when the others have finished.
    std::vector<std::uint32_t> take(std::size_t most, std::size_t least) {
        const std::size_t first = next_;
        const std::size_t fair = (tiles_.size() - next_) / (2 * static_cast<std::size_t>(ranks()));
        most = std::min(most, std::max(fair, least));
        next_ = std::min(tiles_.size(), next_ + most);
        return {tiles_.begin() + static_cast<std::ptrdiff_t>(first),
                tiles_.begin() + static_cast<std::ptrdiff_t>(next_)};
    }

  private:
    std::vector<std::uint32_t> tiles_;
    std::size_t next_ = 0;
};

}  // namespace

Result<Rendering> lead(const World& world, RenderOptions options, const JournalHeader& header,
                       cli::JournalFile* journal, Costs& costs) {
    std::string identity = header_bytes(header);
    broadcast(identity);
    Rendering whole;  // with pixels if they are not in the journal
    if (journal != nullptr) {
        whole.rays = journal->rays_before();
    } else {
        whole = empty_rendering(header);
    }
    Pool pool(journal != nullptr ? journal->missing() : all_tiles(header.picture));
    const auto expected = static_cast<double>(journal != nullptr ? journal->expected() : pool.size());
    std::size_t missing = pool.size();
    const auto progress = std::exchange(options.progress, {});
    Supply supply(options);

    const auto take_in = [&](const std::string& record) -> bool {
        const auto tile = parse_record(record, header);
        if (!tile) return false;
        add_rays(whole.rays, tile->rays);
        if (journal != nullptr) {
            journal->append(record);
        } else {
            copy_tile(*tile, header, whole);
        }
        --missing;
        if (progress) progress((expected - static_cast<double>(missing)) / expected);
        return true;
    };
    Outbox outbox;
    int followers = ranks() - 1;  // who have not been told that there are no more tiles
    Desk desk;
    Renderer renderer(world, options, desk);
    while (missing > 0 || followers > 0) {
        const auto start = Clock::now();
        bool idle = true;
        if (const std::size_t ahead = supply.tiles_ahead(); desk.waiting() < ahead) {
            const std::vector<std::uint32_t> tiles = pool.take(ahead, supply.threads());
            if (tiles.empty()) {
                desk.close();
            } else {
                desk.add(tiles);
                idle = false;
            }
        }
        for (const std::string& record : desk.take_records()) {
            if (!take_in(record)) return failure(ErrorCode::internal, "a damaged record");
            supply.count_finished(1);
            idle = false;
        }
        while (const auto message = receive()) {
            idle = false;
            if (message->tag == Tag::wanted) {
                const std::vector<std::uint32_t> wanted = to_numbers(message->bytes);
                const std::vector<std::uint32_t> tiles =
                    pool.take(wanted.empty() ? 0 : wanted.front(), supply.threads());
                followers -= tiles.empty() ? 1 : 0;
                outbox.send(message->from, Tag::tiles, to_bytes(tiles));
            } else {
                costs.received_bytes += message->bytes.size();
                ++costs.received_tiles;
                if (!take_in(message->bytes)) return failure(ErrorCode::internal, "a damaged message");
            }
        }
        if (journal != nullptr) journal->rethrow();
        if (renderer.has_failed()) return renderer.result();
        costs.busy_seconds += std::chrono::duration<double>(Clock::now() - start).count();
        if (idle) std::this_thread::sleep_for(k_pause);
    }
    Result<Rendering> own = renderer.result();
    if (!own) return own;
    whole.isa = own->isa;
    whole.threads = own->threads * ranks();
    return whole;
}

Result<Rendering> follow(const World& world, RenderOptions options, const JournalHeader& header) {
    std::string identity;
    broadcast(identity);
    if (identity.empty()) return Rendering();
    const Result<ParsedHeader> leader = parse_header(identity);
    if (!leader) return failure(ErrorCode::internal, leader.message);
    const std::string difference = header_difference(leader->header, header);
    if (!difference.empty()) {
        return invalid_argument("this process and rank 0 render different pictures: " + difference +
                                " (there: rank 0)");
    }
    Outbox outbox;
    Supply supply(options);
    Desk desk;
    Renderer renderer(world, std::move(options), desk);
    bool asked = false, closed = false;
    for (;;) {
        bool idle = true;
        const bool ended = renderer.ended();  // before the records are taken: none comes later
        for (std::string& record : desk.take_records()) {
            outbox.send(0, Tag::record, std::move(record));
            supply.count_finished(1);
            idle = false;
        }
        if (ended) break;
        const std::size_t ahead = supply.tiles_ahead();
        if (!asked && !closed && desk.waiting() < ahead) {
            outbox.send(0, Tag::wanted, to_bytes({static_cast<std::uint32_t>(ahead)}));
            asked = true;
        }
        while (const auto message = receive()) {
            const std::vector<std::uint32_t> tiles = to_numbers(message->bytes);
            asked = false;
            idle = false;
            desk.add(tiles);
            closed = tiles.empty();
            if (closed) desk.close();
        }
        if (idle) std::this_thread::sleep_for(k_pause);
    }
    return renderer.result();
}

void dismiss() {
    std::string nothing;
    broadcast(nothing);
}

}  // namespace glint::mpi
