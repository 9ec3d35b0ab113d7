// SPDX-License-Identifier: Apache-2.0
#include "grade/part_renderer.h"

#include <algorithm>

#include "base/status.h"
#include "compare/picture_causes.h"
#include "compare/render_scene.h"

namespace glint {
namespace {

// Of the pixels that should show a part, this fraction has to show it with the faults.
constexpr double k_min_shown = 0.01;

CauseOptions cause_options(int threads) {
    CauseOptions options;
    options.threads = threads;
    return options;
}

std::vector<std::uint8_t> away_from_edges(const BytePicture& picture, int threads) {
    std::vector<std::uint8_t> marks = edges_of(picture, threads);
    for (std::uint8_t& mark : marks) mark = mark == 0;
    return marks;
}

// Of the marked pixels, those that differ.
std::vector<std::uint8_t> that_differ(std::vector<std::uint8_t> marks, const BytePicture& a,
                                      const BytePicture& b) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (is_right(&a.rgb[3 * i], &b.rgb[3 * i])) marks[i] = 0;
    }
    return marks;
}

std::size_t marked(const std::vector<std::uint8_t>& marks) {
    return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
}

// As a file with 8 bits per channel.
Image rounded(const BytePicture& bytes) {
    Image image{bytes.width, bytes.height, std::vector<float>(bytes.rgb.size())};
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = static_cast<float>(bytes.rgb[i]) / 255;
    return image;
}

RubricSettings joined(RubricSettings a, const RubricSettings& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

FaultChain without_those_of_pictures(FaultChain chain) {
    std::erase_if(chain.faults, [](const NamedFault& f) { return f.of_pictures.has_value(); });
    return chain;
}

bool is_one_color(const BytePicture& picture) {
    for (std::size_t i = 3; i < picture.rgb.size(); ++i) {
        if (picture.rgb[i] != picture.rgb[i % 3]) return false;
    }
    return true;
}

}  // namespace

std::string FaultChain::key() const {
    std::string key;
    for (const NamedFault& fault : faults) key += fault.cause.name + '\n' + fault.cause.explanation + '\n';
    for (const bool kept : lights) key += kept ? '1' : '0';
    return key;
}

bool FaultChain::needs_picture() const {
    return std::any_of(faults.begin(), faults.end(),
                       [](const NamedFault& f) { return f.of_pictures.has_value(); });
}

PartRenderer::PartRenderer(const Scene& scene, int threads)
    : scene_(scene),
      options_(cause_options(threads)),
      renderer_(scene, scene.settings.width, scene.settings.height, options_) {}

// The World is shared by all parts, except where a setting changes its geometry, or where it has one material
// more than the scene, for shapes without one.
Result<Rendering> PartRenderer::render_plain(const Scene& changed) const {
    const bool has_materials = renderer_.scene().shading.materials.size() == scene_.materials.size();
    if (renderer_.is_prepared() && has_materials && changed.conventions.cones == scene_.conventions.cones)
        return render_scene(renderer_.world(), changed, TracerFault::none, options_.threads);
    return render_scene(changed, options_.threads);
}

WantedPicture PartRenderer::render(const RubricRow& row) const {
    WantedPicture wanted;
    Status status = status_of([&] {
        wanted.scene = with_settings(scene_, row.settings);
        Result<Rendering> rendered = render_plain(wanted.scene);
        wanted.error = rendered.message;
        if (!rendered) return;
        wanted.bytes = to_bytes(rendered->image, options_.threads, wanted.scene.conventions.byte_rule());
        wanted.image = rounded(wanted.bytes);
        wanted.counts = away_from_edges(wanted.bytes, options_.threads);
        if (row.without.empty()) return;
        rendered = render_plain(with_settings(wanted.scene, row.without));
        wanted.error = rendered.message;
        if (!rendered) return;
        wanted.shows = that_differ(
            wanted.counts, to_bytes(rendered->image, options_.threads, wanted.scene.conventions.byte_rule()),
            wanted.bytes);
        if (marked(wanted.shows) == 0)
            wanted.error = "this part shows nothing in this scene: with and without it is the same picture";
    });
    if (!status) wanted.error = std::move(status.message);
    return wanted;
}

bool PartRenderer::keeps_lights(const FaultChain& chain) const {
    FaultyScene scene = renderer_.scene();
    for (const NamedFault& fault : chain.faults) {
        if (fault.edit) fault.edit(scene);
        if (scene.shading.lights.size() != scene_.lights.size()) return false;
    }
    return true;
}

