// SPDX-License-Identifier: Apache-2.0
// Visible surfaces that coincide, and shapes that are written twice.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>
#include <unordered_set>

#include "base/sort_stably.h"
#include "check/checks.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr std::int32_t k_longest = 400;
// The positions of the rays in their pixels: off every symmetry, so that no ray hits an edge that two faces
// share.
constexpr double k_beside_x = 0.2371, k_beside_y = -0.1893;
constexpr double k_min_share = 1e-4;  // of the picture; a ball that touches the floor has less
constexpr std::size_t k_max_reported = 5;
constexpr double k_parallel = 1e-10, k_grazing = 0.02;  // 1 - cosine; cosine

// All parameters of a shape except its material.
void append(std::vector<double>& to, Vec3 v) { to.insert(to.end(), {v.x, v.y, v.z}); }

std::vector<double> values_of(const Scene& scene, const Shape& shape) {
    std::vector<double> v;
    v.reserve(16);  // of most shapes
    v.push_back(static_cast<double>(shape.kind));
    switch (shape.kind) {
        case ShapeKind::sphere: {
            const Sphere& s = scene.get<Sphere>()[shape.index];
            append(v, s.center), v.push_back(s.radius);
            break;
        }
        case ShapeKind::plane: {
            const Plane& s = scene.get<Plane>()[shape.index];
            const Vec3 n = normalize(s.normal);
            append(v, n), v.push_back(dot(n, s.point));
            break;
        }
        case ShapeKind::cylinder: {
            const Cylinder& s = scene.get<Cylinder>()[shape.index];
            append(v, s.from), append(v, s.to), v.push_back(s.radius);
            break;
        }
        case ShapeKind::cone: {
            const Cone& s = scene.get<Cone>()[shape.index];
            append(v, s.from), append(v, s.to);
            v.insert(v.end(), {s.from_radius, s.to_radius});
            break;
        }
        case ShapeKind::disc: {
            const Disc& s = scene.get<Disc>()[shape.index];
            append(v, s.center), append(v, normalize(s.normal));
            v.insert(v.end(), {s.radius, s.hole});
            break;
        }
        case ShapeKind::torus: {
            const Torus& s = scene.get<Torus>()[shape.index];
            append(v, s.center), append(v, normalize(s.axis));
            v.insert(v.end(), {s.radius, s.tube});
            break;
        }
        case ShapeKind::quadric: {
            const Quadric& s = scene.get<Quadric>()[shape.index];
            append(v, s.squares), append(v, s.products), append(v, s.linear), v.push_back(s.constant);
            break;
        }
        case ShapeKind::quartic: {
            const Quartic& s = scene.get<Quartic>()[shape.index];
            v.insert(v.end(), std::begin(s.coefficients), std::end(s.coefficients));
            break;
        }
        case ShapeKind::box: {
            const Box& s = scene.get<Box>()[shape.index];
            append(v, s.min), append(v, s.max);
            break;
        }
        case ShapeKind::triangle:
            for (const Vec3& p : scene.get<Triangle>()[shape.index].vertices) append(v, p);
            break;
        case ShapeKind::smooth_triangle:
            v[0] = static_cast<double>(ShapeKind::triangle);  // the same surface
            for (const Vec3& p : scene.get<SmoothTriangle>()[shape.index].vertices) append(v, p);
            break;
        case ShapeKind::polygon: {
            const Polygon& s = scene.get<Polygon>()[shape.index];
            for (std::uint32_t i = 0; i < s.count; ++i) append(v, scene.polygon_vertices[s.first + i]);
            break;
        }
        case ShapeKind::mesh:
            v.push_back(static_cast<double>(scene.get<Mesh>()[shape.index].mesh));
            break;
        default:  // a kind that was added later: never equal to another shape
            v.push_back(static_cast<double>(shape.index));
    }
    if (shape.transform != k_none && !(scene.transforms[shape.transform] == Affine{})) {
        for (const auto& row : scene.transforms[shape.transform].m)
            v.insert(v.end(), std::begin(row), std::end(row));
    }
    return v;
}

std::uint64_t hash(const std::vector<double>& values) {
    std::uint64_t h = 14695981039346656037u;
    for (const double x : values) {
        h = (h ^ std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)) * 1099511628211u;  // -0 is 0
        h ^= h >> 29;
    }
    return h;
}

