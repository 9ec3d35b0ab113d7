// SPDX-License-Identifier: Apache-2.0
// Selects the encoder.
#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "base/parallel_for.h"
#include "base/status.h"
#include "glint/conventions.h"
#include "glint/image.h"
#include "image/encoders.h"
#include "image/layer_fault.h"
#include "image/memory_file.h"

namespace glint {
namespace {

constexpr std::int32_t k_max_jpeg = 65500;                       // libjpeg's limit
constexpr std::int64_t k_max_bmp = (std::int64_t{1} << 32) / 4;  // pixels, with the ends of rows

// What a format cannot do.
struct FormatLimits {
    const char* name;
    bool is_built, has_alpha, has_16_bits;
};

#if defined(GLINT_WITH_PNG)
constexpr bool k_has_png = true;
#else
constexpr bool k_has_png = false;
#endif
#if defined(GLINT_WITH_JPEG)
constexpr bool k_has_jpeg = true;
#else
constexpr bool k_has_jpeg = false;
#endif
#if defined(GLINT_WITH_EXR)
constexpr bool k_has_exr = true;
#else
constexpr bool k_has_exr = false;
#endif

FormatLimits limits_of(FileFormat format) {
    switch (format) {
        case FileFormat::png:
            return {"PNG", k_has_png, true, true};
        case FileFormat::exr:
            return {"OpenEXR", k_has_exr, true, true};
        case FileFormat::ppm:
            return {"PPM", true, false, true};
        case FileFormat::tga:
            return {"TGA", true, false, false};
        case FileFormat::bmp:
            return {"BMP", true, false, false};
        case FileFormat::jpeg:
            break;
    }
    return {"JPEG", k_has_jpeg, false, false};
}

// The reason why no encoder can write the picture, or an empty string.
std::string fault(const Image& image, const EncodeOptions& options, bool alpha = false) {
    std::string wrong = encoding_fault(image.width, image.height, options, alpha);
    if (wrong.empty() && image.rgb.size() != std::size_t{3} * image.width * image.height)
        wrong = "the picture's numbers do not fit its size";
    return wrong;
}

std::string alpha_fault(const Image& image, std::span<const float> alpha) {
    if (alpha.size() == image.rgb.size() / 3) return {};
    return "alpha has " + std::to_string(alpha.size()) + " numbers, and the picture " +
           std::to_string(image.rgb.size() / 3) + " pixels";
}

std::string layers_fault(const Image& picture, std::span<const LayerImage> layers) {
    std::set<Layer> seen;
    for (const LayerImage& layer : layers) {
        if (std::string wrong = layer_fault(layer); !wrong.empty()) return wrong;
        if (layer.width != picture.width || layer.height != picture.height)
            return "a layer has not the picture's size";
        if (!seen.insert(layer.layer).second)
            return "the layer '" + layer_name(layer.layer) + "' is there twice";
    }
    return {};
}

// Strips in parallel: all are in memory together.
std::vector<std::uint8_t> encode_strips(const Image& image, std::span<const float> alpha,
                                        const EncodeOptions& options) {
    std::vector<std::uint8_t> bytes;
    MemoryFile file(bytes);
    const std::unique_ptr<StripEncoder> encoder =
        make_strip_encoder(image.width, image.height, options, file, !alpha.empty());
    const std::size_t strip_floats =
        std::size_t{3} * static_cast<std::size_t>(image.width) * std::size_t{k_strip_rows};
    std::vector<EncodedStrip> strips(static_cast<std::size_t>(count_strips(image.height)));
    std::vector<Status> statuses(strips.size());
    parallel_for(strips.size(), options.threads, [&](std::size_t i) {
        statuses[i] = status_of([&] {
            const std::size_t first = i * strip_floats;
            const std::span<const float> rows(image.rgb.data() + first,
                                              std::min(strip_floats, image.rgb.size() - first));
            if (alpha.empty()) {
                strips[i] = encoder->encode(static_cast<std::int32_t>(i), rows);
            } else {
                strips[i] = encoder->encode(static_cast<std::int32_t>(i),
                                            with_alpha(rows, alpha.subspan(first / 3, rows.size() / 3)));
            }
        });
    });
    std::size_t total = 0;
    for (std::size_t i = 0; i < strips.size(); ++i) {
        if (!statuses[i].ok()) throw StatusError(statuses[i]);
        total += strips[i].bytes.size();
    }
    bytes.reserve(bytes.size() + total + 100);
    for (EncodedStrip& strip : strips) encoder->append(std::move(strip));
    encoder->finish();
    return bytes;
}

}  // namespace

std::string encoding_fault(std::int32_t width, std::int32_t height, const EncodeOptions& options,
                           bool alpha) {
    if (width < 1 || height < 1 || width > k_max_size || height > k_max_size)
        return "a picture has 1 to " + std::to_string(k_max_size) + " pixels a side";
    if (options.format > FileFormat::jpeg) return "there is no such file format";
    const FormatLimits limits = limits_of(options.format);
    if (!limits.is_built) return "this build writes no " + std::string(limits.name);
    if (options.bits != 8 && options.bits != 16) return "a channel has 8 or 16 bits";
    if (options.bits != 8 && !limits.has_16_bits) return std::string(limits.name) + " has 8 bits a channel";
    if (options.jpeg_quality < 1 || options.jpeg_quality > 100) return "JPEG's quality is from 1 to 100";
    if (options.format == FileFormat::jpeg && (width > k_max_jpeg || height > k_max_jpeg))
        return "JPEG has at most " + std::to_string(k_max_jpeg) + " pixels a side";
    if (options.format == FileFormat::bmp && std::int64_t{width} * height > k_max_bmp)
        return "BMP has at most 4 GiB";
    if (options.transfer > Transfer::srgb) return "there is no such transfer curve";
    if (options.rounding > Rounding::down) return "there is no such rounding";
    if (!(options.gamma > 0 && options.gamma <= 100)) return "gamma: expected a number > 0 and at most 100";
    if (!alpha || limits.has_alpha) return {};
    const bool can_have = options.format == FileFormat::tga || options.format == FileFormat::bmp;
    return can_have ? "glint writes " + std::string(limits.name) + " without alpha"
                    : std::string(limits.name) + " has no alpha channel";
}

std::unique_ptr<StripEncoder> make_strip_encoder(std::int32_t width, std::int32_t height,
                                                 const EncodeOptions& options, ByteFile& file, bool alpha) {
    if (std::string wrong = encoding_fault(width, height, options, alpha); !wrong.empty())
        throw StatusError(invalid_argument(std::move(wrong)));
    switch (options.format) {
        case FileFormat::ppm:
            return make_ppm_encoder(width, height, options, file);
        case FileFormat::tga:
            return make_tga_encoder(width, height, options, file);
        case FileFormat::bmp:
            return make_bmp_encoder(width, height, options, file);
        case FileFormat::png:
#if defined(GLINT_WITH_PNG)
            return make_png_encoder(width, height, options, file, alpha);
#else
            break;
#endif
        case FileFormat::jpeg:
#if defined(GLINT_WITH_JPEG)
            return make_jpeg_encoder(width, height, options, file);
#else
            break;
#endif
        case FileFormat::exr:
#if defined(GLINT_WITH_EXR)
            return make_exr_encoder(width, height, file, alpha);
#else
            break;
#endif
    }
    return nullptr;
}

#if !defined(GLINT_WITH_EXR)
std::unique_ptr<PartsEncoder> make_parts_encoder(std::int32_t, std::int32_t, std::span<const Layer>,
                                                 ByteFile&, bool) {
    return nullptr;
}
#endif

std::vector<float> with_alpha(std::span<const float> rgb, std::span<const float> alpha) {
    std::vector<float> rgba(4 * alpha.size());
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        std::copy_n(rgb.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                    rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
        rgba[4 * i + 3] = alpha[i];
    }
    return rgba;
}

namespace {

// alpha: empty, or of the picture's size.
std::vector<std::uint8_t> encode_checked(const Image& image, std::span<const float> alpha,
                                         const EncodeOptions& options) {
#if defined(GLINT_WITH_EXR)
    if (options.format == FileFormat::exr) return encode_exr(image, alpha);
#endif
    return encode_strips(image, alpha, options);
}

}  // namespace

Result<std::vector<std::uint8_t>> encode(const Image& image, const EncodeOptions& options) {
    return result_of([&]() -> Result<std::vector<std::uint8_t>> {
        std::string wrong = fault(image, options);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        return encode_checked(image, {}, options);
    });
}

Result<std::vector<std::uint8_t>> encode(const Image& image, std::span<const float> alpha,
                                         const EncodeOptions& options) {
    return result_of([&]() -> Result<std::vector<std::uint8_t>> {
        std::string wrong = fault(image, options, true);
        if (wrong.empty()) wrong = alpha_fault(image, alpha);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        return encode_checked(image, alpha, options);
    });
}

Result<std::vector<std::uint8_t>> encode_layers(const Image& picture, std::span<const LayerImage> layers,
                                                std::span<const float> alpha) {
    return result_of([&]() -> Result<std::vector<std::uint8_t>> {
        std::string wrong = fault(picture, {.format = FileFormat::exr});
        if (wrong.empty()) wrong = layers_fault(picture, layers);
        if (wrong.empty() && !alpha.empty()) wrong = alpha_fault(picture, alpha);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
#if defined(GLINT_WITH_EXR)
        return encode_exr_layers(picture, layers, alpha);
#else
        return invalid_argument("this build writes no OpenEXR");
#endif
    });
}

}  // namespace glint
