// SPDX-License-Identifier: Apache-2.0
// Refraction: what of POV-Ray's `ior` glint's glass does exactly.
#include <algorithm>

#include "formats/povray/reach.h"
#include "formats/povray/scene_builder.h"
#include "math/number.h"

namespace glint::povray {
namespace {

constexpr double k_near = 1e-9;
constexpr std::uint64_t k_max_tests = 10'000'000;

}  // namespace

// 1 for an entirely clear solid, whose glass is the same in glint; else 0: own light, colored shadows and
// reflection inside are not.
double SceneBuilder::glass_of(const Inherited& own) const {
    const std::array<double, 5>& p = own.texture->pigment.color;
    if (!own.is_solid || own.is_merge || own.texture->below || own.texture->pigment.image || !own.interior ||
        own.interior->ior == 1 || !(own.interior->ior > 0)) {
        return 0;
    }
    const Color& mirror = own.texture->finish.reflection_max;
    if (mirror.r > 0 || mirror.g > 0 || mirror.b > 0) return 0;
    const double least = std::min({p[0], p[1], p[2]}), most = std::max({p[0], p[1], p[2]});
    const double f = p[3], t = p[4];
    if (f < 0 || t < 0 || f + t > 1 + k_near) return 0;
    if (f != 0 && !(number::abs(least - 1) <= k_near && number::abs(most - 1) <= k_near)) return 0;
    return f + t >= 1 - k_near ? 1 : 0;
}

// POV-Ray's rays know all solids that they are in, glint's only the last one.
void SceneBuilder::check_glass() {
    const auto is_clear = [&](const Shape& shape) {
        if (shape.material >= scene_.materials.size()) return false;
        const Material& m = scene_.materials[shape.material];
        return m.transmission > 0 || m.is_transparent();
    };
    std::uint64_t tests = 0;
    for (const std::uint32_t i : glass_) {
        const Shape& glass = scene_.shapes[i];
        tests += scene_.shapes.size();
        const bool is_alone =
            tests <= k_max_tests &&
            std::none_of(scene_.shapes.begin(), scene_.shapes.end(), [&](const Shape& shape) {
                if (&shape == &glass || !is_clear(shape)) return false;
                tests += reach_steps(scene_, shape);
                return tests > k_max_tests || !are_apart(scene_, glass, shape);
            });
        if (!is_alone) return report({"ior", "of transparent objects within each other", glass_at_});
    }
}

}  // namespace glint::povray
