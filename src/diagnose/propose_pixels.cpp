// SPDX-License-Identifier: Apache-2.0
// The pixels that are worth logging: one of each kind of difference between two pictures, and some without.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "base/sort_stably.h"
#include "base/status.h"
#include "glint/diagnose.h"
#include "glint/render.h"

namespace glint {
namespace {

constexpr std::size_t k_most_pixels = 12;
// Pixels of one kind are at least this part of the picture's width apart.
constexpr double k_apart = 0.06;

// What is seen at the pixels of a rendering.
class SeenPixels {
  public:
    SeenPixels(const Rendering& rendering, const std::vector<Layer>& layers)
        : rendering_(rendering), layers_(layers) {}

    double most(Layer layer, std::size_t pixel) const {
        const LayerImage& image = of(layer);
        double largest = 0;
        for (int c = 0; c < image.channels; ++c)
            largest = std::max<double>(
                largest,
                image.values[pixel * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c)]);
        return largest;
    }
    // Whether a layer with one channel differs between a pixel and one of its neighbours.
    bool is_border(Layer layer, std::int32_t x, std::int32_t y, double least) const {
        const std::int32_t width = rendering_.image.width, height = rendering_.image.height;
        const auto at = [&](std::int32_t i, std::int32_t j) {
            return most(layer, static_cast<std::size_t>(std::clamp(j, 0, height - 1)) *
                                       static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(std::clamp(i, 0, width - 1)));
        };
        const double here = at(x, y);
        return std::fabs(at(x - 1, y) - here) > least || std::fabs(at(x + 1, y) - here) > least ||
               std::fabs(at(x, y - 1) - here) > least || std::fabs(at(x, y + 1) - here) > least;
    }

  private:
    const LayerImage& of(Layer layer) const {
        return rendering_.layers[static_cast<std::size_t>(std::find(layers_.begin(), layers_.end(), layer) -
                                                          layers_.begin())];
    }
    const Rendering& rendering_;
    const std::vector<Layer>& layers_;
};

}  // namespace

Result<std::vector<ProposedPixel>> propose_pixels(const Scene& scene, const World& world,
                                                  const Image& picture, int threads) {
    return result_of([&]() -> Result<std::vector<ProposedPixel>> {
        const std::vector<Layer> layers = {Layer::object,   Layer::material,   Layer::shadow,
                                           Layer::specular, Layer::reflection, Layer::transmission};
        RenderOptions options;
        options.threads = threads;
        options.layers = layers;
        Result<Rendering> rendered = render(world, options);
        if (!rendered) return static_cast<Status>(rendered);
        const Image& own = rendered->image;
        if (picture.width != own.width || picture.height != own.height ||
            picture.rgb.size() != own.rgb.size())
            return invalid_argument("the picture has " + std::to_string(picture.width) + "x" +
                                    std::to_string(picture.height) + " pixels, the scene's " +
                                    std::to_string(own.width) + "x" + std::to_string(own.height));
        const SeenPixels seen(*rendered, layers);
        struct Candidate {
            double difference;
            std::int32_t x, y;
        };
        // By kind, those that differ most.
        std::map<std::string, std::vector<Candidate>> candidates;
        const auto keep_largest = [](std::vector<Candidate>& list, std::size_t most) {
            sort_stably(list,
                        [](const Candidate& a, const Candidate& b) { return a.difference > b.difference; });
            if (list.size() > most) list.resize(most);
        };
        constexpr std::size_t k_kept = 2000;
        const ByteRule rule = scene.conventions.byte_rule();
        for (std::int32_t y = 0; y < own.height; ++y) {
            for (std::int32_t x = 0; x < own.width; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(own.width) +
                                      static_cast<std::size_t>(x);
                double difference = 0;
                for (std::size_t c = 0; c < 3; ++c)
                    difference = std::max(
                        difference, std::fabs(to_byte(own.rgb[3 * i + c], rule) -
                                              255.0 * std::clamp<double>(picture.rgb[3 * i + c], 0, 1)));
                if (std::isnan(difference)) difference = 255;
                std::string kind;
                const double object = seen.most(Layer::object, i);
                if (difference < 1.5) {
                    if (object == 0 || seen.is_border(Layer::object, x, y, 0.5)) continue;
                    kind = "equal";
                } else if (seen.is_border(Layer::object, x, y, 0.5)) {
                    kind = "edge";
                } else if (object == 0) {
                    kind = "background";
                } else if (seen.is_border(Layer::shadow, x, y, 0.01)) {
                    kind = "shadow border";
                } else if (seen.most(Layer::specular, i) > 0.05) {
                    kind = "highlight";
                } else if (seen.most(Layer::transmission, i) > 0.02) {
                    kind = "glass";
                } else if (seen.most(Layer::reflection, i) > 0.02) {
                    kind = "mirror";
                } else if (seen.most(Layer::shadow, i) > 0.5) {
                    kind = "shadow";
                } else {
                    kind = "material " + std::to_string(static_cast<int>(seen.most(Layer::material, i)));
                }
                std::vector<Candidate>& list = candidates[kind];
                list.push_back({difference, x, y});
                if (list.size() == 2 * k_kept) keep_largest(list, k_kept);
            }
        }
        // In rounds: of each kind the pixel that differs most, then of each another one at some distance.
        std::vector<std::string> kinds;
        for (auto& [kind, list] : candidates) {
            keep_largest(list, k_kept);
            kinds.push_back(kind);
        }
        sort_stably(kinds, [&](const std::string& a, const std::string& b) {
            return candidates[a].front().difference > candidates[b].front().difference;
        });
        std::vector<ProposedPixel> chosen;
        const auto is_near = [&](const Candidate& c) {
            return std::any_of(chosen.begin(), chosen.end(), [&](const ProposedPixel& p) {
                return std::max(std::abs(p.x - c.x), std::abs(p.y - c.y)) < k_apart * own.width;
            });
        };
        for (std::size_t round = 0; round < k_most_pixels; ++round) {
            for (const std::string& kind : kinds) {
                // Two pixels that are equal show where a mistake does not happen.
                if (chosen.size() == k_most_pixels || (kind == "equal" && round > 1)) continue;
                for (const Candidate& c : candidates[kind]) {
                    if (is_near(c)) continue;
                    chosen.push_back({c.x, c.y, kind, c.difference});
                    break;
                }
            }
        }
        if (std::all_of(chosen.begin(), chosen.end(),
                        [](const ProposedPixel& p) { return p.kind == "equal"; }))
            chosen.clear();
        return chosen;
    });
}

}  // namespace glint
