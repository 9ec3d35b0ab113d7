// SPDX-License-Identifier: Apache-2.0
#pragma once
// A file of glTF 2.0 that is written: the lists of its JSON, and its buffer.
// The JSON library must not use <filesystem>, as in all modules.
#define JSON_HAS_FILESYSTEM 0
#define JSON_HAS_EXPERIMENTAL_FILESYSTEM 0
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/mesh.h"

namespace glint::gltf_export {

using Json = nlohmann::ordered_json;

inline constexpr std::uint32_t k_no_index = 0xffffffffu;

/// The lists of the JSON, in the order of the file; the last one is that of KHR_lights_punctual.
enum class List : std::uint8_t {
    nodes,
    cameras,
    meshes,
    materials,
    textures,
    images,
    samplers,
    accessors,
    views,
    lights
};
inline constexpr std::size_t k_lists = 10;

class File {
  public:
    /// The number of the new item. Items become text at once, which takes less memory.
    std::uint32_t add(List list, const Json& item);
    void use_extension(std::string_view name) { extensions_.emplace(name); }

    /// Accessors of float numbers; values: one row of `components` for each vertex.
    std::uint32_t add_floats(std::span<const float> values, std::uint32_t components, bool with_bounds);
    std::uint32_t add_indices(std::span<const TriangleCorners> triangles, std::size_t vertices);
    std::uint32_t add_view(std::span<const std::uint8_t> bytes);

    /// The bytes of a .glb, or of a .gltf with its buffer as a data URI. Throws StatusError if a .glb would
    /// be larger than 4 GiB, which its header cannot say.
    std::string finish(bool is_binary) &&;

  private:
    std::uint32_t add_view(const void* data, std::size_t bytes, std::uint32_t target);
    std::string json(bool is_binary) const;

    struct Items {
        std::string text;
        std::uint32_t count = 0;
    };
    std::array<Items, k_lists> lists_;
    std::set<std::string> extensions_;
    std::vector<std::uint8_t> buffer_;
};

/// The text of a JSON value; bytes that are not UTF-8 are replaced.
std::string dumped(const Json& value);

}  // namespace glint::gltf_export
