// SPDX-License-Identifier: Apache-2.0
#include "mpi/shared_texts.h"

#include <utility>

#include "journal/little_endian.h"
#include "mpi/messages.h"

namespace glint::mpi {
namespace {

void put_text(std::string& bytes, std::string_view text) {
    put_u64(bytes, text.size());
    bytes += text;
}

std::string take_text(std::string_view& bytes) {
    const auto size = static_cast<std::size_t>(get_u64(bytes));
    std::string text(bytes.substr(8, size));
    bytes.remove_prefix(8 + size);
    return text;
}

}  // namespace

std::optional<cli::InputFile> RecordingReader::open(const std::string& path, const cli::FileReach& reach,
                                                    std::string& why) {
    auto file = TextReader::open(path, reach, why);
    if (file) texts_.emplace_back(path, file->text());
    return file;
}

void RecordingReader::give() {
    std::string bytes;
    for (const auto& [path, text] : texts_) {
        put_text(bytes, path);
        put_text(bytes, text);
    }
    texts_ = {};
    bytes.insert(0, "+");
    broadcast(bytes);
    given_ = true;
}

bool RecordingReader::give_up() {
    if (given_) return false;
    std::string bytes = "-";
    broadcast(bytes);
    return true;
}

void GivenReader::take() {
    if (taken_) return;
    taken_ = true;
    std::string bytes;
    broadcast(bytes);
    given_up_ = bytes == "-";
    if (given_up_) return;
    std::string_view rest = bytes;
    rest.remove_prefix(1);
    while (!rest.empty()) {
        std::string name = take_text(rest);
        texts_[std::move(name)] = take_text(rest);
    }
}

bool GivenReader::is_given_up() {
    take();
    return given_up_;
}

std::optional<cli::InputFile> GivenReader::open(const std::string& path, const cli::FileReach&,
                                                std::string& why) {
    take();
    if (given_up_) throw GivenUp();
    const auto text = texts_.find(path);
    if (text != texts_.end()) return cli::InputFile::of_text(text->second);
    why = "rank 0 has not read it";
    return std::nullopt;
}

}  // namespace glint::mpi
