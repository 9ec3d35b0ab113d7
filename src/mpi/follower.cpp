// SPDX-License-Identifier: Apache-2.0
// All ranks but 0: render what rank 0 hands out.
#include <algorithm>
#include <mutex>
#include <utility>

#include "base/status.h"
#include "journal/journal.h"
#include "mpi/distribute.h"
#include "mpi/messages.h"
#include "mpi/renderer.h"
#include "mpi/supply.h"

namespace glint::mpi {
namespace {

class Follower {
  public:
    Follower(const World& world, const RenderOptions& options, bool with_checksums)
        : with_checksums_(with_checksums),
          supply_(options.threads),
          renderer_(
              world, options, desk_, [this](const FinishedTile& tile) { receive(tile); },
              [this] { exchange(); }) {}

    Result<Rendering> run() {
        do {
            renderer_.exchange();
        } while (!renderer_.wait(k_pause));
        renderer_.exchange();  // sends the last records
        return renderer_.result();
    }

  private:
    void receive(const FinishedTile& tile) {
        std::string record = with_checksums_ ? record_bytes(tile) : unchecked_record_bytes(tile);
        const std::scoped_lock lock(mutex_);
        records_.push_back(std::move(record));
        supply_.count_finished();
    }

    std::vector<std::string> take_records() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(records_, {});
    }

    void exchange() {
        for (std::string& record : take_records()) outbox_.send(0, Tag::record, std::move(record));
        const Demand demand = supply_.demand(desk_.waiting());
        if (!asked_ && !closed_ && demand.waiting < std::min(demand.ahead, limit_)) {
            outbox_.send(0, Tag::wanted,
                         to_bytes({static_cast<std::uint32_t>(demand.threads),
                                   static_cast<std::uint32_t>(demand.ahead),
                                   static_cast<std::uint32_t>(demand.waiting)}));
            asked_ = true;
        }
        for (const Message& message : inbox_.receive()) {
            std::vector<std::uint32_t> tiles = to_numbers(message.bytes);
            asked_ = false;
            limit_ = tiles.empty() ? 0 : tiles.front();
            if (!tiles.empty()) tiles.erase(tiles.begin());
            if (!tiles.empty()) desk_.add(tiles);
            closed_ = limit_ == 0;
            if (closed_) desk_.close();
        }
    }

    const bool with_checksums_;
    Supply supply_;
    std::mutex mutex_;
    std::vector<std::string> records_;  // that are to leave
    Inbox inbox_;
    Outbox outbox_;
    std::size_t limit_ = k_max_ahead;
    bool asked_ = false, closed_ = false;
    Desk desk_;
    Renderer renderer_;
};

}  // namespace

Result<Rendering> follow(const World& world, const RenderOptions& options, const JournalHeader& header) {
    std::string start;
    broadcast(start);
    if (start.empty()) return Rendering();
    const Result<ParsedHeader> leader = parse_header(std::string_view(start).substr(1));
    if (!leader) return failure(ErrorCode::internal, leader.message);
    const std::string difference = header_difference(leader->header, header);
    if (!difference.empty()) {
        return invalid_argument("this process and rank 0 render different pictures: " + difference +
                                " (there: rank 0)");
    }
    return Follower(world, options, start.front() == '1').run();
}

}  // namespace glint::mpi
