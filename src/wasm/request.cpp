// SPDX-License-Identifier: Apache-2.0
#include "wasm/request.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "formats/load_validated.h"
#include "formats/povray/standard_includes.h"
#include "formats/profile_file.h"

namespace glint::wasm {
namespace {

using nlohmann::json;

/// The member `name` of an object, or null.
const json& member(const json& object, const char* name) {
    static const json null;
    if (!object.is_object()) return null;
    const auto at = object.find(name);
    return at != object.end() ? *at : null;
}

std::string string_member(const json& object, const char* name) {
    const json& value = member(object, name);
    return value.is_string() ? value.get<std::string>() : std::string();
}

/// A setting's value as the text that set_setting() takes.
std::string text_of(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::vector<OwnedText> owned_texts(const json& list) {
    std::vector<OwnedText> owned;
    if (!list.is_array()) return owned;
    for (const json& text : list)
        owned.push_back(
            {string_member(text, "name"), string_member(text, "text"), string_member(text, "format")});
    return owned;
}

std::vector<SceneText> views(const std::vector<OwnedText>& owned) {
    std::vector<SceneText> texts;
    for (const OwnedText& text : owned) texts.push_back({text.name, text.text, text.format});
    return texts;
}

/// The request's "includes".
class Includes : public Sources {
  public:
    explicit Includes(const std::vector<OwnedText>& texts) {
        for (const OwnedText& text : texts) texts_[text.name] = text.text;
    }
    Result<std::string> read(std::string_view name, std::string_view from) override {
        const std::string folder(from.substr(0, from.rfind('/') + 1));
        const auto at = texts_.find(folder + std::string(name));
        if (at != texts_.end()) return std::string(at->second);
        const bool is_own =
            name.starts_with(povray::k_system_folder) || !povray::standard_include(name).text.empty();
        if (!is_own && std::find(missing.begin(), missing.end(), folder + std::string(name)) == missing.end())
            missing.push_back(folder + std::string(name));
        return Status{ErrorCode::io, {}, {}};  // the reader has the words for it
    }

    std::vector<std::string> missing;

  private:
    std::map<std::string, std::string_view> texts_;
};

/// Three numbers, or nothing.
std::optional<Vec3> vec3_member(const json& object, const char* name) {
    const json& value = member(object, name);
    if (!value.is_array() || value.size() != 3) return std::nullopt;
    for (const json& number : value) {
        if (!number.is_number()) return std::nullopt;
    }
    return Vec3{value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

}  // namespace

std::vector<SceneText> RequestTexts::read_by(const Scene& scene) const {
    std::vector<SceneText> list = views(texts);
    for (const SceneText& text : views(includes)) {
        if (std::find(scene.files.begin(), scene.files.end(), text.name) != scene.files.end())
            list.push_back(text);
    }
    return list;
}

RequestTexts read_texts(const json& request) {
    return {owned_texts(member(request, "texts")), owned_texts(member(request, "includes"))};
}

Result<ValidatedScene> load(const RequestTexts& texts, const json& request,
                            std::vector<std::string>& missing) {
    LoadOptions options;
    options.profile = string_member(request, "profile");
    options.scene_name = string_member(request, "scene");
    if (const json& most = member(request, "maxMemory"); most.is_number() && most.get<double>() >= 1)
        options.max_memory = static_cast<std::uint64_t>(std::min(most.get<double>(), 1e15));
    const json& skips = member(request, "skipUnsupported");
    options.skip_unsupported = skips.is_boolean() && skips.get<bool>();
    const json& settings = member(request, "settings");
    if (settings.is_object()) {
        for (const auto& [key, value] : settings.items()) options.settings.emplace_back(key, text_of(value));
    }
    Includes includes(texts.includes);
    Result<ValidatedScene> loaded = load_validated(views(texts.texts), options, &includes);
    missing = loaded.code == ErrorCode::io ? std::move(includes.missing) : std::vector<std::string>();
    return loaded;
}

std::string apply(const json& request, Scene& scene) {
    if (!request.is_object()) return "the request is not a JSON object";
    const json& settings = member(request, "settings");
    if (settings.is_object()) {
        for (const auto& [key, value] : settings.items()) {
            std::string wrong =
                set_named_setting(scene, key, text_of(value), {SettingOrigin::Kind::command, {}});
            if (!wrong.empty()) return wrong;
        }
    }
    const json& camera = member(request, "camera");
    if (camera.is_null()) return {};
    const auto position = vec3_member(camera, "position"), right = vec3_member(camera, "right"),
               up = vec3_member(camera, "up"), forward = vec3_member(camera, "forward");
    if (!position || !right || !up || !forward)
        return "camera: expected position, right, up and forward of three numbers each";
    scene.camera = {};
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = *position;
    scene.camera.frame = CameraFrame{*right, *up, *forward};
    return {};
}

}  // namespace glint::wasm
