// The browser's door compiled for this machine: native_door X Y WIDTH HEIGHT reads a request from standard
// input and writes the rectangle's floats to standard output, for the tests to compare.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>

#include "wasm/door.h"

int main(int argc, char** argv) {
    if (argc != 5) return 2;
    const std::string request{std::istreambuf_iterator<char>(std::cin), {}};
    GlintScene* const scene = glint_open(request.data(), static_cast<std::uint32_t>(request.size()));
    const int width = std::atoi(argv[3]), height = std::atoi(argv[4]);
    const float* const rgb = glint_render(scene, std::atoi(argv[1]), std::atoi(argv[2]), width, height);
    if (rgb == nullptr) std::fprintf(stderr, "%s\n", glint_report(scene));
    const std::size_t floats = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const bool written = rgb != nullptr && std::fwrite(rgb, sizeof(float), floats, stdout) == floats;
    glint_close(scene);
    return written ? 0 : 1;
}
