// SPDX-License-Identifier: Apache-2.0
// #include: the text beside the including one, glint's table of standard names, or POV-Ray's own file.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/directive_parser.h"
#include "formats/povray/standard_includes.h"

namespace glint::povray {

void DirectiveParser::read_include(const Token& at) {
    begin_value();
    const std::string name(*string());
    // Not by accept(): the token after the file's name must come after the file's own.
    const Frame& frame = frames_.back();
    if (!has_ahead_ && frame.at < frame.end && frame.tokens[frame.at].is(';')) take_raw();
    end_value();
    if (failed()) return;
    if (frames_.size() >= k_max_frames) {
        return error(at, fmt::format("macros and includes are nested more than {} deep", k_max_frames));
    }
    if (++reading().includes.count > k_max_includes) {
        return error(at, fmt::format("more than {} includes", k_max_includes));
    }
    include(at, name);
}

// Texts of one folder: the names of POV-Ray's includes have no folder.
std::string DirectiveParser::path_of(const std::string& name) {
    const std::string_view from = text().place.name;
    return is_absolute_path(name) ? name : std::string(from.substr(0, from.rfind('/') + 1)) + name;
}

// The text of a name: a file's, or glint's own.
DirectiveParser::FoundText DirectiveParser::find_text(const std::string& name) {
    const std::string_view from = text().place.name;
    Status beside{ErrorCode::io, "no files are read here", {}};
    if (reading().sources != nullptr) {
        Result<std::string> text = reading().sources->read(name, from);
        if (text) return {std::move(text), false};
        beside = {ErrorCode::io, text.message.empty() ? "no such file" : text.message, {}};
    }
    StandardInclude own = standard_include(name);
    if (own.is_complete) return {std::move(own.text), true};
    if (reading().sources != nullptr && name.find('/') == std::string::npos) {
        Result<std::string> text = reading().sources->read(std::string(k_system_folder) + name, from);
        if (text) return {std::move(text), true};
    }
    if (!own.text.empty()) return {std::move(own.text), true};
    return {std::move(beside), false};
}

void DirectiveParser::include(const Token& at, const std::string& name) {
    const std::string path = path_of(name);
    Includes& all = reading().includes;
    if (const auto known = all.files.find(path); known != all.files.end()) {
        return open_text(at, known->second);
    }
    FoundText found = find_text(name);
    if (!found.text) {
        reading().is_include_missing = true;
        error(at, fmt::format("{}: {}", quoted(name), found.text.message));
        return report_missing();
    }
    if (found.is_own && !version_) {
        version_ = 3.7;  // POV-Ray's own includes end with it
        version_place_ = at;
    }
    add_text(at, path, std::move(*found.text));
}

// Reading ends at the first include without a text. The others that the text certainly includes are reported
// with it.
void DirectiveParser::report_missing() {
    const Frame& frame = frames_.back();
    int depth = 0;  // of conditions, loops and macros that begin after the first one
    for (std::uint32_t i = frame.at; i + 1 < frame.end && !reading().diagnostics.full(); ++i) {
        const Token& token = frame.tokens[i];
        if (token.kind != TokenKind::directive) continue;
        if (begins_block(token.directive())) ++depth;
        switch (token.directive()) {
            case Word::k_else:
            case Word::k_elseif:
            case Word::k_case:
            case Word::k_range:
                if (depth == 0) depth = 1;  // the other branch of the condition that this is in
                break;
            case Word::k_end:
                depth = std::max(0, depth - 1);
                break;
            case Word::k_include: {
                const Token& file = frame.tokens[i + 1];
                if (depth > 0 || file.kind != TokenKind::string) break;
                const std::string_view said = text_of(file);  // with its quotation marks
                const std::string name(said.substr(1, said.size() - 2));
                if (reading().includes.files.contains(path_of(name))) break;
                if (const FoundText found = find_text(name); !found.text) {
                    reading().diagnostics.error(reading().texts[token.text], token.offset,
                                                text_of(token).size(),
                                                fmt::format("{}: {}", quoted(name), found.text.message));
                }
                break;
            }
            default:
                break;
        }
    }
}

void DirectiveParser::add_text(const Token& at, const std::string& path, std::string text) {
    if (reading().texts.size() > k_max_texts) {
        return error(at, fmt::format("at most {} texts make a scene", k_max_texts));
    }
    const std::uint16_t number = reading().add_text(path, std::move(text));
    lex_text(number);
    open_text(at, number);
}

void DirectiveParser::open_text(const Token& at, std::uint16_t number) {
    if (number >= tokens_.size() || tokens_[number].empty()) lex_text(number);
    for (const Frame& frame : frames_) {
        if (frame.kind == FrameKind::macro || frame.text != number) continue;
        return error(at,
                     fmt::format("a text cannot include itself: {}", quoted(reading().texts[number].name)));
    }
    Frame frame;
    frame.kind = FrameKind::include;
    frame.text = number;
    frame.tokens = tokens_[number].data();
    frame.end = static_cast<std::uint32_t>(tokens_[number].size() - 1);
    frame.conditions = conditions_.size();
    frame.call = at;
    frames_.push_back(std::move(frame));
}

}  // namespace glint::povray
