// SPDX-License-Identifier: Apache-2.0
#include "cli/layer_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/light_argument.h"
#include "cli/text.h"
#include "image/layer_preview.h"
#include "output/strip_writer.h"

namespace glint::cli {
namespace {

std::vector<std::string_view> layer_names() {
    std::vector<std::string_view> names;
    for (const LayerInfo& info : layer_infos()) names.push_back(info.name);
    return names;
}

constexpr std::string_view k_light = "light:";

// A layer of a light; without a scene, any.
Layer light_layer_of(const std::string& word, const Scene* scene) {
    const std::string light = word.substr(k_light.size());
    if (light.empty())
        throw Failure(k_usage, "--aov: expected the name or the number of a light after 'light:'");
    if (scene == nullptr || light == "none") return Layer::no_light;
    return light_layer(find_light("--aov", light, *scene));
}

std::vector<Layer> parse(const std::string& aov, const Scene* scene) {
    std::vector<Layer> layers;
    if (aov == "all") {
        for (const LayerInfo& info : layer_infos()) layers.push_back(info.layer);
        return layers;
    }
    for (std::size_t start = 0; start <= aov.size();) {
        const std::size_t end = std::min(aov.find(',', start), aov.size());
        const std::string word = aov.substr(start, end - start);
        start = end + 1;
        if (word.empty())
            throw Failure(k_usage,
                          fmt::format("--aov '{}': expected layer names separated by commas, found {}", aov,
                                      aov.empty() ? "nothing" : "an empty name"));
        const auto layer = word.starts_with(k_light) ? light_layer_of(word, scene) : find_layer(word);
        if (!layer)
            throw Failure(k_usage, fmt::format("--aov: there is no layer {}{}, light:NAME, or all",
                                               glint::quoted(word), suggestion(word, layer_names())));
        if (std::find(layers.begin(), layers.end(), *layer) == layers.end()) layers.push_back(*layer);
    }
    return layers;
}

// Gamma and the transfer curve apply to light only, not to normals and other numbers.
EncodeOptions encoding_of(Layer layer, EncodeOptions encoding) {
    const bool is_light =
        static_cast<int>(layer) < k_light_layers || layer == Layer::albedo || is_light_layer(layer);
    if (!is_light) encoding.set_rule({.rounding = encoding.rounding});
    return encoding;
}

}  // namespace

void add_layer_argument(CLI::App& command, std::optional<std::string>& aov) {
    command
        .add_option(
            "--aov", aov,
            fmt::format("Also write these layers, separated by commas: {}; or all. light:NAME, or "
                        "light:2: the picture with this light alone; light:none: without lights. OpenEXR: as "
                        "parts of the file; other formats: as separate files, such as castle.normal.png",
                        joined(layer_names())))
        ->option_text("LAYERS");
}

std::vector<Layer> parse_layers(const std::optional<std::string>& aov, const Scene* scene) {
    return aov ? parse(*aov, scene) : std::vector<Layer>{};
}

LayerFiles::LayerFiles(std::vector<Layer> wanted, const std::string& picture, FileFormat format,
                       bool is_stream)
    : wanted_(std::move(wanted)) {
    if (wanted_.empty() || format == FileFormat::exr) return;
    if (is_stream)
        throw Failure(k_usage, "--aov: standard output holds one picture; name a file with --output");
    const std::string ending = extension(picture), base = picture.substr(0, picture.size() - ending.size());
    for (const Layer layer : wanted_) {
        std::string name = layer_name(layer);
        std::replace(name.begin(), name.end(), ':', '-');  // Windows and scp give colons a meaning
        files_.emplace_back("--aov", fmt::format("{}.{}{}", base, name, ending));
    }
}

double LayerFiles::bytes_a_pixel() const {
    double floats = 3;
    for (const Layer layer : wanted_) floats += static_cast<double>(layer_channels(layer).size());
    // An OpenEXR file of the layers is built in memory, and may be as large as they are.
    return floats * sizeof(float) * (files_.empty() && !wanted_.empty() ? 2 : 1);
}

void LayerFiles::write(const std::vector<LayerImage>& layers, const EncodeOptions& encoding) const {
    for (std::size_t i = 0; i < files_.size(); ++i) {
        const Result<Image> picture = viewable(layers[i]);
        if (!picture) throw Failure(k_bad_input, fmt::format("cannot show a layer: {}", picture.message));
        const auto encoded = encode(*picture, encoding_of(layers[i].layer, encoding));
        if (!encoded) throw Failure(k_bad_input, fmt::format("cannot encode a layer: {}", encoded.message));
        files_[i].write(*encoded);
    }
}

void LayerFiles::write(const JournalPicture& picture, const EncodeOptions& encoding) const {
    const Crop& size = picture.header().picture;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        LayerPreview preview(wanted_[i]);
        if (preview.needs_scan())
            picture.for_each_strip(i + 1, 1, [&](auto, auto values) { preview.scan(values); });
        StripWriter file(files_[i].begin(), encoding_of(wanted_[i], encoding), size.width, size.height);
        picture.for_each_strip(i + 1, encoding.threads,
                               [&](std::int32_t strip, std::span<const float> values) {
                                   std::vector<float> rgb(3 * values.size() / picture.channels(i + 1));
                                   preview.convert(values, rgb.data());
                                   file.put(strip, rgb);
                               });
        file.finish(true);
    }
}

}  // namespace glint::cli
