// SPDX-License-Identifier: Apache-2.0
// The tests of misuse must call every function of the public headers.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "misuse/misused.h"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// Free functions are at the start of a line, members of a class after a type.
std::set<std::string> public_functions() {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(GLINT_PROJECT_DIR) / "include/glint")) {
        const std::string text = read(entry.path());
        static const std::regex declared(
            R"((?:^|\n) {0,4}([A-Za-z][\w:<>,]*)(?: [\w:<>,&*]+)* [&*]?([a-z]\w*)\()");
        for (std::sregex_iterator at(text.begin(), text.end(), declared), end; at != end; ++at)
            if ((*at)[1] != "return") names.insert((*at)[2]);
    }
    return names;
}

TEST(Misuse, OfEveryPublicFunctionIsTested) {
    std::string tests;
    for (const auto& entry : fs::directory_iterator(fs::path(GLINT_PROJECT_DIR) / "tests/misuse"))
        if (entry.path().extension() == ".cpp") tests += read(entry.path());
    const std::set<std::string> names = public_functions();
    for (const char* const known : {"render", "load", "viewable", "material_of", "check_kinds",
                                    "render_overlay", "total", "place", "add", "cross", "sample_values"})
        EXPECT_TRUE(names.contains(known)) << known;
    EXPECT_GE(names.size(), 45u);
    for (const std::string& name : names) {
        // Sources is implemented by the caller, parts() is for the library; fields() only visits.
        // call, swap and use are private to Function.
        const std::set<std::string> others = {"read", "parts", "fields", "operator", "call", "swap", "use"};
        if (others.contains(name)) continue;
        EXPECT_TRUE(std::regex_search(tests, std::regex("\\b" + name + R"((<\w+>)?\()"))) << name;
    }
}

}  // namespace
}  // namespace glint::test
