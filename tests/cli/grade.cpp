// glint grade: the table of a folder of submissions, by a reference and by RT2's rubric.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "cli/process.h"
#include "glint/image.h"
#include "image/read_png.h"

namespace glint::test {
namespace {

const std::string k_castle = GLINT_SOURCE "/scenes/epfl/castle.json";
const std::string k_rubric = GLINT_SOURCE "/docs/rt2.rubric";

class Grade : public ::testing::Test {
  protected:
    void draw(const std::string& out, std::vector<std::string> more) {
        std::filesystem::create_directories(std::filesystem::path(folder.path(out)).parent_path());
        std::vector<std::string> arguments = {"render", k_castle, "-s", "96x72", "-q", "-o", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished r = run(folder, arguments);
        ASSERT_EQ(r.code, 0) << r.err;
    }
    // The pictures that RT2 asks for.
    void hand_in(const std::string& name) {
        draw(name + "/castle_diffuse.png", {"--shading", "diffuse", "--no-shadows", "--reflections", "0"});
        draw(name + "/castle_phong.png", {"--shading", "phong", "--no-shadows", "--reflections", "0"});
        draw(name + "/castle_blinn.png", {"--no-shadows", "--reflections", "0"});
        draw(name + "/castle_shadows.png", {"--reflections", "0"});
        draw(name + "/castle_reflections.png", {});
        // The ambient part alone: the scene with its lamps out.
        std::ifstream in(k_castle);
        const std::string json{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        const std::size_t lights = json.find("\"lights\"");
        const std::string out = std::regex_replace(
            json.substr(lights), std::regex("(\"position\": \\[[^\\]]*\\], \"color\": )\\[[^\\]]*\\]"),
            "$1[0, 0, 0]");
        folder.write("dark.json", json.substr(0, lights) + out);
        const Finished r = run(folder, {"render", "dark.json", "-s", "96x72", "-q", "-o",
                                        name + "/castle_ambient.png", "--no-shadows", "--reflections", "0"});
        ASSERT_EQ(r.code, 0) << r.err;
    }
    Finished grade(std::vector<std::string> more) {
        more.insert(more.begin(), "grade");
        return run(folder, more);
    }
    nlohmann::json graded(std::vector<std::string> more) {
        more.insert(more.end(), {"--json", "out.json"});
        const Finished r = grade(more);
        EXPECT_EQ(r.code, 0) << r.err;
        return nlohmann::json::parse(folder.read("out.json"));
    }
    const Folder folder;
};

TEST_F(Grade, PicturesAgainstAReference) {
    draw("right.png", {});
    draw("in/ada.png", {});
    draw("in/ben.png", {"--no-shadows"});
    draw("in/eve/picture.png", {"--reflections", "0"});
    draw("in/zoe.png", {"--crop", "20x20+0+0"});
    folder.write("in/max.png", "not a picture");
    folder.write("in/readme.txt", "no picture either");
    const Finished r = grade({"in", "--scene", k_castle, "--reference", "right.png", "--csv", "t.csv",
                              "--json", "t.json", "--sheet", "t.png"});
    EXPECT_EQ(r.code, 0) << r.err;
    const auto json = nlohmann::json::parse(folder.read("t.json"));
    ASSERT_EQ(json.size(), 5u);
    const auto cause = [&](int i) { return json[i]["causes"].empty() ? "" : json[i]["causes"][0]["name"]; };
    EXPECT_EQ(json[0]["name"], "ada");
    EXPECT_EQ(json[0]["equal"], 1);
    EXPECT_EQ(json[1]["name"], "ben");
    EXPECT_EQ(cause(1), "shadows-missing");
    EXPECT_EQ(json[2]["name"], "eve");
    EXPECT_EQ(cause(2), "reflections-missing");
    EXPECT_TRUE(contains(json[3]["error"], "no PNG"));
    EXPECT_TRUE(contains(json[4]["error"], "20x20 pixels, expected 96x72"));
    EXPECT_TRUE(contains(r.out, "1  ada")) << r.out;
    EXPECT_TRUE(contains(r.out, "shadows-missing (100%)")) << r.out;
    const std::string csv = folder.read("t.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
    EXPECT_TRUE(contains(csv, "\r\nben,in/ben.png,6912,0,")) << csv;
    const Picture sheet = read_png(folder.path("t.png"));
    EXPECT_EQ(sheet.error, "");
    EXPECT_GT(sheet.width, 96 * 2);
    // The scene's own picture is the reference if none is given.
    draw("in/zoe.png", {});
    const auto own = graded({"in", "--scene", k_castle, "--size", "96x72"});
    EXPECT_EQ(own[4]["equal"], 1);
}

TEST_F(Grade, SaysWhatNoCauseExplains) {
    draw("right.png", {});
    draw("in/one.png", {});
    std::string ppm = "P6 96 72 255\n";
    for (int i = 0; i < 96 * 72; ++i) ppm += "\x20\x40\x60";
    folder.write("in/two.ppm", ppm);
    const Finished r = grade({"in", "--reference", "right.png", "--json", "t.json"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "The picture is one colour throughout, (32, 64, 96)")) << r.out;
    const auto json = nlohmann::json::parse(folder.read("t.json"));
    ASSERT_EQ(json.size(), 2u);
    EXPECT_TRUE(contains(json[1]["remark"], "one colour throughout"));
    EXPECT_TRUE(json[1]["causes"].empty());
}

// As bytes such pixels are black, and 'unlit' would explain them.
TEST_F(Grade, WhatIsNotANumberIsSaidFirst) {
    const auto write = [&](const char* name, float value, int count) {
        Image image{20, 12, std::vector<float>(720, 0.5f)};
        for (int i = 0; i < 3 * count; ++i) image.rgb[i] = value;
        const auto bytes = encode(image, {FileFormat::exr}).bytes;
        folder.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    };
    write("right.exr", 0.5f, 0);
    std::filesystem::create_directories(folder.path("in/ada"));
    write("in/ada/a.exr", std::nanf(""), 12);
    std::filesystem::create_directory(folder.path("in/ben"));
    write("in/ben/b.exr", HUGE_VALF, 1);
    const Finished r =
        grade({"in", "--reference", "right.exr", "--csv", "t.csv", "--json", "t.json", "--scene", k_castle});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "  12 pixels are NaN or infinite\n")) << r.out;
    EXPECT_TRUE(contains(r.out, "  1 pixel is NaN or infinite\n")) << r.out;
    const std::string csv = folder.read("t.csv");
    EXPECT_TRUE(contains(csv, "\nada,in/ada/a.exr,240,12,")) << csv;
    EXPECT_TRUE(contains(csv, ",,,12 pixels are NaN or infinite,\r\n")) << csv;
    const auto json = nlohmann::json::parse(folder.read("t.json"));
    EXPECT_EQ(json[0]["not_finite"], 12);
    EXPECT_EQ(json[0]["remark"], "12 pixels are NaN or infinite");
    EXPECT_TRUE(json[0]["causes"].empty());
    EXPECT_EQ(json[1]["not_finite"], 1);

    folder.write("one.rubric", "all 10 *.exr\n");
    const Finished parts = grade(
        {"in", "--scene", k_castle, "--rubric", "one.rubric", "--size", "20x12", "--json", "parts.json"});
    EXPECT_EQ(parts.code, 0) << parts.err;
    EXPECT_TRUE(contains(parts.out, "ada, all: 12 pixels are NaN or infinite; ")) << parts.out;
    const auto part = nlohmann::json::parse(folder.read("parts.json"))[0]["parts"][0];
    EXPECT_EQ(part["not_finite"], 12);
    EXPECT_TRUE(part["cause"].is_null());
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
    // One's own folder.
    const auto own = graded({"in/ada", "--scene", k_castle, "--rubric", k_rubric, "--size", "96x72"});
    ASSERT_EQ(own.size(), 1u);
    EXPECT_EQ(own[0]["name"], "ada");
    EXPECT_EQ(own[0]["total"], 90);
}

// The worked example of docs/teaching.md, as it stands there: its commands, and the table that they print.
TEST_F(Grade, TheWorkedExample) {
    std::ifstream in(GLINT_SOURCE "/docs/teaching.md");
    std::string commands, table;
    bool answered = false, inside = false;
    for (std::string line; std::getline(in, line);) {
        inside = inside || line.starts_with("    for student");
        answered = answered || (inside && line == "answers");
        if (line.starts_with("Nobody has handed in")) break;
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

// One student's broken hand-in is a row, and the others are graded. (Root reads every folder: a name that is
// too long for the system stands for one that cannot be read.)
TEST_F(Grade, WhatCannotBeReadIsARow) {
    draw("right.png", {});
    draw("in/ada.png", {});
    const std::string long_name = "eve_" + std::string(100, 'x');
    std::filesystem::create_directory(folder.path("in/" + long_name));
    std::filesystem::copy(folder.path("right.png"), folder.path("in/" + long_name + "/a.png"));
    std::filesystem::create_symlink("loop", folder.path("in/loop"));
    std::filesystem::create_symlink("gone.png", folder.path("in/max.png"));
    std::filesystem::create_directory(folder.path("in/zoe"));
    std::filesystem::create_symlink("nowhere", folder.path("in/zoe/a.png"));
    std::string in = "in";
    while (in.size() < 4050) in += "/.";
    const auto pictures = graded({in, "--reference", "right.png"});
    ASSERT_EQ(pictures.size(), 5u);
    EXPECT_EQ(pictures[0]["equal"], 1);
    EXPECT_EQ(pictures[1]["name"], long_name);
    EXPECT_EQ(pictures[1]["error"], "the folder cannot be read: File name too long");
    EXPECT_EQ(pictures[2]["name"], "loop");
    EXPECT_TRUE(contains(pictures[2]["error"], "Too many levels of symbolic links"));
    EXPECT_EQ(pictures[3]["name"], "max");
    EXPECT_EQ(pictures[3]["error"], "a link to what is not there");
    EXPECT_EQ(pictures[4]["name"], "zoe");
    EXPECT_EQ(pictures[4]["error"], "a link to what is not there");

    folder.write("one.rubric", "all 10 *.png\n");
    std::filesystem::create_directory(folder.path("in/ben"));
    std::filesystem::copy(folder.path("right.png"), folder.path("in/ben/A.PNG"));
    const auto folders =
        graded({in, "--scene", k_castle, "--rubric", "one.rubric", "--size", "96x72", "--sheet", "s.png"});
    ASSERT_EQ(folders.size(), 4u);
    EXPECT_EQ(folders[0]["name"], "ben");
    EXPECT_EQ(folders[0]["total"], 10) << "*.png matches A.PNG";
    EXPECT_EQ(folders[1]["name"], long_name);
    EXPECT_EQ(folders[1]["parts"][0]["error"], "the folder cannot be read: File name too long");
    EXPECT_EQ(folders[2]["name"], "loop");
    EXPECT_TRUE(contains(folders[2]["parts"][0]["error"], "Too many levels of symbolic links"));
    EXPECT_EQ(folders[3]["name"], "zoe");
    EXPECT_EQ(folders[3]["parts"][0]["error"], "a link to what is not there");
    // One's own folder stays that, whatever else lies in it.
    std::filesystem::create_symlink("nowhere", folder.path("in/ben/notes"));
    const auto own = graded({"in/ben", "--scene", k_castle, "--rubric", "one.rubric", "--size", "96x72"});
    ASSERT_EQ(own.size(), 1u);
    EXPECT_EQ(own[0]["name"], "ben");
}

TEST_F(Grade, AFolderWithoutAPictureIsARow) {
    draw("right.png", {});
    draw("in/ada/castle.png", {});
    std::filesystem::create_directory(folder.path("in/ben"));
    folder.write("in/ben/castle.bmp", "BM");
    draw("in/cem/out/castle.png", {});
    std::filesystem::create_directory(folder.path("in/dan"));
    const auto rows = graded({"in", "--reference", "right.png"});
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0]["equal"], 1);
    const char* names[] = {"ben", "cem", "dan"};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(rows[i + 1]["name"], names[i]);
        EXPECT_TRUE(contains(rows[i + 1]["error"], "holds no picture")) << rows[i + 1];
    }
}

TEST_F(Grade, RowsHaveNamesOfTheirOwn) {
    draw("right.png", {});
    for (const char* name : {"in/ada.png", "in/ada.ppm", "in/ada.png.png", "in/ben.png", "in/ben/x.png",
                             "in/eve/x.png", "in/eve/x.ppm", "in/eve/y.png", "in/max/x.png"})
        draw(name, {});
    std::vector<std::string> names;
    for (const auto& row : graded({"in", "--reference", "right.png"})) names.push_back(row["name"]);
    EXPECT_EQ(names, (std::vector<std::string>{"ada.png", "ada.png.png", "ada.ppm", "ben/x.png", "ben.png",
                                               "eve/x.png", "eve/x.ppm", "eve/y", "max"}));
}

TEST_F(Grade, SheetsAreRefusedBeforeTheWork) {
    draw("right.png", {});
    draw("in/ada.png", {});
    const Finished jpeg = grade({"in", "--reference", "right.png", "--sheet", "s.jpg", "--csv", "t.csv"});
    EXPECT_EQ(jpeg.code, 2);
    EXPECT_TRUE(contains(jpeg.err, "--sheet 's.jpg': expected a name that ends in .png")) << jpeg.err;
    EXPECT_FALSE(folder.has("s.jpg") || folder.has("t.csv"));
    EXPECT_EQ(grade({"in", "--reference", "right.png", "--sheet", "-", "--csv", "-"}).code, 2);
    // More parts than a sheet is wide.
    std::string rubric;
    for (int i = 0; i < 1000; ++i) rubric += "all 1 *.png\n";
    folder.write("wide.rubric", rubric);
    const Finished wide =
        grade({"in", "--scene", k_castle, "--rubric", "wide.rubric", "--size", "9x7", "--sheet", "s.png"});
    EXPECT_EQ(wide.code, 1);
    EXPECT_TRUE(contains(wide.err, "2,000 pictures are too many for a sheet")) << wide.err;
}

TEST_F(Grade, OutputsSpareWhatIsRead) {
    draw("right.png", {});
    draw("in/ada.png", {});
    std::filesystem::copy(k_castle, folder.path("castle.json"));
    folder.write("one.rubric", "all 10 *.png\n");
    std::filesystem::create_symlink("right.png", folder.path("link.png"));
    const std::vector<std::string> names = {"castle.json", "one.rubric", "right.png", "in/ada.png"};
    std::vector<std::string> before;
    for (const std::string& name : names) before.push_back(folder.read(name));
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"--csv", "./castle.json"}, "--csv './castle.json' would overwrite what is read"},
        {{"--json", "one.rubric"}, "--json 'one.rubric' would overwrite what is read"},
        {{"--sheet", "right.png"}, "--sheet 'right.png' would overwrite what is read"},
        {{"--sheet", "link.png"}, "--sheet 'link.png' would overwrite what is read"},
        {{"--csv", "a", "--json", "./a"}, "--csv and --json are one file, './a'"},
        {{"--csv", "a.png", "--sheet", "in/../a.png"}, "--csv and --sheet are one file"},
        {{"--csv", "in/ada.png"}, "--csv 'in/ada.png' is in 'in/.', where the next run"},
        {{"--sheet", "in/sheet.png"},
         "where the next run would take it for handed in: write it into a folder"}};
    for (const auto& [outputs, message] : cases) {
        std::vector<std::string> arguments = {"in/.",        "--scene",   "castle.json",
                                              "--reference", "right.png", "--rubric",
                                              "one.rubric",  "--size",    "96x72"};
        arguments.insert(arguments.end(), outputs.begin(), outputs.end());
        const Finished r = grade(arguments);
        EXPECT_EQ(r.code, 2) << message;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
        EXPECT_EQ(r.out, "");
    }
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(folder.read(names[i]), before[i]) << names[i];
    EXPECT_FALSE(folder.has("a") || folder.has("a.png") || folder.has("in/sheet.png"));
    // A table lies among the pictures unharmed, and nothing is lost where nothing is kept.
    EXPECT_EQ(grade({"in", "--reference", "right.png", "--csv", "in/t.csv"}).code, 0);
    EXPECT_EQ(grade({"in", "--reference", "right.png", "--csv", "/dev/null", "--json", "/dev/null"}).code, 0);
}

