// SPDX-License-Identifier: Apache-2.0
// Which extensions of glTF glint reads.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/text.h"
#include "formats/gltf/file.h"

namespace glint::gltf {
namespace {

// Those that the reader uses, and those that change nothing in a picture of the file at rest.
constexpr std::string_view k_read[] = {"EXT_mesh_gpu_instancing", "KHR_animation_pointer",
                                       "KHR_lights_punctual",     "KHR_materials_emissive_strength",
                                       "KHR_materials_ior",       "KHR_materials_pbrSpecularGlossiness",
                                       "KHR_materials_specular",  "KHR_materials_transmission",
                                       "KHR_materials_unlit",     "KHR_materials_variants",
                                       "KHR_materials_volume",    "KHR_mesh_quantization",
                                       "KHR_texture_transform",   "KHR_xmp",
                                       "KHR_xmp_json_ld"};

bool is_read(const std::string& name) {
    return std::find(std::begin(k_read), std::end(k_read), name) != std::end(k_read);
}

}  // namespace

bool check_extensions(File& file) {
    bool is_right = true;
    CountedMap<std::string, bool> refused;
    const JsonValue required = file.root().find("extensionsRequired");
    if (required.exists() && !required.is(JsonKind::list))
        return file.expected(required, "a list", "extensionsRequired");
    required.for_each([&](JsonValue value) {
        if (is_read(value.string()) || !file.is_alive()) return;
        is_right = false;
        if (!value.is(JsonKind::string)) {
            file.expected(value, "the name of an extension");
        } else if (refused.emplace(value.string(), true).second) {
            file.error(value, fmt::format("the file requires the extension {}, which glint does not read",
                                          quoted(value.string())));
        }
    });
    if (!is_right) return false;
    file.root().find("extensionsUsed").for_each([&](JsonValue value) {
        if (!value.is(JsonKind::string) || is_read(value.string())) return;
        file.warn_once("gltf extension " + value.string().substr(0, 100), value,
                       fmt::format("glint ignores the extension {}", quoted(value.string())));
    });
    return true;
}

}  // namespace glint::gltf
