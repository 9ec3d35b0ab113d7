// SPDX-License-Identifier: Apache-2.0
#include "mpi/messages.h"

#include <mpi.h>

#include <algorithm>
#include <utility>

#include "journal/little_endian.h"

namespace glint::mpi {

int rank() {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

int ranks() {
    int size = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
}

void broadcast(std::string& bytes) {
    std::uint64_t size = bytes.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    bytes.resize(size);
    constexpr std::uint64_t step = 1 << 30;  // counts are int
    for (std::uint64_t at = 0; at < size; at += step) {
        MPI_Bcast(bytes.data() + at, static_cast<int>(std::min(step, size - at)), MPI_BYTE, 0,
                  MPI_COMM_WORLD);
    }
}

struct Inbox::Receiving {
    Message message;
    MPI_Request request = MPI_REQUEST_NULL;
};

Inbox::Inbox() = default;
Inbox::~Inbox() = default;

std::vector<Message> Inbox::receive() {
    for (;;) {
        int arrived = 0;
        MPI_Message handle = MPI_MESSAGE_NULL;
        MPI_Status status;
        MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &arrived, &handle, &status);
        if (arrived == 0) break;
        int count = 0;
        MPI_Get_count(&status, MPI_BYTE, &count);
        auto next = std::make_unique<Receiving>();
        next->message = {status.MPI_SOURCE, static_cast<Tag>(status.MPI_TAG),
                         std::string(static_cast<std::size_t>(count), '\0')};
        MPI_Imrecv(next->message.bytes.data(), count, MPI_BYTE, &handle, &next->request);
        receiving_.push_back(std::move(next));
    }
    std::vector<Message> messages;
    std::erase_if(receiving_, [&](const std::unique_ptr<Receiving>& next) {
        int done = 0;
        MPI_Test(&next->request, &done, MPI_STATUS_IGNORE);
        if (done != 0) messages.push_back(std::move(next->message));
        return done != 0;
    });
    return messages;
}

struct Outbox::Sending {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
};

Outbox::Outbox() = default;
Outbox::~Outbox() { drop_sent(true); }

void Outbox::send(int to, Tag tag, std::string bytes) {
    drop_sent(false);
    auto message = std::make_unique<Sending>();
    message->bytes = std::move(bytes);
    MPI_Isend(message->bytes.data(), static_cast<int>(message->bytes.size()), MPI_BYTE, to,
              static_cast<int>(tag), MPI_COMM_WORLD, &message->request);
    sending_.push_back(std::move(message));
}

void Outbox::drop_sent(bool wait) {
    std::erase_if(sending_, [wait](const std::unique_ptr<Sending>& message) {
        int done = 0;
        if (wait) {
            MPI_Wait(&message->request, MPI_STATUS_IGNORE);
            done = 1;
        } else {
            MPI_Test(&message->request, &done, MPI_STATUS_IGNORE);
        }
        return done != 0;
    });
}

std::string to_bytes(const std::vector<std::uint32_t>& numbers) {
    std::string bytes;
    for (const std::uint32_t number : numbers) put_u32(bytes, number);
    return bytes;
}

std::vector<std::uint32_t> to_numbers(const std::string& bytes) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4)
        numbers.push_back(get_u32(std::string_view(bytes).substr(at)));
    return numbers;
}

}  // namespace glint::mpi
