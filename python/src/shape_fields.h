// SPDX-License-Identifier: Apache-2.0
#pragma once
// The parameters of each kind of shape, for its Python class: visit.point(), direction(), length(), radius()
// (which may be 0), flag() or points() for each.
#include "glint/shapes.h"

namespace glint::python {

template <class Self, class Visit>
requires requires(Self& self, Visit& visit) { std::remove_const_t<Self>::fields(self, visit); }
void visit_parameters(Self& self, Visit&& visit) { std::remove_const_t<Self>::fields(self, visit); }

template <class Visit, class Self>
requires std::same_as<std::remove_const_t<Self>, Cylinder>
void visit_parameters(Self& s, Visit&& visit) {
    visit.point("from_", s.from);
    visit.point("to", s.to);
    visit.length("radius", s.radius);
    visit.flag("caps", s.caps);
}

template <class Visit, class Self>
requires std::same_as<std::remove_const_t<Self>, Cone>
void visit_parameters(Self& s, Visit&& visit) {
    visit.point("from_", s.from);
    visit.point("to", s.to);
    visit.radius("from_radius", s.from_radius);
    visit.radius("to_radius", s.to_radius);
    visit.flag("caps", s.caps);
}

template <class Visit, class Self>
requires std::same_as<std::remove_const_t<Self>, Box>
void visit_parameters(Self& s, Visit&& visit) {
    visit.point("min", s.min);
    visit.point("max", s.max);
}

template <class Visit, class Self>
requires std::same_as<std::remove_const_t<Self>, Triangle>
void visit_parameters(Self& s, Visit&& visit) { visit.points("vertices", s.vertices); }

template <class Visit, class Self>
requires std::same_as<std::remove_const_t<Self>, SmoothTriangle>
void visit_parameters(Self& s, Visit&& visit) {
    visit.points("vertices", s.vertices);
    visit.points("normals", s.normals);
}

}  // namespace glint::python
