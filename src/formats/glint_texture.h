// SPDX-License-Identifier: Apache-2.0
#pragma once
// The textures of .glint, which materials refer to by their names.
#include <string>
#include <vector>

#include "formats/glint_text.h"
#include "glint/texture.h"

namespace glint {

/// The textures of all .glint texts of a load, as indices in Scene::textures. A name may be used before it is
/// defined; it gets its index at the first use.
class GlintTextures {
  public:
    /// The table of this load, created at the first call.
    static GlintTextures& of(LoadState& reading);

    /// The texture with the name in token `name`.
    std::uint32_t named(GlintText& t, const Token& name);

    /// Reads `texture NAME { keys }`. A second definition of a name is an error.
    void read_block(GlintText& t, const Token& word);

    /// After the last text: reports undefined names.
    void finish(LoadState& reading);

  private:
    struct Use {
        InputText place;
        Token token;
    };
    // `over` of a texture. Numbers are those of the blocks' order, so that they are the same when they are
    // read again.
    struct Over {
        std::uint32_t texture;
        std::string name;
        Use use;
    };
    std::vector<Over> overs_;
    std::uint32_t index_of(Scene& scene, const std::string& name);

    CountedMap<std::string, std::uint32_t> known_;  // by name
    CountedMap<std::string, Use> undefined_;        // names that are used and not defined yet
};

}  // namespace glint
