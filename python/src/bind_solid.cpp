// SPDX-License-Identifier: Apache-2.0
// Python's class Solid and the operators that make one.
#include <fmt/format.h>

#include <unordered_map>
#include <utility>

#include "base/text.h"
#include "math/transform.h"
#include "scene/validate_solid.h"
#include "solid.h"

namespace glint::python {
namespace {

// The name of its class, as users write it.
std::string class_of(const ShapeBox& shape) {
    return py::type::of(py::cast(shape.copy())).attr("__name__").cast<std::string>();
}

void check_encloses_space(const ShapeBox& shape, const std::string& where) {
    if (as_solid(shape) != nullptr) return;
    Scene scene;
    shape.append(scene, {});
    if (encloses_space(scene, scene.shapes.front())) return;
    const bool is_open = shape.kind() == ShapeKind::cylinder || shape.kind() == ShapeKind::cone;
    throw py::value_error(fmt::format(
        "{}: expected a shape that encloses a space: a Sphere, Box, Torus, Quadric, Quartic, Plane or Solid, "
        "a "
        "Cylinder or Cone with caps, or a Mesh whose edges are each in two triangles in opposite directions; "
        "found a {}{}",
        where, class_of(shape), is_open ? " without caps" : ""));
}

// Materials with another color, one for each that is given.
class Painter {
  public:
    explicit Painter(Color color) : color_(color) {}
    std::shared_ptr<MaterialBox> paint(const std::shared_ptr<MaterialBox>& material) {
        auto& painted = painted_[material.get()];
        if (!painted) {
            painted = std::make_shared<MaterialBox>(material ? *material : MaterialBox{});
            painted->value = with_color(painted->value, color_);
            painted->name.clear();
        }
        return painted;
    }

