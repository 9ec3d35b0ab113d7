// SPDX-License-Identifier: Apache-2.0
// Another ray tracer's log beside a scene.
#include "glint/diagnose.h"

#include <pybind11/stl.h>

#include "base/text.h"
#include "cli/diagnosis_text.h"
#include "errors.h"
#include "image/quantize.h"
#include "rendering.h"
#include "scene_state.h"

namespace glint::python {
namespace {

// A diagnosis, with the scene that its texts name items of.
struct Diagnosed {
    Diagnosis diagnosis;
    std::shared_ptr<const Scene> scene;
};

std::shared_ptr<Diagnosed> diagnose_log(SceneState& state, const std::string& name, const std::string& log,
                                        const SettingList& settings, std::size_t max_rows, int threads,
                                        const py::object& progress) {
    const Snapshot snapshot = state.prepare_changed(settings, progress);
    Result<Diagnosis> result = run(progress, [&](Running& running) {
        DiagnoseOptions options;
        options.name = name;
        options.threads = threads;
        options.cancel = &running.cancel;
        options.max_rows = max_rows;
        return diagnose(*snapshot.scene, snapshot.world, log, options);
    });
    warn(result.diagnostics);
    return std::make_shared<Diagnosed>(Diagnosed{value_or_raise(std::move(result)), snapshot.scene});
}

// (x, y, kind, difference) of each.
py::list propose(SceneState& state, const Rendering& picture, const SettingList& settings, int threads) {
    const Snapshot snapshot = state.prepare_changed(settings, py::none());
    const auto proposed = value_or_raise(run(py::none(), [&](Running&) {
        return propose_pixels(*snapshot.scene, snapshot.world, as_written(picture.image, picture.rule),
                              threads);
    }));
    py::list list;
    for (const ProposedPixel& pixel : proposed)
        list.append(py::make_tuple(pixel.x, pixel.y, pixel.kind, pixel.difference));
    return list;
}

}  // namespace

void bind_diagnosis(py::module_& m, py::class_<SceneState, std::shared_ptr<SceneState>>& cls) {
    py::class_<Diagnosed, std::shared_ptr<Diagnosed>>(m, "Diagnosed")
        .def("json", [](const Diagnosed& d) { return value_or_raise(diagnosis_json(d.diagnosis, *d.scene)); })
        .def("text",
             [](const Diagnosed& d) { return printable_lines(cli::diagnosis_text(d.diagnosis, *d.scene)); })
        .def("tree", [](const Diagnosed& d, std::int32_t x, std::int32_t y) {
            return printable_lines(cli::diagnosis_tree_text(d.diagnosis, *d.scene, x, y));
        });
    cls.def("diagnose", &diagnose_log).def("propose_pixels", &propose);
}

}  // namespace glint::python
