// SPDX-License-Identifier: Apache-2.0
// The light from all directions and the background gradient as Python objects.
#include "scene/sky_fields.h"

#include "item_fields.h"

namespace glint::python {

template <> std::span<const ItemField<Occlusion>> fields_of() { return k_occlusion_fields; }
template <> std::span<const ItemField<BackgroundGradient>> fields_of() { return k_gradient_fields; }

namespace {

/// One of two words, of which to_string() has the text.
template <class Word> Word read_word(const char* name, const std::string& text) {
    for (const Word word : {Word{0}, Word{1}})
        if (to_string(word) == text) return word;
    throw py::value_error(fmt::format("{}: expected '{}' or '{}', found '{}'", name, to_string(Word{0}),
                                      to_string(Word{1}), text));
}

/// A class whose first argument is a word.
template <class Item, class Word>
void bind_item(py::module_& m, const char* name, const char* word_name, Word Item::*word,
               const char* description) {
    using Box = SharedItem<Item>;
    py::class_<Box, std::shared_ptr<Box>> cls(m, name, description);
    cls.def(py::init([=](const std::string& text, const py::kwargs& keywords) {
                Box item;
                item.value.*word = read_word<Word>(word_name, text);
                static constexpr std::string_view colors[] = {"color_map"};
                constexpr bool has_colors = requires { item.value.color_map; };
                set_fields(item.value, keywords, name, std::span(colors).first(has_colors ? 1 : 0));
                if constexpr (has_colors) {
                    if (keywords.contains("color_map"))
                        item.value.color_map = to_color_map(keywords["color_map"]);
                }
                return std::make_shared<Box>(item);
            }),
            py::arg(word_name) = std::string(to_string(Word{0})));
    bind_fields<Item>(cls, &Box::value);
    if constexpr (requires(Item item) { item.color_map; }) {
        cls.def_property(
            "color_map", [](const Box& b) { return to_python(b.value.color_map); },
            [](Box& b, const py::object& colors) { b.value.color_map = to_color_map(colors); },
            "In place of the two colors, 1 to 256 of (place, color), by place: 0 is at `bottom`, 1 at `top`; "
            "None: the two");
    }
    cls.def_property(
           word_name, [=](const Box& b) { return std::string(to_string(b.value.*word)); },
           [=](Box& b, const std::string& text) { b.value.*word = read_word<Word>(word_name, text); },
           fmt::format("'{}' or '{}'", to_string(Word{0}), to_string(Word{1})).c_str())
        .def("__eq__",
             [](const Box& a, const py::object& other) {
                 return py::isinstance<Box>(other) && same(a.value, other.cast<const Box&>().value);
             })
        .def("__repr__", [=](const Box& b) {
            Item usual;
            usual.*word = b.value.*word;
            std::string fields = changed_fields(b.value, usual);
            if constexpr (requires { usual.color_map; }) {
                if (!b.value.color_map.empty())
                    fields += (fields.empty() ? "color_map=" : ", color_map=") +
                              repr_of(to_python(b.value.color_map));
            }
            return fmt::format("{}('{}'{}{})", name, to_string(b.value.*word), fields.empty() ? "" : ", ",
                               fields);
        });
    bind_copies<decltype(cls), Box>(cls, [](const Box& b) { return b; });
    cls.attr("__hash__") = py::none();
}

}  // namespace

bool same(const Occlusion& a, const Occlusion& b) { return a.method == b.method && same_fields(a, b); }
bool same(const BackgroundGradient& a, const BackgroundGradient& b) {
    return a.kind == b.kind && same_fields(a, b) && a.color_map == b.color_map;
}

void bind_sky(py::module_& m) {
    bind_item(
        m, "Occlusion", "method", &Occlusion::method,
        "Light from all directions that shapes block (ambient occlusion): a surface reflects k_d color f, "
        "where f is the part that arrives. method 'hashed': other directions at each point; 'fixed': the "
        "same for all pixels, as in Tachyon.");
    bind_item(
        m, "BackgroundGradient", "kind", &BackgroundGradient::kind,
        "A background that changes along `up` from `bottom_color` to `top_color`. kind 'sphere': by the "
        "ray's direction; 'plane': by its origin, for orthographic cameras.");
}

}  // namespace glint::python
