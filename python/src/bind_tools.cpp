// SPDX-License-Identifier: Apache-2.0
// Reading, rendering and questioning a scene.
#include <pybind11/stl.h>

#include "base/text.h"
#include "cli/explain_text.h"
#include "cli/file_policy.h"
#include "cli/view_argument.h"
#include "errors.h"
#include "os/files.h"
#include "rendering.h"
#include "scene_state.h"
#include "world/world.h"

namespace glint::python {
namespace {

// Files that scenes include, found and permitted as by the command.
class IncludedFiles : public Sources {
  public:
    IncludedFiles(std::vector<std::string> folders, cli::FileReach reach)
        : folders_(std::move(folders)), reach_(std::move(reach)) {}
    Result<std::string> read(std::string_view name, std::string_view from) override {
        std::string first_why;
        for (const std::string& path : cli::included_paths(name, from, folders_)) {
            std::string why;
            if (auto text = cli::read_named_file(path, reach_, why)) return *std::move(text);
            if (first_why.empty()) first_why = std::move(why);
        }
        return Status{ErrorCode::io, first_why.empty() ? "no such file" : std::move(first_why), {}};
    }

  private:
    std::vector<std::string> folders_;
    cli::FileReach reach_;
};

// [(name, text, format)] as one scene.
void load_texts(SceneState& state,
                const std::vector<std::tuple<std::string, std::string, std::string>>& texts,
                const std::string& scene_name, const std::string& profile,
                const std::optional<std::pair<std::string, std::string>>& profile_text,
                const SettingList& settings, std::uint64_t max_memory,
                const std::vector<std::string>& folders, const std::string& includes, bool skip_unsupported,
                const std::string& view, const py::object& progress) {
    std::vector<SceneText> views;
    cli::FileReach reach{.is_confined = includes != "any", .folders = folders};
    for (const auto& text : texts) reach.folders.push_back(os::folder_of(std::get<0>(text)));
    for (const auto& [name, text, format] : texts) views.push_back({name, text, format});
    LoadOptions options;
    options.scene_name = scene_name;
    options.profile = profile;
    options.settings = settings;
    options.max_memory = max_memory;
    options.skip_unsupported = skip_unsupported;
    if (!view.empty()) {
        options.view = cli::parse_view(view);
        if (!options.view) throw py::value_error("view: " + cli::view_message(view));
    }
    if (profile_text) options.profile_text = SceneText{profile_text->first, profile_text->second, {}};
    IncludedFiles sources(folders, std::move(reach));
    Result<Scene> result = run(progress, [&](Running& running) {
        LoadOptions with = options;
        with.progress = running.report();
        with.cancel = &running.cancel;
        return load(views, with, includes == "none" ? nullptr : &sources);
    });
    const std::vector<Diagnostic> warnings = result.diagnostics;
    state.reset(value_or_raise(std::move(result)));
    state.warn_once(warnings);
}

std::string lights_text(const Scene& scene) {
    std::string known;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const std::string_view name = scene.light_texts.name(i);
        known += (known.empty() ? "" : ", ") + std::to_string(i + 1);
        if (!name.empty()) known += " (" + std::string(name) + ")";
    }
    return known.empty() ? "the scene has no lights" : "there are " + known;
}

std::vector<Layer> layers_of(const std::vector<std::string>& names, const Scene& scene) {
    std::vector<Layer> layers;
    for (const std::string& name : names) {
        const auto layer = find_layer(name, scene);
        if (!layer && name.starts_with("light:"))
            throw py::value_error("there is no light '" + name.substr(6) + "'; " + lights_text(scene));
        if (!layer) {
            std::string known;
            for (const LayerInfo& info : layer_infos())
                known += (known.empty() ? "" : ", ") + std::string(info.name);
            throw py::value_error("there is no layer '" + name + "'; there are " + known + ", light:NAME");
        }
        layers.push_back(*layer);
    }
    return layers;
}

std::shared_ptr<Rendering> render_scene(SceneState& state, const SettingList& settings,
                                        const std::vector<std::string>& layers,
                                        const std::optional<std::array<std::int32_t, 4>>& crop, int threads,
                                        const std::string& isa, const py::object& progress) {
    RenderOptions options;
    options.layers = layers_of(layers, state.scene());
    if (crop) options.crop = Crop{(*crop)[0], (*crop)[1], (*crop)[2], (*crop)[3]};
    options.threads = threads;
    options.isa = isa;
    const Snapshot snapshot = state.prepare(settings, py::none(), threads);
    const bool has_alpha =
        std::find(options.layers.begin(), options.layers.end(), Layer::alpha) != options.layers.end();
    if (snapshot.world.parts().settings.alpha && !has_alpha) options.layers.push_back(Layer::alpha);
    return std::make_shared<Rendering>(value_or_raise(run(progress, [&](Running& running) {
        options.progress = running.report();
        options.cancel = &running.cancel;
        return render(snapshot.world, options);
    })));
}

// JSON, and the text that `glint explain` prints.
py::tuple explain_pixel(SceneState& state, std::int32_t x, std::int32_t y, const SettingList& settings,
                        std::optional<int> sample, double fold, const py::object& progress) {
    const Snapshot snapshot = state.prepare_changed(settings, progress);
    const Scene& scene = *snapshot.scene;
    const int n = scene.settings.samples;
    cli::ExplainStyle style;
    style.sample = sample.value_or(n / 2 * n + n / 2);
    style.fold = fold;
    if (style.sample < 0 || style.sample >= n * n) throw py::index_error("sample out of range");
    style.file.set_rule(scene.conventions.byte_rule());
    // JSON explains all samples, the text one.
    const auto explain_sample = [&](int which) {
        ExplainOptions options;
        options.sample = which;
        return value_or_raise(
            run(progress, [&](Running&) { return explain(scene, snapshot.world, x, y, options); }));
    };
    const Explanation all = explain_sample(-1);
    const bool is_listed = all.samples > 1 && all.samples <= cli::k_max_listed_samples;
    std::string text =
        cli::explanation_text(all.samples > 1 ? explain_sample(style.sample) : all, scene, style);
    if (is_listed) text += cli::samples_text(all, scene, style);
    return py::make_tuple(value_or_raise(explanation_json(all, scene, style.file)), printable_lines(text));
}

std::string write_whole_glint(SceneState& state) {
    Scene scene = state.scene();
    for (Texture& texture : scene.textures) texture.file.clear();
    return value_or_raise(write_glint(scene));
}

py::bytes write_as(SceneState& state, const std::string& format) {
    Result<std::string> written = write_scene(state.scene(), format);
    const std::vector<Diagnostic> warnings = written.diagnostics;
    const std::string bytes = value_or_raise(std::move(written));
    warn(warnings);
    return bytes;
}

py::list check_scene(SceneState& state, const py::object& progress) {
    const auto scene = state.shared_scene();
    const std::vector<Finding> findings = value_or_raise(run(progress, [&](Running& running) {
        CheckOptions options;
        options.progress = running.report();
        options.cancel = &running.cancel;
        return check(*scene, options);
    }));
    py::list list;
    for (const Finding& f : findings)
        list.append(py::make_tuple(std::string(f.id), f.diagnostic, f.remedy, to_string(f)));
    return list;
}

}  // namespace