TEST_F(Grade, BlackPicturesGetNothing) {
    hand_in("in/ada");
    std::string black = "P6\n96 72\n255\n";
    black.resize(black.size() + 96 * 72 * 3);
    for (const char* name : {"ambient", "diffuse", "phong", "blinn", "shadows", "reflections"})
        folder.write("in/ada/castle_" + std::string(name) + ".png", black);  // whatever its name says
    EXPECT_EQ(graded({"in", "--scene", k_castle, "--rubric", k_rubric, "--size", "96x72"})[0]["total"], 0);
}

TEST_F(Grade, BadInput) {
    draw("right.png", {});
    std::filesystem::create_directory(folder.path("empty"));
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"none", "--reference", "right.png"}, "folder 'none': No such file"},
        {{"right.png", "--reference", "right.png"}, "folder 'right.png': Not a directory"},
        {{"empty", "--reference", "right.png"}, "folder 'empty' holds no pictures"},
        {{"empty", "--reference", "none.png"}, "none.png: no such file"},
        {{"empty", "--scene", k_castle, "--rubric", "none.rubric"}, "none.rubric: no such file"}};
    for (const auto& [arguments, message] : cases) {
        const Finished r = grade(arguments);
        EXPECT_EQ(r.code, 1) << message;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
    }
    EXPECT_EQ(grade({"empty"}).code, 2);
    EXPECT_EQ(grade({"empty", "--reference", "right.png", "--rubric", k_rubric}).code, 2);
    EXPECT_EQ(grade({}).code, 2);
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
    // No more than anyone reads, and nothing that the terminal would take for an order.
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
    EXPECT_TRUE(contains(empty.err, "the rubric has no parts")) << empty.err;
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

