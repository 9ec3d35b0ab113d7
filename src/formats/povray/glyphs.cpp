// SPDX-License-Identifier: Apache-2.0
// text: the outlines of a font's glyphs, as a mesh. What was measured of POV-Ray: the em is 1 long; the first
// glyph's left side is at x = 0, whatever the font says; the table of kerning and `offset` (not its z) add to
// the advance; inside is what an odd number of a glyph's edges surrounds; the first point of a contour is on
// it; a glyph that is made of others is moved by the left side of its box, if that is above 0; the box of a
// text has those of all glyphs, also of spaces; a thickness below 0 leaves the sides out.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/font.h"
#include "formats/povray/object_parser.h"
#include "formats/povray/standard_includes.h"

namespace glint::povray {

// Those that have been made, by what makes them: scenes have the same letter many times.
struct TextMeshes {
    CountedMap<CountedString, std::shared_ptr<const ReadMesh>> meshes;
};

namespace {

class TextMesh {
  public:
    TextMesh(ReadMesh& mesh, double thickness) : mesh_(mesh), thickness_(thickness) {}

    /// Vertices without triangles, for min_extent() and max_extent().
    void add_box(FlatPoint low, FlatPoint high) {
        add(low, 0);
        add(high, thickness_);
    }

    // In this order of the corners, trace() gives the normals that POV-Ray gives.

    void add_sides(const FlatLoop& loop) {
        if (!(thickness_ > 0)) return;
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (const FlatPoint& p : loop) {
            add(p, 0);
            add(p, thickness_);
        }
        const auto count = static_cast<std::uint32_t>(2 * loop.size());
        for (std::uint32_t i = 0; i < count; i += 2) {
            const std::uint32_t a = first + i, b = first + (i + 2) % count;
            mesh_.triangles.push_back({b, a, b + 1});
            mesh_.triangles.push_back({b + 1, a, a + 1});
        }
    }

    void add_caps(const CountedVector<FlatTriangle>& triangles) {
        for (const FlatTriangle& t : triangles) {
            mesh_.triangles.push_back({add(t[0], 0), add(t[1], 0), add(t[2], 0)});
            mesh_.triangles.push_back({add(t[1], thickness_), add(t[0], thickness_), add(t[2], thickness_)});
        }
    }

  private:
    std::uint32_t add(FlatPoint p, double z) { return mesh_.add_vertex({p.x, p.y, z}); }

    ReadMesh& mesh_;
    double thickness_;
};

// The closed line of a contour, in single steps.
class ContourLine {
  public:
    ContourLine(const std::function<bool(std::uint64_t)>& spend, FlatLoop& line)
        : spend_(spend), line_(line) {}

    /// place: of a point of the font.
    template <class Place> void add(const std::vector<GlyphPoint>& contour, Place&& place) {
        const std::size_t count = contour.size();
        if (count < 3) return;  // some fonts mark places by such contours
        line_.push_back(place(contour[0]));
        for (std::size_t i = 1; i <= count; ++i) {
            const GlyphPoint& point = contour[i % count];
            const FlatPoint p = place(point);
            if (i == count || point.is_on) {
                end_at(p);
            } else {
                if (control_) end_at({(control_->x + p.x) / 2, (control_->y + p.y) / 2});
                control_ = p;
            }
        }
        line_.pop_back();  // the first point
    }

  private:
    void end_at(FlatPoint end) {
        if (control_) {
            const FlatPoint from = line_.back(), c = *control_;
            const auto between = [&](FlatPoint p) {
                return FlatPoint{(p.x + 2 * c.x) / 3, (p.y + 2 * c.y) / 3};
            };
            line_.pop_back();
            add_curve({from, between(from), between(end), end}, 0, 4, Spline::bezier, spend_, line_);
        } else {
            line_.push_back(end);
        }
        control_.reset();
    }

