// Which of the classic causes explains a difference best: each makes the picture that it would have made, and
// the least mean difference from the faulty picture wins.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/fp_environment.h"
#include "base/guard.h"
#include "glint/compare.h"
#include "glint/render.h"
#include "inspect/picture_causes.h"
#include "inspect/scene_causes.h"

namespace glint {
namespace {

// The scene's own picture stands for a picture from which it differs by less than this part of the difference
// to be explained.
constexpr double k_same_part = 0.1;
// Of causes that explain nearly the same (by this part of the difference) the simplest, which is the earliest
// in the table, is named first.
constexpr double k_tie = 0.003;

struct Candidate {
    Cause cause;
    double least = k_least_explained;
};

// One picture to explain, and what has been found about it.
struct Search {
    BytePicture faulty;
    CauseReport report;
    std::vector<Candidate> found;

    bool is_open() const { return report.error.empty() && report.difference > 0; }
};

struct Drawn {
    Image image;
    BytePicture bytes;
};

class CauseFinder {
  public:
    CauseFinder(const Image& reference, const Scene* scene, const CauseOptions& options)
        : reference_(reference), bytes_(to_bytes(reference, options.threads)), options_(options) {
        if (scene == nullptr) return;
        scene_ = std::make_unique<Scene>(*scene);
        scene_->settings.width = reference.width;
        scene_->settings.height = reference.height;
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
        search.report.difference = mean_difference(search.faulty, bytes_);
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
        const PrepareResult prepared = prepare(scene, options_.threads);
        if (!prepared.world) return std::nullopt;
        RenderOptions options;
        options.threads = options_.threads;
        options.cancel = options_.cancel;
        RenderResult result = render(*prepared.world, options);
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
            report.scene_from_a = mean_difference(drawn_->bytes, search.faulty);
            report.scene_from_b = mean_difference(drawn_->bytes, bytes_);
            const double near = k_same_part * report.difference;
            report.swapped = *report.scene_from_a<near&& * report.scene_from_b> near;
        }
    }

    // The picture that the causes are to make out of the reference.
    const BytePicture& target(const Search& search) const {
        return search.report.swapped ? bytes_ : search.faulty;
    }

    // What remains with this cause is `made`'s difference from the target.
    void judge(Search& search, const BytePicture& made, Candidate candidate) const {
        CauseReport& report = search.report;
        ++report.tried;
        candidate.cause.remaining = mean_difference(made, target(search));
        candidate.cause.explained = 1 - candidate.cause.remaining / report.difference;
        if (candidate.cause.explained >= candidate.least) search.found.push_back(std::move(candidate));
    }

    void try_pictures(Search& search) const {
        const CauseReport& report = search.report;
        // The scene's floats know what bytes have lost, if it draws this very picture.
        const bool by_scene =
            drawn_ && (report.swapped || *report.scene_from_b < k_same_part * report.difference);
        const PictureSource source{by_scene ? drawn_->image : reference_, by_scene ? drawn_->bytes : bytes_,
                                   target(search), by_scene, options_.threads};
        for (const PictureCause& cause : picture_causes()) {
            const std::optional<FaultyPicture> made = cause.make(source);
            if (!made || made->picture.rgb == source.bytes.rgb) continue;
            judge(search, made->picture,
                  {{cause.name, fmt::format(fmt::runtime(cause.explanation), made->detail), 0, 0, false},
                   cause.least});
        }
    }

    void try_scenes(std::vector<Search>& searches) {
        const std::vector<SceneCause> causes = scene_causes(*scene_);
        for (std::size_t i = 0; i < causes.size() && !is_cancelled(); ++i) {
            Scene scene = *scene_;
            causes[i].put(scene);
            const std::optional<Drawn> made = draw(scene);
            if (options_.progress)
                options_.progress(static_cast<double>(i + 1) / static_cast<double>(causes.size()));
            // What changes nothing in this scene explains nothing.
            if (!made || made->bytes.rgb == drawn_->bytes.rgb) continue;
            for (Search& search : searches) {
                if (search.is_open())
                    judge(search, made->bytes, {{causes[i].name, causes[i].explanation, 0, 0, true}});
            }
        }
        for (Search& search : searches) {
            if (search.is_open() && !is_cancelled()) try_intensity(search);
        }
    }

    // All lights by one factor, which is fitted: the background stays as it is, unlike in a scaled picture.
    void try_intensity(Search& search) const {
        const auto factor = fit_scale(drawn_->image, drawn_->bytes, target(search));
        if (!factor) return;
        Scene scene = *scene_;
        scale_lights(scene, *factor);
        if (const std::optional<Drawn> made = draw(scene)) {
            judge(
                search, made->bytes,
                {{"light-intensity",
                  fmt::format("All lights are {:.3g} times as bright: an intensity, or a factor of the sum.",
                              *factor),
                  0, 0, true},
                 0.7});
        }
    }

    // The best first, one of each name.
    void rank(Search& search) const {
        std::vector<Candidate>& found = search.found;
        const double tie = k_tie * search.report.difference;
        std::vector<Cause>& causes = search.report.causes;
        while (!found.empty()) {
            const auto least = std::min_element(found.begin(), found.end(), [](const auto& x, const auto& y) {
                return x.cause.remaining < y.cause.remaining;
            });
            const double limit = least->cause.remaining + (least->cause.remaining > 0 ? tie : 0);
            const auto best = std::find_if(found.begin(), found.end(),
                                           [&](const auto& c) { return c.cause.remaining <= limit; });
            Cause cause = std::move(best->cause);
            std::erase_if(found,
                          [&](const Candidate& c) { return c.cause.name == cause.name || &c == &*best; });
            causes.push_back(std::move(cause));
        }
    }

    const Image& reference_;
    const BytePicture bytes_;
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
