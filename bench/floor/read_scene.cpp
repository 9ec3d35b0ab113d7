// SPDX-License-Identifier: Apache-2.0
#include "read_scene.h"

#include <cstdio>
#include <fstream>
#include <iterator>

namespace glint_floor {

namespace {

glint::Result<std::string> read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return glint::Status{glint::ErrorCode::io, path + ": no such file", {}};
    return std::string{std::istreambuf_iterator<char>(file), {}};
}

class FilesBeside : public glint::Sources {
  public:
    glint::Result<std::string> read(std::string_view name, std::string_view from) override {
        return read_text(std::string(from.substr(0, from.find_last_of('/') + 1)) + std::string(name));
    }
};

}  // namespace

glint::Result<glint::Scene> read_scene(const std::string& path) {
    const glint::Result<std::string> text = read_text(path);
    if (!text) return glint::Status(text);
    const glint::SceneText source{path, *text, {}};
    FilesBeside files;
    return glint::load({&source, 1}, {}, &files);
}

int fail(const char* program, const glint::Status& status) {
    std::fprintf(stderr, "%s: %s", program, to_string(status).c_str());
    return 1;
}

}  // namespace glint_floor
