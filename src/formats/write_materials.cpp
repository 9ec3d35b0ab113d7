// SPDX-License-Identifier: Apache-2.0
#include "formats/write_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

namespace glint {
namespace {

// All that a material is, as bits.
std::array<std::uint64_t, 22> bits_of(const Material& m) {
    std::array<std::uint64_t, 22> bits{};
    std::size_t n = 0;
    for (const Color& c : {m.color, m.ambient, m.diffuse, m.specular, m.mirror_tint, m.transmission_tint}) {
        for (const double x : {c.r, c.g, c.b}) bits[n++] = std::bit_cast<std::uint64_t>(x);
    }
    for (const double x : {m.shininess, m.mirror, m.transmission, m.ior})
        bits[n++] = std::bit_cast<std::uint64_t>(x);
    return bits;
}

// c with c * color == k, bit for bit; the one with the fewest decimals.
std::optional<double> coefficient(Color color, Color k) {
    const auto gives_k = [&](double c) { return c >= 0 && c <= 1 && same_bits(color * c, k); };
    if (gives_k(0)) return 0;
    const double quotient = color.r != 0 ? k.r / color.r : color.g != 0 ? k.g / color.g : k.b / color.b;
    if (!(quotient > 0 && quotient < 2)) return std::nullopt;
    double power = 1;
    for (int decimals = 0; decimals <= 15; ++decimals, power *= 10) {
        // A whole number below 2^53 over a power of ten is the double nearest to that decimal.
        const double c = std::round(quotient * power) / power;
        if (gives_k(c)) return c;
    }
    const auto bits = std::bit_cast<std::uint64_t>(quotient);
    for (const std::uint64_t near : {bits, bits - 1, bits + 1, bits - 2, bits + 2}) {
        if (gives_k(std::bit_cast<double>(near))) return std::bit_cast<double>(near);
    }
    return std::nullopt;
}

void write_term(BlockWriter& block, Color color, Color k, std::string_view word) {
    std::string absolute, relative;
    append(absolute, k);
    const auto c = coefficient(color, k);
    if (c) append(relative, *c);
    // Many digits are no number that anyone chose.
    if (c && relative.size() <= absolute.size()) {
        block.key(word) += relative;
    } else {
        block.key(fmt::format("{}_color", word)) += absolute;
    }
}

}  // namespace

bool same_bits(const Material& a, const Material& b) { return bits_of(a) == bits_of(b); }

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(Vec3 a, Vec3 b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z); }
bool same_bits(Color a, Color b) { return same_bits(a.r, b.r) && same_bits(a.g, b.g) && same_bits(a.b, b.b); }

MaterialPlan::MaterialPlan(const Scene& scene) {
    merge_unnamed(scene);
    std::vector<std::uint32_t> uses(scene.materials.size());
    for (const Shape& shape : scene.shapes) {
        if (shape.material != k_none) ++uses[written_[shape.material]];
    }
    choose_names(scene, uses);
}

// By sorting, so that no choice of materials makes it slow.
void MaterialPlan::merge_unnamed(const Scene& scene) {
    std::vector<std::uint32_t> unnamed;
    written_.resize(scene.materials.size());
    for (std::uint32_t i = 0; i < written_.size(); ++i) {
        written_[i] = i;
        if (scene.material_texts.name(i).empty()) unnamed.push_back(i);
    }
    std::stable_sort(unnamed.begin(), unnamed.end(), [&](std::uint32_t a, std::uint32_t b) {
        return bits_of(scene.materials[a]) < bits_of(scene.materials[b]);
    });
    for (std::size_t i = 1; i < unnamed.size(); ++i) {
        const std::uint32_t before = unnamed[i - 1], after = unnamed[i];
        if (bits_of(scene.materials[before]) == bits_of(scene.materials[after]))
            written_[after] = written_[before];
    }
}

// A name that several materials have goes to the first of them that a shape has.
void MaterialPlan::choose_names(const Scene& scene, const std::vector<std::uint32_t>& uses) {
    named_.resize(uses.size());
    std::set<std::string, std::less<>> taken;
    const auto set_name = [&](std::uint32_t i, std::string text) {
        names_.push_back(std::move(text));
        named_[i] = static_cast<std::uint32_t>(names_.size());
    };
    for (const bool used : {true, false}) {
        for (std::uint32_t i = 0; i < uses.size(); ++i) {
            const auto own = scene.material_texts.name(i);
            if (own.empty() || (uses[i] > 0) != used) continue;
            if (taken.emplace(own).second) set_name(i, std::string(own));
        }
    }
    std::size_t number = 0;
    for (std::uint32_t i = 0; i < uses.size(); ++i) {
        if (named_[i] != 0 || uses[i] < 2) continue;
        std::string text;
        do {
            text = fmt::format("material_{}", ++number);
        } while (!taken.insert(text).second);
        set_name(i, std::move(text));
    }
}

std::string_view MaterialPlan::name(std::uint32_t material) const {
    const std::uint32_t named = named_[written_[material]];
    return named == 0 ? std::string_view() : std::string_view(names_[named - 1]);
}

void write_material_keys(BlockWriter& block, const Material& m) {
    const Material usual;
    append(block.key("color"), m.color);
    write_term(block, m.color, m.ambient, "ambient");
    write_term(block, m.color, m.diffuse, "diffuse");
    write_term(block, m.color, m.specular, "specular");
    const auto write = [&](std::string_view key, const auto& value, const auto& default_value) {
        if (!same_bits(value, default_value)) append(block.key(key), value);
    };
    write("shininess", m.shininess, usual.shininess);
    write("mirror", m.mirror, usual.mirror);
    write("mirror_color", m.mirror_tint, usual.mirror_tint);
    write("transmission", m.transmission, usual.transmission);
    write("transmission_color", m.transmission_tint, usual.transmission_tint);
    write("ior", m.ior, usual.ior);
}

}  // namespace glint
