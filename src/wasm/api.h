// SPDX-License-Identifier: Apache-2.0
#pragma once
// The browser's API: C functions over one linear memory. Strings are UTF-8 with a final zero. A returned
// value stays valid until the next call with the same scene. The API needs no exceptions, files or
// threads.
#include <cstdint>

#if defined(__wasm__)
#define GLINT_WASM_EXPORT(name) __attribute__((export_name(#name))) name
#define GLINT_WASM_IMPORT(from_host, name) \
    __attribute__((import_module("glint"), import_name(#from_host))) name
#else
#define GLINT_WASM_EXPORT(name) name
#define GLINT_WASM_IMPORT(from_host, name) name
#endif

extern "C" {

struct GlintScene;

/// Memory for a request; null if there is not enough.
char* GLINT_WASM_EXPORT(glint_allocate)(std::uint32_t bytes);
void GLINT_WASM_EXPORT(glint_free)(char* memory);

/// Of the host: called by glint_open with the part of it that is done, from 0 to 1.
void GLINT_WASM_IMPORT(progress, glint_progress)(double done);

/// Reads and prepares a scene. The request is JSON: {"texts": [{"name": "a.cgfs", "text": "...", "format":
/// "cgfs"}], "profile": "cgfs", "scene": "name", "settings": {"size": "640x480"}, "includes": [{"name",
/// "text"}], "maxMemory": bytes}; only texts with name and text are required. includes are the texts that
/// `include` may find, by name: the path in the including text, relative to the folder of its own name. Never
/// null; glint_report describes errors. Must be closed by glint_close.
GlintScene* GLINT_WASM_EXPORT(glint_open)(const char* request, std::uint32_t length);
void GLINT_WASM_EXPORT(glint_close)(GlintScene* scene);

/// Prepares the scene with changes. The request is JSON: {"settings": {"size":
/// "64x48"}, "camera": {"position": [x, y, z], "right", "up", "forward"}}. The camera, if given, is
/// orthographic: right and up have the picture's width and height in world units. Everything that a request
/// omits is as opened. Returns 0 on failure: "error" of glint_report then gives the reason, and the scene
/// stays as it was.
std::int32_t GLINT_WASM_EXPORT(glint_prepare)(GlintScene* scene, const char* request, std::uint32_t length);

/// The result of reading, as JSON: {"ready": true, "width": 640, "height": 480, "diagnostics":
/// [{"severity", "file", "line", "column", "length", "message", "can_skip", "text"}]}; lines and columns as
/// in Diagnostic, text as from to_string(). A note is reported as a "warning". Width and height are those of
/// the last glint_prepare; "missing" lists the included texts that the request does not have; "error" is
/// there if the last open, prepare or render failed.
const char* GLINT_WASM_EXPORT(glint_report)(const GlintScene* scene);

/// The scene's contents as JSON (glint.d.mts, SceneInfo): size, counts, bounds, camera, lights, and every
/// setting with its value and the origin of the value. "null" if the scene is not ready.
const char* GLINT_WASM_EXPORT(glint_info)(GlintScene* scene);

/// Renders width x height pixels from (x, y) at the picture's top left: 3 width height linear floats, row by
/// row. Null if the scene is not ready or the rectangle is not inside the picture; "error" of glint_report
/// then gives the reason.
const float* GLINT_WASM_EXPORT(glint_render)(GlintScene* scene, std::int32_t x, std::int32_t y,
                                             std::int32_t width, std::int32_t height);

/// The last pixels of glint_render as bytes: red, green, blue and 255 for each pixel, the same as in a PNG.
/// Null if nothing was rendered.
const std::uint8_t* GLINT_WASM_EXPORT(glint_pixels)(GlintScene* scene);
/// The same rectangle, and layers of it (glint/layers.h): `names` separated by spaces, such as "albedo
/// light:2". Returns 0 where glint_render fails, and for names that are unknown or repeated.
std::int32_t GLINT_WASM_EXPORT(glint_render_layers)(GlintScene* scene, const char* names,
                                                    std::uint32_t length, std::int32_t x, std::int32_t y,
                                                    std::int32_t width, std::int32_t height);
/// A layer of the last glint_render_layers by its index among the names: glint_layer_channels floats for each
/// pixel, row by row. Null and 0 if there is none.
const float* GLINT_WASM_EXPORT(glint_layer)(const GlintScene* scene, std::uint32_t index);
std::int32_t GLINT_WASM_EXPORT(glint_layer_channels)(const GlintScene* scene, std::uint32_t index);
/// The number of rays of the last glint_render.
double GLINT_WASM_EXPORT(glint_rays)(const GlintScene* scene);

/// The explanation of pixel (x, y): explanation_json() (glint/explain.h). "null" if the scene is not ready.
const char* GLINT_WASM_EXPORT(glint_explain)(GlintScene* scene, std::int32_t x, std::int32_t y);

/// The scene as .glint, with its settings in force; empty if it is not ready.
const char* GLINT_WASM_EXPORT(glint_convert)(GlintScene* scene);

/// How the picture of a scene differs from that of a reference, as JSON (glint.d.mts, Comparison); both are
/// rendered as they are prepared. with_causes other than 0: also the causes, found by rendering the
/// reference with each fault, which takes as long as some hundred pictures. {"error"} if it is impossible.
const char* GLINT_WASM_EXPORT(glint_compare)(GlintScene* scene, GlintScene* reference,
                                             std::int32_t with_causes);

/// The same of a picture that another program has drawn of the scene: width x height pixels, each with the
/// bytes red, green, blue and alpha (which is not compared), row by row from the top.
const char* GLINT_WASM_EXPORT(glint_compare_picture)(GlintScene* scene, const char* rgba, std::int32_t width,
                                                     std::int32_t height, std::int32_t with_causes);

/// The scene's likely mistakes as a JSON array (glint.d.mts, Finding); empty if the scene is not ready.
const char* GLINT_WASM_EXPORT(glint_check)(GlintScene* scene);

/// Compares the log of another ray tracer with the scene as it is prepared (glint/diagnose.h). `name` is that
/// of the log in messages. JSON: {"diagnosis": diagnosis_json() or null, "diagnostics": [...], "error":
/// "..."}; an error is there only if the diagnosis is null.
const char* GLINT_WASM_EXPORT(glint_diagnose)(GlintScene* scene, const char* log, std::uint32_t length,
                                              const char* name, std::uint32_t name_length);

/// Only in glint-core.wasm: 1 once a call has needed what that file leaves out (left_out.cpp). The results
/// of that call are not those of glint.wasm.
std::int32_t GLINT_WASM_EXPORT(glint_left_out)();

/// The version, such as "0.3.0".
const char* GLINT_WASM_EXPORT(glint_version)();

}  // extern "C"
