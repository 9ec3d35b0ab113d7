// SPDX-License-Identifier: Apache-2.0 OR MIT-0
// One diffuse sphere, lit by one point light (diffuse_sphere.glint), with the calls that write a log for `glint diagnose`.
//     cc -o diffuse_sphere diffuse_sphere.c -lm && GLINT_PIXELS="40,18;2,2" ./diffuse_sphere > diffuse_sphere.ppm
#include <math.h>
#include <stdio.h>

#include "glint_log.h"

typedef struct { double x, y, z; } Vec;

static Vec sub(Vec a, Vec b) { return (Vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static Vec scaled(Vec a, double f) { return (Vec){a.x * f, a.y * f, a.z * f}; }
static Vec add(Vec a, Vec b) { return (Vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Vec unit(Vec a) { return scaled(a, 1 / sqrt(dot(a, a))); }

enum { k_width = 64, k_height = 48 };
static const Vec k_eye = {0, 0, 4}, k_center = {0, 0, 0}, k_light = {3, 4, 5};
static const Vec k_light_color = {1, 0.9, 0.8}, k_diffuse = {0.9, 0.5, 0.2};
static const double k_radius = 1, k_fov_degrees = 50, k_pi = 3.14159265358979323846;

// The distance of the nearest hit, or -1.
static double hit_sphere(Vec origin, Vec direction) {
    const Vec from_center = sub(origin, k_center);
    const double b = dot(from_center, direction), c = dot(from_center, from_center) - k_radius * k_radius;
    const double root = b * b - c;
    return root < 0 ? -1 : -b - sqrt(root);
}

static Vec trace(Vec origin, Vec direction) {
    Vec color = {0, 0, 0};
    glint_ray("camera");
    glint_vector("origin", origin.x, origin.y, origin.z);
    glint_vector("direction", direction.x, direction.y, direction.z);
    const double t = hit_sphere(origin, direction);
    if (t > 0) {
        const Vec p = add(origin, scaled(direction, t)), n = unit(sub(p, k_center)), l = unit(sub(k_light, p));
        const double n_l = dot(n, l), cosine = n_l > 0 ? n_l : 0;
        color = (Vec){k_diffuse.x * k_light_color.x * cosine, k_diffuse.y * k_light_color.y * cosine,
                      k_diffuse.z * k_light_color.z * cosine};
        glint_number("shape", 1);
        glint_number("t", t);
        glint_vector("P", p.x, p.y, p.z);
        glint_vector("N", n.x, n.y, n.z);
        glint_light(1);
        glint_vector("L", l.x, l.y, l.z);
        glint_number("N.L", n_l);
        glint_color("diffuse", color.x, color.y, color.z);
    } else {
        glint_word("miss");
    }
    glint_color("color", color.x, color.y, color.z);
    glint_end();
    return color;
}

static int to_byte(double v) { return (int)rint(255 * (v < 0 ? 0 : v > 1 ? 1 : v)); }

int main(void) {
    const double width = 2 * tan(k_fov_degrees / 2 * k_pi / 180);  // of the picture, at the distance 1
    printf("P6\n%d %d\n255\n", k_width, k_height);
    for (int y = 0; y < k_height; ++y) {
        for (int x = 0; x < k_width; ++x) {
            glint_pixel(x, y);
            const Vec to_pixel = {((x + 0.5) / k_width - 0.5) * width,
                                  (0.5 - (y + 0.5) / k_height) * width * k_height / k_width, -1};
            const Vec color = trace(k_eye, unit(to_pixel));
            const int r = to_byte(color.x), g = to_byte(color.y), b = to_byte(color.z);
            glint_vector("bytes", r, g, b);
            glint_pixel_end();
            putchar(r);
            putchar(g);
            putchar(b);
        }
    }
    return 0;
}
