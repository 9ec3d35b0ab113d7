// SPDX-License-Identifier: Apache-2.0
// Calls every function that docs/library.md shows. Prints what it expected and did not find.
#include "guide.h"

#include <cstdio>

namespace {

int failures = 0;

void expect(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "\nexpected: %s\n", what);
    ++failures;
}

}  // namespace

int main() {
    glint::Scene scene = make_scene();
    expect(!has_bad_light(scene), "a scene without errors");
    glint::Scene bad = scene;
    bad.lights[0].position.x = 1e300;  // beyond what a coordinate may be
    expect(has_bad_light(bad), "a light with an error");

    TextsByName sources;
    sources.texts["ball.glint"] = "sphere { center = (0, 0, 0)  radius = 1 }\n";
    sources.texts["a.glint"] =
        "include \"ball.glint\"\ncamera { position = (0, 0, 5)  look_at = (0, 0, 0) }\n";
    const auto loaded = read_scene("a.glint", sources);
    expect(loaded && loaded->shapes.size() == 1 && loaded->settings.width == 160, "a scene of two texts");
    sources.texts.erase("ball.glint");
    expect(read_scene("a.glint", sources).code == glint::ErrorCode::io, "a missing text");

    glint::World world = glint::prepare(scene).value();
    const glint::Image before = glint::render(world).value().image;
    const glint::World moved = move_light(world, scene, -4);
    expect(glint::render(moved).value().image.rgb != before.rgb, "another picture");
    expect(glint::render(world).value().image.rgb == before.rgb, "the old World draws the old picture");
    expect(grow_sphere(world, scene) == glint::ShapeEdit::refitted, "a refitted World");

    std::vector<float> pixels(before.rgb.size());
    std::atomic<bool> cancel{false};
    expect(render_into(moved, pixels, cancel).ok(), "a picture in the caller's memory");
    expect(pixels == glint::render(moved).value().image.rgb, "the same picture");
    pixels.pop_back();
    expect(render_into(moved, pixels, cancel).code == glint::ErrorCode::invalid_argument, "memory too small");
    expect(save(before, "guide.png").ok(), "a file");
    expect(save(before, "no_such_folder/guide.png").code == glint::ErrorCode::io, "no file");
    expect(shape_at(world, {0, 0, 9}, {0, 0, -1}) == 0, "the sphere");
    expect(shape_at(world, {0, 5, 9}, {0, 0, -1}) == glint::k_none, "no shape");
    expect(render_until_changed(world, cancel) != glint::ErrorCode::internal, "a picture or none");
    expect(why_dark(make_scene(), glint::prepare(make_scene()).value(), 80, 60) == "adds", "light");
    expect(why_dark(make_scene(), glint::prepare(make_scene()).value(), -1, 0) != "", "no such pixel");
    return failures;
}
