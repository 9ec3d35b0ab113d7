// SPDX-License-Identifier: Apache-2.0
#pragma once
// Objects to the Scene: groups are resolved, maps are applied to the shapes, textures become materials; and
// what of POV-Ray's rules only the whole scene decides.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formats/load_state.h"
#include "formats/number_table.h"
#include "formats/povray/mesh_parts.h"
#include "formats/povray/object.h"
#include "formats/povray/token_stream.h"

namespace glint::povray {

class SceneBuilder {
  public:
    /// stream: for messages, places and limits. is_quiet: without warnings of what is not rendered.
    SceneBuilder(LoadState& reading, TokenStream& stream, bool is_quiet = false)
        : reading_(reading), scene_(reading.scene), stream_(stream), is_quiet_(is_quiet) {}

    /// Whether a mesh of the scene is a height_field.
    bool is_field(std::uint32_t mesh) const {
        return std::any_of(fields_.begin(), fields_.end(),
                           [&](const auto& field) { return field.second.index == mesh; });
    }
    /// default_texture: of shapes that have none, and are in no group with one.
    void place(const Object& object, const Texture& default_texture);
    void use_camera(const CameraItems& camera);
    /// Where the text sets adc_bailout above 1/255, if it does.
    void set_high_bailout(const std::optional<Token>& at) { high_bailout_ = at; }
    /// A feature that is not rendered: a warning for the first of each name, or an error. Does not end the
    /// reading.
    void report(const Missing& missing);
    /// Whether anything that has been placed is an error.
    bool has_refused() const { return !warned_.empty(); }
    /// After everything has been placed. scene_at: the token that stands for the scene in messages.
    void finish(const Token& scene_at);

  private:
    // Where `uv_mapping` has u and v from: the x and y of points in the scene (measured), the vertices of a
    // mesh, the angles around a sphere, or a rule that glint has not.
    enum class UvSource : std::uint8_t { plane, vertices, sphere, unknown };
    // What cuts an object off, and where it is.
    struct PlacedClip {
        ObjectPart object;
        std::optional<Affine> map;
    };
    // What an object has from the groups around it.
    struct Inherited {
        const Texture* texture = nullptr;
        const Affine* map = nullptr;
        // Of the texture's images: the transforms after it.
        const Affine* texture_map = nullptr;
        bool is_uv = false;  // `uv_mapping` of the object
        UvSource uv_source = UvSource::plane;
        const Affine* sphere = nullptr;  // of UvSource::sphere: the place of one of radius 1
        const Opaque* interior = nullptr;
        const Opaque* finish_interior = nullptr;  // of the outermost object
        bool is_no_shadow = false, is_merge = false;
        // Of the interior: that of the whole object, or of a part that has its own.
        std::optional<bool> hollow;  // the outermost `hollow`
        bool has_interior = false, is_hollow = false;
        std::int32_t body = 0;  // the number of an interior with several shapes
        bool is_union = false;  // these are the parts of a union
        bool in_solid = false;  // it is an operand
        bool is_cut_out = false;
        bool is_bounded = false;
        bool is_ball = false;  // a whole sphere: light that enters one leaves it
        std::shared_ptr<const CountedVector<PlacedClip>> clips;
    };

    // place.cpp
    void place(const Object& object, const Inherited& from);
    void place_shape(const Object& object, const Inherited& from);
    SourcePlace shape_place(const Token& at);
    template <class Shape>
    void add(const Shape& shape, std::uint32_t material, const Affine* map, const Token& at);

    // place_solid.cpp
    void place_parts(const Object& object, const Inherited& own);
    void finish_operand(const Object& object, const Inherited& own, std::size_t first);
    void combine_from(std::size_t first, SolidOperation operation, const Token& at);
    bool add_clips(const Object& object, const Inherited& from, Inherited& own);
    void note_solid(std::size_t shape, const Inherited& own);

    // place_mesh.cpp
    void place_mesh(const Object& object, const Inherited& own, bool will_be_cut);
    void place_faces(const Object& object, const Inherited& own);
    bool place_single_face(const Object& object, const Inherited& own);
    bool gather_face(const Object& object, const Inherited& own, const Texture& texture);
    MeshParts* parts_of(const Object& object);

    // place_field.cpp
    void place_field(const Object& object, const Inherited& own);

    // report.cpp
    void report(const MissingList& missing);
    bool leave_out(const Object& object);

    // materials.cpp
    std::uint32_t material_of(const Inherited& own, const Token& at);
    void report_texture(const Inherited& own, const Token& at);

    // place_image.cpp
    std::uint32_t texture_of(const Inherited& own, const Token& at, std::uint32_t over = k_none);
    std::uint32_t add_texture(glint::Texture texture, double image_number, const Token& at);

