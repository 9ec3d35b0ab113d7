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
#include "world/extended_materials.h"
#include "world/packed_geometry.h"
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

/// The camera as viewport_ray (trace/camera_rays-inl.h) needs it.
struct PreparedCamera {
    Projection projection = Projection::perspective;
    Vec3 position, right, up, forward;
    bool has_lighting_eye = false;
    Vec3 lighting_eye;
};

/// A light that is not ambient, with what the kernels need beside its fields.
struct PreparedLight : Light {
    Vec3 unit_axis;  // of spots; of one-sided area lights, their normal
    SpotCone cone;
    std::uint32_t index = 0;   // in Scene::lights
    std::int32_t sample = -1;  // of an area light, where each sample is a light of its own; else -1
    AreaGrid area;
};

/// The color of an ambient light, by its index in Scene::lights.
struct AmbientLight {
    std::uint32_t index = 0;
    Color color;
};

/// The objects that rays are inside, for FogExtent::outside_objects. A set of objects is the exclusive or of
/// their words (WorldParts::interior_word): 0 is the empty set, and a surface that is passed adds its object
/// or removes it. Two objects never have the same word; more have the word 0 in one of 2^32 cases.
struct FogInteriors {
    bool tracked = false;      // rays know theirs: a surface lets light through, or the camera is inside
    std::uint32_t camera = 0;  // the objects that contain the camera
};

struct WorldParts {
    CopyOnWrite<PackedGeometry> geometry;
    CopyOnWrite<std::vector<std::uint32_t>> slot_material;  // by slot, padded: the row in `materials`
    CopyOnWrite<std::vector<double>> materials;  // k_material_values each; the default material is last
    // By slot, padded: r, g, b of the shape's own color, NaN without one; empty: no shape has one.
    CopyOnWrite<std::vector<float>> slot_color;
    // By row of `materials`: the factors of find_color_factors(); empty like slot_color.
    CopyOnWrite<std::vector<double>> color_factors;
    CopyOnWrite<std::vector<std::uint8_t>> no_shadow;  // by row of `materials`; empty: all cast shadows
    CopyOnWrite<std::vector<double>>
        extended;                      // k_extended_values each, by row of `materials`; empty: no uses
    ExtendedFields extended_uses = 0;  // the fields in which a material differs from the default
    CopyOnWrite<std::vector<PreparedLight>> lights;  // all but the ambient ones, in scene order
    CopyOnWrite<std::vector<AmbientLight>> ambient_lights;
    Color ambient{0, 0, 0};  // I_a: the sum of the ambient lights
    Color background;
    std::optional<Fog> fog;
    std::optional<BackgroundGradient> gradient;  // `up` is a unit vector
    std::optional<Occlusion> occlusion;
    double direct = 1;  // the factor of the light of the lights but the ambient ones (Occlusion::direct)
    CopyOnWrite<std::vector<Vec3>> occlusion_directions;  // method fixed: k_occlusion_blocks times samples
    Camera scene_camera;  // from which `camera` was prepared, for the settings' size
    PreparedCamera camera;
    Conventions conventions;
    RenderSettings settings;
    FogInteriors interiors;
    TracerFault fault = TracerFault::none;  // for compare
    bool last_of_equals = false;            // for check: of shapes hit at the same t, the last one is the hit

