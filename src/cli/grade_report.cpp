// SPDX-License-Identifier: Apache-2.0
#include "cli/grade_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/compare_report.h"
#include "cli/grade_json.h"
#include "cli/table_text.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

double share(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string likeliest_cause(const GradedPicture& p) {
    if (!p.causes_error.empty()) return p.causes_error;
    if (p.causes.causes.empty()) return p.causes.remark.empty() ? "no classic cause" : p.causes.remark;
    std::string text = cause_text(p.causes.causes.front());
    for (const Cause& cause : p.causes.then) text += " and then " + cause_text(cause);
    return text;
}

// What a row of the table ends with.
std::string verdict(const GradedPicture& p) {
    if (!p.error.empty()) return p.error;
    if (p.not_finite > 0) return not_finite_text(p.not_finite);
    if (p.difference.all.equal == p.difference.all.pixels) return "identical";
    return likeliest_cause(p) + (p.note.empty() ? "" : "; " + p.note);
}

// All causes in sentences for the student.
std::string explanation_text(const CauseReport& report) {
    std::string text = likelihood_text(report) + report.causes.front().explanation;
    for (const Cause& cause : report.then) text += " And then also: " + cause.explanation;
    return text;
}

}  // namespace

std::string cause_text(const Cause& cause) {
    return fmt::format("{}{} ({})", cause.perhaps ? "perhaps " : "", cause.name, share_text(cause.explained));
}

std::string not_finite_text(std::uint64_t pixels) {
    return fmt::format("{} {} NaN or infinite", counted(pixels, "pixel"), pixels == 1 ? "is" : "are");
}

nlohmann::ordered_json cause_json(const Cause& cause) {
    return {{"name", cause.name},
            {"explained", cause.explained},
            {"explanation", cause.explanation},
            {"perhaps", cause.perhaps}};
}

std::string dumped(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string text_table(const std::vector<GradedPicture>& pictures) {
    std::vector<std::vector<std::string>> rows = {
        {"#", "picture", "equal", "interiors within 2", "mean", "SSIM", "likeliest cause"}};
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const GradedPicture& p = pictures[i];
        const PictureDifference& d = p.difference;
        std::vector<std::string> row = {std::to_string(i + 1), p.name, "-", "-", "-", "-", verdict(p)};
        if (p.error.empty()) {
            row[2] = percent_text(d.all.equal, d.all.pixels);
            row[3] = percent_text(d.interiors.within, d.interiors.pixels);
            row[4] = fmt::format("{:.3g}", d.mean);
            if (d.ssim) row[5] = fmt::format("{:.4f}", *d.ssim);
        }
        rows.push_back(std::move(row));
    }
    return aligned(rows, 2);
}

std::string csv_table(const std::vector<GradedPicture>& pictures) {
    std::string text = csv_line({"name", "file", "pixels", "not_finite", "equal", "within_1", "within_2",
                                 "interiors", "interiors_within_2", "mean", "rms", "psnr", "ssim", "largest",
                                 "cause", "explained", "explanation", "error"});
    for (const GradedPicture& p : pictures) {
        const PictureDifference& d = p.difference;
        std::vector<std::string> cells = {p.name, p.path};
        if (p.error.empty()) {
            for (const std::uint64_t count : {d.all.pixels, p.not_finite, d.all.equal, d.all.within_1,
                                              d.all.within, d.interiors.pixels, d.interiors.within})
                cells.push_back(std::to_string(count));
            cells.push_back(fmt::format("{}", d.mean));
            cells.push_back(fmt::format("{}", d.rms));
            cells.push_back(d.psnr ? fmt::format("{}", *d.psnr) : "");
            cells.push_back(d.ssim ? fmt::format("{}", *d.ssim) : "");
            cells.push_back(fmt::format("{}", d.largest.value));
        }
        cells.resize(14);
        if (p.not_finite > 0) {
            cells.insert(cells.end(), {"", "", not_finite_text(p.not_finite)});
        } else if (p.causes.causes.empty()) {
            cells.resize(17);
        } else {
            const Cause& cause = p.causes.causes.front();
            cells.insert(cells.end(),
                         {cause.name, fmt::format("{}", cause.explained), explanation_text(p.causes)});
        }
        cells.push_back(p.error.empty() ? p.causes_error : p.error);
        text += csv_line(cells);
    }
    return text;
}

std::string json_table(const std::vector<GradedPicture>& pictures) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const GradedPicture& p : pictures) {
        nlohmann::ordered_json item = {{"name", p.name}, {"file", p.path}};
        if (!p.error.empty()) {
            item["error"] = p.error;
        } else {
            const PictureDifference& d = p.difference;
            item["not_finite"] = p.not_finite;
            item["equal"] = share(d.all.equal, d.all.pixels);
            item["within_1"] = share(d.all.within_1, d.all.pixels);
            item["within_2"] = share(d.all.within, d.all.pixels);
            item["interiors_within_2"] = share(d.interiors.within, d.interiors.pixels);
            item["mean"] = d.mean;
            item["rms"] = d.rms;
            item["psnr"] = d.psnr ? nlohmann::ordered_json(*d.psnr) : nlohmann::ordered_json(nullptr);
            item["ssim"] = d.ssim ? nlohmann::ordered_json(*d.ssim) : nlohmann::ordered_json(nullptr);
            item["largest"] = {{"value", d.largest.value}, {"x", d.largest.x}, {"y", d.largest.y}};
            item["causes"] = nlohmann::ordered_json::array();
            for (const Cause& cause : p.causes.causes) item["causes"].push_back(cause_json(cause));
            item["then"] = nlohmann::ordered_json::array();
            for (const Cause& cause : p.causes.then) item["then"].push_back(cause_json(cause));
            item["remark"] = p.not_finite > 0          ? nlohmann::ordered_json(not_finite_text(p.not_finite))
                             : p.causes.remark.empty() ? nlohmann::ordered_json(nullptr)
                                                       : nlohmann::ordered_json(p.causes.remark);
            item["note"] = p.note.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(p.note);
        }
        json.push_back(std::move(item));
    }
    return dumped(json);
}

}  // namespace glint::cli
