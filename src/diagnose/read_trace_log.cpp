// SPDX-License-Identifier: Apache-2.0
// Reads the log of a ray tracer: keys, each followed by its values. JSON lines have the same tokens.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

#include "base/sort_stably.h"
#include "base/text.h"
#include "diagnose/log_keys.h"
#include "diagnose/log_line.h"
#include "diagnose/trace_log.h"

namespace glint {
namespace {

constexpr std::size_t k_max_rays = 4'000'000, k_max_pixel_rays = 20'000, k_max_pixels = 1'000'000,
                      k_max_lights = 4096;

class LogReader {
  public:
    LogReader(InputText text, Diagnostics& diagnostics) : text_(text), diagnostics_(diagnostics) {}

    TraceLog read() {
        log_.is_printrays = is_printrays(text_.text);
        std::string_view rest = text_.text;
        if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
        while (!rest.empty() && diagnostics_.go_on(text_, start_)) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            start_ = static_cast<std::size_t>(rest.data() - text_.text.data());
            is_cut_ = end == rest.size();
            ++line_;
            read_line(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        finish_pixel();
        digits_.set_errors(log_);
        return std::move(log_);
    }

  private:
    void read_line(std::string_view line) {
        std::string translated;
        if (log_.is_printrays) {
            translated = translate_printrays(line);
            line = translated;
        }
        std::vector<LogItem> items =
            split_items(line, [](std::string_view name) { return takes_word(name); });
        // JSON does not order the members of an object.
        if (!items.empty() && line[line.find_first_not_of(" \t\r")] == '{')
            sort_stably(items, [](const LogItem& a, const LogItem& b) { return rank(a) < rank(b); });
        // Its last value may be cut, too.
        if (is_cut_ && !items.empty()) {
            item_ = &items.back();
            place_ = log_.is_printrays ? start_ : start_ + item_->offset;
            diagnostics_.warn(text_, place_, item_->key.size(),
                              "the log does not end with a newline: its last value is left out");
            items.pop_back();
        }
        for (const LogItem& item : items) {
            item_ = &item;
            place_ = log_.is_printrays ? start_ : start_ + item.offset;
            read_item(item);
        }
    }

    static bool takes_word(std::string_view name) {
        const LogKey* key = find_key(name);
        return key != nullptr &&
               (key->use == KeyUse::ray || key->use == KeyUse::light || key->use == KeyUse::shape ||
                key->use == KeyUse::rows || key->use == KeyUse::end);
    }
    static int rank(const LogItem& item) {
        const LogKey* key = find_key(item.key);
        if (key == nullptr) return 4;
        return key->use == KeyUse::pixel   ? 0
               : key->use == KeyUse::ray   ? 1
               : key->use == KeyUse::light ? 2
                                           : 3;
    }

    void error(std::string message) {
        diagnostics_.error(text_, place_, item_->key.size(), std::move(message));
    }
    bool fail(std::string message) {  // false
        error(std::move(message));
        return false;
    }

    void read_item(const LogItem& item) {
        const LogKey* key = find_key(item.key);
        if (key == nullptr) {
            const std::string_view near = nearest_key(item.key);
            diagnostics_.warn_once(
                item.key, text_, place_, item.key.size(),
                fmt::format("the key {} is unknown and is skipped{}", glint::quoted(item.written),
                            near.empty() ? "" : fmt::format("; did you mean `{}`?", near)));
            return;
        }
        if (is_skipped(key->use)) return;
        switch (key->use) {
            case KeyUse::size:
                return read_size();
            case KeyUse::rows:
                if (item.word != "top" && item.word != "bottom")
                    return error(fmt::format("expected `rows top` or `rows bottom`, found {}",
                                             glint::quoted(item.word)));
                log_.rows_from_bottom = item.word == "bottom";
                return;
            case KeyUse::colors:
                if (item.numbers.size() != 1 || (item.numbers[0].v != 1 && item.numbers[0].v != 255))
                    return error("expected `colors 1` or `colors 255`");
                log_.white = item.numbers[0].v;
                return;
            case KeyUse::pixel:
                if (!read_pixel()) skipped_ = Skipped::pixel;
                return;
            case KeyUse::ray:
                if (!read_ray()) skipped_ = Skipped::ray;
                return;
            case KeyUse::light:
                return read_light();
            case KeyUse::end:
                return read_end();
            case KeyUse::miss:
                if (in_shadow_ray_ || (!item.numbers.empty() && item.numbers[0].v == 0)) return;
                if (LoggedRay* ray = open_ray()) ray->is_miss = true, add(*ray, Quantity::hit, {});
                return;
            case KeyUse::shape:
                return read_shape();
            case KeyUse::visible:
                if (!has_count(1)) return;
                if (LoggedLight* light = open_light())
                    add(*light, Quantity::blocked,
                        {std::isnan(item.numbers[0].v) ? item.numbers[0].v
                         : item.numbers[0].v == 0      ? 1.0
                                                       : 0.0,
                         {},
                         {}});
                return;
            case KeyUse::color:
                return read_values(ray_ >= 0           ? Quantity::color
                                   : log_.is_printrays ? Quantity::bytes
                                                       : Quantity::pixel_color);
            case KeyUse::diffuse:
                return read_values(light_ >= 0 ? Quantity::diffuse : Quantity::diffuse_sum);
            case KeyUse::specular:
                return read_values(light_ >= 0 ? Quantity::specular : Quantity::specular_sum);
            case KeyUse::none:
                return read_values(key->quantity);
        }
    }

    // After a pixel or ray that cannot be read, what belongs to it is skipped without a message.
    bool is_skipped(KeyUse use) {
        if (use == KeyUse::pixel) skipped_ = Skipped::none;
        if (skipped_ == Skipped::ray && (use == KeyUse::ray || use == KeyUse::end)) {
            skipped_ = Skipped::none;
            return use == KeyUse::end;
        }
        return skipped_ != Skipped::none;
    }

    bool has_count(std::size_t count) {
        if (item_->numbers.size() == count) return true;
        error(fmt::format("expected {} after {}, found {}",
                          count == 1 ? "a number" : fmt::format("{} numbers", count),
                          glint::quoted(item_->written), item_->numbers.size()));
        return false;
    }

    void read_size() {
        if (!has_count(2)) return;
        for (std::size_t i = 0; i < 2; ++i) {
            const double side = item_->numbers[i].v;
            if (!(side >= 1 && side <= k_max_size))
                return error(fmt::format("expected a size of 1 to {} pixels", k_max_size));
        }
        log_.size = {static_cast<std::int32_t>(item_->numbers[0].v),
                     static_cast<std::int32_t>(item_->numbers[1].v)};
    }

    bool read_pixel() {
        if (item_->numbers.size() != 2 && item_->numbers.size() != 3)
            return fail(fmt::format("expected `pixel X Y`, found {} numbers", item_->numbers.size()));
        for (const LogNumber& n : item_->numbers)
            if (!(n.v >= 0 && n.v < k_max_size))
                return fail(fmt::format("expected a pixel from 0 to {}", k_max_size - 1));
        finish_pixel();
        if (log_.pixels.size() == k_max_pixels)
            return fail(fmt::format("a log has at most {} pixels", k_max_pixels));
        number_index_.clear();
        LoggedPixel& pixel = log_.pixels.emplace_back();
        pixel.line = line_;
        pixel.x = static_cast<std::int32_t>(item_->numbers[0].v);
        pixel.y = static_cast<std::int32_t>(item_->numbers[1].v);
        if (item_->numbers.size() == 3) pixel.sample = static_cast<std::int32_t>(item_->numbers[2].v);
        ray_ = light_ = -1;
        in_shadow_ray_ = false;
        return true;
    }

    // A program that follows a ray in a loop has no place for `end`: its only color, after the last ray, is
    // that of the pixel.
    void finish_pixel() {
        if (log_.pixels.empty()) return;
        LoggedPixel& pixel = log_.pixels.back();
        if (log_.is_printrays) find_parents(pixel);
        const auto has_color = [](const LoggedRay& ray) { return ray.find(Quantity::color) != nullptr; };
        const bool is_loop = pixel.rays.size() > 1 && pixel.rays.back().number < 0 &&
                             ends_ < pixel.rays.size() && pixel.find(Quantity::pixel_color) == nullptr &&
                             std::count_if(pixel.rays.begin(), pixel.rays.end(), has_color) == 1;
        ends_ = 0;
        if (!is_loop || has_color(pixel.rays.front())) return;
        LoggedRay& ray = *std::find_if(pixel.rays.begin(), pixel.rays.end(), has_color);
        const auto value = std::find_if(ray.list.begin(), ray.list.end(),
                                        [](const LoggedValue& v) { return v.quantity == Quantity::color; });
        // Of a ray whose parent has no color, but that is logged after all rays.
        if (value->line < pixel.rays.back().line) return;
        LoggedValue moved = *value;
        moved.quantity = Quantity::pixel_color;
        ray.list.erase(value);
        pixel.list.push_back(moved);
        digits_.merge(Quantity::color, Quantity::pixel_color);
    }

    // printrays does not say which hit a ray starts from: it is the one that is nearest to its origin.
    static void find_parents(LoggedPixel& pixel) {
        for (std::size_t i = 0; i < pixel.rays.size(); ++i) {
            LoggedRay& ray = pixel.rays[i];
            const auto origin = ray.vector(Quantity::origin);
            ray.parent = -1;
            double least = 0;
            for (std::size_t k = 0; k < i && ray.kind != LoggedRayKind::camera; ++k) {
                const auto hit = pixel.rays[k].vector(Quantity::point);
                if (!hit) continue;
                const double away = origin ? length(*hit - *origin).v : 0;
                if (ray.parent >= 0 && away >= least) continue;
                ray.parent = static_cast<std::int32_t>(k), least = away;
            }
            ray.generation =
                ray.parent >= 0 ? pixel.rays[static_cast<std::size_t>(ray.parent)].generation + 1 : 0;
            if (ray.parent < 0) ray.kind = LoggedRayKind::camera;
        }
    }

    LoggedPixel* open_pixel() {
        if (!log_.pixels.empty()) return &log_.pixels.back();
        error(fmt::format("expected `pixel X Y` before {}", glint::quoted(item_->written)));
        return nullptr;
    }
    LoggedRay* open_ray() {
        LoggedPixel* pixel = open_pixel();
        if (pixel == nullptr) return nullptr;
        if (ray_ >= 0) return &pixel->rays[static_cast<std::size_t>(ray_)];
        error(fmt::format("expected `ray camera` before {}", glint::quoted(item_->written)));
        return nullptr;
    }
    LoggedLight* open_light() {
        LoggedRay* ray = open_ray();
        if (ray == nullptr) return nullptr;
        if (light_ >= 0) return &ray->lights[static_cast<std::size_t>(light_)];
        error(fmt::format("expected `light NUMBER` before {}", glint::quoted(item_->written)));
        return nullptr;
    }

    bool read_ray() {
        LoggedPixel* pixel = open_pixel();
        if (pixel == nullptr) return false;
        const std::string& kind = item_->word;
        const auto find_number = [&](double number) -> std::int32_t {
            if (!(number >= 0 && number < 1e9)) return -1;
            const auto at = number_index_.find(static_cast<std::int32_t>(number));
            return at != number_index_.end() ? at->second : -1;
        };
        if (kind.empty()) {
            if (!has_count(1)) return false;
            const std::int32_t found = find_number(item_->numbers[0].v);
            if (found < 0) return fail(fmt::format("this pixel has no ray {} so far", item_->numbers[0].v));
            ray_ = found, light_ = -1;
            in_shadow_ray_ = false;
            return true;
        }
        if (kind == "shadow") {
            if (open_light() == nullptr) return false;
            in_shadow_ray_ = true;
            return true;
        }
        LoggedRay ray;
        ray.line = line_;
        if (kind == "camera" || kind == "primary" || kind == "eye") {
            ray.kind = LoggedRayKind::camera;
        } else if (kind == "mirror" || kind == "reflection" || kind == "reflected") {
            ray.kind = LoggedRayKind::mirror;
        } else if (kind == "glass" || kind == "refraction" || kind == "refracted" || kind == "transmitted") {
            ray.kind = LoggedRayKind::glass;
        } else {
            return fail(fmt::format("expected `camera`, `mirror`, `glass` or `shadow` after `ray`, found {}",
                                    glint::quoted(kind)));
        }
        if (++rays_ > k_max_rays || pixel->rays.size() >= k_max_pixel_rays)
            return fail(
                fmt::format("a pixel has at most {} rays, and a log {}", k_max_pixel_rays, k_max_rays));
        if (ray.kind != LoggedRayKind::camera) ray.parent = ray_;
        const std::vector<LogNumber>& numbers = item_->numbers;
        if (!numbers.empty()) {
            if (!(numbers[0].v >= 0 && numbers[0].v < 1e9))
                return fail("expected a ray's number from 0 to 999999999");
            if (find_number(numbers[0].v) >= 0)
                return fail(fmt::format("this pixel has a ray {} already", numbers[0].v));
            ray.number = static_cast<std::int32_t>(numbers[0].v);
        }
        if (numbers.size() > 1 && numbers[1].v >= 0) {
            ray.parent = find_number(numbers[1].v);
            if (ray.parent < 0)
                return fail(fmt::format("the parent, ray {}, is not among the rays before", numbers[1].v));
        }
        if (ray.kind != LoggedRayKind::camera && ray.parent < 0 && !log_.is_printrays)
            return fail(fmt::format(
                "a {} ray starts from the hit of another ray: expected `ray camera` before", kind));
        if (ray.parent >= 0)
            ray.generation = pixel->rays[static_cast<std::size_t>(ray.parent)].generation + 1;
        if (ray.generation > k_max_reflections)
            return fail(fmt::format("at most {} rays may follow each other: is an `end` missing?",
                                    k_max_reflections));
        if (ray.number >= 0) number_index_.emplace(ray.number, static_cast<std::int32_t>(pixel->rays.size()));
        pixel->rays.push_back(std::move(ray));
        ray_ = static_cast<std::int32_t>(pixel->rays.size()) - 1, light_ = -1;
        in_shadow_ray_ = false;
        return true;
    }

    /// The labels of lights or shapes, by their text.
    using LabelIndex = std::unordered_map<std::string, std::uint32_t>;

    std::uint32_t label(std::vector<LogLabel>& labels, LabelIndex& index) {
        LogLabel wanted;
        if (item_->word.empty() && !item_->numbers.empty()) {
            wanted.number = static_cast<std::int64_t>(std::clamp(item_->numbers[0].v, -1e9, 1e9));
            wanted.text = fmt::format("{}", *wanted.number);
        } else {
            wanted.text = item_->word;
        }
        const auto [at, is_new] = index.emplace(wanted.text, static_cast<std::uint32_t>(labels.size()));
        if (is_new) labels.push_back(std::move(wanted));
        return at->second;
    }

    void read_light() {
        LoggedRay* ray = open_ray();
        if (ray == nullptr) return;
        in_shadow_ray_ = false;
        if (item_->word == "none") {
            light_ = -1;
            return;
        }
        if (item_->word.empty() && item_->numbers.size() != 1)
            return error("expected `light NUMBER` or `light NAME`");
        if (item_->word.empty() && !std::isfinite(item_->numbers[0].v))
            return error("expected a light's number");
        if (ray->lights.size() >= k_max_lights)
            return error(fmt::format("a hit has at most {} lights", k_max_lights));
        const std::uint32_t wanted = label(log_.light_labels, light_index_);
        const auto same = std::find_if(ray->lights.begin(), ray->lights.end(),
                                       [&](const LoggedLight& l) { return l.label == wanted; });
        light_ = static_cast<std::int32_t>(same - ray->lights.begin());
        if (same != ray->lights.end()) return;
        LoggedLight& light = ray->lights.emplace_back();
        light.line = line_;
        light.label = wanted;
    }

    void read_shape() {
        LoggedRay* ray = open_ray();
        if (ray == nullptr || in_shadow_ray_) return;
        if (item_->word.empty() && item_->numbers.size() != 1)
            return error("expected `shape NUMBER` or `shape NAME`");
        if (item_->word.empty() && !std::isfinite(item_->numbers[0].v))
            return error("expected a shape's number");
        const bool is_none = item_->word == "none" || (item_->word.empty() && item_->numbers[0].v < 0);
        if (is_none) {
            ray->is_miss = true;
        } else {
            ray->shape = label(log_.shape_labels, shape_index_);
        }
        add(*ray, Quantity::hit, {});
    }

    void read_end() {
        if (in_shadow_ray_) {
            in_shadow_ray_ = false;
            return;
        }
        LoggedPixel* pixel = open_pixel();
        if (pixel == nullptr) return;
        if (item_->word == "light") {
            light_ = -1;
            return;
        }
        if (ray_ < 0) return;  // of the pixel
        ++ends_;
        ray_ = pixel->rays[static_cast<std::size_t>(ray_)].parent, light_ = -1;
    }

    void read_values(Quantity quantity) {
        const QuantityInfo& info = info_of(quantity);
        const bool is_one = info.kind == QuantityKind::number || info.kind == QuantityKind::flag;
        const std::vector<LogNumber>& numbers = item_->numbers;
        const bool is_grey = info.kind == QuantityKind::color && numbers.size() == 1;
        if (!is_grey && !has_count(is_one ? 1 : 3)) return;
        if (in_shadow_ray_ && info.of == QuantityOf::ray) {
            if (quantity <= Quantity::inside) return;  // of the shadow ray
            in_shadow_ray_ = false;
        }
        LoggedValues* of = info.of == QuantityOf::pixel ? static_cast<LoggedValues*>(open_pixel())
                           : info.of == QuantityOf::ray ? static_cast<LoggedValues*>(open_ray())
                                                        : static_cast<LoggedValues*>(open_light());
        if (of == nullptr) return;
        ApproxVec value(numbers[0].v, numbers[is_one || is_grey ? 0 : 1].v,
                        numbers[is_one || is_grey ? 0 : 2].v);
        if (info.kind == QuantityKind::flag && std::isfinite(numbers[0].v))
            value.x = numbers[0].v != 0 ? 1 : 0;
        for (const LogNumber& n : numbers) digits_.add(quantity, n);
        add(*of, quantity, value);
    }

    void add(LoggedValues& of, Quantity quantity, const ApproxVec& value) {
        if (of.find(quantity) != nullptr)
            return error(fmt::format("{} is given twice", glint::quoted(item_->written)));
        of.list.push_back({quantity, line_, value});
        ++log_.values;
    }

    InputText text_;
    Diagnostics& diagnostics_;
    TraceLog log_;
    LogDigits digits_;
    const LogItem* item_ = nullptr;
    std::size_t start_ = 0, place_ = 0, rays_ = 0;
    LabelIndex light_index_, shape_index_;
    std::unordered_map<std::int32_t, std::int32_t> number_index_;  // of the pixel's rays that have numbers
    std::size_t ends_ = 0;
    std::uint32_t line_ = 0;
    std::int32_t ray_ = -1, light_ = -1;
    bool in_shadow_ray_ = false, is_cut_ = false;
    enum class Skipped : std::uint8_t { none, ray, pixel } skipped_ = Skipped::none;
};

}  // namespace

TraceLog read_trace_log(InputText text, Diagnostics& diagnostics) {
    return LogReader(text, diagnostics).read();
}

}  // namespace glint
