// SPDX-License-Identifier: Apache-2.0
// A diagnosis as JSON; docs/diagnose.md has its schema.
#define JSON_HAS_FILESYSTEM 0
#define JSON_HAS_EXPERIMENTAL_FILESYSTEM 0
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/status.h"
#include "glint/diagnose.h"

namespace glint {
namespace {

using DiagnosisJson = nlohmann::ordered_json;

// One number, three, or null; JSON has no NaN.
DiagnosisJson value_json(const DiagnosedValue& value) {
    const auto number = [](double v) { return std::isfinite(v) ? DiagnosisJson(v) : DiagnosisJson(); };
    if (value.count == 0) return {};
    if (value.count == 1) return number(value.numbers[0]);
    DiagnosisJson list = DiagnosisJson::array();
    for (const double v : value.numbers) list.push_back(number(v));
    return list;
}

DiagnosisJson row_json(const DiagnosedRow& row, const Scene& scene) {
    constexpr std::string_view verdicts[] = {"right", "wrong", "unknown"};
    DiagnosisJson json = {{"pixel", {row.x, row.y}}};
    if (row.ray >= 0)
        json["ray"] = {{"number", row.ray}, {"kind", row.ray_kind}, {"generation", row.generation}};
    if (row.light < scene.lights.size()) {
        json["light"] = {{"index", row.light}};
        if (const auto name = scene.light_texts.name(row.light); !name.empty()) json["light"]["name"] = name;
    }
    json["quantity"] = row.quantity;
    json["line"] = row.line;
    json["verdict"] = verdicts[static_cast<std::size_t>(row.verdict)];
    json["yours"] = value_json(row.yours);
    json["expected"] = value_json(row.expected);
    return json;
}

DiagnosisJson finding_json(const DiagnosisFinding& finding, const Scene& scene) {
    const DiagnosedRow& at = finding.example;
    DiagnosisJson json = {{"quantity", finding.quantity},
                          {"word", finding.word},
                          {"of", at.light < scene.lights.size() ? "light"
                                 : at.ray >= 0                  ? "ray"
                                                                : "pixel"},
                          {"sure", finding.is_sure}};
    json["causes"] = DiagnosisJson::array();
    for (const DiagnosedCause& cause : finding.causes)
        json["causes"].push_back({{"id", cause.id}, {"explanation", cause.explanation}});
    json["only"] = finding.only;
    json["relation"] = finding.relation;
    json["formula"] = finding.formula;
    json["where"] = finding.where;
    json["pixels"] = finding.pixels;
    json["first_pixels"] = finding.first_pixels;
    json["places"] = finding.places;
    json["judged_places"] = finding.judged_places;
    json["example"] = row_json(finding.example, scene);
    return json;
}

}  // namespace

Result<std::string> diagnosis_json(const Diagnosis& diagnosis, const Scene& scene) {
    return result_of([&]() -> Result<std::string> {
        DiagnosisJson json = {{"conventions", diagnosis.conventions},
                              {"pixels", diagnosis.pixels},
                              {"rays", diagnosis.rays},
                              {"values", diagnosis.values},
                              {"judged", diagnosis.judged},
                              {"unknown", diagnosis.unknown},
                              {"outside", diagnosis.outside},
                              {"wrong_pixels", diagnosis.wrong_pixels},
                              {"rows_from_bottom", diagnosis.rows_from_bottom}};
        json["findings"] = DiagnosisJson::array();
        for (const DiagnosisFinding& finding : diagnosis.findings)
            json["findings"].push_back(finding_json(finding, scene));
        json["rows"] = DiagnosisJson::array();
        for (const DiagnosedRow& row : diagnosis.rows) json["rows"].push_back(row_json(row, scene));
        return json.dump(2, ' ', false, DiagnosisJson::error_handler_t::replace);
    });
}

}  // namespace glint
