// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/text.h"
#include "cli/validators.h"
#include "os/process.h"

namespace glint::cli {
namespace {

// The memory that this process may use: the machine's, or less if the container limits it.
double memory_limit() {
    double limit = os::physical_memory();
    for (const char* rule : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        double bytes = 0;
        if (std::ifstream(rule) >> bytes && bytes > 0 && bytes < limit) limit = bytes;
    }
    return limit;
}

}  // namespace

void check_memory(double width, double height, double bytes) {
    const double needed = width * height * bytes, limit = memory_limit();
    if (needed <= limit) return;
    const std::string rest = std::max(width, height) > k_max_size
                                 ? fmt::format("; the limit is {} pixels a side", k_max_size)
                                 : "; render it in parts with --crop";
    throw Failure(k_bad_input,
                  fmt::format("a picture of {:.0f}x{:.0f} needs {} of memory ({} bytes per pixel), and this "
                              "machine has {}{}",
                              width, height, bytes_text(needed), bytes, bytes_text(limit), rest));
}

void check_isa(const std::string& isa) {
    if (isa.empty()) return;
    const auto names = isa_names();
    if (std::find(names.begin(), names.end(), isa) != names.end()) return;
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw Failure(k_usage, fmt::format("--isa: this machine has no instruction set {}{}", glint::quoted(isa),
                                       suggestion(isa, views)));
}

void add_picture_arguments(CLI::App& command, PictureArguments& a) {
    command.add_option("-s,--size", a.size, "Size in pixels; default: the file's, or the profile's")
        ->option_text("WxH");
    command.add_option("--shading", a.shading, "How surfaces are shaded")
        ->option_text("phong|blinn-phong|diffuse|color|normals");
    command.add_flag("--no-shadows", a.no_shadows, "No shadows: every light reaches every surface");
    command
        .add_option("--reflections", a.reflections, "Largest number of successive reflections; 0: no mirrors")
        ->option_text("N");
    command
        .add_option("--aa", a.aa,
                    "N x N samples per pixel; adaptive:N:T: only for pixels whose one sample differs "
                    "by more than T (default: 0.05) from that of a neighbour; with :jitter at the end, at "
                    "sampled places")
        ->option_text("N|adaptive:N[:T]");
    command
        .add_option("--seed", a.seed, "Number of another picture of everything that is sampled; 0 (default)")
        ->option_text("N");
}

void add_alpha_argument(CLI::App& command, PictureArguments& a) {
    command.add_flag("--alpha", a.alpha,
                     "The background is transparent: PNG and OpenEXR have an alpha channel");
}

void add_settings(const PictureArguments& arguments, PictureMemory memory, SceneArguments& scene) {
    auto& settings = scene.settings;
    if (!arguments.size.empty()) {
        const auto size = parse_size(arguments.size);
        const bool is_checked =
            memory == PictureMemory::whole ||
            (memory == PictureMemory::rows && size && std::max(size->width, size->height) > k_max_size);
        if (size && size->width > 0 && size->height > 0 && is_checked) {
            check_memory(static_cast<double>(size->width), static_cast<double>(size->height));
        }
        settings.emplace_back("size", arguments.size);
    }
    if (!arguments.shading.empty()) settings.emplace_back("shading", arguments.shading);
    if (arguments.no_shadows) settings.emplace_back("shadows", "false");
    if (!arguments.reflections.empty()) settings.emplace_back("reflections", arguments.reflections);
    if (arguments.alpha) settings.emplace_back("alpha", "true");
    if (!arguments.aa.empty()) settings.emplace_back("aa", arguments.aa);
    if (!arguments.seed.empty()) settings.emplace_back("seed", arguments.seed);
}

void add_number_arguments(CLI::App& command, NumberArguments& a) {
    command
        .add_option(
            "--transfer", a.transfer,
            "none: the numbers as computed; srgb: the sRGB curve, for use with photographs. Default: the "
            "scene's convention `transfer`, none. OpenEXR is always linear")
        ->check(one_of({"none", "srgb"}))
        ->option_text("none|srgb");
    command
        .add_option("--bits", a.bits,
                    "Bits per channel of PNG and PPM: 8 (default) or 16; OpenEXR is 32-bit float")
        ->check(one_of({"8", "16"}))
        ->option_text("8|16");
}

void add_threads_argument(CLI::App& command, int& threads, const std::string& rest) {
    command.add_option("-t,--threads", threads, "Number of threads; 0 (default): one per processor" + rest)
        ->check(whole_number(0, 1024))
        ->option_text("N");
}

EncodeOptions encoding_of(const NumberArguments& arguments, const ByteRule& rule) {
    EncodeOptions options;
    options.bits = arguments.bits;
    options.jpeg_quality = arguments.jpeg_quality;
    options.set_rule(rule);
    if (!arguments.transfer.empty())
        options.transfer = arguments.transfer == "srgb" ? Transfer::srgb : Transfer::none;
    return options;
}

}  // namespace glint::cli
