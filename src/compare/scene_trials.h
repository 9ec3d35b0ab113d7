// SPDX-License-Identifier: Apache-2.0
#pragma once
// The search for causes by a scene: on a grid of pixels first, and on all of them what is best there.
#include <memory>
#include <optional>
#include <vector>

#include "compare/geometry_causes.h"
#include "compare/scene_search.h"

namespace glint {

class SceneTrials {
  public:
    /// At the reference's size. Throws bad_alloc.
    SceneTrials(const Scene& scene, const BytePicture& reference, const std::vector<std::uint8_t>& edges,
                const CauseOptions& options);

    /// The scene's own picture, at the reference's size; nothing if it cannot be drawn.
    const std::optional<RenderedScene>& rendered() const { return rendered_; }
    std::size_t steps() const { return search_ ? search_->size() : 0; }
    bool is_cancelled() const { return renderer_.is_cancelled(); }

    /// Adds to all searches that are open what a scene with a fault explains. `step` is called steps() times.
    void run(std::vector<Search>& searches, const std::function<void()>& step);
    /// The best pair of causes, each other cause besides one of the best that were found, if it explains what
    /// no single one does: fills in `first` and `second`. True if there is one.
    bool find_pair(Search& search, CauseCandidate& first, CauseCandidate& second);
    /// Which shapes show the difference.
    std::string where_text(const Search& search);

  private:
    // A search on the grid's pixels.
    struct GridSearch {
        Search search;
        Search* whole = nullptr;
    };
    struct Pair {
        CauseCandidate first, second;
        double rating = 0;
    };

    GridSearch grid_search(Search& whole, const PixelGrid& grid) const;
    void run_on(const PixelGrid& grid, std::vector<GridSearch>& searches, const std::function<void()>& step);
    void fit_geometry(const PixelGrid& grid, const RenderedScene& drawn, GridSearch& search);
    void confirm(GridSearch& search) const;
    std::optional<Image> draw_image(const CauseCandidate& candidate, const FaultyScene& base) const;
    std::optional<BytePicture> draw_whole(const CauseCandidate& candidate, const FaultyScene& base) const;
    void pairs_of_scene(const CauseCandidate& first, GridSearch& search, std::vector<Pair>& pairs) const;
    void pairs_of_pictures(const CauseCandidate& first, GridSearch& search, std::vector<Pair>& pairs);
    std::optional<BytePicture> draw_pair(const Pair& pair, const Search& search) const;

    const BytePicture& reference_;
    const std::vector<std::uint8_t>& edges_;
    const SceneRenderer renderer_;
    const PixelGrid grid_;
    std::optional<RenderedScene> rendered_;
    std::vector<std::uint8_t> grid_edges_;
    std::unique_ptr<SceneSearch> search_;
    std::vector<std::optional<RenderedScene>> drawn_causes_;  // of search_, once a pair has been looked for
};

}  // namespace glint
