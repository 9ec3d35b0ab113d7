// SPDX-License-Identifier: Apache-2.0
// Comparing pictures, and points by a rubric.
#include <pybind11/stl.h>

#include "cli/compare_report.h"
#include "errors.h"
#include "grade/part_renderer.h"
#include "rendering.h"
#include "run.h"
#include "scene_state.h"

namespace glint::python {
namespace {

using StatePointer = std::shared_ptr<SceneState>;
using RenderingPointer = std::shared_ptr<Rendering>;

CauseOptions cause_options(Running& running, bool as_floats) {
    CauseOptions options;
    options.as_floats = as_floats;
    options.progress = running.report();
    options.cancel = &running.cancel;
    return options;
}

// JSON and text, as `glint compare` prints them.
py::tuple compare_pictures(const Rendering& a, const Rendering& b, const std::string& name_a,
                           const std::string& name_b, const StatePointer& scene, bool causes, bool as_floats,
                           double within, const py::object& progress) {
    const auto shared = scene ? scene->shared_scene() : nullptr;
    cli::CompareReport report;
    report.a = name_a;
    report.b = name_b;
    report.width = a.image.width;
    report.height = a.image.height;
    report.as_floats = as_floats;
    report.within = within;
    report.with_scene = shared != nullptr;
    report.difference = value_or_raise(run(progress, [&](Running&) {
        return compare(a.image, b.image, {as_floats, within, 0});
    }));
    const PictureDifference& d = report.difference;
    report.passes = d.all.equal == d.all.pixels;
    if (causes && !report.passes && d.not_finite == 0) {
        report.causes = run(progress, [&](Running& running) {
            return find_causes(a.image, b.image, shared.get(), cause_options(running, as_floats));
        });
    }
    return py::make_tuple(cli::json_report(report), cli::text_report(report));
}

RenderingPointer difference(const Rendering& a, const Rendering& b, double gain) {
    auto picture = std::make_shared<Rendering>();
    picture->image = value_or_raise(difference_image(a.image, b.image, gain));
    return picture;
}

// The most likely cause of each picture's difference from the reference: (name, explanation, explained) or
// None.
py::list grade_causes(const std::vector<RenderingPointer>& pictures, const Rendering& reference,
                      const std::shared_ptr<const Scene>& scene, const py::object& progress) {
    std::vector<Image> images;
    for (const RenderingPointer& picture : pictures) images.push_back(picture->image);
    const auto reports = run(progress, [&](Running& running) {
        return find_causes(images, reference.image, scene.get(), cause_options(running, false));
    });
    py::list list;
    for (const Result<CauseReport>& report : reports) {
        if (!report && report.code == ErrorCode::cancelled) raise(report);
        if (!report || report->causes.empty()) {
            list.append(py::none());
            continue;
        }
        const Cause& cause = report->causes.front();
        list.append(py::make_tuple(cause.name, cause.explanation, cause.explained));
    }
    return list;
}

struct Part {
    RubricRow row;
    WantedPicture wanted;
};

std::vector<RubricRow> rubric_rows(const std::string& name, const std::string& text) {
    RubricResult rubric = read_rubric(name, text);
    if (!rubric.diagnostics.empty())
        raise({ErrorCode::parse, rubric.diagnostics.front().message, rubric.diagnostics});
    return std::move(rubric.rows);
}

// The parts of a rubric, each with the picture that it requires.
std::vector<std::shared_ptr<Part>> rubric_parts(SceneState& state, const std::string& name,
                                                const std::string& text, const py::object& progress) {
    const auto scene = state.shared_scene();
    const PartRenderer renderer(*scene, 0);
    std::vector<std::shared_ptr<Part>> parts;
    for (const RubricRow& row : rubric_rows(name, text)) {
        auto part = std::make_shared<Part>(Part{row, {}});
        part->wanted = run(progress, [&](Running&) { return renderer.render(row); });
        if (!part->wanted.error.empty())
            raise({ErrorCode::invalid_argument,
                   name + ":" + std::to_string(row.line) + ": part '" + row.part + "': " + part->wanted.error,
                   {}});
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace

void bind_comparison(py::module_& m) {
    m.def("compare", &compare_pictures);
    m.def("difference", &difference);
    m.def("find_causes", [](const std::vector<RenderingPointer>& pictures, const Rendering& reference,
                            const StatePointer& scene, const py::object& progress) {
        return grade_causes(pictures, reference, scene ? scene->shared_scene() : nullptr, progress);
    });
    py::class_<Part, std::shared_ptr<Part>>(m, "RubricPart")
        .def_property_readonly("name", [](const Part& p) { return p.row.part; })
        .def_property_readonly("points", [](const Part& p) { return p.row.points; })
        .def_property_readonly("file", [](const Part& p) { return p.row.file; })
        .def("wanted",
             [](const Part& p) {
                 auto picture = std::make_shared<Rendering>();
                 picture->image = p.wanted.image;
                 return picture;
             })
        .def("grade",
             [](const Part& p, const Rendering& picture) {
                 const auto& wanted = p.wanted.image;
                 if (picture.image.width != wanted.width || picture.image.height != wanted.height)
                     throw py::value_error("the picture has another size than the reference");
                 const PartScore score = grade(picture.image, p.wanted, p.row.points, 0);
                 return py::make_tuple(score.points, score.share, score.part_share);
             })
        .def("causes",
             [](const Part& p, const std::vector<RenderingPointer>& pictures, const py::object& progress) {
                 Rendering reference;
                 reference.image = p.wanted.image;
                 return grade_causes(pictures, reference, std::make_shared<Scene>(p.wanted.scene), progress);
             });
    m.def("rubric_parts", &rubric_parts);
}

}  // namespace glint::python
