// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/closed_mesh.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/sort_stably.h"
#include "formats/povray/outward_faces.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/closed_mesh.h"

namespace glint::povray {
namespace {

constexpr std::size_t k_max_steps = 30'000'000;
constexpr std::size_t k_most_pieces = 8;  // for each triangle, and for each vertex on an edge
constexpr double k_on_edge = 2e-7;        // of the mesh's size: positions are in single precision

class MeshCloser {
  public:
    explicit MeshCloser(const ReadMesh& mesh) : mesh_(mesh) {
        CountedVector<Vec3> positions;
        for (const Float3& v : mesh.vertices) positions.push_back(to_vec3(v));
        first_ = first_vertices(positions);
        find_edges();
    }

    bool is_closed() const { return !find_open_edge(edges_); }

    // Splits triangles where vertices of others lie on their edges. False if it takes too long, or if the
    // triangles have normals or textures: prisms and texts have none.
    bool split() {
        CountedVector<char> is_open(3 * mesh_.triangles.size()), is_end(mesh_.vertices.size());
        bool is_any = false;
        for_each_edge(edges_, [&](std::span<const MeshEdge> edge) {
            if (edge.size() % 2 == 0) return;
            is_any = true;
            is_open[3 * edge.front().triangle + edge.front().side] = 1;
            is_end[edge.front().low] = is_end[edge.front().high] = 1;
        });
        if (!is_any) return true;
        if (!mesh_.normal_corners.empty() || !mesh_.uv_corners.empty() || !mesh_.texture_corners.empty())
            return false;
        find_points(is_end);
        const CountedVector<TriangleCorners> whole = std::move(mesh_.triangles);
        mesh_.triangles = {};
        for (std::size_t i = 0; i < whole.size(); ++i) {
            Points points[3];
            for (std::size_t side = 0; side < 3; ++side) {
                if (is_open[3 * i + side] != 0)
                    points[side] = points_between(whole[i][side], whole[i][(side + 1) % 3]);
            }
            const std::size_t most = k_most_pieces * (whole.size() + by_axis_[0].size());
            if (steps_ > k_max_steps || mesh_.triangles.size() > most) return false;
            add(whole[i], {points[0], points[1], points[2]});
        }
        find_edges();
        return true;
    }

    // Turns triangles so that those with a common edge have it in opposite directions, and all face
    // outwards. False if that takes too long.
    bool turn() {
        const std::size_t count = mesh_.triangles.size();
        CountedVector<std::uint32_t> beside(3 * count, k_none);
        for_each_edge(edges_, [&](std::span<const MeshEdge> edge) {
            if (edge.size() != 2) return;
            beside[3 * edge[0].triangle + edge[0].side] = edge[1].triangle;
            beside[3 * edge[1].triangle + edge[1].side] = edge[0].triangle;
        });
        CountedVector<char> is_known(count), is_turned(count);
        for (std::uint32_t first = 0; first < count; ++first) {
            if (is_known[first] != 0) continue;
            is_known[first] = 1;
            CountedVector<std::uint32_t> together{first};
            for (std::size_t next = 0; next < together.size(); ++next) {
                const std::uint32_t i = together[next];
                for (std::size_t side = 0; side < 3; ++side) {
                    const std::uint32_t other = beside[3 * i + side];
                    if (other == k_none || is_known[other] != 0) continue;
                    is_known[other] = 1;
                    is_turned[other] = (is_turned[i] != 0) != is_same_way(i, side, other);
                    together.push_back(other);
                }
            }
            if ((steps_ += count) > k_max_steps) return false;
            std::uint32_t largest = first;
            for (const std::uint32_t i : together) {
                if (area(i) > area(largest)) largest = i;
            }
            if (faces_outwards(mesh_, largest) != (is_turned[largest] != 0)) continue;
            for (const std::uint32_t i : together) is_turned[i] = is_turned[i] == 0;
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (is_turned[i] == 0) continue;
            has_turned_ = true;
            for (auto* const list :
                 {&mesh_.triangles, &mesh_.normal_corners, &mesh_.uv_corners, &mesh_.texture_corners})
                if (i < list->size()) std::swap((*list)[i][1], (*list)[i][2]);
        }
        find_edges();
        return true;
    }

    bool has_turned() const { return has_turned_; }
    const ReadMesh& mesh() const { return mesh_; }

  private:
    struct Point {
        double at;  // 0 to 1
        std::uint32_t vertex;
    };
    using Points = CountedVector<Point>;

    Vec3 position(std::uint32_t vertex) const { return to_vec3(mesh_.vertices[vertex]); }
    double coordinate(std::uint32_t vertex, std::size_t axis) const {
        const Float3& v = mesh_.vertices[vertex];
        return static_cast<double>(axis == 0 ? v.x : axis == 1 ? v.y : v.z);
    }

    void find_edges() { edges_ = edges_of(mesh_.triangles, first_); }

    // The vertices on which edges end, by each coordinate.
    void find_points(const CountedVector<char>& is_end) {
        CountedVector<std::uint32_t> ends;
        for (std::uint32_t v = 0; v < is_end.size(); ++v) {
            if (is_end[v] != 0) ends.push_back(v);
        }
        double size = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            by_axis_[axis] = ends;
            sort_stably(by_axis_[axis], [&](std::uint32_t a, std::uint32_t b) {
                return coordinate(a, axis) < coordinate(b, axis);
            });
            size = number::max(
                size, coordinate(by_axis_[axis].back(), axis) - coordinate(by_axis_[axis].front(), axis));
        }
        tolerance_ = k_on_edge * size;
    }

