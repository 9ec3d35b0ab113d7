// SPDX-License-Identifier: Apache-2.0
// Textures as Python objects, and their images from arrays and files.
#include <cstring>

#include "errors.h"
#include "image/texture_image.h"
#include "item_fields.h"
#include "scene/texture_fields.h"
#include "scene/validate_texture.h"

namespace glint::python {

template <> std::span<const ItemField<Texture>> fields_of() { return k_texture_fields; }

UvMap from_python(const UvMapType&, const py::handle& value, std::string_view name) {
    const auto rows = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
    if (!rows) PyErr_Clear();
    if (!rows || rows.ndim() != 2 || rows.shape(0) != 2 || rows.shape(1) != 3)
        throw py::value_error(
            fmt::format("{}: expected two rows of three numbers, found {}", name, repr_of(value)));
    UvMap map;
    std::memcpy(map.m, rows.data(), sizeof(map.m));
    for (const double x : numbers_of(map))
        if (!k_coordinate.contains(x))
            throw py::value_error(fmt::format("{}: expected {}, found {}", name, k_coordinate.text, x));
    return map;
}

py::object to_python(const UvMap& map) {
    const auto row = [](const double(&r)[3]) { return py::make_tuple(r[0], r[1], r[2]); };
    return py::make_tuple(row(map.m[0]), row(map.m[1]));
}

namespace {

struct Picture {
    std::shared_ptr<const TextureImage> image;
    std::string file;  // empty: not from a file
};

// name: of the file, for messages; empty: none.
std::shared_ptr<const TextureImage> decode_image(const py::bytes& bytes, const std::string& name) {
    const std::string_view view = bytes;
    Result<TextureImage> image = [&] {
        const py::gil_scoped_release release;
        return decode_texture({reinterpret_cast<const std::uint8_t*>(view.data()), view.size()});
    }();
    if (!image && !name.empty()) image.message = fmt::format("{}: {}", name, image.message);
    return std::make_shared<const TextureImage>(value_or_raise(std::move(image)));
}

template <class Word> std::shared_ptr<const TextureImage> copy_texels(const py::array& array) {
    // Also turns the bytes of words in the other order.
    const auto texels = py::array_t<Word, py::array::c_style | py::array::forcecast>::ensure(array);
    if (!texels) throw py::error_already_set();
    auto image = std::make_shared<TextureImage>();
    image->height = static_cast<std::uint32_t>(texels.shape(0));
    image->width = static_cast<std::uint32_t>(texels.shape(1));
    image->has_alpha = texels.shape(2) == 4;
    image->words = std::vector<Word>(texels.data(), texels.data() + texels.size());
    return image;
}

std::shared_ptr<const TextureImage> image_of_array(const py::object& value) {
    const py::array array = py::array::ensure(value);
    if (!array) PyErr_Clear();
    const auto size = array ? array.itemsize() : 0;
    if (!array || array.dtype().kind() != 'u' || size > 2)
        throw py::type_error(fmt::format(
            "image: expected an array of uint8 or uint16, bytes, or the name of a file, found {}",
            array && array.dtype().kind() != 'O' ? "an array of " + py::str(array.dtype()).cast<std::string>()
                                                 : repr_of(value)));
    std::string shape;
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
        shape += fmt::format("{}{}", i == 0 ? "" : " x ", array.shape(i));
    if (array.ndim() != 3 || (array.shape(2) != 3 && array.shape(2) != 4))
        throw py::value_error(fmt::format("image: expected an array of height x width x 3 or 4, found {}",
                                          shape.empty() ? "one number" : shape));
    for (const int side : {0, 1})
        if (array.shape(side) < 1 || array.shape(side) > py::ssize_t{k_max_texture_size})
            throw py::value_error(
                fmt::format("image: expected 1 to {} texels a side, found {}", k_max_texture_size, shape));
    return size == 1 ? copy_texels<std::uint8_t>(array) : copy_texels<std::uint16_t>(array);
}

Picture to_picture(const py::object& value) {
    if (py::isinstance<py::bytes>(value)) return {decode_image(value, {}), {}};
    if (!py::isinstance<py::str>(value) && !py::hasattr(value, "__fspath__"))
        return {image_of_array(value), {}};
    const py::object path = from_package("pathlib", "Path")(value);
    const auto name = py::str(value).cast<std::string>();
    return {decode_image(path.attr("read_bytes")(), name), name};
}

void set_image(TextureBox& texture, const py::object& value) {
    Picture picture = to_picture(value);
    texture.value.image = std::move(picture.image);
    texture.value.file = std::move(picture.file);
    texture.value.color_map.clear();
}

// A read-only view, which keeps the image alive.
py::object texels_of(const TextureBox& texture) {
    const std::shared_ptr<const TextureImage>& image = texture.value.image;
    if (!image) return py::none();
    const py::capsule owner(new std::shared_ptr<const TextureImage>(image), [](void* held) {
        delete static_cast<std::shared_ptr<const TextureImage>*>(held);
    });
    return std::visit(
        [&]<class Word>(const std::vector<Word>& words) -> py::object {
            py::array_t<Word> texels({image->height, image->width, image->channels()}, words.data(), owner);
            texels.attr("flags").attr("writeable") = false;
            return texels;
        },
        image->words);
}

void set_color_map(TextureBox& texture, const py::handle& value) {
    Texture made = texture.value;
    made.color_map = to_color_map(value);
    if (made.color_map.empty() && !made.image)
        throw py::value_error("color_map: expected colors, as the texture has no image");
    if (!made.color_map.empty()) {
        made.image = nullptr;
        made.file.clear();
        if (const std::string mistake = mistake_in(made); !mistake.empty()) throw py::value_error(mistake);
    }
    texture.value = std::move(made);
}

void set_map(TextureBox& texture, const py::handle& matrix) {
    texture.value.world_from_texture = matrix.is_none() ? Affine{} : to_affine(matrix, "world_from_texture");
}

// Chains end, so that those who walk them do.
void set_over(TextureBox& texture, std::shared_ptr<TextureBox> over) {
    int layers = 1;
    for (const TextureBox* below = over.get(); below; below = below->over.get()) {
        if (below == &texture) throw py::value_error("over: expected another texture, found a circle");
        if (++layers > k_max_texture_layers)
            throw py::value_error(
                fmt::format("over: expected at most {} layers, found more", k_max_texture_layers));
    }
    texture.over = std::move(over);
}

std::shared_ptr<TextureBox> make_texture(const py::object& image, const py::object& colors,
                                         const py::kwargs& keywords) {
    static constexpr std::string_view others[] = {"world_from_texture", "name", "over"};
    auto texture = std::make_shared<TextureBox>();
    if (image.is_none() == colors.is_none())
        throw py::type_error("Texture: expected an image or a color_map, found " +
                             std::string(colors.is_none() ? "None" : "both"));
    if (colors.is_none()) {
        set_image(*texture, image);
    } else {
        set_color_map(*texture, colors);
    }
    set_fields(texture->value, keywords, "Texture", others);
    if (keywords.contains("world_from_texture")) set_map(*texture, keywords["world_from_texture"]);
    if (keywords.contains("over")) set_over(*texture, to_texture(keywords["over"], "over"));
    texture->name = name_in(keywords);
    return texture;
}

std::string describe(const TextureBox& texture) {
    const Texture& value = texture.value;
    std::string text = "Texture(<no image>";
    if (value.image)
        text = fmt::format("Texture(<{} x {} texels{}>", value.image->width, value.image->height,
                           value.image->has_alpha ? " with alpha" : "");
    if (!value.color_map.empty()) text = "Texture(color_map=" + repr_of(to_python(texture.value.color_map));
    if (const std::string fields = changed_fields(value, Texture{}, texture.name); !fields.empty())
        text += ", " + fields;
    if (!(value.world_from_texture == Affine{}))
        text += ", world_from_texture=" + repr_of(to_python(value.world_from_texture).attr("tolist")());
    if (texture.over) text += ", over=" + describe(*texture.over);
    return text + ")";
}

}  // namespace

std::shared_ptr<TextureBox> to_texture(const py::handle& value, std::string_view name) {
    if (value.is_none()) return nullptr;
    if (py::isinstance<TextureBox>(value)) return value.cast<std::shared_ptr<TextureBox>>();
    throw py::type_error(fmt::format("{}: expected a Texture or None, found {}", name, repr_of(value)));
}

std::shared_ptr<TextureBox> deep_copy(const TextureBox& texture) {
    auto copy = std::make_shared<TextureBox>(texture);
    if (copy->over) copy->over = deep_copy(*copy->over);
    return copy;
}

bool same(const TextureBox& a, const TextureBox& b) {
    if (a.name != b.name || !same(a.value, b.value)) return false;
    return a.over && b.over ? same(*a.over, *b.over) : a.over == b.over;
}

bool same(const Texture& a, const Texture& b) {
    if (!same_fields(a, b) || !(a.world_from_texture == b.world_from_texture)) return false;
    if (!(a.color_map == b.color_map)) return false;
    return a.image == b.image || (a.image && b.image && *a.image == *b.image);
}

void bind_textures(py::module_& m) {
    py::class_<TextureBox, std::shared_ptr<TextureBox>> cls(
        m, "Texture",
        "Texture(image, mapping='uv', ...): a picture on surfaces, whose materials refer to it. image: an "
        "array of height x width x 3 (r, g, b) or 4 (and alpha) of uint8 or uint16, the first row at the "
        "top; the name of a PNG, JPEG, TGA or PPM file; or the bytes of one. u goes to the right and v up; "
        "(0, 0) is the picture's lower left corner, and (1, 1) its upper right corner. color_map: in place "
        "of an "
        "image, colors by u, such as [(0, 'white'), (0.5, 'black')] with mapping='checker', "
        "filter='nearest'.");
    cls.def(py::init(&make_texture), py::arg("image") = py::none(), py::arg("color_map") = py::none());
    bind_fields<Texture>(cls, &TextureBox::value);
    cls.def_property(
        "over", [](const TextureBox& t) { return t.over; },
        [](TextureBox& t, const py::object& over) { set_over(t, to_texture(over, "over")); },
        "The Texture that is seen where this one is transparent, or is not; None: none. Not with "
        "alpha='mask'.");
    cls.def_property("image", &texels_of, &set_image,
                     "The texels, a read-only array of height x width x 3 or 4 of uint8 or uint16, the first "
                     "row at the top. They do not change in place: assign another array, a file's name, or "
                     "bytes.")
        .def_property(
            "color_map", [](const TextureBox& t) { return to_python(t.value.color_map); }, &set_color_map,
            "In place of an image: 1 to 256 of (place, color) or (place, color, alpha), by place, "
            "a number of u "
            "from 0 to 1; None: there is an image")
        .def_property(
            "world_from_texture", [](const TextureBox& t) { return to_python(t.value.world_from_texture); },
            &set_map,
            "Where the texture is in the world, for mappings other than 'uv': an array of 3 x 4 numbers, "
            "also given as 4 x 4; None: not moved")
        .def_property(
            "file", [](const TextureBox& t) { return t.value.file; },
            [](TextureBox& t, const std::string& file) { t.value.file = file; },
            "The name of the picture's file, which to_glint() writes; empty: it writes the texels")
        .def_readwrite("name", &TextureBox::name, "For scene.textures[name]; may be empty.")
        .def("__eq__",
             [](const TextureBox& a, const py::object& other) {
                 if (!py::isinstance<TextureBox>(other)) return false;
                 return same(a, other.cast<const TextureBox&>());
             })
        .def("__repr__", &describe);
    cls.def("__copy__", [](const TextureBox& box) { return std::make_shared<TextureBox>(box); });
    cls.def(
        "__deepcopy__", [](const TextureBox& box, const py::dict&) { return deep_copy(box); },
        py::arg("memo"));
    cls.attr("__hash__") = py::none();
}

}  // namespace glint::python
