// SPDX-License-Identifier: Apache-2.0
#pragma once
// The words of POV-Ray's language that the reader knows. Other reserved words are in povray_keywords.cpp.
#include <cstdint>
#include <string_view>

namespace glint::povray {

// clang-format off
// X(word): its enumerator is k_word.
#define GLINT_POV_DIRECTIVES(X) \
    X(break) X(case) X(debug) X(declare) X(default) X(else) X(elseif) X(end) X(error) X(fclose) X(fopen) \
    X(for) X(if) X(ifdef) X(ifndef) X(include) X(local) X(macro) X(range) X(read) X(render) \
    X(statistics) X(switch) X(undef) X(version) X(warning) X(while) X(write)
#define GLINT_POV_NUMBER_WORDS(X) \
    X(abs) X(acos) X(acosh) X(asc) X(asin) X(asinh) X(atan) X(atan2) X(atanh) X(ceil) X(clock) \
    X(clock_delta) X(clock_on) X(cos) X(cosh) X(defined) X(degrees) X(dimension_size) X(dimensions) \
    X(div) X(exp) X(false) X(file_exists) X(final_clock) X(final_frame) X(floor) X(frame_number) \
    X(image_height) X(image_width) X(initial_clock) X(initial_frame) X(inside) X(int) X(ln) X(log) X(max) X(max_extent) \
    X(min) X(min_extent) X(mod) X(no) X(off) X(on) X(pi) X(pow) X(radians) X(rand) X(seed) X(select) X(sin) X(sinh) X(sqrt) \
    X(strcmp) X(strlen) X(t) X(tan) X(tanh) X(trace) X(true) X(u) X(v) X(val) X(vaxis_rotate) X(vcross) X(vdot) \
    X(vlength) X(vnormalize) X(vrotate) X(x) X(y) X(yes) X(z)
#define GLINT_POV_STRING_WORDS(X) \
    X(chr) X(concat) X(datetime) X(str) X(strlwr) X(strupr) X(substr) X(vstr)
#define GLINT_POV_COLOR_WORDS(X) \
    X(blue) X(color) X(colour) X(filter) X(gray) X(green) X(red) X(rgb) X(rgbf) X(rgbft) X(rgbt) X(srgb) \
    X(srgbf) X(srgbft) X(srgbt) X(transmit)
#define GLINT_POV_OBJECT_WORDS(X) \
    X(box) X(cone) X(cubic) X(cylinder) X(difference) X(disc) X(height_field) X(intersection) X(lathe) \
    X(light_source) X(merge) X(mesh) X(mesh2) X(object) X(plane) X(poly) X(polygon) X(prism) X(quadric) \
    X(quartic) X(smooth_triangle) X(sphere) X(sphere_sweep) X(torus) X(triangle) X(union)
#define GLINT_POV_MODIFIER_WORDS(X) \
    X(bounded_by) X(clipped_by) X(cutaway_textures) X(double_illuminate) X(finish) X(hierarchy) X(hollow) X(interior) \
    X(interior_texture) X(inverse) X(material) X(matrix) X(no_bump_scale) X(no_image) X(no_radiosity) \
    X(no_reflection) X(no_shadow) X(normal) X(open) X(photons) X(pigment) X(radiosity) X(rotate) \
    X(scale) X(split_union) X(sturm) X(texture) X(transform) X(translate) X(uv_mapping)
#define GLINT_POV_MESH_WORDS(X) \
    X(face_indices) X(inside_vector) X(normal_indices) X(normal_vectors) X(texture_list) X(uv_indices) \
    X(uv_vectors) X(vertex_vectors)
#define GLINT_POV_FINISH_WORDS(X) \
    X(ambient) X(brilliance) X(conserve_energy) X(crand) X(diffuse) X(emission) X(exponent) X(falloff) \
    X(fresnel) X(ior) X(irid) X(metallic) X(phong) X(phong_size) X(reflection) X(reflection_exponent) \
    X(roughness) X(specular) X(subsurface) X(use_alpha)
#define GLINT_POV_LIGHT_WORDS(X) \
    X(adaptive) X(area_illumination) X(area_light) X(circular) X(fade_color) X(fade_colour) \
    X(fade_distance) X(fade_power) X(jitter) X(looks_like) X(media_attenuation) X(media_interaction) \
    X(orient) X(parallel) X(point_at) X(projected_through) X(radius) X(shadowless) X(spotlight) \
    X(tightness)
#define GLINT_POV_CAMERA_WORDS(X) \
    X(angle) X(aperture) X(blur_samples) X(camera) X(confidence) X(direction) X(fisheye) X(focal_point) \
    X(location) X(look_at) X(omnimax) X(orthographic) X(panoramic) X(perspective) X(right) X(sky) \
    X(spherical) X(ultra_wide_angle) X(up) X(variance)
#define GLINT_POV_SCENE_WORDS(X) \
    X(adc_bailout) X(ambient_light) X(array) X(assumed_gamma) X(background) X(charset) X(checker) \
    X(color_map) X(colour_map) X(distance) X(fog) X(fog_type) X(function) X(global_settings) X(gradient) \
    X(hf_gray_16) X(image_map) X(irid_wavelength) X(max_intersections) X(max_trace_level) X(mm_per_unit) \
    X(noise_generator) X(number_of_waves) X(quick_color) X(quick_colour) X(rainbow) X(sky_sphere) \
    X(spline)
#define GLINT_POV_WORDS(X) \
    GLINT_POV_DIRECTIVES(X) GLINT_POV_NUMBER_WORDS(X) GLINT_POV_STRING_WORDS(X) GLINT_POV_COLOR_WORDS(X) \
    GLINT_POV_OBJECT_WORDS(X) GLINT_POV_MODIFIER_WORDS(X) GLINT_POV_MESH_WORDS(X) \
    GLINT_POV_FINISH_WORDS(X) GLINT_POV_LIGHT_WORDS(X) GLINT_POV_CAMERA_WORDS(X) \
    GLINT_POV_SCENE_WORDS(X)
// clang-format on

enum class Word : std::uint32_t {
#define GLINT_POV_WORD(word) k_##word,
    GLINT_POV_WORDS(GLINT_POV_WORD)
#undef GLINT_POV_WORD
        k_count,
    k_none = 0xffffffffu  // no word
};

/// The text of a word.
std::string_view to_string(Word word);

}  // namespace glint::povray
