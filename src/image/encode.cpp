// SPDX-License-Identifier: Apache-2.0
// Choosing the encoder.
#include <cstddef>
#include <utility>

#include "base/catch_exceptions.h"
#include "glint/image.h"
#include "image/encoders.h"
#include "image/layer_fault.h"

namespace glint {
namespace {

// What no encoder could write, or an empty string.
std::string fault(const Image& image, const EncodeOptions& options) {
    if (image.width < 1 || image.height < 1 || image.width > k_max_size || image.height > k_max_size) {
        return "a picture has 1 to " + std::to_string(k_max_size) + " pixels a side";
    }
    if (image.rgb.size() != std::size_t{3} * image.width * image.height) {
        return "the picture's numbers do not fit its size";
    }
    if (options.bits != 8 && options.bits != 16) return "a channel has 8 or 16 bits";
    if (options.format > FileFormat::exr) return "there is no such file format";
    if (options.transfer > Transfer::srgb) return "there is no such transfer curve";
    return {};
}

std::string layers_fault(const Image& picture, std::span<const LayerImage> layers) {
    bool seen[k_layers] = {};
    for (const LayerImage& layer : layers) {
        if (std::string wrong = layer_fault(layer); !wrong.empty()) return wrong;
        if (layer.width != picture.width || layer.height != picture.height)
            return "a layer has not the picture's size";
        bool& is_there = seen[static_cast<std::size_t>(layer.layer)];
        if (is_there) {
            const std::string_view name = layer_infos()[static_cast<std::size_t>(layer.layer)].name;
            return "the layer '" + std::string(name) + "' is there twice";
        }
        is_there = true;
    }
    return {};
}

}  // namespace

EncodeResult encode(const Image& image, const EncodeOptions& options) {
    EncodeResult result;
    std::string error = catch_exceptions([&] {
        result.error = fault(image, options);
        if (!result.error.empty()) return;
        switch (options.format) {
            case FileFormat::png:
#if defined(GLINT_WITH_PNG)
                result = encode_png(image, options);
#else
                result.error = "this build writes no PNG";
#endif
                break;
            case FileFormat::ppm:
                result = encode_ppm(image, options);
                break;
            case FileFormat::exr:
#if defined(GLINT_WITH_EXR)
                result = encode_exr(image);
#else
                result.error = "this build writes no OpenEXR";
#endif
                break;
        }
    });
    if (!error.empty()) result = {{}, std::move(error)};
    return result;
}

EncodeResult encode_layers(const Image& picture, std::span<const LayerImage> layers) {
    EncodeResult result;
    std::string error = catch_exceptions([&] {
        result.error = fault(picture, {});
        if (result.error.empty()) result.error = layers_fault(picture, layers);
        if (!result.error.empty()) return;
#if defined(GLINT_WITH_EXR)
        result = encode_exr_layers(picture, layers);
#else
        result.error = "this build writes no OpenEXR";
#endif
    });
    if (!error.empty()) result = {{}, std::move(error)};
    return result;
}

}  // namespace glint
