// SPDX-License-Identifier: Apache-2.0
#include "formats/profile_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace glint {
namespace {

constexpr std::string_view k_blanks = " \t\r\v\f";

// The trimmed part of the line from `from` on; its place is that of its first byte.
std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(k_blanks);
    if (first == std::string_view::npos) return text.substr(text.size());
    return text.substr(first, text.find_last_not_of(k_blanks) - first + 1);
}

std::string_view without_comment(std::string_view line) {
    return line.substr(0, std::min(line.find('#'), line.find("//")));
}

}  // namespace

std::string set_named_setting(Scene& scene, std::string_view key, std::string_view value,
                              SettingOrigin origin) {
    if (const auto index = find_setting(key)) {
        const std::string wrong = set_setting(scene, *index, value, origin).message;
        return wrong.empty() ? wrong : fmt::format("{}: {}", key, wrong);
    }
    std::vector<std::string_view> names;
    for (const SettingKey& k : setting_keys()) names.push_back(k.name);
    return fmt::format("no setting is called {}{}", quoted(key), did_you_mean(key, names));
}

std::string set_named_profile(Scene& scene, std::string_view name) {
    if (apply_profile(scene, name)) return {};
    std::string all;
    for (const auto known : profile_names()) all += fmt::format("{}{}", all.empty() ? "" : ", ", known);
    return fmt::format("no profile is called {}: there are {}{}", quoted(name), all,
                       did_you_mean(name, profile_names()));
}

void read_profile_file(LoadState& reading, const ReadText& text) {
    std::string_view rest = text.place.text;
    if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
    for (std::uint32_t line_number = 1; !rest.empty() && !reading.diagnostics.full(); ++line_number) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view whole_line = rest.substr(0, end);
        const std::string_view line = trimmed(without_comment(whole_line));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.empty()) continue;
        const auto offset = static_cast<std::size_t>(line.data() - text.place.text.data());
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) {
            reading.diagnostics.error(text.place, offset, line.size(),
                                      fmt::format("expected `key = value`, found {}", quoted(line)));
            continue;
        }
        const std::string_view key = trimmed(line.substr(0, equals)),
                               value = trimmed(line.substr(equals + 1));
        const auto column =
            std::min<std::size_t>(static_cast<std::size_t>(line.data() - whole_line.data()) + 1, 65535);
        const SettingOrigin origin{SettingOrigin::Kind::file,
                                   {line_number, static_cast<std::uint16_t>(column), text.file}};
        const std::string wrong = key == "profile" ? set_named_profile(reading.scene, value)
                                                   : set_named_setting(reading.scene, key, value, origin);
        if (!wrong.empty()) reading.diagnostics.error(text.place, offset, line.size(), wrong);
    }
}

}  // namespace glint
