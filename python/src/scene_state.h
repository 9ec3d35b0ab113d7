// SPDX-License-Identifier: Apache-2.0
#pragma once
// A Scene of Python: glint's Scene, the objects of it that Python refers to, and the World that was prepared
// of it, so that the next picture prepares only what has changed.
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "glint/glint.h"
#include "items.h"
#include "run.h"
#include "shape_history.h"
#include "shapes.h"

namespace glint::python {

/// Settings and conventions as KEY, VALUE, as the command line has them.
using SettingList = std::vector<std::pair<std::string, std::string>>;

/// Names an item; an empty name removes the one that it has.
void set_name(ItemTexts& texts, std::uint32_t index, const std::string& name);

/// Sets them in the scene, or throws.
void apply(const SettingList& settings, Scene& scene);

/// The parts of a World that can be replaced on their own.
struct Versions {
    std::uint64_t shapes = 0, textures = 0, materials = 0, lights = 0, camera = 0, background = 0, fog = 0,
                  gradient = 0, occlusion = 0, rules = 0;
};

/// A scene and its World at one moment. Later changes of the SceneState do not reach it, so it can be used
/// without the GIL.
struct Snapshot {
    std::shared_ptr<const Scene> scene;
    World world;
};

/// All functions need the GIL.
class SceneState {
  public:
    SceneState();
    SceneState(const SceneState&) = delete;
    SceneState& operator=(const SceneState&) = delete;

    /// Takes over a scene that was read from text.
    void reset(Scene scene);
    /// Becomes a copy: it shares the World, but no objects.
    void copy_from(SceneState& other);

    /// The scene with all changes that were made to its objects.
    const Scene& scene();
    std::shared_ptr<const Scene> shared_scene();
    /// The scene as it was last compared with its objects. The numbers of lights and shapes are right.
    const Scene& stored() const { return *scene_; }

    // Objects of the scene; the same one each time.
    std::shared_ptr<LightBox> light(std::uint32_t index);
    std::shared_ptr<MaterialBox> material(std::uint32_t index);
    std::shared_ptr<TextureBox> texture(std::uint32_t index);
    std::shared_ptr<ShapeBox> shape(std::uint32_t index);
    std::shared_ptr<CameraBox> camera() { return camera_; }
    void set_camera(std::shared_ptr<CameraBox> camera) { camera_ = std::move(camera); }
    std::shared_ptr<FogBox> fog() { return fog_; }  ///< null: none
    void set_fog(std::shared_ptr<FogBox> fog) { fog_ = std::move(fog); }
    std::shared_ptr<GradientBox> gradient() { return gradient_; }  ///< null: none
    void set_gradient(std::shared_ptr<GradientBox> gradient) { gradient_ = std::move(gradient); }
    std::shared_ptr<OcclusionBox> occlusion() { return occlusion_; }  ///< null: none
    void set_occlusion(std::shared_ptr<OcclusionBox> occlusion) { occlusion_ = std::move(occlusion); }

    std::uint32_t add(const std::shared_ptr<LightBox>& light);
    /// The material's index; it is added if the scene does not have it.
    std::uint32_t add(const std::shared_ptr<MaterialBox>& material);
    /// Likewise.
    std::uint32_t add(const std::shared_ptr<TextureBox>& texture);
    std::uint32_t add(const std::shared_ptr<ShapeBox>& shape);
    void set_lights(const std::vector<std::shared_ptr<LightBox>>& lights);
    void set_material(std::uint32_t index, const std::shared_ptr<MaterialBox>& material);
    void set_shape(std::uint32_t index, const std::shared_ptr<ShapeBox>& shape);
    void remove_shapes(std::vector<std::uint32_t> shapes);

    // For changes by arrays: the scene, to whose end so many shapes are then added.
    Scene& add_shapes(std::size_t count);
    /// Changes some shapes in place: change(scene) writes their parameters, materials, colors or transforms,
    /// and the objects of these shapes take them over. scene() must have been called since Python last ran.
    void edit_shapes(std::span<const std::uint32_t> shapes, const std::function<void(Scene&)>& change);
    /// How often shapes were removed, which gives others new numbers.
    std::uint64_t removals() const { return removals_; }
    void set_background(Color background);
    /// As glint::set_setting().
    void set_setting(const std::string& key, const std::string& value);
    void apply_profile(const std::string& profile);