    // layers.cpp
    // What the layers of a texture look like together: a color, times a texture of the scene.
    struct Look {
        std::array<double, 5> color{};
        std::uint32_t image = k_none;
        const Finish* finish = nullptr;  // of a color without a texture
    };
    // The finish of a material for all layers: that of the top one, with the largest ambient and diffuse.
    struct LayerLight {
        Color ambient{0, 0, 0};
        double diffuse = 0;
    };
    static LayerLight light_of_layers(const Texture& texture);
    Look look_of(const Inherited& own, const Token& at);
    Look over(const Inherited& own, const Look& below, const Token& at);
    std::uint32_t texture_of_color(const Finish& finish, const std::array<double, 5>& color,
                                   std::uint32_t over, const Token& at);
    void set_shares(const Finish& finish, glint::Texture& texture) const;

    // place_lights.cpp
    void place_light(const Object& object, const Inherited& own);
    void place_look(const Object& object, const Inherited& own);

    // blended_faces.cpp
    void add_blended_face(const Object& object, const Inherited& own, std::uint32_t face);

    // interiors.cpp
    struct ShapeInteriors {
        std::size_t first = 0, end = 0;
        std::int32_t body = 0;
        bool is_hollow = false, is_union = false;
    };
    static const Opaque* finish_interior_of(const Object& object);
    void inherit_interior(const Object& object, Inherited& own);
    void note_interior(std::size_t first, const Inherited& own);
    void use_interiors();
    void note_inside(const Object& object, const Inherited& own, std::size_t first);
    void check_camera_inside();
    // A prism, a lathe or a mesh, which glint has no inside of, or a mesh whose light fades in it.
    struct ShapesWithInside {
        std::size_t first = 0, end = 0;
        Token at;
    };
    bool is_around_camera(const ShapesWithInside& object) const;

    // parallel.cpp, refraction.cpp, tiny.cpp, finish.cpp: of the whole scene
    struct ParallelLight {
        Vec3 position, to_light;
        Token at;
    };
    // A shape that may be cut.
    struct UncutShape {
        std::shared_ptr<const Clip> clip;
        CountedVector<ClipObject> objects;
        std::size_t shape = 0;
        bool has_inside = false;
    };
    static double ior_of(const Inherited& own);
    static Fade fade_of(const Inherited& own);
    static double caustics_of(const Inherited& own);
    bool refracts_light() const;
    void make_all_refract();
    void forget_refraction();
    void check_refraction();
    void check_fading();
    bool is_clear_texture(std::uint32_t texture) const;
    void check_parallel_lights();
    void check_size(const Token& scene_at);
    void check_bailout();
    void check_no_reflection();
    void check_jitter();
    void check_clips();
    void cut(const UncutShape& uncut);

    LoadState& reading_;
    Scene& scene_;
    TokenStream& stream_;
    const bool is_quiet_;
    std::uint64_t placed_ = 0;
    // Of each mesh that has been placed. A weak pointer keeps its address from being used again.
    struct PlacedMesh {
        std::weak_ptr<const ReadMesh> mesh;
        MeshParts parts;
        bool has_parts = false;
    };
    CountedHashMap<const ReadMesh*, PlacedMesh> meshes_;
    // Of each height_field that has been placed.
    struct PlacedField {
        std::weak_ptr<const HeightField> field;
        Affine object_from_world;      // without its translation
        std::uint32_t index = k_none;  // in Scene::meshes
    };
    CountedHashMap<const HeightField*, PlacedField> fields_;
    // The shape that faces which are meshes of their own are gathered in.
    struct Gathered {
        std::shared_ptr<MeshData> data;
        std::uint32_t material = k_none;
        bool is_smooth = false, is_hollow = false;
    };
    Gathered gathered_;
    std::uint64_t uncounted_bytes_ = 0;
    CountedVector<ParallelLight> parallel_lights_;
    std::optional<Token> high_bailout_;       // adc_bailout above 1/255
    std::optional<Token> media_attenuation_;  // the last light with it
    std::optional<Token> no_reflection_;      // the first object with it
    // Area lights with shadows and `jitter`: their numbers in the scene.
    CountedVector<std::pair<std::size_t, Token>> jittered_;
    CountedVector<UncutShape> clips_;
    CountedVector<ShapeInteriors> interiors_;  // in the order of the shapes
    CountedVector<ShapesWithInside> with_inside_, fading_meshes_;
    std::optional<Token> overlapping_operands_;  // of the last union in a solid that has such
    std::int32_t bodies_ = 0;
    // The last object that refracts, and that is hollow, too, and the last one that fades light.
    std::optional<Token> refracts_at_, hollow_at_, fades_at_;
    NumberTable<41> materials_;
    NumberTable<23> textures_;
    NumberTable<41>::Key last_key_{};
    std::uint32_t last_material_ = k_none;
    std::optional<LayerLight> layer_light_;  // of a texture with layers, while its material is made
    bool is_last_plain_ = false;             // its shape had no warnings but those of the material
    Token last_place_token_;
    SourcePlace last_place_;
    std::vector<std::string> warned_;  // what has been refused
};

}  // namespace glint::povray
