// SPDX-License-Identifier: Apache-2.0
#include "cli/compare_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/text.h"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t k_max_other_causes = 3;

std::string pixel_text(const float (&c)[3], bool as_floats) {
    if (as_floats) return fmt::format("({:.5g}, {:.5g}, {:.5g})", c[0], c[1], c[2]);
    return fmt::format("({}, {}, {})", to_byte(c[0]), to_byte(c[1]), to_byte(c[2]));
}

void add_counts(std::string& text, const char* name, const PixelCounts& counts) {
    fmt::format_to(std::back_inserter(text), "{:<10}{:>13} {:>10} {:>13} {:>13}\n", name,
                   with_commas(counts.pixels), percent_text(counts.equal, counts.pixels),
                   percent_text(counts.within_1, counts.pixels), percent_text(counts.within, counts.pixels));
}

void add_others(std::string& text, const char* how, std::span<const Cause> causes) {
    if (causes.empty()) return;
    std::vector<std::string> words;
    for (const Cause& cause : causes.first(std::min(causes.size(), k_max_other_causes)))
        words.push_back(fmt::format("{} ({})", cause.name, share_text(cause.explained)));
    text += fmt::format("  {}: {}\n", how, fmt::join(words, ", "));
}

// If no cause explains enough: the nearest one.
void add_nearest(std::string& text, const CompareReport& report) {
    const CauseReport& causes = **report.causes;
    if (causes.tried == 0 || (!causes.remark.empty() && !causes.nearest)) return;
    const std::string nearest = causes.nearest
                                    ? fmt::format("the nearest, {}, explains {}", causes.nearest->name,
                                                  share_text(causes.nearest->explained))
                                    : std::string("none explains any of it");
    fmt::format_to(std::back_inserter(text), "{}{}; {} were tried{}.\n",
                   causes.remark.empty() ? "Nothing classic explains the difference: " : "  Of the causes ",
                   nearest, causes.tried, report.with_scene ? "" : ", and --scene SCENE tries more");
}

void add_causes(std::string& text, const CompareReport& report) {
    auto out = std::back_inserter(text);
    if (!*report.causes) {
        fmt::format_to(out, "causes     {}\n", report.causes->message);
        return;
    }
    const CauseReport& causes = **report.causes;
    if (causes.swapped) {
        fmt::format_to(out,
                       "The scene gives {}, and not {}: what follows explains the latter (A is yours, B the "
                       "reference).\n",
                       report.a, report.b);
    } else if (causes.scene_from_b && *causes.scene_from_b > 0) {
        fmt::format_to(out, "scene      its own picture is {:.3g} of 255 from {}, in the mean{}\n",
                       *causes.scene_from_b, report.b,
                       *causes.scene_from_b > causes.difference / 2
                           ? ": it does not give that picture, so do not trust the causes"
                           : "");
    }
    if (!causes.remark.empty()) text += causes.remark + "\n";
    if (causes.causes.empty()) {
        add_nearest(text, report);
        if (!causes.where.empty()) text += "  " + causes.where + "\n";
        return;
    }
    const Cause& best = causes.causes.front();
    fmt::format_to(out, "{}{}\n  ({}: explains {} of the difference{})\n", likelihood_text(causes),
                   best.explanation, best.name, share_text(best.explained),
                   causes.away_from_edges ? " away from edges" : "");
    for (const Cause& cause : causes.then)
        fmt::format_to(out, "And then also: {}\n  ({}: with it {} is explained)\n", cause.explanation,
                       cause.name, share_text(cause.explained));
    if (!causes.where.empty()) text += causes.where + "\n";
    // What leaves exactly the same cannot be told apart by these pictures.
    const auto lesser = std::find_if(causes.causes.begin() + 1, causes.causes.end(),
                                     [&](const Cause& c) { return c.remaining != best.remaining; });
    const auto as_good = static_cast<std::size_t>(lesser - causes.causes.begin());
    const std::span<const Cause> all = causes.causes;
    add_others(text, "the same picture comes from", all.subspan(1, as_good - 1));
    add_others(text, "less likely", all.subspan(as_good));
    if (!report.with_scene && best.explained < 0.95) text += "  --scene SCENE tries more causes.\n";
}

Json counts_json(const PixelCounts& counts) {
    return {{"pixels", counts.pixels},
            {"equal", counts.equal},
            {"within_1", counts.within_1},
            {"within", counts.within}};
}

template <class T> Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json full_cause_json(const Cause& cause) {
    return {{"name", cause.name},           {"explanation", cause.explanation},
            {"explained", cause.explained}, {"remaining", cause.remaining},
            {"rendered", cause.rendered},   {"perhaps", cause.perhaps}};
}

