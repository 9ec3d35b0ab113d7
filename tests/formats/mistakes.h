// SPDX-License-Identifier: Apache-2.0
#pragma once
// Texts with mistakes and their messages, one text per row. $ marks the place in the text.
#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

#include "formats/load_text.h"

namespace glint::test {

struct BadText {
    const char* name;  ///< of the test
    const char* text;  ///< with $ before each place, in the order of the messages
    std::vector<const char*> messages;
};

inline std::ostream& operator<<(std::ostream& out, const BadText& m) { return out << m.text; }

inline void expect_messages(const BadText& mistake, const char* file, const char* format = "") {
    std::string text;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
    std::uint32_t line = 1, column = 1;
    for (const char* c = mistake.text; *c; ++c) {
        if (*c == '$') {
            places.emplace_back(line, column);
            continue;
        }
        text += *c;
        ++column;
        if (*c == '\n') {
            ++line;
            column = 1;
        }
    }
    const Result<Scene> result = load_text(text, file, {}, nullptr, format);
    std::string all;
    for (const Diagnostic& d : result.diagnostics) all += to_string(d);
    ASSERT_EQ(result.diagnostics.size(), mistake.messages.size()) << all;
    ASSERT_EQ(places.size(), mistake.messages.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Diagnostic& d = result.diagnostics[i];
        EXPECT_EQ(d.message, mistake.messages[i]);
        EXPECT_EQ(d.line, places[i].first) << d.message;
        EXPECT_EQ(d.column, places[i].second) << d.message;
        EXPECT_EQ(d.file, file);
        EXPECT_EQ(d.can_skip, d.message.find("the option skip-unsupported") != std::string::npos)
            << d.message;
        // The source line is that of the place, and the caret is below the place.
        EXPECT_NE(text.find(d.source_line), std::string::npos) << d.source_line;
        EXPECT_EQ(d.caret, d.column - 1) << d.message;
    }
}

inline std::string test_name(const testing::TestParamInfo<BadText>& param) { return param.param.name; }

}  // namespace glint::test
