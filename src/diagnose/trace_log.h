// SPDX-License-Identifier: Apache-2.0
#pragma once
// The log of another ray tracer (docs/formats/trace_log.md), as it was read.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "diagnose/approx.h"
#include "glint/diagnose.h"

namespace glint {

/// A quantity of a log. They are in the order in which a ray tracer computes them, which is the order in
/// which they are compared.
enum class Quantity : std::uint8_t {
    origin,
    direction,
    hit,  ///< `shape`, or `miss`
    t,
    point,
    normal,
    view,
    inside,
    to_light,
    distance,
    attenuation,
    spot,
    n_l,
    reflected,
    half,
    r_v,
    n_h,
    power,
    blocked,
    diffuse,
    specular,
    diffuse_sum,
    specular_sum,
    ambient,
    emission,
    local,
    children,  ///< whether a mirror or glass ray starts at a hit: of the rays, not of a key
    weight,
    color,
    pixel_color,
    clamped,
    bytes,
};
inline constexpr int k_quantities = static_cast<int>(Quantity::bytes) + 1;

/// What the values of a quantity are.
enum class QuantityKind : std::uint8_t { number, flag, vector, direction, color, label, none };
/// Of what they are.
enum class QuantityOf : std::uint8_t { ray, light, pixel };

/// A row of the table of quantities, which the reader, the answers and the schema share.
struct QuantityInfo {
    Quantity quantity;
    std::string_view key;  ///< in logs and JSON
    QuantityKind kind;
    QuantityOf of;
    std::string_view word;     ///< in sentences: "N", "the diffuse term"
    std::string_view formula;  ///< how it follows from earlier ones
    std::string_view where;    ///< where the documents explain it
};
const QuantityInfo& info_of(Quantity quantity);

/// The values that a log gives for a quantity: one, or three.
struct LoggedValue {
    Quantity quantity = Quantity::origin;
    std::uint32_t line = 0;
    ApproxVec value;  ///< of a number, x
};

struct LoggedValues {
    std::vector<LoggedValue> list;

    const LoggedValue* find(Quantity quantity) const {
        for (const LoggedValue& value : list)
            if (value.quantity == quantity) return &value;
        return nullptr;
    }
    std::optional<ApproxVec> vector(Quantity quantity) const {
        const LoggedValue* value = find(quantity);
        return value != nullptr ? std::optional(value->value) : std::nullopt;
    }
    std::optional<Approx> number(Quantity quantity) const {
        const LoggedValue* value = find(quantity);
        return value != nullptr ? std::optional(value->value.x) : std::nullopt;
    }
};

struct LoggedLight : LoggedValues {
    std::uint32_t line = 0;
    std::uint32_t label = 0;  ///< in TraceLog::light_labels
};

enum class LoggedRayKind : std::uint8_t { camera, mirror, glass };

struct LoggedRay : LoggedValues {
    std::uint32_t line = 0;
    LoggedRayKind kind = LoggedRayKind::camera;
    std::int32_t number = -1;  ///< the log's own, or -1
    std::int32_t parent = -1;  ///< in LoggedPixel::rays, before this one; -1: a camera ray
    std::int32_t generation = 0;
    bool is_miss = false;
    std::optional<std::uint32_t> shape;  ///< in TraceLog::shape_labels
    std::vector<LoggedLight> lights;
};

struct LoggedPixel : LoggedValues {
    std::uint32_t line = 0;
    std::int32_t x = 0, y = 0, sample = -1;
    std::vector<LoggedRay> rays;
};

/// A number or a name that a log gives to shapes or lights.
struct LogLabel {
    std::string text;
    std::optional<std::int64_t> number;
};

struct TraceLog {
    std::optional<std::array<std::int32_t, 2>> size;
    std::optional<bool> rows_from_bottom;
    std::optional<double> white;  ///< 1 or 255
    bool is_printrays = false;    ///< CSC 473's own layout
    std::vector<LogLabel> shape_labels, light_labels;
    std::vector<LoggedPixel> pixels;
    std::size_t values = 0;
};

/// Reads a log. Errors and warnings have the place in the text; the log is what could be read.
TraceLog read_trace_log(InputText text, Diagnostics& diagnostics);

}  // namespace glint
