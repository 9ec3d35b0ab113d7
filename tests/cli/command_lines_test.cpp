// SPDX-License-Identifier: Apache-2.0
// Command lines that are not valid, of all programs: the exit code, and one message that says what was
// expected.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "cli/command_line.h"
#include "cli/failure.h"
#include "cli/process.h"
#include "cli/text.h"
#include "mpi/command_line.h"

namespace glint::test {
namespace {

struct WrongLine {
    std::vector<std::string> arguments;
    int code;
    const char* message;  // a regular expression for a part of the message
};

// Messages of the program itself are one line, and perhaps where the help is.
const std::regex k_one_message(
    "glint(-[a-z]+)?( [a-z]+)?: [^\n]+\n(see 'glint(-[a-z]+)?( [a-z]+)? --help'\n)?");

void expect_refused(const WrongLine& line, const Finished& run) {
    const std::string shown = fmt::format("{}\n{}", fmt::join(line.arguments, " | "), run.err);
    EXPECT_EQ(run.code, line.code) << shown;
    EXPECT_EQ(run.out, "") << shown;
    EXPECT_TRUE(std::regex_match(run.err, k_one_message)) << shown;
    EXPECT_TRUE(std::regex_search(run.err, std::regex(line.message))) << line.message << "\n" << shown;
}

class CommandLines : public testing::Test {
  protected:
    CommandLines() {
        folder_.write("a.cgfs", k_scene);
        folder_.write("b.tiles", "no tiles");
        std::filesystem::create_directory(folder_.path("in"));
    }
    void expect_all_refused(std::span<const WrongLine> lines, const std::string& program) {
        const long files = folder_.count();
        RunOptions options;
        options.program = program;
        for (const WrongLine& line : lines) expect_refused(line, run(folder_, line.arguments, options));
        EXPECT_EQ(folder_.count(), files) << "nothing is written";
    }
    Folder folder_;
};

TEST_F(CommandLines, OfGlint) {
    const WrongLine lines[] = {
        {{""}, 2, "there is no command ''"},
        {{"."}, 2, "'.' is not a command; did you mean 'glint render .'"},
        {{"-"}, 2, "'-' is not a command"},
        {{"--"}, 2, "expected a command"},
        {{"--", "render"}, 2, "expected a command"},
        {{"-o"}, 2, "'-o' belongs after a command"},
        {{"=", "="}, 2, "there is no command '='"},
        {{"\x1b[31m"}, 2, "there is no command"},
        {{"none"}, 2, "there is no command 'none'; there are render, "},
        // No argument, and only the end of the options.
        {{"render"}, 2, "expected SCENE"},
        {{"render", "--"}, 2, "expected SCENE"},
        {{"info"}, 2, "expected SCENE, or --isa"},
        {{"convert"}, 2, "expected SCENE... and OUT.glint|expected SCENE"},
        {{"check"}, 2, "expected SCENE"},
        {{"explain"}, 2, "expected SCENE and --pixel X,Y"},
        {{"compare"}, 2, "expected FILE"},
        {{"versus"}, 2, "expected SCENE"},
        {{"grade"}, 2, "expected DIR"},
        {{"join"}, 2, "expected FILE and --output OUT"},
        {{"completion"}, 2, "expected SHELL"},
        {{"man", "none"}, 2, "there is no command 'none'"},
        {{"help", "none"}, 2, "there is no command 'none'"},
        {{"version", "x"}, 2, "unexpected argument 'x'"},
        // Files that are not there, or are none.
        {{"render", "none.cgfs"}, 1, "none.cgfs: no such file"},
        {{"info", "none.cgfs"}, 1, "none.cgfs: no such file"},
        {{"convert", "none.cgfs", "b.glint"}, 1, "none.cgfs: no such file"},
        {{"check", "none.cgfs"}, 1, "none.cgfs: no such file"},
        {{"explain", "none.cgfs", "-p", "1,1"}, 1, "none.cgfs: no such file"},
        {{"compare", "none.png", "none.png"}, 1, "none.png: no such file"},
        {{"versus", "none.cgfs", "--a", "aa=2"}, 1, "none.cgfs: no such file"},
        {{"grade", "none", "--scene", "a.cgfs"}, 1, "folder 'none': No such file"},
        {{"grade", "in", "--scene", "none.cgfs"}, 1, "none.cgfs: no such file"},
        {{"grade", "in", "--scene", "a.cgfs", "--rubric", "none"}, 1, "none: no such file"},
        {{"grade", "in", "--reference", "none.png"}, 1, "none.png: no such file"},
        {{"join", "none.tiles", "-o", "c.png"}, 1, "none.tiles: no such file"},
        {{"render", "in"}, 1, "in: is a folder"},
        {{"info", "in"}, 1, "in: is a folder"},
        {{"check", "in"}, 1, "in: is a folder"},
        {{"compare", "in", "in"}, 1, "in: is a folder"},
        {{"join", "in", "-o", "c.png"}, 1, "in: is a folder"},
        {{"grade", "a.cgfs", "--scene", "a.cgfs"}, 1, "folder 'a.cgfs': Not a directory"},
        {{"render", "a.cgfs", "-o", "in"}, 1, "'in': is a folder"},
        {{"render", "a.cgfs", "-o", "in/none/a.png"}, 1, "there is no folder 'in/none'"},
        {{"convert", "a.cgfs", "in"}, 1, "'in': is a folder"},
        // Of another type.
        {{"join", "b.tiles", "-o", "c.png"}, 1, "b.tiles: it is no journal of glint"},
        {{"compare", "a.cgfs", "a.cgfs"}, 1, "a.cgfs: no PNG"},
        {{"render", "a.cgfs", "-o", "a.txt"}, 2, "--output 'a.txt': glint writes"},
        {{"convert", "a.cgfs", "b.txt"}, 2, "OUT 'b.txt': glint writes scenes as .glint"},
        // Empty names and values, as of a variable of the shell that is not set.
        {{"render", ""}, 2, "SCENE: expected a name, found nothing"},
        {{"info", ""}, 2, "SCENE: expected a name, found nothing"},
        {{"convert", "a.cgfs", ""}, 2, "SCENE: expected a name, found nothing"},
        {{"check", ""}, 2, "SCENE: expected a name, found nothing"},
        {{"explain", "", "-p", "1,1"}, 2, "SCENE: expected a name, found nothing"},
        {{"compare", "", ""}, 2, "FILE: expected a name, found nothing"},
        {{"versus", "", "--a", "aa=2"}, 2, "SCENE: expected a name, found nothing"},
        {{"grade", "", "--scene", "a.cgfs"}, 2, "DIR: expected a name, found nothing"},
        {{"join", "", "-o", "c.png"}, 2, "FILE: expected a name, found nothing"},
        {{"render", "a.cgfs", "-o", ""}, 2, "--output: expected OUT, found nothing"},
        {{"render", "a.cgfs", "--aa", ""}, 2, "--aa: expected N.*, found nothing"},
        {{"render", "a.cgfs", "-s", ""}, 2, "--size: expected WxH, found nothing"},
        {{"render", "a.cgfs", "--crop", ""}, 2, "--crop: expected WxH.X.Y, found nothing"},
        {{"render", "a.cgfs", "--isa", ""}, 2, "--isa: expected NAME, found nothing"},
        {{"render", "a.cgfs", "--part", ""}, 2, "--part: expected K/N, found nothing"},
        {{"render", "a.cgfs", "--stats", ""}, 2, "--stats: expected FILE.json, found nothing"},
        {{"render", "a.cgfs", "--scene", ""}, 2, "--scene: expected NAME, found nothing"},
        {{"render", "a.cgfs", "--profile", ""}, 2, "--profile: expected NAME.FILE, found nothing"},
        {{"render", "a.cgfs", "--include-path", ""}, 2, "--include-path: expected DIR, found nothing"},
        {{"render", "a.cgfs", "--shading", ""}, 2, "--shading: expected phong.*, found nothing"},
        {{"render", "a.cgfs", "--reflections", ""}, 2, "--reflections: expected N, found nothing"},
        {{"render", "a.cgfs", "--seed", ""}, 2, "--seed: expected N, found nothing"},
        {{"compare", "a.cgfs", "--vary", ""}, 2, "--vary: expected KEY=VALUES, found nothing"},
        {{"grade", "in", "--scene", "a.cgfs", "--csv", ""}, 2, "--csv: expected OUT, found nothing"},
        // Wrong values.
        {{"render", "a.cgfs", "-t", "1.5"}, 2, "whole number from 0 to 1024, found '1.5'"},
        {{"render", "a.cgfs", "--seed", "-1"}, 2, "whole number from 0 to 4294967295, found '-1'"},
        {{"render", "a.cgfs", "--reflections", "1e3"}, 2, "whole number from 0 to 1000, found '1e3'"},
        {{"render", "a.cgfs", "--bits", "32"}, 2, "expected 8 or 16, found '32'"},
        {{"render", "a.cgfs", "--part", "5/4"}, 2, "K from 1 to N, as 2/4, found '5/4'"},
        {{"render", "a.cgfs", "--isa", "x"}, 2, "no instruction set 'x'"},
        {{"render", "a.cgfs", "--profile", "in"}, 2, "'in' is neither a profile nor a readable file"},
        {{"explain", "a.cgfs", "-p", "1,"}, 2, "expected X,Y, as 320,200, found '1,'"},
        {{"explain", "a.cgfs", "-p", "-1,1"}, 2, "the picture has 600x600 pixels"},
        {{"explain", "a.cgfs", "-p", "1,1", "--as", "xml"}, 2, "expected text, .*found 'xml'"},
        {{"explain", "a.cgfs", "-p", "1,1", "--sample", "x"}, 2, "--sample: expected I,J"},
        {{"compare", "a.png", "b.png", "--within", "x"}, 2, "expected a number from 0 to 1000000, found 'x'"},
        {{"compare", "a.png"}, 2, "expected two pictures, found 1"},
        {{"compare", "a", "b", "c"}, 2, "expected two pictures, found 3"},
        {{"compare", "a.cgfs", "--vary", "aa"}, 2, "expected KEY=A..B or KEY=VALUE,VALUE"},
        {{"compare", "a.cgfs", "--vary", "aa=3..1"}, 2, "expected A..B, two whole numbers, A below B"},
        {{"versus", "a.cgfs", "--a", "aa"}, 2, "expected KEY=VALUE, found 'aa'"},
        {{"versus", "a.cgfs", "--a", "=2"}, 2, "--a: there is no setting ''"},
        {{"completion", "tcsh"}, 2, "expected bash, zsh or fish, found 'tcsh'"},
        {{"completion", "bash", "--program", "x"}, 2, "expected glint, .*found 'x'"},
        // Missing values, repeated options, unknown options and those of other commands.
        {{"render", "a.cgfs", "-o"}, 2, "--output: expected OUT, found nothing"},
        {{"explain", "a.cgfs", "-p"}, 2, "--pixel: expected X,Y, found nothing"},
        {{"grade", "in", "--csv"}, 2, "--csv: expected OUT, found nothing"},
        {{"join", "b.tiles", "-o"}, 2, "--output: expected OUT, found nothing"},
        {{"render", "a.cgfs", "-o", "1.png", "-o", "2.png"}, 2, "--output is given 2 times: expected once"},
        {{"explain", "a.cgfs", "-p", "1,1", "-p", "2,2"}, 2, "--pixel is given 2 times: expected once"},
        {{"join", "b.tiles", "-o", "1.png", "-o", "2.png"}, 2, "--output is given 2 times: expected once"},
        {{"render", "a.cgfs", "-p", "1,2"}, 2, "unknown option '-p'|unexpected arguments '-p', '1,2'"},
        {{"info", "a.cgfs", "--csv"}, 2, "unknown option '--csv'"},
        {{"check", "a.cgfs", "--sheet"}, 2, "unknown option '--sheet'"},
        {{"join", "b.tiles", "-o", "c.png", "--aa", "2"}, 2, "unexpected argument|unknown option '--aa'"},
        {{"render", "a.cgfs", "--json"}, 2, "unknown option '--json'"},
        {{"render", "a.cgfs", "--quiet=maybe"}, 2, "--quiet takes no value"},
        // Contradictions.
        {{"render", "a.cgfs", "-o", "-", "--show"}, 2, "cannot both go to standard output"},
        {{"render", "a.cgfs", "-o", "-", "--resume"}, 2, "name a file with --output"},
        {{"render", "a.cgfs", "--part", "1/2", "-o", "x.png"}, 2, "--part writes tiles"},
        {{"render", "-", "-", "--format", "cgfs"}, 2, "standard input can be read only once"},
        {{"grade", "in", "--reference", "a.png", "--csv", "x", "--json", "x"}, 2, "are the same file, 'x'"},
        {{"grade", "in", "--scene", "a.cgfs", "--gradescope", "g"}, 2, "--gradescope needs --rubric"},
        {{"grade", "in", "--reference", "a.png", "--rubric", "r"}, 2, "--rubric needs --scene"},
        {{"grade", "in"}, 2, "expected --scene FILE, or --reference PICTURE"},
        {{"versus", "a.cgfs"}, 2, "expected --a KEY=VALUE or --b KEY=VALUE"},
    };
    expect_all_refused(lines, GLINT_COMMAND);
}

TEST_F(CommandLines, OfGlintPovray) {
    const WrongLine lines[] = {
        {{}, 1, "expected the name of a scene: .Iscene.pov"},
        {{""}, 1, "expected the name of a scene"},
        {{"+I"}, 1, "expected the name of a scene"},
        {{"none"}, 1, "none.pov: no such file"},
        {{"+Inone.pov"}, 1, "none.pov: no such file"},
        {{"in"}, 1, "in: is a folder"},
        {{"none.ini"}, 1, "none.ini: no such file"},
        {{"none.ini[x]"}, 1, "none.ini: no such file"},
        {{"a.pov", "+W"}, 1, "'.W': expected a number from 0 to 65536"},
        {{"a.pov", "+W-3"}, 1, "'.W-3': expected a number from 0 to 65536"},
        {{"a.pov", "Width=1e9"}, 1, "'Width=1e9': expected a number from 0 to 65536"},
        {{"a.pov", "Width="}, 1, "'Width=': expected a number"},
        {{"a.pov", "=3"}, 1, "unknown key ''"},
        {{"a.pov", "Widht=3"}, 1, "unknown key 'Widht'"},
        {{"a.pov", "++"}, 1, "unknown switch '..'"},
        {{"a.pov", "--nonsense"}, 1, "unknown switch '--nonsense'"},
        {{"a.pov", "--"}, 1, "unknown switch '--'"},
        {{"a.pov", "+FX"}, 1, "'.FX': glint-povray writes N"},
        {{"a.pov", "+FN8g"}, 1, "'.FN8g': expected a number"},
        {{"a.pov", "+Q99"}, 1, "'.Q99': expected a number from 0 to 11"},
        {{"a.pov", "+KFFx"}, 1, "'.KFFx': expected a number"},
        {{"a.pov", "+SC9", "+EC3"}, 1, "expected a part of the .* pixels: the first column"},
        {{"a.pov", "+Kx"}, 1, "'.Kx': expected a number"},
        {{"a.pov", "+L"}, 1, "'.L': expected a folder"},
        {{"a.pov", "+W0"}, 1, "a width and a height above 0"},
        {{"a.pov", "+Onone/a.png"}, 1, "there is no folder 'none'"},
    };
    expect_all_refused(lines, GLINT_POVRAY);
}

TEST_F(CommandLines, OfGlintTachyon) {
    const WrongLine lines[] = {
        {{}, 255, "expected the name of a model file"},
        {{""}, 255, "expected the name of a model file"},
        {{"none.dat"}, 255, "none.dat: no such file"},
        {{"in"}, 255, "in: is a folder"},
        {{"a", "b"}, 255, "renders one scene, found 'a' and 'b'"},
        {{"a.dat", "-o"}, 255, "-o: expected a value, found nothing"},
        {{"a.dat", "-o", ""}, 255, "-o: expected a value, found nothing"},
        {{"a.dat", "-res", "3"}, 255, "-res: expected a value, found nothing"},
        {{"a.dat", "-res", "x", "y"}, 255, "-res: expected a number >= 0, found 'x'"},
        {{"a.dat", "-format", "JPG"}, 255, "writes TARGA, PNG, PPM, PPM48, BMP and JPEG, found 'JPG'"},
        {{"a.dat", "-numthreads", "9999"}, 255, "whole number from 0 to 1024, found '9999'"},
        {{"a.dat", "-aasamples", "-1"}, 255, "-aasamples: expected a number >= 0, found '-1'"},
        {{"a.dat", "-rescale_lights", "nan"}, 255, "-rescale_lights: expected a number >= 0, found 'nan'"},
        {{"a.dat", "-bogus"}, 255, "unknown flag '-bogus'"},
        {{"a.dat", "--help"}, 255, "unknown flag '--help'"},
        {{"a.dat", "--"}, 255, "unknown flag '--'"},
        {{"a.dat", "-fullshad"}, 255, "did you mean `-fullshade`"},
    };
    expect_all_refused(lines, GLINT_TACHYON);
}

Finished run_program(const Folder& folder, const std::vector<std::string>& arguments,
                     const std::string& program) {
    RunOptions options;
    options.program = program;
    return Process(folder, arguments, options).finish();
}

// Sage reads standard output, and takes its last line for an error; it shows the text only if the code is 0.
TEST_F(CommandLines, InTachyonsPlaceRefusesAsTachyon) {
    const Folder folder;
    std::filesystem::create_symlink(GLINT_TACHYON, folder.path("tachyon"));
    folder.write("a.dat", "Begin_Scene Resolution 4 4 Blub End_Scene\n");
    const auto run = [&](const std::vector<std::string>& arguments) {
        return run_program(folder, arguments, folder.path("tachyon"));
    };
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"a.dat"}, {"none.dat"}, {"a.dat", "-bogus"}}) {
        const Finished r = run(words);
        EXPECT_EQ(r.code, 0);
        EXPECT_TRUE(r.out.ends_with("Aborting render.\n")) << r.out;
        EXPECT_EQ(r.out, r.err + "Aborting render.\n");
        EXPECT_FALSE(r.err.empty());
    }
    folder.write("b.dat", "Begin_Scene Resolution 4 4 Scape Res 3 3 Scale 1 1 Center 0 0 0 t End_Scene\n");
    const Finished done = run({"b.dat", "--skip-unsupported", "-format", "BMP", "-o", "b.bmp"});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_TRUE(contains(done.out, "b.bmp  is without 1 object that glint does not render")) << done.out;
    EXPECT_EQ(folder.read("b.bmp").size(), 54u + 48u);
    const Finished stream = run({"b.dat", "--skip-unsupported", "-o", "-"});
    EXPECT_EQ(stream.out.size(), 18u + 48u) << "nothing but the picture";
    EXPECT_EQ(run_program(folder, {"a.dat"}, GLINT_TACHYON).code, 255);
}

