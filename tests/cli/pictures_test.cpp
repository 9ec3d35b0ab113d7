// SPDX-License-Identifier: Apache-2.0
// The pictures of README.md and docs/: each is the output of the command next to it.
#include <gtest/gtest.h>

#include <set>

#include "cli/process.h"
#include "image/golden.h"

namespace glint::test {
namespace {

const std::string k_root = GLINT_SOURCE;

std::vector<std::string> pages() {
    std::vector<std::string> pages = {k_root + "/README.md"};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(k_root + "/docs")) {
        if (entry.path().extension() == ".md") pages.push_back(entry.path().string());
    }
    return pages;
}

/// The arguments of every `glint render ... -o docs/images/...` of a page, the picture's path last.
std::vector<std::vector<std::string>> commands(const std::string& page) {
    std::vector<std::vector<std::string>> found;
    std::ifstream in(page);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) arguments.push_back(word);
        if (line.starts_with("    glint render ") && arguments.back().starts_with("docs/images/")) {
            arguments.erase(arguments.begin());
            found.push_back(arguments);
        }
    }
    return found;
}

TEST(Pictures, AreWhatTheirCommandsDraw) {
    std::set<std::string> drawn;
    for (const std::string& page : pages()) {
        for (std::vector<std::string> arguments : commands(page)) {
            const std::string path = arguments.back();
            SCOPED_TRACE(page + ": " + path);
            drawn.insert(path);
            const Folder folder;
            for (std::string& a : arguments) {
                if (a.starts_with("scenes/")) a = k_root + "/" + a;
            }
            arguments.back() = "picture.png";
            const Finished finished = run(folder, arguments);
            ASSERT_EQ(finished.code, 0) << finished.err;
            if (std::getenv("GLINT_UPDATE_GOLDEN") != nullptr) {
                std::filesystem::copy_file(folder.path("picture.png"), k_root + "/" + path,
                                           std::filesystem::copy_options::overwrite_existing);
            }
            EXPECT_TRUE(compare(read_png(k_root + "/" + path), read_png(folder.path("picture.png")), {},
                                std::filesystem::path(path).stem().string() + ".difference.png"));
        }
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(k_root + "/docs/images")) {
        const std::string path = entry.path().string().substr(k_root.size() + 1);
        if (path.starts_with("docs/images/playground")) continue;  // the page's own tests make these
        if (path.starts_with("docs/images/blender_")) continue;    // screenshots of Blender
        EXPECT_TRUE(!path.ends_with(".png") || drawn.contains(path)) << path << ": no command draws it";
    }
}

TEST(Pictures, OfEveryPageExist) {
    for (const std::string& page : pages()) {
        std::ifstream in(page);
        std::string text;
        for (std::string line; std::getline(in, line);) {
            if (!line.starts_with("    ")) text += line + '\n';  // code may have "](", which is no link there
        }
        const std::string folder = page.substr(0, page.rfind('/') + 1);
        for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
            std::string target = text.substr(at + 2, text.find(')', at) - at - 2);
            target = target.substr(0, target.find('#'));
            if (target.empty() || target.find("://") != std::string::npos) continue;
            EXPECT_TRUE(std::filesystem::exists(folder + target)) << page << " names " << target;
        }
    }
}

}  // namespace
}  // namespace glint::test
