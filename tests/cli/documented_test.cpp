// SPDX-License-Identifier: Apache-2.0
// docs/command.md names every option of every command.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "cli/process.h"

namespace glint::test {
namespace {

// Options begin a line of the help: "  -o,--output OUT".
std::set<std::string> options_of_help(const std::string& help) {
    std::set<std::string> names;
    const std::regex line(R"(\n  ((-[a-z],)?--[a-z-]+))");
    for (std::sregex_iterator it(help.begin(), help.end(), line), end; it != end; ++it) {
        std::istringstream words((*it)[1].str());
        for (std::string word; std::getline(words, word, ',');) names.insert(word);
    }
    return names;
}

TEST(Documented, EveryOption) {
    std::ifstream file(GLINT_SOURCE "/docs/command.md");
    const std::string docs{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const Folder folder;
    const std::pair<const char*, std::size_t> commands[] = {
        {"render", 20},   {"info", 8},   {"convert", 9}, {"explain", 17}, {"versus", 17},
        {"compare", 21},  {"grade", 18}, {"check", 9},   {"join", 9},     {"install-drop-ins", 3},
        {"diagnose", 14}, {"pixels", 14}};
    for (const auto& [command, at_least] : commands) {
        const std::size_t begin = docs.find(std::string("\n## glint ") + command + "\n");
        ASSERT_NE(begin, std::string::npos) << command;
        const std::string section = docs.substr(begin, docs.find("\n## ", begin + 4) - begin);
        const auto names = options_of_help(run(folder, {command, "--help"}).out);
        EXPECT_GE(names.size(), at_least) << "too few found in the help";
        for (const std::string& name : names) {
            const std::regex word("`" + name + "[ `]");
            const bool common = name == "-h" || name == "--help";
            EXPECT_TRUE(std::regex_search(common ? docs : section, word)) << command << " " << name;
        }
    }
}

// "  0     done" in the help, and "| 0 | done |" in the document.
TEST(Documented, EveryExitCode) {
    std::ifstream file(GLINT_SOURCE "/docs/command.md");
    const std::string docs{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const Folder folder;
    const std::string help = run(folder, {"--help"}).out;
    const std::size_t begin = help.find("Exit codes:\n");
    ASSERT_NE(begin, std::string::npos) << help;
    std::istringstream lines(help.substr(begin, help.find("\n\n", begin) - begin));
    int codes = 0;
    std::string line;
    std::getline(lines, line);
    for (std::smatch parts; std::getline(lines, line); ++codes) {
        ASSERT_TRUE(std::regex_match(line, parts, std::regex("  ([0-9, ]*[0-9]) +(.*)"))) << line;
        EXPECT_TRUE(contains(docs, "\n| " + parts[1].str() + " | " + parts[2].str() + " |\n")) << line;
    }
    EXPECT_EQ(codes, 4);
}

TEST(Documented, EveryHelpHasExamples) {
    const Folder folder;
    const std::vector<std::vector<std::string>> helps = {{"--help"},
                                                         {"render", "--help"},
                                                         {"info", "--help"},
                                                         {"convert", "--help"},
                                                         {"check", "--help"},
                                                         {"explain", "--help"},
                                                         {"versus", "--help"},
                                                         {"compare", "--help"},
                                                         {"grade", "--help"},
                                                         {"join", "--help"},
                                                         {"completion", "--help"},
                                                         {"help", "--help"},
                                                         {"version", "--help"},
                                                         {"man", "--help"}};
    for (const auto& arguments : helps) {
        const Finished r = run(folder, arguments);
        EXPECT_EQ(r.code, 0);
        EXPECT_TRUE(contains(r.out, "Examples:\n")) << r.out;
    }
}

}  // namespace
}  // namespace glint::test
