// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_file.h"

#include <fmt/format.h>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/input_file.h"

namespace glint::cli {

namespace {

template <class Decode>
auto decode_file(const std::string& path, Decode&& decode) -> decltype(decode(ByteSpan())) {
    std::string why;
    const auto file = InputFile::open(path, why, true);
    if (!file) return Status{ErrorCode::io, std::move(why), {}};
    const std::string_view bytes = file->text();
    return decode(ByteSpan(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

template <class Picture> Picture value_or_fail(const std::string& path, Result<Picture> result) {
    if (!result) throw Failure(k_bad_input, fmt::format("{}: {}", path, printable(result.message)));
    return *std::move(result);
}

DecodeOptions options_of(std::uint64_t max_memory) {
    DecodeOptions options;
    options.max_memory = max_memory;
    return options;
}

}  // namespace

Result<DecodedImage> try_picture(const std::string& path, std::uint64_t max_memory) {
    return decode_file(path, [=](ByteSpan bytes) { return decode(bytes, options_of(max_memory)); });
}

DecodedImage read_picture(const std::string& path, std::uint64_t max_memory) {
    return value_or_fail(path, try_picture(path, max_memory));
}

DecodedPicture read_stored_picture(const std::string& path, std::uint64_t max_memory) {
    return value_or_fail(path, decode_file(path, [=](ByteSpan bytes) {
                             return decode_stored(bytes, {options_of(max_memory), false});
                         }));
}

}  // namespace glint::cli
