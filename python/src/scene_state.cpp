// SPDX-License-Identifier: Apache-2.0
#include "scene_state.h"

#include "base/text.h"
#include "errors.h"

namespace glint::python {

void apply(const SettingList& settings, Scene& scene) {
    for (const auto& [key, value] : settings) {
        const auto index = find_setting(key);
        if (!index) {
            std::vector<std::string_view> known;
            for (const SettingKey& setting : setting_keys()) known.push_back(setting.name);
            throw py::key_error("there is no setting '" + key + "'" + did_you_mean(key, known));
        }
        const Status status = set_setting(scene, *index, value, {SettingOrigin::Kind::code, {}});
        if (status) continue;
        Status failed = status;
        if (failed.diagnostics.empty()) failed.message = key + ": " + failed.message;
        raise(failed);
    }
}

SceneState::SceneState() { reset(Scene{}); }

void SceneState::copy_from(SceneState& other) {
    reset(other.scene());
    now_ = other.now_;
    history_ = other.history_;
    warned_ = other.warned_;
    edits_ = other.edits_;
    edited_shapes_ = other.edited_shapes_;
    has_world_ = other.has_world_;
    world_ = other.world_;
    world_shapes_ = other.world_shapes_;
    world_versions_ = other.world_versions_;
    world_edits_ = other.world_edits_;
}

void SceneState::reset(Scene scene) {
    scene_ = std::make_shared<Scene>(std::move(scene));
    lights_.clear();
    materials_.clear();
    textures_.clear();
    shapes_.clear();
    material_indices_.clear();
    texture_indices_.clear();
    camera_ = std::make_shared<CameraBox>();
    camera_->value = scene_->camera;
    if (scene_->camera.frame) {
        camera_->frame = std::make_shared<FrameBox>(FrameBox{*scene_->camera.frame, {}});
        camera_->value.frame.reset();
    }
    const auto box_of = []<class Item>(const std::optional<Item>& item) {
        return item ? std::make_shared<SharedItem<Item>>(SharedItem<Item>{*item, {}}) : nullptr;
    };
    fog_ = box_of(scene_->fog);
    gradient_ = box_of(scene_->gradient);
    occlusion_ = box_of(scene_->occlusion);
    has_world_ = false;
    world_ = {};
    warned_.clear();
}

Scene& SceneState::own() {
    if (scene_.use_count() > 1) scene_ = std::make_shared<Scene>(*scene_);
    return *scene_;
}

const Scene& SceneState::scene() {
    sync();
    return *scene_;
}

std::shared_ptr<const Scene> SceneState::shared_scene() {
    sync();
    return scene_;
}

std::shared_ptr<LightBox> SceneState::light(std::uint32_t index) {
    auto& light = lights_[index];
    if (!light) {
        light = std::make_shared<LightBox>(
            LightBox{scene_->lights[index], std::string(scene_->light_texts.name(index))});
    }
    return light;
}

std::shared_ptr<MaterialBox> SceneState::material(std::uint32_t index) {
    auto& material = materials_[index];
    if (!material) {
        material = std::make_shared<MaterialBox>(
            MaterialBox{scene_->materials[index], std::string(scene_->material_texts.name(index))});
        std::uint32_t& shown = material->value.texture;
        if (shown != k_none) material->texture = texture(shown);
        shown = k_none;
        material_indices_[material.get()] = index;
    }
    return material;
}

std::shared_ptr<TextureBox> SceneState::texture(std::uint32_t index) {
    auto& texture = textures_[index];
    if (!texture) {
        texture = std::make_shared<TextureBox>(
            TextureBox{scene_->textures[index], std::string(scene_->texture_texts.name(index))});
        texture_indices_[texture.get()] = index;
        const std::shared_ptr<TextureBox> made = texture;
        std::uint32_t& below = made->value.over;
        if (below != k_none) made->over = this->texture(below);  // may move `texture`
        below = k_none;
        return made;
    }
    return texture;
}

std::uint32_t SceneState::add(const std::shared_ptr<LightBox>& light) {
    sync_lights();
    Scene& scene = own();
    const auto index = static_cast<std::uint32_t>(scene.lights.size());
    scene.lights.push_back(light->value);
    set_name(scene.light_texts, index, light->name);
    lights_[index] = light;
    ++now_.lights;
    return index;
}

std::uint32_t SceneState::add(const std::shared_ptr<MaterialBox>& material) { return index_of(material); }

std::uint32_t SceneState::index_of(const std::shared_ptr<MaterialBox>& material) {
    if (!material) return k_none;
    const auto found = material_indices_.find(material.get());
    if (found != material_indices_.end()) return found->second;
    const Material value = whole(*material);
    Scene& scene = own();
    const auto index = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(value);
    set_name(scene.material_texts, index, material->name);
    materials_[index] = material;
    material_indices_[material.get()] = index;
    ++now_.materials;
    return index;
}

std::vector<std::uint32_t> SceneState::indices_of(
    const std::vector<std::shared_ptr<MaterialBox>>& materials) {
    std::vector<std::uint32_t> indices;
    indices.reserve(materials.size());
    for (const auto& material : materials) indices.push_back(index_of(material));
    return indices;
}

std::uint32_t SceneState::add(const std::shared_ptr<TextureBox>& texture) { return index_of(texture); }

std::uint32_t SceneState::index_of(const std::shared_ptr<TextureBox>& texture) {
    if (!texture) return k_none;
    const auto found = texture_indices_.find(texture.get());
    if (found != texture_indices_.end()) return found->second;
    const Texture value = whole(*texture);
    Scene& scene = own();
    const auto index = static_cast<std::uint32_t>(scene.textures.size());
    scene.textures.push_back(value);
    set_name(scene.texture_texts, index, texture->name);
    textures_[index] = texture;
    texture_indices_[texture.get()] = index;
    ++now_.textures;
    return index;
}

Texture SceneState::whole(const TextureBox& texture) {
    Texture value = texture.value;
    value.over = index_of(texture.over);
    return value;
}

Material SceneState::whole(const MaterialBox& material) {
    Material value = material.value;
    value.texture = index_of(material.texture);
    return value;
}

void SceneState::set_lights(const std::vector<std::shared_ptr<LightBox>>& lights) {
    Scene& scene = own();
    std::vector<SourcePlace> places;
    for (const auto& light : lights) {
        SourcePlace place;
        for (const auto& [index, known] : lights_)
            if (known == light) place = scene.light_texts.place(index);
        places.push_back(place);
    }
    scene.lights.clear();
    scene.light_texts.names.clear();
    scene.light_texts.places = std::move(places);
    lights_.clear();
    for (const auto& light : lights) {
        const auto index = static_cast<std::uint32_t>(scene.lights.size());
        scene.lights.push_back(light->value);
        set_name(scene.light_texts, index, light->name);
        lights_[index] = light;
    }
    ++now_.lights;
}

void SceneState::set_material(std::uint32_t index, const std::shared_ptr<MaterialBox>& material) {
    const auto known = materials_.find(index);
    if (known != materials_.end()) material_indices_.erase(known->second.get());
    materials_[index] = material;
    material_indices_[material.get()] = index;
}

void SceneState::set_background(Color background) {
    own().background = background;
    ++now_.background;
}

void SceneState::set_setting(const std::string& key, const std::string& value) {
    apply({{key, value}}, own());
    ++now_.rules;
}

void SceneState::apply_profile(const std::string& profile) {
    const Status status = glint::apply_profile(own(), profile);
    if (!status) raise(status);
    ++now_.rules;
}

}  // namespace glint::python
