// SPDX-License-Identifier: Apache-2.0
#include "glint/diagnose.h"
#include "base/sort_stably.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/fp_environment.h"
#include "base/parallel_for.h"
#include "base/status.h"
#include "diagnose/findings.h"
#include "explain/references.h"

namespace glint {
namespace {

std::string_view word_of(LoggedRayKind kind) {
    return kind == LoggedRayKind::camera ? "camera" : kind == LoggedRayKind::mirror ? "mirror" : "glass";
}

// The sentences on what the log's numbers mean.
std::vector<std::string> convention_sentences(const LogModel& model) {
    std::vector<std::string> list;
    const LogRules& rules = model.rules;
    const auto says = [&](Quantity quantity) {
        for (const LoggedPixel& pixel : model.log.pixels)
            for (const LoggedRay& ray : pixel.rays) {
                if (ray.find(quantity) != nullptr) return true;
                for (const LoggedLight& light : ray.lights)
                    if (light.find(quantity) != nullptr) return true;
            }
        return false;
    };
    if (rules.rows_from_bottom)
        list.emplace_back(model.log.rows_from_bottom
                              ? "Rows count from the bottom, as the log says."
                              : "Rows count from the bottom (with rows from the top the camera rays do not "
                                "agree; if your picture is upside down, this is why).");
    bool has_length = false;
    for (const LoggedPixel& pixel : model.log.pixels)
        for (const LoggedRay& ray : pixel.rays)
            if (const auto d = ray.vector(Quantity::direction); d && std::fabs(length(*d).v - 1) > 1e-3)
                has_length = true;
    if (has_length && says(Quantity::t))
        list.emplace_back(rules.has_unit_t ? "D is not of unit length; t is a distance in the world."
                                           : "D is not of unit length; t is in lengths of D.");
    if (rules.light_sign < 0) list.emplace_back("L points from the light to P.");
    if (rules.view_sign < 0) list.emplace_back("V points from the eye to P.");
    if (rules.turns_normals) list.emplace_back("N is logged before it is turned towards the ray.");
    if (rules.reflected_sign < 0) list.emplace_back("R points to the surface.");
    std::string scaled;
    for (int i = 0; i < k_quantities; ++i)
        if (rules.white[static_cast<std::size_t>(i)] == 255)
            scaled += fmt::format("{}{}", scaled.empty() ? "" : ", ", info_of(static_cast<Quantity>(i)).key);
    if (!scaled.empty()) list.push_back(fmt::format("These colors go to 255: {}.", scaled));
    if (rules.weight_is_product)
        list.emplace_back("The weight of a ray is its factor in the pixel: the product along its path.");
    const auto unmatched = [](const std::vector<LogLabel>& labels, const std::vector<std::uint32_t>& of) {
        std::string names;
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (of[i] == k_none && names.size() < 100)
                names += fmt::format("{}{}", names.empty() ? "" : ", ", labels[i].text);
        return names;
    };
    const auto offset = [](const std::vector<LogLabel>& labels, const std::vector<std::uint32_t>& of) {
        std::set<std::int64_t> offsets;
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (labels[i].number && of[i] != k_none) offsets.insert(*labels[i].number - of[i]);
        return offsets;
    };
    const auto shape_offsets = offset(model.log.shape_labels, rules.shape_of),
               light_offsets = offset(model.log.light_labels, rules.light_of);
    if (shape_offsets == std::set<std::int64_t>{0})
        list.emplace_back("Shapes are numbered from 0, in the scene's order.");
    if (shape_offsets.size() > 1)
        list.emplace_back(
            "Shapes are numbered in another order than the scene's; they are told by where they are hit.");
    if (light_offsets == std::set<std::int64_t>{0})
        list.emplace_back("Lights are numbered from 0, in the scene's order.");
    if (light_offsets.size() > 1 ||
        (light_offsets.size() == 1 && *light_offsets.begin() != 0 && *light_offsets.begin() != 1))
        list.emplace_back(
            "Lights are numbered otherwise than in the scene (ambient lights may be left out); they are told "
            "by their direction.");
    if (const std::string names = unmatched(model.log.shape_labels, rules.shape_of); !names.empty())
        list.push_back(fmt::format(
            "It is not known which shapes these are, so that what they are hit at is not compared: {}.",
            names));
    if (const std::string names = unmatched(model.log.light_labels, rules.light_of); !names.empty())
        list.push_back(fmt::format(
            "It is not known which lights these are, so that their values are not compared: {}.", names));
    return list;
}

// A value as the log would have it.
DiagnosedValue value_in_log(const LogModel& model, const ObservedPlace& place, const ApproxVec& value,
                            bool is_number) {
    DiagnosedValue result;
    const QuantityKind kind = info_of(place.quantity).kind;
    if (kind == QuantityKind::label) {
        result.count = 1;
        result.numbers[0] = value.x.v + 1;
        return result;
    }
    double factor = 1;
    if (place.ray < 0) {
        factor = 1 / model.rules.white[static_cast<std::size_t>(place.quantity)];
    } else if (place.quantity != Quantity::children) {
        const RayModel ray(model, place.pixel, place.ray);
        factor = place.light != k_none ? ray.light_factor(place.quantity) : ray.factor(place.quantity);
    }
    const Vec3 v = value.value();
    result.count = kind == QuantityKind::number || kind == QuantityKind::flag ? 1 : 3;
    result.numbers = {v.x, v.y, v.z};
    if (is_number)
        for (double& number : result.numbers) number /= factor;
    return result;
}

const LoggedValue* logged_value(const LogModel& model, const ObservedPlace& place) {
    const LoggedPixel& pixel = model.log.pixels[place.pixel];
    if (place.ray < 0) return pixel.find(place.quantity);
    const LoggedRay& ray = pixel.rays[static_cast<std::size_t>(place.ray)];
    if (place.light == k_none) return ray.find(place.quantity);
    for (const LoggedLight& light : ray.lights)
        if (model.rules.light_of[light.label] == place.light) return light.find(place.quantity);
    return nullptr;
}

DiagnosedRow row_of(const LogModel& model, const Observation& seen) {
    DiagnosedRow row;
    const LoggedPixel& pixel = model.log.pixels[seen.place.pixel];
    row.pixel = seen.place.pixel;
    row.x = pixel.x, row.y = pixel.y;
    row.ray = seen.place.ray;
    row.light = seen.place.light;
    row.quantity = info_of(seen.place.quantity).key;
    const LoggedValue* logged = logged_value(model, seen.place);
    if (seen.place.ray >= 0) {
        const LoggedRay& ray = pixel.rays[static_cast<std::size_t>(seen.place.ray)];
        row.generation = ray.generation;
        row.ray_kind = word_of(ray.kind);
        row.line = ray.line;
    }
    if (logged != nullptr) row.line = logged->line;
    row.verdict = seen.verdict == Verdict::wrong     ? DiagnosedRow::Verdict::wrong
                  : seen.verdict == Verdict::unknown ? DiagnosedRow::Verdict::unknown
                                                     : DiagnosedRow::Verdict::right;
    row.yours = value_in_log(
        model, seen.place, seen.is_number || logged == nullptr ? seen.yours : logged->value, seen.is_number);
    if (seen.verdict != Verdict::unknown) row.expected = value_in_log(model, seen.place, seen.expected, true);
    return row;
}

// "yours is 0.5 times what it should be", if that is so everywhere.
std::string relation_of(const std::vector<Observation>& all, const std::vector<std::size_t>& places) {
    std::optional<double> ratio;
    std::size_t count = 0;
    for (const std::size_t i : places) {
        const QuantityKind kind = info_of(all[i].place.quantity).kind;
        if (!all[i].is_number || kind == QuantityKind::label || kind == QuantityKind::flag) return {};
        const Vec3 a = all[i].yours.value(), b = all[i].expected.value();
        for (const auto& [yours, expected] : {std::pair{a.x, b.x}, {a.y, b.y}, {a.z, b.z}}) {
            if (std::fabs(expected) < 1e-3) {
                if (std::fabs(yours) > 1e-3) return {};
                continue;
            }
            const double r = yours / expected;
            if (ratio && std::fabs(r - *ratio) > 2e-3 * std::max(1.0, std::fabs(*ratio))) return {};
            ratio = r;
            ++count;
        }
    }
    if (!ratio || count < 3 || std::fabs(*ratio - 1) < 5e-3) return {};
    return fmt::format("yours is {:.4g} times what it should be", *ratio);
}

class Diagnosing {
  public:
    Diagnosing(LogModel& model, const DiagnoseOptions& options) : model_(model), options_(options) {}

