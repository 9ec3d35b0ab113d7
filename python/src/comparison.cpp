// SPDX-License-Identifier: Apache-2.0
// Comparing pictures, and points by a rubric.
#include <pybind11/stl.h>

#include "base/text.h"
#include "cli/compare_report.h"
#include "cli/failure.h"
#include "cli/submissions.h"
#include "errors.h"
#include "grade/grade_by_rubric.h"
#include "image/quantize.h"
#include "rendering.h"
#include "run.h"
#include "scene_state.h"

namespace glint::python {
namespace {

using StatePointer = std::shared_ptr<SceneState>;
using RenderingPointer = std::shared_ptr<Rendering>;

CauseOptions cause_options(Running& running, bool as_floats, std::uint64_t max_memory = 0) {
    CauseOptions options;
    options.as_floats = as_floats;
    options.progress = running.report();
    options.cancel = &running.cancel;
    options.max_memory = max_memory;
    return options;
}

// JSON and text, as `glint compare` prints them.
py::tuple compare_pictures(const Rendering& a, const Rendering& b, const std::string& name_a,
                           const std::string& name_b, const StatePointer& scene, bool causes, bool as_floats,
                           double within, std::uint64_t max_memory, const py::object& progress) {
    const auto shared = scene ? scene->shared_scene() : nullptr;
    cli::CompareReport report;
    report.a = name_a;
    report.b = name_b;
    report.width = a.image.width;
    report.height = a.image.height;
    report.as_floats = as_floats;
    report.within = within;
    report.with_scene = shared != nullptr;
    const auto given = [&](const Rendering& r) {
        return as_written(r.image, as_floats ? ByteRule{} : r.rule);
    };
    const Image picture = given(a), reference = given(b);
    report.difference = value_or_raise(run(progress, [&](Running&) {
        return compare(picture, reference, {as_floats, within, 0, max_memory});
    }));
    const PictureDifference& d = report.difference;
    report.passes = d.all.equal == d.all.pixels;
    if (causes && !report.passes && d.not_finite == 0) {
        report.causes = run(progress, [&](Running& running) {
            return find_causes(picture, reference, shared.get(),
                               cause_options(running, as_floats, max_memory));
        });
    }
    return py::make_tuple(cli::json_report(report), printable_lines(cli::text_report(report)));
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
    for (const RenderingPointer& picture : pictures)
        images.push_back(as_written(picture->image, picture->rule));
    const auto reports = run(progress, [&](Running& running) {
        return find_causes(images, as_written(reference.image, reference.rule), scene.get(),
                           cause_options(running, false));
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

Rubric load_rubric(const std::string& name, const std::string& text) {
    RubricResult read = read_rubric(name, text);
    if (!read.diagnostics.empty())
        raise({ErrorCode::parse, read.diagnostics.front().message, read.diagnostics});
    return std::move(read.rubric);
}

// Submissions whose pictures a function of Python finds.
class PythonSubmissions : public Submissions {
  public:
    PythonSubmissions(std::vector<std::string> names, const py::function& find)
        : names_(std::move(names)), find_(find) {}
    std::vector<std::string> names() const override { return names_; }
    HandedIn find(std::size_t submission, const RubricRow& row) override {
        const py::gil_scoped_acquire gil;
        try {
            const py::tuple found = find_(submission, row.file);
            HandedIn picture{found[0].cast<std::string>(), found[1].cast<std::string>(), {}};
            if (!found[2].is_none()) picture.image = found[2].cast<const Rendering&>().image;
            return picture;
        } catch (const std::exception& e) {
            return {{}, e.what(), {}};
        }
    }

  private:
    const std::vector<std::string> names_;
    const py::function& find_;
};

py::tuple part_tuple(const GradedPart& part) {
    py::object cause = py::none();
    if (part.cause) cause = py::str(part.cause->name);
    return py::make_tuple(part.score.points, part.error, cause,
                          part.cause ? part.cause->explanation : std::string(), part.points_alone,
                          py::tuple(py::cast(part.followed)));
}

// (name, points) of each part, and for each submission what part_tuple() gives for each part, and (cause,
// points) of each penalty.
py::tuple grade_class(SceneState& state, const std::string& name, const std::string& text,
                      const std::vector<std::string>& names, const py::function& find,
                      const py::object& progress) {
    const auto scene = state.shared_scene();
    const Rubric rubric = load_rubric(name, text);
    PythonSubmissions submissions(names, find);
    const auto graded = value_or_raise(run(progress, [&](Running& running) {
        RubricOptions options;
        options.progress = running.report();
        options.cancel = &running.cancel;
        return grade_by_rubric(*scene, rubric, submissions, options);
    }));
    py::list parts, results;
    for (const RubricRow& row : rubric.rows) parts.append(py::make_tuple(row.part, row.points));
    for (const GradedSubmission& submission : graded) {
        py::list list, penalties;
        for (const GradedPart& part : submission.parts) list.append(part_tuple(part));
        for (const RubricPenalty& penalty : submission.penalties)
            penalties.append(py::make_tuple(penalty.cause, penalty.points));
        results.append(py::make_tuple(list, py::tuple(penalties)));
    }
    return py::make_tuple(parts, results);
}

// (name, path, error) of each folder of a class.
py::list submission_folders(const std::string& folder) {
    py::list list;
    try {
        for (const cli::Submission& s : cli::list_folders(folder))
            list.append(py::make_tuple(s.name, s.path, s.error));
    } catch (const cli::Failure& e) {
        raise({ErrorCode::invalid_argument, e.what(), {}});
    }
    return list;
}

}  // namespace

void bind_comparison(py::module_& m) {
    m.def("compare", &compare_pictures);
    m.def("difference", &difference);
    m.def("find_causes", [](const std::vector<RenderingPointer>& pictures, const Rendering& reference,
                            const StatePointer& scene, const py::object& progress) {
        return grade_causes(pictures, reference, scene ? scene->shared_scene() : nullptr, progress);
    });
    m.def("grade_by_rubric", &grade_class);
    m.def("submission_folders", &submission_folders);
    m.def("is_match", &cli::is_match);
}

}  // namespace glint::python
