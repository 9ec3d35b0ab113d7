// SPDX-License-Identifier: Apache-2.0
// Retired words (retired_words.h) must not occur in code, comments and documents.
#include <gtest/gtest.h>
#include <regex.h>  // much faster than std::regex

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "words/retired_words.h"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

struct Text {
    std::string path;  // relative to the project
    std::vector<std::string> lines;
};

std::vector<std::string> lines_of(std::istream& in) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

bool is_text(const fs::path& path) {
    static const std::set<std::string> extensions = {".h",   ".cpp", ".ts",   ".tsx", ".mjs",
                                                     ".mts", ".css", ".html", ".md",  ".txt"};
    return extensions.contains(path.extension().string());
}

std::vector<Text> read_texts() {
    const fs::path project = GLINT_PROJECT_DIR;
    std::vector<Text> texts;
    for (const char* folder : {"src", "include", "docs", "web/src"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(project / folder)) {
            if (!entry.is_regular_file() || !is_text(entry.path())) continue;
            std::ifstream in(entry.path());
            texts.push_back({fs::relative(entry.path(), project).generic_string(), lines_of(in)});
        }
    }
    std::ifstream readme(project / "README.md");
    texts.push_back({"README.md", lines_of(readme)});
    return texts;
}

bool is_within(const std::string& path, std::string_view prefixes) {
    if (prefixes.empty()) return true;
    std::istringstream list{std::string(prefixes)};
    for (std::string prefix; list >> prefix;) {
        if (path.starts_with(prefix)) return true;
    }
    return false;
}

/// "src/a.h:3: beam: write ray packet", one for each line with the word.
std::vector<std::string> find_word(const std::vector<Text>& texts, const RetiredWord& word) {
    regex_t pattern;
    if (regcomp(&pattern, std::string(word.pattern).c_str(), REG_EXTENDED) != 0)
        return {"no regular expression: " + std::string(word.pattern)};
    std::vector<std::string> found;
    for (const Text& text : texts) {
        if (!is_within(text.path, word.within)) continue;
        for (std::size_t i = 0; i < text.lines.size(); ++i) {
            const std::string& line = text.lines[i];
            regmatch_t match;
            if (regexec(&pattern, line.c_str(), 1, &match, 0) != 0) continue;
            const auto first = static_cast<std::size_t>(match.rm_so),
                       last = static_cast<std::size_t>(match.rm_eo);
            found.push_back(text.path + ':' + std::to_string(i + 1) + ": " +
                            line.substr(first, last - first) + ": write " + std::string(word.instead));
        }
    }
    regfree(&pattern);
    return found;
}

TEST(Words, RetiredOnesAreGone) {
    const std::vector<Text> texts = read_texts();
    ASSERT_GT(texts.size(), 300u);
    for (const RetiredWord& word : retired_words()) {
        for (const std::string& wrong : find_word(texts, word)) ADD_FAILURE() << wrong;
    }
}

// Each rule finds its word in the paths that it applies to.
TEST(Words, AreFound) {
    const auto at = [](const char* path, const char* line) {
        const std::vector<Text> texts = {{path, {line}}};
        return std::any_of(retired_words().begin(), retired_words().end(),
                           [&](const RetiredWord& word) { return !find_word(texts, word).empty(); });
    };
    EXPECT_TRUE(at("src/trace/hits/hit_kernels-inl.h", "// a beam meets every box"));
    EXPECT_TRUE(at("src/trace/hits/hit_kernels-inl.h", "constexpr int k_least_beam = 8;"));
    EXPECT_TRUE(at("include/glint/explain.h", "inline constexpr int k_most_explained_rays = 1;"));
    EXPECT_TRUE(at("src/geometry/ray-inl.h", "struct Candidate {"));
    EXPECT_TRUE(at("include/glint/explain.h", "enum class BranchState : std::uint8_t {"));
    EXPECT_TRUE(at("src/simd/vec3-inl.h", "template <class T> struct Triple {"));
    EXPECT_TRUE(at("src/trace/film/film-inl.h", "store_triple(sum, sums, first);"));
    EXPECT_TRUE(at("src/trace/render.cpp", "// the kernels that draw pictures"));
    EXPECT_TRUE(at("include/glint/check.h", "///< looked at now and then"));
    EXPECT_TRUE(at("web/src/store/state.ts", "export const machinery = {};"));
    EXPECT_FALSE(at("docs/lighting.md", "a beam that meets the surface at an angle"));
    EXPECT_FALSE(at("docs/checks.md", "a sky or a room"));
    EXPECT_FALSE(at("src/trace/hits/hit_kernels-inl.h", "// a ray packet"));
    EXPECT_EQ(find_word({{"docs/a.md", {"x", "a Cuboid"}}}, {R"(\bCuboid\b)", "Box"}),
              (std::vector<std::string>{"docs/a.md:2: Cuboid: write Box"}));
}

}  // namespace
}  // namespace glint::test
