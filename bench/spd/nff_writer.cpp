// SPDX-License-Identifier: Apache-2.0
#include "scene_writer.h"

namespace spd {

namespace {

class NffWriter final : public SceneWriter {
  public:
    explicit NffWriter(std::FILE* file) : file_(file) {}

    void begin(const View& view) override {
        const auto line = [this](const char* word, Vec3 v) {
            std::fprintf(file_, "%s %g %g %g\n", word, v.x, v.y, v.z);
        };
        line("b", {view.background.r, view.background.g, view.background.b});
        std::fputs("v\n", file_);
        line("from", view.from);
        line("at", view.at);
        line("up", view.up);
        std::fprintf(file_, "angle %g\nhither %g\nresolution 512 512\n", view.angle, view.hither);
        for (const Vec3& light : view.lights) line("l", light);
    }

    void surface(const Surface& s) override {
        std::fprintf(file_, "f %g %g %g %g %g %g %g %g\n", s.color.r, s.color.g, s.color.b, s.kd, s.ks,
                     s.shine, s.transmission, s.ior);
    }

    void sphere(Vec3 center, double radius) override {
        std::fprintf(file_, "s %g %g %g %g\n", center.x, center.y, center.z, radius);
    }

    void cone(Vec3 base, double base_radius, Vec3 apex, double apex_radius) override {
        std::fprintf(file_, "c\n%g %g %g %g\n%g %g %g %g\n", base.x, base.y, base.z, base_radius, apex.x,
                     apex.y, apex.z, apex_radius);
    }

    void polygon(std::span<const Vec3> vertices) override {
        std::fprintf(file_, "p %zu\n", vertices.size());
        for (const Vec3& v : vertices) std::fprintf(file_, "%g %g %g\n", v.x, v.y, v.z);
    }

    void patch(const Vec3 (&vertices)[3], const Vec3 (&normals)[3]) override {
        std::fputs("pp 3\n", file_);
        for (int i = 0; i < 3; ++i)
            std::fprintf(file_, "%g %g %g %g %g %g\n", vertices[i].x, vertices[i].y, vertices[i].z,
                         normals[i].x, normals[i].y, normals[i].z);
    }

  private:
    std::FILE* file_;
};

}  // namespace

std::unique_ptr<SceneWriter> make_nff_writer(std::FILE* file) { return std::make_unique<NffWriter>(file); }

}  // namespace spd
