// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fuzzing of texts: load them and check the result.
#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "formats/tiny_font.h"
#include "glint/load.h"

namespace glint::test {

/// A format's name in the first line, and a text of that format after it.
struct NamedText {
    std::string format;
    std::string_view text;
};
inline NamedText split_format(std::string_view data) {
    const std::size_t end = std::min(data.find('\n'), data.size());
    return {std::string(data.substr(0, end)), data.substr(std::min(end + 1, data.size()))};
}

/// Cancels the reading of a text in POV-Ray's language after some 3 million tokens, a tenth of what the
/// reader allows to a loop that does not end: all of them take half a minute with the sanitizers.
class FewSteps {
  public:
    explicit FewSteps(std::string_view format) : is_counted_(format == "povray") {}
    bool load() const { return is_counted_ && ++calls_ > 50; }  // one for 65536 tokens

  private:
    bool is_counted_;
    mutable int calls_ = 0;
};

/// load(), which a FewSteps may cancel.
inline Result<Scene> load_few_steps(std::span<const SceneText> texts, LoadOptions options = {},
                                    Sources* sources = nullptr) {
    const FewSteps steps(texts[0].format);
    options.cancel = &steps;
    return load(texts, options, sources);
}

/// The texts that may be included: a part of the text itself, under any name, at most 200 bytes; and a font.
class FuzzSources : public Sources {
  public:
    explicit FuzzSources(std::string_view text) : text_(text.substr(text.size() / 2, 200)) {}
    Result<std::string> read(std::string_view name, std::string_view) override {
        if (name.starts_with("no")) return Status{ErrorCode::io, "no such file", {}};
        if (name.ends_with(".ttf")) return tiny_font();
        return std::string(text_);
    }

  private:
    std::string_view text_;
};

/// Loads the text. Returns an error message about the result, or an empty string.
inline std::string fuzz_load(std::string_view text, std::string format, const LoadOptions& options = {}) {
    const SceneText texts[] = {{"fuzz", text, std::move(format)}};
    FuzzSources sources(text);
    const Result<Scene> result = load_few_steps(texts, options, &sources);
    if (result.code == ErrorCode::cancelled) return {};
    std::string printed;
    for (const Diagnostic& d : result.diagnostics) printed += to_string(d);
    if (result.has_value() == has_errors(result.diagnostics))
        return "a scene and an error, or neither: " + printed;
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity == Severity::error && d.line == 0) return "an error without a place: " + d.message;
    }
    if (result && has_errors(validate(*result))) return "a scene that is not valid";
    if (result || options.skip_unsupported) return {};
    // What is left after objects have been left out is a scene, too.
    LoadOptions skips = options;
    skips.skip_unsupported = true;
    return fuzz_load(text, texts[0].format, skips);
}

}  // namespace glint::test
