// SPDX-License-Identifier: Apache-2.0
#pragma once
// The surfaces that the camera rays of some pixels and their secondary rays hit, as the stages of the
// renderer compute them, for check().
#include <cstddef>
#include <cstdint>
#include <vector>

#include "glint/vec.h"
#include "trace/ray_list.h"
#include "world/world.h"

namespace glint {

/// A hit of a ray.
struct SurfaceHit {
    Vec3 point, normal;     // unit normal, flipped towards the ray if the conventions say so
    Vec3 origin, incoming;  // the ray
    double t = 0;           // of the hit
    SurfaceId surface;
    std::uint32_t shape = 0, material = 0;
    std::size_t ray = 0;   // the number of the pixel in the list
    double magnitude = 0;  // as in SurfacePoint
    bool behind = false;   // the ray came from the back of the shape
};

/// The hits by generation: [0] of the camera rays. A stage adds those of as many generations as there are.
using SurfaceRecord = std::vector<std::vector<SurfaceHit>>;

/// Positions in the picture, in pixels from its top left corner.
struct PixelPositions {
    std::vector<double> x, y;
    std::size_t size() const { return x.size(); }
    void add(double px, double py) {
        x.push_back(px);
        y.push_back(py);
    }
};

/// The camera rays through the sample of each pixel, of one sample a pixel.
RayList camera_rays(const WorldParts& world, const PixelPositions& pixels);

/// Follows those rays for some generations, in the pixels' order.
SurfaceRecord follow_pixels(const WorldParts& world, const PixelPositions& pixels, std::size_t generations,
                            int threads);

}  // namespace glint
