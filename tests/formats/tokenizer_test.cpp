// SPDX-License-Identifier: Apache-2.0
#include "formats/tokenizer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace glint::test {
namespace {

constexpr Dialect k_all{true, true, true, true};

std::vector<Token> tokens(std::string_view text, Dialect dialect = k_all) {
    Tokenizer tokenizer(text, dialect);
    std::vector<Token> list;
    for (Token t = tokenizer.next(); t.kind != TokenKind::end; t = tokenizer.next()) list.push_back(t);
    return list;
}

double number(std::string_view text) {
    const auto list = tokens(text);
    EXPECT_EQ(list.size(), 1u) << text;
    EXPECT_EQ(list[0].kind, TokenKind::number) << text;
    EXPECT_EQ(list[0].length, text.size());
    return list[0].number;
}

TEST(Tokenizer, ReadsNumbers) {
    EXPECT_EQ(number("0"), 0);
    EXPECT_EQ(number("-1"), -1);
    EXPECT_EQ(number("+1"), 1);
    EXPECT_EQ(number("4."), 4);
    EXPECT_EQ(number(".5"), 0.5);
    EXPECT_EQ(number("-.5e-1"), -0.05);
    EXPECT_EQ(number("007"), 7);
    EXPECT_EQ(number("0.30000000000000004"), 0.30000000000000004);
    EXPECT_EQ(number("1e-999"), 0);
    EXPECT_TRUE(std::isinf(number("1e999")));
    EXPECT_TRUE(std::isinf(number("-1e999")));
    EXPECT_TRUE(std::isinf(number("1e99999999999999999999")));
    EXPECT_EQ(number("179769313486231570000e288"), 1.7976931348623157e308);
    EXPECT_EQ(number(std::string(100000, '1') + "e-99999"), 1.1111111111111112);
}

TEST(Tokenizer, DecimalsAreTheNearestDoubles) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 200000; ++i) {
        const int count = 1 + static_cast<int>(random() % 19), point = static_cast<int>(random() % 20);
        std::string text = random() % 2 ? "-" : "";
        for (int d = 0; d < count; ++d) {
            if (d == point) text += '.';
            text += static_cast<char>('0' + random() % 10);
        }
        if (random() % 8 == 0) text += "e-7";
        if (text[0] == '.' && text.size() == 1) continue;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(number(text)),
                  std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)))
            << text;
    }
}

TEST(Tokenizer, MalformedNumbers) {
    for (const char* text : {"12abc", "1.2.3", "0x10", "1e", "1e+", "1_000", "4..", "1\xc3\xa9"}) {
        const auto list = tokens(text);
        ASSERT_FALSE(list.empty()) << text;
        EXPECT_EQ(list[0].kind, TokenKind::malformed) << text;
    }
}

TEST(Tokenizer, WordsOfNotANumberAreWords) {
    for (const char* text : {"NaN", "nan", "inf", "-inf", "+Infinity", "-NaN", "e5"}) {
        const auto list = tokens(text);
        ASSERT_EQ(list.size(), 1u) << text;
        EXPECT_EQ(list[0].kind, TokenKind::word) << text;
    }
}

TEST(Tokenizer, CountsLinesAndColumns) {
    const auto list = tokens("a\n  b /* x\n\n*/ c\r\n# d\n\td // e\r\nf");
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> expected = {
        {1, 1}, {2, 3}, {4, 4}, {6, 2}, {7, 1}};
    ASSERT_EQ(list.size(), expected.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(list[i].line, expected[i].first) << i;
        EXPECT_EQ(list[i].column, expected[i].second) << i;
    }
}

TEST(Tokenizer, ReadsOnlyTheCommentsOfItsDialect) {
    EXPECT_EQ(tokens("# a", {}).size(), 2u);
    EXPECT_EQ(tokens("// a", {}).size(), 3u);
    EXPECT_EQ(tokens("/* a */", {}).size(), 5u);
    EXPECT_EQ(tokens("'a'", {}).size(), 3u);
    EXPECT_EQ(tokens("# a").size() + tokens("// a").size() + tokens("/* a */").size(), 0u);
}

TEST(Tokenizer, ReadsStrings) {
    const auto list = tokens(R"("a\"b" 'it\'s' "" '')");
    ASSERT_EQ(list.size(), 4u);
    for (const Token& t : list) EXPECT_EQ(t.kind, TokenKind::string);
    EXPECT_EQ(list[0].length, 6u);
}

TEST(Tokenizer, DecodesStrings) {
    EXPECT_EQ(string_value(R"("a\"b\\c\/d")"), "a\"b\\c/d");
    EXPECT_EQ(string_value(R"('it\'s')"), "it's");
    EXPECT_EQ(string_value(R"("\n\t\r\b\f")"), "\n\t\r\b\f");
    EXPECT_EQ(string_value(R"("\u00e9\u20ac\ud83d\ude00")"), "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80");
    EXPECT_EQ(string_value(R"("\ud83d!")"), "\xef\xbf\xbd!");
    EXPECT_EQ(string_value(R"("\ud83d\u0041")"),
              "\xef\xbf\xbd"
              "A");
    EXPECT_EQ(string_value(R"("\u12")"), "u12");
    EXPECT_EQ(string_value(R"("\q")"), "q");
    EXPECT_EQ(string_value("\"open"), "open");
    EXPECT_EQ(string_value("\""), "");
    EXPECT_EQ(string_value(""), "");
}

TEST(Tokenizer, ReportsUnterminatedTokens) {
    EXPECT_EQ(tokens("\"abc\nd")[0].kind, TokenKind::open_string);
    EXPECT_EQ(tokens("\"abc\nd")[1].line, 2u);
    EXPECT_EQ(tokens("\"abc\\")[0].kind, TokenKind::open_string);
    EXPECT_EQ(tokens("\"abc\\\n\"")[0].kind, TokenKind::open_string);
    const Token comment = tokens("a /* b\nc")[1];
    EXPECT_EQ(comment.kind, TokenKind::open_comment);
    EXPECT_EQ(comment.line, 1u);
    EXPECT_EQ(comment.column, 3u);
    EXPECT_EQ(tokens("/*/")[0].kind, TokenKind::open_comment);
}

TEST(Tokenizer, StopsAtInvalidBytes) {
    using namespace std::string_view_literals;
    const auto list = tokens("a \0 b"sv);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[1].kind, TokenKind::bad_byte);
    EXPECT_EQ(list[1].offset, 2u);
}

TEST(Tokenizer, SkipsAByteOrderMark) {
    const auto list = tokens(
        "\xef\xbb\xbf"
        "a");
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].offset, 3u);
}

TEST(Tokenizer, TokensCoverEveryByteThatIsNotBlank) {
    const std::string_view text = "a=(1,-2.5)[\"s\"]{b:c}.d...e;-!-x+1";
    std::size_t covered = 0;
    for (const Token& t : tokens(text)) {
        EXPECT_EQ(t.offset, covered);
        covered = t.offset + t.length;
    }
    EXPECT_EQ(covered, text.size());
}

}  // namespace
}  // namespace glint::test
