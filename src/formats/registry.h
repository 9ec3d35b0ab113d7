#pragma once
// The formats: a new one adds its file and its row in registry.cpp.
#include <span>

#include "formats/reading.h"

namespace glint {

struct Format {
    FormatInfo info;
    /// Sets what a scene of this format has without saying so (camera, background); called for the first
    /// text.
    void (*set_defaults)(Scene&);
    void (*read)(Reading&, const ReadText&);
};

std::span<const Format> all_formats();

/// By the text's `format`, or else by the extension of its name. Null, and why, if there is none.
const Format* find_format(const SceneText& text, std::string& why);

void set_cgfs_defaults(Scene& scene);
void read_cgfs(Reading& reading, const ReadText& text);

void set_epfl_defaults(Scene& scene);
void read_epfl(Reading& reading, const ReadText& text);

void set_csc473_defaults(Scene& scene);
void read_csc473(Reading& reading, const ReadText& text);

void set_nff_defaults(Scene& scene);
void read_nff(Reading& reading, const ReadText& text);

}  // namespace glint
