// SPDX-License-Identifier: Apache-2.0
#pragma once
// The search for causes by a scene: on a grid of pixels first; the best are then judged by all pixels.
#include <memory>
#include <optional>
#include <vector>

#include "compare/pair_search.h"
#include "compare/scene_search.h"

namespace glint {

enum class PairKind : std::uint8_t { any, with_shift };

/// Bytes that each pixel takes if causes are tried on all pixels of a picture.
inline constexpr std::size_t k_trial_bytes = 100;

class SceneTrials {
  public:
    /// At the reference's size. Throws bad_alloc.
    SceneTrials(const Scene& scene, const BytePicture& reference, const std::vector<std::uint8_t>& edges,
                const CauseOptions& options);

    /// The scene's own picture, at the reference's size; nothing if it cannot be rendered.
    const std::optional<RenderedScene>& rendered() const { return rendered_; }
    /// SceneRenderer::background of all pixels.
    const std::vector<bool>& background() const {
        return renderer_.background({reference_.width, reference_.height, 1});
    }
    /// By which rendered numbers become bytes.
    ByteRule rule() const { return renderer_.rule(renderer_.scene().shading); }
    std::size_t steps() const { return search_ ? search_->size() : 0; }
    bool is_cancelled() const { return renderer_.is_cancelled(); }

    /// Tries the faults of a scene for all searches that are open. `step` is called steps() times.
    void run(std::vector<Search>& searches, const std::function<void()>& step);
    /// The best pair of causes, if it explains what no single one does.
    std::optional<CausePair> find_pair(Search& search, PairKind kind);
    /// PairSearch::with_first, of a pair that find_pair() has found.
    std::optional<CausePair> with_first(const Search& search, const CauseCandidate& first,
                                        const CausePair& pair) const {
        return pairs_->with_first(search, first, pair);
    }
    /// Which shapes show the difference.
    std::string where_text(const Search& search);

  private:
    struct GridSearch {
        Search search;
        Search* whole = nullptr;
    };

    Status memory_for_all() const;
    GridSearch grid_search(Search& whole, const PixelGrid& grid) const;
    void run_on(const PixelGrid& grid, std::vector<GridSearch>& searches, const std::function<void()>& step);
    void try_geometry(const PixelGrid& grid, const RenderedScene& rendered, GridSearch& search) const;
    void try_forms(const PixelGrid& grid, GridSearch& search) const;
    void confirm(GridSearch& search) const;
    bool is_limit(const BytePicture& made, std::size_t row) const;
    std::optional<CauseCandidate> judge_limit(const Search& whole, const RenderedScene& made,
                                              CauseCandidate& candidate) const;

    const BytePicture& reference_;
    const std::vector<std::uint8_t>& edges_;
    const SceneRenderer renderer_;
    const PixelGrid grid_;
    const std::uint64_t max_memory_;
    std::optional<RenderedScene> rendered_;
    std::vector<std::uint8_t> grid_edges_;
    std::unique_ptr<SceneSearch> search_;
    std::unique_ptr<PairSearch> pairs_;  // once a pair has been searched
};

}  // namespace glint
