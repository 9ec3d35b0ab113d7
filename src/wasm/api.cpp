// SPDX-License-Identifier: Apache-2.0
#include "wasm/api.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/quantize.h"
#include "wasm/describe.h"
#include "wasm/judge.h"
#include "wasm/request.h"
#include "world/prepare.h"

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

/// Of one call: 0.8 GB as floats. More does not fit into 32-bit addresses.
constexpr std::int64_t k_max_pixels = std::int64_t{1} << 26;

std::string too_many_pixels(std::int32_t width, std::int32_t height) {
    return std::to_string(width) + "x" + std::to_string(height) +
           " pixels are too many at once: expected up to " + std::to_string(k_max_pixels);
}

}  // namespace

struct GlintScene {
    glint::wasm::RequestTexts texts;
    std::optional<glint::Scene> scene;  // as it is rendered: as opened, with the changes of glint_prepare
    glint::wasm::Changeable opened;     // what glint_prepare can change, as opened
    std::optional<glint::World> world;
    glint::Image image;
    std::vector<glint::LayerImage> layers;
    std::vector<float> alpha;  // of the image, if it is not opaque
    glint::RayCounts rays;
    std::vector<std::uint8_t> pixels;
    ordered_json report;
    std::string report_text, answer;

    /// Writes the report of a request, with the reason if it failed.
    void write_report(const std::string& why = {}) {
        report.erase("error");
        if (!why.empty()) report["error"] = why;
        if (scene) {
            report["width"] = scene->settings.width;
            report["height"] = scene->settings.height;
        }
        report_text = to_text(report);
    }
    /// Renders a rectangle; false if that is impossible, and the report says why.
    bool render(const glint::Crop& crop, std::vector<glint::Layer> wanted) {
        if (!world) return false;
        layers.clear();
        alpha.clear();
        const auto images = static_cast<std::int64_t>(wanted.size()) + 1;
        if (std::int64_t{crop.width} * crop.height > k_max_pixels / images) {
            write_report(too_many_pixels(crop.width, crop.height));
            return false;
        }
        glint::RenderOptions options;
        options.threads = 1;
        options.crop = crop;
        options.layers = std::move(wanted);
        const bool has_alpha = scene->settings.alpha;
        // Perhaps it is asked for.
        const auto alpha_at = static_cast<std::size_t>(
            std::find(options.layers.begin(), options.layers.end(), glint::Layer::alpha) -
            options.layers.begin());
        const bool is_extra = has_alpha && alpha_at == options.layers.size();
        if (is_extra) options.layers.push_back(glint::Layer::alpha);
        glint::Result<glint::Rendering> result = glint::render(*world, options);
        if (!result || report.contains("error")) write_report(result.message);
        image = result ? std::move(result->image) : glint::Image{};
        if (!result) return false;
        layers = std::move(result->layers);
        if (has_alpha) alpha = layers[alpha_at].values;
        if (is_extra) layers.pop_back();
        rays = result->rays;
        return true;
    }
    /// Why the picture cannot be compared; empty if it can.
    std::string compare_fault() const {
        if (!scene || !world) return "the scene has errors";
        const std::int32_t width = scene->settings.width, height = scene->settings.height;
        return std::int64_t{width} * height <= k_max_pixels ? "" : too_many_pixels(width, height);
    }
    static std::string to_text(const ordered_json& value) {
        return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    }
};

char* glint_allocate(std::uint32_t bytes) { return static_cast<char*>(std::malloc(bytes)); }

void glint_free(char* memory) { std::free(memory); }

