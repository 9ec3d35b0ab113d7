// SPDX-License-Identifier: Apache-2.0
#pragma once
// Collects the mistakes of a scene, and checks numbers, points, colors and the fields of items.
#include <fmt/format.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "glint/scene.h"
#include "math/transform.h"
#include "scene/fields.h"
#include "scene/mistakes.h"
#include "scene/ranges.h"
#include "scene/validate_shapes.h"

namespace glint {

class MistakeFinder {
  protected:
    MistakeFinder() = default;
    ~MistakeFinder() = default;

    /// At most 20 errors are kept.
    bool full() const { return mistakes_.size() >= 20; }

    void error(SourcePlace place, std::string message) {
        if (!full()) mistakes_.push_back({Severity::error, place, std::move(message), item_, index_});
    }

    /// Sets the item of the following errors.
    void begin(SceneItem item, std::size_t index = 0) {
        item_ = item;
        index_ = static_cast<std::uint32_t>(index);
    }

    void check(const Range& range, double x, SourcePlace place, std::string_view of, std::string_view what) {
        if (!range.contains(x))
            error(place, fmt::format("{}: {}: expected {}, found {}", of, what, range.text, x));
    }

    void check_point(Vec3 p, SourcePlace place, std::string_view of, std::string_view what) {
        if (!is_coordinate(p)) {
            error(place, fmt::format("{}: {}: expected coordinates from -1e12 to 1e12, found {}", of, what,
                                     text(p)));
        }
    }

    void check_direction(Vec3 v, SourcePlace place, std::string_view of, std::string_view what) {
        check_point(v, place, of, what);
        if (is_zero(v)) error(place, fmt::format("{}: {}: expected a direction, found (0, 0, 0)", of, what));
    }

    void check_color(const Range& range, Color c, SourcePlace place, std::string_view of,
                     std::string_view what) {
        if (!range.contains(c.r) || !range.contains(c.g) || !range.contains(c.b)) {
            error(place, fmt::format("{}: {}: expected each channel to be {}, found ({}, {}, {})", of, what,
                                     range.text, c.r, c.g, c.b));
        }
    }

    /// The valid values of fields, by type.
    struct ValueCheck {
        MistakeFinder& finder;
        SourcePlace place;
        std::string_view of, label;
        void operator()(const NumberType& type, double x) const {
            finder.check(type.range, x, place, of, label);
        }
        void operator()(const WholeType& type, std::int32_t n) const {
            finder.check(type.range, n, place, of, label);
        }
        template <class Choice> void operator()(const ChoiceType& type, Choice choice) const {
            if (static_cast<std::size_t>(choice) >= type.words.size())
                finder.error(place, fmt::format("{}: {}: expected one of {}, found number {}", of, label,
                                                fmt::join(type.words, ", "), static_cast<int>(choice)));
        }
        void operator()(TextureType, std::uint32_t) const {}  // check_texture_index()
        void operator()(UvMapType, const UvMap& map) const {
            for (const double x : numbers_of(map)) finder.check(k_coordinate, x, place, of, label);
        }
        void operator()(BoolType, bool) const {}
        void operator()(PointType, Vec3 p) const { finder.check_point(p, place, of, label); }
        void operator()(DirectionType, Vec3 d) const { finder.check_direction(d, place, of, label); }
        void operator()(const ColorType& type, Color c) const {
            finder.check_color(type.range, c, place, of, label);
        }
        void operator()(AttenuationType, const Attenuation& a) const {
            for (const double c : numbers_of(a)) finder.check(k_attenuation, c, place, of, label);
            if (a == Attenuation{0, 0, 0})
                finder.error(place, fmt::format("{}: {}: expected one of its numbers to be > 0", of, label));
        }
    };

    template <class Item>
    void check_fields(std::span<const ItemField<Item>> fields, const Item& item, SourcePlace place,
                      std::string_view of) {
        for (const ItemField<Item>& field : fields) {
            if (applies(field, item)) visit_field(field, item, ValueCheck{*this, place, of, field.label});
        }
    }

    void add(Mistake mistake) { mistakes_.push_back(std::move(mistake)); }
    bool has_mistakes() const { return !mistakes_.empty(); }
    std::vector<Mistake> take() { return std::move(mistakes_); }

    /// The name of an item in messages: `light 3`, `light 'sun'`.
    static std::string item(std::string_view word, std::uint32_t i, std::string_view name) {
        return name.empty() ? fmt::format("{} {}", word, std::uint64_t{i} + 1)
                            : fmt::format("{} {}", word, quoted(name));
    }

  private:
    SceneItem item_ = SceneItem::none;  // the item being checked
    std::uint32_t index_ = 0;
    std::vector<Mistake> mistakes_;
};

}  // namespace glint
