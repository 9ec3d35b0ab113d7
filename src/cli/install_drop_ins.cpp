// SPDX-License-Identifier: Apache-2.0
// glint install-drop-ins: links named `povray` and `tachyon`, for programs that call those by name.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <system_error>

#include "cli/commands.h"
#include "cli/drop_in.h"
#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/output_file.h"
#include "cli/print_error.h"
#include "cli/print_text.h"
#include "os/files.h"
#include "os/process.h"

namespace glint::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::string folder;
    bool removes = false;
};

// Folders that the system's packages, or all of its users, share.
bool is_systems(const fs::path& folder) {
    for (const char* const shared :
         {"/bin", "/boot", "/dev", "/etc", "/lib", "/lib32", "/lib64", "/libx32", "/nix", "/opt", "/proc",
          "/run", "/sbin", "/snap", "/sys", "/usr", "/var"}) {
        if (folder == shared || is_inside(os::to_string(folder), shared)) return true;
    }
    return folder == folder.root_path();
}

// The program that a link of ours stands for: glint-povray of any installation.
bool is_ours(const fs::path& file, const DropInProgram& program) {
    std::error_code failed;
    return fs::is_symlink(file, failed) && fs::read_symlink(file, failed).filename() == program.name;
}

bool is_there(const fs::path& file) {
    std::error_code failed;
    return fs::exists(fs::symlink_status(file, failed));
}

// The name of the program whose place it takes: povray for glint-povray.
fs::path link_of(const fs::path& folder, const DropInProgram& program) {
    return folder / program.name.substr(std::string_view("glint-").size());
}

// A text for a shell's command line.
std::string in_quotes(const fs::path& folder) {
    std::string quoted = "'";
    for (const char c : os::to_string(folder)) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

[[noreturn]] void fail_at(const fs::path& file, const std::string& why) {
    throw Failure(k_bad_input, fmt::format("{}: {}", os::to_string(file), why));
}

void remove_links(const fs::path& folder) {
    bool removed = false;
    for (const DropInProgram* program : drop_in_programs()) {
        const fs::path link = link_of(folder, *program);
        std::error_code failed;
        if (!is_there(link)) continue;
        if (!is_ours(link, *program)) {
            print_error("glint: {} is left: it is no link to {}\n", os::to_string(link), program->name);
        } else if (fs::remove(link, failed); failed) {
            fail_at(link, failed.message());
        } else {
            print_text(fmt::format("removed {}\n", os::to_string(link)));
            removed = true;
        }
    }
    if (!removed) print_text(fmt::format("nothing to remove in {}\n", os::to_string(folder)));
}

// The running program's folder, which has the others, too.
fs::path programs_folder() {
    const fs::path self = os::program();
    if (self.empty()) throw Failure(k_bad_input, "the folder of this program is not known");
    return self.parent_path();
}

// The older link stays until the new one takes its place.
void replace_link(const fs::path& link, const fs::path& target) {
    const fs::path made = temporary_beside(os::to_string(link));
    std::error_code failed, ignored;
    if (fs::create_symlink(target, made, failed); failed) fail_at(link, failed.message());
    if (fs::rename(made, link, failed); !failed) return;
    fs::remove(made, ignored);
    fail_at(link, failed.message());
}

void install_links(const fs::path& folder) {
    const fs::path programs = programs_folder();
    for (const DropInProgram* program : drop_in_programs()) {
        const fs::path link = link_of(folder, *program), target = programs / program->name;
        if (!is_there(target)) fail_at(target, "no such program: it belongs beside glint");
        if (is_there(link) && !is_ours(link, *program))
            fail_at(link,
                    fmt::format("is there already, and no link to {}: nothing is changed", program->name));
    }
    std::error_code failed;
    if (fs::create_directories(folder, failed); failed) fail_at(folder, failed.message());
    for (const DropInProgram* program : drop_in_programs()) {
        const fs::path link = link_of(folder, *program), target = programs / program->name;
        replace_link(link, target);
        print_text(fmt::format("{} -> {}\n", os::to_string(link), os::to_string(target)));
    }
    print_text(
        fmt::format("\nPrograms that call povray or tachyon find these if the folder is first in PATH:\n"
                    "  export PATH={0}:\"$PATH\"\n"
                    "Undo: glint install-drop-ins --remove {0}\n",
                    in_quotes(folder)));
}

}  // namespace

Run add_install_drop_ins(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "install-drop-ins", "Link glint as povray and tachyon, for programs that call those by name");
    auto arguments = std::make_shared<Arguments>();
    command.add_option("DIR", arguments->folder, "A folder of your own; it is created if there is none")
        ->required();
    command.add_flag("--remove", arguments->removes, "Remove the links; other files stay");
    command.footer(
        "Other files are never replaced, and folders of the system are refused.\n\n"
        "Examples:\n  glint install-drop-ins ~/glint-links\n"
        "  PATH=~/glint-links:$PATH pymol\n  glint install-drop-ins --remove ~/glint-links");
    return [arguments] {
        if (!os::k_has_links)
            throw Failure(k_bad_input,
                          "links need a privilege on Windows: copy glint.exe as povray.exe and tachyon.exe");
        std::error_code failed;
        fs::path folder = fs::absolute(os::to_path(arguments->folder), failed);
        if (!failed) folder = fs::weakly_canonical(folder, failed);
        if (failed) fail_at(os::to_path(arguments->folder), failed.message());
        if (!folder.has_filename()) folder = folder.parent_path();  // a/ is a
        if (is_systems(folder))
            fail_at(folder, "is a folder of the system: choose one of your own, as ~/glint-links");
        if (os::to_string(folder).find(':') != std::string::npos)
            fail_at(folder, "has a colon, which separates the folders of PATH");
        if (is_there(folder) && !fs::is_directory(folder, failed)) fail_at(folder, "is no folder");
        arguments->removes ? remove_links(folder) : install_links(folder);
        return k_done;
    };
}

}  // namespace glint::cli
