// SPDX-License-Identifier: Apache-2.0
// .glint: glint's own scene language. docs/formats/glint.md.
#include <fmt/format.h>

#include <algorithm>

#include "formats/glint_blocks.h"
#include "formats/glint_solid.h"
#include "formats/glint_texture.h"
#include "formats/include.h"
#include "formats/profile_file.h"
#include "formats/registry.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr std::string_view k_what =
    "a block (`camera`, `light`, `material`, `sphere`, `group`, ...), a setting or `include`";
constexpr std::string_view k_block_words[] = {
    "sphere",  "material", "texture",     "light",        "group",      "camera",
    "plane",   "cylinder", "cone",        "disc",         "box",        "triangle",
    "polygon", "render",   "conventions", "fog",          "occlusion",  "background_gradient",
    "torus",   "union",    "merge",       "intersection", "difference", "inverse",
    "clip",    "quadric",  "quartic"};
constexpr std::string_view k_setting_words[] = {"background", "profile", "glint"};

// The keys of Conventions, or of RenderSettings.
struct SettingFields {
    explicit SettingFields(bool are_conventions) {
        for (const SettingKey& key : setting_keys()) {
            if (key.is_convention == are_conventions) fields.push_back({key.name});
        }
    }
    std::vector<Field> fields;
};

// An open group or solid. Its keys precede its contents.
struct Group {
    GlintContext context;
    GlintItem item;
    std::optional<GlintSolid> solid;
    FieldSet set;
    Token word;
    bool has_begun = false;  // its contents have begun: the context is complete
};

class GlintReader {
  public:
    GlintReader(LoadState& reading, const ReadText& text) : t_(reading, text), p_(t_.p) {}

    void read() {
        if (!t_.reading.camera_wanted && !t_.text.is_included) {
            t_.reading.camera_wanted =
                make_diagnostic(Severity::error, t_.text.place, p_.token().offset, p_.token().length,
                                "expected a camera in the scene, as `camera { position = (0, 2, 8)  "
                                "look_at = (0, 1, 0)  fov_x = 50 }`");
        }
        t_.blocks.read([&](const Token& word, std::string_view name) { return read_block(word, name); },
                       [&](const Token& word, std::string_view name) { return read_setting(word, name); },
                       [&](const Token&) { return read_include(); }, [&] { close_group(); });
    }

  private:
    bool read_block(const Token& word, std::string_view name) {
        if (is_shape_word(name)) {
            read_glint_shape(t_, word, context());
        } else if (name == "group" || solid_operation(name)) {
            open_group(word, name);
        } else if (std::find(std::begin(k_block_words), std::end(k_block_words), name) ==
                   std::end(k_block_words)) {
            const bool is_setting = std::find(std::begin(k_setting_words), std::end(k_setting_words), name) !=
                                    std::end(k_setting_words);
            if (is_setting) return false;
            p_.error(word, fmt::format("no block is called {}{}", quoted(name),
                                       name == "smooth_triangle" || name == "mesh"
                                           ? std::string(": write `triangle` with `normals`")
                                           : did_you_mean(name, k_block_words)));
            t_.blocks.skip_block();
        } else if (!groups_.empty()) {
            p_.error(word, fmt::format("a group contains shapes, groups and includes; {} must be outside",
                                       quoted(name)));
            t_.blocks.skip_block();
        } else {
            read_outer_block(word, name);
        }
        return true;
    }

    void read_outer_block(const Token& word, std::string_view name) {
        if (name == "camera") {
            read_glint_camera(t_, word);
        } else if (name == "light") {
            read_glint_light(t_, word);
        } else if (name == "fog") {
            read_of_first(word, read_glint_fog);
        } else if (name == "occlusion") {
            read_of_first(word, read_glint_occlusion);
        } else if (name == "background_gradient") {
            read_of_first(word, read_glint_gradient);
        } else if (name == "material") {
            read_material(word);
        } else if (name == "texture") {
            t_.textures.read_block(t_, word);
        } else {
            read_settings(word, name == "conventions");
        }
    }

    // A block that only the first file may have.
    void read_of_first(const Token& word, void (*read_block_of)(GlintText&, const Token&)) {
        if (!t_.text.is_included) return read_block_of(t_, word);
        warn_ignored(word);
        t_.blocks.skip_block();
    }

