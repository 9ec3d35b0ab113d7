// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the processes send each other. Errors of MPI itself end the job, as is its default.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::mpi {

/// This process's number, and how many there are.
int rank();
int ranks();

/// Gives all processes the bytes of rank 0.
void broadcast(std::string& bytes);

enum class Tag : int {
    tiles = 1,   ///< rank 0 to a worker: numbers of tiles to render; none: there are no more
    record = 2,  ///< a worker to rank 0: the record of a tile
    wanted = 3,  ///< a worker to rank 0: how many more tiles it can take
};

/// A message that has arrived.
struct Message {
    int from = 0;
    Tag tag = Tag::tiles;
    std::string bytes;
};

/// The next message, if one has arrived.
std::optional<Message> receive();

/// Messages on their way. The bytes are kept until they have left.
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
