// SPDX-License-Identifier: Apache-2.0
// A scene's shapes: their objects, and what is added, removed and changed.
#include <algorithm>

#include "scene_state.h"

namespace glint::python {
namespace {

// Removes the items with these numbers, which are sorted.
template <class Item> void erase_items(std::vector<Item>& items, const std::vector<std::uint32_t>& numbers) {
    std::size_t to = 0;
    auto next = numbers.begin();
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (next != numbers.end() && *next == i) {
            ++next;
        } else {
            items[to++] = items[i];
        }
    }
    items.resize(to);
}

// How many of the sorted numbers are less than this one.
std::uint32_t count_before(const std::vector<std::uint32_t>& numbers, std::uint32_t number) {
    return static_cast<std::uint32_t>(std::lower_bound(numbers.begin(), numbers.end(), number) -
                                      numbers.begin());
}

}  // namespace

std::shared_ptr<ShapeBox> SceneState::shape(std::uint32_t index) {
    auto& box = shapes_[index];
    if (!box) {
        box = read_shape(*scene_, scene_->shapes[index]);
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
    std::vector<std::shared_ptr<MaterialBox>> of_parts;
    for (const Shape& part : operands_of(*scene_, shape))
        of_parts.push_back(part.material == k_none ? nullptr : material(part.material));
    box.set_part_materials(of_parts);
}

std::uint32_t SceneState::add(const std::shared_ptr<ShapeBox>& shape) {
    const std::uint32_t material = index_of(shape->material);
    const std::vector<std::uint32_t> of_parts = indices_of(shape->part_materials());
    Scene& scene = own();
    shape->append(scene, of_parts);
    const auto index = static_cast<std::uint32_t>(scene.shapes.size() - 1);
    scene.shapes[index].material = material;
    scene.set_shape_color(index, shape->color);
    write_transform(scene.shapes[index], *shape);
    set_name(scene.shape_texts, index, shape->name);
    shapes_[index] = shape;
    record_added(1);
    return index;
}

void SceneState::set_shape(std::uint32_t index, const std::shared_ptr<ShapeBox>& shape) {
    shapes_[index] = shape;
}

void SceneState::remove_shapes(std::vector<std::uint32_t> removed) {
    sync();
    std::sort(removed.begin(), removed.end());
    removed.erase(std::unique(removed.begin(), removed.end()), removed.end());
    if (removed.empty()) return;
    const auto is_removed = [&](std::uint32_t i) {
        return std::binary_search(removed.begin(), removed.end(), i);
    };
    Scene& scene = own();
    erase_items(scene.shapes, removed);
    erase_items(scene.shape_colors, removed);
    erase_items(scene.shape_texts.places, removed);
    ItemNames names;
    for (const auto& [index, name] : scene.shape_texts.names)
        if (!is_removed(index)) names.emplace(index - count_before(removed, index), name);
    scene.shape_texts.names = std::move(names);
    std::unordered_map<std::uint32_t, std::shared_ptr<ShapeBox>> objects;
    for (auto& [index, object] : shapes_)
        if (!is_removed(index)) objects[index - count_before(removed, index)] = std::move(object);
    shapes_ = std::move(objects);
    record_removed(std::move(removed));
}

Scene& SceneState::add_shapes(std::size_t count) {
    sync();
    record_added(count);
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

void SceneState::record_added(std::size_t count) {
    history_.add(count);
    now_.shapes = history_.version();
}

void SceneState::record_removed(std::vector<std::uint32_t> numbers) {
    for (ShapesEdit& edit : edited_shapes_) {
        edit.first -= count_before(numbers, edit.first);
        edit.end -= count_before(numbers, edit.end);
    }
    history_.remove(std::move(numbers));
    history_.forget(0, scene_->shapes.size());
    now_.shapes = history_.version();
    ++removals_;
}

}  // namespace glint::python
