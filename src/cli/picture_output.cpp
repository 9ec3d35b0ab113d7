// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/clock.h"
#include "cli/failure.h"
#include "cli/picture_endings.h"
#include "cli/text.h"
#include "os/files.h"
#include "os/process.h"

namespace glint::cli {
namespace {

std::optional<FileFormat> format_of_name(const std::string& path) {
    return format_of_ending(extension(path));
}

FileFormat format_of(const std::string& path, const OutputFile& output, const NumberArguments& numbers) {
    if (numbers.format) return *numbers.format;
    if (const auto format = format_of_name(path)) return *format;
    if (output.is_stream()) return FileFormat::png;
    throw Failure(k_usage, fmt::format("--output '{}': glint writes {}", path, k_picture_endings_text));
}

EncodeOptions encoding_of(const PictureDestination& destination, const ByteRule& rule, int threads) {
    EncodeOptions encoding = encoding_of(destination.numbers, rule);
    encoding.format = destination.format;
    encoding.threads = threads;
    return encoding;
}

// Throws Failure if the picture cannot be encoded so.
EncodeOptions checked(const EncodeOptions& encoding, const std::string& path, const Crop& area, bool alpha) {
    const std::string wrong = encoding_fault(area.width, area.height, encoding, false);
    if (!wrong.empty()) throw Failure(k_usage, fmt::format("--output '{}': {}", path, wrong));
    const std::string no_alpha = encoding_fault(area.width, area.height, encoding, alpha);
    if (!no_alpha.empty())
        throw Failure(k_usage, fmt::format("--output '{}': {}; write .png or .exr, or render without alpha",
                                           path, no_alpha));
    return encoding;
}

// The layers that are written as such.
std::vector<Layer> layers_but_alpha(const PictureContents& contents) {
    std::vector<Layer> layers = contents.layers;
    if (contents.has_alpha) layers.pop_back();
    return layers;
}

// Whether the picture of a journal has an alpha channel.
bool is_with_alpha(const JournalHeader& header) {
    const std::pair<std::string, std::string> alpha("alpha", "true");
    return std::find(header.settings.begin(), header.settings.end(), alpha) != header.settings.end() &&
           !header.layers.empty() && header.layers.back() == Layer::alpha;
}

// The rule of the scene of a journal.
ByteRule rule_of(const JournalHeader& header) {
    Scene scene;
    for (const auto& [key, value] : header.settings) {
        const auto index = find_setting(key);
        if (index && (key == "transfer" || key == "gamma" || key == "rounding"))
            set_setting(scene, *index, value, {});
    }
    return scene.conventions.byte_rule();
}

}  // namespace

bool is_picture_path(const std::string& path) { return format_of_name(path).has_value(); }

void put_alpha_last(std::vector<Layer>& layers) {
    std::erase(layers, Layer::alpha);
    layers.push_back(Layer::alpha);
}

PictureDestination picture_destination(const std::string& path, const NumberArguments& numbers, bool shows) {
    const OutputFile file("--output", path);
    const FileFormat format = format_of(path, file, numbers);
    if (file.is_standard_output()) {
        if (shows) throw Failure(k_usage, "--show and the picture cannot both go to standard output");
        if (os::is_terminal(os::k_standard_output))
            throw Failure(k_usage, "standard output is a terminal: redirect it to a file, or use --show");
    }
    return {path, file, numbers, format};
}

PictureContents contents_of(const JournalHeader& header) {
    return {header.picture, header.layers, is_with_alpha(header), rule_of(header)};
}

PictureOutput::PictureOutput(const PictureDestination& destination, const PictureContents& contents,
                             int threads)
    : output_(destination.file),
      area_(contents.area),
      alpha_(contents.has_alpha),
      encoding_(checked(encoding_of(destination, contents.rule, threads), destination.path, area_, alpha_)),
      layers_(layers_but_alpha(contents), destination.path, destination.format, output_.is_stream()) {}

double PictureOutput::bytes_a_pixel() const {
    return layers_.bytes_a_pixel() + (alpha_ ? 2 * sizeof(float) : 0);
}

double PictureOutput::memory() const {
    return static_cast<double>(area_.width) * static_cast<double>(area_.height) * bytes_a_pixel();
}

void PictureOutput::check_memory() const { cli::check_memory(area_.width, area_.height, bytes_a_pixel()); }

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
    if (encoding_.format == FileFormat::exr && has_layers()) {
        const auto file = output_.begin();
        const auto encoder = make_parts_encoder(area_.width, area_.height, layers_.wanted(), *file, alpha_);
        for (std::size_t part = 0; part <= layers_.wanted().size(); ++part) {
            picture.for_each_strip(part, 1, [&](std::int32_t strip, std::span<const float> values) {
                const Crop area = strip_area(area_, strip);
                const auto rows = part == 0 ? picture_rows(picture, strip, values) : std::vector<float>();
                encoder->append(part, area.y - area_.y, area.height,
                                rows.empty() ? values.data() : rows.data());
            });
        }
        encoder->finish();
        file->commit(true);
    } else {
        const auto writer = begin_strips();
        picture.for_each_strip(0, encoding_.threads, [&](std::int32_t strip, std::span<const float> values) {
            const std::vector<float> rows = picture_rows(picture, strip, values);
            writer->put(strip, rows.empty() ? values : std::span<const float>(rows));
        });
        writer->finish(true);
    }
    return seconds_since(start);
}

std::unique_ptr<StripWriter> PictureOutput::begin_strips() const {
    return std::make_unique<StripWriter>(output_.begin(), encoding_, area_.width, area_.height, alpha_);
}

// The rows of the picture with their alpha, which is the journal's last layer; empty without alpha.
std::vector<float> PictureOutput::picture_rows(const JournalPicture& picture, std::int32_t strip,
                                               std::span<const float> rgb) const {
    if (!alpha_) return {};
    return with_alpha(rgb, picture.read_strip(picture.header().layers.size(), strip));
}

}  // namespace glint::cli
