// SPDX-License-Identifier: Apache-2.0
// Refraction: POV-Ray's `ior` of transparent objects.
#include <algorithm>

#include "formats/povray/reach.h"
#include "formats/povray/scene_builder.h"

namespace glint::povray {
namespace {

constexpr std::uint64_t k_max_tests = 10'000'000;

// Whether light passes, or may.
bool is_passed(const Material& m) { return m.is_transparent() || m.texture != k_none; }

}  // namespace

// 1: no refraction. An opaque object around the camera counts, too. (Measured)
double SceneBuilder::ior_of(const Inherited& own) {
    return own.interior && own.interior->ior > 0 ? std::min(own.interior->ior, 1e6) : 1;
}

bool SceneBuilder::refracts_light() const {
    const auto& all = scene_.materials;
    const auto refracts = [](const Material& m) { return m.refracts; };
    return std::any_of(all.begin(), all.end(), refracts) && std::any_of(all.begin(), all.end(), is_passed);
}

// A transparent object within one that refracts has an index of refraction, too: 1. (Measured)
void SceneBuilder::make_all_refract() {
    for (Material& m : scene_.materials) {
        if (m.refracts || !m.is_transparent()) continue;
        m.refracts = true;
        m.ior = 1;
    }
}

void SceneBuilder::forget_refraction() {
    for (Material& m : scene_.materials) {
        if (m.refracts) m.ior = Material{}.ior;
        m.refracts = false;
    }
}

// After use_interiors(). Rays in three objects at a time do not know in which order they have entered these.
void SceneBuilder::check_refraction() {
    if (!refracts_at_) return;
    const auto& shapes = scene_.shapes;
    const auto refracting_material = [&](std::uint32_t number) -> const Material* {
        if (number >= scene_.materials.size()) return nullptr;
        const Material& m = scene_.materials[number];
        return m.refracts && is_passed(m) ? &m : nullptr;
    };
    const auto material_of = [&](const Shape& shape) {
        const Material* found = refracting_material(shape.material);
        if (found || shape.kind != ShapeKind::solid) return found;
        for (const Shape& operand : scene_.solids[scene_.get<Solid>()[shape.index].solid].operands)
            found = found ? found : refracting_material(operand.material);
        return found;
    };
    CountedVector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        if (material_of(shapes[i])) all.push_back(i);
    }
    std::uint64_t tests = 0;
    const auto are_together = [&](std::uint32_t a, std::uint32_t b) {
        tests += reach_steps(scene_, shapes[a]) + reach_steps(scene_, shapes[b]);
        const std::int32_t body = material_of(shapes[a])->interior;
        if (body > 0 && body == material_of(shapes[b])->interior) return false;
        return tests > k_max_tests || !are_apart(scene_, shapes[a], shapes[b]);
    };
    CountedVector<std::uint32_t> around;
    for (std::size_t i = 0; i < all.size(); ++i) {
        around.clear();
        for (std::size_t k = i + 1; k < all.size(); ++k) {
            if (!are_together(all[i], all[k])) continue;
            if (scene_.fog && hollow_at_)
                return report(
                    {"fog", "inside of hollow objects that refract, within another one", *hollow_at_});
            for (const std::uint32_t other : around) {
                if (are_together(other, all[k]))
                    return report({"ior", "of three transparent objects within each other", *refracts_at_});
            }
            around.push_back(all[k]);
        }
    }
}

}  // namespace glint::povray
