// SPDX-License-Identifier: Apache-2.0
#pragma once
// The parts of a World (glint/world.h), in the form that the kernels read.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/copy_on_write.h"
#include "glint/world.h"
#include "lighting/light.h"
#include "math/sample_hash.h"
#include "scene/material_color.h"
#include "world/appearance/extended_materials.h"
#include "world/appearance/texture.h"
#include "world/geometry/packed_geometry.h"
#include "world/tracer_fault.h"

namespace glint {

/// A material as the kernels load it: doubles in the order of MaterialValue.
enum MaterialValue : int {
    k_ambient = 0,
    k_diffuse = 3,
    k_specular = 6,
    k_color = 9,
    k_mirror_tint = 12,
    k_transmission_tint = 15,
    k_shininess = 18,
    k_mirror = 19,
    k_transmission = 20,
    k_ior = 21,
    k_material_values = 22,
};

/// The camera as viewport_ray (trace/rays/camera_rays-inl.h) needs it.
struct PreparedCamera {
    Projection projection = Projection::perspective;
    Vec3 position, right, up, forward;
    bool has_lighting_eye = false;
    Vec3 lighting_eye;
};

/// A light that is not ambient, with what the kernels need beside its fields.
struct PreparedLight : Light {
    Vec3 unit_axis;  // of spots; of one-sided area lights, their normal
    SpotCone spot_cone;
    std::uint32_t index = 0;   // in Scene::lights
    std::int32_t sample = -1;  // of an area light, where each sample is a light of its own; else -1
    AreaGrid area;
};

/// The color of an ambient light, by its index in Scene::lights.
struct AmbientLight {
    std::uint32_t index = 0;
    Color color;
};

/// The objects that rays are inside, for FogExtent::outside_objects and Material::refracts. A set of objects
/// is the exclusive or of their words (interior_word() of world/appearance/appearance.h): 0 is the empty set,
/// and a surface that is passed adds its object or removes it. Two objects never have the same word; more
/// have the word 0 in one of 2^32 cases.
struct Interiors {
    bool tracked = false;      // rays know theirs: a surface lets light through, or the camera is inside
    bool without_fog = false;  // FogExtent::outside_objects
    std::uint32_t camera = 0;  // the objects that contain all points where camera rays start
    std::uint32_t unbent = 0;  // those of them that do not refract
    std::vector<std::uint32_t> cutting;  // slots of shapes that contain some of them (orthographic cameras)
    struct Refracting {
        std::uint32_t word = 0;
        double ior = 1;
        bool hollow = false;
        bool operator==(const Refracting&) const = default;
    };
    std::vector<Refracting> refracting;  // the objects that refract, by word
    bool has_hollow = false;             // some of these are
};

/// Which surface is hit if a ray hits several at one t, in the order of PackedGeometry::precedes(). `last` is
/// for shapes only: of one shape's elements, the first one is hit.
enum class TieRule : std::uint8_t { first, last };

/// world/appearance/appearance.h answers what depends on a surface.
struct WorldParts {
    CopyOnWrite<PackedGeometry> geometry;
    CopyOnWrite<std::vector<std::uint32_t>> slot_material;  // by slot, padded: the row in `materials`
    CopyOnWrite<std::vector<double>> materials;  // k_material_values each; the default material is last
    // By slot, padded: r, g, b of the shape's own color, NaN without one; empty: no shape has one.
    CopyOnWrite<std::vector<float>> slot_color;
    // By row of `materials`: the factors of find_color_factors(); empty if has_surface_colors() is false.
    CopyOnWrite<std::vector<double>> color_factors;
    CopyOnWrite<std::vector<PreparedTexture>> textures;  // of Scene::textures
    bool has_alpha_textures = false;                     // a material has one: set_texture_uses()
    bool has_emission_textures = false;                  // a material has one with TextureMix::multiply_all
    bool has_holes = false;                              // surfaces may have some: is_hole()
    CopyOnWrite<std::vector<std::uint8_t>> no_shadow;    // by row of `materials`; empty: all cast shadows
    CopyOnWrite<std::vector<double>>
        extended;                      // k_extended_values each, by row of `materials`; empty: no uses
    ExtendedFields extended_uses = 0;  // the fields in which a material differs from the default
    CopyOnWrite<std::vector<PreparedLight>> lights;  // all but the ambient ones, in scene order
    CopyOnWrite<std::vector<AmbientLight>> ambient_lights;
    Color ambient{0, 0, 0};  // I_a: the sum of the ambient lights
    Color background;
    std::optional<Fog> fog;
    Color fog_tint{1, 1, 1};  // the factor of what is seen through it (Fog::filter): set_fog()
    std::optional<BackgroundGradient> gradient;  // `up` is a unit vector
    std::optional<Occlusion> occlusion;
    double direct = 1;  // the factor of the light of the lights but the ambient ones (Occlusion::direct)
    CopyOnWrite<std::vector<Vec3>> occlusion_directions;  // method fixed: k_occlusion_blocks times samples
    Camera scene_camera;  // from which `camera` was prepared, for the settings' size
    PreparedCamera camera;
    Conventions conventions;
    RenderSettings settings;
    Interiors interiors;
    TracerFault fault = TracerFault::none;  // for compare
    TieRule ties = TieRule::first;          // for check

