// SPDX-License-Identifier: Apache-2.0
#pragma once
// Materials in .glint: their names and keys.
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "formats/block_writer.h"
#include "glint/scene.h"

namespace glint {

/// The text form of a scene's materials. An unnamed material of a single shape is written in the shape's
/// block; unnamed materials with equal bits are written as one.
class MaterialPlan {
  public:
    explicit MaterialPlan(const Scene& scene);

    /// The material that is written in place of this one.
    std::uint32_t written(std::uint32_t material) const { return written_[material]; }
    /// Whether the material has a block of its own; name() is the name of that block.
    bool is_named(std::uint32_t material) const { return named_[written_[material]] != 0; }
    std::string_view name(std::uint32_t material) const;
    std::string_view texture_name(std::uint32_t texture) const { return texture_names_[texture]; }

  private:
    void use_own_names(const Scene& scene);
    void merge_unnamed(const Scene& scene);
    void name_shared(const Scene& scene);
    void name_textures(const Scene& scene);

    std::vector<std::uint32_t> written_;
    std::vector<std::uint32_t> named_;  // 1 + index into names_, or 0
    std::vector<std::string> names_;
    std::vector<std::string> texture_names_;
    std::set<std::string, std::less<>> taken_;  // the same names
};

/// The keys of a material of the plan; default values are omitted.
void write_material_keys(BlockWriter& block, const MaterialPlan& plan, const Material& material);

/// True if the two have the same bits.
bool same_bits(const Material& a, const Material& b);

}  // namespace glint