    const std::function<bool(std::uint64_t)>& spend_;
    FlatLoop& line_;
    std::optional<FlatPoint> control_;
};

// The next character of UTF-8; a byte that is none of it, as chr() makes them, is a character of Latin-1.
std::uint32_t take_character(std::string_view& text) {
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
    };
    const std::uint32_t first = byte(0);
    const std::size_t count = first >= 0xf0 && first < 0xf5 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 1;
    std::uint32_t code = count == 1 ? first : first & (0x7fu >> count);
    bool is_whole = count <= text.size() && first < 0xf5;
    for (std::size_t i = 1; i < count && is_whole; ++i) {
        is_whole = (byte(i) & 0xc0u) == 0x80;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    text.remove_prefix(is_whole ? count : 1);
    return is_whole ? code : first;
}

CountedString key_of(const char* font, std::string_view characters, std::initializer_list<double> numbers) {
    CountedString key;
    const auto add = [&](const auto& value) {
        key.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    add(font);
    for (const double number : numbers) add(number);
    return key.append(characters);
}

}  // namespace

// The bytes of a font's file: beside the scene, in the folders of includes, or POV-Ray's own. Empty if it is
// refused.
std::string_view ObjectParser::font_bytes(Object& text, const Token& at, const std::string& name) {
    LoadState& state = reading();
    const std::string_view from = this->text().place.name;
    std::string why;
    const auto find = [&](const std::string& file) -> const InputText* {
        const std::string path =
            is_absolute_path(file) ? file : std::string(from.substr(0, from.rfind('/') + 1)) + file;
        const auto& files = state.includes.files;
        if (const auto known = files.find(path); known != files.end()) return &state.texts[known->second];
        Result<std::string> bytes = state.sources->read(file, from);
        if (!bytes) {
            if (why.empty()) why = bytes.message.empty() ? "no such file" : bytes.message;
            return nullptr;
        }
        if (state.texts.size() > k_max_texts) {
            error(at, fmt::format("at most {} texts make a scene", k_max_texts));
            return nullptr;
        }
        return &state.texts[state.add_text(path, std::move(*bytes))];
    };
    if (state.sources == nullptr) {
        refuse_font(text, at, name, "no files are read here");
        return {};
    }
    const bool has_folder = name.find('/') != std::string::npos;
    for (const std::string& folder : {std::string(), std::string(k_system_folder)}) {
        if (!folder.empty() && has_folder) break;
        for (const std::string_view end : {"", ".ttf"}) {
            if (const InputText* bytes = find(folder + name + std::string(end))) return bytes->text;
            if (failed()) return {};
        }
    }
    refuse_font(text, at, name, why);
    state.is_include_missing |= failed();
    return {};
}

// An error, or the text is left out.
void ObjectParser::refuse_font(Object& text, const Token& at, const std::string& name, std::string_view why) {
    if (!reading().options.skip_unsupported) return error(at, fmt::format("{}: {}", quoted(name), why));
    text.missing.add({"text", "without its font", call_place(text.at), true});
    read_modifiers(text);
}

// { ttf "file" "characters" thickness, offset modifiers }
Object ObjectParser::read_text(const Token& word) {
    Object object;
    object.kind = ObjectKind::mesh;
    object.at = word;
    object.stands_for = "text";
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    const Token kind = peek();
    const std::string_view kind_name = kind.kind == TokenKind::word ? text_of(kind) : std::string_view();
    if (kind_name == "internal") {
        object.kind = ObjectKind::refused;
        object.missing.add({"text", "with an internal font", call_place(word), true});
        skip_rest();
        expect('}');
        return object;
    }
    if (kind_name != "ttf") {
        expected("`ttf`");
        return object;
    }
    take();
    const Token file_at = peek();
    const String file = string();
    accept(',');
    const String characters = string();
    accept(',');
    const double thickness = number();
    accept(',');
    const Vec3 offset = vector();
    if (failed()) return object;
    const Missing without_charset{"text", "of characters beyond ASCII without `charset utf8`",
                                  call_place(word)};
    const bool are_spaces = has_text_beyond_ascii_ && !is_utf8_ && is_beyond_ascii(*characters);
    auto mesh = make_counted<ReadMesh>();
    object.mesh = mesh;
    const std::string name(*file);
    const std::string_view bytes = font_bytes(object, file_at, name);
    if (failed() || !object.missing.empty()) return object;
    if (!text_meshes_) text_meshes_ = std::make_shared<TextMeshes>();
    const CountedString key = key_of(bytes.data(), *characters, {thickness, offset.x, offset.y});
    if (const auto known = text_meshes_->meshes.find(key); known != text_meshes_->meshes.end()) {
        object.mesh = known->second;
        spend(characters->size());
        if (are_spaces) object.missing.add(without_charset);
        read_modifiers(object);
        return object;
    }
    std::string why;
    const std::unique_ptr<Font> font = Font::open(bytes, why);
    if (!font) {
        refuse_font(object, file_at, name, why);
        return object;
    }
    TextMesh text_mesh(*mesh, thickness);
    const std::function<bool(std::uint64_t)> spend_on = [&](std::uint64_t n) { return spend(n); };
    const double em = font->units_per_em();
    FlatPoint pen;
    std::optional<std::uint32_t> before;
    for (std::string_view rest = *characters; !rest.empty();) {
        Glyph glyph;
        if (!font->read(take_character(rest), glyph, why)) {
            refuse_font(object, file_at, name, why);
            return object;
        }
        if (!before)
            pen.x = -glyph.left / em;
        else
            pen.x += font->kerning(*before, glyph.number) / em;
        before = glyph.number;
        const auto place = [&](const GlyphPoint& p) {
            return FlatPoint{pen.x + (p.x + glyph.composed_left) / em, pen.y + p.y / em};
        };
        CountedVector<FlatLoop> loops;
        for (const auto& contour : glyph.contours) {
            FlatLoop line;
            ContourLine(spend_on, line).add(contour, place);
            if (line.size() > 2) loops.push_back(std::move(line));
        }
        CountedVector<FlatTriangle> cap;
        const bool is_filled = fill_even_odd(loops, spend_on, cap);
        if (failed() || !is_within_memory(word)) return object;
        if (!is_filled) object.missing.add({"text", "whose edges cross too often", call_place(word), true});
        text_mesh.add_box({pen.x + glyph.left / em, pen.y + glyph.bottom / em},
                          place({glyph.right, glyph.top, true}));
        for (const FlatLoop& line : loops) text_mesh.add_sides(line);
        text_mesh.add_caps(cap);
        pen = {pen.x + glyph.advance / em + offset.x, pen.y + offset.y};
    }
    if (object.missing.empty()) text_meshes_->meshes.emplace(key, mesh);
    if (are_spaces) object.missing.add(without_charset);
    read_modifiers(object);
    return object;
}

}  // namespace glint::povray
