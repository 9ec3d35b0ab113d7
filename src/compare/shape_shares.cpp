// SPDX-License-Identifier: Apache-2.0
#include "compare/shape_shares.h"

#include <algorithm>
#include <cstdlib>

#include "trace/rays/camera_rays-inl.h"
#include "world/prepare_camera.h"

namespace glint {

std::vector<std::uint32_t> shapes_of_pixels(const SceneRenderer& renderer, const PixelGrid& grid) {
    Scene scene = renderer.scene().shading;
    set_grid(scene, grid);
    const PreparedCamera camera = prepare_camera(scene.camera, scene.settings);
    std::vector<Ray> rays;
    for (std::int32_t y = 0; y < grid.rows(); ++y) {
        for (std::int32_t x = 0; x < grid.columns(); ++x) {
            const auto ray = HWY_NAMESPACE::viewport_ray(camera, (x + 0.5) / grid.columns() - 0.5,
                                                         0.5 - (y + 0.5) / grid.rows());
            rays.push_back({ray.origin, ray.direction});
        }
    }
    const Result<std::vector<RayHit>> hits = nearest_hits(renderer.world(), rays, renderer.threads());
    std::vector<std::uint32_t> shapes;
    if (hits) {
        for (const RayHit& hit : *hits) shapes.push_back(hit.shape);
    }
    shapes.resize(rays.size(), k_none);
    return shapes;
}

std::vector<ShapeShare> shares_of_shapes(const std::vector<std::uint32_t>& shapes, const BytePicture& a,
                                         const BytePicture& b) {
    std::vector<std::pair<std::uint32_t, double>> pixels;
    double whole = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        double difference = 0;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) difference += std::abs(int{a.rgb[c]} - int{b.rgb[c]});
        whole += difference;
        if (difference > 0) pixels.emplace_back(shapes[i], difference);
    }
    std::sort(pixels.begin(), pixels.end());
    std::vector<ShapeShare> shares;
    for (const auto& [shape, difference] : pixels) {
        if (shares.empty() || shares.back().shape != shape) shares.push_back({shape, 0});
        shares.back().share += difference / whole;
    }
    std::stable_sort(shares.begin(), shares.end(),
                     [](const auto& x, const auto& y) { return x.share > y.share; });
    return shares;
}

}  // namespace glint
