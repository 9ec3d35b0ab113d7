// SPDX-License-Identifier: Apache-2.0
#include "formats/obj_shapes.h"

#include <fmt/format.h>

#include "base/text.h"

namespace glint {

// Of a file that is rendered by itself. Programs write a Ka that is as bright as Kd, or white.
constexpr double k_obj_ambient_light = 0.1;

void ObjShapes::add() {
    Scene& scene = reading_.scene;
    ObjMeshes meshes(data_, reading_, text_.place);
    std::uint64_t uncounted = 0;  // triangles: counting takes the time of all meshes
    for (ObjPart& part : data_.parts) {
        uncounted += part.triangles.size();
        std::shared_ptr<const MeshData> mesh = meshes.make(part);
        if (!mesh) return;
        const auto index = static_cast<std::uint32_t>(scene.meshes.size());
        scene.meshes.push_back(std::move(mesh));
        note(scene.shape_texts, scene.shapes.size(), part.place, part.name);
        scene.add(Mesh{index}, add_material(part));
        if (uncounted > 65536) {
            if (!go_on()) return;
            uncounted = 0;
        }
    }
    if (undefined_ > 0) {
        const std::string others = undefined_ > 1 ? fmt::format(", and {} others", undefined_ - 1) : "";
        reading_.diagnostics.warn(text_.place, first_undefined_->usemtl, first_undefined_->usemtl_length,
                                  fmt::format("no .mtl has the material {}{}: glint's default one is used",
                                              quoted(first_undefined_->material), others));
    }
    if (!text_.is_included) reading_.lone_mesh = text_.file;
    (void)go_on();
}

std::uint32_t ObjShapes::add_material(const ObjPart& part) {
    if (part.material.empty()) return k_none;
    const auto found = materials_.find(part.material);
    if (found == materials_.end()) {
        if (!is_library_missing_ && undefined_++ == 0) first_undefined_ = &part;
        return k_none;
    }
    Scene& scene = reading_.scene;
    note(scene.material_texts, scene.materials.size(), found->second.place, part.material);
    scene.materials.push_back(found->second.material);
    if (auto texture = mtl_texture(reading_, found->second.color_map, found->second.opacity_map)) {
        scene.materials.back().texture = static_cast<std::uint32_t>(scene.textures.size());
        note(scene.texture_texts, scene.textures.size(), found->second.place, part.material);
        scene.textures.push_back(std::move(*texture));
    }
    if (!text_.is_included) reading_.mesh_ambient_light = k_obj_ambient_light;
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

}  // namespace glint
