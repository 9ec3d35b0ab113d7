// SPDX-License-Identifier: Apache-2.0
// The texts of glint-tachyon and glint-povray: one table gives their help, manual pages and completions.
#include <fmt/format.h>

#include "cli/drop_in.h"

namespace glint::cli {
namespace {

constexpr DropInOption k_tachyon_options[] = {
    {"-o FILE", "The picture; default: outfile.tga, or the ending of -format"},
    {"-format NAME", "TARGA (default, whatever the file's name), PNG, PPM, PPM48, BMP or JPEG",
     "TARGA PNG PPM PPM48 BMP JPEG"},
    {"-res X Y", "The size in pixels; default: the scene's Resolution"},
    {"-aasamples N", "N samples besides the first, as a regular grid of at least as many"},
    {"-numthreads N", "Threads; default: one per processor"},
    {"-raydepth N", "Generations of rays, the camera's included"},
    {"-fullshade, -mediumshade, -lowshade, -lowestshade", "Replace the scene's Shader_Mode"},
    {"-shade_blinn, -shade_phong, -shade_nullphong, -shade_blinn_fast",
     "The highlight; the last is drawn as the first"},
    {"-trans_orig, -trans_vmd, -trans_raster3d", "How a transparent surface and what is behind it are mixed"},
    {"-trans_max_surfaces N", "Transparent surfaces along a ray that are drawn"},
    {"-shadow_filter_on, -shadow_filter_off",
     "Transparent surfaces reduce the light that passes them, or do not"},
    {"-fog_normal, -fog_radial, -fog_vmd", "Fog by the distance along the ray, or by the depth"},
    {"-rescale_lights S", "Multiply the lights by S, if it is below 1"},
    {"-add_skylight S", "Light from the sky"},
    {"-auto_skylight S", "Light from the sky, and the lights multiplied by 1 - S"},
    {"-skylight_samples N", "Rays to the sky from each point; default: 128"},
    {"-nosave", "Render, and write nothing"},
    {"--skip-unsupported", "Leave out what glint cannot draw; the last line says how much"},
    {"-clamp, -nobounding, -boundthresh N, +V, -V", "Accepted; they have no effect on the picture"},
    {"-normalize, -gamma N, -cropoutput W H X Y, -cropoutputauto, -crop X Y W H, -camfile FILE, -normalfixup "
     "MODE, -spaceball, -spaceballport PORT",
     "Accepted with a warning, and not done"},
    {"-help", "Print this help"},
    {"-version", "Print the version"},
};

constexpr DropInOption k_povray_options[] = {
    {"+I[FILE]", "The scene; a FILE without + is one, too"},
    {"+O[FILE]",
     "The picture, whose type's ending is added if it is missing, a folder/, or - (standard output); "
     "default: "
     "beside the scene"},
    {"+W[N], +H[N]", "The size in pixels; default: 320 by 240"},
    {"+FN[8|16], +FT, +FP[8|16], +FE, +FJ, +FB",
     "The file type: PNG (default), TGA, PPM, OpenEXR, JPEG, BMP"},
    {"-F", "Render, and write nothing"},
    {"+A[N], -A", "Anti-aliasing where neighbours differ by N (0.3), or none (default)"},
    {"+R[N]", "The samples of such a pixel, along a side; default: 3"},
    {"+Q[N]", "Quality: 0 and 1 are colors only, 2 and 3 have no shadows, to 11 everything"},
    {"+WT[N]", "Threads; default: one per processor"},
    {"+UA", "Write an alpha channel"},
    {"+L[FOLDER]", "A folder of scenes and included files"},
    {"+K[N]", "The scene's clock"},
    {"+KFI[N], +KFF[N], +KI[N], +KF[N], +KC, +SF[N], +EF[N]",
     "An animation: its first and last frame, the clock of these, a cycle, and the frames to render"},
    {"+SC[N], +EC[N], +SR[N], +ER[N]",
     "The first and last column and row to render, as numbers from 1 or fractions; the rest is black"},
    {"--skip-unsupported", "Leave out what glint cannot draw; the last line says how much, but not with -V"},
    {"-V", "Print only errors"},
    {"-D, -P, -C, -J, +X, +AM[N], +MB[N]",
     "Accepted, as others of display, pause and method; no effect on the picture"},
    {"FILE.ini, FILE.ini[SECTION]", "Options from a file"},
    {"KEY=VALUE", "An option by its name in .ini files, as Width=800; also Declare=NAME=NUMBER"},
    {"--help", "Print this help"},
    {"--version", "Print the version"},
};

}  // namespace

const DropInProgram k_tachyon_program{
    "glint-tachyon",
    "Render Tachyon's scenes (.dat) with glint; take Tachyon's flags",
    "MODEL.dat [FLAGS]",
    k_tachyon_options,
    "",
    "glint-tachyon vmdscene.dat -aasamples 12 -format TARGA -o vmdscene.tga\n"
    "glint-tachyon scene.dat -res 800 600 -format PNG -o scene.png\n",
    "dat",
    255,
    tachyon_drop_in,
    "tachyon",
    "Aborting render."};

const DropInProgram k_povray_program{
    "glint-povray",
    "Render scenes in POV-Ray's language with glint; take POV-Ray's options",
    "[+Iscene.pov | scene.pov] [OPTIONS] [FILE.ini[SECTION]] [KEY=VALUE ...]",
    k_povray_options,
    "Options are read from povray.ini (the variable POVINI names it; this folder, ~/.povray/3.7, "
    "/etc/povray/3.7) "
    "first, as povray reads them.",
    "glint-povray +Iscene.pov +Oscene.png +W800 +H600 +A0.3 -D\n"
    "glint-povray water.ini\n",
    "pov ini",
    1,
    povray_drop_in,
    {},
    {}};

std::array<const DropInProgram*, 2> drop_in_programs() { return {&k_povray_program, &k_tachyon_program}; }

const DropInProgram* find_drop_in(std::string_view name) {
    for (const DropInProgram* program : drop_in_programs()) {
        if (program->name == name || program->name.substr(program->name.find('-') + 1) == name)
            return program;
    }
    return nullptr;
}

std::string drop_in_help(const DropInProgram& program) {
    constexpr std::size_t column = 30;
    std::string text = fmt::format("{}\n\nUsage: {} {}\n\n", program.purpose, program.name, program.usage);
    for (const DropInOption& option : program.options) {
        const std::string start = fmt::format("  {}", option.names);
        text += start.size() < column - 1 ? fmt::format("{:<{}}", start, column)
                                          : fmt::format("{}\n{:<{}}", start, "", column);
        text += fmt::format("{}\n", option.text);
    }
    if (!program.notes.empty()) text += fmt::format("\n{}\n", program.notes);
    text += fmt::format("\nExit codes: 0: done; {}: {}.\n\nExamples:\n", program.failure, k_drop_in_failure);
    for (std::string_view rest = program.examples; !rest.empty();) {
        const std::size_t end = rest.find('\n');
        text += fmt::format("  {}\n", rest.substr(0, end));
        rest.remove_prefix(end + 1);
    }
    return text;
}

}  // namespace glint::cli