Json causes_json(const Result<CauseReport>& result) {
    const CauseReport report = result.value_or(CauseReport{});
    Json json = {{"agrees", report.agrees},
                 {"tried", report.tried},
                 {"swapped", report.swapped},
                 {"away_from_edges", report.away_from_edges}};
    json["scene_from_a"] = or_null(report.scene_from_a);
    json["scene_from_b"] = or_null(report.scene_from_b);
    if (!result) json["error"] = result.message;
    json["remark"] = report.remark.empty() ? Json(nullptr) : Json(report.remark);
    json["nearest"] = report.nearest ? full_cause_json(*report.nearest) : Json(nullptr);
    json["where"] = report.where.empty() ? Json(nullptr) : Json(report.where);
    json["then"] = Json::array();
    for (const Cause& cause : report.then) json["then"].push_back(full_cause_json(cause));
    json["causes"] = Json::array();
    for (const Cause& cause : report.causes) json["causes"].push_back(full_cause_json(cause));
    return json;
}

}  // namespace

std::string percent_text(std::uint64_t part, std::uint64_t whole) {
    if (whole == 0) return "-";
    if (part == whole) return "100%";
    if (part == 0) return "0%";
    const double percent = 100 * static_cast<double>(part) / static_cast<double>(whole);
    if (percent < 0.01) return "<0.01%";
    return percent > 99.99 ? ">99.99%" : fmt::format("{:.2f}%", percent);
}

std::string share_text(double share) {
    const std::string text = fmt::format("{:.3g}%", 100 * share);
    return share < 1 && text == "100%" ? ">99.9%" : text;
}

std::string likelihood_text(const CauseReport& report) {
    const Cause& first = report.causes.front();
    if (!first.perhaps) return {};
    return first.rendered || report.scene_from_b ? "Perhaps: " : "A guess from the pictures alone: ";
}

std::string text_report(const CompareReport& report) {
    const PictureDifference& d = report.difference;
    std::string text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "{} against {}, {}x{} pixels{}\n", report.a, report.b, report.width, report.height,
                   report.as_floats ? ", as floats" : "");
    if (d.all.equal == d.all.pixels) return text + "identical\n";
    fmt::format_to(out, "{:<10}{:>13} {:>10} {:>13} {:>13}\n", "", "pixels", "equal", "within 1/255",
                   fmt::format("within {:.4g}/255", report.within));
    add_counts(text, "all", d.all);
    add_counts(text, "edges", d.edges);
    add_counts(text, "interiors", d.interiors);
    if (d.not_finite > 0)
        fmt::format_to(out,
                       "not finite {:>13} pixels have a number that is infinite or NaN: never equal, below "
                       "taken for 0\n",
                       with_commas(d.not_finite));
    fmt::format_to(out, "of 255     mean {:.4g}, root mean square {:.4g}", d.mean, d.rms);
    if (d.psnr) fmt::format_to(out, "; PSNR {:.2f} dB", *d.psnr);
    if (d.ssim) fmt::format_to(out, ", SSIM {:.4f}", *d.ssim);
    fmt::format_to(out, "\nlargest    {:.4g} at x {}, y {}: {}, and in {} {}\n", d.largest.value, d.largest.x,
                   d.largest.y, pixel_text(d.largest.a, report.as_floats), report.reference,
                   pixel_text(d.largest.b, report.as_floats));
    if (report.causes) add_causes(text, report);
    return text;
}

std::string json_report(const CompareReport& report) {
    const PictureDifference& d = report.difference;
    Json json = {{"a", report.a},
                 {"b", report.b},
                 {"width", report.width},
                 {"height", report.height},
                 {"as_floats", report.as_floats},
                 {"passes", report.passes},
                 {"identical", d.all.equal == d.all.pixels},
                 {"within", report.within}};
    json["all"] = counts_json(d.all);
    json["edges"] = counts_json(d.edges);
    json["interiors"] = counts_json(d.interiors);
    json["not_finite"] = d.not_finite;
    json["mean"] = d.mean;
    json["rms"] = d.rms;
    json["psnr"] = or_null(d.psnr);
    json["ssim"] = or_null(d.ssim);
    json["largest"] = {{"value", d.largest.value},
                       {"x", d.largest.x},
                       {"y", d.largest.y},
                       {"a", d.largest.a},
                       {"b", d.largest.b}};
    json["diagnosis"] = report.causes ? causes_json(*report.causes) : Json(nullptr);
    if (!report.explanations.empty())
        json["explained"] = {
            {"value", report.explained.value}, {"x", report.explained.x}, {"y", report.explained.y}};
    for (const std::string& text : report.explanations) json["explanations"].push_back(Json::parse(text));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace glint::cli