TEST_F(CommandLines, DropInsAreLinksInAFolderOfTheUsers) {
    namespace fs = std::filesystem;
    const Folder folder;
    const std::string links = folder.path("mine/links");
    const auto install = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"install-drop-ins"};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(folder, words, GLINT_COMMAND);
    };
    const Finished done = install({"mine/links/"});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_TRUE(contains(done.out, "export PATH='" + links + "':\"$PATH\"")) << done.out;
    EXPECT_EQ(run_program(folder, {"--version"}, links + "/tachyon").out,
              "glint-tachyon (glint " GLINT_VERSION ")\n");
    EXPECT_EQ(run_program(folder, {"--version"}, links + "/povray").out,
              "glint-povray (glint " GLINT_VERSION ")\n");
    EXPECT_EQ(install({links}).code, 0) << "again";
    // One program by several names; by a name that is none of these it is glint.
    EXPECT_TRUE(fs::equivalent(links + "/povray", GLINT_COMMAND));
    fs::create_symlink(links + "/tachyon", folder.path("tachyon2"));
    EXPECT_EQ(run_program(folder, {"--version"}, folder.path("tachyon2")).out, "glint " GLINT_VERSION "\n");
    folder.write("mine/links/other", "");
    EXPECT_EQ(install({"--remove", links}).code, 0);
    EXPECT_FALSE(fs::exists(fs::symlink_status(links + "/tachyon")));
    EXPECT_TRUE(fs::exists(links + "/other"));

    folder.write("mine/links/tachyon", "another program");
    const Finished refused = install({links});
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(contains(refused.err, "tachyon: is there already")) << refused.err;
    EXPECT_FALSE(fs::exists(links + "/povray")) << "nothing is changed";
    EXPECT_EQ(install({"--remove", links}).code, 0);
    EXPECT_EQ(folder.read("mine/links/tachyon"), "another program");
    fs::create_symlink("/usr/local", folder.path("far"));
    for (const char* const systems : {"/usr/local/bin", "/usr/../bin", "/", "far/bin"}) {
        const Finished r = install({systems});
        EXPECT_EQ(r.code, 1) << systems;
        EXPECT_TRUE(contains(r.err, "is a folder of the system")) << r.err;
    }
    EXPECT_TRUE(contains(install({"mine/links/other"}).err, "is no folder"));
    EXPECT_TRUE(contains(install({"a:b"}).err, "has a colon"));
    const Finished odd = install({"it's \x1b[31m \"$(touch x)"});
    EXPECT_EQ(odd.code, 0) << odd.err;
    EXPECT_EQ(odd.out.find('\x1b'), std::string::npos);
    EXPECT_TRUE(contains(odd.out, "/it'\\''s ")) << odd.out;
    EXPECT_TRUE(contains(install({"--remove", folder.path("none")}).out, "nothing to remove"));
}

