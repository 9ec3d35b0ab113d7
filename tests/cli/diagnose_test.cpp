// SPDX-License-Identifier: Apache-2.0
// glint diagnose and glint pixels as commands.
#include <gtest/gtest.h>

#include "cli/process.h"

namespace glint::test {
namespace {

const std::string k_sphere = GLINT_SOURCE "/examples/trace_log/diffuse_sphere.glint";

// Two rays of the sphere; t is that of the far hit.
constexpr auto k_log =
    "size 64 48\npixel 0 0\nray camera\nmiss\nend\nbytes 9 0 0\npixel 32 24\nray camera\nshape 1\nt 5\nend\n";

TEST(DiagnoseCommand, PrintsAPixel) {
    const Folder folder;
    folder.write("mine.log", k_log);
    const auto tree = run(folder, {"diagnose", k_sphere, "mine.log", "--tree", "32,24"});
    EXPECT_TRUE(contains(tree.out, "! t ")) << tree.out << tree.err;
    EXPECT_TRUE(contains(run(folder, {"diagnose", k_sphere, "mine.log", "--tree", "0,0"}).out, "bytes"));
    const auto none = run(folder, {"diagnose", k_sphere, "mine.log", "--tree", "3,3"});
    EXPECT_EQ(none.code, 1);
    EXPECT_TRUE(contains(none.err, "mine.log: the log has no pixel 3,3")) << none.err;
    EXPECT_EQ(run(folder, {"diagnose", k_sphere, "mine.log", "--tree", "3x3"}).code, 2);
}

TEST(DiagnoseCommand, LooksAtThePicture) {
    const Folder folder;
    folder.write("mine.log", k_log);
    // Without the sphere.
    folder.write("empty.glint", "render { size = 64 x 48 }\ncamera { position = (0, 0, 4) }\n");
    ASSERT_EQ(run(folder, {"render", "empty.glint", "-o", "mine.png"}).code, 0);
    const auto text = run(folder, {"diagnose", k_sphere, "mine.log", "--picture", "mine.png"});
    EXPECT_TRUE(contains(text.out, "The picture has other bytes than the log at 1 of 1 pixel, as at 0,0"))
        << text.out << text.err;
    EXPECT_TRUE(contains(text.out, "The picture differs at these pixels, too, which are not in the log: "))
        << text.out;
    // Of another size.
    ASSERT_EQ(run(folder, {"render", "empty.glint", "-o", "small.png", "--size", "32x20"}).code, 0);
    EXPECT_NE(run(folder, {"diagnose", k_sphere, "mine.log", "--picture", "small.png"}).code, 0);
}

}  // namespace
}  // namespace glint::test
