// SPDX-License-Identifier: Apache-2.0
// POV-Ray's options as the arguments of `glint render`: the picture, its part, its file, the frames.
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "base/text.h"
#include "cli/drop_in_povray.h"
#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/output_file.h"
#include "cli/picture_endings.h"
#include "cli/text.h"
#include "os/files.h"

namespace glint::cli {

DropIn PovrayOptions::finish() {
    if (!parsed_.wants_help && !parsed_.wants_version) set_render_arguments();
    return std::move(parsed_);
}

void PovrayOptions::set_render_arguments() {
    if (input_.empty()) throw Failure(k_usage, "expected the name of a scene: +Iscene.pov");
    RenderArguments& render = parsed_.render;
    render.scene.files = {find_input()};
    render.scene.format = "povray";
    if (width_ == 0 || height_ == 0) fail("expected a width and a height above 0");
    render.picture.size = fmt::format("{}x{}", width_, height_);
    // POV-Ray compares the sum of three channels.
    if (antialias_ && depth_of_samples_ > 1)
        render.picture.aa = fmt::format("adaptive:{}:{:.4g}", depth_of_samples_, threshold_ / 3);
    if (!antialias_) render.picture.aa = "1";
    NumberArguments& numbers = render.numbers;
    if (!numbers.format) numbers.format = FileFormat::png;
    if (*numbers.format != FileFormat::png && *numbers.format != FileFormat::ppm) numbers.bits = 8;
    numbers.jpeg_quality = jpeg_quality_;
    render.output = writes_ ? output_path() : "/dev/null";
    render.scene.include_paths = folders_;
    set_part();
    set_frames();
    if (!writes_) return;
    if (parsed_.frames.empty()) check_output(render.output);
    for (const DropInFrame& frame : parsed_.frames) check_output(frame.output);
}

// POV-Ray's picture has its whole size, with black around the part.
void PovrayOptions::set_part() {
    const auto across = pixels_of(columns_, width_), down = pixels_of(rows_, height_);
    if (!across || !down)
        throw Failure(k_usage,
                      fmt::format("+SC, +EC, +SR, +ER: expected a part of the {}x{} pixels: the first column "
                                  "and row at or before the last, from 1, or fractions",
                                  width_, height_));
    if (across->count == width_ && down->count == height_) return;
    parsed_.render.crop = fmt::format("{}x{}+{}+{}", across->count, down->count, across->first, down->first);
    parsed_.render.keeps_size = true;
}

void PovrayOptions::set_frames() {
    parsed_.frames = frames_of(animation_, parsed_.render.output);
    const bool is_alone = animation_.first_frame.value_or(1) >= animation_.last_frame.value_or(0);
    if (!parsed_.frames.empty() && is_alone)
        warn("an animation of one frame: its clock is Initial_Clock; in POV-Ray it is not a number");
    if (!parsed_.frames.empty() && is_standard_output(parsed_.render.output))
        throw Failure(k_usage, "an animation is several files: name them with +O");
}

// Somebody else's .ini must not write to any place: on the command line the user sees where.
void PovrayOptions::check_output(const std::string& path) const {
    const Namer& by = output_.empty() ? input_by_ : output_by_;
    if (by.place.empty() || path == "-" || is_inside(path, ".") || is_inside(path, by.folder)) return;
    throw Failure(k_usage,
                  fmt::format("{}: expected an output in this folder or the .ini file's, found {}; for "
                              "another folder, give +O on the command line",
                              by.place, glint::quoted(output_.empty() ? path : output_)));
}

// The scene, with .pov or without, in this folder or one of +L. Without extension `input_` then has it.
std::string PovrayOptions::find_input() {
    const auto is_file = [](const std::string& path) {
        const os::FileKind kind = os::info_of(path).kind;
        return kind != os::FileKind::none && kind != os::FileKind::folder;
    };
    const std::string given = input_;
    const bool is_bare = extension(given).empty() && given != "-";
    if (is_bare && !is_file(given)) input_ += ".pov";
    if (input_ == "-" || is_file(input_)) return input_;
    for (const std::string& folder : folders_) {
        std::string path = os::to_string(os::to_path(folder) / os::to_path(input_));
        if (is_file(path)) return path;
    }
    return os::info_of(given).kind == os::FileKind::folder ? given : input_;  // for the message
}

// The names are POV-Ray's (measured): the ending of the file's type is added unless the name has it;
// without +O the picture is beside the scene.
std::string PovrayOptions::output_path() const {
    const std::string ending = ending_of(*parsed_.render.numbers.format);
    const std::filesystem::path scene = os::to_path(input_ == "-" ? "stdin" : input_);
    const std::string name = stem(os::to_string(scene)) + ending;
    if (output_.empty()) return os::to_string(scene.parent_path() / os::to_path(name));
    if (output_ == "-") return output_;
    if (output_.ends_with('/')) return os::to_string(os::to_path(output_) / os::to_path(name));
    std::error_code ignored;
    if (output_.ends_with(ending) || std::filesystem::is_character_file(os::to_path(output_), ignored))
        return output_;
    return output_ + (output_.ends_with('.') ? ending.substr(1) : ending);
}

}  // namespace glint::cli
