// Choosing the encoder, and the whole numbers that a file holds.
#include <cstddef>
#include <utility>

#include "base/fp_environment.h"
#include "base/guard.h"
#include "glint/image.h"
#include "image/encoders.h"
#include "image/quantize.h"
#include "math/elementary.h"

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
    return {};
}

}  // namespace

double srgb_encode(double linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    if (linear <= 0.0031308) return 12.92 * linear;
    return 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

std::uint32_t to_number(float value, int bits, Transfer transfer) {
    const DefaultFpEnvironment environment;
    std::uint8_t bytes[2] = {};
    quantize_row(&value, 1, bits, transfer, bytes);
    return bits == 8 ? bytes[0] : bytes[0] * 256u + bytes[1];
}

std::uint8_t to_byte(float value, Transfer transfer) {
    return static_cast<std::uint8_t>(to_number(value, 8, transfer));
}

void quantize_row(const float* values, std::size_t count, int bits, Transfer transfer, std::uint8_t* out) {
    const auto each = [=](auto curve) {
        if (bits == 8) {
            for (std::size_t i = 0; i < count; ++i) {
                out[i] = static_cast<std::uint8_t>(quantize(curve(static_cast<double>(values[i])), 255));
            }
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t word = quantize(curve(static_cast<double>(values[i])), 65535);
            out[2 * i] = static_cast<std::uint8_t>(word >> 8);
            out[2 * i + 1] = static_cast<std::uint8_t>(word);
        }
    };
    if (transfer == Transfer::srgb) {
        each(srgb_encode);
    } else {
        each([](double value) { return value; });
    }
}

EncodeResult encode(const Image& image, const EncodeOptions& options) {
    EncodeResult result;
    std::string error = guard([&] {
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
    std::string error = guard([&] {
        result.error = fault(picture, {});
        for (const LayerImage& layer : layers) {
            if (!result.error.empty()) return;
            if (layer.width != picture.width || layer.height != picture.height ||
                layer.values.size() != picture.rgb.size() / 3 * static_cast<std::size_t>(layer.channels))
                result.error = "a layer has not the picture's size";
        }
#if defined(GLINT_WITH_EXR)
        if (result.error.empty()) result = encode_exr_layers(picture, layers);
#else
        result.error = "this build writes no OpenEXR";
#endif
    });
    if (!error.empty()) result = {{}, std::move(error)};
    return result;
}

}  // namespace glint
