// SPDX-License-Identifier: Apache-2.0
#pragma once
// The statements of a scene. token_stream.h lists the classes that the reader is made of.
#include <array>
#include <optional>
#include <string_view>

#include "formats/povray/directive_parser.h"
#include "formats/povray/scene_builder.h"

namespace glint::povray {

class Reader final : public DirectiveParser {
  public:
    Reader(LoadState& reading, const ReadText& text)
        : DirectiveParser(reading, text), scene_(reading.scene), builder_(reading, *this) {}
    void read();

  private:
    // read.cpp
    void read_statement();
    void finish();

    // settings.cpp
    void read_global_settings();
    void use_gamma();
    bool set(std::string_view name, const Token& at, std::string_view value);

    // surroundings.cpp
    void read_background(const Token& at);
    void read_fog(const Token& at);
    void read_sky(const Token& at);
    /// After the last object. is_new: version 3.7 or later.
    void use_background(bool is_new);

    Scene& scene_;
    SceneBuilder builder_;
    std::optional<CameraItems> camera_;
    Token gamma_place_;
    std::array<double, 5> background_{};
    Token background_at_;
    Color ambient_light_{1, 1, 1};
};

}  // namespace glint::povray