TEST_F(CommandLines, PovrayRendersFramesAndParts) {
    const Folder folder;
    folder.write("a.pov",
                 "camera { location <0, 0, -5> look_at 0 } background { rgb 1 }\n"
                 "#if (frame_number > 1) sphere { 0, 9 } #end\n");
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"a.pov", "+W4", "+H2", "+FP"});
        return run_program(folder, arguments, GLINT_POVRAY);
    };
    const Finished frames = run({"+KFF2"});
    EXPECT_EQ(frames.code, 0) << frames.err;
    const std::string head = "P6\n4 2\n255\n", white(3, '\xff'), black(3, '\0');
    EXPECT_EQ(folder.read("a1.ppm"), head + std::string(24, '\xff'));
    EXPECT_EQ(folder.read("a2.ppm"), head + std::string(24, '\0'));
    EXPECT_EQ(run({"+SC2", "+EC3", "+SR2"}).code, 0);
    EXPECT_EQ(folder.read("a.ppm"), head + black + black + black + black + black + white + white + black);
}

// What rank 0 of glint-mpi prints.
Finished run_mpi(const std::vector<std::string>& arguments) {
    CLI::App app("", mpi::k_program);
    const cli::RenderHooks hooks;
    const cli::Run render = mpi::add_command_line(app, hooks);
    const cli::CommandLine line = cli::parse_command_line(app, arguments);
    Finished result;
    result.code = line.error.empty() ? cli::k_done : cli::k_usage;
    result.out = line.answer;
    if (!line.error.empty()) result.err = cli::usage_error_text(mpi::k_program, line.command, line.error);
    return result;
}

