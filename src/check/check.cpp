// SPDX-License-Identifier: Apache-2.0
// A scene's likely mistakes: all checks, one after the other.
#include "glint/check.h"

#include <fmt/format.h>

#include "base/fp_environment.h"
#include "base/status.h"
#include "base/text.h"
#include "check/checks.h"

namespace glint {
namespace {

constexpr CheckKind k_kinds[] = {
    {"camera-inside-shape", "the camera is inside a closed shape that contains nothing else"},
    {"camera-sees-nothing", "no shape is in the picture, or only planes are"},
    {"camera-mirrored", "the camera's axes do not have the handedness of the scene's profile"},
    {"camera-frame-skewed",
     "the camera's axes are not at right angles, or not a rotation where the source needs one"},
    {"camera-view-too-wide", "the camera sees 150 degrees or more"},
    {"camera-angle-in-radians", "the angle of view is so small that it is probably in radians"},
    {"light-inside-shape", "a light that adds nothing is inside a closed shape"},
    {"light-behind-everything", "a light is behind every surface that the camera sees"},
    {"light-behind-plane", "a plane is between a light and all that the camera sees"},
    {"light-blocked", "every shadow ray to a light is blocked"},
    {"spot-aimed-elsewhere", "nothing that the camera sees is in the cone of a spot"},
    {"spot-angle-in-radians", "the angles of a spot are so small that they are probably in radians"},
    {"spot-too-tight", "the light of a spot is a dot"},
    {"area-light-faces-away", "nothing that the camera sees is on the bright side of an area light"},
    {"area-light-too-many-samples", "an area light has more samples than the picture can show"},
    {"area-light-one-sample", "an area light has one sample, which shows nothing of its size"},
    {"light-adds-nothing", "no material reflects a light"},
    {"light-too-weak", "a light adds less than half of 1/255 to any pixel"},
    {"light-attenuated-away", "attenuation leaves almost nothing of a light"},
    {"light-written-twice", "two or more lights are equal"},
    {"light-on-surface", "a light is exactly on a surface"},
    {"light-around-shape", "a shape is inside a spherical light"},
    {"light-only-ambient", "no light but ambient light: the shapes look flat"},
    {"ambient-too-strong", "ambient light is almost as bright as the light of the lights"},
    {"occlusion-reach-too-short", "no shape is within the reach of the occlusion"},
    {"light-without-color", "a light is black"},
    {"light-negative", "a channel of a light is below 0"},
    {"light-color-255", "a light's color looks like bytes"},
    {"shape-outside-view", "shapes are outside the picture"},
    {"shape-hidden", "shapes are hidden behind or inside others"},
    {"shape-too-small", "shapes are smaller than a pixel"},
    {"shape-written-twice", "two shapes are the same and in the same place"},
    {"shape-without-area", "the corners of a shape are on one line"},
    {"shape-too-flat", "a cylinder or cone is so short that its side is not visible"},
    {"shape-looks-like-background", "a shape has the color of the background behind it"},
    {"solid-empty", "a combination of shapes leaves nothing"},
    {"operand-cuts-nothing", "a shape that should cut something off a solid does not"},
    {"faces-coincide", "faces of two shapes, or of two operands of a solid, coincide, and are visible"},
    {"seen-from-behind", "flat surfaces are seen from behind, and the conventions do not turn their normals"},
    {"normals-against-winding", "vertex normals point against the triangle's winding"},
    {"normals-on-both-sides", "a triangle's vertex normals point to both sides of it"},
    {"mesh-winding", "triangles of a mesh face the other way than their neighbours"},
    {"mesh-duplicates", "triangles of a mesh have the same vertices"},
    {"mesh-without-area", "triangles of a mesh have no area"},
    {"normal-not-unit", "a normal's length is not 1, but the scene's format uses it as a unit vector"},
    {"direction-not-unit", "a light's direction does not have length 1, and is not normalised"},
    {"material-unused", "no shape uses a material"},
    {"material-color-255", "a material's color looks like bytes"},
    {"material-negative", "light makes a material darker"},
    {"material-almost-black", "a material's color is below 1/255"},
    {"shininess-zero", "a highlight has the exponent 0"},
    {"shininess-too-small", "a highlight has an exponent below 1"},
    {"shininess-too-large", "the exponent of a highlight is so large that it is not visible"},
    {"glass-without-refraction", "glass has the index of refraction of air"},
    {"material-invisible", "a transparent material shows nothing"},
    {"finish-unused", "a field of a finish has no effect"},
    {"texture-unused", "no material has a texture"},
    {"texture-without-coordinates", "a texture needs texture coordinates that its shapes do not have"},
    {"texture-out-of-reach", "a texture that is drawn once is on no surface"},
    {"texture-invisible", "by its alpha, no texel of a texture is visible"},
    {"shape-only-holes", "of a shape, only places are seen where its texture has holes"},
    {"shape-only-back", "a one-sided shape is seen only from behind"},
    {"texture-too-fine", "a texture is so fine that it is noise"},
    {"fog-hides-everything", "no shape is visible through the fog"},
    {"fog-not-visible", "the fog changes no pixel"},
    {"picture-black", "the whole picture is black"},
    {"picture-one-color", "the whole picture has one color"},
    {"picture-dark", "nothing in the picture is bright enough to be seen well"},
    {"picture-clamped", "much of the picture is brighter than 1"},
    {"epsilon-too-small", "rays intersect the surface that they leave: shadow acne"},
    {"epsilon-too-large", "rays start beyond nearby objects"},
    {"reflections-too-few", "one reflection more changes much of the picture"},
};

constexpr double k_prepared = 0.2;  // of the progress

// Does one step after the other, unless it is cancelled.
class Steps {
  public:
    Steps(const CheckOptions& options, int count) : options_(options), count_(count) {}

