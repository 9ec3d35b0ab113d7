// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include <algorithm>

namespace glint::python {
namespace {

constexpr const char* k_severities[] = {"note", "warning", "error"};

std::string without_newline(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

}  // namespace

void raise(const Status& status) {
    if (status.code == ErrorCode::out_of_memory) {
        PyErr_SetString(PyExc_MemoryError, status.message.c_str());
        throw py::error_already_set();
    }
    py::list diagnostics;
    for (const Diagnostic& d : status.diagnostics) diagnostics.append(py::cast(d));
    std::string text = without_newline(to_string(status));
    if (text.starts_with("error: ")) text.erase(0, std::string_view("error: ").size());
    const py::object error =
        from_package("glint._errors", "make_error")(std::string(to_string(status.code)), text, diagnostics);
    PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
    throw py::error_already_set();
}

void warn(const std::vector<Diagnostic>& diagnostics) {
    const py::object show = from_package("glint._errors", "warn");
    for (const Diagnostic& d : diagnostics)
        if (d.severity == Severity::warning) show(d);
}

void bind_errors(py::module_& m) {
    py::class_<Diagnostic>(m, "Diagnostic", "One message about a scene: what is wrong, and where.")
        .def_property_readonly(
            "severity", [](const Diagnostic& d) { return k_severities[static_cast<int>(d.severity)]; },
            "'note', 'warning' or 'error'")
        .def_readonly("file", &Diagnostic::file, "The file as it was named; empty if there is no place.")
        .def_readonly("line", &Diagnostic::line, "From 1; 0 if there is no place.")
        .def_readonly("column", &Diagnostic::column, "In bytes, from 1.")
        .def_readonly("message", &Diagnostic::message, "What is wrong: \"expected a number, found 'oops'\"")
        .def_property_readonly(
            "item", [](const Diagnostic& d) { return item_path(d); },
            "The item of the scene: 'lights[1]', 'camera'; empty if the message is about none.")
        .def_readonly("can_skip", &Diagnostic::can_skip,
                      "Whether this error is about something that skip_unsupported leaves out.")
        .def(py::pickle(
            [](const Diagnostic& d) {
                return py::make_tuple(static_cast<int>(d.severity), d.file, d.line, d.column, d.length,
                                      d.message, d.source_line, d.caret, static_cast<int>(d.item), d.index,
                                      d.left_out, d.can_skip);
            },
            [](const py::tuple& t) {
                if (t.size() != 12) throw py::value_error("this is no pickled glint.Diagnostic");
                return Diagnostic{static_cast<Severity>(std::clamp(t[0].cast<int>(), 0, 2)),
                                  t[1].cast<std::string>(),
                                  t[2].cast<std::uint32_t>(),
                                  t[3].cast<std::uint32_t>(),
                                  t[4].cast<std::uint32_t>(),
                                  t[5].cast<std::string>(),
                                  t[6].cast<std::string>(),
                                  t[7].cast<std::uint32_t>(),
                                  static_cast<SceneItem>(std::clamp(t[8].cast<int>(), 0, 9)),
                                  t[9].cast<std::uint32_t>(),
                                  t[10].cast<std::uint32_t>(),
                                  t[11].cast<bool>()};
            }))
        .def("__str__", [](const Diagnostic& d) { return without_newline(to_string(d)); })
        .def("__repr__", [](const Diagnostic& d) {
            return "<glint.Diagnostic " + without_newline(to_string(d)).substr(0, 200) + ">";
        });
}

}  // namespace glint::python
