// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "base/diagnostics.h"
#include "base/text.h"
#include "cli/failure.h"
#include "cli/memory_size.h"
#include "cli/print_error.h"
#include "cli/repeated_option.h"
#include "cli/text.h"
#include "cli/validators.h"
#include "cli/view_argument.h"
#include "formats/load_validated.h"
#include "formats/registry.h"
#include "os/files.h"
#include "scene/handedness.h"

namespace glint::cli {
namespace {

[[noreturn]] void fail_usage(const std::string& message) { throw Failure(k_usage, message); }

// Applies a setting to an empty scene first, so that its error is reported for the option, not for a file.
void check_setting(const std::string& key, const std::string& value, std::string_view option) {
    const std::optional<std::size_t> index = find_setting(key);
    if (!index) {
        fail_usage(fmt::format("{}: there is no {}{}", option, glint::quoted(key),
                               suggestion(key, setting_names())));
    }
    Scene scratch;
    const std::string error = set_setting(scratch, *index, value, {SettingOrigin::Kind::command, {}}).message;
    if (!error.empty()) fail_usage(fmt::format("{}: {}", option, error));
}

void add_conventions(const SceneArguments& arguments, LoadOptions& options) {
    for (const std::string& text : arguments.conventions) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
            fail_usage(fmt::format("--convention: expected KEY=VALUE, found '{}'", text));
        options.settings.emplace_back(text.substr(0, equals), text.substr(equals + 1));
        check_setting(options.settings.back().first, options.settings.back().second, "--convention " + text);
    }
    for (const auto& [key, value] : arguments.settings) {
        check_setting(key, value, "--" + key);
        options.settings.emplace_back(key, value);
    }
}

// --profile NAME, or a file of `key = value` lines; `file` keeps its text.
void add_profile(const std::string& profile, LoadOptions& options, TextReader& reader,
                 std::optional<InputFile>& file) {
    const auto names = profile_names();
    if (profile.empty() || std::find(names.begin(), names.end(), profile) != names.end()) {
        options.profile = profile;
        return;
    }
    std::string why;
    file = reader.open(profile, why);
    if (!file) {
        fail_usage(fmt::format("--profile: {} is neither a profile nor a readable file ({}){}",
                               glint::quoted(profile), why, suggestion(profile, names)));
    }
    options.profile_text = SceneText{profile, file->text(), {}};
}

}  // namespace

std::vector<std::string_view> setting_names() {
    std::vector<std::string_view> names;
    for (const SettingKey& known : setting_keys()) names.push_back(known.name);
    return names;
}

void add_scene_arguments(CLI::App& command, SceneArguments& arguments) {
    command
        .add_option("SCENE", arguments.files,
                    "Scene files, read together as one scene; - is standard input (needs --format)")
        ->option_text("...")
        ->required();
    command.add_option("--scene", arguments.scene_name, "The scene to use, if the file has several")
        ->option_text("NAME");
    add_include_path_argument(command, arguments);
    add_memory_argument(
        command, arguments.max_memory,
        "The most memory that reading the scene may take: 500M, 4G (default: 2 GiB and 256 times "
        "the length of its files)");
    add_convention_arguments(command, arguments);
}

void add_include_path_argument(CLI::App& command, SceneArguments& arguments) {
    repeated(
        command.add_option("--include-path", arguments.include_paths,
                           "A folder with files that the scene includes and that are not beside it; may be "
                           "repeated"))
        ->option_text("DIR");
}

void add_convention_arguments(CLI::App& command, SceneArguments& arguments) {
    std::vector<std::string> format_names;
    for (const FormatInfo& format : formats()) format_names.emplace_back(format.name);
    const auto profiles = profile_names();
    command.add_option("--format", arguments.format, "The scene's format; default: by the file name")
        ->check(one_of(format_names))
        ->option_text(fmt::format("{}", fmt::join(format_names, "|")));
    command
        .add_option(
            "--profile", arguments.profile,
            fmt::format(
                "Conventions to start from instead of the format's: {}; or a file of `key = value` lines",
                joined(profiles)))
        ->option_text("NAME|FILE");
    repeated(command.add_option(
                 "--convention", arguments.conventions,
                 "Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values "
                 "in force); may be repeated"))
        ->option_text("KEY=VALUE");
    command.add_flag("--skip-unsupported", arguments.skip_unsupported,
                     "Leave out objects that glint does not render; warnings name and count them");
    add_view_argument(command, arguments.view);
}

FileReach reach_of_includes(const SceneArguments& arguments) {
    FileReach reach{.is_confined = arguments.is_confined, .folders = arguments.include_paths};
    for (const std::string& file : arguments.files) reach.folders.push_back(os::folder_of(file));
    return reach;
}

