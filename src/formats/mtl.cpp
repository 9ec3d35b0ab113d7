// SPDX-License-Identifier: Apache-2.0
#include "formats/mtl.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "formats/line_reader.h"
#include "math/number.h"
#include "scene/ranges.h"

namespace glint {
namespace {

constexpr double k_last_illum = 10;

template <std::size_t N> bool is_in(const std::string_view (&words)[N], std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

// The statements of one material.
struct MtlStatements {
    std::optional<Color> ka, kd, ks, ke;
    double ns = Material{}.shininess, ni = 1;
    std::optional<double> d, tr;
    std::optional<MtlMap> map_kd, map_d;
    int illum = 2;

    bool is_mirror() const { return illum >= 3 && illum <= 9; }
    bool is_glass() const { return illum == 4 || illum == 6 || illum == 7 || illum == 9; }
    // Tr has been written as 1 - d and as d: d counts if both are there.
    double transparency() const { return d ? 1 - *d : tr.value_or(0); }

    Material material() const {
        Material m;
        m.color = m.diffuse = kd.value_or(map_kd ? Color{1, 1, 1} : m.color);
        m.ambient = ka.value_or(m.diffuse);
        m.shininess = ns;
        m.emission = ke.value_or(Color{});
        if (illum >= 2) m.specular = ks.value_or(Color{});
        if (illum == 0) {
            m.emission = m.emission + m.diffuse;
            m.ambient = m.diffuse = {};
        }
        const double greatest = number::max(m.specular.r, number::max(m.specular.g, m.specular.b));
        if (is_mirror() && greatest > 0) {
            m.mirror = number::min(greatest, 1.0);
            m.mirror_tint = m.specular * (1 / greatest);
        }
        (is_glass() ? m.transmission : m.transmit) = transparency();
        if (is_glass()) m.ior = ni;
        return m;
    }
};

class MtlReader : LineReader {
  public:
    MtlReader(LoadState& reading, const ReadText& text, MtlMaterials& materials)
        : LineReader(reading, text.place, LineWords::Syntax::wavefront, "line"),
          text_(text),
          materials_(materials) {}

    void read() {
        for (int lines = 1; words_.next_line(); ++lines) {
            const std::string_view word = words_.next();
            if (!word.empty()) statement(word);
            if (lines % 4096 == 0 && !reading_.diagnostics.go_on(where_, words_.offset())) return;
        }
        finish();
    }

  private:
    void statement(std::string_view word) {
        if (word == "newmtl") return begin();
        if (!name_) {
            expected("`newmtl`");
        } else if (word == "Ka") {
            color(now_.ka);
        } else if (word == "Kd") {
            color(now_.kd);
        } else if (word == "Ks") {
            color(now_.ks);
        } else if (word == "Ke") {
            color(now_.ke);
        } else if (word == "Ns") {
            number(now_.ns, k_exponent);
        } else if (word == "Ni") {
            index_of_refraction();
        } else if (word == "d") {
            opacity(now_.d);
        } else if (word == "Tr") {
            opacity(now_.tr);
        } else if (word == "illum") {
            illum();
        } else if (word == "map_Kd") {
            texture(now_.map_kd);
        } else if (word == "map_d") {
            texture(now_.map_d);
        } else if (word == "Tf") {
            filter();
        } else {
            ignore(word);
        }
    }

    void begin() {
        finish();
        place_ = {words_.line(), 1, text_.file};
        if (words_.rest().empty()) {
            expected("the name of the material");
        } else {
            name_ = std::string(words_.found());
            if (materials_.contains(*name_))
                warn_once("mtl again",
                          fmt::format("material {} is defined again: the last one counts", quoted(*name_)));
        }
    }
    void finish() {
        if (name_) materials_[*name_] = {now_.material(), now_.map_kd, now_.map_d, place_};
        name_.reset();
        now_ = {};
    }

    bool number(double& value, const Range& range) {
        words_.next();
        return number_of_word(value, range);
    }
    bool number_of_word(double& value, const Range& range) {
        double read = 0;
        if (!read_number_word(words_.found(), read) || !range.contains(read)) return expected(range.text);
        value = read;
        return true;
    }
    // Three numbers; one stands for three.
    void color(std::optional<Color>& to) {
        Color c;
        const std::string_view word = words_.next();
        if (word == "spectral" || word == "xyz") {
            warn_once("mtl spectral", "glint reads colors as r, g, b only: this one is left out");
            return;
        }
        if (!number_of_word(c.r, k_tint)) return;
        c.g = c.b = c.r;
        if (!words_.next().empty() && (!number_of_word(c.g, k_tint) || !number(c.b, k_tint))) return;
        to = c;
    }
    void index_of_refraction() {
        double value = 1;
        constexpr Range range{0, k_index_of_refraction.max, false, false, "a number from 0 to 1e6"};
        if (number(value, range)) now_.ni = value > 0 ? value : 1;
    }
    void opacity(std::optional<double>& to) {
        double value = 1;
        if (words_.next() == "-halo") {
            warn_once("mtl halo", "glint ignores `-halo`: the opacity is the same at all angles");
            words_.next();
        }
        if (number_of_word(value, k_fraction)) to = value;
    }
    void illum() {
        double value = 0;
        constexpr Range range{0, k_last_illum, false, false, "a whole number from 0 to 10"};
        if (!number(value, range)) return;
        now_.illum = static_cast<int>(value);
        if (static_cast<double>(now_.illum) != value) expected(range.text);
    }
    void filter() {
        std::optional<Color> c;
        color(c);
        if (c && *c != Color{1, 1, 1})
            warn_once("mtl Tf", "glint ignores `Tf`: what is behind a transparent surface is not tinted");
    }

    void texture(std::optional<MtlMap>& map) {
        const std::string wanted = read_mtl_map(words_, text_.file, map.emplace());
        if (wanted.empty()) return;
        map.reset();
        expected(wanted);
    }

    void ignore(std::string_view word) {
        constexpr std::string_view textures[] = {"bump", "disp", "decal", "refl", "norm"};
        if (word.starts_with("map_") || is_in(textures, word)) {
            warn_once("mtl textures",
                      fmt::format("glint ignores {}: only `map_Kd` and `map_d` are drawn", quoted(word)));
        } else {
            warn_once("mtl other", fmt::format("glint ignores {} in materials", quoted(word)));
        }
    }

    const ReadText& text_;
    MtlMaterials& materials_;
    std::optional<std::string> name_;  // of the material that is being read
    SourcePlace place_;
    MtlStatements now_;
};

}  // namespace

std::vector<std::string_view> library_names(std::string_view names) {
    std::vector<std::string_view> all;
    while (!names.empty()) {
        std::size_t end = 0;
        do {
            end = std::min(names.find_first_of(" \t", end + 1), names.size());
        } while (end < names.size() && !names.substr(0, end).ends_with(k_mtl_extension));
        all.push_back(names.substr(0, end));
        names.remove_prefix(std::min(names.find_first_not_of(" \t", end), names.size()));
    }
    return all;
}

void read_mtl(LoadState& reading, const ReadText& text, MtlMaterials& materials) {
    MtlReader(reading, text, materials).read();
}

}  // namespace glint
