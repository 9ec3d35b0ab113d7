// SPDX-License-Identifier: Apache-2.0
// .dat: the scenes of the ray tracer Tachyon. docs/formats/tachyon.md.
#include "formats/tachyon.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/include.h"
#include "formats/registry.h"
#include "formats/tachyon_reader.h"

namespace glint {
namespace {

constexpr std::string_view k_any_object = "an object, a light, a texture, `Camera` or `End_Scene`";
constexpr Range k_picture_size{1, k_max_size, false, false, "a whole number from 1 to 65536"};
constexpr Range k_image_size{0, 65536, false, false, "a whole number from 0 to 65536"};
constexpr Range k_clipping_planes{0, 1e9, false, false, "a whole number from 0 to 1000000000"};
// Of words between two calls of the load's watcher.
constexpr int k_objects_between_reports = 1024;

}  // namespace

TachyonReader::TachyonReader(LoadState& reading, const ReadText& text)
    : reading_(reading),
      scene_(reading.scene),
      state_(*reading.tachyon),
      text_(text),
      scanner_(text.place.text),
      is_further_(text.is_included || reading.tachyon->has_header) {}

std::span<const TachyonReader::Object> TachyonReader::objects() {
    using R = TachyonReader;
    // The most frequent ones first.
    static constexpr Object k_objects[] = {
        {"STRI", "STri", &R::read_smooth_triangle},
        {"SPHERE", "Sphere", &R::read_sphere},
        {"FCYLINDER", "FCylinder", &R::read_finite_cylinder},
        {"TRI", "Tri", &R::read_triangle},
        {"VCSTRI", "VCSTri", &R::read_colored_triangle},
        {"VERTEXARRAY", "VertexArray", &R::read_vertices},
        {"TEXDEF", "TexDef", &R::read_definition},
        {"TEXALIAS", "TexAlias", &R::read_alias},
        {"CYLINDER", "Cylinder", &R::read_cylinder},
        {"POLYCYLINDER", "PolyCylinder", &R::read_polycylinder},
        {"RING", "Ring", &R::read_ring},
        {"PLANE", "Plane", &R::read_plane},
        {"BOX", "Box", &R::read_box},
        {"LIGHT", "Light", &R::read_light},
        {"DIRECTIONAL_LIGHT", "Directional_Light", &R::read_directional_light},
        {"SPOTLIGHT", "SpotLight", &R::read_spot_light},
        {"SKY_LIGHT", "Sky_Light", &R::read_sky_light},
        {"CAMERA", "Camera", &R::read_camera},
        {"SHADER_MODE", "Shader_Mode", &R::read_shader_mode},
        {"BACKGROUND", "Background", &R::read_background},
        {"BACKGROUND_GRADIENT", "Background_Gradient", &R::read_gradient},
        {"FOG", "Fog", &R::read_fog},
        {"INCLUDE", "Include", &R::read_include},
        {"IMAGEDEF", "ImageDef", &R::read_image},
        {"SCAPE", "Scape", &R::read_landscape},
        {"SCALARVOL", "ScalarVol", &R::read_volume},
        {"TPOLYFILE", "TPolyFile", &R::read_polygon_file},
        {"START_CLIPGROUP", "Start_ClipGroup", &R::begin_clipping},
        {"END_CLIPGROUP", "End_ClipGroup", &R::end_clipping},
    };
    return k_objects;
}

void TachyonReader::read() {
    const std::string_view text = text_.place.text;
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
        error(scanner_.token(), "expected UTF-8, found UTF-16");
        return;
    }
    read_header();
    int until_report = 0;
    while (!scanner_.at_end() && !reading_.diagnostics.full()) {
        if (until_report-- == 0) {
            until_report = k_objects_between_reports;
            if (!reading_.diagnostics.go_on(text_.place, scanner_.offset())) return;
        }
        if (scanner_.accept("END_SCENE")) break;
        read_object();
    }
    if (!scene_.shapes.empty() && !reading_.camera_given && !reading_.camera_wanted) {
        reading_.camera_wanted =
            make_diagnostic(Severity::warning, text_.place, text_.place.text.size(), 1,
                            "no `Camera`: the camera is at the origin and looks along the negative z axis");
    }
}

// A text that is included, or that follows another, need not have one.
void TachyonReader::read_header() {
    if (!scanner_.accept("BEGIN_SCENE")) {
        if (!is_further_) expected("`Begin_Scene`");
        return;
    }
    state_.has_header = true;
    const Token word = scanner_.token();
    if (!expect("RESOLUTION", "Resolution")) return;
    double width = 0, height = 0;
    if (!whole_number(width, k_picture_size) || !whole_number(height, k_picture_size)) return;
    set("size", fmt::format("{}x{}", static_cast<int>(width), static_cast<int>(height)), word);
}

