// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "scene/ranges.h"

namespace glint::gltf {
namespace {

// The values of `mode`.
constexpr std::uint64_t k_triangles = 4, k_strip = 5, k_fan = 6;
// Between two looks at the limits of memory and time.
constexpr std::uint64_t k_steps = 65536;

// The triangles of `count` vertices in a row: add(a, b, c), with places in the row.
template <class Add> bool make_triangles(std::uint64_t mode, std::uint64_t count, const Add& add) {
    if (mode == k_triangles) {
        for (std::uint64_t i = 0; i + 3 <= count; i += 3) {
            if (!add(i, i + 1, i + 2)) return false;
        }
        return true;
    }
    for (std::uint64_t i = 0; i + 3 <= count; ++i) {
        const std::uint64_t odd = i % 2;
        if (!(mode == k_strip ? add(i, i + 1 + odd, i + 2 - odd) : add(i + 1, i + 2, 0))) return false;
    }
    return true;
}

}  // namespace

std::span<const MeshPart> Meshes::parts(std::uint32_t mesh) {
    Known& known = known_[mesh];
    if (known.is_read) return known.parts;
    known.is_read = true;
    const JsonValue at = file_.item(List::meshes, mesh), primitives = at.find("primitives");
    if (!primitives.is(JsonKind::list)) {
        file_.expected(primitives.exists() ? primitives : at, "a list", "primitives");
        return {};
    }
    primitives.for_each([&](JsonValue primitive) {
        if (file_.is_alive() && file_.go_on(primitive)) read_primitive(primitive, known.parts);
    });
    return known.parts;
}

void Meshes::read_primitive(JsonValue primitive, CountedVector<MeshPart>& parts) {
    std::uint64_t mode = k_triangles;
    if (!file_.whole(primitive, "mode", mode)) return;
    if (mode > k_fan) {
        file_.expected(primitive.find("mode"), "a number from 0 to 6", "mode");
        return;
    }
    if (mode < k_triangles)
        return file_.warn_once("gltf lines", primitive, "glint draws no points and lines of glTF");
    const JsonValue attributes = primitive.find("attributes");
    if (!attributes.is(JsonKind::object)) {
        file_.expected(attributes.exists() ? attributes : primitive, "an object", "attributes");
        return;
    }
    if (!attributes.find("POSITION").exists())
        return file_.warn_once("gltf positions", primitive, "a primitive without `POSITION` is left out");
    if (primitive.find("targets").size() > 0)
        file_.warn_once("gltf morph", primitive, "glint draws the meshes without their morph targets");
    const std::optional<MaterialUse> use = materials_.use(primitive);
    if (!use || !use->is_visible) return;
    Attributes from;
    if (!open_attributes(attributes, *use, from)) return;
    auto mesh = std::make_shared<MeshData>();
    if (!read_triangles(primitive, mode, *from.positions, *mesh) || mesh->triangles.empty()) return;
    const Used used = use_vertices(from.positions->count, *mesh);
    const std::uint64_t vertices = used.is_all ? from.positions->count : used.order.size();
    const std::uint64_t lists = 1 + (from.normals != nullptr ? 1 : 0) + (from.colors != nullptr ? 1 : 0) +
                                (from.coordinates != nullptr ? 1 : 0);
    const std::uint64_t bytes = MemoryBudget::list_bytes(mesh->triangles.size(), sizeof(TriangleCorners)) +
                                MemoryBudget::list_bytes(lists * vertices, sizeof(Float3));
    if (!has_room(bytes, primitive) ||
        !read_values(*from.positions, used, k_coordinate, mesh->single_positions))
        return;
    if (from.normals != nullptr && !read_values(*from.normals, used, k_coordinate, mesh->normals.values))
        return;
    if (from.coordinates != nullptr &&
        !read_values(*from.coordinates, used, k_coordinate, mesh->texture_coordinates.values))
        return;
    if (from.colors != nullptr && !read_colors(*from.colors, used, *use, *mesh)) return;
    Scene& scene = file_.reading.scene;
    MeshPart part{static_cast<std::uint32_t>(scene.meshes.size()), use->material};
    for (const Float3& p : mesh->single_positions) part.box.add(to_vec3(p));
    parts.push_back(part);
    scene.meshes.push_back(std::move(mesh));
}

bool Meshes::has_room(std::uint64_t bytes, JsonValue at) {
    return file_.reading.has_room(bytes, file_.text.place, at.offset(), at.length());
}

const Accessor* Meshes::open_attribute(JsonValue attributes, std::string_view name, std::uint32_t least,
                                       std::uint32_t most, std::uint64_t count, bool& is_right) {
    const JsonValue index = attributes.find(name);
    if (!index.exists()) return nullptr;
    const Accessor* const accessor = accessors_.open(index, least, most);
    is_right = is_right && accessor != nullptr;
    if (accessor == nullptr || count == 0 || accessor->count == count) return accessor;
    is_right = file_.error(index, fmt::format("expected a value of `{}` for each of {} vertices, found {}",
                                              name, count, accessor->count));
    return nullptr;
}

bool Meshes::open_attributes(JsonValue attributes, const MaterialUse& use, Attributes& to) {
    bool is_right = true;
    to.positions = open_attribute(attributes, "POSITION", 3, 3, 0, is_right);
    if (to.positions == nullptr) return false;
    const std::uint64_t count = to.positions->count;
    to.normals = open_attribute(attributes, "NORMAL", 3, 3, count, is_right);
    to.colors = open_attribute(attributes, "COLOR_0", 3, 4, count, is_right);
    if (use.has_texture)
        to.coordinates =
            open_attribute(attributes, fmt::format("TEXCOORD_{}", use.texture_set), 2, 2, count, is_right);
    if (is_right && use.has_texture && to.coordinates == nullptr)
        file_.warn_once(
            "gltf coordinates", attributes,
            fmt::format("without `TEXCOORD_{}`, a primitive is drawn without its texture", use.texture_set));
    return is_right;
}

bool Meshes::read_triangles(JsonValue primitive, std::uint64_t mode, const Accessor& positions,
                            MeshData& mesh) {
    const JsonValue value = primitive.find("indices");
    const Accessor* const indices = value.exists() ? accessors_.open_indices(value) : nullptr;
    if (value.exists() && indices == nullptr) return false;
    const std::uint64_t count = indices != nullptr ? indices->count : positions.count;
    if (mode == k_triangles && count % 3 != 0)
        file_.warn_once("gltf triangles", primitive,
                        "the number of vertices is no multiple of three: the last ones are left out");
    const std::uint64_t triangles = mode == k_triangles ? count / 3 : count < 3 ? 0 : count - 2;
    if (!has_room(MemoryBudget::list_bytes(triangles, sizeof(TriangleCorners)), primitive)) return false;
    mesh.triangles.reserve(static_cast<std::size_t>(triangles));
    std::uint64_t steps = 0;
    const auto corner = [&](std::uint64_t place, std::uint32_t& vertex) {
        vertex = indices != nullptr ? indices->whole(place) : static_cast<std::uint32_t>(place);
        if (vertex < positions.count) return true;
        return file_.error(value, fmt::format("{}: expected the number of a vertex from 0 to {}, found {} as "
                                              "number {}",
                                              File::name(List::accessors, indices->number),
                                              positions.count - 1, vertex, place));
    };
    return make_triangles(mode, count, [&](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
        TriangleCorners t;
        if (!corner(a, t[0]) || !corner(b, t[1]) || !corner(c, t[2])) return false;
        // Strips have triangles without area between their parts.
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
        return ++steps % k_steps != 0 || file_.go_on(primitive);
    });
}

// Many primitives may share the accessors of their vertices; each mesh then has those that it uses.
Meshes::Used Meshes::use_vertices(std::uint64_t count, MeshData& mesh) {
    Used used;
    if (count <= 6 * mesh.triangles.size()) return used;
    used.is_all = false;
    if (numbers_.size() < count) numbers_.resize(static_cast<std::size_t>(count), k_none);
    for (TriangleCorners& triangle : mesh.triangles) {
        for (std::uint32_t& vertex : triangle) {
            std::uint32_t& number = numbers_[vertex];
            if (number == k_none) {
                number = static_cast<std::uint32_t>(used.order.size());
                used.order.push_back(vertex);
            }
            vertex = number;
        }
    }
    for (const std::uint32_t vertex : used.order) numbers_[vertex] = k_none;
    return used;
}

bool Meshes::read_values(const Accessor& accessor, const Used& used, const Range& range,
                         std::vector<Float3>& values) {
    const std::size_t count = used.is_all ? static_cast<std::size_t>(accessor.count) : used.order.size();
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t element = used.is_all ? i : used.order[i];
        std::array<float, 3> v{};
        accessor.read(element, v);
        for (const float x : v) {
            if (range.contains(x)) continue;
            return file_.error(accessor.at, fmt::format("{}, element {}: expected {}, found {}",
                                                        File::name(List::accessors, accessor.number), element,
                                                        range.text, x));
        }
        values.push_back({v[0], v[1], v[2]});
        if (i % k_steps == k_steps - 1 && !file_.go_on(accessor.at)) return false;
    }
    return true;
}

// They are multiplied by the color of the material, as glint's colors of vertices replace it.
bool Meshes::read_colors(const Accessor& accessor, const Used& used, const MaterialUse& use, MeshData& mesh) {
    std::vector<Float3>& values = mesh.colors.values;
    if (!read_values(accessor, used, k_not_negative, values)) return false;
    for (Float3& value : values) {
        const Vec3 c = to_vec3(value);
        value = to_single({c.x * use.factor.r, c.y * use.factor.g, c.z * use.factor.b});
    }
    if (use.is_unlit)
        file_.warn_once("gltf unlit colors", accessor.at,
                        "glint ignores the colors of vertices of unlit surfaces");
    if (!use.is_transparent || accessor.components < 4) return true;
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::array<float, 4> v{};
        accessor.read(used.is_all ? i : used.order[i], v);
        if (!(v[3] < 1)) continue;
        file_.warn_once("gltf color alpha", accessor.at, "glint ignores the alpha of the colors of vertices");
        break;
    }
    return true;
}

}  // namespace glint::gltf
