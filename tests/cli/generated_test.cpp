// SPDX-License-Identifier: Apache-2.0
// The manual pages and completions, which the build writes (cmake/command_documents.cmake).
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "cli/process.h"

namespace glint::test {
namespace {

const std::string k_documents = std::filesystem::path(GLINT_COMMAND).parent_path() / "command_documents";

std::string document(const std::string& name) {
    std::ifstream in(k_documents + "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

constexpr const char* k_programs[] = {"povray", "tachyon"};  // their own programs, not commands

// The pages that glint's names: its commands and other programs.
std::set<std::string> pages(const Folder& folder) {
    std::set<std::string> names;
    const std::string page = run(folder, {"man"}).out;
    const std::regex name(R"(\n\.BR glint\\-([a-z\\-]+) \(1\))");
    for (std::sregex_iterator it(page.begin(), page.end(), name), end; it != end; ++it) {
        std::string found = (*it)[1].str();
        std::erase(found, '\\');
        names.insert(std::move(found));
    }
    return names;
}

std::set<std::string> commands(const Folder& folder) {
    std::set<std::string> names = pages(folder);
    for (const char* program : k_programs) EXPECT_EQ(names.erase(program), 1u) << program;
    return names;
}

bool has_program(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

// Runs a script in the folder; returns its exit code.
int shell(const Folder& folder, const std::string& command) {
    return std::system(("cd '" + folder.path() + "' && " + command).c_str());
}

// Each program has a page, and each page is a program's.
TEST(Generated, EveryProgramHasAManualPage) {
    const Folder folder;
    const auto names = pages(folder);
    EXPECT_TRUE(names.contains("render") && names.contains("completion") && names.contains("povray"));
    EXPECT_EQ(document("man/glint.1"), run(folder, {"man"}).out);
    for (const std::string& name : names)
        EXPECT_EQ(document("man/glint-" + name + ".1"), run(folder, {"man", name}).out);
}

// A program's manual page has every line of its --help.
TEST(Generated, ManualPagesOfProgramsSayWhatTheirHelpSays) {
    const Folder folder;
    for (const std::string name : k_programs) {
        const std::string program = std::filesystem::path(GLINT_COMMAND).parent_path() / ("glint-" + name);
        ASSERT_EQ(shell(folder, program + (name == "povray" ? " --help" : " -help") + " >help.txt"), 0);
        std::string page =
            std::regex_replace(run(folder, {"man", name}).out, std::regex(R"(\\f[BIR]|\\&)"), "");
        page = std::regex_replace(page, std::regex(R"(\\-)"), "-");
        std::istringstream help(folder.read("help.txt"));
        int lines = 0;
        for (std::string line; std::getline(help, line);) {
            if (!line.starts_with("  ")) continue;
            ++lines;
            for (std::size_t at = line.find_first_not_of(' '); at < line.size();) {  // columns
                const std::size_t end = std::min(line.find("  ", at), line.size());
                EXPECT_TRUE(contains(page, line.substr(at, end - at))) << line << "\n" << page;
                at = std::min(line.find_first_not_of(' ', end), line.size());
            }
        }
        EXPECT_GT(lines, 15);
    }
}

// A manual page contains every option of the help, with its whole description.
TEST(Generated, ManualPagesSayWhatTheHelpSays) {
    const Folder folder;
    const auto names = commands(folder);
    EXPECT_GE(names.size(), 10u);
    for (const std::string& name : names) {
        std::string page = run(folder, {"man", name}).out;
        page = std::regex_replace(page, std::regex(R"(\\f[BIR]|\\&)"), "");
        page = std::regex_replace(page, std::regex(R"(\\-)"), "-");
        const std::string help = run(folder, {name, "--help"}).out;
        const std::regex option(R"(\n  (-[A-Za-z],)?(--[a-z-]+)[^\n]*?(?:\n {20,}|  +)([^\n]*))");
        int options = 0;
        for (std::sregex_iterator it(help.begin(), help.end(), option), end; it != end; ++it, ++options) {
            EXPECT_TRUE(contains(page, (*it)[2].str())) << name << (*it)[2];
            EXPECT_TRUE(contains(page, (*it)[3].str())) << name << "\n" << (*it)[3] << "\n" << page;
        }
        EXPECT_GE(options, 1) << help;
        EXPECT_TRUE(contains(page, help.substr(help.rfind("\n  ") + 3))) << "its last example";
    }
}

TEST(Generated, ManualPagesAreGoodRoff) {
    if (!has_program("groff")) GTEST_SKIP() << "no groff";
    const Folder folder;
    EXPECT_EQ(shell(folder, "groff -man -Tascii -P-cbou -ww -rLL=100n " + k_documents +
                                "/man/*.1 >pages.txt 2>complaints.txt"),
              0);
    EXPECT_EQ(folder.read("complaints.txt"), "");
    EXPECT_TRUE(contains(folder.read("pages.txt"), "SEE ALSO"));
}

TEST(Generated, BashCompletes) {
    const Folder folder;
    folder.write("glint.bash", document("completions/glint.bash"));
    folder.write("castle.json", "");
    folder.write("castle.png", "");
    folder.write("try.bash", R"(source ./glint.bash
try() { COMP_WORDS=(glint "${@:2}"); COMP_CWORD=$(($# - 1)); _glint; [[ $(printf "%s\n" "${COMPREPLY[@]}" | sort | xargs) == "$1" ]] || { echo "$* gives ${COMPREPLY[*]}"; exit 1; }; }
try --crop render --cr
try info inf
try 'info install-drop-ins' in
try blinn-phong render --shading bl
try castle.json render ca
try castle.png render castle.json -o castle.p
try 'castle.json castle.png' compare castle
try castle.json compare a.png b.png --scene ca
try specular_gate= render --convention specular_g
try normal render --aov nor
try '' render -s ''
try 'render' help ren
try 'zsh' completion z
try --stats render a.json --quiet --sta
)");
    EXPECT_EQ(shell(folder, "bash try.bash 2>&1"), 0);
}

TEST(Generated, BashCompletesPrograms) {
    const Folder folder;
    for (const std::string name : {"glint-povray", "glint-tachyon"})
        folder.write(name + ".bash", document("completions/" + name + ".bash"));
    folder.write("a.pov", "");
    folder.write("b.dat", "");
    folder.write("b.tga", "");
    folder.write("try.bash", R"(source ./glint-povray.bash; source ./glint-tachyon.bash
try() { COMP_WORDS=("${@:2}"); COMP_CWORD=$(($# - 2)); _$2; [[ $(printf "%s\n" "${COMPREPLY[@]}" | sort | xargs) == "$1" ]] || { echo "$* gives ${COMPREPLY[*]}"; exit 1; }; }
try a.pov glint-povray ''
try +Ia.pov glint-povray +Ia
try '+W +WT' glint-povray +W
try b.dat glint-tachyon ''
try '-trans_max_surfaces -trans_orig -trans_raster3d -trans_vmd' glint-tachyon b.dat -trans
try 'PPM PPM48' glint-tachyon b.dat -format PP
try b.tga glint-tachyon b.dat -o b.t
try '' glint-tachyon b.dat -res ''
)");
    EXPECT_EQ(shell(folder, "bash try.bash 2>&1"), 0);
}

TEST(Generated, ZshCompletes) {
    if (!has_program("zsh")) GTEST_SKIP() << "no zsh";
    const Folder folder;
    folder.write("_glint", document("completions/glint.zsh"));
    EXPECT_EQ(shell(folder, "zsh -f -n _glint"), 0);
    for (const std::string name : {"glint-povray", "glint-tachyon"}) {
        folder.write("_" + name, document("completions/" + name + ".zsh"));
        EXPECT_EQ(shell(folder, "zsh -f -n _" + name), 0);
    }
    // Checks that _arguments can parse its specifications, by completing as at a prompt.
    folder.write("try.zsh", R"(zmodload zsh/zpty
zpty glint zsh -f -i
zpty -w glint 'PS1= ; unsetopt zle_bracketed_paste 2>/dev/null; fpath=($PWD $fpath); autoload -Uz compinit; compinit -u -D; bindkey "^I" complete-word; echo ready'
zpty -r glint text '*ready'
zpty -r glint text '*ready'
zpty -w -n glint $'glint render --shading bl\t'
sleep 1
zpty -w -n glint $' --cr\t'
sleep 1
while zpty -r -t glint text; do all+=$text; done
print -r -- $all
[[ $all == *'blinn-phong'* && $all == *'--crop'* ]]
)");
    EXPECT_EQ(shell(folder, "zsh -f try.zsh >out.txt 2>&1"), 0) << folder.read("out.txt");
}

TEST(Generated, FishCompletes) {
    if (!has_program("fish")) GTEST_SKIP() << "no fish";
    const Folder folder;
    folder.write("glint.fish", document("completions/glint.fish"));
    folder.write("try.fish", R"(source glint.fish
function try
    complete -C "$argv[2]" | string match -q -- "$argv[1]*"; or begin; echo $argv gives (complete -C "$argv[2]"); exit 1; end
end
try render "glint ren"
try --crop "glint render --cr"
try blinn-phong "glint render --shading bl"
try specular_gate= "glint render --convention specular_g"
try zsh "glint completion z"
)");
    EXPECT_EQ(shell(folder, "HOME=$PWD fish --no-config try.fish 2>&1"), 0);
}

}  // namespace
}  // namespace glint::test
