// SPDX-License-Identifier: Apache-2.0
// glint convert: the files that it reads and writes, and those that it must not overwrite.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/process.h"
#include "glint/version.h"

namespace glint::test {
namespace {

TEST(Convert, WritesTheLastOfItsFiles) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Finished r = run(folder, {"convert", "a.cgfs", "a.glint"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.out, "");
    EXPECT_TRUE(r.err.starts_with("a.glint  ")) << r.err;
    EXPECT_TRUE(contains(r.err, "1 shape, 1 material, 2 lights  (0 warnings)")) << r.err;
    const std::string text = folder.read("a.glint");
    EXPECT_TRUE(text.starts_with("# Converted from a.cgfs (cgfs) by glint ")) << text;
    EXPECT_TRUE(contains(text, "\nlight { type = point  position = (2, 1, 0)  intensity = 0.8 }\n")) << text;

    EXPECT_EQ(run(folder, {"convert", "a.cgfs", "-q", "-o", "b.glint"}).err, "");
    EXPECT_EQ(folder.read("b.glint"), text);
    EXPECT_EQ(run(folder, {"convert", "a.cgfs", "-o", "-"}).out, text);
    folder.write("b.glint", "old");
    EXPECT_EQ(run(folder, {"convert", "a.cgfs", "b.glint"}).code, 0);
    EXPECT_EQ(folder.read("b.glint"), text);
    EXPECT_EQ(folder.count(), 3);
}

TEST(Convert, ToGltf) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Finished r = run(folder, {"convert", "a.cgfs", "a.glb"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.err, "a.cgfs: warning: glTF has no ambient light: it is left out\n")) << r.err;
    EXPECT_TRUE(contains(r.err, "a.glb  ")) << r.err;
    EXPECT_TRUE(folder.read("a.glb").starts_with("glTF"));
    EXPECT_EQ(run(folder, {"convert", "-q", "a.cgfs", "-o", "A.GLTF"}).err, "");
    EXPECT_TRUE(folder.read("A.GLTF").starts_with("{\"asset\":"));
    for (const std::string name : {"a.glb", "A.GLTF"})
        EXPECT_EQ(run(folder, {"render", name, "-s", "32x32", "-o", name + ".ppm"}).code, 0) << name;
    EXPECT_EQ(folder.read("a.glb.ppm"), folder.read("A.GLTF.ppm"));
    EXPECT_TRUE(run(folder, {"convert", "a.cgfs", "-o", "-"}).out.starts_with("# Converted"));
}

TEST(Convert, WhatTheOptionsChooseIsWritten) {
    const Folder folder;
    const Finished r =
        run(folder, {"convert", "-", "--format", "cgfs", "--convention", "limit=drop", "-o", "-"},
            with_input(k_scene));
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(r.out.starts_with("# Converted from standard input (cgfs) by glint ")) << r.out;
    EXPECT_TRUE(contains(r.out, "\nconventions { limit = drop }\n")) << r.out;
}

TEST(Convert, DrawsTheSamePictureWithItsIncludesAndComments) {
    const Folder folder;
    std::filesystem::create_directory(folder.path("parts"));
    folder.write("a.glint", R"(camera { position = (0, 2, 8)  look_at = (0, 1, 0)  fov_y = 40 }  # from afar
light { type = point  position = (2, 4, 5) }
group { rotate = (0, 30, 0)  include "parts/b.glint"  include "parts/c.cgfs" }
)");
    folder.write("parts/b.glint", "# part\n\n# a box\nbox { min = (0, 0, 0)  max = (1, 1.1, 1) }\n");
    folder.write("parts/c.cgfs", "sphere { center = (0, 0, 4)  radius = 1  color = (255, 0, 0) }  # red");
    ASSERT_EQ(run(folder, {"convert", "a.glint", "b.glint"}).code, 0);
    const std::string text = folder.read("b.glint");
    EXPECT_TRUE(text.starts_with(
        "# Converted from a.glint (glint), b.glint (glint), c.cgfs (cgfs) by glint " GLINT_VERSION
        "\n#\n# part\n\n"))
        << text;
    EXPECT_TRUE(contains(text, "# a box\n    box ")) << text;
    EXPECT_TRUE(contains(text, "}  # red\n")) << text;
    for (const std::string name : {"a", "b"}) {
        ASSERT_EQ(run(folder, {"render", name + ".glint", "-s", "40x30", "-o", name + ".exr"}).code, 0);
    }
    EXPECT_EQ(folder.read("a.exr"), folder.read("b.exr"));
    // Included files are not overwritten either.
    EXPECT_EQ(run(folder, {"convert", "a.glint", "parts/b.glint"}).code, 2);
}

std::string mesh_text(int strips) {
    std::string vertices, triangles;
    for (int i = 0; i <= strips; ++i) {
        vertices += fmt::format("{}({}, 0, 0), ({}, 1, 0.25)", i > 0 ? ", " : "", i, i);
        if (i < strips)
            triangles += fmt::format("{}({}, {}, {})", i > 0 ? ", " : "", 2 * i, 2 * i + 2, 2 * i + 1);
    }
    return fmt::format("mesh {{ vertices = ({})  triangles = ({}) }}\n", vertices, triangles);
}

TEST(Convert, KeepsPicturesOfTextures) {
    const Folder folder;
    std::filesystem::create_directory(folder.path("parts"));
    folder.write("wood.ppm", std::string("P6 2 1 255\n\x01\x02\x03\xff\xfe\xfd", 17));
    folder.write("a.glint",
                 "camera { position = (0, 2, 8)  look_at = (0, 0, 0) }\n"
                 "light { type = ambient }\n"
                 "texture wood { file = \"wood.ppm\"  mapping = planar }\n"
                 "sphere { center = (0, 0, 0)  radius = 2  texture = wood }\n");
    ASSERT_EQ(run(folder, {"convert", "a.glint", "parts/b.glint"}).code, 0);
    EXPECT_TRUE(contains(folder.read("parts/b.glint"), "file = \"../wood.ppm\""))
        << folder.read("parts/b.glint");
    ASSERT_EQ(run(folder, {"convert", "parts/b.glint", "c.glint"}).code, 0);
    EXPECT_TRUE(contains(folder.read("c.glint"), "file = \"wood.ppm\""));
    for (const char* scene : {"a.glint", "parts/b.glint", "c.glint"}) {
        ASSERT_EQ(run(folder, {"render", scene, "-s", "60x30", "-o", std::string(scene) + ".ppm"}).code, 0);
        EXPECT_EQ(folder.read(std::string(scene) + ".ppm"), folder.read("a.glint.ppm")) << scene;
    }
}

TEST(Convert, WritesLargeMeshesBesideTheScene) {
    const Folder folder;
    std::filesystem::create_directory(folder.path("parts"));
    constexpr std::string_view rest =
        "camera { position = (9, 2, 40)  look_at = (9, 1, 0)  fov_y = 40 }\n"
        "light { type = point  position = (2, 4, 5) }\n";
    folder.write("a.glint", std::string(rest) + mesh_text(300) + mesh_text(2));
    ASSERT_EQ(run(folder, {"convert", "a.glint", "parts/b.glint"}).code, 0);
    const std::string text = folder.read("parts/b.glint");
    EXPECT_TRUE(contains(text, "mesh { file = \"b-1.ply\" }")) << text;
    EXPECT_TRUE(contains(text, "vertices = ((0, 0, 0), (0, 1, 0.25)")) << "a small one can be read";
    EXPECT_TRUE(folder.read("parts/b-1.ply").starts_with("ply\nformat binary_little_endian 1.0\n"));
    // A mesh of a file keeps it.
    ASSERT_EQ(run(folder, {"convert", "parts/b.glint", "c.glint"}).code, 0);
    EXPECT_TRUE(contains(folder.read("c.glint"), "mesh { file = \"parts/b-1.ply\" }"));
    EXPECT_FALSE(std::filesystem::exists(folder.path("c-1.ply")));
    for (const char* scene : {"a.glint", "parts/b.glint", "c.glint"}) {
        ASSERT_EQ(run(folder, {"render", scene, "-s", "60x30", "-o", std::string(scene) + ".ppm"}).code, 0);
        EXPECT_EQ(folder.read(std::string(scene) + ".ppm"), folder.read("a.glint.ppm")) << scene;
    }
}

TEST(Convert, WritesNoMeshOverAnotherFile) {
    const Folder folder;
    constexpr std::string_view camera =
        "camera { position = (9, 2, 40)  look_at = (9, 1, 0)  fov_y = 40 }\n"
        "light { type = point  position = (2, 4, 5) }\n";
    folder.write("two.glint", std::string(camera) + mesh_text(300) + mesh_text(250));
    folder.write("w-1.ply", "mine");
    const Finished r = run(folder, {"convert", "two.glint", "-o", "w.glint"});
    EXPECT_EQ(r.code, 2) << r.err;
    EXPECT_EQ(folder.read("w-1.ply"), "mine");
    // If one may not be written, none is.
    folder.write("a.glint", std::string(camera) + mesh_text(300) + mesh_text(250));
    ASSERT_EQ(run(folder, {"convert", "a.glint", "-o", "b.glint"}).code, 0);
    const std::string first = folder.read("b-1.ply");
    folder.write("c.glint",
                 std::string(camera) + mesh_text(260) + "mesh { file = \"b-2.ply\" }\n" + mesh_text(270));
    const Finished refused = run(folder, {"convert", "c.glint", "-o", "b.glint"});
    EXPECT_EQ(refused.code, 2) << refused.err;
    EXPECT_EQ(folder.read("b-1.ply"), first);
}

TEST(Convert, NamesOnlyFilesOfMeshesThatCanBeRead) {
    const Folder folder;
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    folder.write("a.dat2", ply);
    ASSERT_EQ(run(folder, {"convert", "a.dat2", "--format", "ply", "-o", "b.glint"}).code, 0);
    EXPECT_TRUE(contains(folder.read("b.glint"), "vertices = ")) << folder.read("b.glint");
    const Finished printed = run(folder, {"convert", "-", "--format", "ply", "-o", "-"}, with_input(ply));
    EXPECT_TRUE(contains(printed.out, "vertices = ")) << printed.out << printed.err;
    EXPECT_EQ(run(folder, {"render", "b.glint", "-s", "9x9", "-o", "b.ppm"}).code, 0);
}

TEST(Convert, NeverOverwritesAScene) {
    const Folder folder;
    folder.write("a.glint", k_scene);
    std::filesystem::create_symlink("a.glint", folder.path("link.glint"));
    for (const char* out : {"a.glint", "./a.glint", "link.glint"}) {
        const Finished r = run(folder, {"convert", "a.glint", "--format", "cgfs", out});
        EXPECT_EQ(r.code, 2) << out;
        EXPECT_TRUE(contains(r.err, "would overwrite an input")) << r.err;
    }
    EXPECT_EQ(folder.read("a.glint"), k_scene);
}

TEST(Convert, WhatItCannotDo) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    folder.write("bad.cgfs", "sphere { center = (0, 0, 4)  radius = -1  color = (255, 0, 0) }");
    struct Case {
        std::vector<std::string> arguments;
        int code;
        const char* message;
    };
    const Case cases[] = {
        {{"convert"}, 2, "SCENE"},
        {{"convert", "a.cgfs"}, 2, "expected SCENE... and OUT.glint|glb|gltf"},
        {{"convert", "a.cgfs", "b.cgfs"}, 2, "'b.cgfs': glint writes scenes as .glint, .glb or .gltf only"},
        {{"convert", "a.cgfs", "-o", "a.json"},
         2,
         "'a.json': glint writes scenes as .glint, .glb or .gltf only"},
        {{"convert", "none.cgfs", "b.glint"}, 1, "none.cgfs: no such file"},
        {{"convert", "bad.cgfs", "b.glint"}, 1, "bad.cgfs:1:"},
        {{"convert", "a.cgfs", "none/b.glint"}, 1, "there is no folder 'none'"},
        {{"convert", "a.cgfs", "-o", "/dev/full"}, 1, "No space left"},
    };
    for (const auto& [arguments, code, message] : cases) {
        const Finished r = run(folder, arguments);
        EXPECT_EQ(r.code, code) << message;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
    }
    EXPECT_EQ(folder.count(), 2);
    folder.write("b.glint", "old");
    EXPECT_EQ(run(folder, {"convert", "a.cgfs", "b.glint"}, with_full_disk(100)).code, 1);
    EXPECT_EQ(folder.read("b.glint"), "old");
    EXPECT_EQ(folder.count(), 3);
}

