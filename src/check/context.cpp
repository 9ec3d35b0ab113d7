// SPDX-License-Identifier: Apache-2.0
#include "check/context.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/diagnostics.h"
#include "base/sort_stably.h"
#include "base/text.h"
#include "check/visible_hits.h"
#include "math/number.h"

namespace glint {
namespace {

constexpr std::size_t k_max_named = 5, k_max_named_of_model = 2;
constexpr std::size_t k_max_alike = 8;  // findings of one kind
// Shapes of a scene that is written by hand, and of one that is computed by macros.
constexpr std::size_t k_by_hand = 64, k_min_computed = 24;
constexpr std::int32_t k_probe = 24;  // longest side of a picture that counts rays
constexpr double k_max_rays = 4e6;    // of a picture
constexpr double k_max_tests = 6e7;   // of rays and shapes, for a picture or a grid of rays

bool is_computed(const Scene& scene) {
    const std::size_t shapes = scene.shapes.size();
    if (shapes > k_by_hand) return true;
    if (shapes < k_min_computed || scene.shape_texts.places.empty()) return false;
    std::set<std::pair<std::uint64_t, std::uint32_t>> places;
    for (const SourcePlace& p : scene.shape_texts.places)
        places.insert({(std::uint64_t{p.file} << 32) | p.line, p.column});
    return 2 * places.size() <= shapes;
}

std::string item(std::string_view word, std::uint32_t index, std::string_view name) {
    return name.empty() ? fmt::format("{} {}", word, std::uint64_t{index} + 1)
                        : fmt::format("{} {}", word, quoted(name));
}

}  // namespace

std::string percent_text(double share) {
    const double percent = 100 * share;
    // Two digits of 99.7 would be "1e+02", and those of small numbers "2e-05".
    if (percent >= 99.5) return "100%";
    return percent < 0.001 && percent > 0 ? "less than 0.001%" : fmt::format("{:.2g}%", percent);
}

std::string vector_text(Vec3 v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

SmallSize small_size(const RenderSettings& settings, std::int32_t longest) {
    const std::int64_t most = std::max(settings.width, settings.height);
    if (most <= longest) return {settings.width, settings.height};
    const auto scaled = [&](std::int32_t side) {
        return static_cast<std::int32_t>(
            std::max<std::int64_t>(1, (2 * side * std::int64_t{longest} + most) / (2 * most)));
    };
    return {scaled(settings.width), scaled(settings.height)};
}

void set_size(WorldParts& world, SmallSize size) {
    world.settings.width = size.width;
    world.settings.height = size.height;
}

std::size_t count_differing(const Image& a, const Image& b, double least) {
    if (a.rgb.size() != b.rgb.size()) return 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
        bool differs = false;
        for (std::size_t c = i; c < i + 3; ++c)
            differs =
                differs || number::abs(static_cast<double>(a.rgb[c]) - static_cast<double>(b.rgb[c])) > least;
        count += differs ? 1 : 0;
    }
    return count;
}

CheckContext::CheckContext(const Scene& scene, World prepared, const CheckOptions& options)
    : scene_(scene),
      prepared_(std::move(prepared)),
      options_(options),
      shapes_per_ray_(shapes_per_ray(world(), options.threads)),
      is_model_(is_computed(scene)) {}

SmallSize CheckContext::grid(std::int32_t longest) const {
    SmallSize size = small_size(scene_.settings, longest);
    while (longest > k_probe && shapes_per_ray_ * size.width * size.height > k_max_tests)
        size = small_size(scene_.settings, longest -= longest / 8);
    return size;
}

std::string CheckContext::coarse_grid(std::int32_t longest) const {
    const SmallSize size = grid(longest);
    if (size.width == small_size(scene_.settings, longest).width) return {};
    return fmt::format("; looked at with {}x{} rays only, each of which meets the boxes of {:.0f} shapes",
                       size.width, size.height, shapes_per_ray_);
}

Result<Rendering> CheckContext::render_at(World world, SmallSize size) const {
    WorldParts& own = WorldAccess::own(world);
    set_size(own, size);
    own.settings.samples = 1;
    RenderOptions options;
    options.threads = options_.threads;
    options.cancel = options_.cancel;
    return render(world, options);
}

// Mirrors of glass can double the rays at each generation.
SmallSize CheckContext::affordable(std::int32_t longest) {
    if (rays_per_pixel_ == 0) {
        const SmallSize size = small_size(scene_.settings, k_probe);
        const Result<Rendering> probe = render_at(prepared_, size);
        if (probe) rays_per_pixel_ = static_cast<double>(probe->rays.total()) / size.width / size.height;
    }
    SmallSize size = small_size(scene_.settings, longest);
    const double most = std::min(k_max_rays, k_max_tests / std::max(shapes_per_ray_, 1.0));
    while (longest > k_probe && rays_per_pixel_ * size.width * size.height > most)
        size = small_size(scene_.settings, longest /= 2);
    return size;
}

Image CheckContext::render_small(const Result<World>& world, std::int32_t longest) {
    if (!world) return {};
    Result<Rendering> result = render_at(*world, affordable(longest));
    return result ? std::move(result->image) : Image{};
}

FindingPlace CheckContext::at_setting(std::string_view key) const {
    const auto index = find_setting(key);
    if (!index) return {};
    return {*index < scene_.origins.size() ? scene_.origins[*index].place : SourcePlace{}, SceneItem::setting,
            static_cast<std::uint32_t>(*index)};
}

void CheckContext::report(std::string_view id, FindingPlace about, std::string message, std::string remedy,
                          Severity severity) {
    SourcePlace place = about.place;
    Finding finding;
    finding.id = id;
    Diagnostic& d = finding.diagnostic;
    d.severity = severity;
    if (place.line != 0 && place.file < scene_.files.size()) {
        d.file = scene_.files[place.file];
        d.line = place.line;
        d.column = place.column;
        d.length = 1;
        for (const SceneText& text : options_.texts) {
            if (text.name != d.file) continue;
            d = diagnostic_at(severity, {text.name, text.text}, place, {});
            break;
        }
    } else {
        place = {};
    }
    d.message = std::move(message);
    d.item = about.item;
    d.index = about.index;
    finding.remedy = std::move(remedy);
    findings_.emplace_back(place, std::move(finding));
}

bool CheckContext::is_reported(std::string_view id) const {
    return std::any_of(findings_.begin(), findings_.end(), [&](const auto& f) { return f.second.id == id; });
}

bool CheckContext::is_reported(std::string_view id, SceneItem item, std::uint32_t index) const {
    return std::any_of(findings_.begin(), findings_.end(), [&](const auto& f) {
        const Diagnostic& d = f.second.diagnostic;
        return f.second.id == id && d.item == item && d.index == index;
    });
}

std::vector<Finding> CheckContext::take() {
    sort_stably(findings_, [](const auto& a, const auto& b) {
        const SourcePlace &p = a.first, &q = b.first;
        if ((p.line == 0) != (q.line == 0)) return p.line != 0;
        if (p.file != q.file) return p.file < q.file;
        return p.line != q.line ? p.line < q.line : p.column < q.column;
    });
    // A mistake made often is one finding, at its first place.
    struct Alike {
        std::size_t count = 0;
        SourcePlace first, second;
    };
    using Kind = std::pair<std::string_view, Severity>;
    const auto kind_of = [](const Finding& f) { return Kind{f.id, f.diagnostic.severity}; };
    std::map<Kind, Alike> kinds;
    for (const auto& [place, finding] : findings_) {
        Alike& alike = kinds[kind_of(finding)];
        if (++alike.count == 1) alike.first = place;
        if (alike.count == 2) alike.second = place;
    }
    const std::size_t most = is_model() ? 1 : k_max_alike;
    std::vector<Finding> list;
    for (auto& [place, finding] : findings_) {
        Alike& alike = kinds[kind_of(finding)];
        if (alike.count == 0) continue;
        if (alike.count > most) {
            const bool elsewhere =
                alike.second.line != alike.first.line || alike.second.file != alike.first.file;
            finding.diagnostic.message += fmt::format("; and {} more like it{}", alike.count - 1,
                                                      elsewhere ? ", the next" + line_of(alike.second) : "");
            alike.count = 0;
        }
        list.push_back(std::move(finding));
    }
    return list;
}

std::string CheckContext::line_of(SourcePlace place) const {
    if (place.line == 0 || place.file >= scene_.files.size()) return {};
    return place.file == 0 ? fmt::format(" (line {})", place.line)
                           : fmt::format(" ({}:{})", scene_.files[place.file], place.line);
}

std::string_view CheckContext::extension_of(SourcePlace place) const {
    if (place.line == 0 || place.file >= scene_.files.size()) return {};
    const std::string_view name = scene_.files[place.file];
    const std::size_t dot = name.rfind('.');
    return dot == std::string_view::npos ? std::string_view() : name.substr(dot);
}

std::string CheckContext::shape(std::uint32_t i) const {
    return item(to_string(scene_.shapes[i].kind), i, scene_.shape_texts.name(i));
}
std::string CheckContext::shape_and_line(std::uint32_t i) const {
    return shape(i) + line_of(scene_.shape_texts.place(i));
}
bool CheckContext::is_implied_light(std::uint32_t i) const {
    return !scene_.light_texts.places.empty() && scene_.light_texts.place(i).line == 0;
}
std::string CheckContext::light(std::uint32_t i) const {
    const std::string_view name = scene_.light_texts.name(i);
    if (!name.empty()) return item("light", i, name);
    if (is_implied_light(i))
        return fmt::format("the {} light of the format", to_string(scene_.lights[i].kind));
    std::uint32_t implied = 0;
    for (std::uint32_t before = 0; before < i; ++before) implied += is_implied_light(before) ? 1 : 0;
    // `glint explain` counts them all.
    return item("light", i - implied, {}) + (implied > 0 ? " of the file" : "");
}
std::string CheckContext::light_and_line(std::uint32_t i) const {
    return light(i) + line_of(scene_.light_texts.place(i));
}
std::string CheckContext::material(std::uint32_t i) const {
    return i >= scene_.materials.size()
               ? "the default material"
               : item("material", i, scene_.material_texts.name(i)) + line_of(scene_.material_texts.place(i));
}

std::string CheckContext::texture(std::uint32_t i) const {
    return item("texture", i, scene_.texture_texts.name(i)) + line_of(scene_.texture_texts.place(i));
}

std::string CheckContext::some_shapes(const std::vector<std::uint32_t>& shapes) const {
    std::string text;
    const std::size_t most = is_model() ? k_max_named_of_model : k_max_named;
    const std::size_t named = shapes.size() <= most + 1 ? shapes.size() : most;
    for (std::size_t i = 0; i < named; ++i) {
        const bool last = i + 1 == named && named == shapes.size();
        text += i == 0 ? "" : last ? " and " : ", ";
        text += shape_and_line(shapes[i]);
    }
    if (named < shapes.size()) text += fmt::format(" and {} more", shapes.size() - named);
    return text;
}

Material CheckContext::material_of(std::uint32_t shape) const {
    const std::uint32_t index = scene_.shapes[shape].material;
    const Material material = index == k_none ? Material{} : scene_.materials[index];
    const std::optional<Color> color = scene_.shape_color(shape);
    return color ? with_color(material, *color) : material;
}

}  // namespace glint
