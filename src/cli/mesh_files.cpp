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

namespace glint::cli {
namespace {

// Smaller meshes can be read and edited in the text.
constexpr std::size_t k_readable_triangles = 200;

// Relative to the folder of `output`, with `/` between folders.
std::string name_from(const std::string& output, const std::string& file) {
    std::error_code failed;
    const std::filesystem::path folder = std::filesystem::absolute(output, failed).parent_path();
    const std::filesystem::path relative = std::filesystem::relative(file, folder, failed);
    return failed || relative.empty() ? file : relative.generic_string();
}

}  // namespace

std::vector<std::string> write_mesh_files(const Scene& scene, const std::string& output) {
    std::vector<std::string> names = mesh_file_names(scene);
    const std::string stem = output.substr(0, output.size() - extension(output).size());
    int written = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!names[i].empty()) {
            names[i] = name_from(output, names[i]);
            continue;
        }
        if (scene.meshes[i]->triangles.size() <= k_readable_triangles) continue;
        const Result<std::string> ply = write_ply(*scene.meshes[i]);
        if (!ply) continue;  // into the text
        const std::string path = fmt::format("{}-{}.ply", stem, ++written);
        OutputFile("OUT", path).write({reinterpret_cast<const std::uint8_t*>(ply->data()), ply->size()});
        names[i] = name_from(output, path);
    }
    return names;
}

}  // namespace glint::cli
