// SPDX-License-Identifier: Apache-2.0
#pragma once
// The reader of POV-Ray's language: directives and macros make a stream of tokens, from which declarations,
// objects and settings are parsed. One class, in several files: stream.cpp (texts, macros, loops),
// directives.cpp, conditions.cpp, expressions.cpp, functions.cpp, user_functions.cpp, strings.cpp,
// values.cpp, textures.cpp, blocks.cpp, objects.cpp, modifiers.cpp, meshes.cpp, polygons.cpp, lights.cpp,
// camera.cpp, sky.cpp, settings.cpp; place.cpp, materials.cpp, smooth.cpp, interiors.cpp, glass.cpp and
// parallel.cpp (to the Scene).
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/load_state.h"
#include "formats/number_table.h"
#include "formats/povray/lexer.h"
#include "formats/povray/value.h"

namespace glint::povray {

// Limits on what a short text can ask for.
inline constexpr std::uint64_t k_max_steps = 30'000'000;  // tokens read again by loops and macros
inline constexpr std::uint64_t k_steps_per_shape = 1000;  // more of them for each shape that came of it
inline constexpr std::uint64_t k_most_steps = 1'000'000'000;
inline constexpr std::size_t k_max_frames = 500;            // macros and includes within each other
inline constexpr int k_max_depth = 100;                     // brackets and blocks within each other
inline constexpr std::uint64_t k_max_elements = 4'000'000;  // of all arrays
inline constexpr std::uint64_t k_max_shapes = 4'000'000;    // more than the text has tokens
inline constexpr std::uint32_t k_max_includes = 10000;      // and tests of files
inline constexpr std::size_t k_max_string = 65536;

/// Comparisons of functions are exact: they have symbols of their own.
char exact_comparison(char symbol);
char rough_comparison(char symbol, bool& is_exact);

class Reader {
  public:
    Reader(LoadState& reading, const ReadText& text);
    void read();

  private:
    void declare_numbers();

    // stream.cpp

    enum class FrameKind : std::uint8_t { text, include, macro };
    // A text or the body of a macro that is being read.
    struct Frame {
        FrameKind kind = FrameKind::text;
        std::uint16_t text = 0;
        const Token* tokens = nullptr;  // also at `end` there is one
        std::uint32_t at = 0, end = 0;
        std::size_t conditions = 0;           // open when it began
        CountedVector<std::uint32_t> locals;  // to be removed at its end
        Token call;                           // of the macro or include
        std::shared_ptr<const Function> function;
    };
    enum class ConditionKind : std::uint8_t { branch, loop_while, loop_for, choice };
    struct Condition {
        ConditionKind kind = ConditionKind::branch;
        Token at;
        bool is_done = false;     // branch: one part has been read; choice: a case has been found
        std::uint32_t begin = 0;  // loops: the first token of the condition, or of the body
        std::uint32_t name = 0;   // for: the variable
        double end = 0, step = 1;
        double choice = 0;
    };
    struct Binding {
        std::uint32_t depth = 0;  // the frame's
        Value value;
    };
    // While a value is read, directives of the same frame end it.
    struct Mark {
        std::size_t frames = 0, conditions = 0;
        int braces = 0;
    };

    const Token& peek() {
        if (!has_ahead_) fetch();
        return ahead_;
    }
    Token take() {
        peek();
        has_ahead_ = false;
        if (ahead_.kind == TokenKind::symbol) braces_ += (ahead_.symbol == '{') - (ahead_.symbol == '}');
        return ahead_;
    }
    bool accept(char symbol) {
        if (!peek().is(symbol)) return false;
        take();
        return true;
    }
    bool accept(Word word) {
        if (peek().word() != word) return false;
        has_ahead_ = false;
        return true;
    }
    bool expect(char symbol);
    void fetch();
    const Token& raw() const { return frames_.back().tokens[frames_.back().at]; }
    bool at_frame_end() const { return frames_.back().at >= frames_.back().end; }
    Token take_raw();
    bool spend(std::uint64_t steps = 1);
    void allow_steps(std::uint64_t shapes);
    bool is_within_memory(const Token& at);
    bool is_marked() const {
        return !marks_.empty() && marks_.back().frames == frames_.size() && marks_.back().braces == braces_;
    }
    bool ends_value(Word directive) const;
    void begin_value() { marks_.push_back({frames_.size(), conditions_.size(), braces_}); }
    void end_value();
    bool check_end_of_text();
    void leave_frame();
    void set_end();
    void call_macro(const Token& name, const Macro& macro);
    void skip_to_branch(bool to_end_only);
    std::uint32_t find_end(std::uint32_t at, std::uint32_t end) const;
    Binding* find_binding(std::uint32_t& name, std::uint32_t depth);
    Reference target_of(Reference reference);
    const Value* find_value(std::uint32_t name);
    void bind(std::uint32_t name, std::uint32_t depth, Value value);
    void assign(std::uint32_t name, bool is_local, Value value);
    void unbind(std::uint32_t name);
    std::uint32_t depth() const { return static_cast<std::uint32_t>(frames_.size() - 1); }

