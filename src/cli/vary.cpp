// SPDX-License-Identifier: Apache-2.0
#include "cli/vary.h"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "cli/compare_report.h"
#include "cli/failure.h"
#include "cli/print_text.h"
#include "cli/progress.h"
#include "cli/render_or_fail.h"
#include "cli/text.h"
#include "image/quantize.h"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int k_max_values = 1001;

struct Step {
    std::string value;
    PictureDifference from_before;  ///< empty for the first value
    std::uint64_t changed() const { return from_before.all.pixels - from_before.all.equal; }
};

std::string_view key_name(const Variation& v) { return setting_keys()[v.key].name; }

std::optional<int> parsed_whole_number(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

[[noreturn]] void fail(const std::string& text, const std::string& why) {
    throw Failure(k_usage, fmt::format("--vary {}: {}", text, why));
}

std::vector<std::string> parse_values(const std::string& whole, std::string_view text) {
    std::vector<std::string> values;
    if (const std::size_t dots = text.find(".."); dots != std::string_view::npos) {
        const auto first = parsed_whole_number(text.substr(0, dots)),
                   last = parsed_whole_number(text.substr(dots + 2));
        if (!first || !last || *first > *last) fail(whole, "expected A..B, two whole numbers, A below B");
        if (*last - *first >= k_max_values) fail(whole, fmt::format("more than {} values", k_max_values));
        for (int i = *first; i <= *last; ++i) values.push_back(std::to_string(i));
        return values;
    }
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        values.emplace_back(text.substr(start, end - start));
        start = end + 1;
    }
    return values;
}

// The first value after which no step changes the picture; nothing if the last step changed it.
const Step* settled(const std::vector<Step>& steps) {
    const Step* found = nullptr;
    for (std::size_t i = steps.size(); i > 1 && steps[i - 1].changed() == 0; --i) found = &steps[i - 2];
    return found;
}

std::string text_of(const std::vector<Step>& steps, const Variation& v) {
    std::string text =
        fmt::format("{:<20} {:>24} {:>10} {:>10}\n", key_name(v), "pixels changed", "mean", "largest");
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const PictureDifference& d = steps[i].from_before;
        text += fmt::format("{:<20}", steps[i].value);
        if (i > 0) {
            text += fmt::format(" {:>24} {:>10.4g} {:>10.4g}",
                                fmt::format("{} ({})", with_commas(steps[i].changed()),
                                            percent_text(steps[i].changed(), d.all.pixels)),
                                d.mean, d.largest.value);
        }
        text += "\n";
    }
    const Step* still = settled(steps);
    if (still != nullptr) return text + fmt::format("no change from {} = {} on\n", key_name(v), still->value);
    return text + fmt::format("{} = {} still changes the picture\n", key_name(v), steps.back().value);
}

std::string json_of(const std::vector<Step>& steps, const Variation& v) {
    Json json = {{"key", key_name(v)}, {"steps", Json::array()}};
    for (std::size_t i = 0; i < steps.size(); ++i) {
        Json step = {{"value", steps[i].value}};
        if (i > 0) {
            step["pixels"] = steps[i].from_before.all.pixels;
            step["changed"] = steps[i].changed();
            step["mean"] = steps[i].from_before.mean;
            step["largest"] = steps[i].from_before.largest.value;
        }
        json["steps"].push_back(std::move(step));
    }
    const Step* still = settled(steps);
    json["settled_from"] = still != nullptr ? Json(still->value) : Json(nullptr);
    return json.dump(2) + "\n";
}

}  // namespace

Variation parse_variation(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) fail(text, "expected KEY=A..B or KEY=VALUE,VALUE");
    const auto key = find_setting(text.substr(0, equals));
    if (!key) {
        fail(text, fmt::format("there is no {}{}", glint::quoted(text.substr(0, equals)),
                               suggestion(text.substr(0, equals), setting_names())));
    }
    if (setting_keys()[*key].name == "size") fail(text, "pictures of different sizes cannot be compared");
    Variation variation{*key, parse_values(text, std::string_view(text).substr(equals + 1))};
    if (variation.values.size() < 2) fail(text, "expected two values or more");
    Scene scratch;
    for (const std::string& value : variation.values) {
        const std::string wrong =
            set_setting(scratch, *key, value, {SettingOrigin::Kind::command, {}}).message;
        if (!wrong.empty()) fail(text, wrong);
    }
    return variation;
}

int vary_command(SceneOption& scene, const Variation& variation, int threads, bool json, bool quiet) {
    Scene varied = std::move(load_scene_option(scene, quiet)->scene).release();
    const World prepared = prepare_or_fail(varied, threads);
    std::vector<Step> steps;
    Image before;
    {
        ProgressBar bar(!quiet);
        for (const std::string& value : variation.values) {
            set_setting(varied, variation.key, value, {SettingOrigin::Kind::command, {}});
            Result<World> changed = with_rules(prepared, varied.conventions, varied.settings);
            // Other changes, and invalid values, need prepare(), which reports errors.
            const World world = changed ? *std::move(changed) : prepare_or_fail(varied, threads);
            Image now = as_written(render_or_fail(world, threads), varied.conventions.byte_rule());
            steps.push_back({value, {}});
            if (!before.rgb.empty()) {
                CompareOptions options;
                options.threads = threads;
                const Result<PictureDifference> compared = compare(now, before, options);
                if (!compared) throw_failure(compared);
                steps.back().from_before = *compared;
            }
            before = std::move(now);
            bar.update(static_cast<double>(steps.size()) / static_cast<double>(variation.values.size()));
        }
    }
    json ? print_json(json_of(steps, variation)) : print_text(text_of(steps, variation));
    return k_done;
}

}  // namespace glint::cli