    Diagnosis run() {
        infer_rules(model_, options_.threads);
        result_.conventions = convention_sentences(model_);
        result_.rows_from_bottom = model_.rules.rows_from_bottom;
        result_.pixels = model_.log.pixels.size();
        result_.values = model_.log.values;
        for (std::size_t p = 0; p < model_.log.pixels.size(); ++p) {
            result_.rays += model_.log.pixels[p].rays.size();
            if (!model_.references[p].explanation) ++result_.outside;
        }
        observe_all();
        find_all();
        return std::move(result_);
    }

  private:
    void observe_all() {
        std::vector<ObservedPlace> places;
        for_each_place(model_, [&](const ObservedPlace& place) {
            places.push_back(place);
            return true;
        });
        seen_.resize(places.size());
        constexpr std::size_t k_chunk = 512;
        parallel_for((places.size() + k_chunk - 1) / k_chunk, options_.threads, [&](std::size_t c) {
            // The values of a ray follow each other, so that one model of it serves all.
            std::optional<RayModel> ray;
            for (std::size_t i = c * k_chunk; i < std::min(places.size(), (c + 1) * k_chunk); ++i) {
                if (options_.cancel.is_set()) return;
                const ObservedPlace& place = places[i];
                const bool is_same_ray =
                    i > c * k_chunk && place.pixel == places[i - 1].pixel && place.ray == places[i - 1].ray;
                if (place.ray >= 0 && !is_same_ray) ray.emplace(model_, place.pixel, place.ray);
                seen_[i] = observe(model_, place, place.ray >= 0 ? &*ray : nullptr);
            }
        });
        std::set<std::uint32_t> wrong;
        std::size_t whole = 0;
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            const Observation& one = seen_[i];
            if (one.verdict == Verdict::unknown) {
                ++result_.unknown;
            } else {
                ++result_.judged;
            }
            if (one.verdict == Verdict::wrong) wrong.insert(one.place.pixel);
            if (i > 0 && one.place.pixel != seen_[i - 1].place.pixel) whole = result_.rows.size();
            if (result_.rows.size() < options_.max_rows) result_.rows.push_back(row_of(model_, one));
        }
        if (seen_.size() > options_.max_rows) result_.rows.resize(whole);
        result_.wrong_pixels = wrong.size();
    }

