// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lights, materials, textures, the fog, the sky and the camera as Python objects. Their attributes are the
// rows of the tables of fields (src/scene/*_fields.h).
#include <memory>
#include <string>
#include <unordered_map>

#include "glint/scene.h"
#include "values.h"

namespace glint::python {

/// A value that Python and any number of scenes refer to. A scene compares it with its own when it is
/// rendered.
template <class Item> struct SharedItem {
    Item value;
    std::string name;
};

using LightBox = SharedItem<Light>;
/// A texture has another number in each scene, so Python's textures and materials refer to the object.
struct TextureBox {
    Texture value;  ///< without `over`
    std::string name;
    std::shared_ptr<TextureBox> over = {};  ///< null: none
};
using FrameBox = SharedItem<CameraFrame>;
using FogBox = SharedItem<Fog>;
using OcclusionBox = SharedItem<Occlusion>;
using GradientBox = SharedItem<BackgroundGradient>;

struct MaterialBox {
    Material value;  ///< without its texture
    std::string name;
    std::shared_ptr<TextureBox> texture = {};  ///< null: none
};
/// A copy with a texture of its own, which shares the image.
std::shared_ptr<MaterialBox> deep_copy(const MaterialBox& material);

struct CameraBox {
    Camera value;  ///< without its frame
    std::shared_ptr<FrameBox> frame;

    Camera whole() const {
        Camera camera = value;
        if (frame) camera.frame = frame->value;
        return camera;
    }
};

bool same(const Light& a, const Light& b);
bool same(const Material& a, const Material& b);
/// With their names and textures.
bool same(const MaterialBox& a, const MaterialBox& b);
/// With their names, and those that they are over.
bool same(const TextureBox& a, const TextureBox& b);
/// Its own, and those that it is over; the images are shared.
std::shared_ptr<TextureBox> deep_copy(const TextureBox& texture);
/// Wherever the images are from.
bool same(const Texture& a, const Texture& b);
bool same(const Camera& a, const Camera& b);
bool same(const Fog& a, const Fog& b);
bool same(const Occlusion& a, const Occlusion& b);
bool same(const BackgroundGradient& a, const BackgroundGradient& b);

/// The keyword is of the field `name`.
std::shared_ptr<TextureBox> to_texture(const py::handle& value, std::string_view name);

void bind_lights(py::module_& m);
void bind_textures(py::module_& m);
void bind_materials(py::module_& m);
void bind_fog(py::module_& m);
/// Occlusion and BackgroundGradient.
void bind_sky(py::module_& m);
/// Camera and CameraFrame.
void bind_cameras(py::module_& m);

}  // namespace glint::python
