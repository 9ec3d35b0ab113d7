// SPDX-License-Identifier: Apache-2.0
#pragma once
// The interface for writing a database, with one implementation per format. Coordinates are right-handed.
#include <cmath>
#include <cstdio>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "glint/vec.h"

namespace spd {

using glint::Color;
using glint::Vec3;

struct View {
    Vec3 from{}, at{}, up{0, 0, 1};
    double angle = 45;  ///< full vertical angle in degrees
    double hither = 1;  ///< written for scan-line programs; ray tracers ignore it
    std::vector<Vec3> lights{};
    Color background{0.078, 0.361, 0.753};
};

/// NFF's fill: k_d = kd color, white highlights and mirrors of ks, Phong's exponent, T and its index of
/// refraction.
struct Surface {
    Color color{};
    double kd = 1, ks = 0, shine = 100000, transmission = 0, ior = 0;
};

/// The Phong exponent of a highlight that falls to one half at this angle from its middle, in degrees.
double shine_of_angle(double degrees);

class SceneWriter {
  public:
    virtual ~SceneWriter() = default;
    virtual void begin(const View& view) = 0;
    virtual void surface(const Surface& surface) = 0;
    virtual void sphere(Vec3 center, double radius) = 0;
    virtual void cone(Vec3 base, double base_radius, Vec3 apex, double apex_radius) = 0;  ///< without caps
    virtual void polygon(std::span<const Vec3> vertices) = 0;                             ///< may be concave
    virtual void patch(const Vec3 (&vertices)[3], const Vec3 (&normals)[3]) = 0;
    virtual void end() {}
};

std::unique_ptr<SceneWriter> make_nff_writer(std::FILE* file);
std::unique_ptr<SceneWriter> make_pov_writer(std::FILE* file);

/// Tachyon has no cones and no polygons except triangles: cones become cylinders of their mean radius.
std::unique_ptr<SceneWriter> make_tachyon_writer(std::FILE* file);

inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 unit(Vec3 a) { return a / length(a); }
/// `p` rotated about the unit `axis`, counter-clockwise when seen from its tip.
Vec3 rotate(Vec3 p, Vec3 axis, double sine, double cosine);
Vec3 rotate(Vec3 p, Vec3 axis, double radians);

}  // namespace spd
