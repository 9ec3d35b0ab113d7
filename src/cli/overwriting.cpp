// SPDX-License-Identifier: Apache-2.0
#include "cli/overwriting.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "cli/failure.h"
#include "os/files.h"

namespace glint::cli {
namespace {

namespace fs = std::filesystem;

using os::FileIdentity;

std::optional<FileIdentity> identity(const os::FileInfo& about) {
    if (about.kind != os::FileKind::regular) return std::nullopt;  // pipes and devices cannot be overwritten
    return about.identity;
}

struct Output {
    std::string option, path;
    std::optional<FileIdentity> file;  // of a regular file that is there already
    fs::path whole;                    // with links followed
};

// Global: the inputs and outputs of a command are spread over its options, its scene's includes and more.
struct Noted {
    std::vector<FileIdentity> inputs;
    std::vector<Output> outputs;
    std::string standard_output;  // the option that uses it
};
Noted& noted() {
    static Noted all;
    return all;
}

[[noreturn]] void refuse(const Output& output) {
    throw Failure(k_usage, fmt::format("{} '{}' would overwrite an input: choose another file", output.option,
                                       output.path));
}

// Throws a usage error if the file has been read, or if another option writes it.
void add_output(Output output) {
    auto& [inputs, outputs, standard_output] = noted();
    for (const Output& other : outputs) {
        if (other.file ? other.file == output.file : other.whole == output.whole)
            throw Failure(k_usage,
                          fmt::format("{} and {} are the same file, '{}': choose another for one of them",
                                      other.option, output.option, output.path));
    }
    if (output.file && std::find(inputs.begin(), inputs.end(), *output.file) != inputs.end()) refuse(output);
    outputs.push_back(std::move(output));
}

}  // namespace

fs::path followed(const std::string& path) {
    fs::path found = os::followed(path);
    std::error_code error;
    return found.empty() ? fs::absolute(os::to_path(path), error).lexically_normal() : found;
}

void note_output(const std::string& option, const std::string& path) {
    Output output{option, path, {}, {}};
    const os::FileInfo about = os::info_of(path);
    output.file = identity(about);
    if (!output.file && about.kind != os::FileKind::none) return;
    output.whole = followed(path);
    add_output(std::move(output));
}

void note_standard_output(const std::string& option) {
    std::string& taken = noted().standard_output;
    if (!taken.empty())
        throw Failure(k_usage, fmt::format("{} and {} cannot both go to standard output", taken, option));
    taken = option;
    // A shell may redirect it to a file.
    if (const auto file = identity(os::info_of(os::k_standard_output)))
        add_output({option, "standard output", file, {}});
}

void note_input(int descriptor) {
    const auto file = identity(os::info_of(descriptor));
    if (!file) return;
    for (const Output& output : noted().outputs) {
        if (output.file == file) refuse(output);
    }
    noted().inputs.push_back(*file);
}

}  // namespace glint::cli
