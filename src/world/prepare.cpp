// Scene -> World.
#include "base/fp_environment.h"
#include "base/guard.h"
#include "math/transform.h"
#include "world/pack_shapes.h"
#include "world/prepare_camera.h"

namespace glint {
namespace {

constexpr double k_least_direction = 1e-15;  // length of a light's

void put(std::vector<double>& to, Color c) { to.insert(to.end(), {c.r, c.g, c.b}); }

std::vector<double> pack_materials(const Scene& scene) {
    std::vector<double> packed;
    packed.reserve((scene.materials.size() + 1) * k_material_values);
    const auto pack = [&](const Material& m) {
        for (const Color& c : {m.ambient, m.diffuse, m.specular, m.color, m.mirror_tint, m.transmission_tint})
            put(packed, c);
        packed.insert(packed.end(), {m.shininess, m.mirror, m.transmission, m.ior});
    };
    for (const Material& m : scene.materials) pack(m);
    pack(Material{});
    return packed;
}

}  // namespace

void WorldDeleter::operator()(const World* world) const { delete world; }

PrepareResult prepare(const Scene& scene, int threads) {
    PrepareResult result;
    const std::string failure = guard([&] {
        const DefaultFpEnvironment environment;
        result.diagnostics = validate(scene);
        if (has_errors(result.diagnostics)) return;
        auto world = std::unique_ptr<World, WorldDeleter>(new World);
        world->conventions = scene.conventions;
        world->settings = scene.settings;
        world->background = scene.background;
        world->camera = prepare_camera(scene.camera, scene.settings);
        world->materials = pack_materials(scene);
        for (const Light& light : scene.lights) {
            if (light.kind == LightKind::ambient) {
                world->ambient = world->ambient + light.color;
            } else {
                world->lights.push_back(light);
                Vec3& to_light = world->lights.back().to_light;
                // Squares of shorter ones vanish.
                if (light.kind == LightKind::directional && length(to_light) < k_least_direction) {
                    to_light = normalize(to_light) * k_least_direction;
                }
            }
        }
        pack_shapes(scene, *world, threads);
        result.world = std::move(world);
    });
    if (!failure.empty()) {
        result.world.reset();
        Diagnostic d;
        d.message = failure + " while preparing the scene";
        result.diagnostics.push_back(std::move(d));
    }
    return result;
}

WorldMemory memory(const World& world) {
    WorldMemory m;
    for (const ShapeClass& c : world.classes) m.shapes += c.values.capacity() * sizeof(double);
    for (int a = 0; a < 3; ++a)
        m.boxes += (world.box_lo[a].capacity() + world.box_hi[a].capacity()) * sizeof(float);
    m.indices = (world.shape_index.capacity() + world.material.capacity()) * sizeof(std::uint32_t);
    m.packed = world.count;
    m.hierarchy = world.bvh.nodes.capacity() * sizeof(BvhNode);
    m.materials = world.materials.capacity() * sizeof(double) + world.lights.capacity() * sizeof(Light);
    return m;
}

Bounds bounds(const World& world) {
    const Aabb& b = world.bvh.bounds;
    return {{b.lo[0], b.lo[1], b.lo[2]}, {b.hi[0], b.hi[1], b.hi[2]}};
}

}  // namespace glint
