#include "wasm/door.h"

// The browser has no file system for the JSON library to know.
#define JSON_HAS_FILESYSTEM 0
#define JSON_HAS_EXPERIMENTAL_FILESYSTEM 0
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/glint.h"

using nlohmann::json;

struct GlintScene {
    glint::WorldPtr world;
    glint::Image image;
    json report;
    std::string report_text;

    void write_report() { report_text = report.dump(-1, ' ', false, json::error_handler_t::replace); }
};

namespace {

/// The string member `name` of an object, or an empty string.
std::string string_member(const json& object, const char* name) {
    if (!object.is_object()) return {};
    const auto member = object.find(name);
    return member != object.end() && member->is_string() ? member->get<std::string>() : std::string();
}

json to_json(const glint::Diagnostic& d) {
    return {{"severity", d.severity == glint::Severity::error ? "error" : "warning"},
            {"file", d.file},
            {"line", d.line},
            {"column", d.column},
            {"length", d.length},
            {"message", d.message},
            {"text", glint::to_string(d)}};
}

void add_diagnostics(json& report, const std::vector<glint::Diagnostic>& diagnostics) {
    for (const glint::Diagnostic& d : diagnostics) report["diagnostics"].push_back(to_json(d));
}

/// The request's "includes".
class Includes : public glint::Sources {
  public:
    explicit Includes(const json& request) {
        const auto list = request.is_object() ? request.find("includes") : request.end();
        if (list != request.end() && list->is_array()) {
            for (const json& text : *list) texts_[string_member(text, "name")] = string_member(text, "text");
        }
    }
    std::optional<std::string> read(std::string_view name, std::string_view from, std::string& why) override {
        const std::string folder(from.substr(0, from.rfind('/') + 1));
        const auto at = texts_.find(folder + std::string(name));
        if (at != texts_.end()) return at->second;
        why = "no such text is among the request's includes";
        return std::nullopt;
    }

  private:
    std::map<std::string, std::string> texts_;
};

glint::LoadResult load(const json& request) {
    std::vector<std::string> owned;
    std::vector<glint::SceneText> texts;
    const auto list = request.is_object() ? request.find("texts") : request.end();
    if (list != request.end() && list->is_array()) {
        owned.reserve(list->size());  // the views below point into it
        for (const json& text : *list) {
            owned.push_back(string_member(text, "text"));
            texts.push_back({string_member(text, "name"), owned.back(), string_member(text, "format")});
        }
    }
    glint::LoadOptions options;
    options.profile = string_member(request, "profile");
    options.scene_name = string_member(request, "scene");
    const auto settings = request.is_object() ? request.find("settings") : request.end();
    if (settings != request.end() && settings->is_object()) {
        for (const auto& [key, value] : settings->items()) {
            options.settings.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
        }
    }
    Includes includes(request);
    return glint::load(texts, options, &includes);
}

}  // namespace

char* glint_allocate(std::uint32_t bytes) { return static_cast<char*>(std::malloc(bytes)); }

void glint_free(char* memory) { std::free(memory); }

GlintScene* glint_open(const char* request, std::uint32_t length) {
    auto* const scene = new GlintScene;
    scene->report = {{"ready", false}, {"diagnostics", json::array()}};
    const json parsed = json::parse(request, request + length, nullptr, false);
    if (parsed.is_discarded()) {
        scene->report["error"] = "the request is not JSON";
        scene->write_report();
        return scene;
    }
    glint::LoadResult loaded = load(parsed);
    add_diagnostics(scene->report, loaded.diagnostics);
    if (loaded.scene) {
        const glint::RenderSettings& settings = loaded.scene->settings;
        scene->report["width"] = settings.width;
        scene->report["height"] = settings.height;
        // What prepare() says, load() has said: it validates too.
        scene->world = glint::prepare(*loaded.scene, 1).world;
        scene->report["ready"] = scene->world != nullptr;
    }
    scene->write_report();
    return scene;
}

void glint_close(GlintScene* scene) { delete scene; }

const char* glint_report(const GlintScene* scene) { return scene->report_text.c_str(); }

const float* glint_render(GlintScene* scene, std::int32_t x, std::int32_t y, std::int32_t width,
                          std::int32_t height) {
    if (!scene->world) return nullptr;
    glint::RenderOptions options;
    options.threads = 1;
    options.crop = glint::Crop{width, height, x, y};
    glint::RenderResult result = glint::render(*scene->world, options);
    if (!result.image) {
        scene->report["error"] = result.error;
        scene->write_report();
        return nullptr;
    }
    scene->image = std::move(*result.image);
    return scene->image.rgb.data();
}

const char* glint_version() { return GLINT_VERSION; }