void TachyonReader::read_object() {
    object_ = scanner_.token();
    is_left_out_ = false;
    for (const Object& object : objects()) {
        if (!scanner_.accept(object.upper)) continue;
        if (!(this->*object.read)()) skip_object();
        return;
    }
    if (is_binary(object_)) return;
    const std::string_view word = scanner_.word();
    std::vector<std::string_view> names;
    for (const Object& object : objects()) names.push_back(object.name);
    error(object_,
          fmt::format("expected {}, found {}{}", k_any_object, quoted(word), did_you_mean(word, names)));
    scanner_.take();
    skip_object();
}

// Skips to the next word that begins an object.
void TachyonReader::skip_object() {
    const auto is_beginning = [](std::string_view word) {
        const auto is = [&](std::string_view upper) {
            return std::equal(word.begin(), word.end(), upper.begin(), upper.end(),
                              [](char a, char b) { return TachyonScanner::upper_case(a) == b; });
        };
        for (const Object& object : objects()) {
            if (is(object.upper)) return true;
        }
        return is("END_SCENE");
    };
    while (!scanner_.at_end() && !is_beginning(scanner_.word())) scanner_.take();
}

bool TachyonReader::read_include() {
    const Token name = scanner_.token();
    if (scanner_.at_end()) return expected("the name of a file");
    const std::string file(scanner_.word());
    scanner_.take();
    include_text(reading_, text_, name, file, "tachyon");
    return true;
}

// The image itself is not used: textures that need one are refused.
bool TachyonReader::read_image() {
    if (scanner_.at_end()) return expected("the name of the image");
    scanner_.take();
    double size[3] = {};
    if (!expect("FORMAT", "Format") || !expect("RGB24", "RGB24") || !expect("RESOLUTION", "Resolution") ||
        !whole_number(size[0], k_image_size) || !whole_number(size[1], k_image_size) ||
        !whole_number(size[2], k_image_size) || !expect("ENCODING", "Encoding") || !expect("HEX", "Hex")) {
        return false;
    }
    for (double left = size[0] * size[1] * size[2]; left > 0; --left) {
        const std::string_view pixel = scanner_.word();
        const std::size_t digits = pixel.size();
        const bool is_hex = pixel.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
        if (!is_hex || (digits != 3 && digits != 6 && digits != 9 && digits != 12))
            return expected("a pixel of 3, 6, 9 or 12 hexadecimal digits");
        scanner_.take();
    }
    return true;
}

// The fields of objects that are not drawn are read, because a name among them can be any word.
bool TachyonReader::read_landscape() {
    leave_out("a random landscape (`Scape`)");
    double x = 0, y = 0;
    Vec3 center;
    return expect("RES", "Res") && number(x) && number(y) && expect("SCALE", "Scale") && number(x) &&
           number(y) && point("CENTER", "Center", center) && skip_texture();
}
bool TachyonReader::read_volume() {
    leave_out("volumes (`ScalarVol`)");
    Vec3 ignored;
    return point("MIN", "Min", ignored) && point("MAX", "Max", ignored) && point("DIM", "Dim", ignored) &&
           expect("FILE", "File") && skip_name("the name of a file") && skip_texture();
}
bool TachyonReader::read_polygon_file() {
    leave_out("a file of polygons (`TPolyFile`)");
    Vec3 ignored;
    return point("SCALE", "Scale", ignored) && point("ROT", "Rot", ignored) &&
           point("CENTER", "Center", ignored) && expect("FILE", "File") && skip_name("the name of a file") &&
           skip_texture();
}
bool TachyonReader::skip_name(std::string_view what) {
    if (scanner_.at_end()) return expected(what);
    scanner_.take();
    return true;
}
// What follows, up to End_ClipGroup, is drawn whole.
bool TachyonReader::begin_clipping() {
    draw_without(object_, "clipping planes (`Start_ClipGroup`)", "them");
    double planes = 0;
    if (!expect("NUMPLANES", "NumPlanes") || !whole_number(planes, k_clipping_planes)) return false;
    for (double left = planes; left > 0; --left) {
        Vec3 normal;
        double distance = 0;
        if (!point(normal) || !number(distance)) return false;
    }
    return true;
}
bool TachyonReader::end_clipping() { return true; }

