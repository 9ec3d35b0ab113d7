// SPDX-License-Identifier: Apache-2.0
#include "cli/diagnosis_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cli/explain_text.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

std::string number_text(double v) {
    if (std::isnan(v)) return "nan";
    return fmt::format("{:.7g}", v == 0 ? 0.0 : v);
}

std::string value_text(const DiagnosedRow& row, const DiagnosedValue& value) {
    if (value.count == 0) return "-";
    if (row.quantity == "shape")
        return value.numbers[0] < 1 ? "a miss" : fmt::format("shape {:.0f}", value.numbers[0]);
    if (row.quantity == "children")
        return value.numbers[0] == 0   ? "none"
               : value.numbers[0] == 1 ? "a mirror ray"
               : value.numbers[0] == 2 ? "a glass ray"
                                       : "a mirror and a glass ray";
    if (value.count == 1) return number_text(value.numbers[0]);
    return fmt::format("({}, {}, {})", number_text(value.numbers[0]), number_text(value.numbers[1]),
                       number_text(value.numbers[2]));
}

std::string place_text(const DiagnosedRow& row, const Scene& scene) {
    std::string text = fmt::format("pixel {},{}", row.x, row.y);
    if (row.ray >= 0 && row.generation > 0)
        text += fmt::format(", {} ray (generation {})", row.ray_kind, row.generation);
    if (row.light < scene.lights.size()) text += ", " + light_text(scene, row.light);
    if (row.line != 0) text += fmt::format(", line {} of the log", row.line);
    return text;
}

// "N is wrong in 20 of 24 pixels, in 20 as the first difference".
std::string wrong_text(const DiagnosisFinding& finding, const Diagnosis& diagnosis) {
    std::string text;
    auto out = std::back_inserter(text);
    std::string word(finding.word);
    if (word.starts_with("the ") || word.starts_with("whether "))
        word.front() = static_cast<char>(word.front() - 'a' + 'A');
    fmt::format_to(
        out, "{}{} {} wrong in {} of {}", word, finding.quantity == "children" ? " (its number)" : "",
        finding.quantity == "bytes" ? "are" : "is", finding.pixels, counted(diagnosis.pixels, "pixel"));
    if (finding.first_pixels > 0)
        fmt::format_to(out, ", in {} as the first difference", finding.first_pixels);
    if (!finding.only.empty()) fmt::format_to(out, "; only {}", finding.only);
    return text;
}

std::string finding_text(const DiagnosisFinding& finding, const Diagnosis& diagnosis, const Scene& scene) {
    std::string text = wrong_text(finding, diagnosis);
    auto out = std::back_inserter(text);
    text += ".\n";
    const DiagnosedRow& row = finding.example;
    fmt::format_to(out, "  {}: yours {}, it should be {}\n", place_text(row, scene),
                   value_text(row, row.yours), value_text(row, row.expected));
    if (!finding.relation.empty() && finding.causes.empty())
        fmt::format_to(out, "  everywhere {}\n", finding.relation);
    if (finding.relation.starts_with("the exponent")) fmt::format_to(out, "  {}\n", finding.relation);
    if (finding.is_sure) {
        fmt::format_to(out, "  cause: {} ({})\n", finding.causes[0].explanation, finding.causes[0].id);
    } else if (!finding.causes.empty()) {
        fmt::format_to(out, "  {}\n",
                       finding.causes.size() == 1 ? "possible cause, which gives these numbers:"
                                                  : "possible causes, each of which gives these numbers:");
        for (const DiagnosedCause& cause : finding.causes)
            fmt::format_to(out, "    {} ({})\n", cause.explanation, cause.id);
    } else {
        text += "  cause unknown: no known mistake gives these numbers\n";
        if (finding.pixels * 500 < diagnosis.pixels)
            text += "  so few may be rounding, which grows behind mirrors and glass\n";
    }
    fmt::format_to(out, "  {} = {}{}{}\n", finding.quantity, finding.formula,
                   finding.where.empty() ? "" : "; see ", finding.where);
    return text;
}

}  // namespace

std::string diagnosis_tree_text(const Diagnosis& diagnosis, const Scene& scene, std::int32_t x,
                                std::int32_t y) {
    std::string text;
    auto out = std::back_inserter(text);
    std::int32_t ray = -2;
    std::uint32_t light = k_none;
    for (const DiagnosedRow& row : diagnosis.rows) {
        if (row.x != x || row.y != y) continue;
        const std::string indent(static_cast<std::size_t>(2 * row.generation), ' ');
        if (row.ray != ray) {
            if (row.ray < 0) {
                text += "the pixel\n";
            } else {
                fmt::format_to(out, "{}{} ray\n", indent, row.ray_kind);
            }
        }
        if (row.light != light && row.light < scene.lights.size())
            fmt::format_to(out, "{}  {}\n", indent, light_text(scene, row.light));
        ray = row.ray, light = row.light;
        constexpr std::string_view marks[] = {"  ", "! ", "? "};
        fmt::format_to(out, "{}{}{}{:<12} {:<38} {}\n", indent, row.light < scene.lights.size() ? "  " : "",
                       marks[static_cast<std::size_t>(row.verdict)], row.quantity, value_text(row, row.yours),
                       row.verdict == DiagnosedRow::Verdict::wrong ? value_text(row, row.expected) : "");
    }
    if (text.empty()) return text;
    return fmt::format(
        "pixel {},{}: the log's values; after those that are wrong (!), what they should be; ?: not "
        "judged\n{}",
        x, y, text);
}

