// SPDX-License-Identifier: Apache-2.0
#include "cli/mesh_files.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <system_error>

#include "cli/failure.h"
#include "cli/output_file.h"
#include "cli/text.h"
#include "formats/mesh_file.h"
#include "glint/write.h"
#include "os/files.h"

namespace glint::cli {
namespace {

// Smaller meshes can be read and edited in the text.
constexpr std::size_t k_readable_triangles = 200;

// Relative to the folder of `output`, with `/` between folders.
std::string name_from(const std::string& output, const std::string& file) {
    std::error_code failed;
    const std::filesystem::path folder = std::filesystem::absolute(os::to_path(output), failed).parent_path();
    const std::filesystem::path relative = std::filesystem::relative(os::to_path(file), folder, failed);
    return failed || relative.empty() ? file : os::to_string(relative);
}

struct NewFile {
    OutputFile file;
    std::string bytes;
};

}  // namespace

std::vector<std::string> known_mesh_files(const Scene& scene, const std::string& format) {
    std::vector<std::string> names = mesh_file_names(scene);
    for (std::string& name : names) {
        // Not standard input, nor a file of an include path, nor one whose name says another format.
        if (!format.empty() || os::info_of(name).kind != os::FileKind::regular) name.clear();
    }
    return names;
}

std::vector<std::string> write_mesh_files(const Scene& scene, const std::string& format,
                                          const OutputFile& output) {
    std::vector<std::string> names = known_mesh_files(scene, format);
    // Beside the file that a link stands for.
    const std::string& target = output.target();
    const std::string stem = target.substr(0, target.size() - extension(target).size());
    std::vector<NewFile> files;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!names[i].empty()) {
            names[i] = name_from(target, names[i]);
            continue;
        }
        if (scene.meshes[i]->triangles.size() <= k_readable_triangles) continue;
        Result<std::string> ply = write_ply(*scene.meshes[i]);
        if (!ply) continue;  // into the text
        const std::string path = fmt::format("{}-{}.ply", stem, files.size() + 1);
        if (os::exists(path) && !os::exists(target)) {
            throw Failure(k_usage,
                          fmt::format("'{}' would be overwritten, and is not of an earlier conversion: "
                                      "choose another OUT",
                                      path));
        }
        names[i] = name_from(target, path);
        files.push_back({OutputFile("OUT", path), std::move(*ply)});
    }
    // Nothing is written unless all may be.
    for (const NewFile& file : files)
        file.file.write({reinterpret_cast<const std::uint8_t*>(file.bytes.data()), file.bytes.size()});
    return names;
}

void name_texture_files(Scene& scene, const OutputFile& output) {
    for (Texture& texture : scene.textures) {
        if (!texture.file.empty()) texture.file = name_from(output.target(), texture.file);
    }
}

}  // namespace glint::cli