bool TachyonReader::expect(std::string_view upper, std::string_view name) {
    return scanner_.accept(upper) || expected(fmt::format("`{}`", name));
}

bool TachyonReader::expected(std::string_view what) {
    const Token at = scanner_.token();
    if (is_binary(at)) return false;
    const std::string found =
        scanner_.at_end() ? std::string("the end of the text") : quoted(scanner_.word());
    return error(at, fmt::format("expected {}, found {}", what, found));
}

// Reading stops at a byte that no text has.
bool TachyonReader::is_binary(const Token& at) {
    const char first = at.length == 0 ? ' ' : text_.place.text[at.offset];
    if (static_cast<unsigned char>(first) >= 0x20 && first != 0x7f) return false;
    error(at, fmt::format("expected text, found the byte 0x{:02x}", static_cast<unsigned char>(first)));
    scanner_.stop();
    return true;
}

bool TachyonReader::number(double& value, const Range& range) {
    const TachyonScanner::Mark mark = scanner_.mark();
    if (!scanner_.accept_number(value)) return expected("a number");
    if (range.contains(value)) return true;
    const Token at = scanner_.token(mark);
    error(at, fmt::format("expected {}, found {}", range.text,
                          quoted(text_.place.text.substr(at.offset, at.length))));
    return true;
}

bool TachyonReader::whole_number(double& value, const Range& range) {
    const TachyonScanner::Mark mark = scanner_.mark();
    if (!scanner_.accept_number(value)) return expected(range.text);
    if (range.contains(value) && value == static_cast<double>(static_cast<std::int64_t>(value))) return true;
    const Token at = scanner_.token(mark);
    return error(at, fmt::format("expected {}, found {}", range.text,
                                 quoted(text_.place.text.substr(at.offset, at.length))));
}

// False when reading should stop. For lists: at every item.
bool TachyonReader::go_on() {
    if (reading_.memory.is_exceeded()) (void)reading_.diagnostics.go_on(text_.place, scanner_.offset());
    return !reading_.diagnostics.full();
}

bool TachyonReader::point(Vec3& v) { return number(v.x) && number(v.y) && number(v.z); }

bool TachyonReader::direction(Vec3& v) {
    const TachyonScanner::Mark mark = scanner_.mark();
    if (!point(v)) return false;
    return !is_zero(v) || error(scanner_.token(mark), "expected a direction of some length, found 0 0 0");
}

bool TachyonReader::color(Color& c) {
    return number(c.r, k_channel) && number(c.g, k_channel) && number(c.b, k_channel);
}

bool TachyonReader::error(const Token& at, std::string message) {
    reading_.diagnostics.error(text_.place, at.offset, at.length, std::move(message));
    return false;
}

void TachyonReader::warn(const Token& at, std::string message) {
    reading_.diagnostics.warn(text_.place, at.offset, at.length, std::move(message));
}

void TachyonReader::note_limit(TachyonLimit which, const Token& at) {
    std::optional<TachyonState::Place>& first = state_.limit(which);
    if (!first) first = {text_.place, at.offset, at.length};
}

// An object that is left out or an error.
void TachyonReader::leave_out(std::string_view what) {
    is_left_out_ = true;
    if (reading_.options.skip_unsupported) {
        return reading_.left_out.add(fmt::format("{} of Tachyon", what), text_.place, object_.offset,
                                     object_.length);
    }
    reading_.diagnostics.refuse(
        text_.place, object_.offset, object_.length,
        fmt::format("glint does not render {}; the option skip-unsupported leaves it out and draws the rest",
                    what));
}

// What objects have: they are drawn without it, or it is an error. pronoun: "it" or "them".
void TachyonReader::draw_without(const Token& at, std::string_view what, std::string_view pronoun) {
    if (reading_.options.skip_unsupported) {
        return reading_.diagnostics.warn_once(
            fmt::format("tachyon without {}", what), text_.place, at.offset, at.length,
            fmt::format("glint does not render {}: the objects are drawn without {}", what, pronoun));
    }
    reading_.diagnostics.refuse(
        text_.place, at.offset, at.length,
        fmt::format("glint does not render {}; the option skip-unsupported draws the objects without {}",
                    what, pronoun));
}

void set_tachyon_defaults(Scene& scene) {
    scene.unit_normals.of_vertices = false;  // Tachyon normalises them
}

void read_tachyon(LoadState& reading, const ReadText& text) {
    if (!reading.tachyon) reading.tachyon = std::make_shared<TachyonState>();
    TachyonReader(reading, text).read();
}

}  // namespace glint
