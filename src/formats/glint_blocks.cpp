// SPDX-License-Identifier: Apache-2.0
#include "formats/glint_blocks.h"

#include "formats/glint_solid.h"

namespace glint {

std::vector<std::string_view> key_names(std::span<const Field> fields) {
    std::vector<std::string_view> names;
    for (const Field& field : fields) names.push_back(field.name);
    return names;
}

std::optional<SolidOperation> solid_operation(std::string_view word) {
    for (const SolidOperation operation : k_combinations) {
        if (to_string(operation) == word) return operation;
    }
    return std::nullopt;
}

std::vector<GlintBlock> glint_blocks() {
    std::vector<GlintBlock> blocks;
    add_shape_blocks(blocks);
    for (const SolidOperation operation : k_combinations)
        blocks.push_back({to_string(operation), key_names(k_solid_fields)});
    blocks.push_back({"group", key_names(k_item_fields)});
    blocks.push_back({"material", key_names(k_material_keys)});
    blocks.push_back({"texture", key_names(glint_texture_keys())});
    blocks.push_back({"light", key_names(glint_light_keys())});
    blocks.push_back({"camera", key_names(glint_camera_keys())});
    blocks.push_back({"fog", key_names(glint_fog_keys())});
    blocks.push_back({"occlusion", key_names(glint_occlusion_keys())});
    blocks.push_back({"background_gradient", key_names(glint_gradient_keys())});
    GlintBlock render{"render", {}}, conventions{"conventions", {}};
    for (const SettingKey& key : setting_keys())
        (key.is_convention ? conventions : render).keys.push_back(key.name);
    blocks.push_back(std::move(render));
    blocks.push_back(std::move(conventions));
    return blocks;
}

}  // namespace glint
