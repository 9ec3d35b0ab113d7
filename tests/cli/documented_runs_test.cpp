// SPDX-License-Identifier: Apache-2.0
// Documented output is the command's output: every `    $ glint ...` in the documents is run in the folder
// of the project's scenes, and its output is compared with the lines below it. A line `...` matches any
// number of lines.
#include <gtest/gtest.h>

#include "cli/process.h"

namespace glint::test {
namespace {

using Lines = std::vector<std::string>;

// Without trailing blanks, which documents do not keep.
Lines lines_of(const std::string& text) {
    Lines lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line.substr(0, line.find_last_not_of(" ") + 1));
    return lines;
}

bool matches(const Lines& shown, std::size_t s, const Lines& printed, std::size_t p) {
    if (s == shown.size()) return p == printed.size();
    if (shown[s] == "...") {
        for (std::size_t next = p; next <= printed.size(); ++next) {
            if (matches(shown, s + 1, printed, next)) return true;
        }
        return false;
    }
    return p < printed.size() && shown[s] == printed[p] && matches(shown, s + 1, printed, p + 1);
}

class DocumentedRuns : public testing::TestWithParam<const char*> {};

TEST_P(DocumentedRuns, PrintWhatTheySay) {
    const Folder folder;
    std::filesystem::create_symlink(GLINT_SOURCE "/scenes", folder.path("scenes"));
    std::filesystem::create_symlink(GLINT_SOURCE "/docs", folder.path("docs"));
    std::ifstream file(std::string(GLINT_SOURCE "/") + GetParam());
    const Lines doc = lines_of({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
    const std::string prompt = "    $ glint ";
    int runs = 0;
    for (std::size_t i = 0; i < doc.size();) {
        if (!doc[i].starts_with(prompt)) {
            ++i;
            continue;
        }
        std::vector<std::string> arguments;
        std::istringstream words(doc[i].substr(prompt.size()));
        for (std::string word; words >> word;) arguments.push_back(word);
        const std::string command = doc[i];
        Lines shown;
        for (++i; i < doc.size() && doc[i].starts_with("    ") && !doc[i].starts_with(prompt); ++i)
            shown.push_back(doc[i].substr(4));
        const Finished r = run(folder, arguments);
        // The documents do not show the line about a rendered picture.
        const Lines printed = lines_of(r.out + (arguments.front() == "render" ? "" : r.err));
        EXPECT_TRUE(matches(shown, 0, printed, 0)) << command << "\nprints\n" << r.out << r.err;
        ++runs;
    }
    EXPECT_GT(runs, 0);
}

INSTANTIATE_TEST_SUITE_P(Docs, DocumentedRuns,
                         testing::Values("README.md", "docs/explain.md", "docs/finding_out_why.md",
                                         "docs/teaching.md"));

}  // namespace
}  // namespace glint::test
