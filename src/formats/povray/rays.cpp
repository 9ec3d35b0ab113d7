// SPDX-License-Identifier: Apache-2.0
// trace() and inside() of declared objects. What was measured of POV-Ray: a ray has unit length and begins at
// 1e-4; the normal points to the outside, of a flat triangle to where its vertices are clockwise; a miss is
// the point 0 with the normal 0. The rays are traced through the library's public functions, in a World of
// the object alone.
#include <fmt/format.h>

#include <vector>

#include "formats/povray/closed_mesh.h"
#include "formats/povray/outward_faces.h"
#include "formats/povray/scene_builder.h"
#include "formats/povray/solid_lathe.h"
#include "formats/povray/value_parser.h"
#include "glint/world.h"
#include "math/quartic_value.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

constexpr double k_ray_begin = 1e-4;
constexpr std::size_t k_max_traced = 64;
constexpr std::uint64_t k_bytes_a_step = 512;  // of a World, so that loops that make many end

// What is_inside() takes of meshes.
std::uint64_t mesh_steps(const Object& object) {
    std::uint64_t steps = object.mesh ? object.mesh->triangles.size() / 16 : 0;
    if (object.parts) {
        for (const ObjectPart& part : *object.parts) steps += mesh_steps(*part);
    }
    for (const ClipObject& clip : object.clips) steps += mesh_steps(*clip.object);
    return steps;
}

bool is_inside(const Object& o, Vec3 p) {
    if (o.map) {
        const auto object_from_world = inverse(*o.map);
        if (!object_from_world) return false;
        p = transform_point(*object_from_world, p);
    }
    bool is_in = false;
    const Vec3 from_a = p - o.a;
    switch (o.kind) {
        case ObjectKind::sphere:
            is_in = dot(from_a, from_a) < o.r * o.r;
            break;
        case ObjectKind::box: {
            const Vec3 from_b = p - o.b;
            is_in = from_a.x * from_b.x <= 0 && from_a.y * from_b.y <= 0 && from_a.z * from_b.z <= 0;
            break;
        }
        case ObjectKind::plane:
            is_in = dot(normalize(o.b), p) <= o.s;
            break;
        case ObjectKind::cylinder:
        case ObjectKind::cone: {
            const Vec3 axis = o.b - o.a;
            const double along = dot(from_a, axis) / dot(axis, axis);
            const double radius = o.kind == ObjectKind::cone ? o.r + (o.s - o.r) * along : o.r;
            const Vec3 across = from_a - axis * along;
            is_in = along > 0 && along < 1 && dot(across, across) < radius * radius;
            break;
        }
        case ObjectKind::torus: {
            const double across = length(Vec3{p.x, 0, p.z}) - o.r;
            is_in = across * across + p.y * p.y <= o.s * o.s;
            break;
        }
        case ObjectKind::quadric:
            is_in = o.a.x * p.x * p.x + o.a.y * p.y * p.y + o.a.z * p.z * p.z + o.b.x * p.x * p.y +
                        o.b.y * p.x * p.z + o.b.z * p.y * p.z + dot(o.c, p) + o.s <=
                    0;
            break;
        case ObjectKind::quartic:
            is_in = quartic_value(o.quartic->coefficients, p) <= 0;
            break;
        case ObjectKind::mesh:
            is_in = is_in_mesh(*closed_mesh(o.mesh), p);
            break;
        default: {
            bool all = true, any = false;
            const auto& parts = o.lathe ? *solid_lathe(o)->parts : *o.parts;
            for (std::size_t i = 0; i < parts.size(); ++i) {
                // Of a difference, the inside of all but the first counts as outside.
                const bool is_cut =
                    o.kind == ObjectKind::solid && i > 0 && o.operation != SolidOperation::intersection;
                const bool is_in_part = is_inside(*parts[i], p) != is_cut;
                all = all && is_in_part;
                any = any || is_in_part;
            }
            is_in = o.kind == ObjectKind::solid ? all : any;
        }
    }
    is_in = is_in != o.is_inverse;
    for (const ClipObject& clip : o.clips)
        is_in = is_in && is_inside(*clip.object, clip.map ? transform_point(*clip.map, p) : p);
    return is_in;
}

}  // namespace

struct ValueParser::Traced {
    std::shared_ptr<const Object> object;  // kept, so that its address is not used again
    World world;
    std::vector<bool> is_turned;  // whether the normal points to the other side, by shape
};

