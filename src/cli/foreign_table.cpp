// SPDX-License-Identifier: Apache-2.0
#include "cli/foreign_table.h"

#include <algorithm>
#include <cctype>

namespace glint::cli {
namespace {

using Value = ForeignValue;

constexpr ForeignFlag k_tachyon[] = {
    {"-res", 2, "--size", Value::size},
    {"-numthreads", 1, "--threads", Value::same},
    {"-aasamples", 1, "--aa", Value::samples_besides},
    {"-format", 1,
     "OUT's extension chooses the file type: .png .ppm .tga .bmp .jpg .exr; --bits 16 writes 16 bits",
     Value::file_type},
    {"-fullshade", 0, "shadows and mirrors are glint's default; leave it out", Value::none, "Full"},
    {"-mediumshade", 0, "--no-shadows", Value::none, "Medium"},
    {"-lowshade", 0, "--no-shadows --reflections 0", Value::none, "Low"},
    {"-lowestshade", 0, "--shading color", Value::none, "Lowest"},
    {"-shade_phong", 0, "--shading phong"},
    {"-shade_blinn", 0, "--shading blinn-phong"},
    {"-shade_blinn_fast", 0, "--shading blinn-phong", Value::nearest},
    {"-shade_nullphong", 0, "--shading diffuse"},
    {"-raydepth", 1, "--reflections", Value::depth},
    {"-verbose", 0, "--stats FILE.json writes figures", Value::unused},
    {"-nosave", 0, "--output /dev/null"},
    {"-gamma", 1, "--transfer srgb", Value::gamma},
    {"-crop", 4, "--crop WxH+X+Y renders a part of the picture"},
    {"-cropoutput", 4, "--crop WxH+X+Y renders a part of the picture"},
    {"-cropoutputauto", 0, "--crop WxH+X+Y renders a part of the picture"},
    {"-spaceball", 0, "glint renders one picture of a scene"},
    {"-spaceballport", 1, "glint renders one picture of a scene"},
    {"-clamp", 0, "glint clamps colors; leave it out", Value::unused},
    {"-nobounding", 0, "glint does not need it; leave it out", Value::unused},
    {"-boundthresh", 1, "glint does not need it; leave it out", Value::unused},
    {"-normalize", 0, "glint does not scale colors; an .exr picture keeps their full range"},
    {"-rescale_lights", 1, "glint uses the lights as they are in the scene", Value::light_scale},
    {"-auto_skylight", 1, "glint-tachyon takes it: light from all directions", Value::sky_instead},
    {"-add_skylight", 1, "glint-tachyon takes it: light from all directions", Value::sky_besides},
    {"-skylight_samples", 1, "glint-tachyon takes it: light from all directions", Value::sky_samples},
    {"-camfile", 1, "glint renders one picture of a scene"},
    {"-trans_max_surfaces", 1, "glint-tachyon takes it", Value::none, "Trans_Max_Surfaces"},
    {"-trans_orig", 0, "see --convention in 'glint render --help'", Value::none, "Trans_Orig"},
    {"-trans_raster3d", 0, "see --convention in 'glint render --help'", Value::none, "Trans_Raster3D"},
    {"-trans_vmd", 0, "see --convention in 'glint render --help'", Value::none, "Trans_VMD"},
    {"-shadow_filter_on", 0, "--convention glass_shadow=opaque", Value::none, "Shadow_Filter_On"},
    {"-shadow_filter_off", 0, "--convention glass_shadow=none", Value::none, "Shadow_Filter_Off"},
    {"-fog_radial", 0, "--convention fog_distance=ray", Value::none, "Fog_Radial"},
    {"-fog_normal", 0, "--convention fog_distance=ray", Value::none,
     "Fog_Radial"},  // Tachyon's help says radial
    {"-fog_vmd", 0, "--convention fog_distance=depth", Value::none, "Fog_VMD"},
    {"-normalfixup", 1, "with --convention facing=all glint turns all normals to the viewer"},
};

// pbrt, Mitsuba, Yocto/GL, Blender and programs of courses
constexpr ForeignFlag k_others[] = {
    {"-i", 1, "SCENE", Value::scene},
    {"--input", 1, "SCENE", Value::scene},
    {"--scene-file", 1, "SCENE", Value::scene},
    {"--out", 1, "--output", Value::same},
    {"--outfile", 1, "--output", Value::same},
    {"--output-file", 1, "--output", Value::same},
    {"-w", 1, "", Value::width},
    {"--width", 1, "", Value::width},
    {"--height", 1, "", Value::height},
    {"--res", 1, "--size", Value::same},
    {"--resolution", 1, "--size", Value::same},
    {"--samples", 1, "--aa", Value::samples},
    {"--spp", 1, "--aa", Value::samples},
    {"--pixelsamples", 1, "--aa", Value::samples},
    {"--antialias", 1, "--aa", Value::same},
    {"-j", 1, "--threads", Value::same},
    {"--jobs", 1, "--threads", Value::same},
    {"--nthreads", 1, "--threads", Value::same},
    {"--num-threads", 1, "--threads", Value::same},
    {"--depth", 1, "--reflections", Value::same},
    {"--max-depth", 1, "--reflections", Value::same},
    {"--bounces", 1, "--reflections", Value::same},
    {"--gamma", 1, "--transfer srgb"},
    {"--preview", 0, "--show"},
    {"-v", 0, "glint shows its progress on a terminal; --stats FILE.json writes figures"},
    {"--verbose", 0, "glint shows its progress on a terminal; --stats FILE.json writes figures"},
    {"--silent", 0, "--quiet"},
};

// Longer switches before those that they begin with.
constexpr PovraySwitch k_povray[] = {
    {"WT", "Work_Threads", PovrayKey::threads},
    {"WL", "Warning_Level", PovrayKey::warning_level},
    {"W", "Width", PovrayKey::width},
    {"HI", "Include_Header", PovrayKey::header},
    {"H", "Height", PovrayKey::height},
    {"I", "Input_File_Name", PovrayKey::input},
    {"O", "Output_File_Name", PovrayKey::output},
    {"AM", "Sampling_Method", PovrayKey::sampling_method},
    {"AG", "Antialias_Gamma", PovrayKey::unused},
    {"A", "Antialias", PovrayKey::antialias},
    {"RP", "Render_Pattern", PovrayKey::unused},
    {"R", "Antialias_Depth", PovrayKey::antialias_depth},
    {"J", "Jitter", PovrayKey::jitter},
    {"D", "Display", PovrayKey::display},
    {"Q", "Quality", PovrayKey::quality},
    {"SC", "Start_Column", PovrayKey::first_column},
    {"SR", "Start_Row", PovrayKey::first_row},
    {"SP", "Preview_Start_Size", PovrayKey::unused},
    {"SF", "Subset_Start_Frame", PovrayKey::subset_first_frame},
    {"EC", "End_Column", PovrayKey::last_column},
    {"ER", "End_Row", PovrayKey::last_row},
    {"EP", "Preview_End_Size", PovrayKey::unused},
    {"EF", "Subset_End_Frame", PovrayKey::subset_last_frame},
    {"F", "Output_to_File", PovrayKey::file_type},
    {"V", "Verbose", PovrayKey::verbose},
    {"G", "All_Console", PovrayKey::console},
    {"L", "Library_Path", PovrayKey::library},
    {"KFI", "Initial_Frame", PovrayKey::first_frame},
    {"KFF", "Final_Frame", PovrayKey::last_frame},
    {"KI", "Initial_Clock", PovrayKey::first_clock},
    {"KF", "Final_Clock", PovrayKey::last_clock},
    {"KC", "Cyclic_Animation", PovrayKey::cycle},
    {"K", "Clock", PovrayKey::clock},
    {"P", "Pause_When_Done", PovrayKey::unused},
    {"C", "Continue_Trace", PovrayKey::unused},
    {"BP", "Bounding_Method", PovrayKey::unused},
    {"BM", "Bounding_Method", PovrayKey::unused},
    {"B", "Buffer_Output", PovrayKey::unused},
    {"MB", "Bounding_Threshold", PovrayKey::unused},
    {"MV", "Version", PovrayKey::unused},
    {"M", "Max_Image_Buffer_Memory", PovrayKey::unused},
    {"UA", "Output_Alpha", PovrayKey::alpha},
    {"UD", "Draw_Vistas", PovrayKey::unused},
    {"UF", "Field_Render", PovrayKey::fields},
    {"UL", "Light_Buffer", PovrayKey::unused},
    {"SU", "Split_Unions", PovrayKey::unused},
    {"UO", "Odd_Field", PovrayKey::fields},
    {"UR", "Remove_Bounds", PovrayKey::unused},
    {"UV", "Vista_Buffer", PovrayKey::unused},
    {"U", "", PovrayKey::unused},
    {"X", "Test_Abort", PovrayKey::unused},
    {"", "Antialias_Threshold", PovrayKey::antialias_threshold},
    {"", "Antialias_Confidence", PovrayKey::unused},
    {"", "Jitter_Amount", PovrayKey::jitter},
    {"", "Output_File_Type", PovrayKey::file_type},
    {"", "Bits_Per_Color", PovrayKey::bits},
    {"", "Display_Gamma", PovrayKey::unused},
    {"", "File_Gamma", PovrayKey::file_gamma},
    {"", "Declare", PovrayKey::declare},
    {"", "Warning_Console", PovrayKey::console},
    {"", "Debug_Console", PovrayKey::console},
    {"", "Fatal_Console", PovrayKey::console},
    {"", "Render_Console", PovrayKey::console},
    {"", "Statistic_Console", PovrayKey::console},
    {"", "All_File", PovrayKey::console},
    {"", "Warning_File", PovrayKey::console},
    {"", "Debug_File", PovrayKey::console},
    {"", "Fatal_File", PovrayKey::console},
    {"", "Render_File", PovrayKey::console},
    {"", "Statistic_File", PovrayKey::console},
    {"", "Preview_Start_Size", PovrayKey::unused},
    {"", "Preview_End_Size", PovrayKey::unused},
    {"", "Video_Mode", PovrayKey::display},
    {"", "Palette", PovrayKey::display},
    {"", "Grayscale_Output", PovrayKey::other_picture},
    {"", "Dither", PovrayKey::other_picture},
    {"", "Dither_Method", PovrayKey::unused},
    {"", "Bounding", PovrayKey::unused},
    {"", "Render_Block_Size", PovrayKey::unused},
    {"", "Render_Block_Step", PovrayKey::unused},
    {"", "BSP_MaxDepth", PovrayKey::unused},
    {"", "BSP_BaseAccessCost", PovrayKey::unused},
    {"", "BSP_ChildAccessCost", PovrayKey::unused},
    {"", "BSP_IsectCost", PovrayKey::unused},
    {"", "BSP_MissChance", PovrayKey::unused},
    {"", "Radiosity_File_Name", PovrayKey::unused},
    {"", "Radiosity_From_File", PovrayKey::unused},
    {"", "Radiosity_To_File", PovrayKey::unused},
    {"", "Radiosity_Vain_Pretrace", PovrayKey::unused},
    {"", "Pre_Scene_Command", PovrayKey::other_picture},
    {"", "Pre_Scene_Return", PovrayKey::unused},
    {"", "Post_Scene_Command", PovrayKey::other_picture},
    {"", "Post_Scene_Return", PovrayKey::unused},
    {"", "Pre_Frame_Command", PovrayKey::other_picture},
    {"", "Pre_Frame_Return", PovrayKey::unused},
    {"", "Post_Frame_Command", PovrayKey::other_picture},
    {"", "Post_Frame_Return", PovrayKey::unused},
    {"", "Fatal_Error_Command", PovrayKey::other_picture},
    {"", "Fatal_Error_Return", PovrayKey::unused},
    {"", "User_Abort_Command", PovrayKey::other_picture},
    {"", "User_Abort_Return", PovrayKey::unused},
    {"", "Clockless_Animation", PovrayKey::other_picture},
    {"", "Real_Time_Raytracing", PovrayKey::other_picture},
    {"", "Max_Image_Buffer_Memory", PovrayKey::unused},
    {"", "High_Reproducibility", PovrayKey::unused},
    {"", "Test_Abort_Count", PovrayKey::unused},
    {"", "Create_Ini", PovrayKey::unused},
    {"", "Compression", PovrayKey::compression},
    {"", "Frame_Step", PovrayKey::frame_step},
};

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

bool equal_without_case(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return upper(x) == upper(y); });
}

}  // namespace

const ForeignFlag* find_foreign_flag(std::string_view word, bool only_tachyon) {
    const auto find = [&](std::span<const ForeignFlag> flags) -> const ForeignFlag* {
        const auto at =
            std::find_if(flags.begin(), flags.end(), [&](const ForeignFlag& f) { return f.flag == word; });
        return at == flags.end() ? nullptr : &*at;
    };
    const ForeignFlag* found = find(k_tachyon);
    return found != nullptr || only_tachyon ? found : find(k_others);
}

std::span<const ForeignFlag> tachyon_flags() { return k_tachyon; }

const PovraySwitch* find_povray_switch(std::string_view letters) {
    for (const PovraySwitch& s : k_povray) {
        const std::size_t size = s.letters.size();
        if (size > 0 && letters.size() >= size && equal_without_case(letters.substr(0, size), s.letters))
            return &s;
    }
    return nullptr;
}

const PovraySwitch* find_povray_key(std::string_view key) {
    if (key.empty()) return nullptr;  // switches without a key
    const auto* at = std::find_if(std::begin(k_povray), std::end(k_povray),
                                  [&](const PovraySwitch& s) { return equal_without_case(s.key, key); });
    return at == std::end(k_povray) ? nullptr : at;
}

}  // namespace glint::cli