std::optional<PartRenderer::FaultyPicture> PartRenderer::render_faulty(const RubricSettings& settings,
                                                                       const FaultChain& chain,
                                                                       const Image& picture) const {
    FaultyPicture made;
    made.scene = renderer_.scene();
    Scene& shading = made.scene.shading;
    set_all_but_lights(shading, settings);
    // The faults count lights as in the scene in which they were found. Lights that this part does not have
    // are black, not left out, so that the numbers stay the same.
    const std::vector<bool> kept = kept_lights(scene_, settings);
    std::vector<Light> lights;
    for (const bool first : {true, false}) {
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            if (chain.lights[i] != first) continue;
            lights.push_back(scene_.lights[i]);
            if (!kept[i]) lights.back().color = lights.back().specular_color = {0, 0, 0};
        }
    }
    shading.lights = std::move(lights);
    const MakePicture* make = nullptr;
    for (const NamedFault& fault : chain.faults) {
        if (fault.edit) fault.edit(made.scene);
        if (fault.make && make != nullptr) return std::nullopt;  // two faults that are sums of pictures
        if (fault.make) make = &fault.make;
    }
    const PixelGrid all{shading.settings.width, shading.settings.height, 1};
    const auto render = [&](const FaultyScene& scene) -> std::optional<Image> {
        std::optional<RenderedScene> rendered = renderer_.render(scene, all);
        if (!rendered) return std::nullopt;
        return std::move(rendered->image);
    };
    std::optional<Image> image = make != nullptr ? (*make)(made.scene, render) : render(made.scene);
    if (!image) return std::nullopt;
    made.image = std::move(*image);
    made.bytes = to_bytes(made.image, options_.threads, shading.conventions.byte_rule());
    for (const NamedFault& fault : chain.faults) {
        if (!fault.of_pictures) continue;
        const PictureCause& cause = picture_causes()[*fault.of_pictures];
        if (cause.freedom > 0) return std::nullopt;
        const BytePicture bytes = made.bytes, faulty = to_bytes(picture, options_.threads);
        const std::vector<std::uint8_t> edges = edges_of(bytes, options_.threads);
        const Area area{&edges, all_rows(bytes.height), 1, options_.threads};
        if (!cause.make({made.image, bytes, faulty, area, area.rows, true}, made.bytes)) return std::nullopt;
        made.image = rounded(made.bytes);
    }
    return made;
}

std::optional<WantedPicture> PartRenderer::render(const RubricRow& row, const FaultChain& chain,
                                                  const Image& picture) const {
    if (!renderer_.is_prepared() || chain.lights.size() != scene_.lights.size()) return std::nullopt;
    std::optional<WantedPicture> wanted;
    const Status status = status_of([&] {
        std::optional<FaultyPicture> with = render_faulty(row.settings, chain, picture);
        if (!with) return;
        WantedPicture found;
        found.bytes = std::move(with->bytes);
        found.image = rounded(found.bytes);
        found.counts = away_from_edges(found.bytes, options_.threads);
        if (!row.without.empty()) {
            const RubricSettings settings = joined(row.settings, row.without);
            if (const auto without = render_faulty(settings, chain, picture)) {
                found.shows = that_differ(found.counts, without->bytes, found.bytes);
            } else {
                // What is fitted to the picture, such as a gamma, does not fit one without the part.
                const FaultChain unfitted = without_those_of_pictures(chain);
                const auto a = render_faulty(row.settings, unfitted, picture),
                           b = render_faulty(settings, unfitted, picture);
                if (!a || !b) return;
                found.shows = that_differ(found.counts, b->bytes, a->bytes);
            }
        }
        const bool is_of_scene = std::all_of(chain.faults.begin(), chain.faults.end(),
                                             [](const NamedFault& f) { return f.edit && !f.of_pictures; });
        found.has_scene = is_of_scene && renderer_.with_shapes() && with->scene.has_all_in_shading();
        if (found.has_scene) {
            found.scene = *renderer_.with_shapes();
            const Scene& from = with->scene.shading;
            found.scene.lights = from.lights;
            found.scene.materials = from.materials;
            found.scene.background = from.background;
            found.scene.camera = from.camera;
            found.scene.conventions = from.conventions;
            found.scene.settings = from.settings;
        }
        wanted = std::move(found);
    });
    return status ? std::move(wanted) : std::nullopt;
}

bool still_shows(const WantedPicture& faulty, const WantedPicture& wanted) {
    if (wanted.shows.empty()) return !is_one_color(faulty.bytes);
    const std::size_t shown = marked(faulty.shows);
    return shown > 0 && static_cast<double>(shown) >= k_min_shown * static_cast<double>(marked(wanted.shows));
}

}  // namespace glint