    template <class Step> void run(const Step& step) {
        if (!is_cancelled()) step();
        ++done_;
        if (options_.progress && !is_cancelled())
            options_.progress(k_prepared + (1 - k_prepared) * done_ / count_);
    }
    bool is_cancelled() const { return options_.cancel.is_set(); }

  private:
    const CheckOptions& options_;
    const int count_;
    int done_ = 0;
};

Result<std::vector<Finding>> run_checks(const Scene& scene, const World& world, const CheckOptions& options) {
    CheckContext context(scene, world, options);
    Steps steps(options, 10);
    std::optional<VisibleHits> visible;
    steps.run([&] { visible.emplace(context); });
    bool sees = false;
    steps.run(
        [&] { sees = check_view_angle(context) && check_camera(context, *visible) && check_fog(context); });
    const auto run_if_seen = [&](const auto& step) {
        steps.run([&] {
            if (sees) step();
        });
    };
    run_if_seen([&] { check_lights(context, *visible); });
    run_if_seen([&] {
        std::vector<bool> explained = check_coincident_shapes(context);
        check_flat_shapes(context, *visible, explained);
        check_solids(context, *visible, explained);
        check_coincident_operands(context, *visible);
        check_shapes(context, *visible, explained);
    });
    run_if_seen([&] { check_normals(context, *visible); });
    steps.run([&] { check_meshes(context); });
    steps.run([&] { check_vectors(context); });
    steps.run([&] { check_materials(context, sees); });
    steps.run([&] {
        check_textures(context, *visible, sees);
        check_holes(context, *visible);
    });
    run_if_seen([&] { check_picture(context, *visible); });
    if (steps.is_cancelled()) return cancelled();
    return context.take();
}

}  // namespace

std::span<const CheckKind> check_kinds() { return k_kinds; }

Result<std::vector<Finding>> check(const Scene& scene, const CheckOptions& options) {
    return result_of([&]() -> Result<std::vector<Finding>> {
        const DefaultFpEnvironment environment;
        PrepareOptions preparing{.threads = options.threads, .cancel = options.cancel};
        if (options.progress)
            preparing.progress = [&](double fraction) { options.progress(k_prepared * fraction); };
        Result<World> prepared = prepare(scene, preparing);
        if (!prepared) return Status(prepared);
        Result<std::vector<Finding>> findings = run_checks(scene, *prepared, options);
        findings.diagnostics = std::move(prepared.diagnostics);
        return findings;
    });
}

std::string to_string(const Finding& finding) {
    Diagnostic d = finding.diagnostic;
    d.message += fmt::format(" [{}]", finding.id);
    return to_string(d) + "  remedy: " + printable(finding.remedy) + '\n';
}

}  // namespace glint
