// SPDX-License-Identifier: Apache-2.0
#include "frame_rays.h"

#include <algorithm>
#include <cmath>

namespace glint_floor {

using namespace glint;

namespace {

constexpr int k_tile = 32;
constexpr double k_min_weight = 0.01;

struct Ray {
    Vec3 origin, direction;
    double weight;
};

struct SurfaceHit {
    Hit hit;
    Vec3 incoming;
    double weight;
};

Vec3 unit(Vec3 v) { return v / std::sqrt(dot(v, v)); }

// The smallest distance from a surface that floats resolve.
double reach(Vec3 p) { return 3e-5 * (1 + std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})); }

Vec3 offset_ray_origin(const Hit& hit, Vec3 direction) {
    return hit.point + hit.normal * (dot(hit.normal, direction) < 0 ? -reach(hit.point) : reach(hit.point));
}

// Pixels in Z-order: a packet of 16 is a block of 4 x 4 pixels, a packet of 64 a block of 8 x 8.
int even_bits(int i) { return (i & 1) | (i >> 1 & 2) | (i >> 2 & 4) | (i >> 3 & 8) | (i >> 4 & 16); }

struct Tracer {
    const Scene& scene;
    const EmbreeScene& embree;
    FrameRays frame{};
    const Material none{};

    const Material& material(const Hit& hit) const {
        return hit.material == k_none ? none : scene.materials[hit.material];
    }

    void shadows(const std::vector<SurfaceHit>& hits, RayClass to) {
        for (const Light& light : scene.lights) {
            if (light.kind != LightKind::point) continue;
            for (const SurfaceHit& s : hits) {
                const Material& m = material(s.hit);
                const Vec3 to_light = light.position - s.hit.point;
                const double same_side = dot(s.hit.normal, to_light) * -dot(s.hit.normal, s.incoming);
                const bool dark = m.diffuse == Color{0, 0, 0} && m.specular == Color{0, 0, 0};
                if (!(same_side > 0) || dark) continue;
                const Vec3 way = offset_ray_origin(s.hit, to_light) - light.position;
                frame.lists[to].add(light.position, unit(way),
                                    static_cast<float>(0.99999 * std::sqrt(dot(way, way))));
            }
        }
    }

    // The mirror rays of the hits, then the rays through glass.
    std::vector<Ray> branches(const std::vector<SurfaceHit>& hits) const {
        std::vector<Ray> reflected, transmitted;
        for (const SurfaceHit& s : hits) {
            const Material& m = material(s.hit);
            const Vec3 d = s.incoming;
            const bool inside = dot(s.hit.normal, d) > 0;
            const Vec3 n = inside ? -s.hit.normal : s.hit.normal;
            double mirror = m.mirror;
            if (m.transmission > 0) {
                const double eta = inside ? m.ior : 1 / m.ior, cosine = -dot(n, d);
                const double square = 1 - eta * eta * (1 - cosine * cosine);
                const Vec3 through = (d + n * cosine) * eta - n * std::sqrt(std::max(square, 0.0));
                if (square < 0)
                    mirror += m.transmission;
                else if (s.weight * m.transmission >= k_min_weight)
                    transmitted.push_back(
                        {offset_ray_origin(s.hit, through), unit(through), s.weight * m.transmission});
            }
            if (mirror > 0 && s.weight * mirror >= k_min_weight) {
                const Vec3 back = d - n * (2 * dot(n, d));
                reflected.push_back({offset_ray_origin(s.hit, back), unit(back), s.weight * mirror});
            }
        }
        reflected.insert(reflected.end(), transmitted.begin(), transmitted.end());
        return reflected;
    }

    void trace(std::vector<Ray> rays, int generations) {
        for (int generation = 0; !rays.empty(); ++generation) {
            std::vector<SurfaceHit> hits;
            for (const Ray& ray : rays) {
                frame.lists[generation == 0 ? k_camera : k_mirror].add(ray.origin, ray.direction, INFINITY);
                SurfaceHit s;
                if (!embree.nearest(ray.origin, ray.direction, s.hit)) continue;
                s.incoming = ray.direction;
                s.weight = ray.weight;
                hits.push_back(s);
            }
            shadows(hits, generation == 0 ? k_first_shadow : k_later_shadow);
            if (generation == generations) break;
            rays = branches(hits);
        }
    }
};

}  // namespace

void RayList::add(Vec3 origin, Vec3 direction, float most) {
    ox.push_back(static_cast<float>(origin.x));
    oy.push_back(static_cast<float>(origin.y));
    oz.push_back(static_cast<float>(origin.z));
    dx.push_back(static_cast<float>(direction.x));
    dy.push_back(static_cast<float>(direction.y));
    dz.push_back(static_cast<float>(direction.z));
    t_max.push_back(most);
}

Vec3 camera_direction(const Camera& camera, int size, int x, int y) {
    const Vec3 forward = unit(camera.look_at - camera.position), right = unit(cross(forward, camera.up));
    const Vec3 up = cross(right, forward);
    const double side = 2 * std::tan(camera.fov_degrees * M_PI / 360);
    const double sx = (x + 0.5) / size - 0.5, sy = 0.5 - (y + 0.5) / size;
    return unit(forward + right * (side * sx) + up * (side * sy));
}

FrameRays frame_rays(const Scene& scene, const EmbreeScene& embree, int size, int generations) {
    Tracer tracer{scene, embree};
    for (int ty = 0; ty < size; ty += k_tile) {
        for (int tx = 0; tx < size; tx += k_tile) {
            std::vector<Ray> rays;
            for (int i = 0; i < k_tile * k_tile; ++i) {
                const int x = tx + even_bits(i), y = ty + even_bits(i >> 1);
                if (x >= size || y >= size) continue;
                rays.push_back({scene.camera.position, camera_direction(scene.camera, size, x, y), 1});
            }
            tracer.trace(std::move(rays), generations);
        }
    }
    return std::move(tracer.frame);
}

}  // namespace glint_floor