    /// A row of the table of materials.
    const double* material(std::uint32_t row) const {
        return materials->data() + static_cast<std::size_t>(row) * k_material_values;
    }
    /// Whether a material uses the extended field: world.uses<&Material::emission>().
    template <auto Member> bool uses() const { return (extended_uses & k_extended_field<Member>) != 0; }
    /// Whether a row of the table has mirror rays, in some direction.
    bool is_mirror(std::uint32_t row) const {
        return material(row)[k_mirror] > 0 ||
               (uses<&Material::mirror_falloff>() &&
                extended_row(row)[k_extended_value<&Material::mirror_falloff>] > 0 &&
                extended_row(row)[k_extended_value<&Material::mirror_min>] > 0);
    }
    /// A row of the second table, which must exist.
    const double* extended_row(std::uint32_t row) const {
        return extended->data() + static_cast<std::size_t>(row) * k_extended_values;
    }
    /// The own color of a slot's shape; not set if it has none.
    ShapeColor color_of(std::uint32_t slot) const {
        if (slot_color->empty()) return {};
        const float* c = slot_color->data() + 3 * std::size_t{slot};
        return {c[0], c[1], c[2]};
    }
    /// Writes the k_material_values of a slot's shape: its material's row, with the shape's own color.
    void write_surface_values(std::uint32_t slot, double* to) const {
        const std::uint32_t row = (*slot_material)[slot];
        std::copy_n(material(row), k_material_values, to);
        const ShapeColor color = color_of(slot);
        if (!color.is_set()) return;
        const double channels[3] = {color.r, color.g, color.b};
        const double* factors = color_factors->data() + std::size_t{row} * k_color_factors;
        for (int c = 0; c < 3; ++c) {
            to[k_color + c] = channels[c];
            for (int i = 0; i < k_color_factors; ++i) {  // of k_ambient, k_diffuse and k_specular
                if (factors[i] == factors[i]) to[3 * i + c] = factors[i] * channels[c];
            }
        }
    }
    std::array<double, k_material_values> surface_values(std::uint32_t slot) const {
        std::array<double, k_material_values> values{};
        write_surface_values(slot, values.data());
        return values;
    }
    /// The number of the scene's materials; the default material follows them.
    std::uint32_t scene_materials() const {
        return static_cast<std::uint32_t>(materials->size() / k_material_values - 1);
    }
    /// Whether the scene may have transparent materials (Material::filter, transmit).
    bool has_transparency() const {
        return (extended_uses &
                (k_extended_field<&Material::filter> | k_extended_field<&Material::transmit>)) != 0;
    }
    bool is_transparent(std::uint32_t row) const {
        if (!has_transparency()) return false;
        const double* const values = extended->data() + static_cast<std::size_t>(row) * k_extended_values;
        return values[k_extended_value<&Material::filter>] > 0 ||
               values[k_extended_value<&Material::transmit>] > 0;
    }
    /// Whether transparent surfaces color the light that passes them.
    bool colors_shadows() const {
        return has_transparency() && conventions.transparent_shadow == TransparentShadow::colored;
    }
    /// The word of the object to which a slot's shape belongs (FogInteriors); 0: it is hollow.
    std::uint32_t interior_word(std::uint32_t slot) const {
        std::uint32_t number = geometry->shape_index[slot];
        if (!extended->empty()) {
            const double* const values = extended_row((*slot_material)[slot]);
            if (values[k_extended_value<&Material::hollow>] > 0) return 0;
            const double interior = values[k_extended_value<&Material::interior>];
            if (interior > 0) number = 0x80000000u | static_cast<std::uint32_t>(interior);
        }
        return lowbias32(number + 1);
    }
    /// Whether the conventions flip the normal of a slot's shape towards the incoming ray.
    bool flips_normal(std::uint32_t slot) const {
        return conventions.facing == Facing::all || conventions.facing == Facing::winding ||
               (conventions.facing == Facing::open && geometry->is_open(slot));
    }
    /// Whether a ray of this direction hits a slot's shape from behind. normal: at the hit, not flipped.
    bool hits_from_behind(std::uint32_t slot, Vec3 normal, Vec3 incoming) const {
        const bool by_winding = conventions.facing == Facing::winding && geometry->is_smooth_triangle(slot);
        return dot(by_winding ? geometry->face_normal(slot) : normal, incoming) > 0;
    }
    /// Whether the conventions and the material let a slot's shape block light.
    bool casts_shadow(std::uint32_t slot) const {
        if (!no_shadow->empty() && (*no_shadow)[(*slot_material)[slot]] != 0) return false;
        if (conventions.transparent_shadow != TransparentShadow::opaque &&
            is_transparent((*slot_material)[slot]))
            return false;
        return conventions.glass_shadow != GlassShadow::none ||
               !(material((*slot_material)[slot])[k_transmission] > 0);
    }
    /// With colors_shadows(): whether a slot's shape, which does not block light, colors it.
    bool colors_light(std::uint32_t slot) const {
        const std::uint32_t row = (*slot_material)[slot];
        return is_transparent(row) && (no_shadow->empty() || (*no_shadow)[row] == 0);
    }
    /// The factor of light that passes a slot's transparent shape: transmit + filter * color.
    Color shadow_factor(std::uint32_t slot) const {
        const std::uint32_t row = (*slot_material)[slot];
        const double* const values = extended->data() + static_cast<std::size_t>(row) * k_extended_values;
        const ShapeColor own = color_of(slot);
        const double* const k = material(row) + k_color;
        const Color color = own.is_set() ? own.color() : Color{k[0], k[1], k[2]};
        const double filter = values[k_extended_value<&Material::filter>],
                     transmit = values[k_extended_value<&Material::transmit>];
        return {transmit + filter * color.r, transmit + filter * color.g, transmit + filter * color.b};
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
