// SPDX-License-Identifier: Apache-2.0
// Rank 0: hands out tiles, renders some itself, and puts the picture together.
#include <algorithm>
#include <utility>

#include "base/status.h"
#include "mpi/distribute.h"
#include "mpi/messages.h"
#include "mpi/renderer.h"
#include "mpi/supply.h"
#include "trace/film/assemble.h"

namespace glint::mpi {
namespace {

using Clock = std::chrono::steady_clock;

// Between two looks for messages when this process renders nothing more.
constexpr std::chrono::microseconds k_pause_at_end{100};

// Tiles for a process. `limit`: so many may wait there from now on; 0: there are no more tiles.
struct Share {
    std::size_t limit = 0;
    std::vector<std::uint32_t> tiles;
};

// The sink's tiles that no process has yet.
class Pool {
  public:
    explicit Pool(TileSink& sink) : sink_(sink), left_(sink.work().missing) {}
    // At the end few tiles, so that no process is left with many when the others have finished.
    Share take(const Demand& demand) {
        if (left_ == 0) return {};
        const std::size_t fair = left_ / (2 * static_cast<std::size_t>(ranks()));
        const std::size_t limit = std::min(demand.ahead, std::max(fair, demand.threads));
        const std::size_t count = std::min(left_, limit - std::min(limit, demand.waiting));
        left_ -= count;
        Share share{limit, {}};
        for (std::size_t i = 0; i < count; ++i) share.tiles.push_back(sink_.next_tile().value());
        return share;
    }

  private:
    TileSink& sink_;
    std::size_t left_;
};

class Leader {
  public:
    Leader(const World& world, const RenderOptions& options, RecordSink& sink, Costs& costs)
        : sink_(sink),
          costs_(costs),
          progress_(options.progress),
          pool_(sink),
          missing_(sink.work().missing),
          supply_(options.threads),
          followers_(ranks() - 1),
          rays_(sink.work().rays_before),
          renderer_(
              world, options, desk_, [this](const FinishedTile& tile) { receive(tile); },
              [this] { exchange(); }) {}

    Result<Rendering> run() {
        bool own_ended = false;
        while (missing_ > 0 || followers_ > 0) {
            renderer_.exchange();
            write_received();
            if (damaged_) return failure(ErrorCode::internal, "a damaged message");
            if (renderer_.has_failed()) return renderer_.result();
            own_ended = renderer_.wait(own_ended ? std::chrono::microseconds(0) : k_pause);
            if (own_ended) std::this_thread::sleep_for(k_pause_at_end);
        }
        Result<Rendering> own = renderer_.result();
        if (!own) return own;
        write_received();
        add_rays(own->rays, rays_);
        own->threads *= ranks();
        return own;
    }

  private:
    // A tile of this process.
    void receive(const FinishedTile& tile) {
        sink_.receive(tile);
        supply_.count_finished();
        --missing_;
    }

    void exchange() {
        const auto start = Clock::now();
        supply_own_threads();
        for (Message& message : inbox_.receive()) {
            if (message.tag == Tag::wanted) {
                answer(message);
            } else {
                take_in(std::move(message.bytes));
            }
        }
        const std::size_t expected = sink_.work().expected;
        if (progress_) progress_(static_cast<double>(expected - missing_) / static_cast<double>(expected));
        costs_.busy_seconds += std::chrono::duration<double>(Clock::now() - start).count();
    }

    void supply_own_threads() {
        if (own_closed_) return;
        const Demand demand = supply_.demand(desk_.waiting());
        if (demand.waiting >= demand.ahead) return;
        const Share share = pool_.take(demand);
        own_closed_ = share.limit == 0;
        if (own_closed_) {
            desk_.close();
        } else if (!share.tiles.empty()) {
            desk_.add(share.tiles);
        }
    }

    void answer(const Message& message) {
        const std::vector<std::uint32_t> numbers = to_numbers(message.bytes);
        if (numbers.size() != 3) {
            damaged_ = true;
            return;
        }
        const Share share = pool_.take({numbers[0], numbers[1], numbers[2]});
        std::vector<std::uint32_t> reply{static_cast<std::uint32_t>(share.limit)};
        reply.insert(reply.end(), share.tiles.begin(), share.tiles.end());
        if (share.limit == 0) --followers_;
        outbox_.send(message.from, Tag::tiles, to_bytes(reply));
    }

    // A record of another process.
    void take_in(std::string record) {
        const std::size_t bytes = record.size();
        const std::optional<RayCounts> rays = sink_.receive_record(std::move(record));
        if (!rays) {
            damaged_ = true;
            return;
        }
        costs_.received_bytes += bytes;
        ++costs_.received_tiles;
        add_rays(rays_, *rays);
        --missing_;
    }

    // On the main thread only: bringing the file to the disk takes time, and tiles go on meanwhile.
    void write_received() {
        sink_.write_received();
        sink_.rethrow();
    }

    RecordSink& sink_;
    Costs& costs_;
    const std::function<void(double)> progress_;
    Pool pool_;
    std::atomic<std::size_t> missing_;  // tiles that the sink has not received
    Supply supply_;
    std::atomic<int> followers_;  // who have not been told that there are no more tiles
    RayCounts rays_;              // of tiles of other processes, and of those that the sink had
    Inbox inbox_;
    Outbox outbox_;
    bool own_closed_ = false;
    std::atomic<bool> damaged_{false};
    Desk desk_;
    Renderer renderer_;
};

}  // namespace

Result<Rendering> lead(const World& world, const RenderOptions& options, const JournalHeader& header,
                       RecordSink& sink, Costs& costs) {
    // Whether records are to have checksums, and the picture.
    std::string start = (sink.needs_checksums() ? "1" : "0") + header_bytes(header);
    broadcast(start);
    return Leader(world, options, sink, costs).run();
}

void dismiss() {
    std::string nothing;
    broadcast(nothing);
}

}  // namespace glint::mpi
