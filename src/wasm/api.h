// SPDX-License-Identifier: Apache-2.0
#pragma once
// The browser's API: glint as a few C functions over one linear memory. Strings are UTF-8 with a final zero;
// what a function returns stays valid until the next call with the same scene. Nothing here needs exceptions,
// files or threads.
#include <cstdint>

#if defined(__wasm__)
#define GLINT_WASM_EXPORT(name) __attribute__((export_name(#name))) name
#else
#define GLINT_WASM_EXPORT(name) name
#endif

extern "C" {

struct GlintScene;

/// Memory for the caller to write a request into; null if there is none left.
char* GLINT_WASM_EXPORT(glint_allocate)(std::uint32_t bytes);
void GLINT_WASM_EXPORT(glint_free)(char* memory);

/// Reads and prepares a scene. The request is JSON: {"texts": [{"name": "a.cgfs", "text": "...", "format":
/// "cgfs"}], "profile": "cgfs", "scene": "name", "settings": {"size": "640x480"}, "includes": [{"name",
/// "text"}]}; all but texts with name and text may be left out. includes are what `include` may find, by
/// name: the path that the including text gives, from the folder of its own name. Never null: glint_report
/// says what went wrong. To be closed by glint_close.
GlintScene* GLINT_WASM_EXPORT(glint_open)(const char* request, std::uint32_t length);
void GLINT_WASM_EXPORT(glint_close)(GlintScene* scene);

/// Prepares the scene to be drawn otherwise than it says. The request is JSON: {"settings": {"size":
/// "64x48"}, "camera": {"position": [x, y, z], "right", "up", "forward"}}, where the camera, if given, is
/// orthographic: right and up are as long as the picture is wide and high in world units. What a request
/// leaves out is as the scene was opened. 0 if that cannot be: glint_report's "error" says why, and nothing
/// can be drawn until a request succeeds.
std::int32_t GLINT_WASM_EXPORT(glint_prepare)(GlintScene* scene, const char* request, std::uint32_t length);

/// What became of the text, as JSON: {"ready": true, "width": 640, "height": 480, "diagnostics":
/// [{"severity", "file", "line", "column", "length", "message", "text"}]}; lines and columns as in
/// Diagnostic, text as to_string() makes it. A note is a "warning" here.
const char* GLINT_WASM_EXPORT(glint_report)(const GlintScene* scene);

/// What is in the scene, as JSON (glint.d.mts, SceneInfo): size, counts, bounds, camera, lights, and every
/// setting with its value and where that is from. "null" if the scene is not ready.
const char* GLINT_WASM_EXPORT(glint_info)(GlintScene* scene);

/// Draws width x height pixels from (x, y) at the picture's top-left: 3 width height linear floats, row by
/// row. Null if the scene is not ready or the rectangle is not inside the picture; glint_report's "error"
/// then says why.
const float* GLINT_WASM_EXPORT(glint_render)(GlintScene* scene, std::int32_t x, std::int32_t y,
                                             std::int32_t width, std::int32_t height);

/// Of what glint_render drew last: red, green, blue and 255 for each pixel, as a PNG of it has them; null if
/// nothing was drawn.
const std::uint8_t* GLINT_WASM_EXPORT(glint_pixels)(GlintScene* scene);
/// And how many rays it took.
double GLINT_WASM_EXPORT(glint_rays)(const GlintScene* scene);

/// Why pixel (x, y) is as it is: explanation_json() (glint/explain.h). "null" if the scene is not ready.
const char* GLINT_WASM_EXPORT(glint_explain)(GlintScene* scene, std::int32_t x, std::int32_t y);

/// The scene in glint's own language, with its settings as they are in force; empty if it is not ready.
const char* GLINT_WASM_EXPORT(glint_convert)(GlintScene* scene);

/// The version, as "0.2.0".
const char* GLINT_WASM_EXPORT(glint_version)();

}  // extern "C"
