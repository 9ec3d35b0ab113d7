// SPDX-License-Identifier: Apache-2.0
#include "scene_state.h"

#include <algorithm>

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
    warned_ = other.warned_;
    edits_ = other.edits_;
    edited_shapes_ = other.edited_shapes_;
    has_world_ = other.has_world_;
    world_ = other.world_;
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
    }
    return texture;
}

std::shared_ptr<ShapeBox> SceneState::shape(std::uint32_t index) {
    auto& box = shapes_[index];
    if (!box) {
        box = read_shape(*scene_, index);
        read_look(*box, index);
        box->name = scene_->shape_texts.name(index);
    }
    return box;
}

void SceneState::read_look(ShapeBox& box, std::uint32_t index) {
    const Shape& shape = scene_->shapes[index];
    box.material = shape.material == k_none ? nullptr : material(shape.material);
    box.color = scene_->shape_color(index);
    box.transform.reset();
    if (shape.transform != k_none) box.transform = scene_->transforms[shape.transform];
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

std::uint32_t SceneState::add(const std::shared_ptr<TextureBox>& texture) { return index_of(texture); }

std::uint32_t SceneState::index_of(const std::shared_ptr<TextureBox>& texture) {
    if (!texture) return k_none;
    const auto found = texture_indices_.find(texture.get());
    if (found != texture_indices_.end()) return found->second;
    Scene& scene = own();
    const auto index = static_cast<std::uint32_t>(scene.textures.size());
    scene.textures.push_back(texture->value);
    set_name(scene.texture_texts, index, texture->name);
    textures_[index] = texture;
    texture_indices_[texture.get()] = index;
    ++now_.textures;
    return index;
}

Material SceneState::whole(const MaterialBox& material) {
    Material value = material.value;
    value.texture = index_of(material.texture);
    return value;
}

std::uint32_t SceneState::add(const std::shared_ptr<ShapeBox>& shape) {
    const std::uint32_t material = index_of(shape->material);
    Scene& scene = own();
    shape->append(scene);
    const auto index = static_cast<std::uint32_t>(scene.shapes.size() - 1);
    scene.shapes[index].material = material;
    scene.set_shape_color(index, shape->color);
    write_transform(scene.shapes[index], *shape);
    set_name(scene.shape_texts, index, shape->name);
    shapes_[index] = shape;
    ++now_.shapes;
    return index;
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

void SceneState::set_shape(std::uint32_t index, const std::shared_ptr<ShapeBox>& shape) {
    shapes_[index] = shape;
}

void SceneState::remove_shapes(std::vector<std::uint32_t> removed) {
    sync();
    std::sort(removed.begin(), removed.end());
    Scene& scene = own();
    std::vector<Shape> shapes;
    std::vector<ShapeColor> colors;
    std::unordered_map<std::uint32_t, std::shared_ptr<ShapeBox>> objects;
    ItemTexts texts;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        if (std::binary_search(removed.begin(), removed.end(), i)) continue;
        const auto to = static_cast<std::uint32_t>(shapes.size());
        if (const auto object = shapes_.find(i); object != shapes_.end()) objects[to] = object->second;
        set_name(texts, to, std::string(scene.shape_texts.name(i)));
        if (!scene.shape_texts.places.empty()) texts.places.push_back(scene.shape_texts.place(i));
        if (i < scene.shape_colors.size()) colors.push_back(scene.shape_colors[i]);
        shapes.push_back(scene.shapes[i]);
    }
    scene.shapes = std::move(shapes);
    scene.shape_colors = std::move(colors);
    scene.shape_texts = std::move(texts);
    shapes_ = std::move(objects);
    ++now_.shapes;
    ++removals_;
}

Scene& SceneState::change_shapes() {
    sync();
    ++now_.shapes;
    return own();
}

void SceneState::edit_shapes(std::span<const std::uint32_t> shapes,
                             const std::function<void(Scene&)>& change) {
    change(own());
    if (!shapes_.empty()) {
        for (const std::uint32_t index : shapes) {
            const auto object = shapes_.find(index);
            if (object == shapes_.end()) continue;
            object->second->read(*scene_, scene_->shapes[index]);
            read_look(*object->second, index);
        }
    }
    for (std::size_t i = 0; i < shapes.size();) {  // each run of consecutive numbers
        const std::size_t start = i++;
        while (i < shapes.size() && shapes[i] == shapes[i - 1] + 1) ++i;
        record_edit(shapes[start], shapes[i - 1] + 1);
    }
}

void SceneState::record_edit(std::uint32_t first, std::uint32_t end) {
    edited_shapes_.push_back({++edits_, first, end});
    // So that a loop which renders nothing does not fill the memory.
    if (edited_shapes_.size() <= scene_->shapes.size() + 1000) return;
    edited_shapes_.assign(1, {edits_, 0, static_cast<std::uint32_t>(scene_->shapes.size())});
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
