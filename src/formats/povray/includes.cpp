// SPDX-License-Identifier: Apache-2.0
// #include: the text beside the including one, glint's table of standard names, or POV-Ray's own file.
#include <fmt/format.h>

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

void DirectiveParser::include(const Token& at, const std::string& name) {
    Includes& all = reading().includes;
    // Texts of one folder: the names of POV-Ray's includes have no folder.
    const std::string_view from = text().place.name;
    const std::string path =
        name.starts_with('/') ? name : std::string(from.substr(0, from.rfind('/') + 1)) + name;
    if (const auto known = all.files.find(path); known != all.files.end()) {
        return open_text(at, known->second);
    }
    std::string why = "no files are read here";
    if (reading().sources != nullptr) {
        Result<std::string> text = reading().sources->read(name, from);
        if (text) return add_text(at, path, std::move(*text));
        why = text.message.empty() ? "no such file" : text.message;
    }
    if (!version_) {
        version_ = 3.7;  // POV-Ray's own includes end with it
        version_place_ = at;
    }
    StandardInclude own = standard_include(name);
    if (own.is_complete) return add_text(at, path, std::move(own.text));
    if (reading().sources != nullptr && name.find('/') == std::string::npos) {
        Result<std::string> text = reading().sources->read(std::string(k_system_folder) + name, from);
        if (text) return add_text(at, path, std::move(*text));
    }
    if (!own.text.empty()) return add_text(at, path, std::move(own.text));
    reading().is_include_missing = true;
    error(at, fmt::format("{}: {}", quoted(name), why));
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
