// SPDX-License-Identifier: Apache-2.0
// POV-Ray 3.7. Its coordinate system is left-handed, but a camera given by all its axes is used as given, so
// the coordinates need no change.
#include "scene_writer.h"

namespace spd {

namespace {

class PovWriter final : public SceneWriter {
  public:
    explicit PovWriter(std::FILE* file) : file_(file) {}

    // max_trace_level includes the camera rays, so this allows five generations.
    void begin(const View& view) override {
        const Vec3 forward = unit(view.at - view.from), right = unit(cross(forward, view.up));
        const double side = 2 * std::tan(view.angle * M_PI / 360);
        std::fputs(
            "#version 3.7;\nglobal_settings { assumed_gamma 1 ambient_light 0 max_trace_level 6 adc_bailout "
            "0.01 }\n",
            file_);
        std::fprintf(file_, "background { color rgb <%g,%g,%g> }\ncamera { perspective location ",
                     view.background.r, view.background.g, view.background.b);
        put(view.from);
        std::fputs(" direction ", file_);
        put(forward);
        std::fputs(" right (image_width / image_height) * ", file_);
        put(right * side);
        std::fputs(" up ", file_);
        put(cross(right, forward) * side);
        std::fputs(" }\n", file_);
        for (const Vec3& light : view.lights) {
            std::fputs("light_source { ", file_);
            put(light);
            std::fprintf(file_, " color rgb %.9g }\n",
                         1 / std::sqrt(static_cast<double>(view.lights.size())));
        }
    }

    // All shapes of one glass are one union with one interior. POV-Ray applies the factor 1 - T to the color
    // itself.
    void surface(const Surface& s) override {
        end();
        const double t = s.transmission;
        std::fprintf(file_,
                     "#declare S = texture { pigment { color rgb <%g,%g,%g> transmit %g } finish { ambient 0 "
                     "diffuse %g",
                     s.color.r, s.color.g, s.color.b, t, t < 1 ? s.kd / (1 - t) : s.kd);
        if (s.ks > 0) std::fprintf(file_, " phong %g phong_size %g reflection { %g }", s.ks, s.shine, s.ks);
        std::fputs(" } }\n", file_);
        if (t > 0) std::fputs("union {\n", file_);
        ior_ = t > 0 ? (s.ior > 0 ? s.ior : 1) : 0;
    }

    void sphere(Vec3 center, double radius) override {
        close_mesh();
        std::fputs("sphere { ", file_);
        put(center);
        std::fprintf(file_, ",%g ", radius);
        finish();
    }

    void cone(Vec3 base, double base_radius, Vec3 apex, double apex_radius) override {
        close_mesh();
        const bool cylinder = base_radius == apex_radius;
        std::fputs(cylinder ? "cylinder { " : "cone { ", file_);
        put(base);
        if (!cylinder) std::fprintf(file_, ",%g", base_radius);
        std::fputc(',', file_);
        put(apex);
        std::fprintf(file_, ",%g open ", apex_radius);
        finish();
    }

    // Triangles and rectangles are written as meshes, which POV-Ray traces fastest.
    void polygon(std::span<const Vec3> vertices) override {
        if (vertices.size() <= 4) {
            for (std::size_t i = 2; i < vertices.size(); ++i)
                triangle(vertices[0], vertices[i - 1], vertices[i]);
            return;
        }
        close_mesh();
        std::fprintf(file_, "polygon { %zu", vertices.size() + 1);
        for (const Vec3& v : vertices) {
            std::fputc(',', file_);
            put(v);
        }
        std::fputc(',', file_);
        put(vertices[0]);
        std::fputc(' ', file_);
        finish();
    }

    void patch(const Vec3 (&vertices)[3], const Vec3 (&normals)[3]) override {
        open_mesh();
        std::fputs("smooth_triangle { ", file_);
        for (int i = 0; i < 3; ++i) {
            if (i > 0) std::fputc(',', file_);
            put(vertices[i]);
            std::fputc(',', file_);
            put(normals[i]);
        }
        std::fputs(" }\n", file_);
    }

    void end() override {
        close_mesh();
        if (ior_ > 0) std::fprintf(file_, "texture { S } interior { ior %g } }\n", ior_);
        ior_ = 0;
    }

  private:
    void put(Vec3 v) { std::fprintf(file_, "<%.9g,%.9g,%.9g>", v.x, v.y, v.z); }

    void triangle(Vec3 a, Vec3 b, Vec3 c) {
        open_mesh();
        std::fputs("triangle { ", file_);
        put(a);
        std::fputc(',', file_);
        put(b);
        std::fputc(',', file_);
        put(c);
        std::fputs(" }\n", file_);
    }

    void open_mesh() {
        if (!in_mesh_) std::fputs("mesh {\n", file_);
        in_mesh_ = true;
    }

    void close_mesh() {
        if (in_mesh_) finish();
        in_mesh_ = false;
    }

    void finish() { std::fputs(ior_ > 0 ? "}\n" : "texture { S } }\n", file_); }

    std::FILE* file_;
    double ior_ = 0;  // of the open union's glass
    bool in_mesh_ = false;
};

}  // namespace

std::unique_ptr<SceneWriter> make_pov_writer(std::FILE* file) { return std::make_unique<PovWriter>(file); }

}  // namespace spd
