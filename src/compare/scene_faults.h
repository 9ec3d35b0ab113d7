// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tables of faults of a scene: when a fault can matter, and the change of the scene.
#include <algorithm>
#include <span>
#include <string>

#include "glint/scene.h"
#include "math/elementary.h"
#include "world/tracer_fault.h"

namespace glint {

struct SceneFault {
    const char* name;
    bool (*applies)(const Scene&);
    void (*put)(Scene&) = nullptr;
    const char* explanation = "";
    const char* part = "";
    const char* scaled = "";
    void (*scale_part)(Scene&, double) = nullptr;
    void (*scale)(Scene&, double) = nullptr;  ///< then the cause is a factor, and the next its explanation
    std::string (*scale_text)(double, bool) = nullptr;
    void (*reshape)(Scene&) = nullptr;            ///< changes the scene with its shapes
    TracerFault fault = TracerFault::none;        ///< of the kernels
    const char* limit = "";                       ///< the cause whose picture an ever larger factor gives
    std::string (*limit_text)(double) = nullptr;  ///< from this factor on
};

/// Of the lighting equation; of spots and area lights; of rays; of fog, transparency and occlusion;
/// of textures.
std::span<const SceneFault> lighting_faults();
std::span<const SceneFault> light_kind_faults();
std::span<const SceneFault> tracing_faults();
std::span<const SceneFault> medium_faults();
std::span<const SceneFault> texture_faults();
/// Of the camera; of the kernels; of shapes and the reading of files; of numbers of other items.
std::span<const SceneFault> camera_faults();
std::span<const SceneFault> kernel_faults();
std::span<const SceneFault> shape_faults();
std::span<const SceneFault> mixed_up_faults();

// ---- What rows ask of a scene, and do to it ----

inline bool is_ambient(const Light& light) { return light.is_ambient(); }
/// The largest channel.
inline double largest(const Color& c) { return std::max({c.r, c.g, c.b}); }
inline bool is_zero(const Color& c) { return c == Color{0, 0, 0}; }

template <class Test> bool any_light(const Scene& s, Test&& test) {
    return std::any_of(s.lights.begin(), s.lights.end(), test);
}
template <class Test> bool any_material(const Scene& s, Test&& test) {
    return std::any_of(s.materials.begin(), s.materials.end(), test);
}

/// A gamma of 2.2 is removed from a channel.
inline double decode_power(double v) { return pow(v, 2.2); }

inline bool is_lit(const Scene& s) {
    return any_light(s, [](const Light& l) { return !is_ambient(l); }) &&
           s.settings.shading != Shading::color && s.settings.shading != Shading::normals;
}
inline bool has_highlights(const Scene& s) {
    return is_lit(s) && s.settings.shading != Shading::diffuse &&
           any_material(s, [](const Material& m) { return !is_zero(m.specular) || !is_zero(m.phong); });
}
inline bool has_mirrors(const Scene& s) {
    return s.settings.reflections > 0 && any_material(s, [](const Material& m) { return m.mirror > 0; });
}
inline bool has_glass(const Scene& s) {
    return s.settings.reflections > 0 &&
           any_material(s, [](const Material& m) { return m.transmission > 0; });
}
inline bool has_area_lights(const Scene& s) {
    return is_lit(s) && any_light(s, [](const Light& l) { return l.is_area(); });
}
inline bool has_shadows(const Scene& s) { return is_lit(s) && s.settings.shadows; }

/// A light that is missing stays in the list, so that the others keep their numbers.
inline void switch_off(Light& light) { light.color = light.specular_color = {0, 0, 0}; }
inline bool is_off(const Light& light) { return is_zero(light.color) && is_zero(light.specular_color); }

/// Of the lights that shine and are not ambient.
template <class Change> void for_each_light(Scene& s, Change&& change) {
    for (Light& light : s.lights) {
        if (!is_ambient(light) && !is_off(light)) change(light);
    }
}
template <class Change> void for_each_area_light(Scene& s, Change&& change) {
    for_each_light(s, [&](Light& light) {
        if (light.is_area()) change(light);
    });
}
template <class Change> void for_each_material(Scene& s, Change&& change) {
    for (Material& material : s.materials) change(material);
}

}  // namespace glint
