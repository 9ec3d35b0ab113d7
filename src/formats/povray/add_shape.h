// SPDX-License-Identifier: Apache-2.0
#pragma once
// Adds a shape to the scene, with its transform and its place.
#include "formats/povray/scene_builder.h"
#include "math/transform.h"

namespace glint::povray {

template <class Shape>
void SceneBuilder::add(const Shape& shape, std::uint32_t material, const Affine* map, const Token& at) {
    if (scene_.shapes.size() % 1024 == 1023 && !stream_.is_within_memory(at)) return;
    std::uint32_t transform = k_none;
    if (map != nullptr) {
        if (scene_.transforms.empty() || !(scene_.transforms.back() == *map)) {
            if (!inverse(*map)) return stream_.error(at, "the shape's transform leaves nothing of it");
            scene_.transforms.push_back(*map);
        }
        transform = static_cast<std::uint32_t>(scene_.transforms.size() - 1);
    }
    scene_.shape_texts.places.push_back(shape_place(at));
    scene_.add(shape, material, transform);
}

}  // namespace glint::povray