    /// Issues the warnings that were not yet issued for this scene.
    void warn_once(const std::vector<Diagnostic>& diagnostics);

    /// Prepares what has changed. `overrides`: settings for this picture alone. `progress` may be None.
    /// is_quiet: issues no warnings; they are for the next call.
    Snapshot prepare(const SettingList& overrides, const py::object& progress, int threads = 0,
                     bool is_quiet = false);
    /// The same, and the snapshot's scene has these settings, too.
    Snapshot prepare_changed(const SettingList& overrides, const py::object& progress);

  private:
    Scene& own();  ///< for writing: a copy, if a snapshot has it
    void sync();
    void sync_materials();
    void sync_textures();
    void sync_lights();
    void sync_shapes();
    std::uint32_t index_of(const std::shared_ptr<MaterialBox>& material);
    std::uint32_t index_of(const std::shared_ptr<TextureBox>& texture);
    std::vector<std::uint32_t> indices_of(const std::vector<std::shared_ptr<MaterialBox>>& materials);
    /// With the number of its texture, which is added if the scene does not have it.
    Material whole(const MaterialBox& material);
    Texture whole(const TextureBox& texture);
    void write_transform(Shape& shape, const ShapeBox& box);
    /// What a shape has beside its parameters.
    void read_look(ShapeBox& box, std::uint32_t index);
    /// first, end: the shapes' numbers.
    void record_edit(std::uint32_t first, std::uint32_t end);
    void record_added(std::size_t count);
    void record_removed(std::vector<std::uint32_t> numbers);

    std::shared_ptr<Scene> scene_;
    // By index; only those that Python has asked for.
    std::unordered_map<std::uint32_t, std::shared_ptr<LightBox>> lights_;
    std::unordered_map<std::uint32_t, std::shared_ptr<MaterialBox>> materials_;
    std::unordered_map<std::uint32_t, std::shared_ptr<TextureBox>> textures_;
    std::unordered_map<std::uint32_t, std::shared_ptr<ShapeBox>> shapes_;
    std::unordered_map<const MaterialBox*, std::uint32_t> material_indices_;
    std::unordered_map<const TextureBox*, std::uint32_t> texture_indices_;
    std::shared_ptr<CameraBox> camera_;
    std::shared_ptr<FogBox> fog_;
    std::shared_ptr<GradientBox> gradient_;
    std::shared_ptr<OcclusionBox> occlusion_;

    Versions now_;
    // Edits of shapes in place, each with its number and its range of shapes.
    struct ShapesEdit {
        std::uint64_t edit = 0;
        std::uint32_t first = 0, end = 0;
    };
    std::uint64_t edits_ = 0;
    std::vector<ShapesEdit> edited_shapes_;
    std::uint64_t removals_ = 0;

    ShapeHistory history_;  // its version is now_.shapes

    bool has_world_ = false;
    World world_;
    std::size_t world_shapes_ = 0;
    Versions world_versions_;
    std::uint64_t world_edits_ = 0;
    std::vector<std::string> warned_;
};

/// Python's class Scene, without what glint/_scene.py adds.
void bind_scene(py::module_& m);
/// Its functions that take arrays.
void bind_arrays(py::class_<SceneState, std::shared_ptr<SceneState>>& cls);
/// Its functions that change many shapes by arrays.
void bind_shape_arrays(py::class_<SceneState, std::shared_ptr<SceneState>>& cls);
/// Its functions that read, render, and question the scene.
void bind_tools(py::module_& m, py::class_<SceneState, std::shared_ptr<SceneState>>& cls);
/// Its functions that compare it with another ray tracer's log.
void bind_diagnosis(py::module_& m, py::class_<SceneState, std::shared_ptr<SceneState>>& cls);

}  // namespace glint::python
