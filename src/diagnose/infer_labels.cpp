// SPDX-License-Identifier: Apache-2.0
#include "diagnose/infer_labels.h"

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>

#include "diagnose/log_line.h"

namespace glint {
namespace {

// The scene's names in small letters, as the reader has those of the log.
std::unordered_map<std::string, std::uint32_t> indices_by_name(const ItemTexts& texts) {
    std::unordered_map<std::string, std::uint32_t> indices;
    for (const auto& [index, name] : texts.names) indices.emplace(in_small_letters(name), index);
    return indices;
}

// How often a light's L, distance, N.L or diffuse term is that of a light of the scene.
void add_light_votes(const LogModel& model, std::size_t p, std::size_t r,
                     std::vector<std::vector<int>>& votes) {
    const LoggedRay& ray = model.log.pixels[p].rays[r];
    const std::int32_t paired = model.references[p].ray[r];
    const ExplainedRay* explained =
        paired >= 0 ? &model.references[p].explanation->rays[static_cast<std::size_t>(paired)] : nullptr;
    const auto own = ray.vector(Quantity::point);
    if (!own && (explained == nullptr || !explained->hit)) return;
    const Vec3 point = own ? own->value() : explained->hit->point;
    for (const LoggedLight& light : ray.lights) {
        const auto l = light.vector(Quantity::to_light), d = light.vector(Quantity::distance),
                   diffuse = light.vector(Quantity::diffuse);
        for (std::uint32_t i = 0; i < model.scene.lights.size(); ++i) {
            const Light& candidate = model.scene.lights[i];
            if (candidate.is_ambient()) continue;
            int& count = votes[light.label][i];
            const ApproxVec way(candidate.way_from(point));
            if (l && std::fabs(dot(unit(*l), unit(way)).v) > 0.99999) count += 4;
            if (d && candidate.has_position() && agree(d->x, length(way), 1e-4 * length(way).v)) count += 4;
            if (explained == nullptr || !explained->hit) continue;
            for (const LightTerms& terms : explained->hit->lights) {
                if (terms.light != i) continue;
                if (const auto n_l = light.vector(Quantity::n_l); n_l && agree(n_l->x, terms.n_l, 1e-4))
                    count += 2;
                const ApproxVec one(terms.diffuse);
                if (diffuse && terms.diffuse.r + terms.diffuse.g + terms.diffuse.b > 1e-3 &&
                    (agree(*diffuse, one, 1e-4) || agree(*diffuse, one * Approx(255), 1e-2)))
                    ++count;
            }
        }
    }
}

// From which number shapes are counted, if the numbers themselves show it: from 0 or from 1.
std::optional<std::int64_t> first_number(const std::vector<LogLabel>& labels, std::size_t shapes) {
    const auto has = [&](std::int64_t number) {
        return std::any_of(labels.begin(), labels.end(),
                           [&](const LogLabel& label) { return label.number == number; });
    };
    if (has(0)) return 0;
    return has(static_cast<std::int64_t>(shapes)) ? std::optional<std::int64_t>(1) : std::nullopt;
}

}  // namespace

// Which shape a label is: that which is hit where t or P agree, else that of its name or its number.
void infer_shapes(LogModel& model) {
    const TraceLog& log = model.log;
    std::vector<std::map<std::uint32_t, int>> sure(log.shape_labels.size()), likely(log.shape_labels.size());
    for (std::size_t p = 0; p < log.pixels.size(); ++p) {
        const PixelReference& reference = model.references[p];
        if (!reference.explanation) continue;
        for (std::size_t r = 0; r < log.pixels[p].rays.size(); ++r) {
            const LoggedRay& ray = log.pixels[p].rays[r];
            if (!ray.shape || reference.ray[r] < 0) continue;
            const ExplainedRay& explained =
                reference.explanation->rays[static_cast<std::size_t>(reference.ray[r])];
            if (!explained.hit) continue;
            const std::uint32_t shape = explained.hit->shape;
            ++likely[*ray.shape][shape];
            const auto point = ray.vector(Quantity::point), t = ray.vector(Quantity::t);
            const double size = length(ApproxVec(explained.direction)).v;
            // P may be wrong where t is right.
            const bool agrees = (point && length(*point - ApproxVec(explained.hit->point)).v <
                                              1e-3 * (1 + length(*point).v)) ||
                                (t && (agree(t->x, explained.t, 1e-3 * explained.t) ||
                                       agree(t->x, explained.t * size, 1e-3 * explained.t * size)));
            if (agrees) ++sure[*ray.shape][shape];
        }
    }
    std::vector<std::uint32_t>& of = model.rules.shape_of;
    of.assign(log.shape_labels.size(), k_none);
    const auto most = [](const std::map<std::uint32_t, int>& votes) {
        int all = 0;
        std::pair<std::uint32_t, int> best{k_none, 0};
        for (const auto& [shape, count] : votes) {
            all += count;
            if (count > best.second) best = {shape, count};
        }
        return 2 * best.second > all ? best.first : k_none;
    };
    const auto names = indices_by_name(model.scene.shape_texts);
    std::map<std::int64_t, int> offsets;
    for (std::size_t l = 0; l < of.size(); ++l) {
        if (const auto named = names.find(log.shape_labels[l].text); named != names.end())
            of[l] = named->second;
        if (of[l] == k_none) of[l] = most(sure[l]);
        if (of[l] != k_none && log.shape_labels[l].number) ++offsets[*log.shape_labels[l].number - of[l]];
    }
    std::pair<std::int64_t, int> offset{0, 0};
    for (const auto& one : offsets)
        if (one.second > offset.second) offset = one;
    // Without any place that agrees, numbers are those of the scene, from 0 or 1.
    if (offsets.empty()) {
        for (const std::int64_t first : {0, 1}) {
            int fitting = 0;
            for (std::size_t l = 0; l < of.size(); ++l) {
                const std::optional<std::int64_t> number = log.shape_labels[l].number;
                if (!number || *number < first) continue;
                const auto at = likely[l].find(static_cast<std::uint32_t>(*number - first));
                if (at != likely[l].end()) fitting += at->second;
            }
            if (fitting > offset.second) offset = {first, fitting};
        }
    }
    // Numbers are in the scene's order unless those that are known say otherwise: what glint hits at the same
    // places shows nothing if the log's hits are wrong.
    bool is_in_order = offsets.size() == 1 && (offset.first == 0 || offset.first == 1);
    if (const auto first = first_number(log.shape_labels, model.scene.shapes.size());
        offset.second == 0 && first) {
        offset.first = *first;
        is_in_order = true;
    }
    for (std::size_t l = 0; l < of.size(); ++l) {
        if (of[l] != k_none) continue;
        const std::optional<std::int64_t> number = log.shape_labels[l].number;
        if (number && (is_in_order || offset.second > 1) && *number >= offset.first &&
            *number - offset.first < static_cast<std::int64_t>(model.scene.shapes.size())) {
            of[l] = static_cast<std::uint32_t>(*number - offset.first);
        } else if (sure[l].empty()) {
            of[l] = most(likely[l]);
        }
    }
}

void infer_lights(LogModel& model) {
    const TraceLog& log = model.log;
    if (log.light_labels.size() > 1000) return;
    std::vector<std::vector<int>> votes(log.light_labels.size(),
                                        std::vector<int>(model.scene.lights.size(), 0));
    for (std::size_t p = 0; p < std::min(log.pixels.size(), k_most_places); ++p)
        for (std::size_t r = 0; r < log.pixels[p].rays.size() && model.references[p].explanation; ++r)
            add_light_votes(model, p, r, votes);
    std::vector<std::uint32_t> directed;  // without ambient lights
    for (std::uint32_t i = 0; i < model.scene.lights.size(); ++i)
        if (!model.scene.lights[i].is_ambient()) directed.push_back(i);
    // The ways of counting: all lights or those with a direction, from 0 or 1.
    std::vector<std::uint32_t> best(log.light_labels.size(), k_none);
    int best_score = -1;
    for (int way = 0; way < 4; ++way) {
        std::vector<std::uint32_t> of(log.light_labels.size(), k_none);
        int sum = 0;
        bool is_possible = true;
        for (std::size_t l = 0; l < of.size(); ++l) {
            if (!log.light_labels[l].number) continue;
            const std::int64_t number = *log.light_labels[l].number - way % 2;
            const auto count =
                static_cast<std::int64_t>(way < 2 ? directed.size() : model.scene.lights.size());
            if (number < 0 || number >= count) {
                is_possible = false;
                continue;
            }
            of[l] = way < 2 ? directed[static_cast<std::size_t>(number)] : static_cast<std::uint32_t>(number);
            if (model.scene.lights[of[l]].is_ambient()) of[l] = k_none;
            if (of[l] != k_none) sum += votes[l][of[l]];
        }
        if (is_possible) ++sum;
        if (sum > best_score) best_score = sum, best = of;
    }
    const auto names = indices_by_name(model.scene.light_texts);
    for (std::size_t l = 0; l < best.size(); ++l) {
        if (const auto named = names.find(log.light_labels[l].text); named != names.end())
            best[l] = named->second;
        const auto most = std::max_element(votes[l].begin(), votes[l].end());
        if (most == votes[l].end() || *most == 0) continue;
        // Another light fits clearly better than the number.
        const int own = best[l] != k_none ? votes[l][best[l]] : 0;
        if (*most > 2 * own) best[l] = static_cast<std::uint32_t>(most - votes[l].begin());
    }
    model.rules.light_of = best;
}

}  // namespace glint
