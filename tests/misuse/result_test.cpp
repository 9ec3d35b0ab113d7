// SPDX-License-Identifier: Apache-2.0
// Results without a value, and Statuses that no function of glint makes.
#include <memory>
#include <optional>

#include "misuse/misused.h"

namespace glint::test {
namespace {

TEST(Misuse, OfResultsWithoutValue) {
    const Result<int> nothing;
    EXPECT_FALSE(nothing.has_value());
    EXPECT_FALSE(nothing.ok());
    EXPECT_FALSE(bool(nothing));
    EXPECT_EQ(nothing.code, ErrorCode::internal);
    EXPECT_EQ(nothing.value_or(7), 7);
    EXPECT_THROW((void)nothing.value(), std::bad_optional_access);

    const Result<int> success = Status{};
    EXPECT_FALSE(success);
    EXPECT_EQ(success.code, ErrorCode::internal);
    const Result<int> other = Result<double>(2.0);
    EXPECT_EQ(other.code, ErrorCode::internal);

    const Result<int> failed = Status{ErrorCode::io, "no such file", {}};
    EXPECT_FALSE(failed);
    EXPECT_EQ(failed.message, "no such file");
    EXPECT_EQ(to_string(failed), "error: no such file\n");
}

TEST(Misuse, OfResultsThatAreMoved) {
    Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
    ASSERT_TRUE(result);
    EXPECT_EQ(*result.value(), 5);
    const std::unique_ptr<int> taken = *std::move(result);
    EXPECT_EQ(*taken, 5);
    EXPECT_TRUE(result.ok());
    EXPECT_EQ(*result, nullptr);
}

TEST(Misuse, OfStatuses) {
    EXPECT_TRUE(Status{}.ok());
    EXPECT_EQ(to_string(Status{}), "");
    EXPECT_EQ(to_string(Status{beyond<ErrorCode>(), {}, {}}), "error: \n");
    Diagnostic warning;
    warning.severity = Severity::warning;
    warning.message = "odd";
    EXPECT_EQ(to_string(Status{ErrorCode::none, {}, {warning}}), "warning: odd\n");
    EXPECT_EQ(to_string(Status{ErrorCode::cancelled, "cancelled", {warning}}),
              "warning: odd\nerror: cancelled\n");
    EXPECT_EQ(to_string(Status{ErrorCode::parse, "one of them", {warning, Diagnostic{}}}),
              "warning: odd\nerror: \n");
}

TEST(Misuse, OfErrorCodes) {
    for (int code = 0; code <= static_cast<int>(ErrorCode::internal); ++code)
        EXPECT_NE(to_string(static_cast<ErrorCode>(code)), "unknown") << code;
    EXPECT_EQ(to_string(ErrorCode::out_of_memory), "out_of_memory");
    EXPECT_EQ(to_string(beyond<ErrorCode>()), "unknown");
}

}  // namespace
}  // namespace glint::test
