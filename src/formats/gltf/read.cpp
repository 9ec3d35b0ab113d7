// SPDX-License-Identifier: Apache-2.0
// .gltf and .glb: glTF 2.0. docs/formats/gltf.md.
#include "formats/gltf/contents.h"
#include "formats/profile_file.h"
#include "formats/registry.h"

namespace glint {
namespace gltf {
namespace {

// The ambient light of a file without lights: the ambient coefficient is the color.
constexpr double k_ambient_light = 0.1;

void read(LoadState& reading, const ReadText& text) {
    File file(reading, text);
    if (!file.open() || !check_extensions(file)) return;
    Nodes nodes(file);
    if (!nodes.place()) return;
    Buffers buffers(file);
    Accessors accessors(file, buffers);
    Textures textures(file, buffers);
    Materials materials(file, textures);
    Meshes meshes(file, accessors, materials);
    const std::size_t shapes = reading.scene.shapes.size(), lights = reading.scene.lights.size();
    Contents(file, accessors, meshes, nodes).add();
    if (!file.is_alive() || !file.go_on(file.root()) || reading.diagnostics.any_errors()) return;
    const bool has_lights = text.is_included && reading.scene.lights.size() > lights;
    if (reading.scene.shapes.size() == shapes && !has_lights) {
        file.error(file.root(), "the scene has no triangles");
        return;
    }
    if (text.is_included) return;
    reading.lone_mesh = text.file;
    reading.mesh_ambient_light = k_ambient_light;
}

}  // namespace
}  // namespace gltf

// Colors are linear, and pictures are seen as sRGB.
void set_gltf_defaults(Scene& scene) {
    set_named_setting(scene, "transfer", "srgb", {SettingOrigin::Kind::file, {1, 1, 0}});
}

void read_gltf(LoadState& reading, const ReadText& text) { gltf::read(reading, text); }

}  // namespace glint
