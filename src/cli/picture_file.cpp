// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_file.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/input_file.h"
#include "os/files.h"

namespace glint::cli {

namespace {

template <class Decode>
auto decode_file(const std::optional<InputFile>& file, std::string why, Decode&& decode)
    -> decltype(decode(ByteSpan())) {
    if (!file) return Status{ErrorCode::io, std::move(why), {}};
    const std::string_view bytes = file->text();
    return decode(ByteSpan(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

// The picture of a file that the user names. Throws Failure.
template <class Decode> auto decode_own(const std::string& path, Decode&& decode) {
    std::string why;
    const auto file = InputFile::open(path, why, true);
    auto result = decode_file(file, std::move(why), decode);
    if (!result) throw Failure(k_bad_input, fmt::format("{}: {}", path, printable(result.message)));
    return *std::move(result);
}

DecodeOptions options_of(std::uint64_t max_memory) {
    DecodeOptions options;
    options.max_memory = max_memory;
    return options;
}

}  // namespace

DecodedImage read_picture(const std::string& path) {
    return decode_own(path, [](ByteSpan bytes) { return decode(bytes); });
}

Result<DecodedImage> try_handed_in(const std::string& path) {
    std::string why;
    const auto file =
        InputFile::open_named(path, {.is_confined = true, .folders = {os::folder_of(path)}}, why);
    return decode_file(file, std::move(why), [](ByteSpan bytes) { return decode(bytes); });
}

DecodedPicture read_stored_picture(const std::string& path, std::uint64_t max_memory) {
    return decode_own(path, [=](ByteSpan bytes) {
        return decode_stored(bytes, {options_of(max_memory), false});
    });
}

}  // namespace glint::cli
