// SPDX-License-Identifier: Apache-2.0
// glint grade --rubric: the rubric of RT2, the worked example, and errors in rubrics.
#include "cli/grade.h"
#include "image/read_png.h"

namespace glint::test {
namespace {

// The log of a program at some pixels is feedback: what is wrong in it, and no points.
TEST_F(Grade, LogsGiveNoPoints) {
    hand_in("in/ada");
    hand_in("in/ben");
    folder.write("in/ada/mine.log",
                 "pixel 40 30\nray camera\nmiss\nend\npixel 41 30\nray camera\nmiss\nend\n");
    folder.write("in/ben/mine.log", "pixel 40\n");
    const std::vector<std::string> arguments = {"in",     "--scene", k_castle, "--rubric",
                                                k_rubric, "--size",  "96x72"};
    std::vector<std::string> with_logs = arguments;
    with_logs.insert(with_logs.end(), {"--logs", "*.log"});
    const auto without = graded(arguments), json = graded(with_logs);
    ASSERT_EQ(json.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(json[i]["total"], without[i]["total"]);
    EXPECT_FALSE(without[0].contains("log"));
    EXPECT_EQ(json[0]["log"]["findings"][0]["quantity"], "shape");
    EXPECT_TRUE(contains(json[0]["log"]["file"], "in/ada/mine.log"));
    EXPECT_TRUE(contains(json[1]["log"]["error"], "expected `pixel X Y`")) << json[1]["log"];
    with_logs.insert(with_logs.begin(), "grade");
    const auto table = run(folder, with_logs);
    EXPECT_TRUE(contains(
        table.out,
        "Logs, which give no points:\n  1  ada: mine.log: The shape that is hit is wrong in 2 of 2 pixels"))
        << table.out;
    // For a student.
    const auto own = run(folder, {"grade", "in/ada", "--scene", k_castle, "--rubric", k_rubric, "--size",
                                  "96x72", "--logs", "*.log", "--hide-causes", "--gradescope", "-"});
    EXPECT_TRUE(contains(
        own.out, "The log, which gives no points: mine.log: The shape that is hit is wrong in 2 of 2 pixels"))
        << own.out;
    EXPECT_EQ(run(folder, {"grade", "in", "--scene", k_castle, "--logs", "*.log"}).code, 2);
}

TEST_F(Grade, ByRt2sRubric) {
    hand_in("in/ada");
    hand_in("in/ben");
    hand_in("in/eve");
    draw("in/ben/castle_shadows.png", {"--reflections", "0", "--no-shadows"});
    std::filesystem::remove(folder.path("in/eve/castle_diffuse.png"));
    draw("in/eve/castle_blinn.png", {"--shading", "phong", "--no-shadows", "--reflections", "0"});
    const std::vector<std::string> arguments = {"in",    "--scene", k_castle, "--rubric", k_rubric, "--size",
                                                "96x72", "--csv",   "t.csv",  "--sheet",  "t.png"};
    const auto json = graded(arguments);
    ASSERT_EQ(json.size(), 3u);
    EXPECT_EQ(json[0]["total"], 90);
    EXPECT_EQ(json[0]["of"], 90);
    ASSERT_EQ(json[1]["parts"].size(), 7u);
    EXPECT_EQ(json[1]["parts"][5]["part"], "shadows");
    EXPECT_EQ(json[1]["parts"][5]["points"], 0);
    EXPECT_EQ(json[1]["parts"][5]["cause"]["name"], "shadows-missing");
    EXPECT_EQ(json[1]["total"], 65);
    EXPECT_EQ(json[2]["parts"][1]["points"], 0);
    EXPECT_TRUE(contains(json[2]["parts"][1]["error"], "no file *diffuse*.png"));
    EXPECT_LT(json[2]["parts"][3]["points"], 5) << "Phong for Blinn-Phong";
    EXPECT_EQ(json[2]["parts"][3]["cause"]["name"], "shading-model");
    EXPECT_EQ(json[2]["parts"][2]["points"], 10);
    const std::string csv = folder.read("t.csv");
    EXPECT_TRUE(
        csv.starts_with("name,ambient,diffuse,phong,blinn-phong,sum of lights,shadows,reflections,total,of,"))
        << csv;
    EXPECT_TRUE(contains(csv, "\nada,5.00,15.00,10.00,10.00,5.00,25.00,20.00,90.00,90.00,")) << csv;
    EXPECT_EQ(read_png(folder.path("t.png")).error, "");
    // A folder of one student.
    const auto own = graded({"in/ada", "--scene", k_castle, "--rubric", k_rubric, "--size", "96x72"});
    ASSERT_EQ(own.size(), 1u);
    EXPECT_EQ(own[0]["name"], "ada");
    EXPECT_EQ(own[0]["total"], 90);
}

// The worked example of docs/teaching.md: its commands print the table shown there.
TEST_F(Grade, TheWorkedExample) {
    std::ifstream in(GLINT_SOURCE "/docs/teaching.md");
    std::string commands, table;
    bool answered = false, inside = false;
    for (std::string line; std::getline(in, line);) {
        inside = inside || line.starts_with("    sed ");
        answered = answered || (inside && line == "answers");
        if (line.starts_with("No student handed in")) break;
        if (inside && line.starts_with("    ")) (answered ? table : commands) += line.substr(4) + "\n";
    }
    std::filesystem::copy(k_castle, folder.path("castle.json"));
    std::filesystem::copy(k_rubric, folder.path("rt2.rubric"));
    folder.write("commands", commands);
    const std::string glint_folder = std::filesystem::path(GLINT_COMMAND).parent_path();
    const std::string line =
        "cd '" + folder.path() + "' && PATH='" + glint_folder + "':$PATH sh -e commands > table 2> errors";
    EXPECT_EQ(std::system(line.c_str()), 0) << folder.read("errors");
    std::string found = folder.read("table");
    found.erase(
        std::unique(found.begin(), found.end(), [](char a, char b) { return a == '\n' && b == '\n'; }),
        found.end());  // the page's empty lines are not indented
    EXPECT_EQ(found, table);
    EXPECT_GT(table.size(), 500u);
}

TEST_F(Grade, BlackPicturesGetNothing) {
    hand_in("in/ada");
    std::string black = "P6\n96 72\n255\n";
    black.resize(black.size() + 96 * 72 * 3);
    for (const char* name : {"ambient", "diffuse", "phong", "blinn", "shadows", "reflections"})
        folder.write("in/ada/castle_" + std::string(name) + ".png", black);  // whatever its name says
    EXPECT_EQ(graded({"in", "--scene", k_castle, "--rubric", k_rubric, "--size", "96x72"})[0]["total"], 0);
}

TEST_F(Grade, MistakesInARubricHaveTheirPlace) {
    std::filesystem::create_directory(folder.path("in"));
    folder.write("bad.rubric",
                 "# a comment\n"
                 "ambient five *.png\n"
                 "diffuse 15\n"
                 "phong 10 *.png shadding=phong\n"
                 "phong 10 *.png shading=plastic   # and a comment\n"
                 "\"sum of 5 *.png\n"
                 "shadows 25 *.png lights=none\n"
                 "shadows 25 *.png size=3x4\n"
                 "shadows 25 *.png without\n"
                 "shadows 25 *.png reflections\n"
                 "\"\" 25 *.png\n"
                 "shadows 25 \"\"\n");
    const Finished r = grade({"in", "--scene", k_castle, "--rubric", "bad.rubric"});
    EXPECT_EQ(r.code, 1);
    for (const char* message :
         {"bad.rubric:2:9: error: expected the part's points",
          "bad.rubric:3:9: error: expected PART POINTS FILE",
          "bad.rubric:4:16: error: there is no setting 'shadding' for a rubric; did you mean "
          "`shading`?",
          "bad.rubric:5:16: error: expected phong | blinn-phong", "bad.rubric:6:2: error: the quote",
          "bad.rubric:7:18: error: expected all, ambient or a number",
          "bad.rubric:8:18: error: there is no setting 'size' for a rubric: --size, or --reference, gives",
          "bad.rubric:9:18: error: expected KEY=VALUE after",
          "bad.rubric:10:18: error: expected KEY=VALUE, found 'reflections'",
          "bad.rubric:11:2: error: the part has no name",
          "bad.rubric:12:13: error: expected the file of a submission"}) {
        EXPECT_TRUE(contains(r.err, message)) << message << "\n" << r.err;
    }
    EXPECT_FALSE(contains(r.err, "`size`")) << r.err;
    // The message is short and contains no terminal control characters.
    std::string many;
    for (int i = 0; i < 1000; ++i) many += "part five \x1b[31m\x07*.png\n";
    folder.write("many.rubric", many);
    const Finished capped = grade({"in", "--scene", k_castle, "--rubric", "many.rubric"});
    EXPECT_EQ(capped.code, 1);
    EXPECT_TRUE(contains(capped.err, "many.rubric:20:6: error:")) << capped.err;
    EXPECT_FALSE(contains(capped.err, "many.rubric:21:")) << capped.err;
    EXPECT_EQ(capped.err.find_first_of("\x1b\x07"), std::string::npos) << capped.err;
    EXPECT_TRUE(contains(capped.err, "  part five  [31m *.png\n       ^~~~\n")) << capped.err;
    folder.write("empty.rubric", "# nothing\n\n");
    const Finished empty = grade({"in", "--scene", k_castle, "--rubric", "empty.rubric"});
    EXPECT_EQ(empty.code, 1);
    EXPECT_TRUE(contains(empty.err, "empty.rubric:1:1: error: the rubric has no parts")) << empty.err;
}

TEST_F(Grade, AByteOrderMarkIsNoPartOfARubric) {
    draw("in/ada/castle.png", {});
    folder.write("marked.rubric", "\xef\xbb\xbf# a comment\nall 10 *.png\n");
    EXPECT_EQ(graded({"in", "--scene", k_castle, "--rubric", "marked.rubric", "--size", "96x72"})[0]["total"],
              10);
    folder.write("wrong.rubric",
                 "\xef\xbb\xbf"
                 "all ten *.png\n");
    const Finished r = grade({"in", "--scene", k_castle, "--rubric", "wrong.rubric"});
    EXPECT_TRUE(contains(r.err, "wrong.rubric:1:5: error: ")) << r.err;
}

// A class whose pictures all have another size has no part right, which is not the fault of its lighting.
TEST_F(Grade, AClassOfAnotherSizeStops) {
    folder.write("all.rubric", "all 10 *.png\n");
    for (const char* name : {"in/ada/a.png", "in/ben/a.png"}) draw(name, {});
    const Finished r = grade({"in", "--scene", k_castle, "--rubric", "all.rubric"});
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "all 2 pictures are 96x72, and the reference is 640x640: use --size 96x72"))
        << r.err;
    EXPECT_EQ(r.out, "");
    const Finished own = grade({"in", "--scene", k_castle, "--size", "80x60"});
    EXPECT_EQ(own.code, 1);
    EXPECT_TRUE(contains(own.err, "use --size 96x72")) << own.err;
    const auto draw_small = [&](const char* name) {
        const Finished drawn = run(folder, {"render", k_castle, "-s", "80x60", "-q", "-o", name});
        ASSERT_EQ(drawn.code, 0) << drawn.err;
    };
    draw_small("right.png");
    const Finished other = grade({"in", "--reference", "right.png"});
    EXPECT_EQ(other.code, 1);
    EXPECT_TRUE(contains(other.err, "the reference is 80x60: give a reference of that size")) << other.err;
    // Only one student's is wrong.
    draw_small("in/ada/a.png");
    const auto json = graded({"in", "--scene", k_castle, "--rubric", "all.rubric", "--size", "80x60"});
    EXPECT_EQ(json[0]["total"], 10);
    EXPECT_TRUE(contains(json[1]["parts"][0]["error"], "96x72 pixels, expected 80x60"));
}

TEST_F(Grade, FilesOfOtherNamesAreListed) {
    folder.write("all.rubric", "all 10 right.png\nother 10 left.png\n");
    draw("in/ada/right.png", {});
    folder.write("in/ada/left.jpg", "x");
    draw("in/ada/out/left.png", {});
    draw("in/ben/right.png", {});
    const auto json = graded({"in", "--scene", k_castle, "--rubric", "all.rubric", "--size", "96x72"});
    EXPECT_EQ(json[0]["parts"][1]["error"], "no file left.png; found left.jpg, out/left.png");
    EXPECT_EQ(json[1]["parts"][1]["error"], "no file left.png");
}

// Of a dark scene most pixels are black.
TEST_F(Grade, ABlackPictureHasNoPoints) {
    const std::string dark = R"(
camera { position = (0, 0, 7)  look_at = (0, 0, 0)  fov_x = 48 }
light { type = point  position = (3, 5, 4) }
sphere { center = (0, 0, 0)  radius = 0.9  color = (0.9, 0.2, 0.2) }
render { size = 96 x 72 })";
    folder.write("dark.glint", dark);
    folder.write("all.rubric", "all 10 *.ppm\n");
    std::filesystem::create_directories(folder.path("in/ada"));
    folder.write("in/ada/a.ppm", "P6 96 72 255\n" + std::string(3 * 96 * 72, '\0'));
    const auto json = graded({"in", "--scene", "dark.glint", "--rubric", "all.rubric"});
    EXPECT_EQ(json[0]["total"], 0) << json;
    // Where nothing is visible, black is right.
    folder.write("night.glint", "sphere { center = (0, 0, 9)  radius = 1 }\n" +
                                    dark.substr(0, dark.find("light")) + "render { size = 96 x 72 }");
    const auto night = graded({"in", "--scene", "night.glint", "--rubric", "all.rubric"});
    EXPECT_EQ(night[0]["total"], 10) << night;
}

}  // namespace
}  // namespace glint::test
