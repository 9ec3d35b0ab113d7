// SPDX-License-Identifier: Apache-2.0
// .json and .js: finds the scenes of a text and selects one. JSON has one scene; the
// homework's JavaScript has a list of scenes with some code of the program around it.
#include <fmt/format.h>

#include <vector>

#include "base/text.h"
#include "formats/data_reader.h"
#include "formats/epfl.h"
#include "formats/registry.h"

namespace glint {
namespace {

struct FoundScene {
    std::size_t offset = 0;  // of its {
    std::string name;
    bool is_scene = false;  // it has a key that only scenes have
};

// Finds the objects of a text, single or in a list, by brackets only: reports no errors
// here.
CountedVector<FoundScene> find_scenes(std::string_view text) {
    CountedVector<FoundScene> scenes;
    Tokenizer tokenizer(text, k_javascript);
    std::size_t depth = 0, scene_depth = 0;
    bool in_list = false;
    Token last, before_last;  // before_last : last
    for (Token t = tokenizer.next(); t.kind != TokenKind::end && t.kind != TokenKind::open_comment;
         t = tokenizer.next()) {
        if (t.is('{') || t.is('[') || t.is('(')) {
            if (depth == 0) in_list = t.is('[');
            if (t.is('{') && (depth == 0 || (depth == 1 && in_list))) {
                scenes.push_back({t.offset, {}, false});
                scene_depth = depth + 1;
            }
            ++depth;
        } else if ((t.is('}') || t.is(']') || t.is(')')) && depth > 0) {
            if (depth-- == scene_depth) scene_depth = 0;
        }
        const bool is_name = last.kind == TokenKind::word || last.kind == TokenKind::string;
        if (scene_depth != 0 && depth == scene_depth && t.is(':') && is_name) {
            const auto key_text = text.substr(last.offset, last.length);
            const std::string key =
                last.kind == TokenKind::string ? string_value(key_text) : std::string(key_text);
            for (const Field& f : k_epfl_scene_fields) scenes.back().is_scene |= f.name == key;
        }
        if (scene_depth != 0 && depth == scene_depth && last.is(':') && t.kind == TokenKind::string) {
            const auto key = text.substr(before_last.offset, before_last.length);
            if (key == "name" || key == "'name'" || key == "\"name\"") {
                scenes.back().name = string_value(text.substr(t.offset, t.length));
            }
        }
        before_last = last;
        last = t;
    }
    std::erase_if(scenes, [](const FoundScene& s) { return !s.is_scene; });
    return scenes;
}

class EpflReader {
  public:
    EpflReader(LoadState& reading, const ReadText& text)
        : reading_(reading), text_(text), p_(text.place, k_javascript, reading.diagnostics), data_(p_) {}

    void read() {
        if (p_.at_end()) p_.expected("a scene `{ ... }` or a list of scenes `[ ... ]`");
        const std::string& wanted = reading_.options.scene_name;
        const Token begin = p_.token();
        const bool is_json = p_.token().is('{');
        if ((!is_json || !wanted.empty()) && !choose(wanted)) return;
        while (!p_.at_end()) read_statement(is_json);
        if (!found_) p_.error(begin, "expected a scene `{ ... }`, found none");
    }

  private:
    static constexpr std::size_t k_any = static_cast<std::size_t>(-1);

    // Sets chosen_. False if the requested scene does not exist.
    bool choose(const std::string& wanted) {
        const auto scenes = find_scenes(text_.place.text);
        if (wanted.empty()) {
            if (scenes.size() > 1) {
                chosen_ = scenes.front().offset;
                p_.note({.offset = chosen_, .length = 1},
                        fmt::format("{} scenes: the first one is read ({})", scenes.size(), names(scenes)));
            }
            return true;
        }
        for (const FoundScene& scene : scenes) {
            if (scene.name != wanted) continue;
            chosen_ = scene.offset;
            return true;
        }
        p_.error(p_.token(), fmt::format("no scene is called {}; there {} {}", quoted(wanted),
                                         scenes.size() == 1 ? "is" : "are",
                                         scenes.empty() ? "no scenes" : names(scenes)));
        return false;
    }

    static std::string names(const CountedVector<FoundScene>& scenes) {
        constexpr std::size_t most = 20;
        std::string all;
        for (std::size_t i = 0; i < scenes.size() && i < most; ++i) {
            all += i == 0 ? "" : ", ";
            all += scenes[i].name.empty() ? "one without a name" : quoted(scenes[i].name);
        }
        return scenes.size() > most ? all + ", ..." : all;
    }

    bool is_word(std::string_view word) const {
        return p_.token().kind == TokenKind::word && p_.text(p_.token()) == word;
    }

    // Skips code before data: `export`, `default`, `const NAME =`, `module.exports =`. False if no data
    // follows.
    bool skip_declaration() {
        while (is_word("export") || is_word("default")) p_.take();
        if (is_word("const") || is_word("let") || is_word("var")) {
            p_.take();
            if (p_.token().kind == TokenKind::word) p_.take();
        } else if (is_word("module") && p_.peek().is('.')) {
            p_.take();
            p_.take();
            if (is_word("exports")) p_.take();
        } else {
            return p_.token().is('{') || p_.token().is('[');
        }
        return p_.accept('=') && (p_.token().is('{') || p_.token().is('['));
    }

    void read_statement(bool is_json) {
        if (p_.accept(';')) return;
        if (is_json && found_) {
            p_.expected("the end of the text");
            return p_.stop();
        }
        if (is_word("import")) {
            const Token import = p_.take();
            p_.warn(import, "glint ignores imports");
            while (!p_.at_end() && p_.token().line == import.line) p_.take();
            return;
        }
        if (p_.token().kind == TokenKind::string) {  // "use strict"
            p_.take();
            return;
        }
        const Token begin = p_.token();
        if (!skip_declaration()) {
            if (found_) {
                p_.warn(begin, "glint reads data, not code: what follows is ignored");
            } else {
                p_.expected("a scene `{ ... }` or a list of scenes `[ ... ]`");
            }
            return p_.stop();
        }
        if (!read_data()) return p_.stop();
        // `[...].map(...)` is not plain data.
        if (p_.token().kind == TokenKind::symbol && !p_.token().is(';')) {
            p_.expected("the end of the text");
            p_.stop();
        }
    }

    bool read_data() {
        if (p_.token().is('{')) return read_object();
        return data_.list("scenes", [&] {
            if (p_.token().is('{')) return read_object();
            p_.expected("a scene `{ ... }`");
            return false;
        });
    }

    bool read_object() {
        const bool is_chosen = chosen_ == k_any ? !found_ : p_.token().offset == chosen_;
        if (!is_chosen) return p_.skip_value();
        found_ = true;
        return read_epfl_scene(reading_, text_, p_);
    }

    LoadState& reading_;
    const ReadText& text_;
    Parser p_;
    DataReader data_;
    std::size_t chosen_ = k_any;  // the offset of the scene to read; k_any: the first
    bool found_ = false;
};

}  // namespace

void read_epfl(LoadState& reading, const ReadText& text) { EpflReader(reading, text).read(); }

}  // namespace glint
