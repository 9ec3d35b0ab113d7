// SPDX-License-Identifier: Apache-2.0
#include "cli/class_summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "cli/html_text.h"
#include "cli/rubric_notes.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

constexpr std::size_t k_max_pictures = 6;  // of a mistake
constexpr const char* k_style = R"(
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; color: #1a1a1a; }
table { border-collapse: collapse; }
th, td { padding: .25rem .75rem; border-bottom: 1px solid #ccc; text-align: left; }
td.number, th.number { text-align: right; }
figure { display: inline-block; margin: 0 1rem 1rem 0; }
figure img { image-rendering: pixelated; vertical-align: top; }
h2 { margin-top: 2.5rem; }
)";

// A picture that shows a mistake, or a part that is missing.
struct Example {
    std::size_t submission = 0;
    std::string caption;
    const PartPicture* picture = nullptr;
};

struct Mistake {
    std::string name, explanation;
    double points = 0;
    std::vector<Example> examples;

    std::size_t submissions() const {
        std::vector<std::size_t> whose;
        for (const Example& e : examples) whose.push_back(e.submission);
        std::sort(whose.begin(), whose.end());
        return static_cast<std::size_t>(std::unique(whose.begin(), whose.end()) - whose.begin());
    }
};

class Mistakes {
  public:
    void add(const std::string& name, const std::string& explanation, double points, Example example) {
        auto at = std::find_if(all_.begin(), all_.end(), [&](const Mistake& m) { return m.name == name; });
        if (at == all_.end()) at = all_.insert(all_.end(), {name, explanation, 0, {}});
        if (at->explanation.empty()) at->explanation = explanation;
        at->points += points;
        at->examples.push_back(std::move(example));
    }
    bool has(const std::string& name, std::size_t submission) const {
        const auto at =
            std::find_if(all_.begin(), all_.end(), [&](const Mistake& m) { return m.name == name; });
        return at != all_.end() && std::any_of(at->examples.begin(), at->examples.end(),
                                               [&](const Example& e) { return e.submission == submission; });
    }
    // Those of most submissions first, and of as many by name.
    std::vector<Mistake> sorted() && {
        std::sort(all_.begin(), all_.end(), [](const Mistake& a, const Mistake& b) {
            return std::pair(b.submissions(), std::string_view(a.name)) <
                   std::pair(a.submissions(), std::string_view(b.name));
        });
        return std::move(all_);
    }

  private:
    std::vector<Mistake> all_;
};

std::string safe(std::string_view text) { return html_text(printable(std::string(text))); }

// For links: without spaces.
std::string anchor(const std::string& name) {
    std::string text = html_text(name);
    std::replace(text.begin(), text.end(), ' ', '-');
    return text;
}

std::string figure(const Example& example) {
    std::string html = fmt::format("<figure><img alt=\"The picture\" src=\"{}\">", example.picture->picture);
    if (!example.picture->difference.empty()) {
        html += fmt::format(" <img alt=\"Its difference from the right picture\" src=\"{}\">",
                            example.picture->difference);
    }
    return html + fmt::format("<figcaption>{}</figcaption></figure>\n", safe(example.caption));
}

std::string section(const Mistake& mistake) {
    std::string html = fmt::format("<h2 id=\"{}\">{}</h2>\n", anchor(mistake.name), safe(mistake.name));
    if (!mistake.explanation.empty()) html += fmt::format("<p>{}</p>\n", safe(mistake.explanation));
    std::vector<std::string> names;
    for (const Example& e : mistake.examples) {
        if (names.empty() || names.back() != e.caption) names.push_back(e.caption);
    }
    html += fmt::format("<p>{}: {}</p>\n", counted(mistake.submissions(), "submission"),
                        safe(fmt::format("{}", fmt::join(names, "; "))));
    // One of each submission before a second of any.
    std::vector<const Example*> shown;
    for (const bool is_first : {true, false}) {
        for (std::size_t i = 0; i < mistake.examples.size(); ++i) {
            const Example& e = mistake.examples[i];
            const bool is_new = i == 0 || mistake.examples[i - 1].submission != e.submission;
            if (e.picture != nullptr && is_new == is_first && shown.size() < k_max_pictures)
                shown.push_back(&e);
        }
    }
    for (const Example* e : shown) html += figure(*e);
    return html;
}

