// SPDX-License-Identifier: Apache-2.0
#pragma once
// The causes that are tried by drawing the scene with each.
#include <functional>
#include <optional>

#include "compare/cause_ranking.h"
#include "compare/scene_causes.h"
#include "glint/world.h"

namespace glint {

struct RenderedScene {
    Image image;
    BytePicture bytes;
};

class SceneSearch {
  public:
    /// Draws the scene at this size. Throws bad_alloc.
    SceneSearch(const Scene& scene, std::int32_t width, std::int32_t height, const CauseOptions& options);

    /// Nothing if it cannot be drawn.
    const std::optional<RenderedScene>& rendered() const { return rendered_; }
    std::size_t size() const { return causes_.size(); }
    /// Tries cause i, below size(), for all searches that are open.
    void try_cause(std::size_t i, std::vector<Search>& searches) const;

  private:
    struct Walk;

    bool is_cancelled() const;
    std::optional<RenderedScene> render(const Scene& shading) const;
    std::optional<RenderedScene> render_scaled(const SceneCause& cause, double factor) const;
    void try_factors(std::vector<Search>& searches, const SceneCause& cause) const;
    void walk(std::vector<Search>& searches, const SceneCause& cause, const BytePicture& one, double step,
              std::vector<Walk>& walks) const;
    void try_multiples(std::vector<Search>& searches, const SceneCause& cause,
                       const RenderedScene& without) const;

    Scene scene_;  // without its shapes: causes leave them as they are
    Result<World> world_;
    const CauseOptions& options_;
    std::optional<RenderedScene> rendered_;
    std::vector<SceneCause> causes_;
};

}  // namespace glint