TEST_F(CommandLines, OfGlintMpi) {
    const WrongLine lines[] = {
        {{}, 2, "glint-mpi: expected a command"},
        {{""}, 2, "there is no command ''; there are render"},
        {{"castle.json"}, 2, "did you mean 'glint-mpi render castle.json'"},
        {{"rendr", "castle.json"}, 2, "did you mean `render`"},
        {{"info", "castle.json"}, 2, "there is no command 'info'"},
        {{"--siz", "3x3"}, 2, "did you mean 'glint-mpi render --size 3x3'"},
        {{"--nonsense"}, 2, "unknown option '--nonsense'"},
        {{"-"}, 2, "'-' is not a command; did you mean 'glint-mpi render -'"},
        {{"--"}, 2, "expected a command"},
        {{"render"}, 2, "glint-mpi render: expected SCENE\nsee 'glint-mpi render --help'"},
        {{"render", ""}, 2, "SCENE: expected a name, found nothing"},
        {{"render", "a.cgfs", "--siz", "3x3"}, 2, "unknown option '--siz'|unexpected arguments '--siz'"},
        {{"render", "a.cgfs", "-o"}, 2, "--output: expected OUT, found nothing"},
        {{"render", "a.cgfs", "-t", "x"}, 2, "whole number from 0 to 1024, found 'x'"},
        {{"render", "a.cgfs", "-s", "1x1", "-s", "2x2"}, 2, "--size is given 2 times: expected once"},
    };
    for (const WrongLine& line : lines) expect_refused(line, run_mpi(line.arguments));
    EXPECT_TRUE(contains(run_mpi({"--version"}).out, "glint "));
    EXPECT_TRUE(contains(run_mpi({"render", "--help"}).out, "--resume"));
}

}  // namespace
}  // namespace glint::test
