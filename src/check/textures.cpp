// SPDX-License-Identifier: Apache-2.0
// Textures that are not visible.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "check/checks.h"
#include "math/transform.h"
#include "world/geometry/primitive_bounds-inl.h"

namespace glint {
namespace {

// An interval; empty as long as least > most.
struct Interval {
    double least = number::k_infinity, most = -number::k_infinity;
    void add(double x) {
        least = number::min(least, x);
        most = number::max(most, x);
    }
};
// Whether numbers of the intervals a x + b y + c reach 0 to 1.
bool reaches_picture(const double (&row)[3], const Interval& x, const Interval& y) {
    Interval mapped;
    for (const double u : {x.least, x.most})
        for (const double v : {y.least, y.most}) mapped.add(row[0] * u + row[1] * v + row[2]);
    // Not a number: unknown.
    return !(mapped.least > 1) && !(mapped.most < 0);
}

// The triangles that have no texture coordinates.
std::size_t count_without(const MeshData& mesh) {
    if (mesh.texture_coordinates.empty()) return mesh.triangles.size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        count += mesh.corner_values(mesh.texture_coordinates, i) ? 0 : 1;
    return count;
}

// Materials whose texture needs coordinates that their shapes have not.
void check_coordinates(CheckContext& context) {
    const Scene& scene = context.scene();
    std::vector<std::size_t> missing(scene.meshes.size());
    for (std::size_t i = 0; i < missing.size(); ++i) missing[i] = count_without(*scene.meshes[i]);
    struct Use {
        std::size_t shapes = 0;
        std::vector<std::uint32_t> without, partly;
        std::size_t triangles = 0, of = 0;  // of `partly`: those without, and all
    };
    std::vector<Use> uses(scene.materials.size());
    // Some shapes of a material: a shape, or those of a solid. Of these, others than meshes may be meant to
    // have none if a mesh has coordinates.
    const auto add = [&](std::uint32_t i, std::uint32_t material, std::span<const Shape> parts) {
        const std::uint32_t texture = material == k_none ? k_none : scene.materials[material].texture;
        if (texture == k_none || !scene.textures[texture].needs_uv()) return;
        bool has_any = false;
        std::size_t triangles = 0, of = 0;  // of meshes: those without, and all
        for (const Shape& part : parts) {
            if (part.kind != ShapeKind::mesh || part.material != material) continue;
            const std::uint32_t mesh = scene.get<Mesh>()[part.index].mesh;
            const std::size_t count = scene.meshes[mesh]->triangles.size();
            has_any = has_any || missing[mesh] < count;
            triangles += missing[mesh], of += count;
        }
        Use& use = uses[material];
        ++use.shapes;
        if (!has_any) {
            use.without.push_back(i);
        } else if (triangles > 0) {
            use.partly.push_back(i);
            use.triangles += triangles, use.of += of;
        }
    };
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        if (shape.kind != ShapeKind::solid) {
            add(i, shape.material, {&shape, 1});
            continue;
        }
        const auto operands = operands_of(scene, shape);
        std::vector<Shape> parts(operands.begin(), operands.end());
        std::vector<std::uint32_t> materials;
        for (Shape& part : parts) {
            if (part.material == k_none) part.material = shape.material;
            materials.push_back(part.material);
        }
        std::sort(materials.begin(), materials.end());
        materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
        for (const std::uint32_t material : materials) add(i, material, parts);
    }
    for (std::uint32_t i = 0; i < uses.size(); ++i) {
        const Use& use = uses[i];
        const std::size_t count = use.without.size();
        const auto report = [&](const std::string& which, std::string remedy) {
            context.report(
                "texture-without-coordinates", context.at_material(i),
                fmt::format("{} has {}, which is placed by the texture coordinates of meshes, and {}",
                            context.material(i), context.texture(scene.materials[i].texture), which),
                std::move(remedy));
        };
        if (count > 0) {
            report(use.shapes == 1
                       ? "the only shape that has it, " + context.some_shapes(use.without) + ", has none"
                       : fmt::format("{} of the {} shapes that have it {} none: {}", count, use.shapes,
                                     count == 1 ? "has" : "have", context.some_shapes(use.without)),
                   "give the texture another mapping (planar, spherical, cylindrical), or its shapes "
                   "texture coordinates: only meshes can have them");
        }
        if (!use.partly.empty()) {
            report(fmt::format("{} of the {} triangles of {} {} none", use.triangles, use.of,
                               context.some_shapes(use.partly), use.triangles == 1 ? "has" : "have"),
                   "give all their vertices texture coordinates, or the triangles that shall have no texture "
                   "another material");
        }
    }
}

// Whether the picture has nothing but what its alpha makes invisible.
bool is_invisible(const Texture& texture) {
    if (!texture.has_alpha() || !texture.image || texture.over != k_none || !texture.image->has_alpha ||
        texture.has_wrap(TextureWrap::once))
        return false;
    return std::visit(
        [&](const auto& words) {
            const double most = sizeof(words[0]) == 1 ? 255 : 65535;
            for (std::size_t i = 3; i < words.size(); i += 4)
                if (texture.opacity(words[i] / most) > 0) return false;
            return true;
        },
        texture.image->words);
}

// Of textures that are drawn once: which of them have surfaces, and which may reach a surface.
struct OnceTextures {
    std::vector<bool> has_surface, reaches;
};

// Planes reach any place. Of operands, and of patterns of u and v, nothing is known.
bool is_everywhere(const PackedGeometry& geometry, const PreparedTexture& texture, std::uint32_t slot) {
    if (texture.from_uv || geometry.operand_of(slot) != nullptr) return true;
    return slot >= geometry.bounded &&
           (texture.mapping == TextureMapping::planar || texture.mapping == TextureMapping::cylindrical);
}

// u and v of a surface that is not everywhere, before Texture::uv_map; nothing if it has none.
std::optional<std::array<Interval, 2>> uv_ranges(const Scene& scene, const PackedGeometry& geometry,
                                                 const PreparedTexture& texture, std::uint32_t slot) {
    std::array<Interval, 2> uv;
    if (texture.mapping == TextureMapping::uv) {
        const Shape& shape = scene.shapes[geometry.shape_index[slot]];
        if (shape.kind != ShapeKind::mesh) return {};
        const auto& mesh = scene.meshes[scene.get<Mesh>()[shape.index].mesh];
        const auto corners = mesh->corner_values(mesh->texture_coordinates, geometry.element_of(slot));
        if (!corners) return {};
        for (const Float3& corner : *corners) {
            uv[0].add(static_cast<double>(corner.x));
            uv[1].add(static_cast<double>(corner.y));
        }
        return uv;
    }
    if (texture.mapping != TextureMapping::planar) {
        uv = {Interval{0, 1}, Interval{0, 1}};
        if (texture.mapping == TextureMapping::spherical) return uv;
        uv[1] = {};
    }
    const Bounds box = to_bounds(HWY_NAMESPACE::primitive_bounds(geometry, slot));
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at{(corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                      (corner & 4) != 0 ? box.max.z : box.min.z};
        const Vec3 p = transform_point(texture.texture_from_world, at);
        if (texture.mapping == TextureMapping::planar) uv[0].add(p.x);
        uv[1].add(p.y);
    }
    return uv;
}

OnceTextures find_once(const CheckContext& context) {
    const WorldParts& world = context.world();
    const std::size_t count = world.textures->size();
    OnceTextures found{std::vector<bool>(count), std::vector<bool>(count)};
    for (std::uint32_t slot = 0; slot < world.geometry->count; ++slot) {
        const PreparedTexture* const texture = world.texture_of((*world.slot_material)[slot]);
        if (texture == nullptr) continue;
        const auto index = static_cast<std::size_t>(texture - world.textures->data());
        if (found.reaches[index]) continue;
        if (is_everywhere(*world.geometry, *texture, slot)) {
            found.reaches[index] = true;
            continue;
        }
        const auto uv = uv_ranges(context.scene(), *world.geometry, *texture, slot);
        if (!uv) continue;
        found.has_surface[index] = true;
        const auto reaches = [&](TextureWrap wrap, const double(&row)[3]) {
            const bool ends = wrap == TextureWrap::once || wrap == TextureWrap::clip;
            return !ends || reaches_picture(row, (*uv)[0], (*uv)[1]);
        };
        found.reaches[index] =
            reaches(texture->wrap_u, texture->uv_map.m[0]) && reaches(texture->wrap_v, texture->uv_map.m[1]);
    }
    return found;
}

}  // namespace

