// SPDX-License-Identifier: Apache-2.0
// The scene's lists and settings for glint/_scene.py, which makes sequences and mappings of them.
#include <pybind11/stl.h>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "scene_state.h"

namespace glint::python {
namespace {

using SceneClass = py::class_<SceneState, std::shared_ptr<SceneState>>;

// The index of the item with a name.
std::uint32_t named(const ItemTexts& texts, std::size_t count, const std::string& name,
                    std::string_view what) {
    std::uint32_t first = k_none;
    std::vector<std::string_view> others;
    for (const auto& [index, known] : texts.names) {
        if (index >= count) continue;
        if (known == name)
            first = std::min(first, index);
        else
            others.push_back(known);
    }
    if (first == k_none)
        throw py::key_error(
            fmt::format("the scene has no {} '{}'{}", what, name, did_you_mean(name, others)));
    return first;
}

std::uint32_t checked(std::size_t index, std::size_t count) {
    if (index >= count) throw py::index_error("index out of range");
    return static_cast<std::uint32_t>(index);
}

void bind_lists(SceneClass& cls) {
    cls.def("light_count", [](SceneState& s) { return s.stored().lights.size(); })
        .def("light",
             [](SceneState& s, std::size_t i) { return s.light(checked(i, s.stored().lights.size())); })
        .def("light_named",
             [](SceneState& s, const std::string& name) {
                 const Scene& scene = s.scene();
                 return s.light(named(scene.light_texts, scene.lights.size(), name, "light"));
             })
        .def("set_lights", &SceneState::set_lights)
        .def("add_light", [](SceneState& s, const std::shared_ptr<LightBox>& light) { return s.add(light); })
        .def("material_count", [](SceneState& s) { return s.scene().materials.size(); })
        .def("material",
             [](SceneState& s, std::size_t i) { return s.material(checked(i, s.stored().materials.size())); })
        .def("material_named",
             [](SceneState& s, const std::string& name) {
                 const Scene& scene = s.scene();
                 return s.material(named(scene.material_texts, scene.materials.size(), name, "material"));
             })
        .def("set_material",
             [](SceneState& s, std::size_t i, const std::shared_ptr<MaterialBox>& material) {
                 s.set_material(checked(i, s.scene().materials.size()), material);
             })
        .def("add_material",
             [](SceneState& s, const std::shared_ptr<MaterialBox>& material) { return s.add(material); })
        .def("texture_count", [](SceneState& s) { return s.scene().textures.size(); })
        .def("texture",
             [](SceneState& s, std::size_t i) { return s.texture(checked(i, s.stored().textures.size())); })
        .def("texture_named",
             [](SceneState& s, const std::string& name) {
                 const Scene& scene = s.scene();
                 return s.texture(named(scene.texture_texts, scene.textures.size(), name, "texture"));
             })
        .def("add_texture",
             [](SceneState& s, const std::shared_ptr<TextureBox>& texture) { return s.add(texture); })
        .def("shape_count", [](SceneState& s) { return s.stored().shapes.size(); })
        .def("shape",
             [](SceneState& s, std::size_t i) { return s.shape(checked(i, s.stored().shapes.size())); })
        .def("shape_named",
             [](SceneState& s, const std::string& name) {
                 const Scene& scene = s.scene();
                 return s.shape(named(scene.shape_texts, scene.shapes.size(), name, "shape"));
             })
        .def("set_shape",
             [](SceneState& s, std::size_t i, const std::shared_ptr<ShapeBox>& shape) {
                 s.set_shape(checked(i, s.stored().shapes.size()), shape);
             })
        .def("remove_shapes",
             [](SceneState& s, const std::vector<std::size_t>& shapes) {
                 std::vector<std::uint32_t> indices;
                 for (const std::size_t i : shapes) indices.push_back(checked(i, s.scene().shapes.size()));
                 s.remove_shapes(std::move(indices));
             })
        .def("add_shape", [](SceneState& s, const std::shared_ptr<ShapeBox>& shape) { return s.add(shape); });
}

void bind_settings(py::module_& m, SceneClass& cls) {
    cls.def("get_setting",
            [](SceneState& s, const std::string& key) {
                const auto index = find_setting(key);
                if (!index) throw py::key_error(key);
                return glint::get_setting(s.scene(), *index);
            })
        .def("set_setting", &SceneState::set_setting)
        .def("apply_profile", &SceneState::apply_profile)
        .def_property_readonly(
            "profile", [](SceneState& s) { return s.scene().profile; },
            "The conventions' profile: 'glint', 'epfl', ...")
        .def_property_readonly(
            "files", [](SceneState& s) { return s.scene().files; },
            "The names of the texts that it was read from")
        .def_property(
            "background", [](SceneState& s) { return to_python(s.scene().background); },
            [](SceneState& s, const py::object& color) {
                s.set_background(to_color(color, "background", k_channel));
            },
            "The color where nothing is hit, linear RGB")
        .def_property(
            "camera", &SceneState::camera,
            [](SceneState& s, const std::shared_ptr<CameraBox>& camera) {
                if (!camera) throw py::type_error("camera: expected a Camera, found None");
                s.set_camera(camera);
            },
            "The Camera.")
        .def_property("fog", &SceneState::fog, &SceneState::set_fog, "The Fog, or None.")
        .def_property("gradient", &SceneState::gradient, &SceneState::set_gradient,
                      "The BackgroundGradient, or None.")
        .def_property("occlusion", &SceneState::occlusion, &SceneState::set_occlusion,
                      "The Occlusion, or None.");
    m.def("setting_keys", [] {
        py::list keys;
        for (const SettingKey& key : setting_keys())
            keys.append(py::make_tuple(std::string(key.name), std::string(key.values),
                                       std::string(key.description), key.is_convention));
        return keys;
    });
    m.def("profile_names", [] {
        py::list names;
        for (const std::string_view name : profile_names()) names.append(std::string(name));
        return names;
    });
}

template <class Item> bool same_optional(const std::optional<Item>& a, const std::optional<Item>& b) {
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

bool equal(SceneState& a, SceneState& b) {
    const Scene &x = a.scene(), &y = b.scene();
    if (x.shapes.size() != y.shapes.size() || x.lights.size() != y.lights.size() ||
        x.materials.size() != y.materials.size() || x.textures.size() != y.textures.size() ||
        !(x.background == y.background) || !(x.conventions == y.conventions) || !(x.settings == y.settings) ||
        !same(x.camera, y.camera) || !same_optional(x.fog, y.fog) || !same_optional(x.gradient, y.gradient) ||
        !same_optional(x.occlusion, y.occlusion))
        return false;
    for (std::size_t i = 0; i < x.lights.size(); ++i)
        if (!same(x.lights[i], y.lights[i])) return false;
    for (std::size_t i = 0; i < x.materials.size(); ++i)
        if (!same(x.materials[i], y.materials[i])) return false;
    for (std::size_t i = 0; i < x.textures.size(); ++i)
        if (!same(x.textures[i], y.textures[i])) return false;
    for (std::uint32_t i = 0; i < x.shapes.size(); ++i) {
        const Shape &s = x.shapes[i], &t = y.shapes[i];
        const auto transform = [](const Scene& scene, const Shape& shape) {
            return shape.transform == k_none ? Affine{} : scene.transforms[shape.transform];
        };
        if (s.kind != t.kind || s.material != t.material || x.shape_color(i) != y.shape_color(i) ||
            !(transform(x, s) == transform(y, t)) || !read_shape(x, s)->same(*read_shape(y, t)) ||
            !std::ranges::equal(operands_of(x, s), operands_of(y, t), {}, &Shape::material, &Shape::material))
            return false;
    }
    return true;
}

}  // namespace

void bind_scene(py::module_& m) {
    SceneClass cls(m, "SceneState");
    cls.def(py::init<>());
    bind_lists(cls);
    bind_settings(m, cls);
    bind_arrays(cls);
    bind_tools(m, cls);
    bind_diagnosis(m, cls);
    cls.def("equals", &equal);
    cls.def("copy_from", [](SceneState& s, SceneState& other) { s.copy_from(other); });
}

}  // namespace glint::python
