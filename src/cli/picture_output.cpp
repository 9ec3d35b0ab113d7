// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
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
    if (ending == ".tga") return FileFormat::tga;
    if (ending == ".bmp") return FileFormat::bmp;
    if (ending == ".jpg" || ending == ".jpeg") return FileFormat::jpeg;
    return std::nullopt;
}

const char* why_no_alpha(FileFormat format) {
    return format == FileFormat::tga   ? "glint writes TGA without alpha"
           : format == FileFormat::bmp ? "glint writes BMP without alpha"
           : format == FileFormat::ppm ? "PPM has no alpha channel"
                                       : "JPEG has no alpha channel";
}

FileFormat format_of(const std::string& path, const OutputFile& output, const NumberArguments& numbers) {
    if (numbers.format) return *numbers.format;
    if (const auto format = format_of_name(path)) return *format;
    if (output.is_stream()) return FileFormat::png;
    throw Failure(
        k_usage,
        fmt::format("--output '{}': glint writes .png, .ppm and .exr, and .tga, .bmp and .jpg", path));
}

EncodeOptions encoding_of(const NumberArguments& numbers, FileFormat format, int threads) {
    EncodeOptions encoding = encoding_of(numbers, {});
    encoding.format = format;
    encoding.threads = threads;
    return encoding;
}

}  // namespace

bool is_picture_path(const std::string& path) { return format_of_name(path).has_value(); }

PictureOutput::PictureOutput(const std::string& path, const NumberArguments& numbers, int threads, bool shows)
    : path_(path),
      numbers_(numbers),
      output_("--output", path),
      encoding_(encoding_of(numbers, format_of(path, output_, numbers), threads)) {
    if (!output_.is_standard_output()) return;
    if (shows) throw Failure(k_usage, "--show and the picture cannot both go to standard output");
    if (is_terminal(STDOUT_FILENO))
        throw Failure(k_usage, "standard output is a terminal: redirect it to a file, or use --show");
}

void PictureOutput::set_layers(const std::vector<Layer>& layers) {
    layers_ = LayerFiles(layers, path_, encoding_.format, output_.is_stream());
}

void PictureOutput::set_alpha() {
    if (encoding_.format != FileFormat::png && encoding_.format != FileFormat::exr)
        throw Failure(k_usage, fmt::format("--output '{}': {}; write .png or .exr, or render without alpha",
                                           path_, why_no_alpha(encoding_.format)));
    alpha_ = true;
    layers_.leave_out(Layer::alpha);  // it is a channel of the picture
}

void PictureOutput::set_rule(const ByteRule& rule) { encoding_.set_rule(encoding_of(numbers_, rule).rule()); }

double PictureOutput::bytes_a_pixel() const {
    return layers_.bytes_a_pixel() + (alpha_ ? 2 * sizeof(float) : 0);
}

double PictureOutput::memory(std::int32_t width, std::int32_t height) const {
    return static_cast<double>(width) * static_cast<double>(height) * bytes_a_pixel();
}

void PictureOutput::check_memory(std::int32_t width, std::int32_t height) const {
    cli::check_memory(width, height, bytes_a_pixel());
}

double PictureOutput::write(const Rendering& rendering) const {
    const auto start = Clock::now();
    const std::span<const LayerImage> layers =
        std::span(rendering.layers).first(rendering.layers.size() - (alpha_ ? 1 : 0));
    const std::span<const float> alpha =
        alpha_ ? std::span<const float>(rendering.layers.back().values) : std::span<const float>();
    const auto encoded = encoding_.format == FileFormat::exr && !layers.empty()
                             ? encode_layers(rendering.image, layers, alpha)
                         : alpha_ ? encode(rendering.image, alpha, encoding_)
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
        const auto encoder = make_parts_encoder(size.width, size.height, layers_.wanted(), *file, alpha_);
        if (encoder == nullptr) throw Failure(k_bad_input, "this build writes no OpenEXR");
        for (std::size_t part = 0; part <= layers_.wanted().size(); ++part) {
            picture.for_each_strip(part, 1, [&](std::int32_t strip, std::span<const float> values) {
                const Crop area = strip_area(size, strip);
                const auto rows = part == 0 ? picture_rows(picture, strip, values) : std::vector<float>();
                encoder->append(part, area.y - size.y, area.height,
                                rows.empty() ? values.data() : rows.data());
            });
        }
        encoder->finish();
        file->commit(true);
    } else {
        StripFile file(output_, encoding_, size.width, size.height, alpha_);
        picture.for_each_strip(0, encoding_.threads, [&](std::int32_t strip, std::span<const float> values) {
            const std::vector<float> rows = picture_rows(picture, strip, values);
            file.put(strip, rows.empty() ? values : std::span<const float>(rows));
        });
        file.finish(true);
    }
    return seconds_since(start);
}

std::unique_ptr<StripFile> PictureOutput::begin_strips(std::int32_t width, std::int32_t height) const {
    return std::make_unique<StripFile>(output_, encoding_, width, height, alpha_);
}

// The rows of the picture with their alpha, which is the journal's last layer; empty without alpha.
std::vector<float> PictureOutput::picture_rows(const JournalPicture& picture, std::int32_t strip,
                                               std::span<const float> rgb) const {
    if (!alpha_) return {};
    return with_alpha(rgb, picture.read_strip(picture.header().layers.size(), strip));
}

bool has_alpha(const JournalHeader& header) {
    const std::pair<std::string, std::string> alpha("alpha", "true");
    return std::find(header.settings.begin(), header.settings.end(), alpha) != header.settings.end() &&
           !header.layers.empty() && header.layers.back() == Layer::alpha;
}

ByteRule rule_of(const JournalHeader& header) {
    Scene scene;
    for (const auto& [key, value] : header.settings) {
        const auto index = find_setting(key);
        if (index && (key == "transfer" || key == "gamma" || key == "rounding"))
            set_setting(scene, *index, value, {});
    }
    return scene.conventions.byte_rule();
}

void put_alpha_last(std::vector<Layer>& layers) {
    std::erase(layers, Layer::alpha);
    layers.push_back(Layer::alpha);
}

}  // namespace glint::cli
