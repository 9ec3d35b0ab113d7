// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "base/text.h"

namespace glint::gltf {
namespace {

static_assert(std::endian::native == std::endian::little);

// Of an accessor without bytes, which a short file could otherwise ask for in any number.
constexpr std::uint64_t k_max_zeros = std::uint64_t{1} << 20;
constexpr std::uint64_t k_max_count = 0xffffffff;  // 2^32 - 1 vertices, so that their numbers are below it

constexpr std::pair<std::string_view, std::uint32_t> k_types[] = {
    {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};

std::optional<ComponentType> component_type(std::uint64_t number) {
    constexpr ComponentType all[] = {ComponentType::int8,   ComponentType::uint8,  ComponentType::int16,
                                     ComponentType::uint16, ComponentType::uint32, ComponentType::float32};
    const auto* const found = std::find_if(std::begin(all), std::end(all), [&](ComponentType type) {
        return static_cast<std::uint64_t>(type) == number;
    });
    return found == std::end(all) ? std::nullopt : std::optional(*found);
}

bool is_unsigned(ComponentType type) {
    return type == ComponentType::uint8 || type == ComponentType::uint16 || type == ComponentType::uint32;
}

std::uint32_t whole_at(const char* from, ComponentType type) {
    std::uint32_t value = 0;  // little-endian: the upper bytes stay 0
    std::memcpy(&value, from, size_of(type));
    return value;
}

}  // namespace

std::uint32_t size_of(ComponentType type) {
    switch (type) {
        case ComponentType::int8:
        case ComponentType::uint8:
            return 1;
        case ComponentType::int16:
        case ComponentType::uint16:
            return 2;
        case ComponentType::uint32:
        case ComponentType::float32:
            return 4;
    }
    return 4;
}

const char* Accessor::element_at(std::uint64_t element) const {
    if (!sparse_indices.empty()) {
        const auto found = std::lower_bound(sparse_indices.begin(), sparse_indices.end(), element);
        if (found != sparse_indices.end() && *found == element) {
            const auto i = static_cast<std::size_t>(found - sparse_indices.begin());
            return sparse_values.data() + i * components * size_of(type);
        }
    }
    return bytes.empty() ? nullptr : bytes.data() + element * stride;
}

std::uint32_t Accessor::whole(std::uint64_t element) const {
    const char* const from = element_at(element);
    return from == nullptr ? 0 : whole_at(from, type);
}

bool Accessors::error(const Accessor& accessor, JsonValue at, std::string_view message) {
    return file_.error(at, fmt::format("{}: {}", File::name(List::accessors, accessor.number), message));
}

const Accessor* Accessors::open(JsonValue index, std::uint32_t least, std::uint32_t most) {
    const Accessor* const accessor = read(index);
    if (accessor == nullptr) return nullptr;
    if (accessor->components >= least && accessor->components <= most) return accessor;
    error(*accessor, accessor->at,
          fmt::format("expected elements of {} numbers, found {}",
                      least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most),
                      accessor->components));
    return nullptr;
}

const Accessor* Accessors::open_indices(JsonValue index) {
    const Accessor* const accessor = open(index, 1, 1);
    if (accessor == nullptr) return nullptr;
    if (is_unsigned(accessor->type) && !accessor->is_normalized) return accessor;
    error(*accessor, accessor->at, "expected unsigned whole numbers as the numbers of vertices");
    return nullptr;
}

const Accessor* Accessors::read(JsonValue value) {
    const std::optional<std::uint32_t> index = file_.index(value, List::accessors);
    if (!index) return nullptr;
    Known& known = known_[*index];
    if (known.is_read) return known.accessor.get();
    known.is_read = true;
    const auto accessor = make_counted<Accessor>();
    accessor->number = *index;
    accessor->at = file_.item(List::accessors, *index);
    const JsonValue sparse = accessor->at.find("sparse");
    if (!read_header(*accessor) || !read_view(*accessor)) return nullptr;
    if (sparse.exists() && !read_sparse(*accessor, sparse)) return nullptr;
    known.accessor = accessor;
    return known.accessor.get();
}

bool Accessors::read_header(Accessor& accessor) {
    const JsonValue at = accessor.at;
    std::uint64_t type = 0;
    if (!file_.whole(at, "count", accessor.count) || !file_.whole(at, "componentType", type) ||
        !file_.flag(at, "normalized", accessor.is_normalized))
        return false;
    for (const std::string_view key : {"componentType", "count", "type"}) {
        if (!at.find(key).exists()) return error(accessor, at, fmt::format("expected `{}`", key));
    }
    if (accessor.count >= k_max_count || accessor.count == 0)
        return file_.expected(at.find("count"), "a number from 1 to 4294967294", "count");
    const std::optional<ComponentType> known_type = component_type(type);
    if (!known_type)
        return file_.expected(at.find("componentType"), "5120, 5121, 5122, 5123, 5125 or 5126",
                              "componentType");
    accessor.type = *known_type;
    const std::string name = at.find("type").string();
    const auto* const shape = std::find_if(std::begin(k_types), std::end(k_types),
                                           [&](const auto& entry) { return entry.first == name; });
    if (shape == std::end(k_types))
        return file_.expected(at.find("type"), "SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4", "type");
    accessor.components = shape->second;
    return true;
}

bool Accessors::read_view(Accessor& accessor) {
    const std::uint64_t size = std::uint64_t{accessor.components} * size_of(accessor.type);
    accessor.stride = size;
    const JsonValue index = accessor.at.find("bufferView");
    if (!index.exists()) {
        return accessor.count <= k_max_zeros ||
               error(accessor, accessor.at, fmt::format("expected at most {} zeros", k_max_zeros));
    }
    const std::optional<BufferView> view = buffers_.view(index);
    std::uint64_t offset = 0;
    if (!view || !file_.whole(accessor.at, "byteOffset", offset)) return false;
    if (view->stride != 0) {
        if (view->stride < size)
            return file_.expected(view->at.find("byteStride"), fmt::format("at least {} bytes", size),
                                  "byteStride");
        accessor.stride = view->stride;
    }
    const std::uint64_t all = view->bytes.size();
    // Division, as the product of two numbers of the file may overflow.
    const bool fits = offset <= all && size <= all - offset &&
                      (accessor.count - 1) <= (all - offset - size) / accessor.stride;
    if (!fits)
        return error(
            accessor, accessor.at,
            fmt::format("expected {} elements of {} bytes from byte {} on, found a buffer view of {} "
                        "bytes",
                        accessor.count, size, offset, all));
    accessor.bytes = view->bytes.substr(static_cast<std::size_t>(offset));
    return true;
}

// The bytes of a sparse accessor's `indices` or `values`.
bool Accessors::read_part(JsonValue part, std::uint64_t size, std::string_view& bytes) {
    const JsonValue index = part.find("bufferView");
    if (!index.exists()) return file_.expected(part, "an object with a `bufferView`");
    const std::optional<BufferView> view = buffers_.view(index);
    std::uint64_t offset = 0;
    if (!view || !file_.whole(part, "byteOffset", offset)) return false;
    if (offset > view->bytes.size() || size > view->bytes.size() - offset)
        return file_.error(
            part, fmt::format("expected {} bytes from byte {} on, found a buffer view of {} bytes", size,
                              offset, view->bytes.size()));
    bytes = view->bytes.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
    return true;
}

bool Accessors::read_sparse(Accessor& accessor, JsonValue sparse) {
    const JsonValue indices = sparse.find("indices"), values = sparse.find("values");
    std::uint64_t count = 0, type_number = 0;
    if (!file_.whole(sparse, "count", count) || !file_.whole(indices, "componentType", type_number))
        return false;
    if (count == 0 || count > accessor.count)
        return file_.error(sparse,
                           fmt::format("{}: expected a `count` from 1 to {}, found {}",
                                       File::name(List::accessors, accessor.number), accessor.count, count));
    const std::optional<ComponentType> type = component_type(type_number);
    if (!type || !is_unsigned(*type))
        return file_.expected(indices.exists() ? indices : sparse,
                              "`indices` of componentType 5121, 5123 or 5125");
    std::string_view numbers;
    if (!read_part(indices, count * size_of(*type), numbers) ||
        !read_part(values, count * accessor.components * size_of(accessor.type), accessor.sparse_values))
        return false;
    accessor.sparse_indices.reserve(static_cast<std::size_t>(count));
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint32_t index = whole_at(numbers.data() + i * size_of(*type), *type);
        const bool ascends = accessor.sparse_indices.empty() || accessor.sparse_indices.back() < index;
        if (!ascends || index >= accessor.count)
            return file_.error(indices,
                               fmt::format("expected ascending numbers of elements from 0 to {}, found {} as "
                                           "number {}",
                                           accessor.count - 1, index, i));
        accessor.sparse_indices.push_back(index);
    }
    return true;
}

}  // namespace glint::gltf