GlintScene* glint_open(const char* request, std::uint32_t length) {
    auto* const scene = new GlintScene;
    scene->report = {{"ready", false}, {"diagnostics", json::array()}};
    const json parsed = json::parse(request, request + length, nullptr, false);
    if (parsed.is_discarded()) {
        scene->write_report("the request is not JSON");
        return scene;
    }
    scene->texts = glint::wasm::read_texts(parsed);
    std::vector<std::string> missing;
    // Reading a large text and building its hierarchy take about the same time.
    glint::Result<glint::ValidatedScene> loaded =
        glint::wasm::load(scene->texts, parsed, missing, [](double done) { glint_progress(0.5 * done); });
    if (!missing.empty()) scene->report["missing"] = missing;
    for (const glint::Diagnostic& d : loaded.diagnostics)
        scene->report["diagnostics"].push_back(glint::wasm::to_json(d));
    if (loaded) {
        glint::PrepareOptions options;
        options.threads = 1;
        options.progress = [](double done) { glint_progress(0.5 + 0.5 * done); };
        // What prepare() says, load() has said: it validates too.
        if (glint::Result<glint::World> prepared = glint::prepare(*loaded, options))
            scene->world = *std::move(prepared);
        scene->scene = std::move(*loaded).release();
        scene->opened = glint::wasm::Changeable(*scene->scene);
        scene->report["width"] = scene->scene->settings.width;  // its place among the keys
        scene->report["height"] = scene->scene->settings.height;
        scene->report["ready"] = scene->world.has_value();
    }
    scene->write_report();
    return scene;
}

void glint_close(GlintScene* scene) { delete scene; }

std::int32_t glint_prepare(GlintScene* scene, const char* request, std::uint32_t length) {
    if (!scene->scene) return 0;
    const glint::wasm::Changeable before(*scene->scene);
    scene->opened.restore(*scene->scene);
    std::string wrong =
        glint::wasm::apply(json::parse(request, request + length, nullptr, false), *scene->scene);
    if (wrong.empty()) {
        glint::Result<glint::World> prepared;
        if (scene->world) prepared = glint::with_camera(*scene->world, scene->scene->camera);
        if (prepared)
            prepared = glint::with_rules(*prepared, scene->scene->conventions, scene->scene->settings);
        // What these cannot change, and what is wrong where, prepare() knows.
        if (!prepared) prepared = glint::prepare(*scene->scene, {.threads = 1});
        if (prepared) {
            scene->world = *std::move(prepared);
        } else {
            wrong = prepared.message;
        }
    }
    if (!wrong.empty()) before.restore(*scene->scene);
    scene->write_report(wrong);
    return wrong.empty() ? 1 : 0;
}

const char* glint_report(const GlintScene* scene) { return scene->report_text.c_str(); }

const char* glint_info(GlintScene* scene) {
    scene->answer =
        scene->world ? GlintScene::to_text(glint::wasm::describe(*scene->scene, *scene->world)) : "null";
    return scene->answer.c_str();
}

const float* glint_render(GlintScene* scene, std::int32_t x, std::int32_t y, std::int32_t width,
                          std::int32_t height) {
    return scene->render({width, height, x, y}, {}) ? scene->image.rgb.data() : nullptr;
}

std::int32_t glint_render_layers(GlintScene* scene, const char* names, std::uint32_t length, std::int32_t x,
                                 std::int32_t y, std::int32_t width, std::int32_t height) {
    std::vector<glint::Layer> wanted;
    for (std::string_view rest(names, length); !rest.empty();) {
        const std::string_view name = rest.substr(0, rest.find(' '));
        rest.remove_prefix(std::min(rest.size(), name.size() + 1));
        const std::optional<glint::Layer> layer =
            scene->scene ? glint::find_layer(name, *scene->scene) : glint::find_layer(name);
        if (!layer) {
            scene->layers.clear();
            scene->write_report("there is no layer '" + std::string(name) + "'");
            return 0;
        }
        wanted.push_back(*layer);
    }
    return scene->render({width, height, x, y}, std::move(wanted)) ? 1 : 0;
}

const float* glint_layer(const GlintScene* scene, std::uint32_t index) {
    return index < scene->layers.size() ? scene->layers[index].values.data() : nullptr;
}

std::int32_t glint_layer_channels(const GlintScene* scene, std::uint32_t index) {
    return index < scene->layers.size() ? scene->layers[index].channels : 0;
}

