// SPDX-License-Identifier: Apache-2.0
// Height fields to the Scene. One that is not smooth, or stands at several places in the same way, is stored
// once.
#include "formats/povray/add_shape.h"
#include "formats/povray/field_mesh.h"

namespace glint::povray {

void SceneBuilder::place_field(const Object& object, const Inherited& own) {
    if (!object.field || object.field->heights.empty()) return;  // it is reported
    const HeightField& field = *object.field;
    const Affine cube = cube_from_grid(field);
    const Affine map = own.map ? compose(*own.map, cube) : cube;
    auto back = inverse(map);
    if (!back) return stream_.error(object.at, "the height_field's transform leaves nothing of it");
    for (auto& row : back->m) row[3] = 0;
    PlacedField& placed = fields_[&field];
    if (placed.index == k_none || (field.is_smooth && !(placed.object_from_world == *back))) {
        if (!stream_.has_room(bytes_of_mesh(field), object.at)) return;
        auto [data, is_coarse] = mesh_of_field(field, *back);
        if (data->triangles.empty()) return;  // all is below the water
        if (is_coarse) {
            stream_.warn_once(
                "coarse height_field", object.at,
                "the normals of this smooth height_field are linear in the triangles of so many "
                "texels, not bilinear in their squares as in POV-Ray: the picture will differ");
        }
        placed = {object.field, *back, static_cast<std::uint32_t>(scene_.meshes.size())};
        scene_.meshes.push_back(std::move(data));
        if (!stream_.is_within_memory(object.at)) return;
    }
    Inherited field_own = own;
    field_own.uv_source = UvSource::unknown;
    add(Mesh{placed.index}, material_of(field_own, object.at), &map, object.at);
}

}  // namespace glint::povray
