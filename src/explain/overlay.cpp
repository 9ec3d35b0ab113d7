// SPDX-License-Identifier: Apache-2.0
// Draws a pixel's rays over the picture.
#include <fmt/format.h>

#include <cmath>

#include "base/status.h"
#include "explain/references.h"
#include "glint/explain.h"
#include "math/transform.h"
#include "world/camera_projection.h"
#include "world/world.h"

namespace glint {
namespace {

struct ScreenPoint {
    double x = 0, y = 0;  // in pixels from the picture's top-left corner
};

// The position in the picture of a point of the world.
class View {
  public:
    explicit View(const WorldParts& world)
        : is_perspective_(world.camera.projection == Projection::perspective),
          projection_(world.camera),
          width_(world.settings.width),
          height_(world.settings.height) {}

    // The distance along the camera's forward direction. Points behind a perspective camera have no position.
    double depth(Vec3 p) const { return projection_.coordinates(p).depth; }
    bool is_perspective() const { return is_perspective_; }

    ScreenPoint project(Vec3 p) const {
        const auto [x, y, depth] = projection_.coordinates(p);
        const double scale = is_perspective() ? 1 / depth : 1;
        return {(x * scale + 0.5) * width_, (0.5 - y * scale) * height_};
    }

  private:
    bool is_perspective_;
    CameraProjection projection_;
    double width_, height_;
};

constexpr double k_farthest = 1e15;  // pixels from the picture; beyond, a double has no fraction

class Pen {
  public:
    Pen(Image& image, const View& view) : image_(image), view_(view) {}

    // Draws a line given in world space; the part behind the camera is omitted.
    void draw(Vec3 from, Vec3 to, Color color) {
        if (view_.is_perspective()) {
            double a = view_.depth(from), b = view_.depth(to);
            if (a < b) {
                std::swap(a, b);
                std::swap(from, to);
            }
            const double nearest = 1e-4 * a;
            if (!(a > 0)) return;
            if (b < nearest) to = from + (to - from) * ((a - nearest) / (a - b));
        }
        draw(view_.project(from), view_.project(to), color);
    }

    void frame(int x, int y, Color color) {
        for (int i = -3; i <= 3; ++i) {
            for (const int side : {-3, 3}) {
                put(x + i, y + side, color);
                put(x + side, y + i, color);
            }
        }
    }

  private:
    // Clips to the picture (Liang and Barsky, 1984) and draws one pixel per step.
    void draw(ScreenPoint a, ScreenPoint b, Color color) {
        for (const double x : {a.x, a.y, b.x, b.y}) {
            if (!(std::fabs(x) < k_farthest)) return;
        }
        double first = 0, last = 1;
        const double dx = b.x - a.x, dy = b.y - a.y;
        const auto clip = [&](double p, double q) {
            if (p == 0) return q >= 0;
            const double t = q / p;
            if (p < 0) first = std::max(first, t);
            if (p > 0) last = std::min(last, t);
            return first <= last;
        };
        if (!clip(-dx, a.x) || !clip(dx, image_.width - a.x) || !clip(-dy, a.y) ||
            !clip(dy, image_.height - a.y))
            return;
        const double length = std::max(std::fabs(dx), std::fabs(dy)) * (last - first);
        if (!(length < 1e6)) return;
        const int steps = static_cast<int>(length) + 1;
        for (int i = 0; i <= steps; ++i) {
            const double t = first + (last - first) * i / steps;
            put(static_cast<int>(std::floor(a.x + dx * t)), static_cast<int>(std::floor(a.y + dy * t)),
                color);
        }
    }

    void put(int x, int y, Color color) {
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
        float* pixel =
            image_.rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                                     static_cast<std::size_t>(x));
        pixel[0] = static_cast<float>(color.r);
        pixel[1] = static_cast<float>(color.g);
        pixel[2] = static_cast<float>(color.b);
    }

    Image& image_;
    const View& view_;
};

constexpr Color k_white{1, 1, 1}, k_mirror_color{0.3, 0.6, 1}, k_glass_color{0.2, 0.9, 0.4},
    k_lit{1, 0.9, 0.2}, k_blocked{1, 0.2, 0.1}, k_beyond{0.4, 0.1, 0.1};

// The drawn length of a ray that hits nothing: longer than the whole scene.
double far_away(const World& world, Vec3 from) {
    const Bounds box = scene_bounds(world);
    if (!(box.min.x <= box.max.x)) return 100;
    return 2 * (length(box.max - box.min) + length(from - box.min));
}

void draw_lights(Pen& pen, const ExplainedHit& hit, const Scene& scene, const World& world) {
    for (const LightTerms& terms : hit.lights) {
        if (!terms.may_add) continue;
        const Vec3 end = scene.lights[terms.light].has_position()
                             ? hit.point + terms.to_light
                             : hit.point + normalize(terms.to_light) * far_away(world, hit.point);
        if (!terms.blocked) {
            pen.draw(hit.point, end, k_lit);
        } else {
            const Vec3 blocked = terms.blocker ? terms.blocker->point : hit.point;
            pen.draw(blocked, end, k_beyond);
            pen.draw(hit.point, blocked, k_blocked);
        }
    }
}

// The error message, or an empty string.
std::string overlay_fault(const Image& picture, const Explanation& e, const Scene& scene,
                          const World& world) {
    const RenderSettings& settings = world.parts().settings;
    if (picture.width != settings.width || picture.height != settings.height ||
        picture.rgb.size() != std::size_t{3} * picture.width * picture.height)
        return fmt::format("the picture is not of the world's size, {}x{}", settings.width, settings.height);
    if (e.x < 0 || e.y < 0 || e.x >= picture.width || e.y >= picture.height)
        return fmt::format("pixel {},{} is not within the picture of {}x{}", e.x, e.y, picture.width,
                           picture.height);
    const std::string fault = world_fault(scene, world.parts());
    return fault.empty() ? explanation_fault(e, scene) : fault;
}

void draw_rays(Image& picture, const Explanation& explanation, const Scene& scene, const World& world) {
    const View view(world.parts());
    Pen pen(picture, view);
    for (const ExplainedRay& ray : explanation.rays) {
        if (ray.hit) draw_lights(pen, *ray.hit, scene, world);
    }
    for (const ExplainedRay& ray : explanation.rays) {
        if (ray.parent < 0) continue;
        const Vec3 end =
            ray.hit ? ray.hit->point : ray.origin + normalize(ray.direction) * far_away(world, ray.origin);
        if (ray.beyond_limit) continue;
        const Vec3 start = ray.straight ? ray.origin + ray.direction * ray.t_min : ray.origin;
        pen.draw(start, end, ray.transmitted ? k_glass_color : k_mirror_color);
    }
    pen.frame(explanation.x, explanation.y, k_white);
}

}  // namespace

Status render_overlay(Image& picture, const Explanation& explanation, const Scene& scene,
                      const World& world) {
    return result_of([&]() -> Status {
        std::string fault = overlay_fault(picture, explanation, scene, world);
        if (!fault.empty()) return invalid_argument(std::move(fault));
        draw_rays(picture, explanation, scene, world);
        return {};
    });
}

}  // namespace glint
