// SPDX-License-Identifier: Apache-2.0
// Tachyon 0.99's scene format. Its camera is left-handed, so its picture is mirrored; the rendering time is
// the same.
#include <map>
#include <tuple>

#include "scene_writer.h"
#include "world/geometry/triangulate.h"

namespace spd {

namespace {

class TachyonWriter final : public SceneWriter {
  public:
    explicit TachyonWriter(std::FILE* file) : file_(file) {}

    void begin(const View& view) override {
        std::fprintf(file_,
                     "BEGIN_SCENE\nRESOLUTION 512 512\nCAMERA\nZOOM %.9g\nASPECTRATIO 1.0\nANTIALIASING 0\n"
                     "RAYDEPTH 6\n",
                     1 / (2 * std::tan(view.angle * M_PI / 360)));
        const Vec3 forward = unit(view.at - view.from), right = unit(cross(forward, view.up));
        line("CENTER", view.from);
        line("VIEWDIR", forward);
        line("UPDIR", cross(right, forward));
        std::fputs("END_CAMERA\n", file_);
        std::fprintf(file_, "BACKGROUND %g %g %g\n", view.background.r, view.background.g, view.background.b);
        const double intensity = 1 / std::sqrt(static_cast<double>(view.lights.size()));
        for (const Vec3& light : view.lights) {
            std::fputs("LIGHT ", file_);
            line("CENTER", light);
            std::fprintf(file_, "RAD 0.0001 COLOR %.9g %.9g %.9g\n", intensity, intensity, intensity);
        }
    }

    // Each surface is defined once, with a number.
    void surface(const Surface& s) override {
        const auto key = std::tuple(s.color.r, s.color.g, s.color.b, s.kd, s.ks, s.shine, s.transmission);
        const auto [place, added] = numbers_.try_emplace(key, static_cast<int>(numbers_.size()));
        number_ = place->second;
        if (!added) return;
        std::fprintf(file_, "TEXDEF T%d AMBIENT 0 DIFFUSE %g SPECULAR %g OPACITY %g ", number_, s.kd, s.ks,
                     1 - s.transmission);
        if (s.ks > 0) std::fprintf(file_, "PHONG PLASTIC %g PHONG_SIZE %g ", s.ks, s.shine);
        std::fprintf(file_, "COLOR %g %g %g TEXFUNC 0\n", s.color.r, s.color.g, s.color.b);
    }

    void sphere(Vec3 center, double radius) override {
        std::fputs("SPHERE ", file_);
        line("CENTER", center);
        std::fprintf(file_, "RAD %.9g T%d\n", radius, number_);
    }

    void cone(Vec3 base, double base_radius, Vec3 apex, double apex_radius) override {
        std::fputs("FCYLINDER ", file_);
        line("BASE", base);
        line("APEX", apex);
        std::fprintf(file_, "RAD %.9g T%d\n", (base_radius + apex_radius) / 2, number_);
    }

    void polygon(std::span<const Vec3> vertices) override {
        triangles_.clear();
        glint::triangulate(vertices, triangles_);
        for (const glint::Triangle& triangle : triangles_) {
            std::fputs("TRI ", file_);
            for (int i = 0; i < 3; ++i) line(k_vertices[i], triangle.vertices[i]);
            std::fprintf(file_, "T%d\n", number_);
        }
    }

    void patch(const Vec3 (&vertices)[3], const Vec3 (&normals)[3]) override {
        std::fputs("STRI ", file_);
        for (int i = 0; i < 3; ++i) line(k_vertices[i], vertices[i]);
        for (int i = 0; i < 3; ++i) line(k_normals[i], normals[i]);
        std::fprintf(file_, "T%d\n", number_);
    }

    void end() override { std::fputs("END_SCENE\n", file_); }

  private:
    static constexpr const char *k_vertices[] = {"V0", "V1", "V2"}, *k_normals[] = {"N0", "N1", "N2"};

    void line(const char* word, Vec3 v) { std::fprintf(file_, "%s %.9g %.9g %.9g\n", word, v.x, v.y, v.z); }

    std::FILE* file_;
    std::map<std::tuple<double, double, double, double, double, double, double>, int> numbers_;
    int number_ = 0;
    std::vector<glint::Triangle> triangles_;
};

}  // namespace

std::unique_ptr<SceneWriter> make_tachyon_writer(std::FILE* file) {
    return std::make_unique<TachyonWriter>(file);
}

}  // namespace spd
