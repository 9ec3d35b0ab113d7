// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_file.h"

#include <fmt/format.h>

#include "cli/failure.h"
#include "cli/input_file.h"

namespace glint::cli {

Result<DecodedImage> try_picture(const std::string& path) {
    std::string why;
    const auto file = InputFile::open(path, why, true);
    if (!file) return Status{ErrorCode::io, std::move(why), {}};
    const std::string_view bytes = file->text();
    return decode({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

DecodedImage read_picture(const std::string& path) {
    Result<DecodedImage> result = try_picture(path);
    if (!result) throw Failure(k_bad_input, fmt::format("{}: {}", path, result.message));
    return *std::move(result);
}

}  // namespace glint::cli
