// SPDX-License-Identifier: Apache-2.0
// Names in scenes, pictures and folders are anybody's: no byte of them may control the terminal.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/text.h"
#include "cli/process.h"

namespace glint::test {
namespace {

// Red, a bell, U+009B (a control sequence of one character), U+202E (from right to left), a newline.
constexpr const char* k_hostile = "x\x1b[31m\x07\xc2\x9b\xe2\x80\xae\ny";

void expect_shown(const std::string& text, const std::string& what) {
    for (std::string_view rest = text; !rest.empty();) {
        const Character c = first_character(rest);
        EXPECT_TRUE(c.is_printable || rest[0] == '\n' || rest[0] == '\t')
            << what << ": byte " << (text.size() - rest.size()) << " of " << printable(text);
        if (!c.is_printable && rest[0] != '\n' && rest[0] != '\t') return;
        rest.remove_prefix(c.length);
    }
}

// The same with material, light and shape of hostile names.
std::string hostile_scene() {
    const std::string name = R"(x\u001b[31m\u0007\u009b\u202e\ny\u007f)";
    return R"({"camera": {"position": [0, 0, 0], "target": [0, 0, -1], "up": [0, 1, 0], "fov": 40},
 "materials": [{"name": ")" +
           name +
           R"(", "color": [0.5, 0.5, 0.5], "ambient": 0.2, "diffuse": 1, "specular": 1, "shininess": 4, "mirror": 0}],
 "lights": [{"position": [0, 5, 0], "color": [1, 1, 1]}],
 "spheres": [{"center": [0, 0, -5], "radius": 1, "material": ")" +
           name + R"("}]})";
}

class HostileNames : public testing::Test {
  protected:
    Finished run_shown(const std::vector<std::string>& arguments, int code) {
        Finished result = run(folder_, arguments);
        const std::string what = printable(arguments.front() + " " + arguments.back());
        EXPECT_EQ(result.code, code) << what << printable_lines(result.err);
        expect_shown(result.out, what);
        expect_shown(result.err, what);
        return result;
    }
    Folder folder_;
};

TEST_F(HostileNames, OfItemsInReports) {
    folder_.write("s.json", hostile_scene());
    for (const std::vector<std::string>& line :
         {std::vector<std::string>{"explain", "s.json", "-s", "8x8", "-p", "4,4"},
          {"explain", "s.json", "-s", "8x8", "-p", "4,4", "--as", "printrays"},
          {"info", "s.json"},
          {"check", "s.json"},
          {"versus", "s.json", "-s", "8x8", "--a", "aa=2"}}) {
        const std::string out = run_shown(line, 0).out;
        EXPECT_FALSE(contains(out, "\ny")) << "a name begins a line of its own: " << printable_lines(out);
    }
    const std::string text = run_shown({"explain", "s.json", "-s", "8x8", "-p", "4,4"}, 0).out;
    EXPECT_TRUE(contains(text, "'x\\x1b[31m\\x07\\xc2\\x9b\\xe2\\x80\\xae\\x0ay\\x7f'"))
        << printable_lines(text);
}

// Where explanations have colors.
TEST_F(HostileNames, InATerminal) {
    folder_.write("s.json", hostile_scene());
    RunOptions options;
    options.program = "/usr/bin/script";
    const std::string line = "env -u NO_COLOR " GLINT_COMMAND " explain s.json -s 8x8 -p 4,4";
    const std::string out = Process(folder_, {"-qec", line, "/dev/null"}, options).finish().out;
    EXPECT_TRUE(contains(out, "'x\\x1b[31m\\x07\\xc2\\x9b\\xe2\\x80\\xae\\x0ay\\x7f'")) << out;
    EXPECT_TRUE(contains(out, "\x1b[48;2;")) << out;
}

