// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reads one text in Tachyon's format. The members are in tachyon.cpp (objects), tachyon_shapes.cpp,
// tachyon_triangles.cpp, tachyon_textures.cpp and tachyon_settings.cpp (camera, lights, background and
// modes).
#include <set>
#include <span>
#include <string>
#include <vector>

#include "formats/tachyon.h"
#include "formats/tachyon_scanner.h"
#include "scene/ranges.h"

namespace glint {

/// Of points, vertices or facets.
inline constexpr Range k_tachyon_count{0, 4e9, false, false, "a whole number from 0 to 4e9"};

/// The largest of the numbers over the smallest.
double tachyon_spread(const double (&numbers)[3]);

class TachyonReader {
  public:
    TachyonReader(LoadState& reading, const ReadText& text);
    void read();

  private:
    // Each reader of an object returns false after an error within it: what follows, up to the next word that
    // begins an object, is then skipped. An object that glint does not render is no such error.
    using ReadObject = bool (TachyonReader::*)();
    struct Object {
        std::string_view upper, name;
        ReadObject read;
    };
    static std::span<const Object> objects();

    void read_header();
    void read_object();
    void skip_object();
    bool read_include();
    bool read_image();
    bool read_landscape();
    bool read_volume();
    bool read_polygon_file();
    bool skip_name(std::string_view what);
    bool begin_clipping();
    bool end_clipping();

    // tachyon_triangles.cpp
    bool read_triangle();
    bool read_smooth_triangle();
    bool read_colored_triangle();
    bool read_vertices();
    bool read_facets(bool is_strip);
    bool add_facets();
    void add_smooth(const SmoothTriangle& triangle, std::uint32_t material);
    void note_normals(const Vec3 (&normals)[3]);
    void gather(const SmoothTriangle& triangle, const Color (&colors)[3], std::uint32_t material);

    // tachyon_shapes.cpp
    bool read_sphere();
    bool read_finite_cylinder();
    bool read_cylinder();
    bool read_polycylinder();
    bool read_ring();
    bool read_plane();
    bool read_box();
    template <class T> void add(const T& shape, std::uint32_t material) {
        note(scene_.shape_texts, scene_.shapes.size(), source_place(text_, object_));
        scene_.add(shape, material);
        if (scene_.shapes.size() % 4096 == 0) reading_.memory.count(scene_);
    }

    // tachyon_textures.cpp
    bool texture(std::uint32_t& material);
    bool skip_texture();
    bool texture_body(TachyonTexture& texture, bool has_vertex_colors);
    bool texture_function(TachyonTexture& texture, const Token& word, double function);
    std::uint32_t material_of(const TachyonTexture& texture, const Token& place);
    std::uint32_t add_material(const TachyonTexture& texture, const Token& place);
    bool read_definition();
    bool read_alias();
    bool keep_texture(const Token& at, std::string_view word);

    // tachyon_settings.cpp
    bool read_camera();
    bool read_shader_mode();
    void set_shader(const Token& at);
    bool read_mode();
    bool read_occlusion();
    void set_occlusion(const Color& light, double samples);
    bool read_light();
    bool read_directional_light();
    bool read_spot_light();
    bool read_light_color(Light& light);
    void add_light(Light light, double radius);
    bool read_sky_light();
    bool read_background();
    bool read_gradient();
    bool read_fog();
    void set(std::string_view key, std::string_view value, const Token& place);

    // Words of the text.
    bool expect(std::string_view upper, std::string_view name);
    bool expected(std::string_view what);
    bool number(double& value, const Range& range = k_coordinate);
    bool whole_number(double& value, const Range& range);
    bool point(Vec3& value);
    bool direction(Vec3& value);
    bool color(Color& value);
    /// A field: its keyword, and its value.
    bool number(std::string_view upper, std::string_view name, double& value, const Range& range) {
        return expect(upper, name) && number(value, range);
    }
    bool point(std::string_view upper, std::string_view name, Vec3& value) {
        return expect(upper, name) && point(value);
    }
    bool color(std::string_view upper, std::string_view name, Color& value) {
        return expect(upper, name) && color(value);
    }
    bool is_binary(const Token& at);
    bool go_on();
    bool error(const Token& at, std::string message);
    void warn(const Token& at, std::string message);
    void note_limit(TachyonLimit which, const Token& at);
    void leave_out(std::string_view what);
    void draw_without(const Token& at, std::string_view what, std::string_view pronoun = "it");

    LoadState& reading_;
    Scene& scene_;
    TachyonState& state_;
    const ReadText& text_;
    TachyonScanner scanner_;
    const bool is_further_;              // included, or after another text: needs no header
    Token object_;                       // the first word of the object
    Token function_;                     // the number after the last `TexFunc` that is drawn
    bool is_left_out_ = false;           // the object
    TachyonScanner::Passage last_body_;  // of the last texture, and its material
    std::uint32_t last_material_ = k_none;
    std::set<std::string, std::less<>, Counted<std::string>> refused_;  // textures that were reported
    CountedVector<Vec3> coordinates_, normals_;                         // of the last vertex array
    CountedVector<Color> colors_;
    CountedVector<TriangleCorners> facets_;        // of the vertex array, that have not been added
    CountedVector<std::uint32_t> vertex_numbers_;  // in add_facets(): in the mesh; else unset
    TachyonTexture vertex_texture_;
    std::shared_ptr<MeshData> gathered_;  // of triangles with vertex colors
    std::uint32_t gathered_material_ = k_none;
};

}  // namespace glint