std::string page(const std::vector<Mistake>& mistakes, std::size_t submissions, bool has_points) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>The mistakes of a class</title>\n"
        "<style>{}</style>\n<h1>The mistakes of a class</h1>\n<p>{}. {} Beside each picture is its "
        "difference from the right one, four times as bright.</p>\n",
        k_style, counted(submissions, "submission"),
        has_points ? k_review_text : "A cause is the likeliest one: look at the pictures.");
    if (mistakes.empty()) return html + "<p>No mistakes were found.</p>\n</html>\n";
    html += "<table>\n<tr><th>mistake<th class=\"number\">submissions";
    if (has_points) html += "<th class=\"number\">points lost";
    html += "\n";
    for (const Mistake& m : mistakes) {
        html += fmt::format("<tr><td><a href=\"#{}\">{}</a><td class=\"number\">{}", anchor(m.name),
                            safe(m.name), m.submissions());
        if (has_points) html += fmt::format("<td class=\"number\">{}", points_text(m.points));
        html += "\n";
    }
    html += "</table>\n";
    for (const Mistake& m : mistakes) html += section(m);
    return html + "</html>\n";
}

}  // namespace

std::string class_summary(const Rubric& rubric, const std::vector<GradedSubmission>& submissions,
                          const PartPictures& pictures) {
    Mistakes mistakes;
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        const GradedSubmission& s = submissions[i];
        for (std::size_t k = 0; k < rubric.rows.size(); ++k) {
            const GradedPart& part = s.parts[k];
            const double lost = rubric.rows[k].points - part.score.points;
            if (!(lost > 0)) continue;
            mistakes.add(loss_name(part), part.cause ? part.cause->explanation : "", lost,
                         {i, fmt::format("{}, {}", s.name, rubric.rows[k].part),
                          pictures.find(i * rubric.rows.size() + k)});
        }
        for (const RubricPenalty& penalty : s.penalties)
            mistakes.add(penalty.cause, "", penalty.points, {i, s.name, nullptr});
        // Those that cost nothing because their part was not handed in.
        for (const Cause& fault : s.faults) {
            for (std::size_t k = 0; k < rubric.rows.size() && !mistakes.has(fault.name, i); ++k) {
                const std::vector<std::string>& followed = s.parts[k].followed;
                if (std::find(followed.begin(), followed.end(), fault.name) == followed.end()) continue;
                mistakes.add(fault.name, fault.explanation, 0,
                             {i, fmt::format("{}, {}", s.name, rubric.rows[k].part),
                              pictures.find(i * rubric.rows.size() + k)});
            }
        }
    }
    return page(std::move(mistakes).sorted(), submissions.size(), true);
}

std::string class_summary(const std::vector<GradedPicture>& graded, const PartPictures& pictures) {
    Mistakes mistakes;
    for (std::size_t i = 0; i < graded.size(); ++i) {
        const GradedPicture& p = graded[i];
        const Example example{i, p.name, pictures.find(i)};
        if (!p.error.empty()) {
            mistakes.add("not readable, or another size", "", 0, example);
        } else if (p.not_finite > 0) {
            mistakes.add("NaN or infinite", "", 0, example);
        } else if (!p.causes.causes.empty()) {
            const Cause& cause = p.causes.causes.front();
            mistakes.add(cause.name, cause.explanation, 0, example);
        } else if (!p.causes.agrees && p.difference.all.equal != p.difference.all.pixels) {
            mistakes.add("no classic cause", "", 0, example);
        }
    }
    return page(std::move(mistakes).sorted(), graded.size(), false);
}

}  // namespace glint::cli
