// SPDX-License-Identifier: Apache-2.0
#include "databases.h"

namespace spd {

namespace {

constexpr Database k_databases[] = {
    {"balls", 4, 8, write_balls},        {"tetra", 6, 12, write_tetra},     {"gears", 4, 30, write_gears},
    {"mount", 6, 12, write_mount},       {"rings", 7, 60, write_rings},     {"tree", 11, 22, write_tree},
    {"lattice", 12, 150, write_lattice}, {"teapot", 12, 400, write_teapot},
};

}  // namespace

std::span<const Database> databases() { return k_databases; }

double shine_of_angle(double degrees) { return std::log(0.5) / std::log(std::cos(degrees * M_PI / 180)); }

// Rodrigues' formula.
Vec3 rotate(Vec3 p, Vec3 axis, double sine, double cosine) {
    return p * cosine + cross(axis, p) * sine + axis * (dot(axis, p) * (1 - cosine));
}

Vec3 rotate(Vec3 p, Vec3 axis, double radians) {
    return rotate(p, axis, std::sin(radians), std::cos(radians));
}

}  // namespace spd
