// SPDX-License-Identifier: Apache-2.0
#include "cli/journal_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/output_file.h"
#include "trace/film/assemble.h"

namespace glint::cli {
namespace {

constexpr std::chrono::seconds k_sync_interval{5};

}  // namespace

JournalFile::JournalFile(std::string path, const JournalHeader& header)
    : path_(std::move(path)), header_(header), synced_(std::chrono::steady_clock::now()) {}

JournalFile::~JournalFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (unfinished_) ::unlink(path_.c_str());
}

void JournalFile::fail(int error) const {
    throw Failure(k_bad_input,
                  fmt::format("cannot write the journal {}: {}", glint::quoted(path_), std::strerror(error)));
}

void JournalFile::lock() {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    if (errno == EWOULDBLOCK)
        throw Failure(k_bad_input,
                      fmt::format("the journal {} is in use by another process", glint::quoted(path_)));
    fail(errno);
}

std::unique_ptr<JournalFile> JournalFile::resume(const std::string& path, const JournalHeader& header) {
    std::unique_ptr<JournalFile> file(new JournalFile(path, header));
    for (;;) {
        file->descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (file->descriptor_ < 0) file->fail(errno);
        file->lock();
        // The process that had the lock may have finished and removed the file since it was opened here.
        struct stat about {};
        if (::fstat(file->descriptor_, &about) != 0) file->fail(errno);
        if (about.st_nlink > 0) break;
        ::close(std::exchange(file->descriptor_, -1));
    }
    file->start();
    return file;
}

std::unique_ptr<JournalFile> JournalFile::begin(const std::string& target, const JournalHeader& header) {
    std::unique_ptr<JournalFile> file(new JournalFile(temporary_beside(target), header));
    file->unfinished_.emplace(file->path_);
    file->descriptor_ = ::open(file->path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file->descriptor_ < 0) file->fail(errno);
    file->lock();
    file->start();
    return file;
}

// Checks what the file has, and takes note of its tiles. Returns how many bytes of it are kept.
std::size_t JournalFile::read_tiles() {
    std::string why;
    std::optional<InputFile> file = InputFile::open_own(path_, why);
    if (!file) throw Failure(k_bad_input, fmt::format("the journal {}: {}", glint::quoted(path_), why));
    // A process may have been killed while it wrote the header.
    if (header_bytes(header_).starts_with(file->text())) return 0;
    const auto refuse = [&](const std::string& reason) {
        throw Failure(
            k_bad_input,
            fmt::format("the journal {} cannot be resumed: {}; remove it, or choose another --output",
                        glint::quoted(path_), reason));
    };
    const Result<JournalInput> input = read_journal(path_, std::move(*file));
    if (!input) refuse(input.message);
    const Journal& journal = input->journal;
    why = header_difference(journal.header, header_);
    if (why.empty() && (journal.header.part != header_.part || journal.header.parts != header_.parts)) {
        why = fmt::format("it is of part {}/{}, and this is part {}/{}", journal.header.part,
                          journal.header.parts, header_.part, header_.parts);
    }
    if (!why.empty()) refuse(why);
    std::vector<bool> there(count_tiles(header_.picture));
    for (const JournalTile& tile : journal.tiles) {
        if (!there[tile.number]) add_rays(rays_before_, tile.rays);
        there[tile.number] = true;
    }
    std::erase_if(missing_, [&](std::uint32_t tile) { return there[tile]; });
    return journal.size;
}

// Cuts off a record that is not whole, and writes the header if there is none.
void JournalFile::start() {
    struct stat about {};
    if (::fstat(descriptor_, &about) != 0) fail(errno);
    if (!S_ISREG(about.st_mode))
        throw Failure(k_bad_input, fmt::format("the journal {} is no regular file", glint::quoted(path_)));
    missing_ = tiles_of_part(header_);
    expected_ = missing_.size();
    const std::size_t kept = about.st_size > 0 ? read_tiles() : 0;
    if (::ftruncate(descriptor_, static_cast<off_t>(kept)) != 0 ||
        ::lseek(descriptor_, static_cast<off_t>(kept), SEEK_SET) < 0)
        fail(errno);
    if (kept > 0) return;
    write(header_bytes(header_));
    sync();
    sync_folder(folder_of(path_));
}

void JournalFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

void JournalFile::sync() {
    if (::fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(errno);  // not all can
    synced_ = std::chrono::steady_clock::now();
}

void JournalFile::append(std::string_view record) {
    write(record);
    if (std::chrono::steady_clock::now() - synced_ >= k_sync_interval) sync();
}

JournalInput JournalFile::read() const {
    std::string why;
    std::optional<InputFile> file = InputFile::open_own(path_, why);
    if (!file) throw Failure(k_bad_input, fmt::format("the journal {}: {}", glint::quoted(path_), why));
    Result<JournalInput> input = read_journal(path_, std::move(*file));
    if (!input)
        throw Failure(k_bad_input, fmt::format("the journal {}: {}", glint::quoted(path_), input.message));
    return *std::move(input);
}

void JournalFile::move_to(const std::string& target) {
    sync();
    if (::rename(path_.c_str(), target.c_str()) != 0) fail(errno);
    unfinished_.reset();
    sync_folder(folder_of(target));
}

void JournalFile::remove() {
    ::unlink(path_.c_str());
    unfinished_.reset();
}

}  // namespace glint::cli
