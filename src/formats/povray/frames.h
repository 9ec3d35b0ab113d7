// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is being read: texts and macros within each other, their conditions, and what names stand for there.
#include <cstdint>
#include <memory>

#include "base/memory_budget.h"
#include "formats/povray/lexer.h"
#include "formats/povray/value.h"

namespace glint::povray {

enum class FrameKind : std::uint8_t { text, include, macro };

/// A text or the body of a macro or function that is being read.
struct Frame {
    FrameKind kind = FrameKind::text;
    std::uint16_t text = 0;
    const Token* tokens = nullptr;  // also at `end` there is one
    std::uint32_t at = 0, end = 0;
    std::size_t conditions = 0;           // open when it began
    CountedVector<std::uint32_t> locals;  // to be removed at its end
    Token call;                           // of the macro or include
    std::shared_ptr<const Function> function;
};

enum class ConditionKind : std::uint8_t { branch, loop_while, loop_for, choice };

/// A directive that an `#end` belongs to, and whose parts are being read.
struct Condition {
    ConditionKind kind = ConditionKind::branch;
    Token at;
    bool is_done = false;     // branch: one part has been read; choice: a case has been found
    std::uint32_t begin = 0;  // loops: the first token of the condition, or of the body
    std::uint32_t name = 0;   // for: the variable
    double end = 0, step = 1;
    double choice = 0;
};

/// What a name stands for in a frame and those that it opens.
struct Binding {
    std::uint32_t depth = 0;  // the frame's
    Value value;
};

/// While a value is read, directives of the same frame end it.
struct Mark {
    std::size_t frames = 0, conditions = 0;
    int braces = 0;
};

}  // namespace glint::povray
