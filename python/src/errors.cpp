// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

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
        .def("__str__", [](const Diagnostic& d) { return without_newline(to_string(d)); })
        .def("__repr__", [](const Diagnostic& d) {
            return "<glint.Diagnostic " + without_newline(to_string(d)).substr(0, 200) + ">";
        });
}

}  // namespace glint::python