void bind_tools(py::module_& m, py::class_<SceneState, std::shared_ptr<SceneState>>& cls) {
    cls.def("load_texts", &load_texts)
        .def("render", &render_scene)
        .def("explain", &explain_pixel)
        .def("check", &check_scene)
        .def("write_glint", [](SceneState& s) { return value_or_raise(write_glint(s.scene())); })
        .def("write_scene", &write_as, "The bytes of a file in a format of written_formats(), by its name.")
        .def("write_whole_glint", &write_whole_glint,
             "As write_glint(), with the texels of textures instead of the names of files.")
        .def("validate", [](SceneState& s) { return validate(s.scene()); });
    m.def("isa_names", &isa_names, "The instruction sets that this machine has, best first.");
    m.def("formats", [] {
        py::list list;
        for (const FormatInfo& f : formats())
            list.append(
                py::make_tuple(std::string(f.name), std::string(f.extensions), std::string(f.description)));
        return list;
    });
    m.def("written_formats", [] {
        py::list list;
        for (const WrittenFormat& f : written_formats())
            list.append(
                py::make_tuple(std::string(f.name), std::string(f.extension), std::string(f.description)));
        return list;
    });
    m.def("check_kinds", [] {
        py::dict kinds;
        for (const CheckKind& kind : check_kinds())
            kinds[py::str(std::string(kind.id))] = std::string(kind.description);
        return kinds;
    });
}

}  // namespace glint::python
