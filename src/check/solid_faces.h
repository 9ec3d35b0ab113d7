// SPDX-License-Identifier: Apache-2.0
#pragma once
// Faces of a solid's operands that coincide.
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "trace/kernels.h"
#include "world/world.h"

namespace glint {

/// A ray as far as its hit on a shape, or k_none. Its direction has length 1.
struct SightLine {
    Vec3 origin, direction;
    double end;
    std::uint32_t shape;
};

/// Two operands of a solid.
struct OperandPair {
    std::uint32_t earlier, later;
    friend auto operator<=>(const OperandPair&,
                            const OperandPair&) = default;  // NOLINT(modernize-use-nullptr): there is no 0
};
/// What is found of the faces of two.
struct FacesFound {
    std::size_t lines = 0;
    bool changes_surface = false;  // by the order there is a surface or none, else its material differs
};

/// Finds pairs of faces that coincide and whose order changes what is seen: they are crossed in front of what
/// a line hits, rounding decides which of them is first, and with that whether there is a surface, or in
/// which material. Faces that are deep inside of others, or that look the same in any order, are no such
/// pair.
class SolidFaces {
  public:
    /// slot: of a solid.
    SolidFaces(const WorldParts& world, const Kernels& kernels, std::uint32_t slot);

    const Bounds& box() const { return box_; }
    void look_along(const SightLine& line);
    /// How many operands and items of the tree look_along() has gone through to compare crossings.
    std::uint64_t steps() const { return steps_; }
    const std::map<OperandPair, FacesFound>& found() const { return found_; }

  private:
    struct Crossing {
        double t;
        std::uint32_t operand;
        bool is_entry;
    };
    struct Look {
        std::array<double, k_material_values> values;
        const PreparedTexture* texture;
        bool is_clear;
        bool operator==(const Look&) const = default;
    };
    enum class Difference : std::uint8_t { none, material, surface };
    using States = std::vector<std::uint32_t>;    // by operand: 1 inside, else 0
    using Operands = std::vector<std::uint32_t>;  // some, by their numbers

    std::size_t count() const { return packed_.slots.size(); }
    Look look_of(std::uint32_t slot) const;
    void find_crossings(std::uint32_t operand, Vec3 origin, Vec3 direction, std::vector<Crossing>& to);
    double nearest(const Crossing& to, Vec3 origin, Vec3 direction);
    States states_at(double t) const;
    Operands seen_in(States states, const std::vector<Operands>& order, const States& last) const;
    Difference difference_of(const Crossing& first, const Crossing& second, double near);
    bool are_one_face(const SightLine& line, const Crossing& a, const Crossing& b, double near);

    const WorldParts& world_;
    const PackedGeometry& geometry_;
    const Kernels& kernels_;
    const PackedSolid& packed_;
    const std::uint32_t shape_;
    const Bounds box_;
    const double step_;                             // how far beside a line the faces are looked at
    std::vector<Look> looks_;                       // by operand
    std::vector<std::vector<Crossing>> crossings_;  // by operand, of the line that is looked along
    std::vector<Crossing> beside_;                  // of an operand, of a line beside it
    std::vector<double> ends_;
    std::uint64_t steps_ = 0;
    std::map<OperandPair, FacesFound> found_;
};

}  // namespace glint
