// SPDX-License-Identifier: Apache-2.0
#include "cli/grade_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "cli/compare_report.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

// Columns as wide as their widest cell, two spaces apart; the first ones to the left, numbers to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left_columns) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool left = i < left_columns || i + 1 == widths.size();
            line += left ? fmt::format("{:<{}}  ", row[i], widths[i])
                         : fmt::format("{:>{}}  ", row[i], widths[i]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

// For people: a student, or a rubric, may call something what moves the terminal's cursor. U+0080 to U+009F
// are control characters, too, and so is half of one to a terminal that takes bytes.
std::string printable(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const auto c = static_cast<unsigned char>(text.front());
        const bool is_control =
            c < 0x20 || c == 0x7f || (length == 2 && c == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0);
        const std::size_t taken = std::max<std::size_t>(length, 1);
        safe += length == 0 || is_control ? "?" : text.substr(0, taken);
        text.remove_prefix(taken);
    }
    return safe;
}

// RFC 4180; and a leading = + - @ would be a formula to a spreadsheet, which a file's name must not be.
std::string csv_cell(const std::string& text) {
    std::string safe = text;
    if (!safe.empty() && std::string_view("=+-@\t").find(safe[0]) != std::string_view::npos)
        safe.insert(0, "'");
    if (safe.find_first_of(",\"\r\n") == std::string::npos) return safe;
    std::string quoted = "\"";
    for (const char c : safe) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
    return line + "\r\n";
}

std::string dumped(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

double share(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string cause_text(const Cause& cause) {
    return fmt::format("{}{} ({})", cause.perhaps ? "perhaps " : "", cause.name, share_text(cause.explained));
}

// Such pixels count as 0 in the figures, which look like a fault of the lighting.
std::string not_finite_text(std::uint64_t pixels) {
    return fmt::format("{} {} NaN or infinite", counted(pixels, "pixel"), pixels == 1 ? "is" : "are");
}

// What a row of the table ends with.
std::string verdict(const GradedPicture& p) {
    if (!p.error.empty()) return p.error;
    if (p.not_finite > 0) return not_finite_text(p.not_finite);
    if (p.difference.all.equal == p.difference.all.pixels) return "identical";
    if (!p.causes_error.empty()) return p.causes_error;
    if (p.causes.causes.empty()) return p.causes.remark.empty() ? "no classic cause" : p.causes.remark;
    std::string text = cause_text(p.causes.causes.front());
    for (const Cause& cause : p.causes.then) text += " and then " + cause_text(cause);
    return text;
}

Json cause_json(const Cause& cause) {
    return {{"name", cause.name},
            {"explained", cause.explained},
            {"explanation", cause.explanation},
            {"perhaps", cause.perhaps}};
}

std::string points_text(double points) { return fmt::format("{:.4g}", points); }

double all_points(const std::vector<RubricRow>& rows) {
    double sum = 0;
    for (const RubricRow& row : rows) sum += row.points;
    return sum;
}

// Why a part has not all its points, and whether it has pixels without a value; empty if all is well.
std::string part_note(const RubricRow& row, const GradedPart& part) {
    if (!part.error.empty()) return part.error;
    std::string note;
    if (part.score.not_finite > 0) note = not_finite_text(part.score.not_finite);
    if (part.score.points >= row.points) return note;
    note +=
        fmt::format("{}{} of the pixels are right", note.empty() ? "" : "; ", share_text(part.score.share));
    if (!row.without.empty())
        note += fmt::format(", {} of those that show it", share_text(part.score.part_share));
    if (part.cause) note += fmt::format("; {}: {}", cause_text(*part.cause), part.cause->explanation);
    return note;
}

}  // namespace

double GradedSubmission::total() const {
    double sum = 0;
    for (const GradedPart& part : parts) sum += part.score.points;
    return sum;
}

std::string text_table(const std::vector<GradedPicture>& pictures) {
    std::vector<std::vector<std::string>> rows = {
        {"#", "picture", "equal", "interiors within 2", "mean", "SSIM", "likeliest cause"}};
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const GradedPicture& p = pictures[i];
        const PictureDifference& d = p.difference;
        std::vector<std::string> row = {std::to_string(i + 1), printable(p.name), "-", "-", "-", "-",
                                        printable(verdict(p))};
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
            cells.insert(cells.end(), {cause.name, fmt::format("{}", cause.explained), cause.explanation});
        }
        cells.push_back(p.error.empty() ? p.causes_error : p.error);
        text += csv_line(cells);
    }
    return text;
}

