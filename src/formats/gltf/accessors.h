// SPDX-License-Identifier: Apache-2.0
#pragma once
// Accessors: numbers in buffers, interleaved, sparse and normalised (glTF 2.0, sections 3.6.2 and 3.11).
#include <array>
#include <cstring>
#include <memory>
#include <optional>

#include "formats/gltf/buffers.h"

namespace glint::gltf {

/// The values of `componentType`.
enum class ComponentType : std::uint16_t {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126
};

/// SCALAR to VEC4, and MAT4.
inline constexpr std::uint32_t k_max_components = 16;

/// Its elements are all within the bytes of its buffers.
struct Accessor {
    std::uint32_t number = 0;  ///< in `accessors`
    JsonValue at;
    std::uint64_t count = 0;
    std::uint32_t components = 1;  ///< of an element
    ComponentType type = ComponentType::float32;
    bool is_normalized = false;
    std::string_view bytes;    ///< from the first element on; empty: zeros
    std::uint64_t stride = 0;  ///< bytes from an element to the next

    /// The elements that a sparse accessor replaces, ascending, and their values, one after the other.
    CountedVector<std::uint32_t> sparse_indices;
    std::string_view sparse_values;

    /// The first `N` components of an element, as numbers in single precision; missing ones are left.
    template <std::size_t N> void read(std::uint64_t element, std::array<float, N>& values) const;
    /// An element of unsigned whole numbers.
    std::uint32_t whole(std::uint64_t element) const;

  private:
    const char* element_at(std::uint64_t element) const;
    float component(const char* bytes, std::uint32_t index) const;
};

class Accessors {
  public:
    Accessors(File& file, Buffers& buffers)
        : file_(file), buffers_(buffers), known_(file.count(List::accessors)) {}

    /// The accessor with a number of components from `least` to `most`. Null after an error.
    const Accessor* open(JsonValue index, std::uint32_t least, std::uint32_t most);
    /// One of unsigned whole numbers. Null after an error.
    const Accessor* open_indices(JsonValue index);

  private:
    struct Known {
        bool is_read = false;
        std::shared_ptr<const Accessor> accessor;
    };
    const Accessor* read(JsonValue index);
    bool read_header(Accessor& accessor);
    bool read_view(Accessor& accessor);
    bool read_sparse(Accessor& accessor, JsonValue sparse);
    bool read_part(JsonValue part, std::uint64_t size, std::string_view& bytes);
    bool error(const Accessor& accessor, JsonValue at, std::string_view message);

    File& file_;
    Buffers& buffers_;
    CountedVector<Known> known_;
};

std::uint32_t size_of(ComponentType type);

inline float Accessor::component(const char* from, std::uint32_t index) const {
    // Normalised whole numbers: glTF 2.0, section 3.11.
    const auto read_as = [&](auto value, float greatest) {
        std::memcpy(&value, from + index * sizeof value, sizeof value);
        const auto number = static_cast<float>(value);
        if (!is_normalized) return number;
        const float share = number / greatest;
        return share < -1 ? -1 : share;
    };
    switch (type) {
        case ComponentType::int8:
            return read_as(std::int8_t{}, 127);
        case ComponentType::uint8:
            return read_as(std::uint8_t{}, 255);
        case ComponentType::int16:
            return read_as(std::int16_t{}, 32767);
        case ComponentType::uint16:
            return read_as(std::uint16_t{}, 65535);
        case ComponentType::uint32:
            return read_as(std::uint32_t{}, 4294967295.0F);
        case ComponentType::float32:
            break;
    }
    float value = 0;
    std::memcpy(&value, from + index * sizeof value, sizeof value);
    return value;
}

template <std::size_t N> void Accessor::read(std::uint64_t element, std::array<float, N>& values) const {
    const char* const from = element_at(element);
    const std::uint32_t n = components < N ? components : static_cast<std::uint32_t>(N);
    for (std::uint32_t i = 0; i < n; ++i) values[i] = from == nullptr ? 0 : component(from, i);
}

}  // namespace glint::gltf
