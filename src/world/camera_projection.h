// SPDX-License-Identifier: Apache-2.0
#pragma once
// From points of the world to the picture: the inverse of viewport_ray (trace/rays/camera_rays-inl.h).
#include "math/transform.h"
#include "world/world.h"

namespace glint {

/// A point in the camera's frame: position + x right + y up + depth forward.
struct CameraCoordinates {
    double x, y, depth;
};

class CameraProjection {
  public:
    explicit CameraProjection(const PreparedCamera& camera) : position_(camera.position) {
        const Vec3 r = camera.right, u = camera.up, f = camera.forward;
        const double volume = dot(cross(r, u), f);
        to_x_ = cross(u, f) / volume;
        to_y_ = cross(f, r) / volume;
        to_depth_ = cross(r, u) / volume;
    }

    /// An orthographic camera sees the point at (x, y) of the viewport, a perspective one at (x, y) / depth.
    CameraCoordinates coordinates(Vec3 p) const {
        const Vec3 way = p - position_;
        return {dot(way, to_x_), dot(way, to_y_), dot(way, to_depth_)};
    }

  private:
    Vec3 position_, to_x_, to_y_, to_depth_;
};

}  // namespace glint
