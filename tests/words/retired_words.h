// SPDX-License-Identifier: Apache-2.0
#pragma once
// Terms that glint no longer uses because the field has standard terms: not in code, comments or documents.
#include <string_view>
#include <vector>

namespace glint::test {

struct RetiredWord {
    std::string_view
        pattern;  ///< a regular expression of POSIX with \b and \w, upper and lower case told apart
    std::string_view instead;  ///< what to write
    /// Prefixes of the paths that are searched, separated by blanks; empty: all paths.
    std::string_view within = {};
};

inline const std::vector<RetiredWord>& retired_words() {
    static const std::vector<RetiredWord> list = {
        // Modules and files.
        {R"(\brooms?\b)", "module", "src/CMakeLists.txt src/base/ src/scene/ docs/architecture.md"},
        {R"(\bthe house\b)", "the library"},
        {R"(\b(native_)?doors?\b|GLINT_DOOR)", "API",
         "src/ include/ docs/architecture.md docs/playground.md"},
        {R"(\bsrc/inspect\b|"inspect/)", "src/explain, src/check, src/compare or src/grade"},
        {R"(\b[Hh]andover\b)", "tsan_ordering, happens-before"},
        {R"(\bguard\(|\bbase/guard\.h\b)", "result_of"},
        {R"(\bclaim_pages\b)", "prefault_pages"},
        // Rays and the hierarchy.
        {R"(\b[Bb]eams?\b|\w*_beams?\b)", "ray packet",
         "src/ include/ docs/performance.md docs/architecture.md"},
        {R"(\bVisits\b)", "TraversalStack", "src/bvh/"},
        {R"(\b(Sights?|hit_seen|Turn|TurnAll|TurnOrder|turn_order)\b)",
         "ShearedRay, hit_sheared, AxisPermutation; VisibleHits; reverse_tie_order", "src/ include/"},
        {R"(\bCandidate\b)", "Hit, CauseCandidate", "src/ include/ docs/"},
        {R"(\bleave(_through|_t_min)?\()", "offset_ray_origin", "src/ include/ docs/"},
        {R"(\bleave-inl\b|\bleaving-inl\b|\bLeavingRays?\b)", "ray_offset, secondary_rays"},
        {R"(\b(queue_branches|branches_of|branch-inl|Branch(State)?)\b)",
         "queue_secondary_rays, secondary_weights, ExplainedSecondaryRay", "src/ include/ docs/"},
        {R"(\b[Tt]riple\b|\w+_triple\b|\bTripleNumbers\b)", "Vector3, load_vector3",
         "src/simd/ src/geometry/ src/lighting/ src/trace/ src/world/"},
        // Tiles and the film.
        {R"(\bvoid_tile\b|\bfill_with_void\b|\bseen_in_the_void\b|\bsees_nothing\b)",
         "tile_culling, fill_background, miss_color, is_tile_empty"},
        {R"(\b[Pp]yramid(_of)?\b)", "TileFrustum", "src/trace/"},
        {R"(\bOwnBoxes\b|\bown_box(es)?\b)", "PrimitiveBounds, primitive_bounds"},
        {R"(\bPixelSums\b|\bpixel_sums\b|\bfold_pixels\b|\bfilm_part\b)", "Film, resolve, film_value"},
        {R"(\b(take_shadows|reach_hits|put_shadow_rays)\b)",
         "apply_shadows, make_shadow_rays, store_shadow_rays"},
        {R"(\b(k_share|shade_share|SeenSurfaces|see_surfaces|start_alike)\b)",
         "k_batch_size, shade_batch, FirstHits, store_first_hits, start_uniform"},
        {R"(\b(count_asked|count_unblocked)\b)", "count_tested, count_unoccluded"},
        // Limits and shapes.
        {R"(\bk_(most|least)(_\w+)?\b)", "k_max_..., k_min_..."},
        {R"(\bCuboid\w*)", "Box"},
        {R"(\bshape_word\b)", "to_string"},
        {R"(\bk_takes_maps\b)", "k_bakes_transform"},
        {R"(\b[Hh]abits?\b)", "SpellingHint", "src/formats/"},
        // Prose.
        {R"(\b([Nn]obody|[Ss]omebody|now and then|[Hh]olds? against|beside which)\b)",
         "no thread, another World, at intervals, overrides",
         "src/base/ src/bvh/ src/formats/ src/geometry/ src/image/ src/lighting/ src/math/ src/scene/ "
         "src/simd/ "
         "src/trace/ src/world/ include/ docs/library.md docs/architecture.md README.md"},
        {R"(// .*\b(draws?|drawn)\b)", "renders", "src/trace/ src/world/ src/scene/ src/formats/"},
        // Scenes, lights, pictures.
        {R"(\w+_lamps?\b|\blamps?_\w+)", "light"},
        {R"(\b(draw_picture|draw_wanted|draw_at|draw_scaled|DrawnScene|draw_reference|draw_side)\b)",
         "render_..."},
        {R"(\bSubject\b)", "CheckContext, ViewContent", "src/ web/src/"},
        {R"(\btell\()", "print_error", "src/"},
        // The page.
        {R"(\bmachinery\b|\w*\b[a-z]*Beside\b|\bbesideNow\b|\bDrift\b)",
         "services, DocumentState, PlaceTracker", "web/src/"},
    };
    return list;
}

}  // namespace glint::test
