// SPDX-License-Identifier: Apache-2.0
#pragma once
// A log beside the scene: glint's explanations of its pixels, what its numbers and conventions mean, and
// which rays belong together.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "diagnose/mistakes.h"
#include "diagnose/trace_log.h"
#include "glint/explain.h"
#include "glint/world.h"

namespace glint {

/// What the numbers of a log mean; infer_rules() finds out.
struct LogRules {
    bool rows_from_bottom = false;
    bool has_unit_t = false;     ///< t is a distance in the world, whatever the length of D
    bool turns_normals = false;  ///< N is logged before it is turned towards the ray; what follows shows it
    double light_sign = 1, view_sign = 1, reflected_sign = 1;  ///< -1: L, V, R point the other way
    std::array<double, k_quantities> white;                    ///< 1, or 255 for colors to 255
    bool weight_is_product = false;                 ///< weights are of the pixel, not of the parent
    std::vector<std::uint32_t> shape_of, light_of;  ///< by label; k_none: unknown
    LogRules() { white.fill(1); }
};

/// A mistake, and which way of making it.
struct Trial {
    TracerMistake mistake = TracerMistake::none;
    int variant = 0;
    double number = 0;  ///< of exponent_other: the exponent
};

/// glint's own explanation of a logged pixel.
struct PixelReference {
    std::optional<Explanation> explanation;  ///< nothing: the pixel is not in the picture
    std::vector<std::int32_t> ray;           ///< by ray of the log: the same one in the explanation, or -1
};

/// Worlds of single shapes, for mistakes in the choice of the nearest hit.
class ShapeWorlds {
  public:
    static constexpr std::size_t k_max_shapes = 256;
    explicit ShapeWorlds(const Scene& scene);
    bool exists() const { return !worlds_.empty(); }
    std::size_t size() const { return worlds_.size(); }
    /// All t of the ray's hits with a shape, in order; t_min and t in lengths of the direction.
    std::vector<double> hits(std::size_t shape, Vec3 origin, Vec3 direction, double t_min) const;

  private:
    std::vector<World> worlds_;
};

class LogModel {
  public:
    LogModel(const Scene& scene, const World& world, const TraceLog& log, int threads);

    const Scene& scene;
    const World& world;
    const TraceLog& log;
    LogRules rules;
    std::vector<PixelReference> references;
    bool is_simple = true;  ///< no fog, occlusion, or shading without lights: sums are computed

    /// The nearest hit of a ray; t in lengths of the direction.
    RayHit nearest(Vec3 origin, Vec3 direction, double t_min, double t_max = __builtin_huge_val()) const;
    bool is_occluded(Vec3 origin, Vec3 direction, double t_min, double t_max) const;
    const ShapeWorlds& shape_worlds() const;
    /// The row of a pixel, counted from the top.
    std::int32_t row(const LoggedPixel& pixel) const {
        return rules.rows_from_bottom ? scene.settings.height - 1 - pixel.y : pixel.y;
    }
    /// Explains the pixels anew, after rows_from_bottom has changed, and finds the rays that belong together.
    void explain_pixels(int threads);

  private:
    mutable std::unique_ptr<ShapeWorlds> shape_worlds_;
};

/// Finds out what the numbers of the model's log mean. Writes to model.rules.
void infer_rules(LogModel& model, int threads);

}  // namespace glint
