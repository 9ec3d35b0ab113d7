// SPDX-License-Identifier: Apache-2.0
#include "scene/validate_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include "scene/closed_mesh.h"
#include "scene/ranges.h"
#include "scene/validate_mesh.h"
#include "scene/validate_solid.h"

namespace glint {
namespace {

class ParameterCheck {
  public:
    ParameterCheck(const Scene& scene, std::vector<std::string>& mistakes,
                   std::set<const MeshData*>& valid_meshes, std::set<const MeshData*>& closed_meshes)
        : scene_(scene), mistakes_(mistakes), valid_meshes_(valid_meshes), closed_meshes_(closed_meshes) {}

    void check(const Shape& s) {
        switch (s.kind) {
#define GLINT_KIND(Type, word)                                                      \
    case ShapeKind::word:                                                           \
        if (s.index >= scene_.get<Type>().size()) return say("no such parameters"); \
        return check_parameters(scene_.get<Type>()[s.index]);
            GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
        }
        say("no such kind of shape");
    }

  private:
    void say(std::string mistake) { mistakes_.push_back(std::move(mistake)); }

    // The valid values of a shape's fields().
    struct FieldCheck {
        std::vector<std::string>& mistakes;
        void say(std::string mistake) { mistakes.push_back(std::move(mistake)); }
        void point(std::string_view name, const Vec3& p) {
            if (!is_coordinate(p)) say(fmt::format("expected a {} within 1e12, found {}", name, text(p)));
        }
        void direction(std::string_view name, const Vec3& d) {
            if (is_coordinate(d) && !is_zero(d)) return;
            say(fmt::format("expected {} {} other than (0, 0, 0) and within 1e12, found {}",
                            name == "axis" ? "an" : "a", name, text(d)));
        }
        void coefficients(std::string_view name, const Vec3& v) {
            if (!is_coordinate(v))
                say(fmt::format("{}: expected numbers within 1e12, found {}", name, text(v)));
        }
        void coefficient(std::string_view name, double x) {
            if (!is_coordinate({x, 0, 0}))
                say(fmt::format("{}: expected a number within 1e12, found {}", name, x));
        }
        void length(std::string_view name, double x) {
            if (k_length.contains(x)) return;
            say(fmt::format("{}: expected {}, found {}", name, k_length.text, x));
        }
        void radius(std::string_view name, double x) {
            if (k_not_negative.contains(x)) return;
            say(fmt::format("{}: expected {}, found {}", name, k_not_negative.text, x));
        }
    };
    template <class T> void check_parameters(const T& shape) { T::fields(shape, FieldCheck{mistakes_}); }

    void check_parameters(const Disc& disc) {
        Disc::fields(disc, FieldCheck{mistakes_});
        if (disc.radius > 0 && disc.hole >= disc.radius) {
            say(fmt::format("expected a hole smaller than the radius {}, found {}", disc.radius, disc.hole));
        }
    }

    void check_parameters(const Quadric& quadric) {
        Quadric::fields(quadric, FieldCheck{mistakes_});
        if (is_zero(quadric.squares) && is_zero(quadric.products) && is_zero(quadric.linear))
            say("expected a coefficient other than 0 in squares, products or linear");
    }

    void check_parameters(const Quartic& quartic) {
        Quartic::fields(quartic, FieldCheck{mistakes_});
        const auto last = std::end(quartic.coefficients) - 1;
        if (std::all_of(std::begin(quartic.coefficients), last, [](double x) { return x == 0; }))
            say("expected a coefficient other than 0 besides the constant");
    }

    void check_parameters(const Cylinder& c) {
        if (!is_coordinate(c.from) || !is_coordinate(c.to)) {
            say(fmt::format("expected an axis within 1e12, found {} to {}", text(c.from), text(c.to)));
        } else if (c.from == c.to) {
            say("expected an axis of some length, found two equal ends " + text(c.from));
        }
        FieldCheck{mistakes_}.length("radius", c.radius);
    }

    void check_parameters(const Cone& c) {
        check_parameters(Cylinder{c.from, c.to, 1, c.caps});
        if (!k_not_negative.contains(c.from_radius) || !k_not_negative.contains(c.to_radius)) {
            say(fmt::format("radius: expected {}, found ({}, {})", k_not_negative.text, c.from_radius,
                            c.to_radius));
        } else if (c.from_radius == 0 && c.to_radius == 0) {
            say("expected a radius > 0 at one end at least, found (0, 0)");
        }
    }

