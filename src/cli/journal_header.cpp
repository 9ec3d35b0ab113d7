// SPDX-License-Identifier: Apache-2.0
#include "cli/journal_header.h"

#include "cli/text.h"
#include "journal/hash.h"

namespace glint::cli {

JournalHeader journal_header(const SceneArguments& arguments, const LoadedScene& loaded, const Crop& picture,
                             const std::vector<Layer>& layers) {
    JournalHeader header;
    header.picture_version = k_picture_version;
    header.picture = picture;
    header.layers = layers;
    std::string formats;
    for (const SceneText& text : loaded.texts) {
        header.files.emplace_back(text.name, hash_of(text.text));
        formats += formats.empty() ? "" : ",";
        formats += text.format.empty() ? extension(text.name) : text.format;
    }
    header.files.insert(header.files.end(), loaded.included.begin(), loaded.included.end());
    header.settings.emplace_back("format", formats);
    header.settings.emplace_back("scene", arguments.scene_name);
    const auto keys = setting_keys();
    for (std::size_t i = 0; i < keys.size(); ++i)
        header.settings.emplace_back(keys[i].name, get_setting(*loaded.scene, i));
    return header;
}

}  // namespace glint::cli
