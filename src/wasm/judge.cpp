// SPDX-License-Identifier: Apache-2.0
#include "wasm/judge.h"

#include "glint/diagnose.h"
#include "image/quantize.h"
#include "wasm/describe.h"

namespace glint::wasm {
namespace {

using Json = nlohmann::ordered_json;

Json cause_json(const Cause& cause) {
    return {{"name", cause.name},
            {"explanation", cause.explanation},
            {"explained", cause.explained},
            {"perhaps", cause.perhaps}};
}

Json causes_json(const std::vector<Cause>& causes) {
    Json list = Json::array();
    for (const Cause& cause : causes) list.push_back(cause_json(cause));
    return list;
}

// Of a picture and the one that is wanted. faults: the scene of the latter, if causes are wanted.
Json compared(const Image& picture, const Image& wanted, const Scene* faults) {
    const Result<PictureDifference> difference = compare(picture, wanted, {.threads = 1});
    if (!difference) return {{"error", difference.message}};
    const PixelCounts& all = difference->all;
    Json json = {
        {"pixels", all.pixels},
        {"equal", all.equal},
        {"within_1", all.within_1},
        {"within", all.within},
        {"mean", difference->mean},
        {"rms", difference->rms},
        {"psnr", difference->psnr ? Json(*difference->psnr) : Json()},
        {"ssim", difference->ssim ? Json(*difference->ssim) : Json()},
        {"largest",
         {{"value", difference->largest.value}, {"x", difference->largest.x}, {"y", difference->largest.y}}}};
    if (faults == nullptr) return json;
    const Result<CauseReport> report = find_causes(picture, wanted, faults, {.threads = 1});
    if (!report) return {{"error", report.message}};
    json["agrees"] = report->agrees;
    json["remark"] = report->remark;
    json["causes"] = causes_json(report->causes);
    json["then"] = causes_json(report->then);
    json["where"] = report->where;
    return json;
}

}  // namespace

Json comparison(const World& world, const World& reference, const Scene* faults) {
    const Result<Rendering> a = render(world, {.threads = 1}), b = render(reference, {.threads = 1});
    if (!a || !b) return {{"error", a ? b.message : a.message}};
    return compared(as_written(a->image, a->rule), as_written(b->image, b->rule), faults);
}

Json comparison(const GivenPicture& picture, const World& world, const Scene* faults) {
    const Result<Rendering> wanted = render(world, {.threads = 1});
    if (!wanted) return {{"error", wanted.message}};
    Image given = wanted->image;
    for (std::size_t i = 0; i < given.rgb.size(); ++i) {
        const auto byte = static_cast<std::uint8_t>(picture.rgba[i / 3 * 4 + i % 3]);
        given.rgb[i] = static_cast<float>(byte) / 255.0F;
    }
    return compared(given, as_written(wanted->image, wanted->rule), faults);
}

Json findings(const Scene& scene, const std::vector<SceneText>& texts) {
    Json list = Json::array();
    const Result<std::vector<Finding>> found = check(scene, {.threads = 1, .texts = texts});
    if (!found) return list;
    for (const Finding& finding : *found) {
        Json json = to_json(finding.diagnostic);
        json["id"] = finding.id;
        json["remedy"] = finding.remedy;
        json["note"] = finding.diagnostic.severity == Severity::note;
        list.push_back(std::move(json));
    }
    return list;
}

std::string diagnosis(const Scene& scene, const World& world, std::string_view log, std::string name) {
    const Result<Diagnosis> found = diagnose(scene, world, log, {.name = std::move(name), .threads = 1});
    Json rest = {{"diagnostics", Json::array()}};
    for (const Diagnostic& one : found.diagnostics) rest["diagnostics"].push_back(to_json(one));
    const Result<std::string> text =
        found ? diagnosis_json(*found, scene) : Result<std::string>(Status(found));
    if (!text) rest["error"] = text.message;
    return "{\"diagnosis\": " + (text ? *text : "null") + ", " +
           rest.dump(-1, ' ', false, Json::error_handler_t::replace).substr(1);
}

}  // namespace glint::wasm