// `profile_file` keeps the text of the profile.
LoadOptions load_options(const SceneArguments& arguments, TextReader& reader,
                         std::optional<InputFile>& profile_file) {
    LoadOptions options;
    options.scene_name = arguments.scene_name;
    options.max_memory = arguments.max_memory;
    options.declared = arguments.declared;
    options.skip_unsupported = arguments.skip_unsupported;
    options.view = arguments.view;
    add_profile(arguments.profile, options, reader, profile_file);
    add_conventions(arguments, options);
    return options;
}

std::optional<Scene> load_with_size(const SceneArguments& arguments, const LoadedScene& loaded,
                                    std::int32_t width, std::int32_t height) {
    TextReader reader;
    std::optional<InputFile> profile_file;
    LoadOptions options = load_options(arguments, reader, profile_file);
    options.settings.emplace_back("size", fmt::format("{}x{}", width, height));
    FileSources sources(reader, arguments.include_paths, loaded.reach);
    Result<Scene> result = load(loaded.texts, options, &sources);
    if (!result) return std::nullopt;
    return *std::move(result);
}

namespace {

// A .pov that is also a scene of CSC 473 is read as one.
void note_mirrored(const std::vector<SceneText>& texts, const Scene& scene,
                   std::vector<Diagnostic>& diagnostics) {
    const SourcePlace place = scene.camera_place;
    if (place.line == 0 || place.file >= texts.size() || !scene.camera.frame) return;
    const SceneText& text = texts[place.file];
    if (!text.format.empty() || choose_format(text).format != "csc473" ||
        !is_reversed_in_povray(*scene.camera.frame))
        return;
    diagnostics.push_back(
        diagnostic_at(Severity::note, {text.name, text.text}, place,
                      "read as a scene of CSC 473, with `right` as it is written; POV-Ray exchanges left "
                      "and right: `--format povray` reads the text as POV-Ray does"));
}

}  // namespace

LoadedScene load_scene(const SceneArguments& arguments, TextReader& reader) {
    std::optional<InputFile> profile_file;
    const LoadOptions options = load_options(arguments, reader, profile_file);
    const auto inputs = std::count(arguments.files.begin(), arguments.files.end(), "-");
    if (inputs > 1) fail_usage("standard input can be read only once");
    if (inputs == 1 && arguments.format.empty()) fail_usage("a scene on standard input needs --format NAME");

    std::vector<InputFile> files;
    std::vector<SceneText> texts;
    std::string problems;
    for (const std::string& name : arguments.files) {
        std::string why;
        std::optional<InputFile> file = reader.open(name, {.is_users = !arguments.is_named_by_file}, why);
        if (!file) {
            problems += fmt::format("{}{}: {}", problems.empty() ? "" : "\n", name, why);
            continue;
        }
        files.push_back(std::move(*file));
    }
    if (!problems.empty()) throw Failure(k_bad_input, problems);
    files.reserve(files.size() + arguments.further_texts.size());  // texts of files keep their place
    for (std::size_t i = 0; i < files.size(); ++i) {
        texts.push_back({arguments.files[i], files[i].text(), arguments.format});
    }
    for (const auto& [name, text] : arguments.further_texts) {
        files.push_back(InputFile::of_text(text));
        texts.push_back({name, files.back().text(), arguments.format});
    }
    FileSources sources(reader, arguments.include_paths, reach_of_includes(arguments));
    Result<ValidatedScene> result = load_validated(texts, options, &sources);
    sources.rethrow();
    if (!result) {
        print(result.diagnostics);
        throw_failure(result);
    }
    note_mirrored(texts, **result, result.diagnostics);
    for (const InputFile& file : files) file.release();  // few commands need the text again
    return {std::move(*result), std::move(result.diagnostics), std::move(files), std::move(texts),
            sources.hashes(),   reach_of_includes(arguments)};
}

LoadedScene load_scene(const SceneArguments& arguments) {
    TextReader reader;
    return load_scene(arguments, reader);
}

std::vector<InputFile> open_included(const LoadedScene& loaded, std::vector<SceneText>& texts) {
    std::vector<InputFile> files;
    std::vector<std::string> names;
    for (std::size_t i = loaded.texts.size(); i < loaded.scene->files.size(); ++i) {
        std::string why;
        if (!is_scene_name(loaded.scene->files[i])) continue;
        if (auto file = InputFile::open_named(loaded.scene->files[i], loaded.reach, why)) {
            files.push_back(std::move(*file));
            names.push_back(loaded.scene->files[i]);
        }
    }
    for (std::size_t i = 0; i < files.size(); ++i) texts.push_back({names[i], files[i].text(), {}});
    return files;
}

void add_warnings(std::vector<Diagnostic>& warnings, const std::vector<Diagnostic>& more) {
    for (const Diagnostic& d : more) {
        const bool known = std::any_of(warnings.begin(), warnings.end(), [&](const Diagnostic& w) {
            return w.message == d.message && w.file == d.file && w.line == d.line && w.column == d.column;
        });
        if (!known) warnings.push_back(d);
    }
}

void print(const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& d : diagnostics) print_error("{}", to_string(d));
}

}  // namespace glint::cli
