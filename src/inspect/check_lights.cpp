// Lights that add nothing to the picture, found by drawing it with each of them alone; and why.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

#include "inspect/checks.h"
#include "math/number.h"

namespace glint {
namespace {

constexpr std::int32_t k_first_look = 160, k_second_look = 480;  // longest side, pixels
constexpr std::size_t k_most_lights = 256;                       // that are drawn one by one
constexpr std::size_t k_full_looks = 8;                          // more lights get smaller pictures
constexpr double k_half_byte = 0.5 / 255;
constexpr std::size_t k_most_points = 4096;
constexpr double k_most_intensity = 10;  // without attenuation; 255 is a byte's

bool is_black(Color c) { return c.r == 0 && c.g == 0 && c.b == 0; }
double brightest(Color c) { return number::max(c.r, number::max(c.g, c.b)); }

double largest_difference(const Image& a, const Image& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.rgb.size() && i < b.rgb.size(); ++i)
        most = number::max(most, number::abs(static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i])));
    return most;
}

// What single lights do to the picture.
class Effects {
  public:
    explicit Effects(Subject& subject) : subject_(subject) {}

    /// The most that the light adds to a channel of a pixel.
    double of(const Light& light, std::int32_t longest) {
        const auto dark = dark_.find(longest);
        const Image& unlit =
            dark == dark_.end() ? dark_.emplace(longest, draw({}, longest)).first->second : dark->second;
        return largest_difference(unlit, draw({light}, longest));
    }

  private:
    Image draw(std::vector<Light> lights, std::int32_t longest) {
        World& world = subject_.change();
        world.ambient = {0, 0, 0};
        world.lights = std::move(lights);
        Image image = subject_.draw(longest);
        subject_.restore();
        return image;
    }

    Subject& subject_;
    std::map<std::int32_t, Image> dark_;  // by longest side
};

// Why points that the camera sees get nothing of a light.
struct Blockage {
    std::size_t points = 0, facing = 0, blocked = 0;
    std::uint32_t blocker = k_none;  // the one that most shadow rays meet first, from the light
    std::size_t by_blocker = 0;
};

Blockage find_blockage(const Subject& subject, const Sight& sight, const Light& light) {
    const ShadowRays shadows = shadow_rays(subject.world(), sight, light, k_most_points);
    const HitList hits = nearest_hits(subject.world(), shadows.rays, subject.threads());
    Blockage found;
    found.points = shadows.points;
    found.facing = shadows.rays.size();
    std::unordered_map<std::uint32_t, std::size_t> counts;
    for (const std::uint32_t slot : hits.slot) {
        if (slot == k_none) continue;
        ++found.blocked;
        const std::uint32_t shape = subject.world().shape_index[slot];
        const std::size_t now = ++counts[shape];
        if (now > found.by_blocker || (now == found.by_blocker && shape < found.blocker)) {
            found.by_blocker = now;
            found.blocker = shape;
        }
    }
    return found;
}

void report_dark(Subject& subject, const Sight& sight, std::uint32_t index) {
    const Light& light = subject.scene().lights[index];
    const SourcePlace place = subject.scene().light_texts.place(index);
    const std::string name = subject.light(index);
    const bool point_light = light.kind == LightKind::point;
    if (point_light) {
        for (const std::uint32_t shape : shapes_around(subject, light.position)) {
            const Material& m = subject.material_of(shape);
            if (m.transmission > 0 && subject.scene().conventions.glass_shadow == GlassShadow::none) continue;
            return subject.report(
                "light-inside-shape", place,
                fmt::format("{} is inside {}, which keeps its light from all that the camera sees", name,
                            subject.shape_and_line(shape)),
                "move the light out of the shape");
        }
    }
    const Blockage b = find_blockage(subject, sight, light);
    if (b.facing == 0) {
        return subject.report(
            "light-behind-everything", place,
            fmt::format("{} is behind every surface that the camera sees: N.L <= 0 at all of {} points", name,
                        b.points),
            point_light ? "move the light to the side of the surfaces that the camera sees"
                        : "turn the direction around: it goes from the surface towards the light");
    }
    if (b.blocker != k_none && b.blocked == b.facing) {
        const bool plane = subject.scene().shapes[b.blocker].kind == ShapeKind::plane;
        return subject.report(
            plane ? "light-behind-plane" : "light-blocked", place,
            fmt::format("{} lights nothing that the camera sees: {} stands between it and {} of {} points",
                        name, subject.shape_and_line(b.blocker), b.by_blocker, b.facing),
            plane ? "move the light to the other side of the plane"
                  : "move the light, or the shape before it");
    }
    subject.report(
        "light-adds-nothing", place,
        fmt::format("{} adds nothing to the picture: no material that the camera sees reflects its colour",
                    name),
        "give the materials diffuse or specular coefficients, or leave the light out");
}