    void read_material(const Token& word) {
        if (!t_.blocks.label() || t_.p.name(*t_.blocks.label()).empty()) {
            p_.error(word, "expected a name after `material`");
            return t_.blocks.skip_block();
        }
        const Token name = *t_.blocks.label();
        FieldSet set("material", k_material_keys, material_hints());
        MaterialKeys keys;
        if (t_.blocks.fields(set, word,
                             [&](int field, const Token&) { return read_material_key(t_, field, keys); }))
            t_.materials.define(t_, word, name, keys);
    }

    // conventions { } and render { }: keys and values as on the command line.
    void read_settings(const Token& word, bool are_conventions) {
        static const SettingFields conventions(true), settings(false);
        const std::string_view what = are_conventions ? "conventions block" : "render block";
        static constexpr SpellingHint conventions_hints[] = {
            {"size", "it in a `render` block"},    {"shading", "it in a `render` block"},
            {"shadows", "it in a `render` block"}, {"reflections", "it in a `render` block"},
            {"aa", "it in a `render` block"},      {"alpha", "it in a `render` block"},
            {"seed", "it in a `render` block"}};
        static constexpr SpellingHint render_hints[] = {
            {"depth", "`reflections`"},           {"samples", "`aa`"},
            {"jitter", "`aa = \"4:jitter\"`"},    {"random_seed", "`seed`"},
            {"width", "`size = 640 x 480`"},      {"height", "`size = 640 x 480`"},
            {"resolution", "`size = 640 x 480`"}, {"threads", "it on the command line"}};
        FieldSet set(what, are_conventions ? conventions.fields : settings.fields,
                     are_conventions ? std::span<const SpellingHint>(conventions_hints) : render_hints);
        if (t_.text.is_included) warn_ignored(word);
        t_.reading.settings_given = true;
        t_.blocks.fields(set, word, [&](int field, const Token& key) {
            const Token at = p_.token();
            std::string value;
            if (!read_setting_text(t_, value)) return false;
            const std::string wrong =
                set_named_setting(t_.scene, set.fields()[static_cast<std::size_t>(field)].name, value,
                                  {SettingOrigin::Kind::file, source_place(t_.text, key)});
            if (!wrong.empty()) p_.error(at, wrong);
            return true;
        });
    }

    bool read_setting(const Token& word, std::string_view name) {
        if (!groups_.empty()) return read_group_key(word, name);
        if (name == "background") return read_background(word);
        if (name == "profile") return read_profile(word);
        if (name == "glint") return read_version();
        const bool is_item = std::any_of(std::begin(k_item_fields), std::end(k_item_fields),
                                         [&](const Field& field) { return field.name == name; });
        if (is_item) {
            p_.error(word, fmt::format("{} belongs in the block of a shape or a group", quoted(name)));
        } else if (name == "include") {
            p_.error(word, "an include has no `=`: write `include \"file\"`");
        } else if (find_setting(name)) {
            p_.error(word, fmt::format("{} belongs in a `conventions` or a `render` block", quoted(name)));
        } else {
            p_.error(word, fmt::format("no setting is called {}{}", quoted(name),
                                       did_you_mean(name, k_setting_words)));
        }
        return false;
    }

    bool read_version() {
        const Token at = p_.token();
        double version = 0;
        if (!p_.number(version, k_coordinate)) return false;
        if (version != 1)
            p_.error(at, fmt::format("expected 1, the version of the language, found {}", p_.describe(at)));
        return true;
    }

    bool read_background(const Token& word) {
        LoadState& reading = t_.reading;
        if (reading.background_given) {
            p_.warn(word, reading.background_included
                              ? "this background holds, and not that of an included file"
                              : "a second background: the last one holds");
        }
        reading.background_given = true;
        reading.background_included = false;
        t_.scene.background_place = source_place(t_.text, word);
        return read_color(t_, t_.scene.background, k_channel, ColorUse::surface);
    }

    // The profile of the command line overrides that of the text; its profile file is applied after it.
    bool read_profile(const Token& word) {
        const Token at = p_.token();
        Token name;
        if (!read_name(t_, "the name of a profile", name)) return false;
        if (t_.text.file != 0) {
            warn_ignored(word);
        } else if (t_.reading.settings_given) {
            p_.error(word,
                     "expected `profile` before the first `conventions` or `render` block, whose keys it "
                     "would undo");
        } else if (t_.reading.options.profile.empty()) {
            const std::string wrong = set_named_profile(t_.scene, p_.name(name));
            if (!wrong.empty()) {
                p_.error(at, wrong);
            } else if (t_.reading.profile_text && !t_.reading.diagnostics.any_errors()) {
                read_profile_file(t_.reading, *t_.reading.profile_text);
            }
        }
        return true;
    }

