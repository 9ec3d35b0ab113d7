// SPDX-License-Identifier: Apache-2.0
#include "rendering.h"

#include <pybind11/stl.h>

#include <cstring>

#include "errors.h"

namespace glint::python {
namespace {

using RenderingPointer = std::shared_ptr<Rendering>;

// A view of the picture's floats, which keeps them alive.
py::array_t<float> view(const py::object& owner, const std::vector<float>& values, std::int32_t width,
                        std::int32_t height, int channels) {
    return py::array_t<float>({py::ssize_t{height}, py::ssize_t{width}, py::ssize_t{channels}}, values.data(),
                              owner);
}

RenderingPointer from_array(const py::array_t<float, py::array::c_style | py::array::forcecast>& array) {
    if (array.ndim() != 3 || array.shape(2) != 3 || array.shape(0) < 1 || array.shape(1) < 1 ||
        array.shape(0) > k_max_size || array.shape(1) > k_max_size)
        throw py::value_error("a picture is an array of height x width x 3 numbers");
    auto rendering = std::make_shared<Rendering>();
    rendering->image.width = static_cast<std::int32_t>(array.shape(1));
    rendering->image.height = static_cast<std::int32_t>(array.shape(0));
    rendering->image.rgb.assign(array.data(), array.data() + array.size());
    return rendering;
}

py::bytes to_bytes(const std::vector<std::uint8_t>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

py::bytes encoded(const Rendering& r, const std::string& format, int bits,
                  const std::optional<std::string>& transfer) {
    EncodeOptions options;
    if (format == "png") {
        options.format = FileFormat::png;
    } else if (format == "ppm") {
        options.format = FileFormat::ppm;
    } else if (format == "exr") {
        options.format = FileFormat::exr;
    } else if (format == "tga") {
        options.format = FileFormat::tga;
    } else if (format == "bmp") {
        options.format = FileFormat::bmp;
    } else if (format == "jpeg") {
        options.format = FileFormat::jpeg;
    } else {
        throw py::value_error("format: expected 'png', 'ppm', 'tga', 'bmp', 'jpeg' or 'exr', found " +
                              repr_of(py::str(format)));
    }
    options.bits = bits;
    options.set_rule(r.rule);
    if (transfer) {
        if (*transfer != "none" && *transfer != "srgb")
            throw py::value_error("transfer: expected 'none' or 'srgb', found " +
                                  repr_of(py::str(*transfer)));
        options.transfer = *transfer == "srgb" ? Transfer::srgb : Transfer::none;
    }
    Result<std::vector<std::uint8_t>> result;
    {
        const py::gil_scoped_release release;
        std::vector<LayerImage> layers = r.layers;
        std::vector<float> alpha;
        std::erase_if(layers, [&](LayerImage& layer) {
            const bool is_alpha = r.has_alpha && layer.layer == Layer::alpha;
            if (is_alpha) alpha = std::move(layer.values);
            return is_alpha;
        });
        result = options.format == FileFormat::exr && !layers.empty() ? encode_layers(r.image, layers, alpha)
                 : alpha.empty()                                      ? encode(r.image, options)
                                                                      : encode(r.image, alpha, options);
    }
    return to_bytes(value_or_raise(std::move(result)));
}

const LayerImage& layer_named(const Rendering& r, const std::string& name) {
    for (const LayerImage& layer : r.layers)
        if (layer_name(layer.layer) == name) return layer;
    throw py::key_error("the picture was rendered without the layer '" + name + "'");
}

RenderingPointer decoded(const py::bytes& bytes, std::uint64_t max_memory) {
    const std::string_view text = bytes;
    DecodeOptions options;
    options.max_memory = max_memory;
    DecodedImage image =
        value_or_raise(decode({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, options));
    auto rendering = std::make_shared<Rendering>();
    rendering->image = std::move(image.image);
    return rendering;
}

}  // namespace

void bind_rendering(py::module_& m) {
    py::class_<Rendering, RenderingPointer>(m, "Rendering")
        .def(py::init(&from_array))
        .def_static("decode", &decoded)
        .def_property_readonly("width", [](const Rendering& r) { return r.image.width; })
        .def_property_readonly("height", [](const Rendering& r) { return r.image.height; })
        .def_readonly("isa", &Rendering::isa)
        .def_readonly("threads", &Rendering::threads)
        .def_property_readonly("rays",
                               [](const Rendering& r) {
                                   py::dict rays;
                                   rays["camera"] = r.rays.camera;
                                   rays["shadow"] = r.rays.shadow;
                                   rays["mirror"] = r.rays.mirror;
                                   rays["transmitted"] = r.rays.transmitted;
                                   rays["cut"] = r.rays.cut;
                                   return rays;
                               })
        .def("array",
             [](const py::object& self) {
                 const auto& image = self.cast<const Rendering&>().image;
                 return view(self, image.rgb, image.width, image.height, 3);
             })
        .def("layer_names",
             [](const Rendering& r) {
                 std::vector<std::string> names;
                 for (const LayerImage& layer : r.layers) names.push_back(layer_name(layer.layer));
                 return names;
             })
        .def("layer",
             [](const py::object& self, const std::string& name) {
                 const LayerImage& layer = layer_named(self.cast<const Rendering&>(), name);
                 return view(self, layer.values, layer.width, layer.height, layer.channels);
             })
        .def("viewable",
             [](const Rendering& r, const std::string& name) {
                 auto shown = std::make_shared<Rendering>();
                 shown->image = value_or_raise(viewable(layer_named(r, name)));
                 return shown;
             })
        .def("copy", [](const Rendering& r) { return std::make_shared<Rendering>(r); })
        .def("encode", &encoded);
    m.def("layer_infos", [] {
        py::list list;
        for (const LayerInfo& info : layer_infos())
            list.append(py::make_tuple(std::string(info.name), std::string(info.channels),
                                       std::string(info.description)));
        return list;
    });
}

}  // namespace glint::python
