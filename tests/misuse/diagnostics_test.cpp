// SPDX-License-Identifier: Apache-2.0
// Diagnostics that glint itself does not produce.
#include "misuse/misused.h"

namespace glint::test {
namespace {

TEST(Misuse, OfDiagnostics) {
    EXPECT_EQ(to_string(Diagnostic{}), "error: \n");
    Diagnostic d;
    d.severity = beyond<Severity>();
    d.file = "a.glint";
    d.line = std::numeric_limits<std::uint32_t>::max();
    d.message = "what";
    d.source_line = "sphere";
    d.length = 0;
    EXPECT_NE(to_string(d).find("\n  sphere\n  ^\n"), std::string::npos) << to_string(d);
    d.length = std::numeric_limits<std::uint32_t>::max();
    EXPECT_NE(to_string(d).find("\n  sphere\n  ^~~~~~\n"), std::string::npos) << to_string(d);
    d.caret = std::numeric_limits<std::uint32_t>::max();
    EXPECT_NE(to_string(d).find("\n  sphere\n        ^\n"), std::string::npos) << to_string(d);
    d.item = beyond<SceneItem>();
    EXPECT_EQ(item_path(d), "");
    d.file.clear();
    d.item = SceneItem::shape;
    d.index = k_none;
    EXPECT_EQ(item_path(d), "shapes[4294967295]");
    EXPECT_EQ(item_path(Diagnostic{}), "");
    EXPECT_FALSE(has_errors({d}));
    EXPECT_FALSE(has_errors({}));
    EXPECT_EQ(count_warnings({d, {}}), 0u);
    EXPECT_EQ(count_warnings({}), 0u);
}

TEST(Misuse, OfFindings) {
    EXPECT_EQ(to_string(Finding{}), "error:  []\n  remedy: \n");
    for (const CheckKind& kind : check_kinds()) EXPECT_FALSE(kind.id.empty() || kind.description.empty());
}

TEST(Misuse, OfCheck) {
    Scene scene = some_scene();
    scene.shapes[1].index = 77;
    const Result<std::vector<Finding>> invalid = check(scene);
    EXPECT_TRUE(has_errors(invalid.diagnostics));
    EXPECT_EQ(invalid.code, ErrorCode::invalid_scene);

    // Texts and places that do not belong to the scene.
    scene = some_scene();
    scene.materials.push_back({});  // no shape has it
    const std::size_t findings = check(scene).value().size();
    EXPECT_GT(findings, 0u);
    scene.files = {"a.glint"};
    scene.light_texts.places.assign(4, {1000000, 65535, 9});
    scene.shape_texts.places.assign(1, {3, 1, 0});
    scene.shape_texts.names = {{77u, "nobody"}};
    const SceneText texts[] = {{"b.glint", "none", "none"}, {"a.glint", "", ""}, {"", {}, ""}};
    EXPECT_EQ(check(scene, {-5, texts}).value().size(), findings);

    EXPECT_TRUE(check(Scene{}));
    const std::atomic<bool> cancel{true};
    EXPECT_EQ(check(scene, {.cancel = &cancel}).code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace glint::test
