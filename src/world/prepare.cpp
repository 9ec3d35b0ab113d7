// Scene -> World.
#include <algorithm>
#include <array>

#include "base/fp_environment.h"
#include "base/guard.h"
#include "base/parallel_for.h"
#include "bvh/rays.h"
#include "geometry/kinds-inl.h"
#include "math/transform.h"
#include "world/prepare_camera.h"
#include "world/world.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

// A class is a kind, transformed or not.
constexpr int k_classes = 2 * k_shape_kinds;
int class_number(const Shape& s) { return 2 * static_cast<int>(s.kind) + (s.transform != k_none ? 1 : 0); }

// What a kind says of itself, whatever its type: how many values, its box, its packed values, whether it is open.
struct KindFacts {
    int values = 0;
    bool bounded = true;
    template <class Geometry> void visit() {
        values = Geometry::k_values;
        bounded = Geometry::k_bounded;
    }
};
KindFacts kind_facts(int class_number) {
    KindFacts facts;
    visit_geometry(static_cast<ShapeKind>(class_number / 2), class_number % 2 == 1, facts);
    return facts;
}

template <class Visit>
void with_parameters(const Scene& scene, const Shape& shape, Visit&& visit) {
    switch (shape.kind) {
#define GLINT_KIND(Type, word)                                         \
    case ShapeKind::word:                                              \
        visit(scene.get<Type>()[shape.index], Type##Geometry());       \
        break;
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    }
}

// The box of a box's corners under a map.
void transform_bounds(const Affine& map, Vec3& lo, Vec3& hi) {
    Vec3 new_lo, new_hi;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p = transform_point(map, {corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z});
        if (corner == 0) new_lo = new_hi = p;
        new_lo = {std::min(new_lo.x, p.x), std::min(new_lo.y, p.y), std::min(new_lo.z, p.z)};
        new_hi = {std::max(new_hi.x, p.x), std::max(new_hi.y, p.y), std::max(new_hi.z, p.z)};
    }
    lo = new_lo;
    hi = new_hi;
}

Box shape_box(const Scene& scene, const Shape& shape) {
    Vec3 lo, hi;
    with_parameters(scene, shape, [&](const auto& parameters, auto geometry) { geometry.bounds(parameters, lo, hi); });
    if (shape.transform != k_none) transform_bounds(scene.transforms[shape.transform], lo, hi);
    return padded_box(lo, hi);
}

bool turns_normal(const Scene& scene, const Shape& shape) {
    if (scene.conventions.facing != Facing::open) return scene.conventions.facing == Facing::all;
    bool open = false;
    with_parameters(scene, shape, [&](const auto& parameters, auto geometry) { open = geometry.open(parameters); });
    return open;
}

void put(std::vector<double>& to, Color c) { to.insert(to.end(), {c.r, c.g, c.b}); }

std::vector<double> pack_materials(const Scene& scene) {
    std::vector<double> packed;
    packed.reserve((scene.materials.size() + 1) * k_material_values);
    const auto pack = [&](const Material& m) {
        for (const Color& c : {m.ambient, m.diffuse, m.specular, m.color, m.mirror_tint, m.transmission_tint}) put(packed, c);
        packed.insert(packed.end(), {m.shininess, m.mirror, m.transmission, m.ior});
    };
    for (const Material& m : scene.materials) pack(m);
    pack(Material{});
    return packed;
}

// Lays the shapes out by class and, within a class, in the order given; fills everything that is by slot.
class Packer {
  public:
    Packer(const Scene& scene, World& world) : scene_(scene), world_(world) {}

    // items: indices into Scene::shapes in the order wanted within each class, bounded ones only.
    void pack(const std::vector<std::uint32_t>& items, int threads) {
        std::array<std::uint32_t, k_classes> count{};
        for (const Shape& s : scene_.shapes) ++count[class_number(s)];
        std::array<int, k_classes> order{};
        for (int c = 0; c < k_classes; ++c) order[c] = c;
        std::stable_partition(order.begin(), order.end(), [](int c) { return kind_facts(c).bounded; });
        std::array<std::uint32_t, k_classes> next{};
        for (const int c : order) {
            const KindFacts facts = kind_facts(c);
            next[c] = world_.count;
            world_.count += count[c];
            if (facts.bounded) world_.bounded = world_.count;
            if (count[c] == 0) continue;
            ShapeClass packed;
            packed.kind = static_cast<ShapeKind>(c / 2);
            packed.transformed = c % 2 == 1;
            packed.first = next[c];
            packed.count = count[c];
            packed.stride = count[c] + k_ray_padding;
            packed.values.resize(static_cast<std::size_t>(packed.stride) * facts.values);
            world_.classes.push_back(std::move(packed));
        }
        const std::size_t padded = world_.count + k_ray_padding;
        for (int a = 0; a < 3; ++a) {
            world_.box_lo[a].assign(padded, 0);
            world_.box_hi[a].assign(padded, 0);
        }
        world_.shape_index.assign(padded, 0);
        world_.material.assign(padded, 0);
        slot_.resize(scene_.shapes.size());
        for (const std::uint32_t i : items) slot_[i] = next[class_number(scene_.shapes[i])]++;
        for (std::uint32_t i = 0; i < scene_.shapes.size(); ++i) {
            const int c = class_number(scene_.shapes[i]);
            if (!kind_facts(c).bounded) slot_[i] = next[c]++;
        }
        constexpr std::size_t chunk = 16384;
        parallel_for((scene_.shapes.size() + chunk - 1) / chunk, threads, [&](std::size_t block) {
            const std::size_t end = std::min(scene_.shapes.size(), (block + 1) * chunk);
            for (std::size_t i = block * chunk; i < end; ++i) fill(static_cast<std::uint32_t>(i));
        });
    }

