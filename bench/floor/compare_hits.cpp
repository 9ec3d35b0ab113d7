// SPDX-License-Identifier: Apache-2.0
// compare_hits SCENE [SIZE]: the first hits of a picture of SIZE x SIZE pixels, by glint and by Embree, which
// finds the nearest triangle in single precision. Prints JSON: the pixels where exactly one hits, and the
// greatest differences of depth, as a fraction of the scene's size, and of normals, over 99.99% and all of
// the pixels that both hit.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "embree_scene.h"
#include "frame_rays.h"
#include "glint/render.h"
#include "read_scene.h"

using namespace glint_floor;

namespace {

double length(Vec3 v) { return std::sqrt(dot(v, v)); }

void print(const char* name, std::vector<double>& differences) {
    std::sort(differences.begin(), differences.end());
    const std::size_t count = differences.size();
    const double most = count > 0 ? differences.back() : 0;
    const double usual =
        count > 0 ? differences[static_cast<std::size_t>(0.9999 * static_cast<double>(count - 1))] : 0;
    const auto within = std::upper_bound(differences.begin(), differences.end(), 1e-5) - differences.begin();
    std::printf(", \"%s\": {\"within_1e-5\": %.6f, \"of_99.99%%\": %.3g, \"of_all\": %.3g}", name,
                count > 0 ? static_cast<double>(within) / static_cast<double>(count) : 1, usual, most);
}

}  // namespace

int main(int count, char** arguments) {
    const int size = count > 2 ? std::atoi(arguments[2]) : 1024;
    if (count < 2 || count > 3 || size < 1 || size > 16384) {
        std::fputs("usage: compare_hits SCENE [SIZE]\n", stderr);
        return 2;
    }
    glint::Result<glint::Scene> scene = read_scene(arguments[1]);
    if (!scene) return fail("compare_hits", scene);
    scene->settings.width = scene->settings.height = size;
    scene->settings.samples = 1;
    glint::RenderOptions options;
    options.layers = {glint::Layer::depth, glint::Layer::normal};
    const glint::Result<glint::World> world = glint::prepare(*scene);
    if (!world) return fail("compare_hits", world);
    const glint::Result<glint::Rendering> drawn = glint::render(*world, options);
    if (!drawn) return fail("compare_hits", drawn);
    const EmbreeScene embree(*scene, 2);
    const double scene_size = embree.size();
    const std::vector<float>& depth = drawn->layers[0].values;
    const std::vector<float>& normal = drawn->layers[1].values;
    std::vector<double> depths, normals;
    int one = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * size + x;
            const Vec3 direction = camera_direction(scene->camera, size, x, y);
            Hit hit;
            const bool is_hit = embree.nearest(scene->camera.position, direction, hit);
            if (is_hit != std::isfinite(depth[at])) ++one;
            if (!is_hit || !std::isfinite(depth[at])) continue;
            const Vec3 n{normal[3 * at], normal[3 * at + 1], normal[3 * at + 2]};
            depths.push_back(std::abs(length(hit.point - scene->camera.position) - depth[at]) / scene_size);
            normals.push_back(std::min(length(n - hit.normal), length(n + hit.normal)));
        }
    }
    std::printf("{\"pixels\": %d, \"both\": %zu, \"one\": %d", size * size, depths.size(), one);
    print("depth", depths);
    print("normal", normals);
    std::puts("}");
    return 0;
}