    /// Whether the shading mode has light.
    bool has_lighting() const {
        return settings.shading != Shading::color && settings.shading != Shading::normals;
    }
    /// A row of the table of materials.
    const double* material(std::uint32_t row) const {
        return materials->data() + static_cast<std::size_t>(row) * k_material_values;
    }
    /// Whether a material uses the extended field: world.uses<&Material::emission>().
    template <auto Member> bool uses() const { return (extended_uses & k_extended_field<Member>) != 0; }
    /// Whether a row of the table has mirror rays, in some direction.
    bool is_mirror(std::uint32_t row) const {
        return material(row)[k_mirror] > 0 ||
               ((uses<&Material::mirror_falloff>() || uses<&Material::mirror_fresnel>()) &&
                extended_row(row)[k_extended_value<&Material::mirror_falloff>] +
                        extended_row(row)[k_extended_value<&Material::mirror_fresnel>] >
                    0 &&
                extended_row(row)[k_extended_value<&Material::mirror_min>] > 0);
    }
    /// A row of the second table, which must exist.
    const double* extended_row(std::uint32_t row) const {
        return extended->data() + static_cast<std::size_t>(row) * k_extended_values;
    }
    /// Whether surfaces may have other colors than their materials: their own, or that of a texture.
    bool has_surface_colors() const { return !slot_color->empty() || uses<&Material::texture>(); }
    /// Whether the color of a surface may differ from point to point.
    bool has_point_colors() const { return geometry->has_mesh_colors || uses<&Material::texture>(); }
    /// The number of the scene's materials; the default material follows them.
    std::uint32_t scene_materials() const {
        return static_cast<std::uint32_t>(materials->size() / k_material_values - 1);
    }
    /// Whether the scene may have transparent materials (Material::filter, transmit).
    bool has_transparency() const {
        return (extended_uses &
                (k_extended_field<&Material::filter> | k_extended_field<&Material::transmit>)) != 0;
    }
    /// Whether surfaces of a row's material may be transparent.
    bool is_transparent(std::uint32_t row) const {
        if (!has_transparency()) return false;
        const double* const values = extended_row(row);
        return values[k_extended_value<&Material::filter>] > 0 ||
               values[k_extended_value<&Material::transmit>] > 0 ||
               (has_alpha_textures && has_alpha_texture(row));
    }
    /// Whether values of the second table differ from point to point.
    bool has_extended_points() const { return has_alpha_textures || has_emission_textures; }
    /// The texture of a row's material, or null.
    const PreparedTexture* texture_of(std::uint32_t row) const {
        if (!uses<&Material::texture>()) return nullptr;
        const double index = extended_row(row)[k_extended_value<&Material::texture>];
        return index < static_cast<double>(textures->size()) ? &(*textures)[static_cast<std::size_t>(index)]
                                                             : nullptr;
    }
    std::uint32_t index_of(const PreparedTexture& texture) const {
        return static_cast<std::uint32_t>(&texture - textures->data());
    }
    bool has_alpha_texture(std::uint32_t row) const {
        const PreparedTexture* const texture = texture_of(row);
        return texture != nullptr && texture->has_alpha();
    }
    /// Whether transparent surfaces color the light that passes them.
    bool colors_shadows() const {
        return has_transparency() && conventions.transparent_shadow == TransparentShadow::colored;
    }
};

inline Bounds to_bounds(const Aabb& box) {
    return {{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}};
}

/// Creates Worlds, and gives the library's code write access.
class WorldAccess {
  public:
    static World make(WorldParts parts);
    /// The World's parts for writing; copied first if another World shares them. Throws std::bad_alloc.
    static WorldParts& own(World& world);
};

}  // namespace glint