    // directives.cpp

    void read_directive();
    void read_declare(bool is_local);
    void read_undef();
    void read_macro(const Token& at);
    void read_version();
    void read_default();
    void read_message(const Token& at);

    // conditions.cpp
    bool condition();
    bool read_defined();
    void read_if(const Token& at, bool is_true);
    void read_ifdef(const Token& at, bool wanted);
    void read_else(const Token& at);
    void read_elseif(const Token& at);
    void read_end(const Token& at);
    void run_while();
    void read_for(const Token& at);
    void read_switch(const Token& at);
    void read_case(const Token& at);
    void read_break(const Token& at);
    void leave_condition();
    bool is_within(double value, const Condition& condition) const;

    // includes.cpp

    void read_include(const Token& at);
    void include(const Token& at, const std::string& name);
    void add_text(const Token& at, const std::string& path, std::string text);
    void lex_text(std::uint16_t number);
    void open_text(const Token& at, std::uint16_t number);

    // expressions.cpp

    struct Deeper {
        explicit Deeper(Reader& reader);
        ~Deeper() { --reader_.nesting_; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;
        bool ok = true;

      private:
        Reader& reader_;
    };
    Numbers expression();       // terms, without comparisons
    Numbers full_expression();  // with comparisons, `&`, `|` and `? :`
    Numbers comparison();
    Numbers product();
    Numbers factor();
    Numbers primary();
    Numbers suffixed(Numbers value);
    Numbers vector_literal();
    Numbers identifier(const Token& name);
    Numbers combine(char op, const Token& at, Numbers a, Numbers b);
    double number();
    bool is_end_of_number(std::uint32_t skipped) const;
    Vec3 vector();
    double number_or(double value);  // an optional number
    bool flag();                     // an optional number that stands for true or false
    bool begins_number(const Token& token);
    bool is_string_value(const Token& token);
    std::string what_is(const Token& token);

    // functions.cpp
    Numbers function(const Token& name);
    double argument();
    Vec3 vector_argument();
    Numbers call(const Token& name);
    Numbers array_size(const Token& name);
    RenderSettings scene_size(const Token& at);
    std::optional<double> clock() const;
    std::optional<double> declared_number(std::string_view name) const;

    // user_functions.cpp
    std::shared_ptr<const Function> read_function(const Token& at);
    std::uint32_t parameter_name(const Token& token);
    std::string what_problem(const Token& token);
    bool take_part(Token& token, const Function& function, const std::vector<std::uint32_t>& axes);
    Numbers call_function(const Token& name, const std::shared_ptr<const Function>& function);

    // strings.cpp
    bool begins_string(const Token& token);
    String string();
    CountedString string_function(Word word);
    std::string format_number(double value, double length, double decimals);
    double value_of(const Token& at, std::string_view text);
    int compare(std::string_view a, std::string_view b);

    // values.cpp
    Value value();
    Value identifier_value(const Token& name);
    Value named_value(const Token& name);
    template <class T> std::shared_ptr<const T> named(const Token& name);
    Numbers expression_after(Numbers first);
    Value array_value(const Token& at);
    void read_elements(Array& array, std::size_t dimensions, std::size_t& next, bool has_sizes);
    bool hold(Array& array, const Value& element, const Token& at);
    bool spend_elements(const Token& at, std::uint64_t count);
    std::uint32_t index();
    std::vector<std::uint32_t> read_indices();
    Value read_element(const Token& name, Value array);
    const Value* element(const Token& name, const Value& array, std::span<const std::uint32_t> indices);
    void assign_element(const Token& name, Value& whole, std::span<const std::uint32_t> indices,
                        Value assigned);

