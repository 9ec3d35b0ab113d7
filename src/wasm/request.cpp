// SPDX-License-Identifier: Apache-2.0
#include "wasm/request.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "formats/load_validated.h"
#include "formats/mesh_file.h"
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

/// The bytes of a file that is no text; other characters than those of base64 are skipped.
std::string bytes_of_base64(std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::int8_t, 256> value;
    value.fill(-1);
    for (std::size_t i = 0; i < digits.size(); ++i)
        value[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t held = 0;
    int bits = 0;
    for (const char c : text) {
        const int digit = value[static_cast<unsigned char>(c)];
        if (digit < 0) continue;
        held = held << 6 | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(held >> bits & 255);
    }
    return bytes;
}

OwnedText owned_text(const json& text) {
    const json& base64 = member(text, "base64");
    return {string_member(text, "name"),
            base64.is_string() ? bytes_of_base64(base64.get_ref<const std::string&>())
                               : string_member(text, "text"),
            string_member(text, "format")};
}

std::vector<OwnedText> owned_texts(const json& list) {
    std::vector<OwnedText> owned;
    if (!list.is_array()) return owned;
    for (const json& text : list) owned.push_back(owned_text(text));
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

std::vector<std::string> mesh_files(const Scene& scene) {
    std::vector<std::string> names = mesh_file_names(scene);
    const std::string_view main = scene.files.empty() ? std::string_view() : scene.files.front();
    const std::string_view folder = main.substr(0, main.rfind('/') + 1);
    for (std::string& name : names) {
        if (name.starts_with(folder)) name.erase(0, folder.size());
    }
    return names;
}

Result<ValidatedScene> load(const RequestTexts& texts, const json& request, std::vector<std::string>& missing,
                            Function<void(double)> progress) {
    LoadOptions options;
    options.progress = std::move(progress);
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
