// SPDX-License-Identifier: Apache-2.0
#include "cli/journal_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/output_file.h"
#include "os/files.h"
#include "trace/film/assemble.h"

namespace glint::cli {
namespace {

constexpr std::chrono::seconds k_sync_interval{5};

}  // namespace

JournalFile::JournalFile(std::string path, const JournalHeader& header)
    : path_(std::move(path)), header_(header), synced_(std::chrono::steady_clock::now()) {}

JournalFile::~JournalFile() {
    if (descriptor_ >= 0) os::close(descriptor_);
    if (unfinished_) os::remove(path_);
}

void JournalFile::fail(int error) const {
    throw Failure(k_bad_input,
                  fmt::format("cannot write the journal {}: {}", glint::quoted(path_), std::strerror(error)));
}

void JournalFile::lock() {
    if (os::lock(descriptor_)) return;
    if (errno == EWOULDBLOCK)
        throw Failure(k_bad_input,
                      fmt::format("the journal {} is in use by another process", glint::quoted(path_)));
    fail(errno);
}

std::unique_ptr<JournalFile> JournalFile::resume(const std::string& path, const JournalHeader& header) {
    std::unique_ptr<JournalFile> file(new JournalFile(path, header));
    for (;;) {
        file->descriptor_ = os::open_or_make(path);
        if (file->descriptor_ < 0) file->fail(errno);
        file->lock();
        // The process that had the lock may have finished and removed the file since it was opened here.
        const os::FileInfo about = os::info_of(file->descriptor_);
        if (about.kind == os::FileKind::none) file->fail(errno);
        if (about.has_name) break;
        os::close(std::exchange(file->descriptor_, -1));
    }
    file->start();
    return file;
}

std::unique_ptr<JournalFile> JournalFile::begin(const std::string& target, const JournalHeader& header) {
    std::unique_ptr<JournalFile> file(new JournalFile(temporary_beside(target), header));
    file->unfinished_.emplace(file->path_);
    file->descriptor_ = os::open_new(file->path_);
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
    const os::FileInfo about = os::info_of(descriptor_);
    if (about.kind == os::FileKind::none) fail(errno);
    if (about.kind != os::FileKind::regular)
        throw Failure(k_bad_input, fmt::format("the journal {} is no regular file", glint::quoted(path_)));
    missing_ = tiles_of_part(header_);
    expected_ = missing_.size();
    const std::size_t kept = about.size > 0 ? read_tiles() : 0;
    if (!os::resize(descriptor_, kept) || !os::seek(descriptor_, kept)) fail(errno);
    if (kept > 0) return;
    write(header_bytes(header_));
    sync();
    os::sync_folder(os::folder_of(path_));
}

void JournalFile::write(std::string_view bytes) {
    if (!os::write(descriptor_, bytes.data(), bytes.size())) fail(errno);
}

void JournalFile::sync() {
    if (!os::sync(descriptor_) && errno != EINVAL && errno != EROFS) fail(errno);
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
    if (!os::replace(path_, target)) fail(errno);
    unfinished_.reset();
    os::sync_folder(os::folder_of(target));
}

void JournalFile::remove() {
    os::remove(path_);
    unfinished_.reset();
}

}  // namespace glint::cli
