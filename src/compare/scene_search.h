// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tries causes by rendering the scene with each.
#include <functional>
#include <optional>
#include <vector>

#include "compare/cause_ranking.h"
#include "compare/scene_causes.h"

namespace glint {

/// The picture of a candidate that is not of pictures alone; nothing if it cannot be rendered.
std::optional<RenderedScene> render_candidate(const SceneRenderer& renderer, const CauseCandidate& candidate,
                                              const FaultyScene& base, const PixelGrid& grid);

/// Tries the causes of lighting and tracing on a scene that may have a fault already.
class SceneSearch {
  public:
    SceneSearch(const SceneRenderer& renderer, const PixelGrid& grid, const FaultyScene& scene);

    /// The scene on the grid; nothing if it cannot be rendered.
    const std::optional<RenderedScene>& rendered() const { return rendered_; }
    std::size_t size() const { return causes_.size(); }
    /// Tries cause i, below size(), for all searches that are open. Their pictures are of the grid's pixels.
    void try_cause(std::size_t i, const std::vector<Search*>& searches) const;
    /// The picture of cause i; nothing if it has none without a picture to fit it to.
    std::optional<RenderedScene> render_cause(std::size_t i) const;
    const SceneCause& cause(std::size_t i) const { return causes_[i]; }
    /// The candidate of cause i, whose `left` is still to be filled in.
    CauseCandidate candidate(std::size_t i) const;
    /// The same with a factor, of a cause that has one: SceneCause::scale or scale_part.
    CauseCandidate scaled_candidate(std::size_t i, double factor, bool about) const;
    /// The first cause of this name.
    std::optional<std::size_t> row_of(const std::string& name) const;
    /// The cause that has this one as its limit (SceneCause::limit); nothing if there is none.
    std::optional<std::size_t> cause_with_limit(const std::string& name) const;

  private:
    struct Walk;

    std::optional<RenderedScene> render(const FaultEdit& edit) const;
    std::optional<RenderedScene> render_scaled(const SceneCause& cause, double factor) const;
    void try_factors(const std::vector<Search*>& searches, std::size_t row) const;
    void walk(const std::vector<Search*>& searches, const SceneCause& cause, const BytePicture& one,
              double step, std::vector<Walk>& walks) const;
    void try_multiples(const std::vector<Search*>& searches, std::size_t row,
                       const RenderedScene& without) const;

    const SceneRenderer& renderer_;
    const PixelGrid grid_;
    const FaultyScene scene_;
    std::optional<RenderedScene> rendered_;
    std::vector<SceneCause> causes_;
};

}  // namespace glint
