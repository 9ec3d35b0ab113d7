// SPDX-License-Identifier: Apache-2.0
#pragma once
// Objects: shapes, groups, meshes and lights with their modifiers; and cameras. In objects.cpp, shapes.cpp,
// modifiers.cpp, meshes.cpp, mesh_lists.cpp, polygons.cpp, prisms.cpp, glyphs.cpp, sweeps.cpp,
// height_fields.cpp, lights.cpp and camera.cpp.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "formats/povray/curves.h"
#include "formats/povray/number_list.h"
#include "formats/povray/texture_parser.h"

namespace glint::povray {

struct Outline;     // polygons.cpp
struct TextMeshes;  // glyphs.cpp

/// What a `height_field` has before its modifiers.
struct FieldItems {
    Token name_at;
    std::string name;
    double water_level = 0;
    bool is_smooth = false;
};

class ObjectParser : public TextureParser {
  protected:
    using TextureParser::TextureParser;

    bool begins_object(const Token& token);
    bool begins_declared(const Token& word);
    Object read_object();
    ObjectPart read_part();
    CameraItems read_camera(const Token& word);
    /// What #default gives.
    std::optional<CameraItems>& default_camera() { return default_camera_; }

  private:
    Value other_value(const Token& first) override;

    // objects.cpp
    Object read_copy();
    ObjectPart object_of(const Token& name);
    Object refuse_object(const Token& word);
    Object read_group(const Token& word);
    void check_operands(Object& solid);

    // shapes.cpp
    Object read_shape(const Token& word);
    void read_quartic(Object& object);
    void check_shape(Object& object);

    // modifiers.cpp
    void read_modifiers(Object& object);
    bool read_modifier(Object& object);
    void read_clip(Object& object);
    void read_bounds(Object& object);

    // meshes.cpp
    Object read_mesh(const Token& word);
    Object read_mesh2(const Token& word);
    void read_mesh_triangle(ReadMesh& mesh);
    void check_mesh(const Token& at, ReadMesh& mesh, bool has_normal_indices);
    void read_texture_list(ReadMesh& mesh);

    // mesh_lists.cpp
    bool open_list();
    void close_list();
    void list_error(std::string_view wanted);
    double list_number();
    Vec3 list_vector();
    std::size_t read_count();
    std::size_t room_for(std::size_t count) const;
    CountedVector<Float3> read_points(Float3 (*convert)(Vec3), ReadMesh* noting = nullptr);
    std::uint32_t index_of(double value, const Token& at);
    void read_face_indices(TriangleCorners& indices);
    void read_faces(ReadMesh& mesh);
    void read_corner_indices(CountedVector<TriangleCorners>& corners, std::size_t faces);
    Vec3 uv_vector();
    CountedVector<Float3> read_uv();

    // polygons.cpp
    Object read_polygon(const Token& word);
    void take_outlines(const CountedVector<Vec3>& points, Object& object);
    bool fill_outlines(const std::vector<Outline>& outlines, Vec3 normal, Vec3 first, Object& object);

    // prisms.cpp
    Object read_prism(const Token& word);
    bool read_spline(Object& object, Spline& spline, unsigned allowed);
    void read_flat_points(std::size_t least, Spline spline, FlatLoop& points);

    // glyphs.cpp, in builds with fonts
    Object read_text(const Token& word);
    std::string_view font_bytes(Object& text, const Token& at, const std::string& name);
    void refuse_font(Object& text, const Token& at, const std::string& name, std::string_view why);

    // sweeps.cpp
    Object read_lathe(const Token& word);
    Object read_sphere_sweep(const Token& word);

    // height_fields.cpp
    Object read_height_field(const Token& word);
    bool read_field_items(Object& object, FieldItems& items);

    // lights.cpp
    Object read_light(const Token& word);
    void read_looks_like(Object& light);
    std::int32_t sample_count();

    std::optional<CameraItems> default_camera_;
    std::shared_ptr<TextMeshes> text_meshes_;
    NumberList list_;  // what is left of the list that is being read; at its end: the tokens count
    Token list_at_;    // its place
};

}  // namespace glint::povray
