// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/buffers.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/include.h"

namespace glint::gltf {
namespace {

// The names of media type application/gltf-buffer. No other file is opened as a buffer.
constexpr std::string_view k_buffer_extensions[] = {".bin", ".glbin", ".glbuf"};

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    return c == '/' || c == '_' ? 63 : -1;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

// False at a character that base64 does not have.
bool decode_base64(std::string_view text, CountedString& bytes) {
    while (text.ends_with('=')) text.remove_suffix(1);
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int digit = base64_digit(c);
        if (digit < 0) return false;
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<char>(static_cast<unsigned char>(bits >> count)));
    }
    return true;
}

bool is_buffer_name(std::string_view name) {
    return std::any_of(std::begin(k_buffer_extensions), std::end(k_buffer_extensions),
                       [&](std::string_view extension) { return name.ends_with(extension); });
}

}  // namespace

std::optional<std::string> file_of_uri(std::string_view uri, std::string& why) {
    // "http://host/a", "file:///a", "//host/a".
    const std::size_t colon = uri.find(':');
    if ((colon != std::string_view::npos && colon < uri.find('/')) || uri.starts_with("//")) {
        why = "expected the name of a file relative to this one";
        return std::nullopt;
    }
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool is_escape =
            uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
        if (is_escape) {
            name += static_cast<char>(
                static_cast<unsigned char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])));
            i += 2;
        } else {
            name += uri[i];
        }
    }
    if (name.empty()) {
        why = "expected the name of a file";
        return std::nullopt;
    }
    return name;
}

std::optional<std::string_view> Buffers::decode(JsonValue uri) {
    std::string unescaped;
    std::string_view text = uri.text().substr(1, uri.length() - 2);
    if (text.find('\\') != std::string_view::npos) text = unescaped = uri.string();
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || !text.substr(0, comma).ends_with(";base64")) {
        file_.error(uri,
                    fmt::format("expected `data:...;base64,` and bytes in base64, found {}", quoted(text)));
        return std::nullopt;
    }
    text.remove_prefix(comma + 1);
    if (!file_.reading.has_room(MemoryBudget::list_bytes(text.size() / 4 * 3 + 3, 1), file_.text.place,
                                uri.offset(), uri.length()))
        return std::nullopt;
    CountedString bytes;
    if (!decode_base64(text, bytes)) {
        file_.error(uri, "expected bytes in base64, found another character");
        return std::nullopt;
    }
    decoded_.push_back(std::move(bytes));
    return decoded_.back();
}

std::optional<std::string_view> Buffers::read(std::uint32_t index, JsonValue at) {
    const JsonValue uri = at.find("uri");
    if (!uri.exists()) {
        if (index == 0 && file_.chunk) return file_.chunk;
        file_.error(at, fmt::format("{} has neither a `uri` nor the binary chunk of a .glb",
                                    File::name(List::buffers, index)));
        return std::nullopt;
    }
    if (!uri.is(JsonKind::string)) {
        file_.expected(uri, "a string", "uri");
        return std::nullopt;
    }
    if (is_data_uri(uri.text().substr(1))) return decode(uri);
    std::string why;
    const std::optional<std::string> name = file_of_uri(uri.string(), why);
    if (!name || !is_buffer_name(*name)) {
        if (name) why = "expected the name of a file that ends in .bin, .glbin or .glbuf";
        file_.error(uri, fmt::format("{}: {}", quoted(uri.string()), why));
        return std::nullopt;
    }
    const std::optional<ReadText> text = open_text(file_.reading, file_.text, file_.token(uri), *name);
    if (!text) return std::nullopt;
    return text->place.text;
}

std::optional<std::string_view> Buffers::buffer(std::uint32_t index) {
    Known& known = known_[index];
    if (known.is_read) return known.bytes;
    known.is_read = true;
    const JsonValue at = file_.item(List::buffers, index);
    std::uint64_t length = 0;
    if (!file_.whole(at, "byteLength", length)) return std::nullopt;
    if (!at.find("byteLength").exists()) {
        file_.error(at, fmt::format("expected `byteLength` in {}", File::name(List::buffers, index)));
        return std::nullopt;
    }
    const std::optional<std::string_view> bytes = read(index, at);
    if (!bytes) return std::nullopt;
    if (bytes->size() < length) {
        file_.error(at.find("byteLength"), fmt::format("expected {} bytes in {}, found {}", length,
                                                       File::name(List::buffers, index), bytes->size()));
        return std::nullopt;
    }
    known.bytes = bytes->substr(0, static_cast<std::size_t>(length));
    return known.bytes;
}

std::optional<BufferView> Buffers::view(JsonValue value) {
    const std::optional<std::uint32_t> index = file_.index(value, List::buffer_views);
    if (!index) return std::nullopt;
    BufferView view;
    view.at = file_.item(List::buffer_views, *index);
    std::uint64_t offset = 0, length = 0;
    if (!file_.whole(view.at, "byteOffset", offset) || !file_.whole(view.at, "byteLength", length) ||
        !file_.whole(view.at, "byteStride", view.stride))
        return std::nullopt;
    const JsonValue of = view.at.find("buffer");
    if (!of.exists() || !view.at.find("byteLength").exists()) {
        file_.error(view.at, fmt::format("expected `buffer` and `byteLength` in {}",
                                         File::name(List::buffer_views, *index)));
        return std::nullopt;
    }
    const std::optional<std::uint32_t> number = file_.index(of, List::buffers);
    if (!number) return std::nullopt;
    const std::optional<std::string_view> bytes = buffer(*number);
    if (!bytes) return std::nullopt;
    if (offset > bytes->size() || length > bytes->size() - offset) {
        file_.error(view.at, fmt::format("expected bytes {} to {} of {}, which has {}", offset,
                                         offset + length, File::name(List::buffers, *number), bytes->size()));
        return std::nullopt;
    }
    view.bytes = bytes->substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
    return view;
}

}  // namespace glint::gltf
