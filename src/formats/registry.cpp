// SPDX-License-Identifier: Apache-2.0
#include "formats/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/text.h"
#include "formats/csc473.h"

namespace glint {
namespace {

constexpr Format k_formats[] = {
    {{"cgfs", ".cgfs", "cgfs", "the listings of \"Computer Graphics from Scratch\""},
     set_cgfs_defaults,
     read_cgfs},
    {{"epfl", ".json .js", "epfl", "RT2's scenes, as JSON or as the homework's JavaScript"},
     set_epfl_defaults,
     read_epfl},
    {{"csc473", ".pov", "csc473", "the scenes of CSC 473, a part of POV-Ray's language"},
     set_csc473_defaults,
     read_csc473},
    {{"povray", ".pov", "povray", "POV-Ray's language, as exported by chemists' and engineers' programs",
      true},
     set_povray_defaults,
     read_povray},
    {{"nff", ".nff", "nff", "the Neutral File Format of the Standard Procedural Databases"},
     set_nff_defaults,
     read_nff},
    {{"tachyon", ".dat", "tachyon", "the scenes of the ray tracer Tachyon, as VMD and Sage write them", true},
     set_tachyon_defaults,
     read_tachyon,
     finish_tachyon},
    {{"ply", ".ply", "glint", "Stanford's polygon files, a mesh of triangles"},
     set_mesh_defaults,
     read_ply,
     finish_mesh,
     read_ply_mesh},
    {{"stl", ".stl", "glint", "the triangles of 3D printing and CAD programs, as text or binary"},
     set_mesh_defaults,
     read_stl,
     finish_mesh,
     read_stl_mesh},
    {{"obj", ".obj", "glint", "Wavefront's meshes, with the materials of .mtl files"},
     set_mesh_defaults,
     read_obj,
     finish_mesh,
     read_obj_mesh},
    {{"gltf", ".gltf .glb", "glint", "glTF 2.0, as text with its buffers or in one binary file"},
     set_gltf_defaults,
     read_gltf,
     finish_mesh},
    {{"glint", ".glint", "glint", "glint's own scene language"},
     set_glint_defaults,
     read_glint,
     finish_glint},
};

constexpr auto k_infos = [] {
    std::array<FormatInfo, std::size(k_formats)> infos;
    for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = k_formats[i].info;
    return infos;
}();

bool equal_without_case(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (lower(a[i]) != lower(b[i])) return false;
    }
    return true;
}

bool has_extension(std::string_view name, std::string_view extensions) {
    while (!extensions.empty()) {
        const auto extension = extensions.substr(0, extensions.find(' '));
        if (name.size() > extension.size() &&
            equal_without_case(name.substr(name.size() - extension.size()), extension)) {
            return true;
        }
        extensions.remove_prefix(std::min(extension.size() + 1, extensions.size()));
    }
    return false;
}

// The different entries of a column.
std::string known(std::string_view FormatInfo::*column) {
    std::vector<std::string_view> entries;
    for (const FormatInfo& info : k_infos) {
        if (std::find(entries.begin(), entries.end(), info.*column) == entries.end())
            entries.push_back(info.*column);
    }
    return fmt::format("{}", fmt::join(entries, ", "));
}

}  // namespace

std::span<const Format> all_formats() { return k_formats; }

bool is_scene_name(std::string_view name) {
    return has_extension(name, ".inc .mtl") ||
           std::any_of(std::begin(k_formats), std::end(k_formats),
                       [&](const Format& f) { return has_extension(name, f.info.extensions); });
}

std::span<const FormatInfo> formats() { return k_infos; }

const Format* find_format(const SceneText& text, std::string& why) {
    for (const Format& f : k_formats) {
        const bool is_it =
            text.format.empty() ? has_extension(text.name, f.info.extensions) : text.format == f.info.name;
        if (!is_it) continue;
        // A .pov is of CSC 473 only if its whole text is.
        const bool is_read = text.format.empty() && f.read == read_csc473 && !text.text.empty();
        if (is_read && first_csc473_error(text)) continue;
        return &f;
    }
    if (text.format.empty()) {
        why = fmt::format("expected a name that ends in one of {}, or the name of a format ({})",
                          known(&FormatInfo::extensions), known(&FormatInfo::name));
    } else {
        why = fmt::format("expected one of the formats {}, found {}", known(&FormatInfo::name),
                          quoted(text.format));
    }
    return nullptr;
}

FormatChoice choose_format(const SceneText& text) {
    FormatChoice choice;
    const Format* format = find_format(text, choice.reason);
    if (format == nullptr) return choice;
    choice.format = format->info.name;
    choice.reason = text.format.empty() ? "by the name of the file" : "as chosen";
    if (!text.format.empty() || !has_extension(text.name, ".pov")) return choice;
    if (const auto error = first_csc473_error(text)) {
        choice.reason = fmt::format("not csc473: {}:{}: {}", error->line, error->column, error->message);
    } else {
        choice.reason =
            "the whole text is in CSC 473's part of POV-Ray's language; `--format povray` reads it as "
            "POV-Ray does";
    }
    return choice;
}

}  // namespace glint
