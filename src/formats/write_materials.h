// SPDX-License-Identifier: Apache-2.0
#pragma once
// Materials as .glint writes them: which have a name, and the words of each.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/block_writer.h"
#include "glint/scene.h"

namespace glint {

/// How each material of a scene is written. One without a name that only one shape has is written in that
/// shape's block; those without a name that are the same, bit for bit, are written as one.
class MaterialPlan {
  public:
    explicit MaterialPlan(const Scene& scene);

    /// The material that is written for this one.
    std::uint32_t written(std::uint32_t material) const { return written_[material]; }
    /// Whether it has a block of its own, and its name there.
    bool is_named(std::uint32_t material) const { return named_[written_[material]] != 0; }
    std::string_view name(std::uint32_t material) const;

  private:
    void merge_unnamed(const Scene& scene);
    void choose_names(const Scene& scene, const std::vector<std::uint32_t>& uses);

    std::vector<std::uint32_t> written_;
    std::vector<std::uint32_t> named_;  // 1 + index into names_, or 0
    std::vector<std::string> names_;
};

/// The keys of the material, all that is not as the language has it without the key.
void write_material_keys(BlockWriter& block, const Material& material);

/// True if the two have the same bits.
bool same_bits(const Material& a, const Material& b);

}  // namespace glint
