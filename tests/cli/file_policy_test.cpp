// SPDX-License-Identifier: Apache-2.0
// Which files a scene, a submission or an .ini file may name (SECURITY.md).
#include "cli/file_policy.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include "cli/process.h"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_secret = "root:secret:0:0";

class FilePolicy : public testing::Test {
  protected:
    FilePolicy() {
        fs::create_directories(folder_.path("scene/parts"));
        folder_.write("a.cgfs", k_scene);
        folder_.write("secret.txt", k_secret);
        folder_.write("secret.glint", "secret line\n");
    }
    Finished include(const std::string& text, const std::string& name = "scene/s.pov") {
        folder_.write(name, text);
        return run(folder_,
                   {"info", name, "--format", fs::path(name).extension() == ".pov" ? "povray" : "glint"});
    }
    std::string why(const std::string& path, const cli::FileReach& reach) {
        std::string why;
        return cli::read_named_file(folder_.path(path), reach, why) ? "" : why;
    }
    Folder folder_;
};

TEST_F(FilePolicy, OnlyRegularFilesAreIncluded) {
    ::mkfifo(folder_.path("scene/pipe").c_str(), 0600);
    const int server = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    folder_.path("scene/socket").copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(server, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    for (const char* name : {"pipe", "socket", "parts", "/dev/zero", "/dev/stdin", "/dev/tty"}) {
        const Finished r = include(std::string("#include \"") + name + "\"\n");
        EXPECT_EQ(r.code, 1) << name;
        EXPECT_TRUE(contains(r.err, "not a regular file")) << r.err;
    }
    ::close(server);
}

// They claim to be regular; reading /proc/kmsg waits.
TEST_F(FilePolicy, FilesOfTheKernelAreEmpty) {
    for (const char* name : {"/proc/self/environ", "/proc/kmsg", "/proc/self/cmdline"}) {
        const Finished r = include(std::string("#include \"") + name + "\"\n#error \"after\"\n");
        EXPECT_EQ(r.code, 1);
        EXPECT_TRUE(contains(r.err, "after") || contains(r.err, "Permission denied") ||
                    contains(r.err, "no such file"))
            << r.err;
        EXPECT_FALSE(contains(r.err, "PATH=")) << r.err;
    }
}

TEST_F(FilePolicy, NoLineOfAnotherTypeIsQuoted) {
    for (const char* line : {"#include \"../secret.txt\"", "#include \"link\""}) {
        std::error_code ignored;
        fs::create_symlink("../secret.txt", folder_.path("scene/link"), ignored);
        const Finished r = include(line);
        EXPECT_EQ(r.code, 1);
        EXPECT_TRUE(contains(r.err, ":1:1: error: ")) << r.err;
        EXPECT_FALSE(contains(r.err, "secret:0:0")) << r.err;
    }
    // Of a scene's, it is.
    const Finished scene = include("include \"../secret.glint\"\n", "scene/s.glint");
    EXPECT_TRUE(contains(scene.err, "  secret line\n")) << scene.err;
    // The user's own text has any name.
    folder_.write("mine.txt", k_secret);
    EXPECT_TRUE(contains(run(folder_, {"info", "mine.txt", "--format", "glint"}).err, k_secret));
}

TEST_F(FilePolicy, TheUsersFilesAreAnywhere) {
    folder_.write("common.inc", "sphere { <0, 0, 4>, 1 }\n");
    EXPECT_EQ(include("#include \"../common.inc\"\ncamera { location <0, 0, 0> }\n").code, 0);
    const Finished piped = run(folder_, {"info", "/dev/stdin", "--format", "cgfs"}, with_input(k_scene));
    EXPECT_EQ(piped.code, 0) << piped.err;
}

TEST_F(FilePolicy, ConfinedToFolders) {
    const cli::FileReach reach{.is_confined = true, .folders = {folder_.path("scene")}};
    folder_.write("scene/parts/in.inc", "x");
    fs::create_symlink("parts", folder_.path("scene/inner"));
    fs::create_symlink("..", folder_.path("scene/outer"));
    fs::create_symlink("../secret.txt", folder_.path("scene/link.inc"));
    EXPECT_EQ(why("scene/parts/in.inc", reach), "");
    EXPECT_EQ(why("scene/inner/in.inc", reach), "");
    EXPECT_EQ(why("scene/parts/../parts/in.inc", reach), "");
    const std::string outside = "is outside the folders that may be read here";
    for (const char* path : {"secret.txt", "scene/../secret.txt", "scene/link.inc", "scene/outer/secret.txt",
                             "none.txt", "scene/../none.txt", "scene2", "../../../../../../etc/passwd"})
        EXPECT_EQ(why(path, reach), outside) << path;
    std::string reason;
    EXPECT_FALSE(cli::open_named_file("/etc/passwd", reach, reason).descriptor >= 0);
    EXPECT_EQ(reason, outside);
}

TEST_F(FilePolicy, GradedScenesAndPicturesStayInTheirFolders) {
    folder_.write("scene/s.glint",
                  "include \"../a.cgfs\"\n"
                  "camera { position = (0, 0, 0)  look_at = (0, 0, 1)  fov_x = 50 }\n");
    fs::create_directories(folder_.path("in/ada"));
    fs::create_directories(folder_.path("in/eve"));
    run(folder_, {"render", "a.cgfs", "-s", "8x8", "-o", "in/ada/a.png"});
    fs::create_symlink("../ada/a.png", folder_.path("in/eve/a.png"));
    const Finished outside = run(folder_, {"grade", "in", "--scene", "scene/s.glint", "-s", "8x8"});
    EXPECT_EQ(outside.code, 1);
    EXPECT_TRUE(contains(outside.err, "'../a.cgfs': is outside the folders")) << outside.err;
    const Finished told =
        run(folder_, {"grade", "in", "--scene", "scene/s.glint", "--include-path", ".", "-s", "8x8"});
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(contains(told.out, "is outside the folders")) << told.out;  // eve's picture is ada's
    EXPECT_EQ(run(folder_, {"info", "scene/s.glint"}).code, 0) << "the user's own scene may";
}

TEST_F(FilePolicy, AnIniWritesOnlyIntoItsFolderOrThisOne) {
    fs::create_directories(folder_.path("work/inside"));
    fs::create_directories(folder_.path("elsewhere"));
    fs::create_symlink("../elsewhere", folder_.path("work/link"));
    folder_.write("work/s.pov", "camera { location <0, 0, 0> }\nsphere { <0, 0, 4>, 1 }\n");
    RunOptions options;
    options.program = GLINT_POVRAY;
    const auto run_ini = [&](const std::string& output, const std::vector<std::string>& more = {}) {
        folder_.write("work/s.ini",
                      "Input_File_Name=work/s.pov\nWidth=8\nHeight=8\nOutput_File_Name=" + output + "\n");
        std::vector<std::string> words{"work/s.ini"};
        words.insert(words.end(), more.begin(), more.end());
        return run(folder_, words, options);
    };
    Folder other;
    for (const std::string& path : {other.path("a.png"), other.path() + "/", std::string("../a.png"),
                                    std::string("work/../../a.png"), std::string("/etc/glint_test.png")}) {
        const Finished r = run_ini(path);
        EXPECT_EQ(r.code, 1) << path;
        EXPECT_TRUE(
            contains(r.err, "work/s.ini:4: expected an output in this folder or the .ini file's, found '"))
            << r.err;
        EXPECT_TRUE(contains(r.err, "give +O on the command line")) << r.err;
    }
    EXPECT_EQ(other.count(), 0);
    for (const std::string& path :
         {std::string("a.png"), std::string("work/inside/a.png"), folder_.path("work/b.png")})
        EXPECT_EQ(run_ini(path).code, 0) << path;
    // A link that only a frame of an animation would follow.
    other.write("victim", "kept");
    std::filesystem::create_symlink(other.path("victim"), folder_.path("f1.png"));
    const Finished linked = run_ini("f.png\nFinal_Frame=2");
    EXPECT_EQ(linked.code, 1);
    EXPECT_TRUE(contains(linked.err, "expected an output in this folder or the .ini file's")) << linked.err;
    EXPECT_EQ(other.read("victim"), "kept");
    // A link to a file that does not exist yet; of the output's name, or of the picture beside the scene.
    std::filesystem::create_symlink(other.path("planted.png"), folder_.path("work/g.png"));
    std::filesystem::create_symlink("g.png", folder_.path("work/s.png"));
    EXPECT_EQ(run_ini("work/g.png").code, 1);
    folder_.write("work/beside.ini", "Input_File_Name=work/s.pov\nWidth=8\nHeight=8\n");
    EXPECT_EQ(run(folder_, {"work/beside.ini"}, options).code, 1);
    EXPECT_FALSE(other.has("planted.png"));
    // The user may write anywhere.
    const Finished told = run_ini("/etc/glint_test.png", {"+O" + other.path("a.png")});
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(other.has("a.png"));
    // A scene that an .ini names is a regular file.
    folder_.write("p.ini", "Input_File_Name=/dev/zero\n");
    const Finished device = run(folder_, {"p.ini", "+Oa.png"}, options);
    EXPECT_TRUE(contains(device.err, "/dev/zero: not a regular file")) << device.err;
}

}  // namespace
}  // namespace glint::test
