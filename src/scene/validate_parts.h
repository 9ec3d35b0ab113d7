// SPDX-License-Identifier: Apache-2.0
#pragma once
// Checks what a scene has besides shapes.
#include <string>

#include "scene/mistake_finder.h"

namespace glint {

class PartValidator : public MistakeFinder {
  protected:
    explicit PartValidator(const Scene& scene) : scene_(scene) {}
    ~PartValidator() = default;

    void check_part(ScenePart part);
    void check_texture(std::uint32_t i);
    void check_texture_index(std::uint32_t i);
    void check_material(const Material& m, std::uint32_t i);

    const Scene& scene_;

  private:
    void check_settings();
    void check_fog();
    void check_gradient();
    void check_occlusion();
    void check_camera();
    void check_frame(const CameraFrame& frame, SourcePlace place);
    void check_light(std::uint32_t i);
    void check_layers(std::uint32_t i, SourcePlace place, const std::string& of);
};

}  // namespace glint