bool is_attenuated(const Light& light) {
    const Attenuation& a = light.attenuation;
    return light.kind == LightKind::point && (a.c0 > 1 || a.c1 > 0 || a.c2 > 0);
}

// Colours and intensities that can hardly be meant. True if the light has none.
bool check_color(Subject& subject, std::uint32_t index) {
    const Light& light = subject.scene().lights[index];
    const SourcePlace place = subject.scene().light_texts.place(index);
    if (is_black(light.color) && (light.kind == LightKind::ambient || is_black(light.specular_color))) {
        subject.report("light-without-color", place,
                       fmt::format("{} is black: it adds nothing", subject.light(index)),
                       "give it a colour or an intensity, or leave it out");
        return true;
    }
    if (brightest(light.color) > k_most_intensity && !is_attenuated(light)) {
        subject.report(
            "light-color-255", place,
            fmt::format(
                "{} has the colour ({:.4g}, {:.4g}, {:.4g}), where 1 is full and nothing weakens it: are "
                "these bytes from 0 to 255?",
                subject.light(index), light.color.r, light.color.g, light.color.b),
            "divide the colour by 255");
    }
    return false;
}

// An ambient light that the format implies has no place in a scene whose other items have.
bool is_implied(const Scene& scene, std::uint32_t index) {
    return !scene.light_texts.places.empty() && scene.light_texts.place(index).line == 0;
}

void check_ambient(Subject& subject, std::uint32_t index) {
    const Scene& scene = subject.scene();
    if (scene.shapes.empty() || is_implied(scene, index)) return;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i)
        if (!is_black(subject.material_of(i).ambient)) return;
    subject.report(
        "light-adds-nothing", scene.light_texts.place(index),
        fmt::format("{} adds nothing: no shape's material has an ambient coefficient", subject.light(index)),
        "give the materials `ambient`, or leave the light out");
}

}  // namespace

void check_lights(Subject& subject, const Sight& sight) {
    const Scene& scene = subject.scene();
    const Shading shading = scene.settings.shading;
    if (shading == Shading::color || shading == Shading::normals) return;
    const std::size_t count = std::min(scene.lights.size(), k_most_lights);
    std::int32_t longest = k_first_look;
    for (std::size_t n = count; n > k_full_looks; n /= 4) longest /= 2;
    std::size_t looked_twice = 0;
    Effects effects(subject);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Light& light = scene.lights[i];
        if (check_color(subject, i)) continue;
        if (light.kind == LightKind::ambient) {
            if (shading != Shading::diffuse) check_ambient(subject, i);
            continue;
        }
        double effect = effects.of(light, longest);
        if (effect >= k_half_byte) continue;
        // A highlight may lie between the pixels of a small picture.
        effect = effects.of(light, looked_twice++ < k_full_looks ? k_second_look : k_first_look);
        if (effect == 0) {
            report_dark(subject, sight, i);
        } else if (effect < k_half_byte) {
            subject.report(
                "light-too-weak", scene.light_texts.place(i),
                fmt::format("{} adds {:.2g} of 255 to the brightest pixel it reaches: nobody sees it",
                            subject.light(i), effect * 255),
                is_attenuated(light) ? "raise its intensity, or weaken its attenuation"
                                     : "raise its intensity");
        }
    }
}

}  // namespace glint