  private:
    Color color_;
    std::unordered_map<const MaterialBox*, std::shared_ptr<MaterialBox>> painted_;
};

// A copy as SolidBox has it.
std::shared_ptr<const ShapeBox> as_part(const ShapeBox& given, const std::string& where) {
    check_encloses_space(given, where);
    const std::shared_ptr<ShapeBox> part = given.copy();
    part->name.clear();
    std::optional<Painter> painter;
    if (part->color) painter.emplace(*std::exchange(part->color, {}));
    auto* const solid = dynamic_cast<SolidBox*>(part.get());
    if (solid == nullptr) {
        if (painter) part->material = painter->paint(part->material);
        return part;
    }
    if (!painter && !solid->material && !solid->transform) return part;
    solid->change_operands([&](ShapeBox& operand) {
        if (!operand.material) operand.material = solid->material;
        if (painter) operand.material = painter->paint(operand.material);
        if (!solid->transform) return;
        operand.transform =
            operand.transform ? compose(*solid->transform, *operand.transform) : *solid->transform;
    });
    solid->material = nullptr;
    solid->transform.reset();
    return part;
}

void check_tree(const SolidBox& solid) {
    if (solid.parts.empty()) throw py::value_error("parts: expected one shape or more, found none");
    if (solid.operation == SolidOperation::inverse && solid.parts.size() != 1)
        throw py::value_error(
            fmt::format("parts: expected one shape for 'inverse', found {}", solid.parts.size()));
    if (const std::string mistake = mistake_in_steps(solid.tree()); !mistake.empty())
        throw py::value_error("parts: " + mistake);
}

SolidOperation to_operation(const std::string& word) {
    std::vector<std::string_view> words;
    for (const SolidOperation operation : k_combinations) {
        if (to_string(operation) == word) return operation;
        words.push_back(to_string(operation));
    }
    throw py::value_error(fmt::format("operation: expected one of {}, found {}{}", fmt::join(words, ", "),
                                      repr_of(py::str(word)), did_you_mean(word, words)));
}

const ShapeBox& to_shape(const py::handle& given, const std::string& where) {
    if (!py::isinstance<ShapeBox>(given))
        throw py::type_error(fmt::format("{}: expected a shape, found {}", where, repr_of(given)));
    return given.cast<const ShapeBox&>();
}

std::vector<std::shared_ptr<const ShapeBox>> to_parts(const py::object& given) {
    if (py::isinstance<ShapeBox>(given) || !py::isinstance<py::iterable>(given))
        throw py::type_error("parts: expected a sequence of shapes, found " + repr_of(given));
    std::vector<std::shared_ptr<const ShapeBox>> parts;
    for (const py::handle& part : given) {
        const std::string where = fmt::format("parts[{}]", parts.size());
        parts.push_back(as_part(to_shape(part, where), where));
    }
    return parts;
}

// a - b and the like. A solid of the same operation, which has no look of its own, is extended.
std::shared_ptr<SolidBox> combine_two(SolidOperation operation, const ShapeBox& a, const py::object& other) {
    const std::string word(to_string(operation));
    const ShapeBox& b = to_shape(other, word);
    auto solid = std::make_shared<SolidBox>();
    solid->operation = operation;
    const SolidBox* const first = as_solid(a);
    if (first != nullptr && first->operation == operation && first->name.empty() &&
        same_look(*first, SolidBox{})) {
        solid->parts = first->parts;
    } else {
        solid->parts.push_back(as_part(a, word));
    }
    solid->parts.push_back(as_part(b, word));
    check_tree(*solid);
    return solid;
}

}  // namespace

void bind_solid(py::module_& m, py::class_<ShapeBox, std::shared_ptr<ShapeBox>>& shape) {
    py::class_<SolidBox, ShapeBox, std::shared_ptr<SolidBox>>(
        m, "Solid",
        "Solid(operation, parts): shapes that are combined by their insides (constructive solid geometry). "
        "a - b is Solid('difference', [a, b]), a & b 'intersection', a | b 'merge' and ~a 'inverse'. A part "
        "is a Sphere, Box, Torus, Quadric, Quartic, Solid, a Cylinder or Cone with caps, a closed Mesh, or a "
        "Plane, whose inside is opposite to its normal. The surfaces have the materials of their parts; a "
        "part without one has the solid's. "
        "Parts are copied: later changes of them do not change the solid. Their materials are not copied. A "
        "part's name is lost, and its color becomes a material.")
        .def(py::init([](const std::string& operation, const py::object& parts, const py::kwargs& keywords) {
                 auto solid = std::make_shared<SolidBox>();
                 solid->operation = to_operation(operation);
                 solid->parts = to_parts(parts);
                 check_tree(*solid);
                 for (const auto& [key, value] : keywords)
                     if (!set_common(*solid, py::str(key), value))
                         throw py::type_error("solid has no attribute " + repr_of(key));
                 return solid;
             }),
             py::arg("operation"), py::arg("parts"))
        .def_property(
            "operation", [](const SolidBox& solid) { return std::string(to_string(solid.operation)); },
            [](SolidBox& solid, const std::string& word) {
                SolidBox changed = solid;
                changed.operation = to_operation(word);
                check_tree(changed);
                solid.operation = changed.operation;
            },
            "'merge': inside any; only the surface of the whole. 'union': inside any; surfaces within "
            "another "
            "part remain. 'intersection': inside all. 'difference': inside the first and outside of the "
            "others. 'inverse': outside of the only part. 'clip': the first, cut off, without a surface at "
            "the cut, where it is outside of one of the others")
        .def_property(
            "parts", &SolidBox::copied_parts,
            [](SolidBox& solid, const py::object& parts) {
                SolidBox changed = solid;
                changed.parts = to_parts(parts);
                check_tree(changed);
                solid.parts = changed.parts;
            },
            "A tuple of copies of the shapes; to change the solid, set it to other shapes");
    const auto bind = [&](const char* name, SolidOperation operation, const char* doc) {
        shape.def(
            name,
            [operation](const ShapeBox& a, const py::object& b) { return combine_two(operation, a, b); },
            py::arg("other"), doc);
    };
    bind("__sub__", SolidOperation::difference, "The Solid inside this shape and outside of the other one.");
    bind("__and__", SolidOperation::intersection, "The Solid inside both shapes.");
    bind("__or__", SolidOperation::merge, "The Solid inside either shape, with the surface of the whole.");
    shape.def(
        "__invert__",
        [](const ShapeBox& a) {
            auto solid = std::make_shared<SolidBox>();
            solid->operation = SolidOperation::inverse;
            solid->parts.push_back(as_part(a, "inverse"));
            check_tree(*solid);
            return solid;
        },
        "The Solid outside of this shape.");
}

}  // namespace glint::python
