// SPDX-License-Identifier: Apache-2.0
// glint-povray's command line: its words and those of .ini files.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "base/text.h"
#include "cli/drop_in.h"
#include "cli/drop_in_povray.h"
#include "cli/drop_in_words.h"
#include "cli/failure.h"
#include "cli/foreign_table.h"
#include "cli/input_file.h"
#include "cli/text.h"
#include "os/files.h"

namespace glint::cli {
namespace {

constexpr int k_max_ini_depth = 10, k_max_ini_files = 1000;

class PovrayArguments {
  public:
    explicit PovrayArguments(IniFiles& files) : files_(files) {}
    DropIn parse(const std::vector<std::string>& words) {
        read_own_ini();
        for (const std::string& word : words) {
            if (word == "--help" || word == "-help" || word == "-h" || word == "-?") {
                options_.parsed().wants_help = true;
            } else if (word == "--version" || word == "-version") {
                options_.parsed().wants_version = true;
            } else if (word == "--skip-unsupported") {
                options_.parsed().render.scene.skip_unsupported = true;
            } else if (!word.empty() &&
                       (word[0] == '+' || word[0] == '-' || word.find('=') < word.find(' '))) {
                for (const std::string& option : split_options(word, true)) read(option);
            } else {
                read(word);
            }
        }
        return options_.finish();
    }

  private:
    // The user's and the system's defaults, as POV-Ray finds them.
    void read_own_ini() {
        std::vector<std::string> candidates;
        if (const char* named = std::getenv("POVINI")) candidates.emplace_back(named);
        candidates.emplace_back("povray.ini");
        if (const char* home = std::getenv("HOME"))
            candidates.push_back(std::string(home) + "/.povray/3.7/povray.ini");
        candidates.emplace_back("/etc/povray/3.7/povray.ini");
        for (const std::string& path : candidates) {
            if (!files_.exists(path)) continue;
            is_own_ini_ = true;
            options_.place.is_trusted = path != "povray.ini";  // which comes with a folder
            read_ini(path);
            is_own_ini_ = options_.place.is_trusted = false;
            return;
        }
    }

    // FILE.ini or FILE.ini[section].
    void read_ini(const std::string& word) {
        const std::size_t bracket = word.ends_with(']') ? word.find('[') : std::string::npos;
        const std::string path = word.substr(0, bracket);
        const std::string wanted =
            bracket == std::string::npos ? "" : word.substr(bracket + 1, word.size() - bracket - 2);
        if (++depth_ > k_max_ini_depth)
            options_.fail(fmt::format("{}: .ini files are nested too deeply", path));
        // Ten files of a hundred lines, each of which names the next file, would be read 100^9 times.
        if (++ini_files_ > k_max_ini_files)
            options_.fail(fmt::format("more than {} .ini files", k_max_ini_files));
        const OptionPlace outer = options_.place;
        options_.place.file = path;
        const std::string file = files_.read(path, depth_ == 1 && !is_own_ini_);
        std::string_view rest = file;
        bool is_wanted = true;
        for (int line = 1; !rest.empty(); ++line) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            const std::string text = trimmed_value(without_comment(rest.substr(0, end)));
            rest.remove_prefix(std::min(end + 1, rest.size()));
            options_.place.text = fmt::format("{}:{}", path, line);
            // In a name it would end the message.
            if (text.find('\0') != std::string::npos) options_.fail("expected text, found a NUL byte");
            if (text.starts_with('[') && text.ends_with(']')) {
                is_wanted = text.substr(1, text.size() - 2) == wanted;
            } else if (is_wanted && !text.empty()) {
                read_line(text);
            }
        }
        options_.place = outer;
        --depth_;
    }

    // Key = Value, or switches.
    void read_line(const std::string& text) {
        const bool is_key = text[0] != '+' && text[0] != '-' && text.find('=') != std::string::npos;
        if (is_key) return read(text);
        if (text.find('=') != std::string::npos) {
            for (const std::string& option : split_options(text, true)) read(option);
            return;
        }
        for (std::size_t i = 0; i < text.size();) {
            const std::size_t end = std::min(text.find_first_of(" \t", i), text.size());
            if (end > i) read(text.substr(i, end - i));
            i = end + 1;
        }
    }

    void read(const std::string& word) {
        if (word.size() > 1 && (word[0] == '+' || word[0] == '-')) {
            const PovraySwitch* known = find_povray_switch(std::string_view(word).substr(1));
            if (known == nullptr) return unknown(fmt::format("unknown switch {}", glint::quoted(word)));
            return options_.set(known->id, trimmed_value(word.substr(1 + known->letters.size())),
                                word[0] == '+', word);
        }
        const std::size_t equals = word.find('=');
        if (equals != std::string::npos) {
            const std::string key = trimmed_value(word.substr(0, equals)),
                              value = trimmed_value(word.substr(equals + 1));
            const PovraySwitch* known = find_povray_key(key);
            if (known == nullptr) return unknown(fmt::format("unknown key {}", glint::quoted(key)));
            return options_.set(*known, value, word);
        }
        const std::string ending = extension(word.substr(0, word.find('[')));
        if (ending == ".ini") return read_ini(word);
        options_.set_input(word);
    }

    // The system's own defaults may have keys of other versions.
    void unknown(const std::string& message) const {
        if (!is_own_ini_) options_.fail(message);
    }

    IniFiles& files_;
    PovrayOptions options_;
    bool is_own_ini_ = false;
    int depth_ = 0, ini_files_ = 0;
};

}  // namespace

bool IniFiles::exists(const std::string& path) { return os::info_of(path).kind == os::FileKind::regular; }

std::string IniFiles::read(const std::string& path, bool is_users) {
    std::string why;
    TextReader reader;
    const auto file = reader.open(path, {.is_users = is_users}, why);
    if (!file) throw Failure(k_bad_input, fmt::format("{}: {}", path, why));
    return std::string(file->text());
}

DropIn povray_drop_in(const std::vector<std::string>& arguments, IniFiles& files) {
    return PovrayArguments(files).parse(arguments);
}

DropIn povray_drop_in(const std::vector<std::string>& arguments) {
    IniFiles files;
    return povray_drop_in(arguments, files);
}

}  // namespace glint::cli
