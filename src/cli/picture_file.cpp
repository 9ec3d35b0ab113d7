// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_file.h"

#include <fmt/format.h>

#include "cli/failure.h"
#include "cli/input_file.h"

namespace glint::cli {

DecodeResult try_picture(const std::string& path) {
    DecodeResult result;
    const auto file = InputFile::open(path, result.error, true);
    if (!file) return result;
    const std::string_view bytes = file->text();
    return decode({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

DecodeResult read_picture(const std::string& path) {
    DecodeResult result = try_picture(path);
    if (!result.image) throw Failure(k_bad_input, fmt::format("{}: {}", path, result.error));
    return result;
}

}  // namespace glint::cli
