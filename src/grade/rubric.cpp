// SPDX-License-Identifier: Apache-2.0
#include "grade/rubric.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/diagnostics.h"
#include "base/text.h"
#include "compare/cause_names.h"
#include "glint/conventions.h"

namespace glint {
namespace {

constexpr double k_max_points = 1e6;

struct Word {
    std::string_view text;
    std::size_t at = 0;  // in the rubric
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::optional<int> light_count(std::string_view text) {
    if (text.empty() || text.size() > 6) return std::nullopt;
    int count = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') return std::nullopt;
        count = count * 10 + (c - '0');
    }
    return count;
}

// Why a pair is no setting, or an empty string.
std::string setting_fault(std::string_view key, std::string_view value) {
    if (key == "lights") {
        if (value == "all" || value == "ambient" || light_count(value)) return {};
        return fmt::format("expected all, ambient or a number of lights, found {}", quoted(value));
    }
    if (key == "size")
        return "there is no setting 'size' for a rubric: --size, or --reference, gives that of all parts";
    const std::optional<std::size_t> index = find_setting(key);
    if (!index) {
        std::vector<std::string_view> names = {"lights"};
        for (const SettingKey& known : setting_keys()) {
            if (known.name != "size") names.push_back(known.name);
        }
        return fmt::format("there is no setting {} for a rubric", quoted(key)) + did_you_mean(key, names);
    }
    Scene scratch;
    return set_setting(scratch, *index, value, {SettingOrigin::Kind::command, {}}).message;
}

class LineReader {
  public:
    /// line: of the whole text.
    LineReader(InputText whole, std::string_view line, Rubric& rubric, Diagnostics& diagnostics)
        : whole_(whole), line_(line), rubric_(rubric), diagnostics_(diagnostics) {}

    void read() {
        std::vector<Word> words;
        if (!split(words) || words.empty()) return;
        if (words[0].text.empty()) return fail(words[0], "the part has no name");
        // A part may be called "penalty", too: its second word is a number.
        if (words[0].text == "penalty" && words.size() > 1 && !is_number(words[1].text))
            return read_penalty(words);
        if (words.size() < 3) return fail(words.back(), "expected PART POINTS FILE [KEY=VALUE...]");
        RubricRow row{std::string(words[0].text), 0, std::string(words[2].text), {}, {}, line_number()};
        if (!take_points(words[1], "part's", row.points)) return;
        if (row.file.empty())
            return fail(words[2], "expected the file of a submission, such as *.png, found nothing");
        RubricSettings* settings = &row.settings;
        for (std::size_t i = 3; i < words.size(); ++i) {
            if (words[i].text == "without" && settings == &row.settings) {
                settings = &row.without;
            } else if (!take_setting(words[i], *settings)) {
                return;
            }
        }
        if (settings == &row.without && row.without.empty())
            return fail(words.back(), "expected KEY=VALUE after `without`");
        rubric_.rows.push_back(std::move(row));
    }

  private:
    static bool is_number(std::string_view text) {
        double value = 0;
        return fast_float::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
    }

    bool take_points(const Word& word, std::string_view whose, double& value) {
        const std::string_view text = word.text;
        const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && value > 0 && value <= k_max_points)
            return true;
        fail(word, fmt::format("expected the {} points, a number above 0 and at most {}, found {}", whose,
                               k_max_points, quoted(text)));
        return false;
    }

    void read_penalty(const std::vector<Word>& words) {
        const std::string_view cause = words[1].text;
        const std::vector<std::string_view>& names = cause_names();
        if (std::find(names.begin(), names.end(), cause) == names.end()) {
            return fail(words[1], fmt::format("docs/compare.md has no cause {}", quoted(cause)) +
                                      did_you_mean(cause, names));
        }
        if (words.size() != 3) return fail(words.back(), "expected penalty CAUSE POINTS");
        RubricPenalty penalty{std::string(cause), 0};
        if (!take_points(words[2], "penalty's", penalty.points)) return;
        const bool is_twice = std::any_of(rubric_.penalties.begin(), rubric_.penalties.end(),
                                          [&](const RubricPenalty& p) { return p.cause == cause; });
        if (is_twice) return fail(words[1], fmt::format("{} has a penalty already", quoted(cause)));
        rubric_.penalties.push_back(std::move(penalty));
    }

