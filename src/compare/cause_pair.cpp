// SPDX-License-Identifier: Apache-2.0
#include "compare/cause_pair.h"

#include <fmt/format.h>

#include "compare/parameter_fit.h"
#include "compare/picture_causes.h"

namespace glint {

PairCandidate in_order(CauseCandidate a, CauseCandidate b) {
    const auto place = [](const CauseCandidate& c) { return c.of_pictures ? 2 : c.edit ? 0 : 1; };
    if (place(b) < place(a)) std::swap(a, b);
    return {std::move(a), std::move(b)};
}

std::string row_key(const CauseCandidate& c) {
    return fmt::format("{} {} {}", c.cause.name, c.row, c.of_pictures.has_value());
}

CauseCandidate fault_of_pictures(std::size_t i) {
    const PictureCause& cause = picture_causes()[i];
    CauseCandidate candidate{{cause.name, cause.explanation, 0, 0, false}, cause.least};
    candidate.of_pictures = i;
    // What the explanation names is fitted.
    if (candidate.cause.explanation.find("{}") != std::string::npos)
        candidate.parameters = k_detail_parameters;
    return candidate;
}

bool can_be_undone(const CauseCandidate& fault) {
    return fault.of_pictures && picture_causes()[*fault.of_pictures].is_own_inverse;
}

std::optional<BytePicture> flipped(const BytePicture& picture, const CauseCandidate& fault,
                                   const Area& area) {
    BytePicture made = picture;
    const PictureView numbers = view_of(picture);
    const Rows rows = all_rows(picture.height);
    if (!picture_causes()[*fault.of_pictures].make({numbers, picture, picture, area, rows}, made))
        return std::nullopt;
    return made;
}

std::optional<RenderedScene> render_pair(const SceneRenderer& renderer, const PixelGrid& grid,
                                         const Search& search, PairCandidate& pair) {
    FaultyScene base = renderer.scene();
    if (!pair.after.of_pictures) {
        pair.before.edit(base);
        return render_candidate(renderer, pair.after, base, grid);
    }
    std::optional<RenderedScene> made = pair.before.of_pictures
                                            ? renderer.render(base, grid)
                                            : render_candidate(renderer, pair.before, base, grid);
    for (CauseCandidate* fault : {&pair.before, &pair.after}) {
        if (!fault->of_pictures || !made || (fault == &pair.after && can_be_undone(*fault))) continue;
        BytePicture bytes = made->bytes;
        const PictureCause& cause = picture_causes()[*fault->of_pictures];
        const auto detail = cause.make({made->image, made->bytes, *search.target, search.area,
                                        search.area.rows, true, &renderer.background(grid)},
                                       bytes);
        if (!detail) return std::nullopt;
        fault->cause.explanation = fmt::format(fmt::runtime(cause.explanation), *detail);
        for (std::size_t i = 0; i < bytes.rgb.size(); ++i)
            made->image.rgb[i] = static_cast<float>(bytes.rgb[i]) / 255;
        made->bytes = std::move(bytes);
    }
    return made;
}

void fit_pair(const SceneRenderer& renderer, const SceneSearch& causes, const PixelGrid& grid,
              const Search& search, PairCandidate& pair) {
    FitProblem problem;
    for (const CauseCandidate* c : {&pair.before, &pair.after}) {
        problem.start.insert(problem.start.end(), c->values.begin(), c->values.end());
        if (c->fitted)
            problem.units.insert(problem.units.end(), c->fitted->units.begin(), c->fitted->units.end());
    }
    if (problem.start.empty()) return;
    const auto with_values = [&](std::span<const double> values, bool about) {
        PairCandidate changed = pair;
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(pair.before.values.size());
        if (changed.before.fitted) changed.before.set_values({values.begin(), middle}, about);
        if (changed.after.fitted) changed.after.set_values({middle, values.end()}, about);
        return changed;
    };
    problem.render = [&](std::span<const double> values) -> std::optional<std::vector<float>> {
        PairCandidate changed = with_values(values, true);
        std::optional<RenderedScene> made = render_pair(renderer, grid, search, changed);
        if (!made) return std::nullopt;
        return std::move(made->image.rgb);
    };
    const std::optional<Fit> fit = ParameterFit(grid, *search.target).fit(problem, FitStart::near);
    if (!fit) return;
    PairCandidate fitted = with_values(fit->values, fit->left > k_pair_found);
    for (CauseCandidate* c : {&fitted.before, &fitted.after}) {
        const bool is_of_part =
            c->fitted && c->row < causes.size() && c->cause.name == causes.cause(c->row).scaled;
        if (is_of_part && c->values[0] < k_min_multiple) *c = causes.candidate(c->row);  // it is missing
    }
    fitted.rating += fit->left - pair.left;
    fitted.left = fit->left;
    pair = std::move(fitted);
}

}  // namespace glint
