// SPDX-License-Identifier: Apache-2.0
// glint grade: the table of a folder of submissions.
#include "cli/grade.h"

#include <cmath>

#include "glint/image.h"
#include "image/read_png.h"

namespace glint::test {
namespace {

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
    // Without a reference, the scene's own picture is used.
    draw("in/zoe.png", {});
    const auto own = graded({"in", "--scene", k_castle, "--size", "96x72"});
    EXPECT_EQ(own[4]["equal"], 1);
}

TEST_F(Grade, TheTableHasBothSentencesOfTwoCauses) {
    draw("right.png", {});
    draw("in/ada.png", {"--no-shadows", "--reflections", "0"});
    const Finished r = grade({"in", "--scene", k_castle, "--reference", "right.png", "--csv", "t.csv"});
    EXPECT_EQ(r.code, 0) << r.err;
    const std::string csv = folder.read("t.csv");
    EXPECT_TRUE(contains(csv, "Shadows are missing")) << csv;
    EXPECT_TRUE(contains(csv, "And then also: ")) << csv;
    EXPECT_TRUE(contains(csv, "Mirrors are missing")) << csv;
}

TEST_F(Grade, WithTheSceneACauseIsNoGuessFromThePicturesAlone) {
    draw("in/ada.ppm", {});
    std::string root = folder.read("in/ada.ppm");
    for (std::size_t i = root.size() - std::size_t{3} * 96 * 72; i < root.size(); ++i) {
        const double value = static_cast<unsigned char>(root[i]) / 255.0;
        root[i] = static_cast<char>(std::lround(255 * std::sqrt(value)));
    }
    folder.write("in/ada.ppm", root);
    const Finished r = grade({"in", "--scene", k_castle, "--size", "96x72", "--csv", "t.csv"});
    EXPECT_EQ(r.code, 0) << r.err;
    const std::string csv = folder.read("t.csv");
    EXPECT_TRUE(contains(csv, "\"Perhaps: A gamma of 1/2.0 was applied")) << csv;
}

TEST_F(Grade, SaysWhatNoCauseExplains) {
    draw("right.png", {});
    draw("in/one.png", {});
    std::string ppm = "P6 96 72 255\n";
    for (int i = 0; i < 96 * 72; ++i) ppm += "\x20\x40\x60";
    folder.write("in/two.ppm", ppm);
    const Finished r = grade({"in", "--reference", "right.png", "--json", "t.json"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "The picture is one color throughout, (32, 64, 96)")) << r.out;
    const auto json = nlohmann::json::parse(folder.read("t.json"));
    ASSERT_EQ(json.size(), 2u);
    EXPECT_TRUE(contains(json[1]["remark"], "one color throughout"));
    EXPECT_TRUE(json[1]["causes"].empty());
}

TEST_F(Grade, SaysThatJpegChangesColors) {
    draw("right.png", {});
    draw("in/ada.jpg", {"--no-shadows"});
    draw("in/ben.png", {"--no-shadows"});
    const Finished r = grade({"in", "--scene", k_castle, "--reference", "right.png", "--json", "t.json"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "; JPEG changes colors a little\n")) << r.out;
    const auto json = nlohmann::json::parse(folder.read("t.json"));
    EXPECT_EQ(json[0]["note"], "JPEG changes colors a little");
    EXPECT_EQ(json[1]["note"], nullptr);
    folder.write("one.rubric", "all 10 *\n");
    std::filesystem::create_directories(folder.path("of/ada"));
    std::filesystem::rename(folder.path("in/ada.jpg"), folder.path("of/ada/a.jpg"));
    const Finished parts = grade({"of", "--scene", k_castle, "--rubric", "one.rubric", "--size", "96x72"});
    EXPECT_TRUE(contains(parts.out, "; JPEG changes colors a little; ")) << parts.out;
}

// Compared as bytes, such pixels are black, and 'unlit' would explain them.
TEST_F(Grade, WhatIsNotANumberIsSaidFirst) {
    const auto write = [&](const char* name, float value, int count) {
        Image image{20, 12, std::vector<float>(720, 0.5f)};
        for (int i = 0; i < 3 * count; ++i) image.rgb[i] = value;
        const auto bytes = encode(image, {FileFormat::exr}).value();
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

// An unreadable submission is a row of the table, and the others are graded. (Root can read every folder, so
// the test uses a name that is too long for the system.)
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
    // The folder of one student stays one submission, whatever else is in it.
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
    // More parts than fit the width of a sheet.
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
        {{"--csv", "./castle.json"}, "--csv './castle.json' would overwrite an input"},
        {{"--json", "one.rubric"}, "--json 'one.rubric' would overwrite an input"},
        {{"--sheet", "right.png"}, "--sheet 'right.png' would overwrite an input"},
        {{"--sheet", "link.png"}, "--sheet 'link.png' would overwrite an input"},
        {{"--csv", "a", "--json", "./a"}, "--csv and --json are the same file, './a'"},
        {{"--csv", "a.png", "--sheet", "in/../a.png"}, "--csv and --sheet are the same file"},
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
    // A table may be written among the pictures.
    EXPECT_EQ(grade({"in", "--reference", "right.png", "--csv", "in/t.csv"}).code, 0);
    EXPECT_EQ(grade({"in", "--reference", "right.png", "--csv", "/dev/null", "--json", "/dev/null"}).code, 0);
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
    const Finished tests = grade({"empty", "--scene", k_castle, "--gradescope", "r.json"});
    EXPECT_EQ(tests.code, 2);
    EXPECT_TRUE(contains(tests.err, "--gradescope needs --rubric FILE")) << tests.err;
    EXPECT_EQ(grade({"empty", "--reference", "right.png", "--rubric", k_rubric}).code, 2);
    EXPECT_EQ(grade({}).code, 2);
}

// File names must not become formulas in a spreadsheet, and must not control the terminal.
TEST_F(Grade, NamesAreText) {
    draw("right.png", {});
    draw("in/=1+2.png", {});
    draw("in/a,\"b\".png", {});
    draw("in/\x1b[2J\nx.png", {});
    const Finished r = grade({"in", "--reference", "right.png", "--csv", "t.csv"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "\\x1b[2J\\x0ax ")) << r.out;
    const std::string csv = folder.read("t.csv");
    EXPECT_TRUE(contains(csv, "\n'=1+2,")) << csv;
    EXPECT_TRUE(contains(csv, "\n\"a,\"\"b\"\"\",")) << csv;
    // U+009B is ESC [ as one character, and some terminals treat the single byte alike.
    std::filesystem::rename(folder.path("in/=1+2.png"), folder.path("in/\xc2\x9b"
                                                                    "2J\xc3\xa9.png"));
    std::filesystem::rename(folder.path("in/a,\"b\".png"), folder.path("in/z\x9b.png"));
    const Finished c1 = grade({"in", "--reference", "right.png"});
    EXPECT_TRUE(contains(c1.out, "  \\xc2\\x9b2J\xc3\xa9 ")) << c1.out;
    EXPECT_TRUE(contains(c1.out, "  z\\x9b ")) << c1.out;
    // The same for texts of a rubric: the name of a part, and of a missing file.
    std::filesystem::create_directory(folder.path("in/ada"));
    folder.write("names.rubric",
                 "\"p\xc2\x9b"
                 "2J\x1b[2J\" 5 none\x1b[2J.png\n");
    const Finished parts = grade({"in", "--scene", k_castle, "--rubric", "names.rubric", "--size", "9x7"});
    EXPECT_TRUE(contains(parts.out, "  p\\xc2\\x9b2J\\x1b[2J  total")) << parts.out;
    EXPECT_TRUE(contains(parts.out, "ada, p\\xc2\\x9b2J\\x1b[2J: no file none\\x1b[2J.png\n")) << parts.out;
    EXPECT_FALSE(contains(parts.out, "\x1b") || contains(parts.out, "\x9b")) << parts.out;
    folder.write("names.rubric", "\"p\x1b[2J\" 5 *.png lights=all without lights=all\n");
    const Finished nothing = grade({"in", "--scene", k_castle, "--rubric", "names.rubric", "--size", "9x7"});
    EXPECT_TRUE(contains(nothing.err, "names.rubric:1: part 'p\\x1b[2J': this part shows nothing"))
        << nothing.err;
}

}  // namespace
}  // namespace glint::test
