// SPDX-License-Identifier: Apache-2.0
#pragma once
// The two conventions for the colors of triangles in a binary .stl, which have 5 bits for each channel.
#include <cstdint>
#include <string_view>
#include <vector>

#include "glint/mesh.h"

namespace glint {

class StlColors {
  public:
    /// header: the first 80 bytes. With "COLOR=" and R, G, B, A in it, the file is one of Materialise Magics.
    explicit StlColors(std::string_view header) {
        constexpr std::string_view word = "COLOR=";
        const std::size_t at = header.find(word);
        if (at == std::string_view::npos || at + word.size() + 4 > header.size()) return;
        const auto channel = [&](std::size_t i) {
            return static_cast<float>(static_cast<unsigned char>(header[at + word.size() + i])) / 255;
        };
        default_ = {channel(0), channel(1), channel(2)};
        has_default_ = true;
    }

    bool has_default() const { return has_default_; }
    /// By the triangle's two bytes of attributes. Magics: bit 15 is set if the triangle has the color of the
    /// header. Others (VisCAM, SolidView): it is set if the triangle has a color.
    bool is_colored(std::uint16_t attribute) const { return has_default() || (attribute & k_flag) != 0; }

    /// The number in `values` of the triangle's color, which is added if it is new; CornerValues::k_none if
    /// it has none.
    std::uint32_t number_of(std::uint16_t attribute, std::vector<Float3>& values) {
        if (!is_colored(attribute)) return CornerValues::k_none;
        const bool is_default = has_default() && (attribute & k_flag) != 0;
        const std::uint32_t bits = is_default ? k_flag : attribute & (k_flag - 1);
        if (numbers_.empty()) numbers_.resize(k_flag + 1, CornerValues::k_none);
        if (numbers_[bits] == CornerValues::k_none) {
            numbers_[bits] = static_cast<std::uint32_t>(values.size());
            const float low = channel(bits), middle = channel(bits >> 5), high = channel(bits >> 10);
            values.push_back(is_default      ? default_
                             : has_default() ? Float3{low, middle, high}
                                             : Float3{high, middle, low});
        }
        return numbers_[bits];
    }

  private:
    static constexpr std::uint32_t k_flag = 1u << 15;
    static float channel(std::uint32_t bits) { return static_cast<float>(bits & 31u) / 31; }

    bool has_default_ = false;
    Float3 default_;
    std::vector<std::uint32_t> numbers_;  // by the 15 bits; the last one is that of the default
};

}  // namespace glint
