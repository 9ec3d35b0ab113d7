// SPDX-License-Identifier: Apache-2.0
#pragma once
// A glint::Scene in Embree: spheres, cones and cylinders as Embree's round shapes, all others as triangles,
// those of meshes for each of their shapes.
#include <embree3/rtcore.h>

#include <cstdint>
#include <vector>

#include "glint/scene.h"

namespace glint_floor {

using glint::Vec3;

struct Hit {
    Vec3 point, normal;  ///< unit, on the shape's own outer side
    std::uint32_t material = glint::k_none;
};

class EmbreeScene {
  public:
    /// Embree's best build quality, on `threads` threads. Ends the program if Embree fails.
    EmbreeScene(const glint::Scene& scene, int threads);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene get() const { return scene_; }
    double size() const;  ///< the diagonal of its box

    /// Finds the nearest hit of origin + t direction for 0 < t. Returns whether there is one. Embree, in
    /// single precision, chooses the triangle; its point and normal are computed in double.
    bool nearest(Vec3 origin, Vec3 direction, Hit& hit) const;

  private:
    void add_rounds(const glint::Scene& scene);
    void add_triangles(const glint::Scene& scene);
    void add_mesh(const glint::Scene& scene, const glint::Shape& shape,
                  std::vector<glint::Triangle>& triangles);
    void attach(RTCGeometry geometry);

    RTCDevice device_;
    RTCScene scene_;
    std::vector<std::vector<std::uint32_t>> materials_;  // by geometry, by primitive
    std::vector<glint::Triangle> flat_;                  // all triangles
    std::vector<Vec3> normals_;                          // of the triangles: three each, or zeros if flat
    unsigned triangles_ = RTC_INVALID_GEOMETRY_ID;
};

}  // namespace glint_floor
