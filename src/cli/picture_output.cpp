// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "cli/clock.h"
#include "cli/failure.h"
#include "cli/terminal.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

std::optional<FileFormat> format_of_name(const std::string& path) {
    const std::string ending = extension(path);
    if (ending == ".png") return FileFormat::png;
    if (ending == ".ppm") return FileFormat::ppm;
    if (ending == ".exr") return FileFormat::exr;
    return std::nullopt;
}

FileFormat format_of(const std::string& path, const OutputFile& output) {
    if (const auto format = format_of_name(path)) return *format;
    if (output.is_stream()) return FileFormat::png;
    throw Failure(k_usage, fmt::format("--output '{}': glint writes .png, .ppm and .exr", path));
}

EncodeOptions encoding_of(const NumberArguments& numbers, FileFormat format, int threads) {
    EncodeOptions encoding = encoding_of(numbers);
    encoding.format = format;
    encoding.threads = threads;
    return encoding;
}

}  // namespace

bool is_picture_path(const std::string& path) { return format_of_name(path).has_value(); }

PictureOutput::PictureOutput(const std::string& path, const NumberArguments& numbers, int threads, bool shows)
    : path_(path),
      output_("--output", path),
      encoding_(encoding_of(numbers, format_of(path, output_), threads)) {
    if (!output_.is_standard_output()) return;
    if (shows) throw Failure(k_usage, "--show and the picture cannot both go to standard output");
    if (is_terminal(STDOUT_FILENO))
        throw Failure(k_usage, "standard output is a terminal: redirect it to a file, or use --show");
}

void PictureOutput::set_layers(const std::vector<Layer>& layers) {
    layers_ = LayerFiles(layers, path_, encoding_.format, output_.is_stream());
}

double PictureOutput::memory(std::int32_t width, std::int32_t height) const {
    return static_cast<double>(width) * static_cast<double>(height) * layers_.bytes_a_pixel();
}

void PictureOutput::check_memory(std::int32_t width, std::int32_t height) const {
    cli::check_memory(width, height, layers_.bytes_a_pixel());
}

double PictureOutput::write(const Rendering& rendering) const {
    const auto start = Clock::now();
    const auto encoded = encoding_.format == FileFormat::exr && !rendering.layers.empty()
                             ? encode_layers(rendering.image, rendering.layers)
                             : encode(rendering.image, encoding_);
    const double seconds = seconds_since(start);
    if (!encoded) throw Failure(k_bad_input, fmt::format("cannot encode the picture: {}", encoded.message));
    layers_.write(rendering.layers, encoding_);
    output_.write(*encoded);
    return seconds;
}

double PictureOutput::write(const JournalPicture& picture) const {
    layers_.write(picture, encoding_);
    const auto start = Clock::now();
    const Crop& size = picture.header().picture;
    if (encoding_.format == FileFormat::exr && has_layers()) {
        const auto file = output_.begin();
        const auto encoder = make_parts_encoder(size.width, size.height, layers_.wanted(), *file);
        if (encoder == nullptr) throw Failure(k_bad_input, "this build writes no OpenEXR");
        for (std::size_t part = 0; part <= layers_.wanted().size(); ++part) {
            picture.for_each_strip(part, 1, [&](std::int32_t strip, std::span<const float> values) {
                const Crop area = strip_area(size, strip);
                encoder->append(part, area.y - size.y, area.height, values.data());
            });
        }
        encoder->finish();
        file->commit(true);
    } else {
        StripFile file(output_, encoding_, size.width, size.height);
        picture.for_each_strip(0, encoding_.threads, [&](std::int32_t strip, std::span<const float> values) {
            file.put(strip, values);
        });
        file.finish(true);
    }
    return seconds_since(start);
}

std::unique_ptr<StripFile> PictureOutput::begin_strips(std::int32_t width, std::int32_t height) const {
    return std::make_unique<StripFile>(output_, encoding_, width, height);
}

}  // namespace glint::cli