    // colors.cpp
    bool begins_color(const Token& token);
    std::array<double, 5> color(bool from_numbers);
    double of_srgb(double c) const;
    Numbers color_value();

    // textures.cpp
    Texture& own_texture(Object& object);
    Texture read_texture();
    void read_texture_items(Texture& texture);
    void read_pigment(Pigment& pigment);
    void read_finish(Finish& finish);
    void read_reflection(Finish& finish);
    Missing missing(const Token& at, std::string_view name);
    std::shared_ptr<const Texture> layered(const std::shared_ptr<const Texture>& below, Texture top);

    // blocks.cpp
    static bool is_opaque(Word word);
    std::shared_ptr<const Opaque> read_opaque(Word word, const Token& at);
    Opaque read_interior(const Token& at);
    MaterialValue read_material();
    void skip_block();
    void skip_rest();

    // transforms.cpp
    bool read_transform_item(std::optional<Affine>& map);
    Affine read_transform_block();
    Affine read_matrix();

    // objects.cpp
    bool begins_object(const Token& token);
    bool begins_declared(const Token& word);
    Object read_object();
    ObjectPart read_part();
    Object read_copy();
    ObjectPart object_of(const Token& name);
    Object read_shape(const Token& word);
    void check_shape(Object& object);
    static bool holds(const Object& clip, const Object& object);
    void read_modifiers(Object& object);
    bool read_modifier(Object& object);
    void read_clip(Object& object);
    static bool clip_mesh(const Object& clip, Object& object);
    static bool bounds_of(const Object& object, Vec3& lo, Vec3& hi);
    std::shared_ptr<const Clip> clip_of(const Object& clip, const Object& object, const Token& at);
    void check_clips();
    Object refuse_object(const Token& word);
    Object read_group(const Token& word);

    // meshes.cpp
    Object read_mesh(const Token& word);
    Object read_mesh2(const Token& word);
    void read_mesh_triangle(Mesh& mesh);
    void check_mesh(const Token& at, Mesh& mesh, bool has_normal_indices);
    std::size_t read_count();
    void read_face_indices(std::array<std::uint32_t, 3>& indices);
    std::uint32_t read_index();
    CountedVector<Vec3> read_points();
    void read_faces(Mesh& mesh);
    void read_normal_indices(Mesh& mesh);
    void read_texture_list(Mesh& mesh);

    // polygons.cpp
    Object read_polygon(const Token& word);
    void take_outlines(const CountedVector<Vec3>& points, Object& object);

    // lights.cpp
    Object read_light(const Token& word);
    void read_looks_like(Object& light);
    std::int32_t sample_count();

    // camera.cpp
    CameraItems read_camera(const Token& word);
    void use_camera(const CameraItems& camera);

    // sky.cpp
    void read_sky(const Token& at);
    std::shared_ptr<const GradientPattern> read_gradient(std::optional<Affine> map);
    bool read_color_map(CountedVector<ColorMapEntry>& map);

    // settings.cpp
    void read_statement();
    void read_global_settings();
    void read_background(const Token& at);
    void read_fog(const Token& at);
    void use_gamma();
    bool set(std::string_view name, const Token& at, std::string_view value);
    void finish_settings();

    // place.cpp
    std::uint64_t max_shapes() const { return k_max_shapes + tokens_[text_.file].size(); }
    void place(const Object& object);
    // What an object has from the groups around it.
    struct Inherited {
        const Texture* texture = nullptr;
        const Affine* map = nullptr;
        const Opaque* interior = nullptr;
        bool is_no_shadow = false, is_merge = false;
        bool is_solid = false;  // a shape whose inside is known
        // Of the interior: that of the whole object, or of a part that has its own.
        std::optional<bool> hollow;  // the outermost `hollow`
        bool has_interior = false, is_hollow = false;
        std::int32_t body = 0;  // the number of an interior with several shapes
    };
    void place(const Object& object, const Inherited& from);
    void place_shape(const Object& object, const Inherited& from);
    void place_mesh(const Object& object, const Inherited& own);
    SourcePlace shape_place(const Token& at);