bool are_twins(const Scene& scene, std::uint32_t a, std::uint32_t b) {
    return values_of(scene, scene.shapes[a]) == values_of(scene, scene.shapes[b]);
}

void check_twins(CheckContext& context, std::vector<bool>& covered) {
    const Scene& scene = context.scene();
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(scene.shapes.size());
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i)
        keys.emplace_back(hash(values_of(scene, scene.shapes[i])), i);
    std::sort(keys.begin(), keys.end());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> twins;  // the later, the earlier
    for (std::size_t i = 1; i < keys.size(); ++i) {
        if (keys[i].first == keys[i - 1].first && are_twins(scene, keys[i].second, keys[i - 1].second))
            twins.emplace_back(keys[i].second, keys[i - 1].second);
    }
    std::sort(twins.begin(), twins.end());
    for (const auto& [later, earlier] : twins) covered[later] = covered[earlier] = true;
    // Models have such shapes where parts meet, as an atom at the ends of its bonds.
    const std::size_t most = context.is_model() ? 1 : k_max_reported;
    for (std::size_t i = 0; i < twins.size() && i < most; ++i) {
        const auto [later, earlier] = twins[i];
        const std::size_t more = i + 1 == most ? twins.size() - most : 0;
        context.report(
            "shape-written-twice", context.at_shape(later),
            fmt::format("{} has the same parameters as {}: only the earlier one is visible{}",
                        context.shape(later), context.shape_and_line(earlier),
                        more == 0 ? ""
                        : more == 1
                            ? fmt::format("; and so has {}", context.shape_and_line(twins[i + 1].first))
                            : fmt::format("; and so have {} more shapes, the next {}", more,
                                          context.shape_and_line(twins[i + 1].first))),
            "remove one of them, or move it to its intended place",
            context.is_model() ? Severity::note : Severity::warning);
    }
}

// A pair of shapes whose surfaces coincide.
struct Pair {
    std::uint32_t earlier, later;
    friend auto operator<=>(const Pair&,
                            const Pair&) = default;  // NOLINT(modernize-use-nullptr): there is no 0
};

// How far apart two surfaces are that a ray leaving one of them cannot tell apart: the offset's epsilon as a
// length, within reason.
double tolerance(const Conventions& rules, double magnitude) {
    const double epsilon = rules.offset == Offset::scale ? rules.epsilon * magnitude : rules.epsilon;
    return number::min(number::max(epsilon, 1e-9 * magnitude), 1e-4 * magnitude);
}

// The World whose glass and transparent surfaces send no rays on: their bodies may rest on others.
World without_glass(World world) {
    WorldParts& parts = WorldAccess::own(world);
    for (std::uint32_t row = 0; row <= parts.scene_materials(); ++row) {
        const bool transparent = parts.is_transparent(row);
        if (!transparent && !(parts.material(row)[k_transmission] > 0)) continue;
        double* const values = parts.materials.own().data() + std::size_t{row} * k_material_values;
        values[k_mirror] = values[k_transmission] = 0;
        if (parts.extended->empty()) continue;
        double* const extended = parts.extended.own().data() + std::size_t{row} * k_extended_values;
        extended[k_extended_value<&Material::filter>] = extended[k_extended_value<&Material::transmit>] =
            extended[k_extended_value<&Material::mirror_min>] = 0;
    }
    return world;
}

class Coincidences {
  public:
    explicit Coincidences(CheckContext& context) : context_(context), world_(context.world()) {}

    /// Looks along the camera's rays and, of mirrors, along the reflected rays of the first generations.
    void find() {
        const SmallSize size = context_.grid(k_longest);
        rays_ = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
        for (const std::vector<SurfaceHit>& hits :
             follow_picture(without_glass(context_.prepared()).parts(), size, k_beside_x, k_beside_y,
                            context_.threads()))
            find_along(hits);
    }

