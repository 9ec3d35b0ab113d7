// SPDX-License-Identifier: Apache-2.0
// The browser's API, compiled natively for comparison. A request comes from standard
// input:
//   native_api render X Y WIDTH HEIGHT    writes the rectangle's floats to standard output
//   native_api png|exr                    the file of the picture, by encode()
//   native_api explain X Y                the pixel's explanation
//   native_api info, convert, check       the results of glint_info, glint_convert and glint_check
//   native_api diagnose LOG               that of glint_diagnose for a log in a file
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "wasm/api.h"
#include "wasm/request.h"

void glint_progress(double) {}

namespace {

bool write(const void* data, std::size_t bytes) { return std::fwrite(data, 1, bytes, stdout) == bytes; }
bool write(const std::string& text) { return write(text.data(), text.size()); }

bool render(GlintScene* scene, int x, int y, int width, int height) {
    const float* const rgb = glint_render(scene, x, y, width, height);
    if (rgb == nullptr) std::fprintf(stderr, "%s\n", glint_report(scene));
    return rgb != nullptr &&
           write(rgb, 3 * sizeof(float) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

const char* diagnose(GlintScene* scene, const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::string log{std::istreambuf_iterator<char>(file), {}};
    return glint_diagnose(scene, log.data(), static_cast<std::uint32_t>(log.size()), "mine.log", 8);
}

bool write_file(const std::string& request, glint::FileFormat format) {
    const nlohmann::json parsed = nlohmann::json::parse(request);
    const glint::wasm::RequestTexts texts = glint::wasm::read_texts(parsed);
    std::vector<std::string> missing;
    const auto scene = glint::wasm::load(texts, parsed, missing);
    const auto world = scene ? glint::prepare(**scene) : glint::Result<glint::World>(glint::Status(scene));
    if (!world) return false;
    glint::RenderOptions options;
    if ((*scene)->settings.alpha) options.layers = {glint::Layer::alpha};
    const auto made = glint::render(*world, options);
    if (!made) return false;
    glint::EncodeOptions file;
    file.set_rule(made->rule);
    file.format = format;
    const auto bytes = made->has_alpha ? glint::encode(made->image, made->layers[0].values, file)
                                       : glint::encode(made->image, file);
    return bytes && write(bytes->data(), bytes->size());
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    const auto number = [&](int i) { return i < argc ? std::atoi(argv[i]) : 0; };
    const std::string request{std::istreambuf_iterator<char>(std::cin), {}};
    GlintScene* const scene = glint_open(request.data(), static_cast<std::uint32_t>(request.size()));
    bool done = false;
    if (what == "render") done = render(scene, number(2), number(3), number(4), number(5));
    if (what == "png") done = write_file(request, glint::FileFormat::png);
    if (what == "exr") done = write_file(request, glint::FileFormat::exr);
    if (what == "explain") done = write(glint_explain(scene, number(2), number(3)));
    if (what == "info") done = write(glint_info(scene));
    if (what == "check") done = write(glint_check(scene));
    if (what == "diagnose" && argc > 2) done = write(diagnose(scene, argv[2]));
    if (what == "convert") done = write(glint_convert(scene));
    glint_close(scene);
    return done ? 0 : 1;
}
