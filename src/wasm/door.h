#pragma once
// The browser's door: glint as a few C functions over one linear memory. Strings are UTF-8; what a function
// returns stays valid until the next call with the same scene. Nothing here needs exceptions, files or
// threads.
#include <cstdint>

#if defined(__wasm__)
#define GLINT_DOOR(name) __attribute__((export_name(#name))) name
#else
#define GLINT_DOOR(name) name
#endif

extern "C" {

struct GlintScene;

/// Memory for the caller to write a request into; null if there is none left.
char* GLINT_DOOR(glint_allocate)(std::uint32_t bytes);
void GLINT_DOOR(glint_free)(char* memory);

/// Reads and prepares a scene. The request is JSON: {"texts": [{"name": "a.cgfs", "text": "...", "format":
/// "cgfs"}], "profile": "cgfs", "scene": "name", "settings": {"size": "640x480"}, "includes": [{"name",
/// "text"}]}; all but texts with name and text may be left out. includes are what `include` may find, by
/// name: the path that the including text gives, from the folder of its own name. Never null: glint_report
/// says what went wrong. To be closed by glint_close.
GlintScene* GLINT_DOOR(glint_open)(const char* request, std::uint32_t length);
void GLINT_DOOR(glint_close)(GlintScene* scene);

/// What is known of the scene, as JSON text with a final zero: {"ready": true, "width": 640, "height": 480,
/// "diagnostics": [{"severity", "file", "line", "column", "length", "message", "text"}]}; lines and columns
/// as in Diagnostic, text as to_string() makes it.
const char* GLINT_DOOR(glint_report)(const GlintScene* scene);

/// Draws width x height pixels from (x, y) at the picture's top-left: 3 width height linear floats, row by
/// row. Null if the scene is not ready or the rectangle is not inside the picture; glint_report's "error"
/// then says why.
const float* GLINT_DOOR(glint_render)(GlintScene* scene, std::int32_t x, std::int32_t y, std::int32_t width,
                                      std::int32_t height);

/// The version, "0.1.0".
const char* GLINT_DOOR(glint_version)();

}  // extern "C"
