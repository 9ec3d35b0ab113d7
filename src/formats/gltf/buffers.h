// SPDX-License-Identifier: Apache-2.0
#pragma once
// The bytes of a file: its binary chunk, files beside it, and base64 in its JSON.
#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "formats/gltf/file.h"

namespace glint::gltf {

struct BufferView {
    std::string_view bytes;
    std::uint64_t stride = 0;  ///< 0: none is given
    JsonValue at;
};

class Buffers {
  public:
    explicit Buffers(File& file) : file_(file), known_(file.count(List::buffers)) {}

    /// Nothing after an error.
    std::optional<BufferView> view(JsonValue index);
    /// The bytes of a data URI; nothing after an error.
    std::optional<std::string_view> decode(JsonValue uri);

  private:
    struct Known {
        bool is_read = false;
        std::optional<std::string_view> bytes;
    };
    std::optional<std::string_view> buffer(std::uint32_t index);
    std::optional<std::string_view> read(std::uint32_t index, JsonValue at);

    File& file_;
    CountedVector<Known> known_;
    std::deque<CountedString> decoded_;
};

/// The name of the file that a relative URI means, without %XX. Nothing, with the reason in `why`, if it is
/// on another host.
std::optional<std::string> file_of_uri(std::string_view uri, std::string& why);

inline bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

}  // namespace glint::gltf