    /// Marks the shapes whose faces coincide with another's.
    void report(std::vector<bool>& covered) const {
        std::vector<std::pair<std::size_t, Pair>> list;
        std::size_t all = 0;
        for (const auto& [pair, pixels] : pixels_) {
            if (are_twins(context_.scene(), pair.earlier, pair.later)) continue;
            list.emplace_back(pixels, pair);
            all += pixels;
        }
        const double least = k_min_share * static_cast<double>(rays_);
        if (static_cast<double>(all) <= least) return;
        sort_stably(list, [](const auto& a, const auto& b) { return a.first > b.first; });
        for (const auto& [pixels, pair] : list) covered[pair.earlier] = covered[pair.later] = true;
        // Of thousands of small pairs, none may be large enough by itself.
        std::size_t named = 1;
        const std::size_t most = context_.is_model() ? 1 : k_max_reported;
        while (named < list.size() && (named < most) && static_cast<double>(list[named].first) > least)
            ++named;
        for (std::size_t i = 0; i < named; ++i) {
            const auto& [pixels, pair] = list[i];
            const std::size_t more = i + 1 == named ? list.size() - named : 0;
            context_.report(
                "faces-coincide", context_.at_shape(pair.later),
                fmt::format("{} has a face that coincides with one of {}, visible in {} of "
                            "the picture: the order in "
                            "the file or rounding decides which one a pixel shows{}",
                            context_.shape(pair.later), context_.shape_and_line(pair.earlier),
                            percent_text(static_cast<double>(pixels) / static_cast<double>(rays_)),
                            more == 0 ? ""
                                      : fmt::format("; in {} of it {} pairs of shapes do so",
                                                    percent_text(static_cast<double>(all) /
                                                                 static_cast<double>(rays_)),
                                                    list.size())),
                "move one of them by more than epsilon, or remove the covered one");
        }
    }

  private:
    // Counts the faces that coincide with those that were hit.
    void find_along(const std::vector<SurfaceHit>& hits) {
        // Of two that are hit at the same t, the later.
        World from_behind = context_.prepared();
        WorldAccess::own(from_behind).ties = TieRule::last;
        RayList at, beyond;
        for (const SurfaceHit& hit : hits) at.add(hit.origin, hit.incoming, hit.t - hit.t * 0x1p-52);
        const HitList last = nearest_hits(from_behind.parts(), at, context_.threads());
        std::vector<const SurfaceHit*> nearer;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const SurfaceHit& hit = hits[i];
            if (!last.surface[i].exists()) continue;
            if (last.surface[i] != hit.surface) {
                consider(hit, last.surface[i], hit.point);
                continue;
            }
            const double slope = number::abs(dot(hit.normal, hit.incoming));
            if (slope < k_grazing * length(hit.incoming)) continue;
            beyond.add(hit.origin, hit.incoming, hit.t,
                       hit.t + tolerance(world_.conventions, hit.magnitude) / slope);
            nearer.push_back(&hit);
        }
        const HitList second = nearest_hits(world_, beyond, context_.threads());
        for (std::size_t i = 0; i < nearer.size(); ++i) {
            if (second.surface[i].exists())
                consider(*nearer[i], second.surface[i],
                         nearer[i]->origin + nearer[i]->incoming * second.t[i]);
        }
    }

    // b: a surface that the ray of `a` hits at `point`.
    void consider(const SurfaceHit& a, SurfaceId b, Vec3 point) {
        const std::uint32_t shape = world_.geometry->shape_of(b);
        if (a.shape == shape) return;
        const double along = dot(a.normal, facing_normal(world_, b, point, a.incoming));
        if (number::abs(along) < 1 - k_parallel) return;
        const auto first = surface_values(world_, a.surface), second = surface_values(world_, b);
        // Two faces of equal materials show no difference, unless light goes through them.
        const bool same = along > 0 && first == second;
        if (same && !(first[k_transmission] > 0)) return;
        ++pixels_[{std::min(a.shape, shape), std::max(a.shape, shape)}];
    }

    CheckContext& context_;
    const WorldParts& world_;
    std::size_t rays_ = 0;
    std::map<Pair, std::size_t> pixels_;
};

}  // namespace

std::vector<bool> check_coincident_shapes(CheckContext& context) {
    std::vector<bool> covered(context.scene().shapes.size());
    check_twins(context, covered);
    Coincidences coincidences(context);
    coincidences.find();
    coincidences.report(covered);
    return covered;
}

}  // namespace glint
