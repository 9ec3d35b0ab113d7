// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/write.h"

#include <fmt/format.h>

#include <utility>

#include "base/status.h"
#include "export/gltf/color_maps.h"
#include "export/gltf/meshes.h"
#include "export/gltf/placement.h"
#include "export/gltf/shapes.h"
#include "export/gltf/viewing.h"

namespace glint::gltf_export {
namespace {

// The fog and the like.
void warn_of_surroundings(const Scene& scene, Losses& losses) {
    if (scene.fog) losses.add("fog", "it is left out");
    if (scene.occlusion) losses.add("light from all directions (`occlusion`)", "it is left out");
    if (scene.gradient || scene.background != Color{}) losses.add("background", "it is left out");
}

// Whether a file of glTF is read with other conventions.
bool has_other_conventions(const Scene& scene) {
    Scene usual;
    if (!apply_profile(usual, "glint").ok()) return false;
    const auto keys = setting_keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const std::string_view name = keys[i].name;
        // The colors and the lights have what these say.
        if (name == "transfer" || name == "gamma" || name == "clamp_attenuation") continue;
        if (!keys[i].is_convention && name != "shading") continue;
        if (get_setting(scene, i) != get_setting(usual, i)) return true;
    }
    return false;
}

Result<std::string> write(const Scene& given, bool is_binary) {
    std::vector<Diagnostic> diagnostics = validate(given);
    if (has_errors(diagnostics)) return invalid_scene(std::move(diagnostics));
    File file;
    Losses losses;
    const std::optional<Scene> changed = with_mean_colors(given, losses);
    const Scene& scene = changed ? *changed : given;
    const ColorRule rule(scene.conventions);
    TextureList textures(scene, rule, file, losses);
    MaterialList materials(scene, rule, file, textures, losses);
    MeshList meshes(file, materials, losses);
    Affine file_from_world;
    if (is_left_handed(scene.camera)) file_from_world.m[2][2] = -1;
    const ShapeMeshes shapes(scene, file_from_world, losses);
    for (const PlacedMesh& placed : shapes.placed()) {
        const std::uint32_t mesh = meshes.use(*placed.mesh, placed.material, placed.color, placed.name, rule);
        if (mesh == k_no_index) continue;
        Json node = Json::object();
        if (!placed.name.empty()) node["name"] = placed.name;
        node["mesh"] = mesh;
        add_placement(node, placed.file_from_mesh);
        file.add(List::nodes, node);
    }
    add_camera(file, scene, file_from_world, shapes.box(), losses);
    add_lights(file, scene, file_from_world, shapes, losses);
    warn_of_surroundings(scene, losses);
    if (has_other_conventions(scene))
        losses.add("conventions of other renderers", "the scene is read with those of the profile `glint`");
    std::vector<Diagnostic> warnings =
        losses.warnings(scene.files.empty() ? std::string() : scene.files.front());
    return {std::move(file).finish(is_binary), std::move(warnings)};
}

}  // namespace

Result<std::string> write_binary(const Scene& scene) {
    return result_of([&] { return write(scene, true); }, " while writing the scene as glTF");
}

Result<std::string> write_text(const Scene& scene) {
    return result_of([&] { return write(scene, false); }, " while writing the scene as glTF");
}

}  // namespace glint::gltf_export
