// SPDX-License-Identifier: Apache-2.0
#include "base/status.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics.h"
#include "base/text.h"

namespace glint {

std::string_view to_string(ErrorCode code) {
    switch (code) {
        case ErrorCode::none:
            return "none";
        case ErrorCode::invalid_argument:
            return "invalid_argument";
        case ErrorCode::invalid_scene:
            return "invalid_scene";
        case ErrorCode::parse:
            return "parse";
        case ErrorCode::io:
            return "io";
        case ErrorCode::cancelled:
            return "cancelled";
        case ErrorCode::out_of_memory:
            return "out_of_memory";
        case ErrorCode::internal:
            return "internal";
    }
    return "unknown";
}

std::string to_string(const Status& status) {
    std::string text;
    for (const Diagnostic& d : status.diagnostics) text += to_string(d);
    if (!status.ok() && !has_errors(status.diagnostics))
        text += fmt::format("error: {}\n", printable(status.message));
    return text;
}

Status failure(ErrorCode code, std::vector<Diagnostic> diagnostics) {
    Status status{code, {}, std::move(diagnostics)};
    const auto first = std::find_if(status.diagnostics.begin(), status.diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::error; });
    if (first == status.diagnostics.end()) return status;
    status.message = place_text(*first);
    if (!status.message.empty()) status.message += ": ";
    status.message += first->message;
    return status;
}

}  // namespace glint