TEST_F(HostileNames, InJson) {
    folder_.write("s.json", hostile_scene());
    folder_.write("a\xff\x1b.json", hostile_scene());
    for (const std::vector<std::string>& line :
         {std::vector<std::string>{"explain", "s.json", "-s", "8x8", "-p", "4,4", "--as", "json"},
          {"explain", "a\xff\x1b.json", "-s", "8x8", "-p", "4,4", "--as", "json"},
          {"info", "a\xff\x1b.json", "--json"},
          {"check", "a\xff\x1b.json", "--json"},
          {"versus", "a\xff\x1b.json", "-s", "8x8", "--a", "aa=2", "--json"}}) {
        const std::string out = run_shown(line, 0).out;
        EXPECT_FALSE(nlohmann::json::parse(out, nullptr, false).is_discarded()) << printable_lines(out);
    }
}

TEST_F(HostileNames, OfFiles) {
    const std::string name = k_hostile;
    folder_.write(name + ".cgfs", "sphere { " + name + " }");
    run_shown({"render", name + ".cgfs"}, 1);
    run_shown({"check", name + ".cgfs"}, 1);
    run_shown({"render", name}, 1);
    run_shown({name}, 2);
    run_shown({"render", name + ".cgfs", "-o", name}, 2);
    folder_.write("a.cgfs", k_scene);
    run_shown({"render", "a.cgfs", "-s", "8x8", "-o", name + ".png"}, 0);
    run_shown({"compare", name + ".png", name + ".png"}, 0);
    run_shown({"convert", "a.cgfs", name + ".glint"}, 0);
}

TEST_F(HostileNames, OfAPartOfAnExr) {
    folder_.write("a.cgfs", k_scene);
    run(folder_, {"render", "a.cgfs", "-s", "8x8", "-o", "a.exr"});
    // A name of the part, in front of the other attributes; the rows' places are now wrong.
    std::string bytes = folder_.read("a.exr"), value = k_hostile;
    const std::string length = {static_cast<char>(value.size()), 0, 0, 0};
    bytes.insert(8, std::string("name\0string\0", 12) + length + value);
    folder_.write("b.exr", bytes);
    run_shown({"compare", "b.exr", "a.exr"}, 1);
}

TEST_F(HostileNames, InGrades) {
    folder_.write("a.cgfs", k_scene);
    std::filesystem::create_directory(folder_.path("in"));
    run(folder_, {"render", "a.cgfs", "-s", "8x8", "-o", std::string("in/") + k_hostile + ".png"});
    run(folder_, {"render", "a.cgfs", "-s", "8x8", "-o", "in/=1+1.png"});
    run_shown({"grade", "in", "--scene", "a.cgfs", "-s", "8x8", "--csv", "g.csv", "--json", "g.json"}, 0);
    run_shown({"grade", "in", "--scene", "a.cgfs", "-s", "8x8"}, 0);
    const std::string csv = folder_.read("g.csv");
    std::string lines = csv;
    std::erase(lines, '\r');  // CSV's lines end with it
    expect_shown(lines, "CSV");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3) << printable_lines(csv);
    EXPECT_TRUE(contains(csv, "\n'=1+1,")) << printable_lines(csv);
    EXPECT_FALSE(nlohmann::json::parse(folder_.read("g.json"), nullptr, false).is_discarded());
}

TEST(Escaped, IsShownAndStable) {
    EXPECT_EQ(printable("a\tb\nc"), "a\\x09b\\x0ac");
    EXPECT_EQ(printable_lines("a\tb\nc\r"), "a\tb\nc\\x0d");
    EXPECT_EQ(printable("\x1b[0m\xff\xc3\xa4\xc2\x85"), "\\x1b[0m\\xff\xc3\xa4\\xc2\\x85");
    EXPECT_EQ(printable("\xe2\x80\xa9\xe2\x80\xae\xe2\x81\xa6"),
              "\xe2\x80\xa9\\xe2\\x80\\xae\\xe2\\x81\\xa6");
    EXPECT_EQ(printable(printable(k_hostile)), printable(k_hostile));
}

}  // namespace
}  // namespace glint::test
