// SPDX-License-Identifier: Apache-2.0
// What has been changed in a scene's objects goes to the scene.
#include "scene_state.h"

namespace glint::python {
namespace {

bool same_affine(const Affine& a, const std::optional<Affine>& b) { return a == b.value_or(Affine{}); }

const Affine& transform_of(const Scene& scene, const Shape& shape) {
    static const Affine identity;
    return shape.transform == k_none ? identity : scene.transforms[shape.transform];
}

// Objects that only the map refers to; their values are in the scene.
template <class Map> void forget_unused(Map& objects) {
    std::erase_if(objects, [](const auto& entry) { return entry.second.use_count() == 1; });
}
template <class Map, class Indices> void forget_unused(Map& objects, Indices& indices) {
    std::erase_if(objects, [&](const auto& entry) {
        const bool unused = entry.second.use_count() == 1;
        if (unused) indices.erase(entry.second.get());
        return unused;
    });
}

}  // namespace

void set_name(ItemTexts& texts, std::uint32_t index, const std::string& name) {
    if (texts.name(index) == name) return;
    if (name.empty()) {
        texts.names.erase(index);
    } else {
        texts.names[index] = name;
    }
}

void SceneState::write_transform(Shape& shape, const ShapeBox& box) {
    if (same_affine(transform_of(*scene_, shape), box.transform)) return;
    if (!box.transform) {
        shape.transform = k_none;
    } else {
        scene_->transforms.push_back(*box.transform);
        shape.transform = static_cast<std::uint32_t>(scene_->transforms.size() - 1);
    }
}

void SceneState::sync_materials() {
    bool changed = false;
    for (const auto& [index, box] : materials_) {
        if (scene_->material_texts.name(index) != box->name) set_name(own().material_texts, index, box->name);
        const Material value = whole(*box);
        if (same(scene_->materials[index], value)) continue;
        own().materials[index] = value;
        changed = true;
    }
    if (changed) ++now_.materials;
    forget_unused(materials_, material_indices_);
}

void SceneState::sync_textures() {
    bool changed = false;
    std::vector<std::uint32_t> known;
    for (const auto& entry : textures_) known.push_back(entry.first);
    for (const std::uint32_t index : known) {  // whole() may add textures
        const std::shared_ptr<TextureBox> box = textures_[index];
        const Texture value = whole(*box);
        if (scene_->texture_texts.name(index) != box->name) set_name(own().texture_texts, index, box->name);
        if (scene_->textures[index].file != box->value.file) own().textures[index].file = box->value.file;
        if (same(scene_->textures[index], value)) continue;
        own().textures[index] = value;
        changed = true;
    }
    if (changed) ++now_.textures;
    forget_unused(textures_, texture_indices_);
}

void SceneState::sync_lights() {
    bool changed = false;
    for (const auto& [index, box] : lights_) {
        if (scene_->light_texts.name(index) != box->name) set_name(own().light_texts, index, box->name);
        if (same(scene_->lights[index], box->value)) continue;
        own().lights[index] = box->value;
        changed = true;
    }
    if (changed) ++now_.lights;
    forget_unused(lights_);
}

void SceneState::sync_shapes() {
    for (const auto& [index, box] : shapes_) {
        const std::uint32_t material = index_of(box->material);
        const std::vector<std::uint32_t> of_parts = indices_of(box->part_materials());
        if (scene_->shape_texts.name(index) != box->name) set_name(own().shape_texts, index, box->name);
        const Shape& shape = scene_->shapes[index];
        const bool moved = !same_affine(transform_of(*scene_, shape), box->transform);
        if (!moved && shape.material == material && scene_->shape_color(index) == box->color &&
            box->is_shape(*scene_, index, of_parts))
            continue;
        Scene& scene = own();
        box->write(scene, index, of_parts);
        scene.shapes[index].material = material;
        scene.set_shape_color(index, box->color);
        write_transform(scene.shapes[index], *box);
        record_edit(index, index + 1);
    }
    forget_unused(shapes_);
}

void SceneState::sync() {
    sync_shapes();     // first: it may add materials
    sync_materials();  // may add textures
    sync_textures();
    sync_lights();
    if (!same(camera_->whole(), scene_->camera)) {
        own().camera = camera_->whole();
        ++now_.camera;
    }
    const auto sync_one = [&](auto Scene::*member, const auto& box, std::uint64_t& version) {
        const auto& item = (*scene_).*member;
        if (box ? item && same(*item, box->value) : !item) return;
        own().*member = box ? std::optional(box->value) : std::nullopt;
        ++version;
    };
    sync_one(&Scene::fog, fog_, now_.fog);
    sync_one(&Scene::gradient, gradient_, now_.gradient);
    sync_one(&Scene::occlusion, occlusion_, now_.occlusion);
}

}  // namespace glint::python
