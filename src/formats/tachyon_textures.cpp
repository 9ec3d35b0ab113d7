// SPDX-License-Identifier: Apache-2.0
// Tachyon's textures: bodies, names, and the materials that they become.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/tachyon_reader.h"

namespace glint {
namespace {

constexpr Range k_function{0, 10, false, false, "a whole number from 0 to 10"};
// From the first one on that is not drawn.
constexpr double k_first_refused = 5;
constexpr std::string_view k_functions[] = {"the noise",
                                            "the checker on a cylinder",
                                            "an image on a cylinder",
                                            "an image on a sphere",
                                            "an image on a plane",
                                            "a volume image"};

}  // namespace

// Texture BODY, or the name of one.
bool TachyonReader::texture(std::uint32_t& material) {
    if (scanner_.accept("TEXTURE")) {
        // Large scenes repeat the text of a texture for each shape.
        if (scanner_.accept(last_body_)) {
            material = last_material_;
            return true;
        }
        const Token start = scanner_.token();
        TachyonTexture read;
        if (!texture_body(read, false)) return false;
        material = material_of(read, start);
        last_body_ = scanner_.passage(start);
        last_material_ = material;
        return true;
    }
    if (scanner_.at_end()) return expected("`Texture` or the name of a texture");
    const std::string name(scanner_.word());
    const auto found = state_.names.find(name);
    if (found != state_.names.end()) {
        material = found->second;
        scanner_.take();
        return true;
    }
    const Token at = scanner_.token();
    const std::string once = "tachyon texture " + name;
    if (!reading_.diagnostics.warned(once)) {
        reading_.diagnostics.warn_once(
            once, text_.place, at.offset, at.length,
            fmt::format("no texture is called {}: Tachyon's default is used (white, "
                        "Ambient 0.1, Diffuse 0.9)",
                        quoted(name)));
    }
    material = material_of({}, at);
    scanner_.take();
    return true;
}

// Of an object that is left out: makes no material.
bool TachyonReader::skip_texture() {
    TachyonTexture read;
    return scanner_.accept("TEXTURE") ? texture_body(read, false)
                                      : skip_name("`Texture` or the name of a texture");
}

std::uint32_t TachyonReader::material_of(const TachyonTexture& texture, const Token& place) {
    const NumberTable<17>::Key key = texture.numbers();
    if (const std::uint32_t* const known = state_.materials.find(key)) return *known;
    const std::uint32_t material = add_material(texture, place);
    state_.materials.add(key, material);
    return material;
}

std::uint32_t TachyonReader::add_material(const TachyonTexture& texture, const Token& place) {
    const auto material = static_cast<std::uint32_t>(scene_.materials.size());
    note(scene_.material_texts, material, source_place(text_, place));
    scene_.materials.emplace_back();
    state_.textures.emplace_back(material, texture);
    if (texture.function == TachyonFunction::grit || texture.function == TachyonFunction::marble)
        note_limit(TachyonLimit::grain, function_);
    if (texture.function == TachyonFunction::wood) note_limit(TachyonLimit::rings, function_);
    if (texture.function != TachyonFunction::none && texture.is_metal && texture.phong > 0)
        note_limit(TachyonLimit::bright_highlight, function_);
    return material;
}

bool TachyonReader::texture_body(TachyonTexture& t, bool has_vertex_colors) {
    if (!number("AMBIENT", "Ambient", t.ambient, k_channel) ||
        !number("DIFFUSE", "Diffuse", t.diffuse, k_channel) ||
        !number("SPECULAR", "Specular", t.specular, k_fraction) ||
        !number("OPACITY", "Opacity", t.opacity, k_fraction)) {
        return false;
    }
    if (scanner_.accept("TRANSMODE")) {
        t.fades_at_angles = scanner_.accept("R3D");
        if (!t.fades_at_angles && !scanner_.at_end()) scanner_.take();
    }
    if (scanner_.accept("OUTLINE") &&
        (!number(t.outline, k_fraction) ||
         !number("OUTLINE_WIDTH", "Outline_Width", t.outline_width, k_fraction))) {
        return false;
    }
    if (scanner_.accept("PHONG")) {
        t.is_metal = scanner_.accept("METAL");
        if (!t.is_metal && !scanner_.accept("PLASTIC")) return expected("`Plastic` or `Metal`");
        if (!number(t.phong, k_channel) || !number("PHONG_SIZE", "Phong_size", t.phong_size, k_exponent))
            return false;
    }
    if (has_vertex_colors) return expect("VCST", "VCST");
    if (!color("COLOR", "Color", t.color) || !expect("TEXFUNC", "TexFunc")) return false;
    const Token at = scanner_.token();
    double function = 0;
    return whole_number(function, k_function) && (function == 0 || texture_function(t, at, function));
}

// The arguments are read, so that mistakes in them are reported, too.
bool TachyonReader::texture_function(TachyonTexture& t, const Token& at, double function) {
    const bool has_image = function >= 7;
    std::string image;
    if (has_image) {
        if (scanner_.at_end()) return expected("the name of an image");
        image = " " + quoted(scanner_.word());
        scanner_.take();
    }
    Vec3 center, ignored;
    if (!point("CENTER", "Center", center) || !point("ROTATE", "Rotate", ignored) ||
        !point("SCALE", "Scale", ignored)) {
        return false;
    }
    if (function < k_first_refused) {
        function_ = at;
        t.function = static_cast<TachyonFunction>(static_cast<int>(function));
        if (t.function != TachyonFunction::grit) t.color = {1, 1, 1};
        if (t.function == TachyonFunction::checker || t.function == TachyonFunction::wood) t.center = center;
        return true;
    }
    if (function >= 9 && (!point("UAXIS", "Uaxis", ignored) || !point("VAXIS", "Vaxis", ignored)))
        return false;
    if (function >= 10 && !point("WAXIS", "Waxis", ignored)) return false;
    const std::string once = fmt::format("tachyon function {}{}", function, image);
    if (!is_left_out_ && refused_.insert(once).second) {
        draw_without(at, fmt::format("{}{} as a texture (`TexFunc {}`)",
                                     k_functions[static_cast<std::size_t>(function - k_first_refused)], image,
                                     function));
    }
    return true;
}

bool TachyonReader::read_definition() {
    const Token name = scanner_.token();
    if (scanner_.at_end()) return expected("the name of the texture");
    std::string word(scanner_.word());
    scanner_.take();
    TachyonTexture read;
    if (!texture_body(read, false)) return false;
    if (state_.names.contains(word)) return keep_texture(name, word);
    // Each name has a material of its own, that `glint convert` keeps.
    const std::uint32_t material = add_material(read, name);
    if (std::uint32_t* const known = state_.materials.find(read.numbers())) {
        *known = material;
    } else {
        state_.materials.add(read.numbers(), material);
    }
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    if (std::none_of(word.begin(), word.end(), is_control))
        scene_.material_texts.names.emplace(material, word);
    state_.names.emplace(std::move(word), material);
    return true;
}

bool TachyonReader::read_alias() {
    const Token name = scanner_.token();
    if (scanner_.at_end()) return expected("the new name of a texture");
    std::string word(scanner_.word());
    scanner_.take();
    if (scanner_.at_end()) return expected("the name of a texture");
    const auto found = state_.names.find(std::string(scanner_.word()));
    if (found == state_.names.end()) {
        const Token at = scanner_.token();
        warn(at, fmt::format("no texture is called {}: Tachyon's default is used", quoted(scanner_.word())));
    }
    const std::uint32_t material = found == state_.names.end() ? material_of({}, name) : found->second;
    scanner_.take();
    if (state_.names.contains(word)) return keep_texture(name, word);
    state_.names.emplace(std::move(word), material);
    return true;
}

// A further definition of a name has no effect in Tachyon.
bool TachyonReader::keep_texture(const Token& at, std::string_view word) {
    reading_.diagnostics.warn_once(
        "tachyon texture again", text_.place, at.offset, at.length,
        fmt::format("the texture {} is defined already: its first definition counts, as in Tachyon",
                    quoted(word)));
    return true;
}

}  // namespace glint