    // Words, or texts between quotes; nothing from # on. False if a quote is not closed.
    bool split(std::vector<Word>& words) {
        for (std::size_t i = 0; i < line_.size() && line_[i] != '#';) {
            if (is_space(line_[i])) {
                ++i;
                continue;
            }
            const bool in_quotes = line_[i] == '"';
            const std::size_t start = in_quotes ? i + 1 : i;
            std::size_t end = start;
            while (end < line_.size() && (in_quotes ? line_[end] != '"' : !is_space(line_[end]))) ++end;
            const auto line_start = static_cast<std::size_t>(line_.data() - whole_.text.data());
            words.push_back({line_.substr(start, end - start), line_start + start});
            if (in_quotes && end == line_.size()) {
                fail(words.back(), "the quote is not closed");
                return false;
            }
            i = end + (in_quotes ? 1 : 0);
        }
        return true;
    }

    bool take_setting(const Word& word, RubricSettings& settings) {
        const std::size_t equals = word.text.find('=');
        if (equals == std::string_view::npos) {
            fail(word, fmt::format("expected KEY=VALUE, found {}", quoted(word.text)));
            return false;
        }
        const std::string_view key = word.text.substr(0, equals), value = word.text.substr(equals + 1);
        if (const std::string wrong = setting_fault(key, value); !wrong.empty()) {
            fail(word, wrong);
            return false;
        }
        settings.emplace_back(key, value);
        return true;
    }

    std::uint32_t line_number() const {
        return static_cast<std::uint32_t>(1 + std::count(whole_.text.data(), line_.data(), '\n'));
    }

    void fail(const Word& word, std::string message) {
        diagnostics_.error(whole_, word.at, word.text.size(), std::move(message));
    }

    InputText whole_;
    std::string_view line_;
    Rubric& rubric_;
    Diagnostics& diagnostics_;
};

}  // namespace

RubricResult read_rubric(std::string_view name, std::string_view text) {
    RubricResult result;
    result.rubric.name = name;
    Diagnostics diagnostics;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark
    for (std::string_view rest = text; !rest.empty() && !diagnostics.full();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        LineReader({name, text}, rest.substr(0, end), result.rubric, diagnostics).read();
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    result.diagnostics = diagnostics.take();
    if (result.rubric.rows.empty() && result.diagnostics.empty()) {
        Diagnostic d;
        d.file = name;
        d.line = d.column = 1;
        d.message = "the rubric has no parts: expected lines of PART POINTS FILE [KEY=VALUE...]";
        result.diagnostics.push_back(std::move(d));
    }
    return result;
}

std::vector<bool> kept_lights(const Scene& scene, const RubricSettings& settings) {
    std::vector<bool> kept(scene.lights.size(), true);
    for (const auto& [key, value] : settings) {
        if (key != "lights") continue;
        int left = value == "ambient" ? 0 : light_count(value).value_or(static_cast<int>(kept.size()));
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (kept[i] && !scene.lights[i].is_ambient()) kept[i] = left-- > 0;
        }
    }
    return kept;
}

void set_all_but_lights(Scene& scene, const RubricSettings& settings) {
    for (const auto& [key, value] : settings) {
        if (key == "lights") continue;
        if (const auto index = find_setting(key))
            set_setting(scene, *index, value, {SettingOrigin::Kind::command, {}});
    }
}

Scene with_settings(const Scene& scene, const RubricSettings& settings) {
    Scene changed = scene;
    const std::vector<bool> kept = kept_lights(scene, settings);
    std::size_t i = 0;
    std::erase_if(changed.lights, [&](const Light&) { return !kept[i++]; });
    set_all_but_lights(changed, settings);
    return changed;
}

}  // namespace glint
