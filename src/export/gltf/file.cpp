// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/base64.h"
#include "base/status.h"
#include "glint/version.h"

namespace glint::gltf_export {
namespace {

// The numbers of OpenGL.
constexpr int k_float = 5126, k_unsigned_short = 5123, k_unsigned_int = 5125;
constexpr std::uint32_t k_vertices = 34962, k_triangles = 34963;
constexpr std::string_view k_names[k_lists] = {"nodes",  "cameras",  "meshes",    "materials",   "textures",
                                               "images", "samplers", "accessors", "bufferViews", "lights"};
constexpr std::string_view k_types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};

void append32(std::string& out, std::uint64_t number) {
    for (int i = 0; i < 4; ++i) out += static_cast<char>(number >> (8 * i) & 0xff);
}

void append_chunk(std::string& out, std::string_view type, std::string_view bytes, char filler) {
    const std::size_t padded = (bytes.size() + 3) / 4 * 4;
    append32(out, padded);
    out += type;
    out += bytes;
    out.append(padded - bytes.size(), filler);
}

}  // namespace

std::string dumped(const Json& value) {
    return value.dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace);
}

std::uint32_t File::add(List list, const Json& item) {
    Items& items = lists_[static_cast<std::size_t>(list)];
    if (items.count > 0) items.text += ",\n";
    items.text += dumped(item);
    return items.count++;
}

std::uint32_t File::add_view(const void* data, std::size_t bytes, std::uint32_t target) {
    Json view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes}};
    if (target != 0) view["target"] = target;
    const auto* const from = static_cast<const std::uint8_t*>(data);
    buffer_.insert(buffer_.end(), from, from + bytes);
    buffer_.resize((buffer_.size() + 3) / 4 * 4);  // numbers of four bytes are at multiples of four
    return add(List::views, view);
}

std::uint32_t File::add_view(std::span<const std::uint8_t> bytes) {
    return add_view(bytes.data(), bytes.size(), 0);
}

std::uint32_t File::add_floats(std::span<const float> values, std::uint32_t components, bool with_bounds) {
    static_assert(std::endian::native == std::endian::little);
    Json accessor{{"bufferView", add_view(values.data(), values.size_bytes(), k_vertices)},
                  {"componentType", k_float},
                  {"count", values.size() / components},
                  {"type", std::string(k_types[components])}};
    if (with_bounds) {
        Json low = Json::array(), high = Json::array();
        for (std::size_t c = 0; c < components; ++c) {
            float least = values[c], most = values[c];
            for (std::size_t i = c; i < values.size(); i += components) {
                least = std::min(least, values[i]);
                most = std::max(most, values[i]);
            }
            low.push_back(least);
            high.push_back(most);
        }
        accessor["min"] = std::move(low);
        accessor["max"] = std::move(high);
    }
    return add(List::accessors, accessor);
}

std::uint32_t File::add_indices(std::span<const TriangleCorners> triangles, std::size_t vertices) {
    std::uint32_t view = 0;
    const bool is_short = vertices < 65536;  // 65535 restarts a strip
    if (is_short) {
        std::vector<std::uint16_t> numbers;
        numbers.reserve(3 * triangles.size());
        for (const TriangleCorners& triangle : triangles)
            for (const std::uint32_t corner : triangle) numbers.push_back(static_cast<std::uint16_t>(corner));
        view = add_view(numbers.data(), 2 * numbers.size(), k_triangles);
    } else {
        view = add_view(triangles.data(), triangles.size_bytes(), k_triangles);
    }
    return add(List::accessors, {{"bufferView", view},
                                 {"componentType", is_short ? k_unsigned_short : k_unsigned_int},
                                 {"count", 3 * triangles.size()},
                                 {"type", "SCALAR"}});
}

std::string File::json(bool is_binary) const {
    std::string out = "{\"asset\":" + dumped({{"version", "2.0"}, {"generator", "glint " GLINT_VERSION}});
    if (!extensions_.empty()) out += ",\n\"extensionsUsed\":" + dumped(extensions_);
    const auto of = [&](List list) -> const Items& { return lists_[static_cast<std::size_t>(list)]; };
    if (of(List::lights).count > 0)
        out += ",\n\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[\n" + of(List::lights).text + "]}}";
    out += ",\n\"scene\":0,\n\"scenes\":[{";
    for (std::uint32_t i = 0; i < of(List::nodes).count; ++i)
        fmt::format_to(std::back_inserter(out), "{}{}", i == 0 ? "\"nodes\":[" : ",", i);
    out += of(List::nodes).count > 0 ? "]}]" : "}]";
    for (std::size_t i = 0; i < k_lists; ++i) {
        if (lists_[i].count == 0 || i == static_cast<std::size_t>(List::lights)) continue;
        fmt::format_to(std::back_inserter(out), ",\n\"{}\":[\n", k_names[i]);
        out += lists_[i].text;
        out += ']';
    }
    if (!buffer_.empty()) {
        fmt::format_to(std::back_inserter(out), ",\n\"buffers\":[{{\"byteLength\":{}", buffer_.size());
        if (!is_binary) out += ",\"uri\":\"data:application/octet-stream;base64," + base64(buffer_) + '"';
        out += "}]";
    }
    return out += "}\n";
}

std::string File::finish(bool is_binary) && {
    std::string text = json(is_binary);
    if (!is_binary) return text;
    const std::uint64_t length =
        12 + 8 + (text.size() + 3) / 4 * 4 + (buffer_.empty() ? 0 : 8 + buffer_.size());
    if (length > UINT32_MAX)
        throw StatusError(failure(ErrorCode::invalid_scene,
                                  "a .glb file has at most 4 GiB, and the scene needs more: write a .gltf"));
    std::string out;
    out.reserve(static_cast<std::size_t>(length));
    out += "glTF";
    append32(out, 2);
    append32(out, length);
    append_chunk(out, "JSON", text, ' ');
    if (!buffer_.empty())
        append_chunk(out, std::string_view("BIN\0", 4),
                     {reinterpret_cast<const char*>(buffer_.data()), buffer_.size()}, '\0');
    return out;
}

}  // namespace glint::gltf_export
