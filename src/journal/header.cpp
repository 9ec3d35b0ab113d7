// SPDX-License-Identifier: Apache-2.0
#include "journal/header.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>

#include "base/status.h"
#include "base/text.h"
#include "glint/scene.h"
#include "journal/little_endian.h"

namespace glint {
namespace {

constexpr std::string_view k_magic = "glint journal 1\n";
constexpr std::size_t k_max_header = std::size_t{1} << 26;

// A value may have any bytes; a line may not have a newline.
std::string escaped(std::string_view value) {
    std::string text;
    for (const char c : value) {
        if (c == '\n')
            text += "\\n";
        else if (c == '\\')
            text += "\\\\";
        else
            text += c;
    }
    return text;
}

std::string unescaped(std::string_view text) {
    std::string value;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size()) {
            value += text[++i] == 'n' ? '\n' : text[i];
        } else {
            value += text[i];
        }
    }
    return value;
}

std::string layer_list(const std::vector<Layer>& layers) {
    std::string text;
    for (const Layer layer : layers) {
        if (!text.empty()) text += ',';
        text += layer_name(layer);
    }
    return text;
}

std::string crop_text(const Crop& c) { return fmt::format("{}x{}+{}+{}", c.width, c.height, c.x, c.y); }

// The next word of a line and the space after it; the rest stays.
std::string_view next_word(std::string_view& line) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    return word;
}

// Numbers separated by any of the letters of `between`; false if the text has others.
template <class T> bool parse_numbers(std::string_view text, std::string_view between, T* values, int count) {
    for (int i = 0; i < count; ++i) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), values[i]);
        if (error != std::errc()) return false;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (i + 1 == count) return text.empty();
        if (text.empty() || text.front() != between[static_cast<std::size_t>(i)]) return false;
        text.remove_prefix(1);
    }
    return true;
}

bool parse_layers(std::string_view text, std::vector<Layer>& layers) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        const auto layer = find_layer(text.substr(0, end));
        if (!layer || std::find(layers.begin(), layers.end(), *layer) != layers.end()) return false;
        layers.push_back(*layer);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return true;
}

// One line of the text. Keys that are not known are of a later version: they may decide the picture.
bool parse_line(std::string_view line, JournalHeader& header) {
    const std::string_view key = next_word(line);
    if (key == "picture_version") return parse_numbers(line, "", &header.picture_version, 1);
    if (key == "picture") {
        std::int32_t v[4];
        if (!parse_numbers(line, "x++", v, 4)) return false;
        header.picture = {v[0], v[1], v[2], v[3]};
        return std::all_of(v, v + 2, [](std::int32_t n) { return n >= 1 && n <= k_max_size; }) &&
               std::all_of(v + 2, v + 4, [](std::int32_t n) { return n >= 0 && n < k_max_size; });
    }
    if (key == "layers") return parse_layers(line, header.layers);
    if (key == "part") {
        std::uint32_t v[2];
        if (!parse_numbers(line, "/", v, 2)) return false;
        header.part = v[0];
        header.parts = v[1];
        return header.part >= 1 && header.part <= header.parts;
    }
    if (key == "file") {
        const std::string_view hash = next_word(line);
        header.files.emplace_back(unescaped(line), hash);
        return true;
    }
    if (key == "set") {
        const std::string_view name = next_word(line);
        header.settings.emplace_back(name, unescaped(line));
        return true;
    }
    return false;
}

Status no_header(const char* why) { return failure(ErrorCode::parse, why); }

}  // namespace

std::size_t JournalHeader::floats_of_pixel() const {
    std::size_t floats = 3;
    for (std::size_t i = 0; i < layers.size(); ++i) floats += channels_of_layer(i);
    return floats;
}

std::size_t JournalHeader::channels_of_layer(std::size_t i) const { return layer_channels(layers[i]).size(); }

std::uint32_t journal_checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

std::string header_bytes(const JournalHeader& header) {
    std::string text =
        fmt::format("picture_version {}\npicture {}\n", header.picture_version, crop_text(header.picture));
    if (!header.layers.empty()) text += fmt::format("layers {}\n", layer_list(header.layers));
    text += fmt::format("part {}/{}\n", header.part, header.parts);
    for (const auto& [name, hash] : header.files) text += fmt::format("file {} {}\n", hash, escaped(name));
    for (const auto& [name, value] : header.settings)
        text += fmt::format("set {} {}\n", name, escaped(value));
    std::string bytes(k_magic);
    put_u32(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += text;
    put_u32(bytes, journal_checksum(text));
    return bytes;
}

Result<ParsedHeader> parse_header(std::string_view bytes) {
    const std::size_t start = k_magic.size() + 4;
    if (!bytes.starts_with(k_magic)) {
        return no_header(k_magic.starts_with(bytes) ? "it ends within its header"
                                                    : "it is no journal of glint");
    }
    if (bytes.size() < start) return no_header("it ends within its header");
    const std::size_t length = get_u32(bytes.substr(k_magic.size()));
    if (length > k_max_header) return no_header("its header is damaged");
    if (bytes.size() < start + length + 4) return no_header("it ends within its header");
    std::string_view text = bytes.substr(start, length);
    if (get_u32(bytes.substr(start + length)) != journal_checksum(text))
        return no_header("its header is damaged");
    ParsedHeader parsed;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (!parse_line(text.substr(0, end), parsed.header))
            return no_header("its header is of another version of glint, or is damaged");
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (parsed.header.picture.width < 1) return no_header("its header is damaged");
    parsed.size = start + length + 4;
    return parsed;
}

std::string header_difference(const JournalHeader& a, const JournalHeader& b) {
    for (std::size_t i = 0; i < std::max(a.files.size(), b.files.size()); ++i) {
        if (i >= b.files.size()) return fmt::format("{} is not read here", quoted(a.files[i].first));
        if (i >= a.files.size()) return fmt::format("{} was not read there", quoted(b.files[i].first));
        if (a.files[i].second == b.files[i].second) continue;
        if (a.files[i].first == b.files[i].first)
            return fmt::format("{} has changed", quoted(a.files[i].first));
        return fmt::format("{} was read there and {} is read here", quoted(a.files[i].first),
                           quoted(b.files[i].first));
    }
    const auto differ = [](std::string_view name, std::string_view there, std::string_view here) {
        return fmt::format("{} is {} there and {} here", name, there.empty() ? "not set" : there,
                           here.empty() ? "not set" : here);
    };
    if (a.picture_version != b.picture_version)
        return differ("the version of glint's pictures", std::to_string(a.picture_version),
                      std::to_string(b.picture_version));
    const auto value = [](const JournalHeader& header, const std::string& name) -> const std::string* {
        for (const auto& setting : header.settings)
            if (setting.first == name) return &setting.second;
        return nullptr;
    };
    for (const auto* header : {&a, &b}) {
        for (const auto& [name, unused] : header->settings) {
            const std::string *there = value(a, name), *here = value(b, name);
            if (there == nullptr || here == nullptr || *there != *here)
                return differ(name, there ? *there : "", here ? *here : "");
        }
    }
    if (crop_text(a.picture) != crop_text(b.picture))
        return differ("the crop", crop_text(a.picture), crop_text(b.picture));
    if (a.layers != b.layers) return differ("the list of layers", layer_list(a.layers), layer_list(b.layers));
    return {};
}

}  // namespace glint