const std::uint8_t* glint_pixels(GlintScene* scene) {
    const std::vector<float>& rgb = scene->image.rgb;
    if (rgb.empty()) return nullptr;
    scene->pixels.resize(rgb.size() / 3 * 4);
    const glint::ByteRule rule = scene->scene->conventions.byte_rule();
    for (std::size_t from = 0, to = 0; from < rgb.size(); from += 3, to += 4) {
        // Straight alpha, as in PNG.
        const float alpha = scene->alpha.empty() ? 1 : scene->alpha[from / 3];
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = alpha == 1 ? rgb[from + c] : alpha > 0 ? rgb[from + c] / alpha : 0;
            glint::quantize_row(&value, 1, 8, rule, &scene->pixels[to + c]);
        }
        scene->pixels[to + 3] = static_cast<std::uint8_t>(glint::quantize(static_cast<double>(alpha), 255));
    }
    return scene->pixels.data();
}

double glint_rays(const GlintScene* scene) { return static_cast<double>(scene->rays.total()); }

const char* glint_explain(GlintScene* scene, std::int32_t x, std::int32_t y) {
    scene->answer = "null";
    if (!scene->world) return scene->answer.c_str();
    const auto explanation = glint::explain(*scene->scene, *scene->world, x, y);
    glint::EncodeOptions file;
    file.set_rule(scene->scene->conventions.byte_rule());
    const auto text = explanation ? glint::explanation_json(*explanation, *scene->scene, file)
                                  : glint::Result<std::string>(glint::Status(explanation));
    scene->answer =
        text ? *text
             : GlintScene::to_text(
                   {{"pixel", {x, y}}, {"samples", scene->scene->settings.samples}, {"error", text.message}});
    return scene->answer.c_str();
}

const char* glint_convert(GlintScene* scene) {
    scene->answer = "";
    if (scene->scene) {
        const std::vector<std::string> meshes = glint::wasm::mesh_files(*scene->scene);
        scene->answer =
            glint::write_glint(*scene->scene, scene->texts.read_by(*scene->scene), meshes).value_or({});
    }
    return scene->answer.c_str();
}

const char* glint_compare(GlintScene* scene, GlintScene* reference, std::int32_t with_causes) {
    std::string fault = scene->compare_fault();
    if (fault.empty()) fault = reference->compare_fault();
    const ordered_json answer =
        !fault.empty() ? ordered_json{{"error", fault}}
                       : glint::wasm::comparison(*scene->world, *reference->world,
                                                 with_causes != 0 ? &*reference->scene : nullptr);
    scene->answer = GlintScene::to_text(answer);
    return scene->answer.c_str();
}

const char* glint_compare_picture(GlintScene* scene, const char* rgba, std::int32_t width,
                                  std::int32_t height, std::int32_t with_causes) {
    std::string fault = scene->compare_fault();
    if (fault.empty()) {
        const glint::RenderSettings& s = scene->scene->settings;
        if (s.width != width || s.height != height)
            fault = fmt::format("the picture has {}x{} pixels, and the scene's has {}x{}", width, height,
                                s.width, s.height);
    }
    const ordered_json answer = !fault.empty()
                                    ? ordered_json{{"error", fault}}
                                    : glint::wasm::comparison({rgba, width, height}, *scene->world,
                                                              with_causes != 0 ? &*scene->scene : nullptr);
    scene->answer = GlintScene::to_text(answer);
    return scene->answer.c_str();
}

const char* glint_check(GlintScene* scene) {
    scene->answer =
        scene->scene
            ? GlintScene::to_text(glint::wasm::findings(*scene->scene, scene->texts.read_by(*scene->scene)))
            : "[]";
    return scene->answer.c_str();
}

const char* glint_diagnose(GlintScene* scene, const char* log, std::uint32_t length, const char* name,
                           std::uint32_t name_length) {
    scene->answer =
        scene->world
            ? glint::wasm::diagnosis(*scene->scene, *scene->world, {log, length}, {name, name_length})
            : GlintScene::to_text({{"diagnosis", {}}, {"error", "the scene has errors"}});
    return scene->answer.c_str();
}

const char* glint_version() { return GLINT_VERSION; }
