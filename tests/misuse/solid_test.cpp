// SPDX-License-Identifier: Apache-2.0
// Solids that are none, and calls with indices that are not there.
#include <functional>

#include "misuse/misused.h"

namespace glint::test {
namespace {

/// A box without a sphere, in a scene of other shapes.
Scene scene_of_a_solid() {
    Scene scene = some_scene();
    const auto first = static_cast<std::uint32_t>(scene.shapes.size());
    scene.add(Box{});
    scene.add(Sphere{{1, 1, 1}, 0.5});
    combine_last(scene, SolidOperation::difference, first);
    return scene;
}

TEST(Misuse, OfSolids) {
    EXPECT_EQ(to_string(beyond<SolidOperation>()), "unknown operation");
    EXPECT_FALSE(has_errors(validate(scene_of_a_solid())));
    const std::function<void(Scene&, SolidTree&)> edits[] = {
        [](Scene& s, SolidTree&) { s.solids.clear(); },
        [](Scene&, SolidTree& t) { t.operands.clear(); },
        [](Scene&, SolidTree& t) { t.steps.clear(); },
        [](Scene&, SolidTree& t) { t.steps.pop_back(); },
        [](Scene&, SolidTree& t) { t.steps.push_back(t.steps[0]); },
        [](Scene&, SolidTree& t) { t.steps.back().count = 3; },
        [](Scene&, SolidTree& t) { t.steps.back().count = k_none; },
        [](Scene&, SolidTree& t) { t.steps.back().operation = static_cast<SolidOperation>(100); },
        [](Scene&, SolidTree& t) { t.steps.back().operation = SolidOperation::inverse; },
        [](Scene&, SolidTree& t) {
            t.steps.insert(t.steps.end(), 101, {SolidOperation::inverse, 1});
        },
        [](Scene&, SolidTree& t) { t.operands[1].index = 1000; },
        [](Scene&, SolidTree& t) { t.operands[1].material = 1000; },
        [](Scene&, SolidTree& t) { t.operands[1].transform = 1000; },
        [](Scene&, SolidTree& t) { t.operands[1].kind = static_cast<ShapeKind>(100); },
        [](Scene& s, SolidTree& t) { t.operands[1] = s.shapes.back(); },  // itself
        [](Scene& s, SolidTree& t) {
            s.add(Disc{});
            t.operands[1] = s.shapes.back();
        },
        [](Scene& s, SolidTree&) { s.get<Sphere>().back().radius = -1; },
        [](Scene&, SolidTree& t) {
            t.operands.resize(k_max_solid_operands + 1, t.operands[0]);
            t.steps.assign(t.operands.size(), {SolidOperation::operand, 0});
            t.steps.push_back({SolidOperation::merge, static_cast<std::uint32_t>(t.operands.size())});
        },
    };
    int number = 0;
    for (const auto& edit : edits) {
        SCOPED_TRACE(number++);
        Scene scene = scene_of_a_solid();
        edit(scene, scene.solids.back());
        EXPECT_TRUE(has_errors(validate(scene)));
        EXPECT_FALSE(prepare(scene));
        EXPECT_EQ(write_glint(scene).code, ErrorCode::invalid_scene);
        EXPECT_EQ(check(scene).code, ErrorCode::invalid_scene);
    }
}

TEST(Misuse, OfCombining) {
    Scene scene = some_scene();
    EXPECT_EQ(combine_last(scene, SolidOperation::merge, 1000), k_none);
    EXPECT_EQ(combine_last(scene, SolidOperation::merge, k_none), k_none);
    EXPECT_EQ(scene.shapes.size(), some_scene().shapes.size());
    EXPECT_TRUE(operands_of(scene, {ShapeKind::solid, 1000}).empty());
    EXPECT_TRUE(operands_of(scene, scene.shapes[0]).empty());
    const Shape wrong[] = {{ShapeKind::solid, 1000}, {static_cast<ShapeKind>(100), 5}};
    const SolidTree tree = combine(scene, SolidOperation::intersection, wrong);
    EXPECT_EQ(tree.operands.size(), 2u);
    EXPECT_TRUE(combine(scene, SolidOperation::merge, {}).operands.empty());
}

}  // namespace
}  // namespace glint::test