    // The ends of other edges that are on an edge, along it.
    Points points_between(std::uint32_t from, std::uint32_t to) {
        const Vec3 a = position(from), way = position(to) - a;
        // Those that may be on it, by the coordinate that leaves the fewest.
        std::span<const std::uint32_t> near;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = coordinate(from, axis), y = coordinate(to, axis);
            const auto& all = by_axis_[axis];
            const auto below = [&](std::uint32_t v, double limit) { return coordinate(v, axis) < limit; };
            // Pointers, because older versions of libc++ make no span of iterators.
            const std::uint32_t *const begin = all.data(), *const end = begin + all.size();
            const std::span<const std::uint32_t> range(
                std::lower_bound(begin, end, number::min(x, y) - tolerance_, below),
                std::lower_bound(begin, end, number::max(x, y) + tolerance_, below));
            if (axis == 0 || range.size() < near.size()) near = range;
        }
        steps_ += near.size();
        Points found;
        for (const std::uint32_t vertex : near) {
            const Vec3 p = position(vertex) - a;
            const double at = dot(p, way) / dot(way, way);
            const bool is_other = vertex != first_[from] && vertex != first_[to];
            if (is_other && at > 0 && at < 1 && length(p - way * at) <= tolerance_)
                found.push_back({at, vertex});
        }
        sort_stably(found, [](const Point& x, const Point& y) { return x.at < y.at; });
        return found;
    }

    // points: on each side.
    void add(const TriangleCorners& corners, const std::array<std::span<const Point>, 3>& points) {
        std::size_t side = 0;
        while (side < 3 && points[side].empty()) ++side;
        if (side == 3) {
            mesh_.triangles.push_back(corners);
            return;
        }
        const std::uint32_t tip = corners[(side + 2) % 3];
        const std::span<const Point> none;
        std::uint32_t last = corners[side];
        for (std::size_t i = 0; i <= points[side].size(); ++i) {
            const bool is_last = i == points[side].size();
            const std::uint32_t end = is_last ? corners[(side + 1) % 3] : points[side][i].vertex;
            add({last, end, tip},
                {none, is_last ? points[(side + 1) % 3] : none, i == 0 ? points[(side + 2) % 3] : none});
            last = end;
        }
    }

    double area(std::uint32_t triangle) const {
        const TriangleCorners& t = mesh_.triangles[triangle];
        const Vec3 a = position(t[0]);
        return length(cross(position(t[1]) - a, position(t[2]) - a));
    }
    // Whether both have their common edge in one direction.
    bool is_same_way(std::uint32_t triangle, std::size_t side, std::uint32_t other) const {
        const auto corner = [&](std::uint32_t of, std::size_t k) {
            return first_[mesh_.triangles[of][k % 3]];
        };
        for (std::size_t k = 0; k < 3; ++k) {
            if (corner(other, k) == corner(triangle, side) &&
                corner(other, k + 1) == corner(triangle, side + 1))
                return true;
        }
        return false;
    }

    ReadMesh mesh_;
    std::vector<std::uint32_t> first_;
    std::vector<MeshEdge> edges_;
    std::array<CountedVector<std::uint32_t>, 3> by_axis_;
    double tolerance_ = 0;
    std::size_t steps_ = 0;
    bool has_turned_ = false;
};

// Of vertices that are there: it is asked for after errors, too.
bool has_triangles(const ReadMesh& mesh) {
    constexpr std::size_t least = 4;  // of a tetrahedron
    return mesh.triangles.size() >= least && !mesh.far &&
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const TriangleCorners& t) {
               return *std::max_element(t.begin(), t.end()) < mesh.vertices.size();
           });
}

std::shared_ptr<const ReadMesh> split_and_turned(MeshCloser& closer) {
    if (!closer.split() || !closer.turn() || !closer.is_closed()) return nullptr;
    return make_counted<ReadMesh>(closer.mesh());
}

}  // namespace

std::shared_ptr<const ReadMesh> closed_mesh(const std::shared_ptr<const ReadMesh>& mesh) {
    ReadMesh::Closed& closed = mesh->closed;
    if (!closed.is_known) {
        closed.is_known = true;
        if (!has_triangles(*mesh)) return nullptr;
        MeshCloser closer(*mesh);
        closed.is_closed = closer.is_closed();
        if (!closed.is_closed)
            closed.changed = split_and_turned(closer);
        else if (closer.turn() && !closer.has_turned())
            closed.is_outward = true;
        else if (closer.has_turned() && closer.is_closed())
            closed.changed = make_counted<ReadMesh>(closer.mesh());
        closed.is_outward |= closed.changed != nullptr;
    }
    return closed.is_closed && !closed.changed ? mesh : closed.changed;
}

std::shared_ptr<const ReadMesh> outward_mesh(const std::shared_ptr<const ReadMesh>& mesh) {
    const std::shared_ptr<const ReadMesh> closed = closed_mesh(mesh);
    return mesh->closed.is_outward ? closed : nullptr;
}

}  // namespace glint::povray
