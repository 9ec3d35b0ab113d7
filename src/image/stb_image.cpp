// SPDX-License-Identifier: Apache-2.0
// stb_image, the decoder of the pixels of PNG and JPEG: whole numbers only, so every build has the same
// words. Its memory is zero at first, because with damaged files it reads numbers that it has not written;
// and it is limited, because PNG's data may be inflated to any size.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace {

struct StbMemory {
    std::uint64_t left;
    bool is_over;  // more than that was wanted
    bool is_out;   // there was no memory
};
thread_local StbMemory stb_memory{0, false, false};

// Before each piece of memory: its size.
constexpr std::size_t k_before_piece = alignof(std::max_align_t);

void* allocate_for_stb(std::size_t bytes) {
    if (bytes > stb_memory.left) {
        stb_memory.is_over = true;
        return nullptr;
    }
    void* const memory = std::calloc(1, bytes + k_before_piece);
    if (memory == nullptr) {
        stb_memory.is_out = true;
        return nullptr;
    }
    stb_memory.left -= bytes;
    std::memcpy(memory, &bytes, sizeof bytes);
    return static_cast<char*>(memory) + k_before_piece;
}

std::size_t size_for_stb(void* memory) {
    std::size_t bytes = 0;
    std::memcpy(&bytes, static_cast<char*>(memory) - k_before_piece, sizeof bytes);
    return bytes;
}

void release_for_stb(void* memory) {
    if (memory == nullptr) return;
    stb_memory.left += size_for_stb(memory);
    std::free(static_cast<char*>(memory) - k_before_piece);
}

void* reallocate_for_stb(void* memory, std::size_t bytes) {
    void* const larger = allocate_for_stb(bytes);
    if (larger == nullptr || memory == nullptr) return larger;
    std::memcpy(larger, memory, std::min(bytes, size_for_stb(memory)));
    release_for_stb(memory);
    return larger;
}

}  // namespace

#define STBI_MALLOC(bytes) allocate_for_stb(bytes)
#define STBI_REALLOC(memory, bytes) reallocate_for_stb(memory, bytes)
#define STBI_FREE(memory) release_for_stb(memory)
#define STBI_ASSERT(condition) ((void)0)  // the library never aborts
#define STBI_MAX_DIMENSIONS 32768
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_SIMD  // whose JPEG has other words
#define STBI_NO_STDIO
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#include <stb_image.h>

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "base/status.h"
#include "image/texture_files.h"

namespace glint {
namespace {

struct ReleaseForStb {
    void operator()(void* memory) const { release_for_stb(memory); }
};

template <class Word>
Result<TextureImage> decode_words(ByteSpan file, const StbPicture& picture,
                                  Word* (*load)(const stbi_uc*, int, int*, int*, int*, int)) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<Word, ReleaseForStb> words(
        load(file.data(), static_cast<int>(file.size()), &width, &height, &channels, 0));
    if (!words) {
        if (stb_memory.is_out) return failure(ErrorCode::out_of_memory, "out of memory");
        if (stb_memory.is_over)
            return undecodable(fmt::format("{}: more data than its picture has", picture.format));
        const char* const reason = stbi_failure_reason();
        return undecodable(fmt::format("{}: {}", picture.format, reason != nullptr ? reason : "unreadable"));
    }
    if (width != static_cast<int>(picture.width) || height != static_cast<int>(picture.height))
        return undecodable(fmt::format("{}: it has two sizes", picture.format));
    return texels_of(picture.width, picture.height, static_cast<std::size_t>(channels), words.get());
}

}  // namespace

Result<TextureImage> decode_by_stb(ByteSpan file, const StbPicture& picture) {
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<int>::max());
    if (file.size() > most || picture.memory > most)
        return undecodable(fmt::format("{}: a picture of {} x {} pixels that takes more than 2 GiB to decode",
                                       picture.format, picture.width, picture.height));
    stb_memory = {picture.memory, false, false};
    stbi__g_failure_reason = nullptr;
    if (picture.is_wide) return decode_words<stbi_us>(file, picture, stbi_load_16_from_memory);
    return decode_words<stbi_uc>(file, picture, stbi_load_from_memory);
}

}  // namespace glint
