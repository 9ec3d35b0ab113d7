// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/contents.h"

#include <fmt/format.h>

#include "base/text.h"
#include "math/transform.h"
#include "scene/ranges.h"

namespace glint::gltf {

constexpr std::uint64_t k_shapes_between_looks = 4096;

void Contents::add() {
    if (const JsonValue animations = file_.root().find("animations"); animations.size() > 0)
        file_.warn_once("gltf animations", animations,
                        "glint draws the file at rest, without its animations");
    const std::size_t lights = file_.reading.scene.lights.size();
    for (const PlacedNode& placed : nodes_.placed()) {
        if (!file_.is_alive()) return;
        const JsonValue node = file_.item(List::nodes, placed.node);
        if (node.find("mesh").exists()) add_mesh(node, placed.world_from_node);
        if (const JsonValue camera = node.find("camera"); camera.exists())
            set_camera(file_, camera, placed.world_from_node);
        const JsonValue light = File::extension(node, "KHR_lights_punctual").find("light");
        if (light.exists()) add_light(file_, light, placed.world_from_node);
    }
    limit_exposure(file_, lights, box_);
}

// glTF 2.0, section 3.7.3.3: the joints place the vertices, not the node. The whole mesh is placed as its
// first joint is, which is right if the joints are as they were bound.
bool Contents::skinned(JsonValue node, Affine& world_from_mesh) {
    const JsonValue value = node.find("skin");
    if (!value.exists()) return true;
    const std::optional<std::uint32_t> index = file_.index(value, List::skins);
    if (!index) return false;
    file_.warn_once("gltf skins", value, "glint draws meshes with skins at rest, as they were bound");
    // Many nodes may share a skin of many joints.
    const auto [known, is_new] = skins_.try_emplace(*index);
    if (is_new && !read_skin(file_.item(List::skins, *index), known->second)) return false;
    if (known->second) world_from_mesh = *known->second;
    return true;
}

bool Contents::read_skin(JsonValue skin, std::optional<Affine>& world_from_mesh) {
    JsonValue first;
    skin.find("joints").for_each([&](JsonValue joint) {
        if (!first.exists()) first = joint;
    });
    if (!first.exists()) return file_.expected(skin, "an object with a list of `joints`");
    const std::optional<std::uint32_t> joint = file_.index(first, List::nodes);
    if (!joint) return false;
    const Affine* const world_from_joint = nodes_.world_from(*joint);
    if (world_from_joint == nullptr) return true;
    Affine joint_from_mesh;
    if (const JsonValue matrices = skin.find("inverseBindMatrices"); matrices.exists()) {
        const Accessor* const accessor = accessors_.open(matrices, 16, 16);
        if (accessor == nullptr) return false;
        std::array<float, 16> m{};  // column by column
        accessor->read(0, m);
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 4; ++column) {
                if (!k_coordinate.contains(m[4 * column + row]))
                    return file_.error(matrices, "expected matrices of numbers from -1e12 to 1e12");
                joint_from_mesh.m[row][column] = m[4 * column + row];
            }
        }
    }
    world_from_mesh = compose(*world_from_joint, joint_from_mesh);
    return true;
}

void Contents::add_mesh(JsonValue node, const Affine& world_from_node) {
    const std::optional<std::uint32_t> index = file_.index(node.find("mesh"), List::meshes);
    Affine world_from_mesh = world_from_node;
    if (!index || !skinned(node, world_from_mesh)) return;
    const std::span<const MeshPart> parts = meshes_.parts(*index);
    if (parts.empty()) return;
    const JsonValue instances = File::extension(node, "EXT_mesh_gpu_instancing");
    if (instances.exists()) return add_instances(node, instances.find("attributes"), parts, world_from_mesh);
    std::string name = file_.string(node, "name");
    if (name.empty()) name = file_.string(file_.item(List::meshes, *index), "name");
    add_shapes(node, parts, world_from_mesh, name);
}

void Contents::add_instances(JsonValue node, JsonValue attributes, std::span<const MeshPart> parts,
                             const Affine& world_from_node) {
    if (!attributes.is(JsonKind::object) || attributes.size() == 0) {
        file_.expected(attributes.exists() ? attributes : node, "an object with members",
                       "EXT_mesh_gpu_instancing.attributes");
        return;
    }
    const Accessor* of[3] = {};
    constexpr std::string_view names[] = {"TRANSLATION", "ROTATION", "SCALE"};
    std::optional<std::uint64_t> count;
    for (std::size_t i = 0; i < 3; ++i) {
        const JsonValue index = attributes.find(names[i]);
        if (!index.exists()) continue;
        const std::uint32_t components = i == 1 ? 4 : 3;
        of[i] = accessors_.open(index, components, components);
        if (of[i] == nullptr) return;
        if (count && *count != of[i]->count) {
            file_.error(index, fmt::format("expected {} instances, found {}", *count, of[i]->count));
            return;
        }
        count = of[i]->count;
    }
    for (std::uint64_t i = 0; i < count.value_or(1); ++i) {
        std::array<float, 3> t{0, 0, 0}, s{1, 1, 1};
        std::array<float, 4> q{0, 0, 0, 1};
        if (of[0] != nullptr) of[0]->read(i, t);
        if (of[1] != nullptr) of[1]->read(i, q);
        if (of[2] != nullptr) of[2]->read(i, s);
        for (const float x : {t[0], t[1], t[2], s[0], s[1], s[2], q[0], q[1], q[2], q[3]}) {
            if (k_coordinate.contains(x)) continue;
            file_.error(attributes,
                        fmt::format("instance {}: expected {}, found {}", i, k_coordinate.text, x));
            return;
        }
        add_shapes(
            node, parts,
            compose(world_from_node, trs({t[0], t[1], t[2]}, {q[0], q[1], q[2], q[3]}, {s[0], s[1], s[2]})),
            {});
        if (!file_.is_alive()) return;
    }
}

void Contents::add_shapes(JsonValue node, std::span<const MeshPart> parts, const Affine& world_from_mesh,
                          const std::string& name) {
    // A scale of 0 hides what is below a node.
    if (!inverse(world_from_mesh))
        return file_.warn_once("gltf flat", node, "a mesh with a scale of 0 is left out");
    Scene& scene = file_.reading.scene;
    std::uint32_t transform = k_none;
    if (world_from_mesh != Affine{}) {
        transform = static_cast<std::uint32_t>(scene.transforms.size());
        scene.transforms.push_back(world_from_mesh);
    }
    for (const MeshPart& part : parts) {
        for (unsigned i = 0; i < 8; ++i)
            box_.add(transform_point(world_from_mesh, {(i & 1) != 0 ? part.box.hi.x : part.box.lo.x,
                                                       (i & 2) != 0 ? part.box.hi.y : part.box.lo.y,
                                                       (i & 4) != 0 ? part.box.hi.z : part.box.lo.z}));
        note(scene.shape_texts, scene.shapes.size(), file_.place(node), name);
        scene.add(Mesh{part.mesh}, part.material, transform);
        if (++shapes_ % k_shapes_between_looks == 0 && !file_.go_on(node)) return;
    }
}

}  // namespace glint::gltf
