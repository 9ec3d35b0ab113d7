// SPDX-License-Identifier: Apache-2.0
#pragma once
// A file of glTF 2.0: its JSON, the lists of it that others refer to by number, and messages at its values.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "formats/json_tree.h"
#include "formats/load_state.h"

namespace glint::gltf {

/// The lists of the root, by the order of k_list_names.
enum class List : std::uint8_t {
    accessors,
    buffer_views,
    buffers,
    cameras,
    images,
    lights,
    materials,
    meshes,
    nodes,
    samplers,
    scenes,
    skins,
    textures
};
inline constexpr std::string_view k_list_names[] = {
    "accessors", "bufferViews", "buffers",  "cameras", "images", "lights",  "materials",
    "meshes",    "nodes",       "samplers", "scenes",  "skins",  "textures"};

/// A whole number of the file is at most this, so that sums of a few do not overflow.
inline constexpr double k_max_whole = 0x1p48;

class File {
  public:
    File(LoadState& load_state, const ReadText& read_text) : reading(load_state), text(read_text) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    /// Reads the JSON, and the container of a .glb. False after an error.
    bool open();

    LoadState& reading;
    const ReadText& text;
    std::optional<std::string_view> chunk;  ///< the binary chunk of a .glb

    JsonValue root() const { return json_->root(); }
    std::uint32_t count(List list) const { return static_cast<std::uint32_t>(of(list).size()); }
    JsonValue item(List list, std::uint32_t index) const { return of(list)[index]; }
    /// The number of an item of the list. Nothing, with an error, if the value is none.
    std::optional<std::uint32_t> index(JsonValue value, List list);
    /// "accessors[3]".
    static std::string name(List list, std::uint32_t index);

    // The members of an object. Missing ones leave the value as it was. False after an error.
    bool number(JsonValue object, std::string_view key, double& value, const Range& range);
    bool whole(JsonValue object, std::string_view key, std::uint64_t& value);
    bool flag(JsonValue object, std::string_view key, bool& value);
    bool numbers(JsonValue object, std::string_view key, std::span<double> values, const Range& range);
    bool color(JsonValue object, std::string_view key, Color& value);
    /// A string, empty if there is none.
    std::string string(JsonValue object, std::string_view key) const { return object.find(key).string(); }
    /// The extension of an object, if it has it.
    static JsonValue extension(JsonValue object, std::string_view name) {
        return object.find("extensions").find(name);
    }

    /// "expected WHAT as `key`, found ...". False.
    bool expected(JsonValue at, std::string_view what, std::string_view key = {});
    bool error(JsonValue at, std::string message);
    void warn(JsonValue at, std::string message);
    void warn_once(std::string_view key, JsonValue at, std::string message);
    Token token(JsonValue at) const;
    SourcePlace place(JsonValue at) const { return source_place(text, token(at)); }
    bool is_alive() const { return !reading.diagnostics.full(); }
    /// Called at intervals: whether to go on.
    bool go_on(JsonValue at) { return reading.diagnostics.go_on(text.place, at.offset()); }

  private:
    bool open_container(std::size_t& offset, std::size_t& length);
    bool container_error(std::size_t offset, std::string message);
    bool find_lists();
    bool check_version();
    const CountedVector<JsonValue>& of(List list) const { return lists_[static_cast<std::size_t>(list)]; }

    std::optional<JsonTree> json_;
    std::array<CountedVector<JsonValue>, std::size(k_list_names)> lists_;
};

/// Refuses required extensions that glint does not know, and warns about others that the file uses. False
/// after an error.
bool check_extensions(File& file);

}  // namespace glint::gltf
