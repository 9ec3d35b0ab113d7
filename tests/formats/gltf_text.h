// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small files of glTF for tests.
#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "formats/load_text.h"

namespace glint::test {

inline std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k > count ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

template <class T> std::string bytes_of(std::initializer_list<T> values) {
    return {reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(T)};
}

/// The members of a file, and the bytes of its buffer.
struct GltfText {
    std::map<std::string, std::string> members{{"asset", R"({"version": "2.0"})"}};
    std::vector<std::string> views, accessors;
    std::string bytes;

    int view(const std::string& of, const std::string& more = {}) {
        views.push_back(fmt::format(R"({{"buffer": 0, "byteOffset": {}, "byteLength": {}{}}})", bytes.size(),
                                    of.size(), more));
        bytes += of;
        bytes.resize((bytes.size() + 3) / 4 * 4);
        return static_cast<int>(views.size()) - 1;
    }
    /// type: "VEC3", component: 5126, more: ", \"normalized\": true".
    int accessor(int view, int count, int component, const char* type, const std::string& more = {}) {
        const std::string of = view < 0 ? std::string() : fmt::format(R"("bufferView": {}, )", view);
        accessors.push_back(fmt::format(R"({{{}"componentType": {}, "count": {}, "type": "{}"{}}})", of,
                                        component, count, type, more));
        return static_cast<int>(accessors.size()) - 1;
    }
    int floats(const char* type, int count, std::initializer_list<float> values) {
        return accessor(view(bytes_of(values)), count, 5126, type);
    }
    std::string json(const std::string& buffer) const {
        std::string text = "{\n";
        for (const auto& [key, value] : members) text += fmt::format("\"{}\": {},\n", key, value);
        text += fmt::format("\"accessors\": [{}],\n", fmt::join(accessors, ",\n"));
        text += fmt::format("\"bufferViews\": [{}],\n", fmt::join(views, ",\n"));
        text += fmt::format("\"buffers\": [{{\"byteLength\": {}{}}}]\n}}\n", bytes.size(), buffer);
        return text;
    }
    std::string text() const {
        return json(", \"uri\": \"data:application/octet-stream;base64," + base64(bytes) + "\"");
    }
    std::string binary() const {
        std::string chunk = json({});
        chunk.resize((chunk.size() + 3) / 4 * 4, ' ');
        const auto word = [](std::size_t value) { return bytes_of({static_cast<std::uint32_t>(value)}); };
        return "glTF" + word(2) + word(28 + chunk.size() + bytes.size()) + word(chunk.size()) + "JSON" +
               chunk + word(bytes.size()) + std::string("BIN\0", 4) + bytes;
    }
};

/// A square of two triangles, (0, 0) to (1, 1), with normals; its material is number 0 if it has one.
inline GltfText gltf_square(const std::string& material = {}) {
    GltfText file;
    const int positions = file.floats("VEC3", 4, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int normals = file.floats("VEC3", 4, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int indices =
        file.accessor(file.view(bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3})), 6, 5123, "SCALAR");
    file.members["meshes"] = fmt::format(
        R"([{{"primitives": [{{"attributes": {{"POSITION": {}, "NORMAL": {}}}, "indices": {}{}}}]}}])",
        positions, normals, indices, material.empty() ? "" : ", \"material\": 0");
    if (!material.empty()) file.members["materials"] = "[" + material + "]";
    file.members["nodes"] = R"([{"mesh": 0}])";
    file.members["scenes"] = R"([{"nodes": [0]}])";
    return file;
}

}  // namespace glint::test
