// SPDX-License-Identifier: Apache-2.0
#include "compare/pixel_grid.h"

#include <algorithm>

#include "world/prepare_camera.h"

namespace glint {

PixelGrid grid_of(const Scene& scene, std::int32_t width, std::int32_t height) {
    PixelGrid grid{width, height, 1};
    if (scene.conventions.pixel_sample == PixelSample::whole) return grid;  // pixels are world units
    const auto pixels = [&](std::int32_t step) { return std::int64_t{width / step} * (height / step); };
    while (pixels(grid.step) > 3 * k_grid_pixels) grid.step += 2;
    // If blocks fill the picture, they are the same ones in the flipped picture.
    for (std::int32_t step = grid.step; pixels(step) > k_grid_pixels / 3 && step > 1; step += 2) {
        if (width % step == 0 && height % step == 0) {
            grid.step = step;
            break;
        }
    }
    return grid;
}

PixelGrid coarse_grid_of(const Scene& scene, std::int32_t width, std::int32_t height) {
    PixelGrid grid{width, height, 1};
    if (scene.conventions.pixel_sample == PixelSample::whole) return grid;
    const auto pixels = [&](std::int32_t step) { return std::int64_t{width / step} * (height / step); };
    while (pixels(grid.step + 2) >= k_coarse_pixels) grid.step += 2;
    return grid;
}

Rows rows_of(const PixelGrid& grid) {
    Rows rows;
    for (std::int32_t y = 0; y < grid.rows(); ++y) rows.push_back(y * grid.step + grid.step / 2);
    return rows;
}

BytePicture on_grid(const BytePicture& picture, const PixelGrid& grid) {
    if (grid.step == 1) return picture;
    BytePicture small{grid.columns(), grid.rows(), {}};
    small.rgb.resize(std::size_t{3} * small.width * small.height);
    for (std::int32_t y = 0; y < small.height; ++y) {
        for (std::int32_t x = 0; x < small.width; ++x)
            std::copy_n(picture.pixel(x * grid.step + grid.step / 2, y * grid.step + grid.step / 2), 3,
                        small.pixel(x, y));
    }
    return small;
}

std::vector<std::uint8_t> on_grid(const std::vector<std::uint8_t>& marks, const PixelGrid& grid) {
    if (grid.step == 1) return marks;
    std::vector<std::uint8_t> small;
    for (std::int32_t y = 0; y < grid.rows(); ++y) {
        for (std::int32_t x = 0; x < grid.columns(); ++x)
            small.push_back(marks[static_cast<std::size_t>(y * grid.step + grid.step / 2) * grid.width +
                                  x * grid.step + grid.step / 2]);
    }
    return small;
}

void set_grid(Scene& scene, const PixelGrid& grid) {
    if (grid.step == 1) return;
    const PreparedCamera camera = prepare_camera(scene.camera, scene.settings);
    const double across = static_cast<double>(grid.step) * grid.columns() / grid.width,
                 along = static_cast<double>(grid.step) * grid.rows() / grid.height;
    // The rays of the bottom-left corner pass half a pixel further left and down, those of the top-right one
    // further right and up.
    const PixelSample where = scene.conventions.pixel_sample;
    const double half = where == PixelSample::corner ? 0.5 : where == PixelSample::top_right ? -0.5 : 0;
    const Vec3 shift = camera.right * ((across - 1) / 2 - half / grid.width) +
                       camera.up * ((1 - along) / 2 - half / grid.height);
    const bool perspective = scene.camera.projection == Projection::perspective;
    scene.camera.frame = {camera.right * across, camera.up * along,
                          perspective ? camera.forward + shift : camera.forward};
    if (!perspective) scene.camera.position = scene.camera.position + shift;
    scene.conventions.pixel_sample = PixelSample::center;
    scene.settings.width = grid.columns();
    scene.settings.height = grid.rows();
    scene.settings.samples = 1;
}

}  // namespace glint
