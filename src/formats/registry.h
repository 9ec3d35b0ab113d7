// SPDX-License-Identifier: Apache-2.0
#pragma once
// The formats. A new format adds its file, and its row in registry.cpp.
#include <span>

#include "formats/load_state.h"
#include "formats/mesh_file.h"

namespace glint {

struct Format {
    FormatInfo info;
    /// Sets the defaults of a scene in this format (camera, background); called for the first
    /// text.
    void (*set_defaults)(Scene&);
    void (*read)(LoadState&, const ReadText&);
    /// Completes the scene after the last text of a load; or null.
    void (*finish)(LoadState&) = nullptr;
    /// The text as one mesh, for shapes that name its file; or null.
    MeshReader read_mesh = nullptr;
};

std::span<const Format> all_formats();

/// The format by the text's `format`, or by the extension of its name. Null and the reason if there is none.
const Format* find_format(const SceneText& text, std::string& why);

/// Whether a file has the name of a scene, of POV-Ray's includes or of an .obj's materials. Messages quote no
/// lines of other files that a scene includes, which may be anybody's.
bool is_scene_name(std::string_view name);

void set_cgfs_defaults(Scene& scene);
void read_cgfs(LoadState& reading, const ReadText& text);

void set_epfl_defaults(Scene& scene);
void read_epfl(LoadState& reading, const ReadText& text);

void set_csc473_defaults(Scene& scene);
void read_csc473(LoadState& reading, const ReadText& text);

void set_povray_defaults(Scene& scene);
void read_povray(LoadState& reading, const ReadText& text);

void set_nff_defaults(Scene& scene);
void read_nff(LoadState& reading, const ReadText& text);

void set_tachyon_defaults(Scene& scene);
void read_tachyon(LoadState& reading, const ReadText& text);
void finish_tachyon(LoadState& reading);

void set_mesh_defaults(Scene& scene);
void read_ply(LoadState& reading, const ReadText& text);
void read_stl(LoadState& reading, const ReadText& text);
void read_obj(LoadState& reading, const ReadText& text);
void finish_mesh(LoadState& reading);

void set_gltf_defaults(Scene& scene);
void read_gltf(LoadState& reading, const ReadText& text);

void set_glint_defaults(Scene& scene);
void read_glint(LoadState& reading, const ReadText& text);
void finish_glint(LoadState& reading);

}  // namespace glint
