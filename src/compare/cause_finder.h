// SPDX-License-Identifier: Apache-2.0
#pragma once
// The search for causes, from pictures to reports.
#include <memory>
#include <vector>

#include "compare/cause_ranking.h"
#include "compare/picture_faults.h"
#include "compare/scene_trials.h"
#include "glint/compare.h"

namespace glint {

/// Each cause makes the picture that it would have made out of the reference. The one with the smallest mean
/// difference from the faulty picture is named.
class CauseFinder {
  public:
    /// All must outlive it; `scene` may be null. Throws bad_alloc.
    /// `bytes` are those of the reference.
    CauseFinder(const PictureView& reference, BytePicture bytes, const Scene* scene,
                const CauseOptions& options);
    /// The same of a reference that has only bytes.
    CauseFinder(BytePicture bytes, const Scene* scene, const CauseOptions& options);

    /// A search for this picture, of the reference's size, and its bytes. `picture` is not needed afterwards.
    Search start(const PictureView& picture, BytePicture bytes) const;
    /// The same of a picture that has only bytes.
    Search start(BytePicture bytes) const;
    /// Fills in the reports.
    void find(std::vector<Search>& searches);

  private:
    bool is_cancelled() const { return options_.cancel.is_set(); }
    void measure(Search& search) const;
    void take_sample(Search& search) const;
    void look_at(Search& search) const;
    void step();
    void render_scene(std::vector<Search>& searches);
    void take_out_rounding(std::vector<Search>& searches, const RenderedScene& scene);
    void take_out_tie(Search& search, const RenderedScene& scene) const;
    PictureSource source(const Search& search, const Rows& rows) const;
    void try_pictures(Search& search);
    void confirm(Search& search);
    void count_differing(Search& search) const;
    bool is_few(std::size_t pixels) const;
    std::optional<CausePair> find_pair(Search& search);
    void name(Search& search);
    void judge_agreement(Search& search) const;
    void name_pair(Search& search, CausePair& pair) const;

    BytePicture bytes_;
    bool is_of_scene_ = false;  // `bytes_` are those of the scene's own picture
    const PictureView reference_;
    const std::vector<std::uint8_t> edges_;
    const Scene* const scene_;
    const CauseOptions& options_;
    std::unique_ptr<SceneTrials> trials_;
    BytePicture made_;  // what a cause makes, one after the other
    std::size_t steps_ = 0, done_ = 0;
};

}  // namespace glint
