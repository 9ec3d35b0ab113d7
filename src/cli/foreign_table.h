// SPDX-License-Identifier: Apache-2.0
#pragma once
// The flags of other renderers, for glint's answers to them and for glint-povray and glint-tachyon.
#include <cstdint>
#include <span>
#include <string_view>

namespace glint::cli {

/// How a flag's value is translated. The last ones have a meaning for glint-tachyon only; for answers they
/// are none, or same (depth).
enum class ForeignValue : std::uint8_t {
    none,   ///< no value, or glint does not use it
    same,   ///< unchanged, after glint's option
    size,   ///< two values: WxH
    width,  ///< combined with the height of another flag
    height,
    samples,          ///< samples per pixel; glint counts them along a side
    samples_besides,  ///< the same, in addition to the first one
    scene,            ///< an argument without an option
    unused,           ///< has no effect on the picture
    nearest,          ///< glint's option is only similar
    depth,            ///< the generations of rays, the camera's included
    gamma,
    file_type,
    light_scale,
    sky_instead,  ///< light from the sky, by which the lights are reduced
    sky_besides,
    sky_samples,
};

struct ForeignFlag {
    std::string_view flag;
    int values;             ///< how many arguments it takes
    std::string_view ours;  ///< an option, or a sentence if it does not begin with -
    ForeignValue value = ForeignValue::none;
    std::string_view mode = {};  ///< Tachyon: the word in Shader_Mode ... End_Shader_Mode
};

/// The flag of this name, or null. only_tachyon: among Tachyon's.
const ForeignFlag* find_foreign_flag(std::string_view word, bool only_tachyon = false);
std::span<const ForeignFlag> tachyon_flags();

/// What POV-Ray's switches and keys of .ini files set.
enum class PovrayKey : std::uint8_t {
    width,
    height,
    input,
    output,
    file_type,
    bits,
    threads,
    antialias,
    antialias_threshold,
    antialias_depth,
    sampling_method,
    jitter,
    display,
    quality,
    first_column,
    last_column,
    first_row,
    last_row,
    verbose,
    warning_level,
    console,
    library,
    clock,
    first_frame,
    last_frame,
    first_clock,
    last_clock,
    cycle,
    subset_first_frame,
    subset_last_frame,
    frame_step,
    fields,
    compression,
    alpha,
    declare,
    file_gamma,
    header,
    other_picture,  ///< another picture, which glint does not make
    unused,         ///< has no effect on the picture
};

struct PovraySwitch {
    std::string_view letters;  ///< after + or -; empty: only a key
    std::string_view key;      ///< in .ini files: "Width"
    PovrayKey id;
};

/// The switch that `letters` begins with, as in "W640", or null. Case does not matter.
const PovraySwitch* find_povray_switch(std::string_view letters);
/// The key of an .ini file, or null. Case does not matter.
const PovraySwitch* find_povray_key(std::string_view key);

}  // namespace glint::cli