    // interiors.cpp
    struct ShapeInteriors {
        std::size_t first = 0, end = 0;
        std::int32_t body = 0;
        bool is_hollow = false;
    };
    void inherit_interior(const Object& object, Inherited& own);
    void note_interior(std::size_t first, const Inherited& own);
    void use_interiors();

    // smooth.cpp
    void add_smooth(const SmoothTriangle& whole, std::uint32_t material, const Token& at);

    // parallel.cpp
    struct ParallelLight {
        Vec3 position, to_light;
        Token at;
    };
    void check_parallel_lights();
    void check_no_reflection();

    // tiny.cpp
    void check_size();
    void check_bailout();

    // glass.cpp
    double glass_of(const Inherited& own) const;
    void check_glass();

    // materials.cpp
    std::uint32_t material_of(const Inherited& own, const Token& at);
    void report_texture(const Inherited& own, const Token& at);
    void place_light(const Object& object, const Inherited& own);
    void place_look(const Object& object, const Inherited& own);
    void add_blended_face(const Object& object, const Inherited& own, const Mesh::Face& face,
                          std::span<const Vec3> points, std::span<const Vec3> normals);
    void report(const Missing& missing);
    void report(const MissingList& missing);
    bool leave_out(const Object& object);
    template <class Shape>
    void add(const Shape& shape, std::uint32_t material, const Affine* map, const Token& at);

    // Messages.
    void error(const Token& at, std::string message);
    void warn(const Token& at, std::string message);
    void warn_once(std::string_view key, const Token& at, std::string message);
    void expected(std::string_view what);
    std::string describe(const Token& token) const;
    std::string_view text_of(const Token& token) const;
    SourcePlace place_of(const Token& token);
    Token call_place(const Token& at) const;  // of the outermost macro call that is being read, or `at`

    LoadState& reading_;
    Scene& scene_;
    const ReadText& text_;
    Names names_;
    std::map<std::uint16_t, CountedVector<std::uint32_t>> line_starts_;
    std::vector<CountedVector<Token>> tokens_;  // by the number of the text
    std::vector<LexError> lex_errors_;
    std::vector<Frame> frames_;
    CountedVector<Condition> conditions_;
    std::vector<Mark> marks_;
    CountedVector<CountedVector<Binding>> bindings_;  // by name, innermost last
    std::vector<std::uint32_t> random_;               // the states of seed()
    Token ahead_;
    bool has_ahead_ = false, failed_ = false;
    std::uint64_t max_steps_ = k_max_steps;  // and one for each token of the text
    std::uint64_t steps_ = 0, elements_ = 0, shapes_ = 0, placed_ = 0;
    int nesting_ = 0, braces_ = 0;

    Texture default_texture_;
    std::shared_ptr<const Texture> default_shared_;
    std::optional<double> version_, gamma_;
    bool is_gamma_srgb_ = false;
    Token gamma_place_, version_place_;
    std::array<double, 5> background_{};
    Color ambient_light_{1, 1, 1};
    CountedVector<ParallelLight> parallel_lights_;
    std::optional<Token> high_bailout_;   // adc_bailout above 1/255
    std::optional<Token> no_reflection_;  // the first object with it
    CountedVector<std::shared_ptr<const Clip>> clips_;
    CountedVector<ShapeInteriors> interiors_;  // in the order of the shapes
    std::int32_t bodies_ = 0;
    CountedVector<std::uint32_t> glass_;  // shapes that refract
    Token glass_at_;                      // the last of them
    std::optional<CameraItems> camera_, camera_default_;
    NumberTable<33> materials_;
    NumberTable<33>::Key last_key_{};
    std::uint32_t last_material_ = k_none;
    bool is_last_plain_ = false;  // its shape had no warnings but those of the material
    Token last_place_token_;
    SourcePlace last_place_;
    std::vector<std::string> warned_;  // what has been refused
};

// What an identifier that has been read, or an element of an array, stands for; null if that is nothing of
// this kind.
template <class T> std::shared_ptr<const T> Reader::named(const Token& name) {
    const Value value = named_value(name);
    const auto* held = std::get_if<std::shared_ptr<const T>>(&value);
    return held != nullptr ? *held : nullptr;
}

}  // namespace glint::povray
