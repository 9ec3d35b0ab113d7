// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fuzzing of POV-Ray's .ini files: read them as glint-povray does and check its arguments.
#include <string>
#include <string_view>

#include "cli/drop_in.h"
#include "cli/failure.h"
#include "glint/scene.h"

namespace glint::test {

/// The .ini files that may be named: fuzz.ini is the text, any other one its second half. There is none of
/// the user's.
class FuzzIniFiles : public cli::IniFiles {
  public:
    explicit FuzzIniFiles(std::string_view text) : text_(text) {}
    bool exists(const std::string&) override { return false; }
    std::string read(const std::string& path, bool) override {
        if (path.starts_with("no")) throw cli::Failure(cli::k_bad_input, path + ": no such file");
        return std::string(path == "fuzz.ini" ? text_ : text_.substr(text_.size() / 2));
    }

  private:
    std::string_view text_;
};

/// Reads the text as an .ini file. Returns what is wrong with the result, or an empty string.
inline std::string fuzz_ini(std::string_view text) {
    FuzzIniFiles files(text);
    cli::DropIn read;
    try {
        read = cli::povray_drop_in({"fuzz.ini"}, files);
    } catch (const cli::Failure& e) {
        return std::string_view(e.what()).empty() ? "a failure without a message" : "";
    }
    if (read.wants_help || read.wants_version) return {};
    const cli::RenderArguments& render = read.render;
    // What it returns is valid for `glint render`.
    auto settings = render.scene.settings;
    settings.emplace_back("size", render.picture.size);
    if (!render.picture.aa.empty()) settings.emplace_back("aa", render.picture.aa);
    Scene scene;
    for (const auto& [key, value] : settings) {
        const auto setting = find_setting(key);
        if (!setting) return "an unknown setting: " + key;
        const Status set = set_setting(scene, *setting, value, {});
        if (!set.ok()) return key + " = " + value + ": " + set.message;
    }
    if (render.scene.files.size() != 1 || render.scene.files[0].empty()) return "no name of a scene";
    if (render.output.empty()) return "no name of a picture";
    return render.numbers.bits == 8 || render.numbers.bits == 16 ? "" : "a wrong number of bits";
}

}  // namespace glint::test
