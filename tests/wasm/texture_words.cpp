// SPDX-License-Identifier: Apache-2.0
// A module for the tests: decode_texture() as the page has it.
#include "image/texture_words.h"

#include <cstdlib>
#include <string>

#include "image/texture_image.h"
#include "wasm/api.h"

extern "C" {

std::uint8_t* GLINT_WASM_EXPORT(texture_allocate)(std::uint32_t bytes) {
    return static_cast<std::uint8_t*>(std::malloc(bytes));
}

/// words_of() the picture in the memory of texture_allocate(), or its error; until the next call.
const char* GLINT_WASM_EXPORT(texture_words)(std::uint8_t* file, std::uint32_t bytes) {
    static std::string text;
    const glint::Result<glint::TextureImage> image = glint::decode_texture({file, bytes});
    text = image ? glint::test::words_of(*image) : image.message;
    std::free(file);
    return text.c_str();
}

}  // extern "C"
