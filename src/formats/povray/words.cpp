// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/words.h"

namespace glint::povray {
namespace {

constexpr std::string_view k_words[] = {
#define GLINT_POV_WORD(word) #word,
    GLINT_POV_WORDS(GLINT_POV_WORD)
#undef GLINT_POV_WORD
};

}  // namespace

std::string_view to_string(Word word) {
    return word < Word::k_count ? k_words[static_cast<std::size_t>(word)] : std::string_view();
}

}  // namespace glint::povray