// The World of an object, which is made once. Nothing after an error.
const ValueParser::Traced* ValueParser::traced(const std::shared_ptr<const Object>& object, const Token& at) {
    for (const auto& each : traced_) {
        if (each->object == object) return each.get();
    }
    auto made = std::make_shared<Traced>();
    made->object = object;
    Scene scene;
    std::swap(scene, reading().scene);
    SceneBuilder builder(reading(), *this, true);
    builder.place(*object, Texture());
    std::swap(scene, reading().scene);
    if (builder.has_refused() && !failed()) error(at, "glint does not render the object that is traced here");
    if (failed()) return nullptr;
    Result<World> world = prepare(scene);
    if (!world.ok()) {
        error(at, fmt::format("glint does not trace this object: {}", world.message));
        return nullptr;
    }
    made->world = std::move(*world);
    for (const Shape& shape : scene.shapes) {
        bool is_flat = shape.kind == ShapeKind::triangle;
        if (shape.kind == ShapeKind::mesh) {
            const std::uint32_t mesh = scene.get<Mesh>()[shape.index].mesh;
            is_flat = scene.meshes[mesh]->normals.empty() && !builder.is_field(mesh);
        }
        made->is_turned.push_back(is_flat != object->is_inverse);
    }
    const std::uint64_t bytes = memory_usage(made->world).total();
    if (!has_room(traced_bytes_ + bytes, at) || !spend(bytes / k_bytes_a_step)) return nullptr;
    if (traced_.size() == k_max_traced) {
        traced_.clear();
        traced_bytes_ = 0;
    }
    traced_bytes_ += bytes;
    traced_.push_back(std::move(made));
    return traced_.back().get();
}

std::shared_ptr<const Object> ValueParser::object_argument() {
    const Token name = take();
    auto object = named<Object>(name);
    if (object == nullptr && !failed())
        error(name, fmt::format("expected the name of an object, found {}{}", describe(name), what_is(name)));
    return object;
}

// OBJECT, from, direction [, the normal's name or element of an array]
Numbers ValueParser::trace(const Token& function) {
    const auto object = object_argument();
    accept(',');
    const Vec3 from = vector_argument(), to = vector_argument();
    const bool has_normal = !failed() && !peek().is(')');
    const Token name = has_normal ? take() : Token();
    std::vector<std::uint32_t> indices;
    if (has_normal) {
        const Value* const known = find_value(name);
        const auto* const numbers = known ? std::get_if<Numbers>(known) : nullptr;
        const bool is_array = known && std::holds_alternative<std::shared_ptr<Array>>(*known);
        if (is_array && peek().is('[')) {
            indices = read_indices();
        } else if (!numbers || numbers->terms != 3) {
            error(name,
                  fmt::format("expected the name of a vector, found {}{}", describe(name), what_is(name)));
        }
    }
    const Traced* of = failed() ? nullptr : traced(object, function);
    if (of == nullptr) return {};
    Vec3 point, normal;
    if (const double size = length(to); size > 0) {
        const Ray ray{from, to / size, k_ray_begin};
        const auto hits = nearest_hits(of->world, std::span(&ray, 1), 1);
        if (hits.ok() && hits->front().shape != k_none) {
            const RayHit& hit = hits->front();
            point = ray.origin + ray.direction * hit.t;
            normal = of->is_turned[hit.shape] ? -hit.normal : hit.normal;
        }
    }
    std::uint32_t target = name.name;
    if (Binding* const binding = has_normal ? find_binding(target, depth()) : nullptr) {
        if (indices.empty()) {
            binding->value = Numbers(normal);
        } else {
            assign_element(name, binding->value, indices, Numbers(normal));
        }
    }
    return Numbers(point);
}

// OBJECT, point
Numbers ValueParser::inside(const Token& function) {
    const auto object = object_argument();
    accept(',');
    const Vec3 point = vector();
    if (failed() || !spend(object->count + mesh_steps(*object))) return {};
    bool is_known = encloses_space(*object);
    for (const ClipObject& clip : object->clips) is_known = is_known && encloses_space(*clip.object);
    if (!is_known) {
        error(function, "expected an object whose inside glint knows");
        return {};
    }
    return is_inside(*object, point) ? 1.0 : 0.0;
}

}  // namespace glint::povray
