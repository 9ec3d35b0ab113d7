// SPDX-License-Identifier: Apache-2.0
#pragma once
// The log of another ray tracer beside a scene: which quantity is the first that differs, and which mistake
// gives its number. docs/diagnose.md; the log's format is docs/formats/trace_log.md.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "glint/export.h"
#include "glint/image.h"
#include "glint/result.h"
#include "glint/world.h"

namespace glint {

struct DiagnoseOptions {
    std::string name = "log";  ///< of the log, in messages
    int threads = 0;           ///< 0: one per processor; the answer does not depend on it
    CancelFlag cancel = {};    ///< checked at intervals
    /// The most rows of Diagnosis::rows: those of the first pixels, whole pixels only.
    std::size_t max_rows = 20000;
};

/// Numbers of a quantity as the log has them: in its own units and signs.
struct DiagnosedValue {
    int count = 0;  ///< 0: none; 1: a number, a flag, a shape's number from 1 (0: a miss); 3
    std::array<double, 3> numbers{};  ///< may be NaN or infinite
};

/// A row of the two trees: a quantity of a light or ray or pixel.
struct DiagnosedRow {
    std::uint32_t pixel = 0;       ///< in the order of the log
    std::int32_t x = 0, y = 0;     ///< as the log counts them
    std::int32_t ray = -1;         ///< in the order of the pixel; -1: of the pixel
    std::int32_t generation = 0;   ///< of the ray: 0: the camera's
    std::string_view ray_kind;     ///< "camera", "mirror", "glass"; empty for the pixel
    std::uint32_t light = k_none;  ///< in Scene::lights, or k_none
    std::string_view quantity;     ///< its key
    std::uint32_t line = 0;        ///< of the log, from 1; 0: it has no line
    enum class Verdict : std::uint8_t { right, wrong, unknown } verdict = Verdict::unknown;
    /// What it should be follows from the log's own earlier values.
    DiagnosedValue yours, expected;
};

/// A mistake that gives the log's numbers.
struct DiagnosedCause {
    std::string_view id;           ///< one of diagnosed_causes()
    std::string_view explanation;  ///< one or two sentences
};

/// A quantity that differs, at some places for one reason.
struct DiagnosisFinding {
    std::string_view quantity;  ///< its key in the log
    std::string_view word;      ///< in sentences: "N"
    std::string_view formula;   ///< how it follows from earlier quantities
    std::string_view where;     ///< where the documents explain it; may be empty
    /// True: there is one cause, it gives the log's numbers at three pixels or more (of more than 3,000: at a
    /// thousandth), and every other known mistake fails. False: each of `causes` gives them; there may be
    /// none.
    bool is_sure = false;
    std::vector<DiagnosedCause> causes;
    std::string only;      ///< where alone it happens: "where the ray comes from inside"; empty: everywhere
    std::string relation;  ///< "yours is -1 times what it should be"; empty: none is known
    std::size_t pixels = 0, first_pixels = 0;   ///< that have it; where it is the first difference
    std::size_t places = 0, judged_places = 0;  ///< that have it; where the quantity was judged
    DiagnosedRow example;
};

struct Diagnosis {
    std::vector<std::string> conventions;          ///< what the log's numbers mean, a sentence each
    std::size_t pixels = 0, rays = 0, values = 0;  ///< in the log
    /// Values that were judged, and those that could not be. Pixels of the log that are not in the picture.
    std::size_t judged = 0, unknown = 0, outside = 0;
    std::size_t wrong_pixels = 0;   ///< with any difference
    bool rows_from_bottom = false;  ///< the log's row 0 is the picture's lowest
    std::vector<DiagnosisFinding>
        findings;  ///< that which is the first difference in most pixels comes first
    std::vector<DiagnosedRow> rows;
};

/// Compares a log with a scene. The world must have been prepared from this scene. An error for a log that
/// violates its format (with the place), or has no pixel of the picture. Never throws.
GLINT_API Result<Diagnosis> diagnose(const Scene& scene, const World& world, std::string_view log,
                                     const DiagnoseOptions& options = {});

/// A pixel that is worth logging.
struct ProposedPixel {
    std::int32_t x = 0, y = 0;  ///< counted from the top left
    /// "edge", "background", "shadow border", "highlight", "glass", "mirror", "shadow", "material 2";
    /// "equal": a pixel without a difference.
    std::string kind;
    double difference = 0;  ///< of the channel that differs most, in 255ths
};

/// Up to twelve pixels of another program's picture of the scene: of each kind of difference those that
/// differ most, at some distance from each other, and two that are equal. Empty: the pictures are equal but
/// for rounding. An error if the picture has another size than the world's. Never throws.
GLINT_API Result<std::vector<ProposedPixel>> propose_pixels(const Scene& scene, const World& world,
                                                            const Image& picture, int threads = 0);

/// All causes that are tried.
GLINT_API std::vector<DiagnosedCause> diagnosed_causes();

/// The diagnosis as JSON (docs/diagnose.md has its schema).
GLINT_API Result<std::string> diagnosis_json(const Diagnosis& diagnosis, const Scene& scene);

}  // namespace glint
