// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the processes send each other. Errors of MPI itself end the job, as is its default.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glint::mpi {

/// This process's number, and how many there are.
int rank();
int ranks();

/// Gives all processes the bytes of rank 0.
void broadcast(std::string& bytes);

enum class Tag : int {
    /// Rank 0 to a worker: how many tiles may wait there (0: there are no more), then numbers of tiles.
    tiles = 1,
    /// A worker to rank 0: the record of a tile, with its checksum if rank 0's sink needs it.
    record = 2,
    /// A worker to rank 0: its threads, how many tiles are to wait there, how many do.
    wanted = 3,
};

/// A message that has arrived.
struct Message {
    int from = 0;
    Tag tag = Tag::tiles;
    std::string bytes;
};

/// Messages on their way to this process. receive() never waits for the process that sends one, which may
/// render a tile at the time.
class Inbox {
  public:
    Inbox();
    ~Inbox();
    Inbox(const Inbox&) = delete;
    Inbox& operator=(const Inbox&) = delete;
    /// Those that have arrived.
    std::vector<Message> receive();

  private:
    struct Receiving;
    std::vector<std::unique_ptr<Receiving>> receiving_;
};

/// Messages on their way to others. The bytes are kept until they have left.
class Outbox {
  public:
    Outbox();
    ~Outbox();
    Outbox(const Outbox&) = delete;
    Outbox& operator=(const Outbox&) = delete;
    void send(int to, Tag tag, std::string bytes);

  private:
    void drop_sent(bool wait);
    struct Sending;
    std::vector<std::unique_ptr<Sending>> sending_;
};

/// Whole numbers as bytes of a message, and back.
std::string to_bytes(const std::vector<std::uint32_t>& numbers);
std::vector<std::uint32_t> to_numbers(const std::string& bytes);

}  // namespace glint::mpi
