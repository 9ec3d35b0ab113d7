// SPDX-License-Identifier: Apache-2.0
#include "journal/hash.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

namespace glint {

std::string hash_of(std::string_view bytes) {
    XXH128_canonical_t digest;
    XXH128_canonicalFromHash(&digest, XXH3_128bits(bytes.data(), bytes.size()));
    std::string text;
    for (const unsigned char byte : digest.digest) text += fmt::format("{:02x}", byte);
    return text;
}

}  // namespace glint