// A file's name is not to become a formula in a spreadsheet, nor to clear a terminal.
TEST_F(Grade, NamesAreText) {
    draw("right.png", {});
    draw("in/=1+2.png", {});
    draw("in/a,\"b\".png", {});
    draw("in/\x1b[2J\nx.png", {});
    const Finished r = grade({"in", "--reference", "right.png", "--csv", "t.csv"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "?[2J?x ")) << r.out;
    const std::string csv = folder.read("t.csv");
    EXPECT_TRUE(contains(csv, "\n'=1+2,")) << csv;
    EXPECT_TRUE(contains(csv, "\n\"a,\"\"b\"\"\",")) << csv;
    // U+009B is ESC [ in one character, and the byte alone is so to some terminals.
    std::filesystem::rename(folder.path("in/=1+2.png"), folder.path("in/\xc2\x9b"
                                                                    "2J\xc3\xa9.png"));
    std::filesystem::rename(folder.path("in/a,\"b\".png"), folder.path("in/z\x9b.png"));
    const Finished c1 = grade({"in", "--reference", "right.png"});
    EXPECT_TRUE(contains(c1.out, "  ?2J\xc3\xa9 ")) << c1.out;
    EXPECT_TRUE(contains(c1.out, "  z? ")) << c1.out;
    // So with what a rubric says: a part's name, and a file's that nobody handed in.
    std::filesystem::create_directory(folder.path("in/ada"));
    folder.write("names.rubric",
                 "\"p\xc2\x9b"
                 "2J\x1b[2J\" 5 none\x1b[2J.png\n");
    const Finished parts = grade({"in", "--scene", k_castle, "--rubric", "names.rubric", "--size", "9x7"});
    EXPECT_TRUE(contains(parts.out, "  p?2J?[2J  total")) << parts.out;
    EXPECT_TRUE(contains(parts.out, "ada, p?2J?[2J: no file none?[2J.png\n")) << parts.out;
    EXPECT_FALSE(contains(parts.out, "\x1b") || contains(parts.out, "\x9b")) << parts.out;
    folder.write("names.rubric", "\"p\x1b[2J\" 5 *.png lights=all without lights=all\n");
    const Finished nothing = grade({"in", "--scene", k_castle, "--rubric", "names.rubric", "--size", "9x7"});
    EXPECT_TRUE(contains(nothing.err, "part 'p\\x1b[2J': this part shows nothing")) << nothing.err;
}

}  // namespace
}  // namespace glint::test