// .glint has no image_width, and no camera of Tachyon's, whose frame follows from the size of the picture.
TEST(Convert, SaysWhatDependsOnThePicturesShape) {
    const Folder folder;
    const std::string sphere = "sphere { z*4, 1 texture { pigment { color rgb 1 } } }\n";
    folder.write("fixed.pov", "camera { right x*4/3 look_at z }\n" + sphere);
    folder.write("shape.pov", "camera { right x*image_width/image_height look_at z }\n" + sphere);
    folder.write("a.dat", R"(BEGIN_SCENE
RESOLUTION 64 48
CAMERA
ZOOM 1
ASPECTRATIO 1
ANTIALIASING 0
RAYDEPTH 1
CENTER 0 0 -4
VIEWDIR 0 0 1
UPDIR 0 1 0
END_CAMERA
SPHERE CENTER 0 0 0 RAD 1 TEXTURE AMBIENT 0.1 DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 1 0 0 TEXFUNC 0
END_SCENE
)");
    const char* const said = "warning: the scene depends on the picture's shape";
    for (const auto& [file, expected] :
         {std::pair{"fixed.pov", false}, std::pair{"shape.pov", true}, std::pair{"a.dat", true}}) {
        const Finished r =
            run(folder, {"convert", file, "--format", file[0] == 'a' ? "tachyon" : "povray", "out.glint"});
        EXPECT_EQ(r.code, 0) << r.err;
        EXPECT_EQ(contains(r.err, said), expected) << file << ": " << r.err;
        EXPECT_FALSE(contains(run(folder, {"convert", "-q", file, "q.glint"}).err, said));
    }
    const Finished r = run(folder, {"convert", "--format", "povray", "-", "-o", "in.glint"},
                           with_input("camera { right x*image_width/image_height look_at z }\n" + sphere));
    EXPECT_TRUE(contains(r.err, said)) << r.err;
}

}  // namespace
}  // namespace glint::test
