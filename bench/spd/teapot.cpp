// SPDX-License-Identifier: Apache-2.0
// Newell's teapot: 32 Bezier patches of size^2 * 2 smooth triangles each, on a checkerboard of size^2
// squares. The control points are the published ones, stored by their symmetries: 20 patches are
// quarters of surfaces of revolution, 8 are halves of the handle and the spout, which are symmetric.
#include "databases.h"

namespace spd {

namespace {

struct Patch {
    Vec3 points[4][4];
};

struct Profile {
    double radius[4], z[4];
    double fullness = 0.56;  // relative to a quarter circle's control points
};

constexpr Profile k_upper[] = {
    {{1.4, 1.3375, 1.4375, 1.5}, {2.4, 2.53125, 2.53125, 2.4}},  // rim
    {{1.5, 1.75, 2, 2}, {2.4, 1.875, 1.35, 0.9}},                // body
    {{2, 2, 1.5, 1.5}, {0.9, 0.45, 0.225, 0.15}},
    {{0, 0.8, 0, 0.2}, {3.15, 3.15, 2.85, 2.7}, 0.5625},  // lid
    {{0.2, 0.4, 1.3, 1.3}, {2.7, 2.55, 2.55, 2.4}},
};
constexpr Profile k_bottom = {{0, 1.425, 1.5, 1.5}, {0, 0, 0.075, 0.15}};

// Two curves in the plane y = 0, and how far the surface between them bulges to both sides.
struct Tube {
    double x[2][4], z[2][4], bulge[4];
};

constexpr Tube k_tubes[] = {
    {{{-1.6, -2.3, -2.7, -2.7}, {-1.5, -2.5, -3, -3}},  // handle
     {{2.025, 2.025, 2.025, 1.8}, {2.25, 2.25, 2.25, 1.8}},
     {0.3, 0.3, 0.3, 0.3}},
    {{{-2.7, -2.7, -2.5, -2}, {-3, -3, -2.65, -1.9}},
     {{1.8, 1.575, 1.125, 0.9}, {1.8, 1.35, 0.9375, 0.6}},
     {0.3, 0.3, 0.3, 0.3}},
    {{{1.7, 2.6, 2.3, 2.7}, {1.7, 3.1, 2.4, 3.3}},  // spout
     {{1.425, 1.425, 2.1, 2.4}, {0.6, 0.825, 2.025, 2.4}},
     {0.66, 0.66, 0.25, 0.25}},
    {{{2.7, 2.8, 2.9, 2.8}, {3.3, 3.525, 3.45, 3.2}},
     {{2.4, 2.475, 2.475, 2.4}, {2.4, 2.49375, 2.5125, 2.4}},
     {0.25, 0.25, 0.15, 0.15}},
};

// `turn` is 1 or -1: the direction of the quarters, chosen so that all normals point outward.
void add_quarters(const Profile& profile, double turn, std::vector<Patch>& out) {
    for (int quarter = 0; quarter < 4; ++quarter) {
        Patch patch;
        for (int i = 0; i < 4; ++i) {
            const double r = profile.radius[i], f = r * profile.fullness;
            const Vec3 row[4] = {{r, 0, 0}, {r, turn * f, 0}, {f, turn * r, 0}, {0, turn * r, 0}};
            for (int j = 0; j < 4; ++j) {
                Vec3 p = row[j];
                for (int q = 0; q < quarter; ++q) p = {-turn * p.y, turn * p.x, 0};
                patch.points[i][j] = {p.x, p.y, profile.z[i]};
            }
        }
        out.push_back(patch);
    }
}

void add_halves(const Tube& tube, std::vector<Patch>& out) {
    for (int half = 0; half < 2; ++half) {
        Patch patch;
        for (int i = 0; i < 4; ++i) {
            const double y = half == 0 ? -tube.bulge[i] : tube.bulge[i];
            const int a = half, b = 1 - half;
            patch.points[i][0] = {tube.x[a][i], 0, tube.z[a][i]};
            patch.points[i][1] = {tube.x[a][i], y, tube.z[a][i]};
            patch.points[i][2] = {tube.x[b][i], y, tube.z[b][i]};
            patch.points[i][3] = {tube.x[b][i], 0, tube.z[b][i]};
        }
        out.push_back(patch);
    }
}

std::vector<Patch> patches() {
    std::vector<Patch> out;
    for (const Profile& profile : k_upper) add_quarters(profile, -1, out);
    for (const Tube& tube : k_tubes) add_halves(tube, out);
    add_quarters(k_bottom, 1, out);
    return out;
}

struct Point {
    Vec3 place, normal;
};

// Bernstein's polynomials of degree 3 and their derivatives.
struct Basis {
    double value[4], slope[4];
    explicit Basis(double t)
        : value{(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t), t * t * t},
          slope{-3 * (1 - t) * (1 - t), 3 * (1 - t) * (1 - 3 * t), 3 * t * (2 - 3 * t), 3 * t * t} {}
};

bool on_axis(Vec3 p) { return std::abs(p.x) < 0.0001 && std::abs(p.y) < 0.0001; }

Point evaluate(const Patch& patch, double s, double t) {
    const Basis u(s), v(t);
    Vec3 place, along_s, along_t;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            place = place + patch.points[i][j] * (u.value[i] * v.value[j]);
            along_s = along_s + patch.points[i][j] * (u.slope[i] * v.value[j]);
            along_t = along_t + patch.points[i][j] * (u.value[i] * v.slope[j]);
        }
    }
    if (on_axis(place)) return {place, {0, 0, place.z > 1.5 ? 1.0 : -1.0}};  // all of the patch's t meet here
    return {place, unit(cross(along_t, along_s))};
}

