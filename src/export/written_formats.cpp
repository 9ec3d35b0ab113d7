// SPDX-License-Identifier: Apache-2.0
// The formats that scenes are written in. A new one adds its row.
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <vector>

#include "base/status.h"
#include "base/text.h"
#include "export/gltf/write.h"
#include "glint/write.h"

namespace glint {
namespace {

struct Writer {
    WrittenFormat format;
    Result<std::string> (*write)(const Scene&);
};

constexpr Writer k_writers[] = {
    {{"glint", ".glint", "glint's own scene language, which keeps all of a scene"},
     [](const Scene& scene) { return write_glint(scene); }},
    {{"glb", ".glb", "glTF 2.0 in one binary file, for Blender and most other programs"},
     gltf_export::write_binary},
    {{"gltf", ".gltf", "glTF 2.0 as text, with its numbers and pictures inside"}, gltf_export::write_text},
};

constexpr auto k_written = [] {
    std::array<WrittenFormat, std::size(k_writers)> formats;
    for (std::size_t i = 0; i < formats.size(); ++i) formats[i] = k_writers[i].format;
    return formats;
}();

}  // namespace

std::span<const WrittenFormat> written_formats() { return k_written; }

Result<std::string> write_scene(const Scene& scene, std::string_view format) {
    const auto body = [&]() -> Result<std::string> {
        std::vector<std::string_view> names;
        for (const Writer& writer : k_writers) {
            if (writer.format.name == format) return writer.write(scene);
            names.push_back(writer.format.name);
        }
        return invalid_argument(
            fmt::format("expected one of the formats {}, found {}", fmt::join(names, ", "), quoted(format)));
    };
    return result_of(body, " while writing the scene");
}

}  // namespace glint
