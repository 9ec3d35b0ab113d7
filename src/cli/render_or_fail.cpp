// SPDX-License-Identifier: Apache-2.0
#include "cli/render_or_fail.h"

#include <fmt/format.h>

#include "cli/failure.h"
#include "cli/output_file.h"
#include "cli/scene_arguments.h"
#include "cli/text.h"

namespace glint::cli {

World prepare_or_fail(const Scene& scene, int threads) {
    Result<World> prepared = prepare(scene, {.threads = threads});
    if (prepared) return *std::move(prepared);
    print(prepared.diagnostics);
    throw_failure(prepared);
}

Image render_or_fail(const World& world, int threads, const std::string& isa) {
    RenderOptions options;
    options.threads = threads;
    options.isa = isa;
    Result<Rendering> result = render(world, options);
    if (!result) throw_failure(result);
    return std::move(result->image);
}

OutputFile png_output(const char* option, const std::string& path) {
    OutputFile output(option, path);
    if (!output.is_stream() && extension(path) != ".png")
        throw Failure(k_usage, fmt::format("{} '{}': expected a name that ends in .png", option, path));
    return output;
}

void write_png(const Image& picture, const OutputFile& output, EncodeOptions options) {
    options.format = FileFormat::png;
    const auto encoded = encode(picture, options);
    if (!encoded) throw Failure(k_bad_input, fmt::format("cannot encode the picture: {}", encoded.message));
    output.write(*encoded);
}

}  // namespace glint::cli
