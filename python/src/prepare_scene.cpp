// SPDX-License-Identifier: Apache-2.0
// The World of a SceneState: only what has changed is prepared anew.
#include <algorithm>
#include <numeric>
#include <optional>

#include "errors.h"
#include "scene_state.h"

namespace glint::python {
namespace {

// Replaces in the World what differs between two versions of its scene. `change`: of the list of shapes;
// `shapes`: those that were edited.
Status update(World& world, const Versions& old, const Versions& now, const Scene& scene,
              const ShapeHistory::Change& change, const std::vector<std::uint32_t>& shapes,
              const PrepareOptions& options, std::vector<Diagnostic>& warnings) {
    Status failed;
    const auto take = [&](Result<World> result) {
        if (result) {
            warnings.insert(warnings.end(), result.diagnostics.begin(), result.diagnostics.end());
            world = *std::move(result);
            return true;
        }
        failed = std::move(result);
        return false;
    };
    if (old.materials != now.materials && !take(with_materials(world, scene.materials))) return failed;
    if (old.lights != now.lights && !take(with_lights(world, scene.lights))) return failed;
    if (old.camera != now.camera && !take(with_camera(world, scene.camera))) return failed;
    if (old.background != now.background && !take(with_background(world, scene.background))) return failed;
    if (old.fog != now.fog && !take(with_fog(world, scene.fog))) return failed;
    if (old.gradient != now.gradient && !take(with_gradient(world, scene.gradient))) return failed;
    if (old.occlusion != now.occlusion && !take(with_occlusion(world, scene.occlusion))) return failed;
    if (old.rules != now.rules && !take(with_rules(world, scene.conventions, scene.settings))) return failed;
    if (!change.removed.empty() || change.added != 0) {
        std::vector<std::uint32_t> added(change.added);
        std::iota(added.begin(), added.end(), static_cast<std::uint32_t>(scene.shapes.size() - change.added));
        const Result<ShapeEdit> spliced = splice_shapes(world, scene, change.removed, added, options);
        if (!spliced) return spliced;
    }
    if (!shapes.empty()) return edit_shapes(world, scene, shapes, options);
    return {};
}

}  // namespace

void SceneState::warn_once(const std::vector<Diagnostic>& diagnostics) {
    std::vector<Diagnostic> fresh;
    for (const Diagnostic& d : diagnostics) {
        std::string text = to_string(d);
        if (std::find(warned_.begin(), warned_.end(), text) != warned_.end()) continue;
        warned_.push_back(std::move(text));
        fresh.push_back(d);
    }
    warn(fresh);
}

Snapshot SceneState::prepare(const SettingList& overrides, const py::object& progress, int threads,
                             bool is_quiet) {
    sync();
    std::shared_ptr<const Scene> scene = scene_;
    std::vector<std::uint32_t> shapes;
    for (const ShapesEdit& edit : edited_shapes_)
        if (edit.edit > world_edits_)
            for (std::uint32_t index = edit.first; index < edit.end; ++index) shapes.push_back(index);
    std::sort(shapes.begin(), shapes.end());
    shapes.erase(std::unique(shapes.begin(), shapes.end()), shapes.end());

    const Versions now = now_, old = world_versions_;
    const std::uint64_t edits = edits_;
    const auto is_same = [](const Versions& a, const Versions& b) {
        return a.shapes == b.shapes && a.textures == b.textures && a.materials == b.materials &&
               a.lights == b.lights && a.camera == b.camera && a.background == b.background &&
               a.fog == b.fog && a.gradient == b.gradient && a.occlusion == b.occlusion && a.rules == b.rules;
    };
    World world = world_;
    if (!has_world_ || !is_same(now, old) || !shapes.empty()) {
        const std::optional<ShapeHistory::Change> change = history_.since(old.shapes, world_shapes_);
        const bool has_world = has_world_ && change && old.textures == now.textures;
        history_.seal();
        // Without a second owner shapes are edited in place.
        has_world_ = false;
        world_ = {};
        std::vector<Diagnostic> warnings;
        const Status status = run(progress, [&](Running& running) -> Status {
            const PrepareOptions options{threads, running.report(), &running.cancel};
            if (has_world) {
                const Status updated = update(world, old, now, *scene, *change, shapes, options, warnings);
                if (updated || updated.code == ErrorCode::cancelled) return updated;
            }
            // Also after a failed update: the messages then say where in the text the item is, and rules
            // that concern the geometry need this.
            Result<World> prepared = glint::prepare(*scene, options);
            if (!prepared) return prepared;
            warnings = prepared.diagnostics;
            world = *std::move(prepared);
            return {};
        });
        if (!status) raise(status);
        if (is_quiet && !warnings.empty())
            return {std::move(scene), std::move(world)};  // the next call has them
        world_ = world;
        world_versions_ = now;
        world_shapes_ = scene->shapes.size();
        world_edits_ = edits;
        has_world_ = true;
        std::erase_if(edited_shapes_, [&](const ShapesEdit& edit) { return edit.edit <= edits; });
        history_.forget(now.shapes, scene_->shapes.size());
        warn_once(warnings);
    }
    if (overrides.empty()) return {std::move(scene), std::move(world)};

    // The settings of this picture alone.
    Scene settings;
    settings.conventions = scene->conventions;
    settings.settings = scene->settings;
    apply(overrides, settings);
    Result<World> changed = with_rules(world, settings.conventions, settings.settings);
    if (changed) return {std::move(scene), *std::move(changed)};
    // Some rules concern the geometry.
    auto whole = std::make_shared<Scene>(*scene);
    whole->conventions = settings.conventions;
    whole->settings = settings.settings;
    changed = run(progress, [&](Running& running) {
        return glint::prepare(*whole, {threads, running.report(), &running.cancel});
    });
    return {std::move(whole), value_or_raise(std::move(changed))};
}

Snapshot SceneState::prepare_changed(const SettingList& overrides, const py::object& progress) {
    Snapshot snapshot = prepare(overrides, progress);
    if (!overrides.empty()) {
        auto changed = std::make_shared<Scene>(*snapshot.scene);
        apply(overrides, *changed);
        snapshot.scene = std::move(changed);
    }
    return snapshot;
}

}  // namespace glint::python
