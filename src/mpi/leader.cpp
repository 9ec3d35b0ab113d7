// SPDX-License-Identifier: Apache-2.0
// Rank 0: hands out tiles, renders some itself, and puts the picture together.
#include <algorithm>
#include <utility>

#include "base/status.h"
#include "journal/journal.h"
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

std::vector<std::uint32_t> all_tiles(const Crop& picture) {
    std::vector<std::uint32_t> tiles(count_tiles(picture));
    for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i] = static_cast<std::uint32_t>(i);
    return tiles;
}

// Tiles for a process. `limit`: so many may wait there from now on; 0: there are no more tiles.
struct Share {
    std::size_t limit = 0;
    std::vector<std::uint32_t> tiles;
};

// Rank 0's tiles that no process has yet.
class Pool {
  public:
    explicit Pool(std::vector<std::uint32_t> tiles) : tiles_(std::move(tiles)) {}
    std::size_t size() const { return tiles_.size(); }
    // At the end few tiles, so that no process is left with many when the others have finished.
    Share take(const Demand& demand) {
        const std::size_t left = tiles_.size() - next_;
        if (left == 0) return {};
        const std::size_t fair = left / (2 * static_cast<std::size_t>(ranks()));
        const std::size_t limit = std::min(demand.ahead, std::max(fair, demand.threads));
        const auto first = tiles_.begin() + static_cast<std::ptrdiff_t>(next_);
        const std::size_t count = std::min(left, limit - std::min(limit, demand.waiting));
        next_ += count;
        return {limit, {first, first + static_cast<std::ptrdiff_t>(count)}};
    }

  private:
    std::vector<std::uint32_t> tiles_;
    std::size_t next_ = 0;
};

class Leader {
  public:
    Leader(const World& world, const RenderOptions& options, const JournalHeader& header,
           cli::JournalFile* journal, Costs& costs)
        : header_(header),
          journal_(journal),
          costs_(costs),
          progress_(options.progress),
          pool_(journal != nullptr ? journal->missing() : all_tiles(header.picture)),
          expected_(journal != nullptr ? journal->expected() : pool_.size()),
          missing_(pool_.size()),
          supply_(options.threads),
          followers_(ranks() - 1),
          whole_(start_picture(options.threads)),
          renderer_(world, own_options(options), desk_, [this] { exchange(); }) {}

    Result<Rendering> run() {
        bool own_ended = false;
        while (missing_ > 0 || followers_ > 0) {
            renderer_.exchange();
            write_records();
            if (journal_ != nullptr) journal_->rethrow();
            if (damaged_) return failure(ErrorCode::internal, "a damaged message");
            if (renderer_.has_failed()) return renderer_.result();
            own_ended = renderer_.wait(own_ended ? std::chrono::microseconds(0) : k_pause);
            if (own_ended) std::this_thread::sleep_for(k_pause_at_end);
        }
        Result<Rendering> own = renderer_.result();
        if (!own) return own;
        write_records();
        if (journal_ != nullptr) journal_->rethrow();
        add_rays(whole_.rays, own->rays);
        whole_.isa = own->isa;
        whole_.threads = own->threads * ranks();
        return std::move(whole_);
    }

  private:
    // With pixels if they are not in the journal.
    Rendering start_picture(int threads) const {
        if (journal_ == nullptr)
            return empty_rendering(header_.layers, header_.picture, thread_count(threads));
        Rendering rendering;
        rendering.rays = journal_->rays_before();
        return rendering;
    }

    RenderOptions own_options(RenderOptions options) {
        options.on_tile = [this](const FinishedTile& tile) {
            if (journal_ != nullptr) {
                records_.add(record_bytes(tile));
            } else {
                copy_tile(tile, header_.picture, whole_);
            }
            supply_.count_finished();
            --missing_;
        };
        return options;
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
        if (progress_) progress_(static_cast<double>(expected_ - missing_) / static_cast<double>(expected_));
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
        const auto tile = parse_unchecked_record(record, header_);
        if (!tile) {
            damaged_ = true;
            return;
        }
        costs_.received_bytes += record.size();
        ++costs_.received_tiles;
        add_rays(whole_.rays, tile->rays);
        if (journal_ != nullptr) {
            records_.add(std::move(record));
        } else {
            copy_tile(*tile, header_, whole_);
        }
        --missing_;
    }

    // On the main thread only: bringing the file to the disk takes time, and tiles go on meanwhile.
    void write_records() {
        for (const std::string& record : records_.take()) journal_->append(record);
    }

    const JournalHeader& header_;
    cli::JournalFile* const journal_;
    Costs& costs_;
    const std::function<void(double)> progress_;
    Pool pool_;
    const std::size_t expected_;
    std::atomic<std::size_t> missing_;  // tiles that have not been copied, or added to records_
    Supply supply_;
    std::atomic<int> followers_;  // who have not been told that there are no more tiles
    Rendering whole_;
    Records records_;
    Inbox inbox_;
    Outbox outbox_;
    bool own_closed_ = false;
    std::atomic<bool> damaged_{false};
    Desk desk_;
    Renderer renderer_;
};

}  // namespace

Result<Rendering> lead(const World& world, const RenderOptions& options, const JournalHeader& header,
                       cli::JournalFile* journal, Costs& costs) {
    // Whether records are to have checksums, and the picture.
    std::string start = (journal != nullptr ? "1" : "0") + header_bytes(header);
    broadcast(start);
    return Leader(world, options, header, journal, costs).run();
}

void dismiss() {
    std::string nothing;
    broadcast(nothing);
}

}  // namespace glint::mpi