std::string feedback_text(const Diagnosis& d, bool with_cause) {
    if (d.findings.empty())
        return d.judged == 0 ? "nothing in it could be compared" : "no value in it is wrong";
    const DiagnosisFinding& finding = d.findings.front();
    std::string text = wrong_text(finding, d);
    if (!with_cause) return text;
    if (finding.causes.empty()) return text + "; cause unknown";
    if (finding.is_sure)
        return text + fmt::format("; cause: {} ({})", finding.causes[0].explanation, finding.causes[0].id);
    std::string ids;
    for (const DiagnosedCause& cause : finding.causes)
        ids += (ids.empty() ? "" : ", ") + std::string(cause.id);
    return text + "; possible causes: " + ids;
}

std::string picture_text(const Diagnosis& diagnosis, const Image& picture,
                         const std::vector<ProposedPixel>& proposed) {
    std::size_t compared = 0;
    std::vector<const DiagnosedRow*> other;
    const auto row_of = [&](std::int32_t y) {
        return diagnosis.rows_from_bottom ? picture.height - 1 - y : y;
    };
    for (const DiagnosedRow& row : diagnosis.rows) {
        if (row.quantity != "bytes" || row.yours.count != 3 || row.x >= picture.width ||
            row.y >= picture.height)
            continue;
        ++compared;
        const std::size_t at =
            3 * (static_cast<std::size_t>(row_of(row.y)) * static_cast<std::size_t>(picture.width) +
                 static_cast<std::size_t>(row.x));
        for (std::size_t c = 0; c < 3; ++c) {
            if (std::fabs(255.0 * picture.rgb[at + c] - row.yours.numbers[c]) <= 1.5) continue;
            other.push_back(&row);
            break;
        }
    }
    std::string text;
    auto out = std::back_inserter(text);
    if (!other.empty())
        fmt::format_to(out,
                       "\nThe picture has other bytes than the log at {} of {}, as at {},{}: is it of the "
                       "same run, with the same rows?\n",
                       other.size(), counted(compared, "pixel"), other[0]->x, other[0]->y);
    std::string list;
    for (const ProposedPixel& p : proposed) {
        const bool is_logged =
            std::any_of(diagnosis.rows.begin(), diagnosis.rows.end(),
                        [&](const DiagnosedRow& r) { return r.x == p.x && row_of(r.y) == p.y; });
        if (p.kind != "equal" && !is_logged)
            list += fmt::format("{}{},{} ({})", list.empty() ? "" : "; ", p.x, p.y, p.kind);
    }
    if (!list.empty())
        fmt::format_to(out, "\nThe picture differs at these pixels, too, which are not in the log: {}\n",
                       list);
    return text;
}

std::string diagnosis_text(const Diagnosis& d, const Scene& scene) {
    std::string text;
    auto out = std::back_inserter(text);
    for (const std::string& sentence : d.conventions) text += sentence + "\n";
    fmt::format_to(out, "{} values of {} in {} were compared", with_commas(d.judged), counted(d.rays, "ray"),
                   counted(d.pixels, "pixel"));
    if (d.unknown > 0) fmt::format_to(out, "; {} could not be judged", with_commas(d.unknown));
    text += ".\n";
    if (d.outside > 0)
        fmt::format_to(
            out, "{} not in the picture.\n",
            d.outside == 1 ? "One pixel of the log is" : fmt::format("{} pixels of the log are", d.outside));
    if (d.findings.empty() && d.judged == 0)
        return text + "Nothing could be compared: the log has too little, or it is not of this scene.\n";
    if (d.findings.empty() && d.unknown > d.judged / 4)
        return text +
               "None of the values that could be compared differs: each follows from the scene, up to "
               "rounding.\n";
    if (d.findings.empty())
        return text + "Nothing differs: each value follows from the scene, up to rounding.\n";
    for (const DiagnosisFinding& finding : d.findings) text += "\n" + finding_text(finding, d, scene);
    const DiagnosedRow& first = d.findings.front().example;
    fmt::format_to(out, "\nAll quantities of such a pixel: --tree {},{}\n", first.x, first.y);
    return text;
}

}  // namespace glint::cli
