// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the checks work on: the scene, its world, small pictures of it, and the list of findings.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/check.h"
#include "glint/render.h"
#include "world/world.h"

namespace glint {

/// Changes of a pixel value below this change no byte.
inline constexpr double k_half_byte = 0.5 / 255;

/// The number of pixels in which a channel differs by more than `least`; 0 if the pictures have not one size.
std::size_t count_differing(const Image& a, const Image& b, double least);

/// The share of pixels for which test(index of the first channel) is true.
template <class Test> double share_of_pixels(const Image& image, const Test& test) {
    if (image.rgb.empty()) return 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) count += test(i) ? 1 : 0;
    return 3 * static_cast<double>(count) / static_cast<double>(image.rgb.size());
}

inline bool is_black(Color c) { return c.r == 0 && c.g == 0 && c.b == 0; }

/// As findings write it: "(1, 2.5, -3)".
std::string vector_text(Vec3 v);
/// A share from 0 to 1: "0.53%", "100%".
std::string percent_text(double share);

/// The sides of the picture, made small: at most `longest` pixels, in about the same proportion.
struct SmallSize {
    std::int32_t width, height;
};
SmallSize small_size(const RenderSettings& settings, std::int32_t longest);
/// A picture of this size shows the whole view, whatever proportions so few pixels have: the camera stays
/// that of the picture's own size.
void set_size(WorldParts& world, SmallSize size);

/// What a finding is about, and where that is written.
struct FindingPlace {
    SourcePlace place;  ///< line 0: nowhere
    SceneItem item = SceneItem::none;
    std::uint32_t index = 0;
};

class CheckContext {
  public:
    /// prepared: from the scene.
    CheckContext(const Scene& scene, World prepared, const CheckOptions& options);

    const Scene& scene() const { return scene_; }
    const World& prepared() const { return prepared_; }
    const WorldParts& world() const { return prepared_.parts(); }
    int threads() const { return options_.threads; }

    /// The size of a grid of camera rays, at most `longest` a side: fewer where each meets hundreds of shapes
    /// that lie in one another, since it is tested against all of them.
    SmallSize grid(std::int32_t longest) const;
    /// Where the grid is coarser for that reason, a sentence that says so, else nothing; for findings that a
    /// finer one might not make.
    std::string coarse_grid(std::int32_t longest) const;

    /// A picture of the scene, or of a World with other shading (a failed one: an empty picture), one sample
    /// a pixel, at most `longest` pixels a side; fewer where the scene's rays multiply, or its shapes lie in
    /// one another. Of the same size for the same `longest`.
    Image render_small(std::int32_t longest) { return render_small(prepared_, longest); }
    Image render_small(const Result<World>& world, std::int32_t longest);

    /// A note is about what does not harm the picture.
    void report(std::string_view id, FindingPlace about, std::string message, std::string remedy,
                Severity severity = Severity::warning);
    /// Whether the scene is an exported or computed model: it has more shapes than one that is written by
    /// hand, or most of its shapes come from the same places in the text, by macros and declared objects.
    /// Its findings of one kind are one finding.
    bool is_model() const { return is_model_; }
    /// Whether there is a finding with this id, about any item or about this one.
    bool is_reported(std::string_view id) const;
    bool is_reported(std::string_view id, SceneItem item, std::uint32_t index) const;
    FindingPlace at_camera() const { return {scene_.camera_place, SceneItem::camera}; }
    FindingPlace at_background() const { return {scene_.background_place, SceneItem::background}; }
    FindingPlace at_light(std::uint32_t i) const {
        return {scene_.light_texts.place(i), SceneItem::light, i};
    }
    /// Nowhere, for the default material.
    FindingPlace at_material(std::uint32_t i) const {
        if (i >= scene_.materials.size()) return {};
        return {scene_.material_texts.place(i), SceneItem::material, i};
    }
    FindingPlace at_texture(std::uint32_t i) const {
        return {scene_.texture_texts.place(i), SceneItem::texture, i};
    }
    FindingPlace at_shape(std::uint32_t i) const {
        return {scene_.shape_texts.place(i), SceneItem::shape, i};
    }
    /// The end of the name of the file that has the place, as ".pov"; nothing for none.
    std::string_view extension_of(SourcePlace place) const;
    /// Whether the format adds the light, which has no place in the file, although others have one.
    bool is_implied_light(std::uint32_t i) const;
    FindingPlace at_setting(std::string_view key) const;
    /// The findings by their places; where there are many of a kind, the first of them and their number.
    std::vector<Finding> take();

    /// "sphere 'ball'" or "sphere 3", and with its line: "sphere 3 (line 7)", if it has one.
    std::string shape(std::uint32_t index) const;
    std::string shape_and_line(std::uint32_t index) const;
    /// Of the lights that the file has: the format may add another one before them.
    std::string light(std::uint32_t index) const;
    std::string light_and_line(std::uint32_t index) const;
    std::string material(std::uint32_t index) const;
    std::string texture(std::uint32_t index) const;

    /// The first few of a list: "sphere 1 (line 3), sphere 2 (line 4) and 98 more".
    std::string some_shapes(const std::vector<std::uint32_t>& shapes) const;

    /// The material of a shape, with the shape's own color.
    Material material_of(std::uint32_t shape) const;

  private:
    std::string line_of(SourcePlace place) const;
    Result<Rendering> render_at(World world, SmallSize size) const;
    SmallSize affordable(std::int32_t longest);

    const Scene& scene_;
    const World prepared_;
    const CheckOptions& options_;
    double rays_per_pixel_ = 0;  // of the scene as it is; 0: not rendered yet
    const double shapes_per_ray_;
    const bool is_model_;
    std::vector<std::pair<SourcePlace, Finding>> findings_;
};

}  // namespace glint
