#pragma once
// The World: a Scene prepared for tracing.
#include <cstdint>
#include <vector>

#include "bvh/bvh.h"
#include "glint/render.h"

namespace glint {

/// Shapes of one kind, transformed or not, packed as columns: value k of the class's item i is values[k *
/// stride + i].
struct ShapeClass {
    ShapeKind kind = ShapeKind::sphere;
    bool transformed = false;
    std::uint32_t first = 0;  // its items are slots [first, first + count) of the world
    std::uint32_t count = 0;
    std::uint32_t stride = 0;  // count and a vector of padding
    std::vector<double> values;
    const double* column(int k) const { return values.data() + static_cast<std::size_t>(k) * stride; }
};

/// A material as the kernels gather it: doubles in the order of MaterialValue.
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

/// The camera as a pixel's ray needs it: a viewport point is forward + right sx + up sy, sx and sy in [-1/2,
/// 1/2].
struct PreparedCamera {
    Projection projection = Projection::perspective;
    Vec3 position, right, up, forward;
    bool has_lighting_eye = false;
    Vec3 lighting_eye;
};

/// Slots number the shapes as the world packs them: the bounded ones in the hierarchy's leaf order within
/// their class, then the unbounded ones. All arrays by slot are padded by a vector.
class World {
  public:
    std::vector<ShapeClass> classes;          // bounded classes first
    std::uint32_t boxed = 0;                  // slots below this have their box stored
    std::uint32_t bounded = 0;                // slots below this are in the hierarchy
    std::uint32_t count = 0;                  // slots
    Bvh bvh;                                  // its leaves refer to slots; its order is dropped
    std::vector<float> box_lo[3], box_hi[3];  // by slot: the shape's own padded box; a triangle's is computed
    std::vector<std::uint32_t> shape_index;   // by slot: the index in Scene::shapes
    std::vector<std::uint32_t> material;      // by slot: the material, k_turn_normal, k_no_shadow

    std::vector<double> materials;  // k_material_values each; the last is the default material
    std::vector<Light> lights;      // point and directional, in scene order
    Color ambient{0, 0, 0};         // I_a: the sum of the ambient lights
    Color background;
    PreparedCamera camera;
    Conventions conventions;
    RenderSettings settings;

    /// The class that a slot belongs to.
    const ShapeClass& class_of(std::uint32_t slot) const {
        std::size_t c = 0;
        while (slot - classes[c].first >= classes[c].count) ++c;
        return classes[c];
    }
};

/// Set in World::material where the convention turns the normal towards the incoming ray.
inline constexpr std::uint32_t k_turn_normal = 0x80000000u;
/// Set in World::material where the convention lets the surface cast no shadow.
inline constexpr std::uint32_t k_no_shadow = 0x40000000u;
inline constexpr std::uint32_t k_material_index = ~(k_turn_normal | k_no_shadow);

}  // namespace glint