std::string json_table(const std::vector<GradedPicture>& pictures) {
    Json json = Json::array();
    for (const GradedPicture& p : pictures) {
        Json item = {{"name", p.name}, {"file", p.path}};
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
            item["psnr"] = d.psnr ? Json(*d.psnr) : Json(nullptr);
            item["ssim"] = d.ssim ? Json(*d.ssim) : Json(nullptr);
            item["largest"] = {{"value", d.largest.value}, {"x", d.largest.x}, {"y", d.largest.y}};
            item["causes"] = Json::array();
            for (const Cause& cause : p.causes.causes) item["causes"].push_back(cause_json(cause));
            item["then"] = Json::array();
            for (const Cause& cause : p.causes.then) item["then"].push_back(cause_json(cause));
            item["remark"] = p.not_finite > 0          ? Json(not_finite_text(p.not_finite))
                             : p.causes.remark.empty() ? Json(nullptr)
                                                       : Json(p.causes.remark);
        }
        json.push_back(std::move(item));
    }
    return dumped(json);
}

std::string text_table(const std::vector<RubricRow>& rubric,
                       const std::vector<GradedSubmission>& submissions) {
    std::vector<std::vector<std::string>> rows = {{"#", "submission"}, {"", "of"}};
    for (const RubricRow& row : rubric) {
        rows[0].push_back(printable(row.part));
        rows[1].push_back(points_text(row.points));
    }
    rows[0].push_back("total");
    rows[1].push_back(points_text(all_points(rubric)));
    std::string notes;
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        const GradedSubmission& s = submissions[i];
        rows.push_back({std::to_string(i + 1), printable(s.name)});
        for (std::size_t k = 0; k < rubric.size(); ++k) {
            rows.back().push_back(points_text(s.parts[k].score.points));
            const std::string note = part_note(rubric[k], s.parts[k]);
            if (!note.empty())
                notes += printable(fmt::format("{}, {}: {}", s.name, rubric[k].part, note)) + "\n";
        }
        rows.back().push_back(points_text(s.total()));
    }
    return aligned(rows, 2) + (notes.empty() ? "" : "\n" + notes);
}

std::string csv_table(const std::vector<RubricRow>& rubric,
                      const std::vector<GradedSubmission>& submissions) {
    std::vector<std::string> head = {"name"};
    for (const RubricRow& row : rubric) head.push_back(row.part);
    head.insert(head.end(), {"total", "of", "notes"});
    std::string text = csv_line(head);
    for (const GradedSubmission& s : submissions) {
        std::vector<std::string> cells = {s.name};
        std::string notes;
        for (std::size_t k = 0; k < rubric.size(); ++k) {
            cells.push_back(fmt::format("{:.2f}", s.parts[k].score.points));
            const std::string note = part_note(rubric[k], s.parts[k]);
            if (!note.empty())
                notes += fmt::format("{}{}: {}", notes.empty() ? "" : " | ", rubric[k].part, note);
        }
        cells.insert(cells.end(),
                     {fmt::format("{:.2f}", s.total()), fmt::format("{:.2f}", all_points(rubric)), notes});
        text += csv_line(cells);
    }
    return text;
}

std::string json_table(const std::vector<RubricRow>& rubric,
                       const std::vector<GradedSubmission>& submissions) {
    Json json = Json::array();
    for (const GradedSubmission& s : submissions) {
        Json item = {
            {"name", s.name}, {"total", s.total()}, {"of", all_points(rubric)}, {"parts", Json::array()}};
        for (std::size_t k = 0; k < rubric.size(); ++k) {
            const GradedPart& part = s.parts[k];
            Json entry = {{"part", rubric[k].part},
                          {"points", part.score.points},
                          {"of", rubric[k].points},
                          {"file", part.path}};
            if (!part.error.empty()) {
                entry["error"] = part.error;
            } else {
                entry["not_finite"] = part.score.not_finite;
                entry["share"] = part.score.share;
                entry["part_share"] = part.score.part_share;
            }
            entry["cause"] = part.cause ? cause_json(*part.cause) : Json(nullptr);
            item["parts"].push_back(std::move(entry));
        }
        json.push_back(std::move(item));
    }
    return dumped(json);
}

}  // namespace glint::cli
