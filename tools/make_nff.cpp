// SPDX-License-Identifier: Apache-2.0
// Writes scenes as .nff, of any size: make_nff sphereflake [DEPTH] | pyramid [DEPTH] | fullerene
//
// sphereflake: every sphere has nine of a third its size: 1 + 9 + ... + 9^DEPTH (3: 820; 6: 597,871).
// pyramid: a tetrahedron subdivided recursively, 4^DEPTH in all. fullerene: 60 spheres, 90
// cylinders.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace {

struct Point {
    double x, y, z;
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator*(Point a, double s) { return {a.x * s, a.y * s, a.z * s}; }
Point cross(Point a, Point b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point unit(Point a) { return a * (1 / std::sqrt(dot(a, a))); }

void view(Point from, Point at, double angle) {
    std::printf("v\nfrom %g %g %g\nat %g %g %g\nup 0 0 1\nangle %g\nhither 0.01\nresolution 512 512\n",
                from.x, from.y, from.z, at.x, at.y, at.z, angle);
}

void floor_at(double z, double half) {
    std::printf("p 4\n%g %g %g\n%g %g %g\n%g %g %g\n%g %g %g\n", half, half, z, -half, half, z, -half, -half,
                z, half, -half, z);
}

// Rounded to a number of decimals; never -0.
double rounded(double a, int decimals) {
    const double scale = std::pow(10.0, decimals);
    return std::round(a * scale) / scale + 0.0;
}

// The nine children of a sphere whose `up` points away from its parent: six around it, three above. The web
// page carries the flake of depth 3, so its text is short: centers to thousandths, radii to ten thousandths.
void flake(Point center, double radius, Point up, int depth, int decimals) {
    std::printf("s %.6g %.6g %.6g %.6g\n", rounded(center.x, decimals), rounded(center.y, decimals),
                rounded(center.z, decimals), rounded(radius, decimals + 1));
    if (depth == 0) return;
    const Point other = std::abs(up.z) < 0.9 ? Point{0, 0, 1} : Point{1, 0, 0};
    const Point right = unit(cross(other, up)), forward = cross(up, right);
    const double h = std::sqrt(0.75), low = std::sqrt(0.5);
    const Point directions[9] = {{1, 0, 0},
                                 {0.5, h, 0},
                                 {-0.5, h, 0},
                                 {-1, 0, 0},
                                 {-0.5, -h, 0},
                                 {0.5, -h, 0},
                                 {0, low, low},
                                 {-h * low, -0.5 * low, low},
                                 {h * low, -0.5 * low, low}};
    for (const Point& d : directions) {
        const Point out = right * d.x + forward * d.y + up * d.z;
        flake(center + out * (radius * 4 / 3), radius / 3, out, depth - 1, decimals);
    }
}

void sphereflake(int depth) {
    std::puts("# A sphereflake over a floor, under three lights.\nb 0.35 0.5 0.75");
    view({2.2, -2.6, 1.5}, {0, 0, 0}, 30);
    std::puts(
        "l 4 -3 5 0.9 0.85 0.75\nl -3 -4 3 0.2 0.3 0.5\nl 1 5 6 0.5 0.4 0.25\nf 0.55 0.6 0.5 0.8 0.1 20 0 1");
    floor_at(-0.7, 40);
    std::puts("f 1 0.7 0.3 0.7 0.45 30 0 1");
    flake({0, 0, 0}, 0.5, {0, 0, 1}, depth, depth > 3 ? 9 : 3);
}

void corner(Point a, Point b, Point c, Point d, int depth) {
    if (depth > 0) {
        const Point ab = (a + b) * 0.5, ac = (a + c) * 0.5, ad = (a + d) * 0.5, bc = (b + c) * 0.5,
                    bd = (b + d) * 0.5, cd = (c + d) * 0.5;
        corner(a, ab, ac, ad, depth - 1);
        corner(ab, b, bc, bd, depth - 1);
        corner(ac, bc, c, cd, depth - 1);
        corner(ad, bd, cd, d, depth - 1);
        return;
    }
    const Point faces[4][3] = {{a, b, d}, {b, c, d}, {c, a, d}, {a, c, b}};
    for (const auto& face : faces) {
        std::puts("p 3");
        for (const Point& p : face) std::printf("%.6g %.6g %.6g\n", p.x, p.y, p.z);
    }
}

void pyramid(int depth) {
    std::puts("# A pyramid of tetrahedra on a mirror.\nb 0.12 0.16 0.25");
    view({2.9, -1.4, 1.3}, {0, 0, 0.5}, 36);
    std::puts("l 3 -5 6 0.9 0.9 0.8\nl 6 3 3 0.5 0.25 0.2\nf 0.3 0.35 0.45 0.5 0.35 60 0 1");
    floor_at(-0.001, 60);
    std::puts("f 0.95 0.6 0.2 0.9 0.1 12 0 1");
    const double h = std::sqrt(0.75);
    corner({1, 0, 0}, {-0.5, h, 0}, {-0.5, -h, 0}, {0, 0, std::sqrt(2.0)}, depth);
}

// The even permutations of three kinds of points with all signs; neighbours have the distance 2.
void fullerene() {
    std::puts("# Buckminsterfullerene: 60 atoms of carbon, 90 bonds.\nb 0.9 0.92 0.95");
    view({8, -13, 6}, {0, 0, 0}, 40);
    std::puts("l 10 -20 15\nl -20 -10 5\nl 0 -5 20");
    const double phi = (1 + std::sqrt(5.0)) / 2;
    const Point kinds[] = {{0, 1, 3 * phi}, {1, 2 + phi, 2 * phi}, {phi, 2, 2 * phi + 1}};
    std::vector<Point> atoms;
    for (const Point& k : kinds) {
        for (int signs = 0; signs < 8; ++signs) {
            if (k.x == 0 && (signs & 1)) continue;
            const Point p{signs & 1 ? -k.x : k.x, signs & 2 ? -k.y : k.y, signs & 4 ? -k.z : k.z};
            for (const Point& q : {p, Point{p.y, p.z, p.x}, Point{p.z, p.x, p.y}}) atoms.push_back(q);
        }
    }
    std::puts("f 0.16 0.17 0.2 0.9 0.12 40 0 1");
    for (const Point& a : atoms) std::printf("s %.6g %.6g %.6g 0.6\n", a.x, a.y, a.z);
    std::puts("f 0.85 0.3 0.2 0.8 0.1 20 0 1");
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        for (std::size_t j = i + 1; j < atoms.size(); ++j) {
            const Point d = atoms[j] + atoms[i] * -1, &a = atoms[i], &b = atoms[j];
            if (dot(d, d) > 4.01) continue;
            std::printf("c\n%.6g %.6g %.6g 0.2\n%.6g %.6g %.6g 0.2\n", a.x, a.y, a.z, b.x, b.y, b.z);
        }
    }
}

}  // namespace

int main(int count, char** arguments) {
    const std::string_view what = count > 1 ? arguments[1] : "";
    const int depth = count > 2 ? std::atoi(arguments[2]) : 3;
    if (depth >= 0 && depth <= 9 && what == "sphereflake") {
        sphereflake(depth);
    } else if (depth >= 0 && depth <= 12 && what == "pyramid") {
        pyramid(depth);
    } else if (what == "fullerene") {
        fullerene();
    } else {
        std::fputs("usage: make_nff sphereflake [DEPTH 0 to 9] | pyramid [DEPTH 0 to 12] | fullerene\n",
                   stderr);
        return 2;
    }
    return 0;
}