    void warn_ignored(const Token& word) {
        p_.warn(word, fmt::format("glint ignores {} here: the first file has the say", p_.describe(word)));
    }

    bool read_include() {
        if (p_.token().kind != TokenKind::string) {
            p_.expected("the name of a file in quotes");
            return false;
        }
        const Token at = p_.take();
        Scene& scene = t_.scene;
        GlintContext& around = context();
        const std::size_t first_shape = scene.shapes.size(), first_transform = scene.transforms.size();
        include_text(t_.reading, t_.text, at, p_.name(at));
        if (around.map) {
            for (std::size_t i = first_transform; i < scene.transforms.size(); ++i)
                scene.transforms[i] = compose(*around.map, scene.transforms[i]);
        }
        for (std::size_t i = first_shape; i < scene.shapes.size(); ++i) {
            Shape& shape = scene.shapes[i];
            if (shape.transform == k_none) shape.transform = transform_index(scene, around);
            if (shape.material == k_none) shape.material = around.material;
        }
        return true;
    }

    void open_group(const Token& word, std::string_view name) {
        const auto operation = solid_operation(name);
        const std::span<const Field> fields =
            operation ? std::span<const Field>(k_solid_fields) : k_item_fields;
        Group group{{}, {}, {}, FieldSet{name, fields, material_hints()}, word};
        if (operation) {
            // Its parts have its material and its transform by the solid.
            group.solid = {*operation, t_.scene.shapes.size(), context(), {}, block_name(t_)};
        } else {
            group.context = context();
        }
        if (t_.blocks.open(word)) groups_.push_back(std::move(group));
    }

    void close_group() {
        Group& group = groups_.back();
        if (group.solid) close_glint_solid(t_, group.word, *group.solid, group.item);
        groups_.pop_back();
    }

    bool read_group_key(const Token& word, std::string_view name) {
        Group& group = groups_.back();
        const int field = p_.field(group.set, word, name);
        if (field < 0) return false;
        if (group.has_begun) {
            p_.error(word, fmt::format("expected {} before what the {} holds", quoted(name),
                                       group.solid ? p_.text(group.word) : "group"));
            return false;
        }
        if (field == static_cast<int>(std::size(k_item_fields)))
            return read_color(t_, group.solid->color.emplace(), k_channel, ColorUse::surface);
        return read_item_key(t_, field, word, group.item);
    }

    // The context of the next shape, group or include.
    GlintContext& context() {
        if (groups_.empty()) return top_;
        Group& group = groups_.back();
        if (!group.has_begun) {
            group.has_begun = true;
            if (group.solid) return group.context;
            if (const auto map = compose_maps(std::nullopt, group.item.map)) {
                group.context.map = compose_maps(group.context.map, map);
                group.context.transform = k_none;
            }
            const std::uint32_t base =
                group.item.material != k_none ? group.item.material : group.context.material;
            group.context.material = t_.materials.changed(t_, group.word, base, group.item.keys, false);
        }
        return group.context;
    }

    GlintText t_;
    Parser& p_;
    GlintContext top_;
    std::vector<Group> groups_;
};

}  // namespace

GlintText::GlintText(LoadState& of, const ReadText& read_text)
    : reading(of),
      scene(of.scene),
      text(read_text),
      materials(GlintMaterials::of(of)),
      textures(GlintTextures::of(of)),
      p(read_text.place, {.hash_comments = true, .slash_comments = true}, of.diagnostics),
      blocks(p, {}, k_what, {.include = "include", .names = true}) {}

void set_glint_defaults(Scene&) {}

void read_glint(LoadState& reading, const ReadText& text) { GlintReader(reading, text).read(); }

void finish_glint(LoadState& reading) {
    if (!reading.glint_materials) return;
    reading.glint_materials->finish(reading);
    reading.glint_textures->finish(reading);
    // After an error, the camera may be in a part that was not read.
    if (reading.diagnostics.any_errors()) reading.camera_wanted.reset();
}

}  // namespace glint
