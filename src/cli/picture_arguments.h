// SPDX-License-Identifier: Apache-2.0
#pragma once
// The options of rendering that several commands share.
#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/scene_arguments.h"

namespace glint::cli {

struct PictureArguments {
    std::string size, shading, reflections, aa, seed;
    bool no_shadows = false, alpha = false;
};

/// Adds --size, --shading, --no-shadows, --reflections, --aa and --seed.
void add_picture_arguments(CLI::App& command, PictureArguments& arguments);
/// Adds --alpha.
void add_alpha_argument(CLI::App& command, PictureArguments& arguments);

/// What of a picture is in memory: some of its pixels, rows of it, or all.
enum class PictureMemory { some, rows, whole };

/// Adds the arguments to the settings that load_scene applies. Checks first that there is enough memory for
/// a picture of that size, so that the message for a huge size names the memory needed. A picture of rows
/// needs that memory only beyond the largest size.
void add_settings(const PictureArguments& arguments, PictureMemory memory, SceneArguments& scene);

/// How the picture's numbers are written to a file.
struct NumberArguments {
    std::string transfer = {};  ///< empty: the scene's
    int bits = 8;
    std::optional<FileFormat> format = {};  ///< empty: by the output's name
    int jpeg_quality = 95;
};

/// Adds --transfer and --bits.
void add_number_arguments(CLI::App& command, NumberArguments& arguments);

/// Adds --threads, 0 to 1024. `rest` continues its description: ". The picture does not depend on it".
void add_threads_argument(CLI::App& command, int& threads, const std::string& rest = {});

/// The same as options of encode(). rule: the scene's.
EncodeOptions encoding_of(const NumberArguments& arguments, const ByteRule& rule);

/// Throws Failure if this machine has too little memory for a picture. bytes: per pixel; a picture without
/// layers has three floats.
void check_memory(double width, double height, double bytes = 12);

/// Throws a usage error if this machine does not have the instruction set.
void check_isa(const std::string& isa);

}  // namespace glint::cli