void write_patch(SceneWriter& out, const Patch& patch, int size) {
    for (int s = 0; s < size; ++s) {
        for (int t = 0; t < size; ++t) {
            constexpr int k_corners[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
            for (int triangle = 0; triangle < 2; ++triangle) {
                Vec3 vertices[3], normals[3];
                int axis = 0;
                for (int i = 0; i < 3; ++i) {
                    const auto& corner = k_corners[(i + triangle * 2) % 4];
                    const Point point = evaluate(patch, (s + corner[0]) / static_cast<double>(size),
                                                 (t + corner[1]) / static_cast<double>(size));
                    vertices[i] = point.place;
                    normals[i] = point.normal;
                    axis += on_axis(point.place);
                }
                if (axis < 2) out.patch(vertices, normals);
            }
        }
    }
}

void write_checkerboard(SceneWriter& out, int size) {
    for (const int odd : {1, 0}) {
        const double grey = odd ? 1 : 0.5;
        out.surface({.color = {grey, grey, grey}, .kd = 0.5, .ks = 0.5, .shine = shine_of_angle(30)});
        const auto at = [size](int i) { return 4 * (2.0 * i / size - 1); };
        for (int x = 0; x < size; ++x) {
            for (int y = 0; y < size; ++y) {
                if ((x + y) % 2 != odd) continue;
                const Vec3 square[] = {{at(x), at(y), 0},
                                       {at(x + 1), at(y), 0},
                                       {at(x + 1), at(y + 1), 0},
                                       {at(x), at(y + 1), 0}};
                out.polygon(square);
            }
        }
    }
}

}  // namespace

void write_teapot(SceneWriter& out, int size) {
    View view{.from = {4.86, 7.2, 5.4}, .at = {0, 0, 0}};
    view.lights = {{-3.1, 9.8, 12.1}, {11.3, 5.1, 8.8}};
    out.begin(view);
    write_checkerboard(out, size);
    out.surface({.color = {1, 0.5, 0.1}, .kd = 0.75, .ks = 0.25, .shine = shine_of_angle(37)});
    for (const Patch& patch : patches()) write_patch(out, patch, size);
}

}  // namespace spd