void check_textures(CheckContext& context, const VisibleHits& visible, bool sees) {
    const Scene& scene = context.scene();
    if (scene.textures.empty()) return;
    std::vector<bool> used(scene.textures.size());
    for (const Material& material : scene.materials)
        for (std::uint32_t t = material.texture; t < scene.textures.size(); t = scene.textures[t].over)
            used[t] = true;
    check_coordinates(context);
    const OnceTextures once = find_once(context);
    for (std::uint32_t i = 0; i < scene.textures.size(); ++i) {
        if (!used[i]) {
            context.report("texture-unused", context.at_texture(i),
                           fmt::format("no material has {}", context.texture(i)),
                           "write `texture = ` and its name in a material, or remove it",
                           context.is_model() ? Severity::note : Severity::warning);
        } else if (is_invisible(scene.textures[i])) {
            context.report(
                "texture-invisible", context.at_texture(i),
                fmt::format("{} is {} everywhere, by its alpha", context.texture(i),
                            scene.textures[i].alpha == TextureAlpha::mask ? "a hole" : "transparent"),
                "set `alpha` to ignore, or give the picture another alpha");
        } else if (once.has_surface[i] && !once.reaches[i]) {
            context.report("texture-out-of-reach", context.at_texture(i),
                           fmt::format("{} is drawn once, where u and v are from 0 to 1, and no surface that "
                                       "has it comes there: none shows it",
                                       context.texture(i)),
                           "move it there by its transform or `uv_map`, or set `wrap_u` and `wrap_v` to "
                           "repeat");
        }
    }
    if (sees) check_texture_fineness(context, visible);
}

}  // namespace glint