    void find_all() {
        std::set<Quantity> quantities;
        std::map<std::uint32_t, std::size_t> first;  // by pixel: the first wrong observation
        std::map<Quantity, std::size_t> judged;
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            if (seen_[i].verdict != Verdict::unknown) ++judged[seen_[i].place.quantity];
            if (seen_[i].verdict != Verdict::wrong) continue;
            quantities.insert(seen_[i].place.quantity);
            first.emplace(seen_[i].place.pixel, i);
        }
        for (const Quantity quantity : quantities) {
            if (options_.cancel.is_set()) return;
            for (const FoundReason& reason : find_reasons(model_, seen_, quantity)) {
                DiagnosisFinding finding;
                const QuantityInfo& info = info_of(quantity);
                finding.quantity = info.key;
                finding.word = info.word;
                finding.formula = info.formula;
                finding.where = info.where;
                finding.is_sure = reason.is_sure;
                for (const TracerMistake cause : reason.causes)
                    finding.causes.push_back({info_of(cause).id, info_of(cause).explanation});
                finding.only = reason.only;
                finding.relation =
                    reason.is_number ? relation_of(seen_, reason.places) : "yours is not a number";
                for (const Trial& trial : reason.trials)
                    if (trial.mistake == TracerMistake::exponent_other)
                        finding.relation = fmt::format("the exponent is {:.4g}", trial.number);
                std::set<std::uint32_t> pixels;
                std::size_t example = reason.places.front();
                for (const std::size_t i : reason.places) {
                    pixels.insert(seen_[i].place.pixel);
                    if (first[seen_[i].place.pixel] == i) {
                        if (finding.first_pixels == 0) example = i;
                        ++finding.first_pixels;
                    }
                }
                finding.pixels = pixels.size();
                finding.places = reason.places.size();
                finding.judged_places = judged[quantity];
                finding.example = row_of(model_, seen_[example]);
                result_.findings.push_back(std::move(finding));
            }
        }
        sort_stably(result_.findings, [](const DiagnosisFinding& a, const DiagnosisFinding& b) {
            return a.first_pixels > b.first_pixels;
        });
    }

