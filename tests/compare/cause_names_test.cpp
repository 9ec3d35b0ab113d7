// SPDX-License-Identifier: Apache-2.0
// The ids of causes, and the tables of docs/compare.md.
#include "compare/cause_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <string>

namespace glint::test {
namespace {

TEST(CauseNames, AreThoseOfTheDocumentation) {
    std::ifstream in(GLINT_SOURCE "/docs/compare.md");
    std::set<std::string> documented;
    bool is_cause = false;
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("|")) is_cause = false;
        if (line.starts_with("|-")) continue;
        const std::string cell = line.substr(0, line.find('|', 1));
        static const std::regex id("[a-z]+(-[a-z]+)*");
        for (std::sregex_iterator at(cell.begin(), cell.end(), id), end; is_cause && at != end; ++at)
            documented.insert(at->str());
        if (line.starts_with("| cause |")) is_cause = true;
    }
    const auto& names = cause_names();
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    EXPECT_EQ((std::set<std::string>(names.begin(), names.end())), documented);
}

}  // namespace
}  // namespace glint::test
