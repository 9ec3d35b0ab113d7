// SPDX-License-Identifier: Apache-2.0
// The camera and its frame as Python objects.
#include "item_fields.h"
#include "scene/camera_fields.h"

namespace glint::python {

template <> std::span<const ItemField<Camera>> fields_of() { return k_camera_fields; }
template <> std::span<const ItemField<CameraFrame>> fields_of() { return k_frame_fields; }

namespace {

constexpr const char* k_projections[] = {"perspective", "orthographic"};
constexpr const char* k_axes[] = {"x", "y"};

template <class Enum>
Enum enum_of(const char* const (&words)[2], const std::string& word, std::string_view name) {
    for (int i = 0; i < 2; ++i)
        if (words[i] == word) return static_cast<Enum>(i);
    throw py::value_error(
        fmt::format("{}: expected '{}' or '{}', found '{}'", name, words[0], words[1], word));
}

void set_frame(CameraBox& camera, const py::object& frame) {
    camera.frame = frame.is_none() ? nullptr : frame.cast<std::shared_ptr<FrameBox>>();
}

void bind_frame(py::module_& m) {
    py::class_<FrameBox, std::shared_ptr<FrameBox>> cls(
        m, "CameraFrame",
        "A camera's axes: `right` spans the picture's width and `up` its height at `forward` from the "
        "position.");
    cls.def(py::init([](const py::kwargs& keywords) {
        FrameBox frame;
        set_fields(frame.value, keywords, "CameraFrame");
        return std::make_shared<FrameBox>(frame);
    }));
    bind_fields<CameraFrame>(cls, &FrameBox::value);
    cls.def("__eq__",
            [](const FrameBox& a, const py::object& other) {
                return py::isinstance<FrameBox>(other) && a.value == other.cast<const FrameBox&>().value;
            })
        .def("__repr__", [](const FrameBox& frame) {
            CameraFrame other{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}};
            return fmt::format("CameraFrame({})", changed_fields(frame.value, other));
        });
    bind_copies<decltype(cls), FrameBox>(cls, [](const FrameBox& frame) { return frame; });
    cls.attr("__hash__") = py::none();
}

}  // namespace

bool same(const Camera& a, const Camera& b) {
    return a.projection == b.projection && a.fov_axis == b.fov_axis && a.frame == b.frame &&
           same_fields(a, b);
}

void bind_cameras(py::module_& m) {
    bind_frame(m);
    py::class_<CameraBox, std::shared_ptr<CameraBox>> cls(
        m, "Camera", "The camera. Without a frame it is right-handed, and pixels are square.");
    cls.def(py::init([](const py::kwargs& keywords) {
        static constexpr std::string_view others[] = {"projection", "fov_axis", "frame"};
        CameraBox camera;
        set_fields(camera.value, keywords, "Camera", others);
        if (keywords.contains("projection"))
            camera.value.projection =
                enum_of<Projection>(k_projections, keywords["projection"].cast<std::string>(), "projection");
        if (keywords.contains("fov_axis"))
            camera.value.fov_axis =
                enum_of<FovAxis>(k_axes, keywords["fov_axis"].cast<std::string>(), "fov_axis");
        if (keywords.contains("frame")) set_frame(camera, keywords["frame"]);
        return std::make_shared<CameraBox>(camera);
    }));
    bind_fields<Camera>(cls, &CameraBox::value);
    cls.def_property(
           "projection",
           [](const CameraBox& c) { return k_projections[static_cast<int>(c.value.projection)]; },
           [](CameraBox& c, const std::string& word) {
               c.value.projection = enum_of<Projection>(k_projections, word, "projection");
           },
           "'perspective' or 'orthographic'")
        .def_property(
            "fov_axis", [](const CameraBox& c) { return k_axes[static_cast<int>(c.value.fov_axis)]; },
            [](CameraBox& c, const std::string& word) {
                c.value.fov_axis = enum_of<FovAxis>(k_axes, word, "fov_axis");
            },
            "The side of the picture that `fov` spans: 'x', its width, or 'y', its height")
        .def_property(
            "frame", [](const CameraBox& c) { return c.frame; },
            [](CameraBox& c, const py::object& frame) { set_frame(c, frame); },
            "A CameraFrame, which replaces look_at, up, fov and width; or None")
        .def("__eq__",
             [](const CameraBox& a, const py::object& other) {
                 return py::isinstance<CameraBox>(other) &&
                        same(a.whole(), other.cast<const CameraBox&>().whole());
             })
        .def("__repr__", [](const CameraBox& c) {
            std::string text = changed_fields(c.whole(), Camera{});
            const auto add = [&](const std::string& more) { text += (text.empty() ? "" : ", ") + more; };
            if (c.value.projection != Projection::perspective) add("projection='orthographic'");
            if (c.value.fov_axis != FovAxis::x) add("fov_axis='y'");
            if (c.frame) add("frame=" + repr_of(py::cast(c.frame)));
            return "Camera(" + text + ")";
        });
    bind_copies<decltype(cls), CameraBox>(cls, [](const CameraBox& c) {
        CameraBox copy = c;
        if (c.frame) copy.frame = std::make_shared<FrameBox>(*c.frame);
        return copy;
    });
    cls.attr("__hash__") = py::none();
}

}  // namespace glint::python
