// SPDX-License-Identifier: Apache-2.0
// Triangles of meshes that contradict their neighbours, their normals, or each other.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "check/checks.h"

namespace glint {
namespace {

constexpr double k_few_triangles = 0.01;  // of a mesh's triangles: programs that export meshes make some

// Triangles of a mesh, by number.
struct Odd {
    std::size_t count = 0;
    std::uint32_t first = 0;  // the least
    void add(std::uint32_t triangle) {
        first = count == 0 ? triangle : std::min(first, triangle);
        ++count;
    }
};

// The triangles of a mesh in parts that hang together, each with the side of it that it shows.
class Sides {
  public:
    explicit Sides(std::uint32_t count) : links_(count) {
        for (std::uint32_t i = 0; i < count; ++i) links_[i].to = i;
    }
    /// Two neighbours: they show the same side, or not.
    void join(std::uint32_t a, std::uint32_t b, bool is_turned) {
        const Link x = find(a), y = find(b);
        if (x.to == y.to) {
            if ((x.is_turned != y.is_turned) != is_turned) links_[x.to].is_one_sided = true;
            return;
        }
        const bool one_sided = links_[x.to].is_one_sided || links_[y.to].is_one_sided;
        const auto [low, high] = std::minmax(x.to, y.to);
        links_[high].to = low;
        links_[high].is_turned = (x.is_turned != y.is_turned) != is_turned;
        links_[low].is_one_sided = one_sided;
    }
    /// In each part, the fewer of those that show different sides. None of a part with one side, as a Moebius
    /// strip: no order of vertices agrees there.
    Odd turned() {
        std::vector<std::array<Odd, 2>> parts(links_.size());
        for (std::uint32_t i = 0; i < links_.size(); ++i) {
            const Link link = find(i);
            if (!links_[link.to].is_one_sided) parts[link.to][link.is_turned ? 1 : 0].add(i);
        }
        Odd all;
        for (const auto& [straight, turned] : parts) {
            const Odd& fewer = turned.count <= straight.count ? turned : straight;
            if (fewer.count == 0) continue;
            all.first = all.count == 0 ? fewer.first : std::min(all.first, fewer.first);
            all.count += fewer.count;
        }
        return all;
    }

  private:
    struct Link {
        std::uint32_t to = 0;
        bool is_turned = false, is_one_sided = false;
    };
    // The first triangle of the part, and whether i shows another side than it.
    Link find(std::uint32_t i) {
        Link to{i};
        while (links_[to.to].to != to.to) {
            Link& link = links_[to.to];
            const Link next = links_[link.to];
            to.is_turned = to.is_turned != link.is_turned;
            to.to = link.to;
            // Half of the way is short next time.
            if (next.to != link.to) link = {next.to, link.is_turned != next.is_turned, link.is_one_sided};
        }
        return to;
    }

    std::vector<Link> links_;
};

class MeshCheck {
  public:
    /// name: of the shape, or of the operand of that solid.
    MeshCheck(CheckContext& context, const MeshData& mesh, std::uint32_t shape, std::string name)
        : context_(context), mesh_(mesh), shape_(shape), name_(std::move(name)) {}

    void run() {
        check_areas();
        check_normals();
        check_duplicates();
        check_winding();
    }

  private:
    Vec3 face(std::uint32_t triangle) const {
        const auto& [a, b, c] = mesh_.triangles[triangle];
        return cross(mesh_.position(b) - mesh_.position(a), mesh_.position(c) - mesh_.position(a));
    }
    std::uint32_t size() const { return static_cast<std::uint32_t>(mesh_.triangles.size()); }

    void report(std::string_view id, const Odd& odd, std::string_view what, std::string remedy,
                bool is_harmless = false) {
        if (odd.count == 0) return;
        const bool few = static_cast<double>(odd.count) < k_few_triangles * static_cast<double>(size());
        context_.report(
            id, context_.at_shape(shape_),
            fmt::format("{}: {} of the {} triangles of its mesh {}; the first is number {}, from 0", name_,
                        odd.count, size(), what, odd.first),
            std::move(remedy), few || is_harmless ? Severity::note : Severity::warning);
    }

    void check_areas() {
        Odd flat;
        for (std::uint32_t i = 0; i < size(); ++i) {
            if (face(i) == Vec3{}) flat.add(i);
        }
        report("mesh-without-area", flat, "have no area, so that no ray hits them", "leave them out", true);
    }