    void check_parameters(const Box& c) {
        check_vertices(std::array{c.min, c.max});
        if (c.min.x > c.max.x || c.min.y > c.max.y || c.min.z > c.max.z) {
            say(fmt::format("expected min at most max in each coordinate, found {} and {}", text(c.min),
                            text(c.max)));
        }
    }

    void check_parameters(const Triangle& t) { check_vertices(t.vertices); }

    void check_parameters(const SmoothTriangle& t) {
        check_vertices(t.vertices);
        for (const Vec3& n : t.normals) FieldCheck{mistakes_}.direction("normal", n);
    }

    void check_parameters(const Polygon& p) {
        const std::size_t known = scene_.polygon_vertices.size();
        if (p.first > known || p.count > known - p.first) return say("no such vertices");
        if (p.count < 3) return say(fmt::format("expected at least 3 vertices, found {}", p.count));
        if (p.count > k_max_polygon_vertices) {
            return say(fmt::format("expected at most {} vertices, found {}: cut it into smaller polygons",
                                   k_max_polygon_vertices, p.count));
        }
        check_vertices(std::span(scene_.polygon_vertices).subspan(p.first, p.count));
    }

    void check_parameters(const Mesh& shape) {
        if (shape.mesh >= scene_.meshes.size() || scene_.meshes[shape.mesh] == nullptr)
            return say("no such mesh");
        const MeshData* mesh = scene_.meshes[shape.mesh].get();
        if (valid_meshes_.contains(mesh)) return;
        std::string mistake = mistake_in(*mesh);
        if (mistake.empty()) {
            valid_meshes_.insert(mesh);
        } else {
            say(std::move(mistake));
        }
    }

    void check_parameters(const Solid& shape) {
        if (shape.solid >= scene_.solids.size()) return say("no such solid");
        const SolidTree& tree = scene_.solids[shape.solid];
        if (std::string mistake = mistake_in_steps(tree); !mistake.empty()) return say(std::move(mistake));
        for (std::size_t i = 0; i < tree.operands.size(); ++i) check_operand(i, tree.operands[i]);
    }
    void check_operand(std::size_t number, const Shape& operand) {
        std::vector<std::string> mistakes;
        if (operand.kind == ShapeKind::mesh) {
            ParameterCheck(scene_, mistakes, valid_meshes_, closed_meshes_).check(operand);
            if (mistakes.empty())
                check_closed(*scene_.meshes[scene_.get<Mesh>()[operand.index].mesh], mistakes);
        } else if (!encloses_space(scene_, operand)) {
            mistakes.push_back(fmt::format(
                "expected a shape that encloses a space (a sphere, box, torus, quadric, quartic or plane, "
                "a cylinder or cone with caps, or a closed mesh), found a {}",
                to_string(operand.kind)));
        } else {
            ParameterCheck(scene_, mistakes, valid_meshes_, closed_meshes_).check(operand);
        }
        if (operand.transform != k_none && operand.transform >= scene_.transforms.size())
            mistakes.emplace_back("no such transform");
        for (const std::string& mistake : mistakes) say(fmt::format("operand {}: {}", number + 1, mistake));
    }

    void check_closed(const MeshData& mesh, std::vector<std::string>& mistakes) {
        if (closed_meshes_.contains(&mesh)) return;
        const std::optional<std::uint32_t> open = find_open_triangle(mesh);
        if (!open) {
            closed_meshes_.insert(&mesh);
            if (!mesh.normals.empty() && is_inside_out(mesh)) {
                mistakes.emplace_back(
                    "expected the triangles of a mesh with normals to be counterclockwise seen from outside, "
                    "found them clockwise");
            }
            return;
        }
        mistakes.push_back(fmt::format(
            "expected a closed mesh, with each edge in two triangles that have it in opposite directions; "
            "triangle {} has another",
            *open));
    }

    void check_vertices(std::span<const Vec3> vertices) {
        for (const Vec3& v : vertices) {
            if (!is_coordinate(v)) return say("expected a vertex within 1e12, found " + text(v));
        }
    }

    const Scene& scene_;
    std::vector<std::string>& mistakes_;
    std::set<const MeshData*>&valid_meshes_, &closed_meshes_;
};

}  // namespace

std::string text(Vec3 v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

const std::vector<std::string>& ShapeCheck::mistakes(const Shape& shape) {
    mistakes_.clear();
    ParameterCheck(scene_, mistakes_, valid_meshes_, closed_meshes_).check(shape);
    return mistakes_;
}

}  // namespace glint
