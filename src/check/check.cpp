// SPDX-License-Identifier: Apache-2.0
// A scene's likely mistakes: all checks, one after the other.
#include "glint/check.h"

#include <fmt/format.h>

#include "base/catch_exceptions.h"
#include "base/fp_environment.h"
#include "check/checks.h"

namespace glint {
namespace {

constexpr CheckKind k_kinds[] = {
    {"camera-inside-shape", "the camera is inside a closed shape that holds nothing else"},
    {"camera-sees-nothing", "no shape is in the picture, or none but planes"},
    {"camera-frame-skewed",
     "the camera's axes are not at right angles, or no rotation where one is asked for"},
    {"light-inside-shape", "a light that adds nothing is inside a closed shape"},
    {"light-behind-everything", "a light is behind every surface that the camera sees"},
    {"light-behind-plane", "a plane stands between a light and all that the camera sees"},
    {"light-blocked", "every shadow ray to a light is blocked"},
    {"light-adds-nothing", "no material reflects a light"},
    {"light-too-weak", "a light adds less than half of 1/255 to any pixel"},
    {"light-without-color", "a light is black"},
    {"light-negative", "a light takes light away"},
    {"light-color-255", "a light's colour looks like bytes"},
    {"shape-outside-view", "shapes are outside the picture"},
    {"shape-hidden", "shapes are hidden behind or inside others"},
    {"shape-too-small", "shapes are smaller than a pixel"},
    {"shape-written-twice", "two shapes are the same and in the same place"},
    {"faces-coincide", "faces of two shapes of different looks are in one place, and seen"},
    {"seen-from-behind", "flat surfaces are seen from behind, where nothing turns their normals"},
    {"normals-against-winding", "vertex normals point against the triangle's winding"},
    {"normals-on-both-sides", "a triangle's vertex normals point to both sides of it"},
    {"normal-not-unit", "a normal is not of length 1, where the scene's format takes it so"},
    {"direction-not-unit", "a light's direction is not of length 1, and is not normalised"},
    {"material-unused", "no shape has a material"},
    {"material-color-255", "a material's colour looks like bytes"},
    {"material-negative", "light makes a material darker"},
    {"material-almost-black", "a material's colour is below 1/255"},
    {"shininess-zero", "a highlight has the exponent 0"},
    {"picture-black", "the whole picture is black"},
    {"picture-one-color", "the whole picture has one colour"},
    {"picture-clamped", "much of the picture is brighter than 1"},
    {"epsilon-too-small", "rays meet the surface that they leave: shadow acne"},
    {"epsilon-too-large", "rays start beyond what is near"},
    {"reflections-too-few", "one reflection more changes much of the picture"},
};

void run_checks(const Scene& scene, const World& world, const CheckOptions& options, CheckResult& result) {
    CheckContext context(scene, world, options);
    const VisibleHits visible(context);
    if (check_camera(context, visible)) {
        check_lights(context, visible);
        check_shapes(context, visible, check_coincident_shapes(context));
        check_normals(context, visible);
        check_picture(context, visible);
    }
    check_vectors(context);
    check_materials(context);
    result.findings = context.take();
}

}  // namespace

std::span<const CheckKind> check_kinds() { return k_kinds; }

CheckResult check(const Scene& scene, const CheckOptions& options) {
    CheckResult result;
    Result<World> prepared = prepare(scene, {.threads = options.threads});
    result.diagnostics = std::move(prepared.diagnostics);
    if (!prepared) return result;
    result.error = catch_exceptions([&] {
        const DefaultFpEnvironment environment;
        run_checks(scene, *prepared, options, result);
    });
    if (!result.error.empty()) result.findings.clear();
    return result;
}

std::string to_string(const Finding& finding) {
    Diagnostic d = finding.diagnostic;
    d.message += fmt::format(" [{}]", finding.id);
    return to_string(d) + "  remedy: " + finding.remedy + '\n';
}

}  // namespace glint
