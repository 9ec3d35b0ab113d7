// SPDX-License-Identifier: Apache-2.0
#pragma once
// The options that say how a scene is drawn, whatever is done with the picture.
#include <CLI/CLI.hpp>
#include <string>

#include "cli/scene_arguments.h"

namespace glint::cli {

struct PictureArguments {
    std::string size, shading, reflections, aa;
    bool no_shadows = false;
};

/// Adds --size, --shading, --no-shadows, --reflections and --aa.
void add_picture_arguments(CLI::App& command, PictureArguments& arguments);

/// Adds what the arguments say to the settings that load_scene applies. Checks the memory that a picture of
/// that size needs first: a size too large for any picture is answered by what it would need. is_whole: the
/// whole picture is kept.
void add_settings(const PictureArguments& arguments, bool is_whole, SceneArguments& scene);

/// What becomes of the picture's numbers in a file.
struct NumberArguments {
    std::string transfer = "none";
    int bits = 8;
};

/// Adds --transfer and --bits.
void add_number_arguments(CLI::App& command, NumberArguments& arguments);

/// Adds --threads, 0 to 1024. `rest` goes on with its description: ". The picture is the same".
void add_threads_argument(CLI::App& command, int& threads, const std::string& rest = {});

/// As encode() takes them.
EncodeOptions encoding_of(const NumberArguments& arguments);

/// Throws Failure if this machine has not the memory for a picture. bytes: a pixel; a picture alone has three
/// floats.
void check_memory(double width, double height, double bytes = 12);

/// Throws Failure of usage if this machine has no such instruction set.
void check_isa(const std::string& isa);

}  // namespace glint::cli
