// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/file.h"

#include <fmt/format.h>

#include <cstring>

#include "base/text.h"

namespace glint::gltf {
namespace {

constexpr std::size_t k_header_size = 12, k_chunk_header_size = 8;
constexpr std::uint32_t k_json_chunk = 0x4E4F534A, k_binary_chunk = 0x004E4942;  // "JSON", "BIN\0"

std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

}  // namespace

bool File::open() {
    std::size_t offset = 0, length = text.place.text.size();
    if (text.place.text.starts_with("glTF") && !open_container(offset, length)) return false;
    json_ = read_json(reading.diagnostics, text.place, offset, length);
    if (!json_) return false;
    if (!root().is(JsonKind::object)) return expected(root(), "an object `{ ... }`");
    return check_version() && find_lists();
}

// Errors of the container are at the first byte: lines of binary numbers mean nothing.
bool File::container_error(std::size_t offset, std::string message) {
    reading.diagnostics.error(text.place, 0, 4, fmt::format("byte {}: {}", offset, message));
    return false;
}

// glTF 2.0, section 4: a header, then chunks; the first is the JSON, the second may be the binary buffer.
bool File::open_container(std::size_t& offset, std::size_t& length) {
    const std::string_view bytes = text.place.text;
    if (bytes.size() < k_header_size + k_chunk_header_size)
        return container_error(bytes.size(), "the file ends here, in its header");
    if (const std::uint32_t version = word_at(bytes, 4); version != 2)
        return container_error(4, fmt::format("expected version 2 of .glb, found {}", version));
    const std::size_t all = word_at(bytes, 8);
    if (all > bytes.size())
        return container_error(8, fmt::format("expected a file of {} bytes, found {}", all, bytes.size()));
    bool has_json = false;
    for (std::size_t at = k_header_size; at + k_chunk_header_size <= all;) {
        const std::size_t size = word_at(bytes, at), begin = at + k_chunk_header_size;
        const std::uint32_t kind = word_at(bytes, at + 4);
        if (size > all - begin)
            return container_error(
                at, fmt::format("expected a chunk of {} bytes, found room for {}", size, all - begin));
        if (!has_json) {
            if (kind != k_json_chunk) return container_error(at + 4, "expected the chunk JSON first");
            has_json = true;
            offset = begin;
            length = size;
        } else if (kind == k_binary_chunk && !chunk) {
            chunk = bytes.substr(begin, size);
        }
        at = begin + size;
    }
    if (!has_json) return container_error(k_header_size, "expected the chunk JSON");
    // Some programs fill it up with zeros instead of blanks.
    while (length > 0 && bytes[offset + length - 1] == '\0') --length;
    return true;
}

bool File::check_version() {
    const JsonValue asset = root().find("asset"), version = asset.find("version");
    if (!version.is(JsonKind::string))
        return expected(version.exists() ? version : root(), "the version of glTF as `asset.version`");
    if (!version.string().starts_with("2."))
        return error(version, fmt::format("expected glTF 2.0, found version {}", quoted(version.string())));
    if (const JsonValue least = asset.find("minVersion"); least.exists() && least.string() != "2.0")
        return error(least, fmt::format("expected glTF 2.0, found a file that needs version {}",
                                        quoted(least.string())));
    return true;
}

bool File::find_lists() {
    for (std::size_t i = 0; i < lists_.size(); ++i) {
        const JsonValue owner =
            static_cast<List>(i) == List::lights ? extension(root(), "KHR_lights_punctual") : root();
        const JsonValue list = owner.find(k_list_names[i]);
        if (!list.exists()) continue;
        if (!list.is(JsonKind::list)) return expected(list, "a list", k_list_names[i]);
        lists_[i].reserve(list.size());
        list.for_each([&](JsonValue value) { lists_[i].push_back(value); });
        for (const JsonValue value : lists_[i]) {
            if (!value.is(JsonKind::object)) return expected(value, "an object `{ ... }`");
        }
    }
    return go_on(root());
}

std::string File::name(List list, std::uint32_t index) {
    return fmt::format("{}[{}]", k_list_names[static_cast<std::size_t>(list)], index);
}

std::optional<std::uint32_t> File::index(JsonValue value, List list) {
    const double number = value.number();
    if (value.is(JsonKind::number) && number >= 0 && number < count(list)) {
        const auto whole = static_cast<std::uint32_t>(number);
        if (static_cast<double>(whole) == number) return whole;
    }
    const std::string_view what = k_list_names[static_cast<std::size_t>(list)];
    if (count(list) == 0) {
        expected(value, fmt::format("a number of `{}`, of which there are none", what));
    } else {
        expected(value, fmt::format("a number of `{}` from 0 to {}", what, count(list) - 1));
    }
    return std::nullopt;
}

bool File::number(JsonValue object, std::string_view key, double& value, const Range& range) {
    const JsonValue found = object.find(key);
    if (!found.exists()) return true;
    if (!found.is(JsonKind::number) || !range.contains(found.number()))
        return expected(found, range.text, key);
    value = found.number();
    return true;
}

bool File::whole(JsonValue object, std::string_view key, std::uint64_t& value) {
    const JsonValue found = object.find(key);
    if (!found.exists()) return true;
    const double number = found.number();
    if (!found.is(JsonKind::number) || !(number >= 0 && number <= k_max_whole) ||
        static_cast<double>(static_cast<std::uint64_t>(number)) != number)
        return expected(found, "a whole number of at least 0", key);
    value = static_cast<std::uint64_t>(number);
    return true;
}

bool File::flag(JsonValue object, std::string_view key, bool& value) {
    const JsonValue found = object.find(key);
    if (!found.exists()) return true;
    if (!found.is(JsonKind::boolean)) return expected(found, "`true` or `false`", key);
    value = found.number() != 0;
    return true;
}

bool File::numbers(JsonValue object, std::string_view key, std::span<double> values, const Range& range) {
    const JsonValue found = object.find(key);
    if (!found.exists()) return true;
    if (!found.is(JsonKind::list) || found.size() != values.size())
        return expected(found, fmt::format("a list of {} numbers", values.size()), key);
    std::size_t i = 0;
    bool is_right = true;
    found.for_each([&](JsonValue value) {
        if (!value.is(JsonKind::number) || !range.contains(value.number())) {
            if (is_right) expected(value, range.text, key);
            is_right = false;
        }
        values[i++] = value.number();
    });
    return is_right;
}

bool File::color(JsonValue object, std::string_view key, Color& value) {
    double v[3] = {value.r, value.g, value.b};
    if (!numbers(object, key, v, k_tint)) return false;
    value = {v[0], v[1], v[2]};
    return true;
}

bool File::expected(JsonValue at, std::string_view what, std::string_view key) {
    const std::string as = key.empty() ? std::string() : fmt::format(" as `{}`", key);
    return error(at, fmt::format("expected {}{}, found {}", what, as, at.description()));
}

bool File::error(JsonValue at, std::string message) {
    reading.diagnostics.error(text.place, at.offset(), at.length(), std::move(message));
    return false;
}

void File::warn(JsonValue at, std::string message) {
    reading.diagnostics.warn(text.place, at.offset(), at.length(), std::move(message));
}

void File::warn_once(std::string_view key, JsonValue at, std::string message) {
    reading.diagnostics.warn_once(key, text.place, at.offset(), at.length(), std::move(message));
}

Token File::token(JsonValue at) const {
    Token token;
    token.line = at.line();
    token.column = at.column();
    token.offset = at.offset();
    token.length = at.length();
    return token;
}

}  // namespace glint::gltf
