// Which of the classic causes explains a difference best: each makes the picture that it would have made, and
// the least mean difference from the faulty picture wins.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "base/fp_environment.h"
#include "base/guard.h"
#include "glint/compare.h"
#include "inspect/cause_ranking.h"
#include "inspect/draw_picture.h"
#include "inspect/factor_search.h"
#include "inspect/picture_causes.h"
#include "inspect/scene_causes.h"

namespace glint {
namespace {

// The scene's own picture stands for a picture from which it differs by less than this part of the difference
// to be explained.
constexpr double k_same_part = 0.1;
// What is fitted to the picture has to explain more.
constexpr double k_least_fitted = 0.85, k_least_factor = 0.5;
// A factor is looked for from 1 to these, and no further where no more than this part of the difference
// stays.
constexpr double k_most_factor = 16, k_enough = 0.001;

std::string capital(std::string text) {
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

struct Drawn {
    Image image;
    BytePicture bytes;
};

// Shapes without a material get one of the scene's, so that faults of materials reach them.
void name_default_material(Scene& scene) {
    const auto index = static_cast<std::uint32_t>(scene.materials.size());
    bool used = false;
    for (Shape& shape : scene.shapes) {
        if (shape.material != k_none) continue;
        shape.material = index;
        used = true;
    }
    if (used) scene.materials.emplace_back();
}

class CauseFinder {
  public:
    CauseFinder(const Image& reference, const Scene* scene, const CauseOptions& options)
        : reference_(reference),
          bytes_(to_bytes(reference, options.threads)),
          edges_(edges_of(bytes_, options.threads)),
          options_(options) {
        if (scene == nullptr) return;
        scene_ = std::make_unique<Scene>(*scene);
        scene_->settings.width = reference.width;
        scene_->settings.height = reference.height;
        name_default_material(*scene_);
    }

    Search start(const Image& picture) const {
        Search search;
        if (picture.width != reference_.width || picture.height != reference_.height ||
            picture.rgb.size() != reference_.rgb.size()) {
            search.report.error =
                fmt::format("the pictures have different sizes: {}x{} and {}x{}", picture.width,
                            picture.height, reference_.width, reference_.height);
            return search;
        }
        search.faulty = to_bytes(picture, options_.threads);
        search.whole = distance(search.faulty, bytes_, edges_);
        search.report.difference = search.whole.all;
        return search;
    }

    void find(std::vector<Search>& searches) {
        if (std::none_of(searches.begin(), searches.end(), [](const Search& s) { return s.is_open(); }))
            return;
        if (scene_ != nullptr) draw_scene(searches);
        for (Search& search : searches) {
            if (search.is_open()) try_pictures(search);
        }
        if (drawn_) try_scenes(searches);
        for (Search& search : searches) rank(search);
    }

  private:
    bool is_cancelled() const {
        return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed);
    }

    std::optional<Drawn> draw(const Scene& scene) const {
        RenderResult result = draw_picture(scene, options_.threads, options_.cancel);
        if (!result.image) return std::nullopt;
        Drawn drawn{std::move(*result.image), {}};
        drawn.bytes = to_bytes(drawn.image, options_.threads);
        return drawn;
    }

    void draw_scene(std::vector<Search>& searches) {
        drawn_ = draw(*scene_);
        for (Search& search : searches) {
            if (!search.is_open()) continue;
            if (!drawn_) {
                search.report.error = "the scene cannot be drawn at the pictures' size";
                continue;
            }
            CauseReport& report = search.report;
            report.scene_from_a = distance(drawn_->bytes, search.faulty, edges_).all;
            report.scene_from_b = distance(drawn_->bytes, bytes_, edges_).all;
            const double near = k_same_part * report.difference;
            report.swapped = *report.scene_from_a<near&& * report.scene_from_b> near;
        }
    }

    // The picture that the causes are to make out of the reference.
    const BytePicture& target(const Search& search) const {
        return search.report.swapped ? bytes_ : search.faulty;
    }

    // `made` is what the cause makes of the reference.
    void judge(Search& search, const BytePicture& made, Candidate candidate) const {
        ++search.report.tried;
        candidate.left = distance(made, target(search), edges_);
        search.found.push_back(std::move(candidate));
    }

    void try_pictures(Search& search) const {
        const CauseReport& report = search.report;
        // The scene's floats know what bytes have lost, if it draws this very picture.
        const bool by_scene =
            drawn_ && (report.swapped || *report.scene_from_b < k_same_part * report.difference);
        const PictureSource source{by_scene ? drawn_->image : reference_,
                                   by_scene ? drawn_->bytes : bytes_,
                                   target(search),
                                   edges_,
                                   by_scene,
                                   options_.threads};
        for (const PictureCause& cause : picture_causes()) {
            const std::optional<FaultyPicture> made = cause.make(source);
            if (!made || made->picture.rgb == source.bytes.rgb) continue;
            judge(search, made->picture,
                  {{cause.name, fmt::format(fmt::runtime(cause.explanation), made->detail), 0, 0, false},
                   cause.least,
                   cause.freedom});
        }
    }

    void try_scenes(std::vector<Search>& searches) {
        const std::vector<SceneCause> causes = scene_causes(*scene_);
        for (std::size_t i = 0; i < causes.size() && !is_cancelled(); ++i) {
            std::optional<Drawn> made;
            if (causes[i].scale) {
                try_factors(searches, causes[i]);
            } else {
                Scene scene = *scene_;
                causes[i].put(scene);
                made = draw(scene);
            }
            if (options_.progress)
                options_.progress(static_cast<double>(i + 1) / static_cast<double>(causes.size()));
            // What changes nothing in this scene explains nothing.
            if (!made || made->bytes.rgb == drawn_->bytes.rgb) continue;
            for (Search& search : searches) {
                if (search.is_open())
                    judge(search, made->bytes, {{causes[i].name, causes[i].explanation, 0, 0, true}});
            }
            if (!causes[i].part.empty()) try_multiples(searches, causes[i], *made);
        }
    }

    // How the search for one picture's factor goes.
    struct Walk {
        Distance at_one;   // what stays with the factor 1
        TriedFactor best;  // so far
        bool leads = false, goes_on = false;
    };

    std::optional<Drawn> draw_scaled(const SceneCause& cause, double factor) const {
        Scene scene = *scene_;
        if (cause.put) cause.put(scene);
        cause.scale(scene, factor);
        return draw(scene);
    }

    // A number of the scene by a factor that is fitted: from 1 by powers of two as long as it gets better,
    // then to the bottom of the valley.
    void try_factors(std::vector<Search>& searches, const SceneCause& cause) const {
        const std::optional<Drawn> one = draw_scaled(cause, 1);
        if (!one) return;
        std::vector<Walk> walks(searches.size());
        for (std::size_t i = 0; i < searches.size(); ++i) {
            if (!searches[i].is_open()) continue;
            walks[i].at_one = distance(one->bytes, target(searches[i]), edges_);
            walks[i].best = {1, walks[i].at_one.all};
        }
        for (const double step : {2.0, 0.5}) walk(searches, cause, one->bytes, step, walks);
        for (std::size_t i = 0; i < searches.size() && !is_cancelled(); ++i) {
            Search& search = searches[i];
            const double enough = k_enough * search.whole.all;
            const bool is_explained =
                std::any_of(search.found.begin(), search.found.end(),
                            [&](const Candidate& c) { return c.freedom == 0 && c.left.all <= enough; });
            if (!walks[i].leads || is_explained) continue;
            TriedFactor best = walks[i].best;
            if (best.left > enough) {
                best = refine_factor(best, best.factor / 2, best.factor * 2, enough,
                                     [&](double factor) -> std::optional<double> {
                                         const auto made = draw_scaled(cause, factor);
                                         if (!made) return std::nullopt;
                                         return distance(made->bytes, target(search), edges_).all;
                                     });
            }
            const std::optional<Drawn> made = draw_scaled(cause, best.factor);
            if (!made || made->bytes.rgb == one->bytes.rgb) continue;
            judge(search, made->bytes,
                  {{cause.name, cause.scale_text(best.factor, best.left > enough), 0, 0, true},
                   k_least_factor});
        }
    }

    // A picture lies on the way from `one` to a factor as far as going there is no detour.
    void walk(std::vector<Search>& searches, const SceneCause& cause, const BytePicture& one, double step,
              std::vector<Walk>& walks) const {
        for (std::size_t i = 0; i < searches.size(); ++i) walks[i].goes_on = searches[i].is_open();
        const auto goes_on = [](const Walk& w) { return w.goes_on; };
        for (double factor = step; factor <= k_most_factor && factor * k_most_factor >= 1; factor *= step) {
            if (std::none_of(walks.begin(), walks.end(), goes_on) || is_cancelled()) return;
            const std::optional<Drawn> made = draw_scaled(cause, factor);
            if (!made || made->bytes.rgb == one.rgb) return;
            const Distance moved = distance(made->bytes, one, edges_);
            for (std::size_t i = 0; i < searches.size(); ++i) {
                Walk& w = walks[i];
                if (!w.goes_on) continue;
                const Distance left = distance(made->bytes, target(searches[i]), edges_);
                const auto is_on_the_way = [](double from_one, double way, double rest) {
                    return (from_one + way - rest) / 2 > k_least_explained * from_one;
                };
                w.leads = w.leads || is_on_the_way(w.at_one.all, moved.all, left.all) ||
                          is_on_the_way(w.at_one.calm, moved.calm, left.calm);
                w.goes_on = left.all < w.best.left;
                if (w.goes_on) w.best = {factor, left.all};
            }
        }
    }

    // The part of the light that is missing in `without`, by a factor that is fitted. Light is a sum, so the
    // picture with any multiple of a part is known from those with and without it.
    void try_multiples(std::vector<Search>& searches, const SceneCause& cause, const Drawn& without) const {
        std::vector<float> part = drawn_->image.rgb;
        for (std::size_t i = 0; i < part.size(); ++i) part[i] -= without.image.rgb[i];
        for (Search& search : searches) {
            if (!search.is_open()) continue;
            const auto factor = fit_factor(without.image.rgb, part, drawn_->bytes, target(search));
            if (!factor) continue;
            Image image = without.image;
            for (std::size_t i = 0; i < part.size(); ++i)
                image.rgb[i] += static_cast<float>(*factor) * part[i];
            judge(search, to_bytes(image, options_.threads),
                  {{cause.scaled,
                    fmt::format("{} is {:.3g} times what it should be.", capital(cause.part), *factor), 0, 0,
                    true},
                   k_least_fitted});
        }
    }

    const Image& reference_;
    const BytePicture bytes_;
    const std::vector<std::uint8_t> edges_;
    const CauseOptions& options_;
    std::unique_ptr<Scene> scene_;
    std::optional<Drawn> drawn_;
};

}  // namespace

std::vector<CauseReport> find_causes(std::span<const Image> pictures, const Image& b, const Scene* scene,
                                     const CauseOptions& options) {
    std::vector<CauseReport> reports;
    const std::string error = guard([&] {
        const DefaultFpEnvironment environment;
        if (b.width < 1 || b.height < 1 || b.rgb.size() != std::size_t{3} * b.width * b.height)
            throw std::invalid_argument("the reference has no pixels, or their numbers do not fit its size");
        CauseFinder finder(b, scene, options);
        std::vector<Search> searches;
        for (const Image& picture : pictures) searches.push_back(finder.start(picture));
        finder.find(searches);
        for (Search& search : searches) reports.push_back(std::move(search.report));
    });
    if (!error.empty()) {
        reports.assign(pictures.size(), {});
        for (CauseReport& report : reports) report.error = error;
    }
    return reports;
}

CauseReport find_causes(const Image& a, const Image& b, const Scene* scene, const CauseOptions& options) {
    return std::move(find_causes({&a, 1}, b, scene, options).front());
}

}  // namespace glint