    // In the mesh's coordinates: a transform that mirrors would reverse the winding, but not the normals.
    void check_normals() {
        Odd against, mixed;
        for (std::uint32_t i = 0; i < size(); ++i) {
            const auto normals = mesh_.corner_normals(i);
            if (!normals) continue;
            const Vec3 n = face(i);
            const auto backward = std::count_if(normals->begin(), normals->end(),
                                                [&](const Float3& m) { return dot(to_vec3(m), n) < 0; });
            if (backward == 3) against.add(i);
            if (backward == 1 || backward == 2) mixed.add(i);
        }
        report("normals-against-winding", against,
               "have vertex normals that point to the side from which their vertices are clockwise",
               "reverse the normals, or the order of the vertices");
        report("normals-on-both-sides", mixed, "have vertex normals that point to different sides of them",
               "make the three normals of a triangle point to one side of it");
    }

    // Three numbers to compare, and a fourth that belongs to them.
    using Row = std::array<std::uint32_t, 4>;

    void check_duplicates() {
        std::vector<Row> rows;
        rows.reserve(size());
        for (std::uint32_t i = 0; i < size(); ++i) {
            TriangleCorners t = mesh_.triangles[i];
            std::sort(t.begin(), t.end());
            rows.push_back({t[0], t[1], t[2], i});
        }
        std::sort(rows.begin(), rows.end());
        Odd twice;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            if (std::equal(rows[i].begin(), rows[i].end() - 1, rows[i - 1].begin())) twice.add(rows[i][3]);
        }
        report("mesh-duplicates", twice, "have the vertices of another one",
               "leave them out: of two triangles in one place the first is drawn");
    }

    // Of two triangles that both have an edge in the same direction, one faces the other way.
    void check_winding() {
        std::vector<Row> rows;  // of an edge: its vertices in order, the triangle, its first corner there
        rows.reserve(3 * std::size_t{size()});
        for (std::uint32_t i = 0; i < size(); ++i) {
            const TriangleCorners& t = mesh_.triangles[i];
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t from = t[k], to = t[(k + 1) % 3];
                if (from != to) rows.push_back({std::min(from, to), std::max(from, to), i, k});
            }
        }
        std::sort(rows.begin(), rows.end());
        Sides sides(size());
        const auto corner = [&](const Row& row, std::uint32_t further) {
            return mesh_.triangles[row[2]][(row[3] + further) % 3];
        };
        for (std::size_t i = 0, end = 0; i < rows.size(); i = end) {
            while (end < rows.size() && rows[end][0] == rows[i][0] && rows[end][1] == rows[i][1]) ++end;
            if (end - i != 2) continue;
            const Row &a = rows[i], &b = rows[i + 1];
            // Two with the same three vertices are duplicates.
            if (corner(a, 2) != corner(b, 2)) sides.join(a[2], b[2], corner(a, 0) == corner(b, 0));
        }
        // Where the conventions turn all normals to the ray, flat triangles look the same from both sides,
        // but glass begins at the one and ends at the other.
        const bool is_glass = context_.material_of(shape_).transmission > 0;
        const Facing facing = context_.world().conventions.facing;
        report("mesh-winding", sides.turned(), "face the other way than their neighbours",
               "reverse the order of their vertices",
               !is_glass && (facing == Facing::all || facing == Facing::open));
    }

    CheckContext& context_;
    const MeshData& mesh_;
    const std::uint32_t shape_;  // the first one that has it
    const std::string name_;
};

}  // namespace

void check_meshes(CheckContext& context) {
    const Scene& scene = context.scene();
    std::vector<bool> is_done(scene.meshes.size());
    const auto look_at = [&](const Shape& shape, std::uint32_t i, const auto& name) {
        if (shape.kind != ShapeKind::mesh) return;
        const std::uint32_t mesh = scene.get<Mesh>()[shape.index].mesh;
        if (is_done[mesh]) return;
        is_done[mesh] = true;
        MeshCheck(context, *scene.meshes[mesh], i, name()).run();
    };
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        look_at(scene.shapes[i], i, [&] { return context.shape(i); });
        std::size_t number = 0;
        for (const Shape& operand : operands_of(scene, scene.shapes[i])) {
            ++number;
            look_at(operand, i, [&] { return fmt::format("shape {} of {}", number, context.shape(i)); });
        }
    }
}

}  // namespace glint
