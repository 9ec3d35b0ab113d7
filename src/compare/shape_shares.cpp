// SPDX-License-Identifier: Apache-2.0
#include "compare/shape_shares.h"

#include <algorithm>
#include <cstdlib>

#include "base/sort_stably.h"
#include "trace/rays/camera_rays-inl.h"
#include "world/prepare_camera.h"

namespace glint {

namespace {

constexpr std::size_t k_rays_at_a_time = 1 << 16;

// Calls add(shape) for every pixel: k_none if the camera sees none there. False if that is not known.
template <class Add> bool for_each_shape(const SceneRenderer& renderer, const PixelGrid& grid, Add&& add) {
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
        if (rays.size() < k_rays_at_a_time && y + 1 < grid.rows()) continue;
        const Result<std::vector<RayHit>> hits = nearest_hits(renderer.world(), rays, renderer.threads());
        if (!hits) return false;
        for (const RayHit& hit : *hits) add(hit.shape);
        rays.clear();
    }
    return true;
}

}  // namespace

std::vector<std::uint32_t> shapes_of_pixels(const SceneRenderer& renderer, const PixelGrid& grid) {
    std::vector<std::uint32_t> shapes;
    for_each_shape(renderer, grid, [&](std::uint32_t shape) { shapes.push_back(shape); });
    shapes.resize(static_cast<std::size_t>(grid.columns()) * grid.rows(), k_none);
    return shapes;
}

std::vector<bool> background_pixels(const SceneRenderer& renderer, const PixelGrid& grid) {
    const std::size_t size = static_cast<std::size_t>(grid.columns()) * grid.rows();
    std::vector<bool> marks;
    marks.reserve(size);
    const bool is_known =
        for_each_shape(renderer, grid, [&](std::uint32_t shape) { marks.push_back(shape == k_none); });
    return is_known ? marks : std::vector<bool>(size);
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
    sort_stably(shares, [](const auto& x, const auto& y) { return x.share > y.share; });
    return shares;
}

}  // namespace glint