    std::uint32_t slot(std::uint32_t shape) const { return slot_[shape]; }

  private:
    void fill(std::uint32_t i) {
        const Shape& shape = scene_.shapes[i];
        const std::uint32_t slot = slot_[i];
        world_.shape_index[slot] = i;
        const auto last = static_cast<std::uint32_t>(scene_.materials.size());  // the default material
        world_.material[slot] = (shape.material == k_none ? last : shape.material) |
                                (turns_normal(scene_, shape) ? k_turn_normal : 0);
        auto& packed = const_cast<ShapeClass&>(world_.class_of(slot));
        std::array<double, 64> values;
        int n = 0;
        with_parameters(scene_, shape, [&](const auto& parameters, auto geometry) {
            static_assert(decltype(geometry)::k_values + 12 <= 64);
            geometry.pack(parameters, values.data());
            n = decltype(geometry)::k_values;
        });
        if (shape.transform != k_none) {
            // validate() has made sure that it can be inverted.
            const Affine object_from_world = inverse(scene_.transforms[shape.transform]).value_or(Affine{});
            for (const auto& row : object_from_world.m) {
                for (const double value : row) values[n++] = value;
            }
        }
        for (int k = 0; k < n; ++k) {
            packed.values[static_cast<std::size_t>(k) * packed.stride + (slot - packed.first)] = values[k];
        }
        if (slot >= world_.bounded) return;
        const Box box = shape_box(scene_, shape);
        for (int a = 0; a < 3; ++a) {
            world_.box_lo[a][slot] = box.lo[a];
            world_.box_hi[a][slot] = box.hi[a];
        }
    }

    const Scene& scene_;
    World& world_;
    std::vector<std::uint32_t> slot_;
};

void build_geometry(const Scene& scene, World& world, int threads) {
    std::vector<std::uint32_t> items;
    std::vector<Box> boxes;
    std::vector<std::uint8_t> item_class;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        const int c = class_number(scene.shapes[i]);
        if (!kind_facts(c).bounded) continue;
        items.push_back(i);
        item_class.push_back(static_cast<std::uint8_t>(c));
    }
    boxes.resize(items.size());
    constexpr std::size_t chunk = 16384;
    parallel_for((items.size() + chunk - 1) / chunk, threads, [&](std::size_t block) {
        const std::size_t end = std::min(items.size(), (block + 1) * chunk);
        for (std::size_t i = block * chunk; i < end; ++i) boxes[i] = shape_box(scene, scene.shapes[items[i]]);
    });
    world.bvh = build_bvh(boxes, item_class, threads);

    std::vector<std::uint32_t> leaf_order(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) leaf_order[i] = items[world.bvh.order[i]];
    Packer packer(scene, world);
    packer.pack(leaf_order, threads);
    // A leaf's items are of one class and consecutive in leaf order, so their slots are consecutive too.
    for (BvhNode& node : world.bvh.nodes) {
        for (BvhChild& child : node.child) {
            if (child.is_leaf()) child = BvhChild::leaf(packer.slot(leaf_order[child.first()]), child.count());
        }
    }
    world.bvh.order = {};
}

}  // namespace

const ShapeClass& World::class_of(std::uint32_t slot) const {
    std::size_t c = 0;
    while (slot - classes[c].first >= classes[c].count) ++c;
    return classes[c];
}

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
            }
        }
        build_geometry(scene, *world, threads);
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
    for (int a = 0; a < 3; ++a) m.shapes += (world.box_lo[a].capacity() + world.box_hi[a].capacity()) * sizeof(float);
    m.shapes += (world.shape_index.capacity() + world.material.capacity()) * sizeof(std::uint32_t);
    m.hierarchy = world.bvh.nodes.capacity() * sizeof(BvhNode);
    m.materials = world.materials.capacity() * sizeof(double) + world.lights.capacity() * sizeof(Light);
    return m;
}

Bounds bounds(const World& world) {
    const Box& b = world.bvh.bounds;
    return {{b.lo[0], b.lo[1], b.lo[2]}, {b.hi[0], b.hi[1], b.hi[2]}};
}

}  // namespace glint