    LogModel& model_;
    const DiagnoseOptions& options_;
    Diagnosis result_;
    std::vector<Observation> seen_;
};

}  // namespace

Result<Diagnosis> diagnose(const Scene& scene, const World& world, std::string_view text,
                           const DiagnoseOptions& options) {
    return result_of([&]() -> Result<Diagnosis> {
        const DefaultFpEnvironment environment;
        if (std::string fault = world_fault(scene, world.parts()); !fault.empty())
            return invalid_argument(std::move(fault));
        if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
            return failure(ErrorCode::parse,
                           fmt::format("{}: the log is UTF-16: save it as UTF-8", options.name));
        Diagnostics diagnostics;
        const TraceLog log = read_trace_log({options.name, text}, diagnostics);
        if (diagnostics.any_errors()) return failure(ErrorCode::parse, diagnostics.take());
        if (log.pixels.empty())
            return failure(ErrorCode::parse,
                           fmt::format("{}: the log has no line `pixel X Y`", options.name));
        const RenderSettings& settings = scene.settings;
        if (log.size && (*log.size)[0] * static_cast<std::int64_t>(settings.height) !=
                            (*log.size)[1] * static_cast<std::int64_t>(settings.width))
            return failure(
                ErrorCode::invalid_argument,
                fmt::format(
                    "{}: the log is of a picture of {}x{} pixels, the scene's has {}x{}: give its size",
                    options.name, (*log.size)[0], (*log.size)[1], settings.width, settings.height));
        const auto judge = [&](const Scene& of_log, const World& world_of_log) {
            LogModel model(of_log, world_of_log, log, options.threads);
            return Diagnosing(model, options).run();
        };
        Diagnosis diagnosis;
        if (!log.size || (*log.size)[0] == settings.width) {
            diagnosis = judge(scene, world);
        } else {
            Scene resized = scene;
            resized.settings.width = (*log.size)[0], resized.settings.height = (*log.size)[1];
            const Result<World> prepared = with_rules(world, resized.conventions, resized.settings);
            if (!prepared) return static_cast<Status>(prepared);
            diagnosis = judge(resized, *prepared);
        }
        if (options.cancel.is_set()) return cancelled();
        if (diagnosis.outside == diagnosis.pixels)
            return failure(ErrorCode::invalid_argument,
                           fmt::format("{}: no pixel of the log is in the picture of {}x{}", options.name,
                                       log.size ? (*log.size)[0] : settings.width,
                                       log.size ? (*log.size)[1] : settings.height));
        return Result<Diagnosis>(std::move(diagnosis), diagnostics.take());
    });
}

std::vector<DiagnosedCause> diagnosed_causes() {
    std::vector<DiagnosedCause> list;
    for (const MistakeInfo& info : mistake_infos()) list.push_back({info.id, info.explanation});
    return list;
}

}  // namespace glint
