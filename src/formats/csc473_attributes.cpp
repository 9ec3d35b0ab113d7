// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/csc473.h"
#include "formats/povray_keywords.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr Field k_attributes[] = {{"pigment"}, {"finish"}, {"translate"}, {"rotate"}, {"scale"}};
constexpr std::string_view k_attribute_names[] = {"pigment", "finish", "translate", "rotate", "scale"};

constexpr Range k_roughness{0, 1e6, true, false, "a number > 0 and at most 1e6"};
struct FinishRow {
    double PovFinish::*value;
    Range range;
};
constexpr Field k_finish[] = {{"ambient"},    {"diffuse"},    {"specular"}, {"roughness"},
                              {"reflection"}, {"refraction"}, {"ior"}};
constexpr std::string_view k_finish_names[] = {"ambient",    "diffuse",    "specular", "roughness",
                                               "reflection", "refraction", "ior"};
constexpr FinishRow k_finish_rows[] = {
    {&PovFinish::ambient, k_channel},        {&PovFinish::diffuse, k_channel},
    {&PovFinish::specular, k_channel},       {&PovFinish::roughness, k_roughness},
    {&PovFinish::reflection, k_fraction},    {&PovFinish::refraction, k_channel},
    {&PovFinish::ior, k_index_of_refraction}};

template <std::size_t N> bool knows(const std::string_view (&names)[N], std::string_view name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

// <a, b, c>, or <a, b, c, d> with the fourth from 0 to 1. Files of the course also have `rgbf` with three.
bool read_numbers(Parser& p, double* values, int count, const Range& range) {
    const std::string_view how_many = count == 3 ? "three" : "four";
    if (!p.accept('<')) {
        const Token at = p.token();
        if (at.kind == TokenKind::word || at.kind == TokenKind::number) {
            p.error(at, fmt::format("expected `<` and {} numbers, found {}: names and single numbers for "
                                    "vectors are of POV-Ray's own language",
                                    how_many, p.describe(at)));
        } else {
            p.expected(fmt::format("`<` and {} numbers", how_many));
        }
        return false;
    }
    for (int i = 0; i < count; ++i) {
        if (i == 3 && p.token().is('>')) {
            p.warn(p.token(), "three numbers of four: the filter is 0");
            break;
        }
        if (i > 0 && !p.accept(',')) {
            p.expected(fmt::format("`,` and {} numbers in all", how_many));
            return false;
        }
        if (!p.number(values[i], i < 3 ? range : k_fraction)) return false;
    }
    if (p.accept('>')) return true;
    p.expected(fmt::format("`>` after {} numbers", how_many));
    return false;
}

bool read_pigment(Parser& p, PovColor& pigment) {
    if (!p.expect('{')) return false;
    if (!read_pov_color(p, pigment)) {
        p.skip_to_close('}');
    } else if (!p.accept('}')) {
        refuse_word(p, "`}` after the color", {});
        p.skip_to_close('}');
    }
    return true;
}

bool read_finish(Parser& p, PovAttributes& attributes) {
    if (!p.expect('{')) return false;
    attributes.finish = PovFinish();
    FieldSet keys("finish", k_finish);
    while (!p.accept('}')) {
        const Token key = p.token();
        const auto name = p.text(key);
        if (!knows(k_finish_names, name)) {
            refuse_word(p,
                        "`ambient`, `diffuse`, `specular`, `roughness`, `reflection`, `refraction`, `ior` or "
                        "`}`",
                        k_finish_names);
            p.skip_to_close('}');
            return true;
        }
        p.take();
        const FinishRow& row = k_finish_rows[p.field(keys, key, name)];
        if (name == "refraction") attributes.refraction = key;
        if (!p.number(attributes.finish.*row.value, row.range)) {
            p.skip_to_close('}');
            return true;
        }
        p.accept(',');
    }
    return true;
}

// translate <v>, rotate <degrees about x, then y, then z>, scale <v> or scale number.
bool read_map(Parser& p, std::string_view name, const Token& key, std::optional<Affine>& map) {
    Vec3 v;
    if (name == "scale" && p.token().kind == TokenKind::number) {
        if (!p.number(v.x, k_coordinate)) return false;
        v.y = v.z = v.x;
    } else if (!read_pov_vector(p, v)) {
        return false;
    }
    Affine step;
    if (name == "translate") step = translation(v);
    if (name == "rotate") step = compose(rotation_z(v.z), compose(rotation_y(v.y), rotation_x(v.x)));
    if (name == "scale") {
        if (v.x == 0 || v.y == 0 || v.z == 0) {
            p.error(key, "expected a scale without 0, which would leave nothing of the shape");
            return true;
        }
        step = scaling(v);
    }
    map = map ? compose(step, *map) : step;
    return true;
}

}  // namespace

void refuse_word(Parser& p, std::string_view expected, std::span<const std::string_view> known) {
    const Token token = p.token();
    const auto name = p.text(token);
    const bool is_word = token.kind == TokenKind::word;
    const auto meaning = is_word ? povray_meaning(name) : std::string_view();
    if (!meaning.empty()) {
        p.error(token, fmt::format("`{}` ({}) is of POV-Ray's own language; of it glint reads what CSC 473 "
                                   "uses: expected {}",
                                   name, meaning, expected));
    } else if (is_word) {
        p.error(token,
                fmt::format("expected {}, found {}{}", expected, quoted(name), did_you_mean(name, known)));
    } else {
        p.expected(expected);
    }
}

bool read_pov_vector(Parser& p, Vec3& value) {
    double v[3] = {};
    if (!read_numbers(p, v, 3, k_coordinate)) return false;
    value = {v[0], v[1], v[2]};
    return true;
}

bool read_pov_color(Parser& p, PovColor& color) {
    constexpr std::string_view kinds[] = {"color", "rgb", "rgbf"};
    if (p.text(p.token()) == "color") p.take();
    const auto kind = p.text(p.token());
    if (kind != "rgb" && kind != "rgbf") {
        refuse_word(p, "`rgb` or `rgbf`", kinds);
        return false;
    }
    p.take();
    double values[4] = {0, 0, 0, 0};
    if (!read_numbers(p, values, kind == "rgb" ? 3 : 4, k_channel)) return false;
    color = {{values[0], values[1], values[2]}, values[3]};
    return true;
}

bool read_pov_attributes(Parser& p, std::string_view what, PovAttributes& attributes) {
    FieldSet keys(what, k_attributes);
    while (!p.accept('}')) {
        const Token key = p.token();
        const auto name = p.text(key);
        if (!knows(k_attribute_names, name)) {
            refuse_word(p, "`pigment`, `finish`, `translate`, `rotate`, `scale` or `}`", k_attribute_names);
            return false;
        }
        p.take();
        const bool is_map = name != "pigment" && name != "finish";
        if (!is_map) p.field(keys, key, name);
        const bool ok = is_map             ? read_map(p, name, key, attributes.map)
                        : name == "finish" ? read_finish(p, attributes)
                                           : read_pigment(p, attributes.pigment);
        if (!ok) return false;
        p.accept(',');
    }
    return true;
}

}  // namespace glint
