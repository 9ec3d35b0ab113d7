// SPDX-License-Identifier: Apache-2.0
#include "diagnose/log_keys.h"

#include <unordered_map>
#include <vector>

#include "base/text.h"

namespace glint {

std::span<const LogKey> log_keys() {
    using enum Quantity;
    static constexpr LogKey keys[] = {
        {"size", KeyUse::size},
        {"rows", KeyUse::rows},
        {"colors", KeyUse::colors},
        {"pixel", KeyUse::pixel},
        {"ray", KeyUse::ray},
        {"light", KeyUse::light},
        {"miss", KeyUse::miss},
        {"shape", KeyUse::shape},
        {"object", KeyUse::shape},
        {"end", KeyUse::end},
        {"visible", KeyUse::visible},
        {"lit", KeyUse::visible},
        {"color", KeyUse::color},
        {"diffuse", KeyUse::diffuse},
        {"specular", KeyUse::specular},
        {"origin", KeyUse::none, origin},
        {"o", KeyUse::none, origin},
        {"direction", KeyUse::none, direction},
        {"dir", KeyUse::none, direction},
        {"d", KeyUse::none, direction},
        {"t", KeyUse::none, t},
        {"p", KeyUse::none, point},
        {"point", KeyUse::none, point},
        {"intersection", KeyUse::none, point},
        {"n", KeyUse::none, normal},
        {"normal", KeyUse::none, normal},
        {"v", KeyUse::none, view},
        {"view", KeyUse::none, view},
        {"inside", KeyUse::none, inside},
        {"l", KeyUse::none, to_light},
        {"tolight", KeyUse::none, to_light},
        {"distance", KeyUse::none, distance},
        {"dist", KeyUse::none, distance},
        {"attenuation", KeyUse::none, attenuation},
        {"att", KeyUse::none, attenuation},
        {"spot", KeyUse::none, spot},
        {"nl", KeyUse::none, n_l},
        {"ndotl", KeyUse::none, n_l},
        {"r", KeyUse::none, reflected},
        {"h", KeyUse::none, half},
        {"half", KeyUse::none, half},
        {"rv", KeyUse::none, r_v},
        {"rdotv", KeyUse::none, r_v},
        {"nh", KeyUse::none, n_h},
        {"ndoth", KeyUse::none, n_h},
        {"power", KeyUse::none, power},
        {"blocked", KeyUse::none, blocked},
        {"shadowed", KeyUse::none, blocked},
        {"ambient", KeyUse::none, ambient},
        {"emission", KeyUse::none, emission},
        {"local", KeyUse::none, local},
        {"weight", KeyUse::none, weight},
        {"pixelcolor", KeyUse::none, pixel_color},
        {"clamped", KeyUse::none, clamped},
        {"bytes", KeyUse::none, bytes},
        {"rgb", KeyUse::none, bytes},
    };
    return keys;
}

const LogKey* find_key(std::string_view name) {
    static const auto by_name = [] {
        std::unordered_map<std::string_view, const LogKey*> map;
        for (const LogKey& key : log_keys()) map.emplace(key.name, &key);
        return map;
    }();
    const auto at = by_name.find(name);
    return at != by_name.end() ? at->second : nullptr;
}

std::string_view nearest_key(std::string_view name) {
    std::vector<std::string_view> names;
    for (const LogKey& key : log_keys())
        if (key.name.size() > 2) names.push_back(key.name);
    return nearest_word(name, names);
}

}  // namespace glint
