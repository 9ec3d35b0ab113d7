// SPDX-License-Identifier: Apache-2.0
#pragma once
// The state that the readers of one load() share: the scene so far, and what earlier texts have set.
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/memory_budget.h"
#include "formats/parser.h"
#include "glint/load.h"

namespace glint {

class GlintMaterials;
class GlintTextures;
struct TachyonState;

/// A text of the load.
struct ReadText {
    InputText place;
    std::uint16_t file = 0;  ///< index into Scene::files
    bool is_included = false;
};

/// The included texts. Their addresses and those of their names do not change during the load.
struct Includes {
    struct Text {
        std::string name, text;
    };
    std::deque<Text> texts;
    std::map<std::string, std::uint16_t, std::less<>> files;  ///< indices of texts, by name
    std::uint16_t root = 0;                                   ///< the caller's text that is being read
    std::vector<std::uint16_t> open;  ///< the included texts that are being read, outermost first
    std::uint32_t count = 0;          ///< the number of includes
    std::size_t repeated_bytes = 0;   ///< of texts included again
};

/// The memory that the load holds, of LoadOptions::max_memory.
class LoadMemory : public MemoryBudget {
  public:
    LoadMemory(const LoadOptions& options, std::uint64_t text_bytes);
    /// A text is read in addition.
    void add_text(std::uint64_t bytes);
    /// Counts what the scene holds now instead of what it held before.
    void count(const Scene& scene);
    /// Meshes of the scene do not change once they have been counted, but for this one.
    void set_growing(std::shared_ptr<const MeshData> mesh);
    /// "reading takes more than 64 MiB of memory ..."
    std::string message() const;

  private:
    bool is_default_;
    std::uint64_t text_bytes_, scene_bytes_ = 0;
    std::shared_ptr<const MeshData> growing_;
    std::uint64_t mesh_bytes_ = 0;  // of the scene's first meshes
    std::size_t counted_meshes_ = 0;
    bool is_growing_passed_ = false;  // it is one of these
};

/// Objects that LoadOptions::skip_unsupported leaves out, by their kind.
class LeftOut {
  public:
    /// One more of a kind: "a random landscape (`Scape`)". The first one's place is that of the warning.
    void add(std::string_view kind, InputText where, std::size_t offset, std::size_t length);
    /// A warning for each kind.
    void report(Diagnostics& diagnostics) const;

  private:
    struct Kind {
        std::string name;
        InputText where;
        std::size_t offset = 0, length = 0;
        std::uint32_t count = 0;
    };
    std::vector<Kind> kinds_;  // some tens: those of the format
};

struct LoadState {
    LoadState(const LoadOptions& load_options, Sources* text_sources, std::uint32_t max_errors,
              std::uint64_t text_bytes)
        : memory(load_options, text_bytes),
          options(load_options),
          sources(text_sources),
          diagnostics(max_errors) {}

    LoadMemory memory;  ///< the first member: the others count in it
    const LoadOptions& options;
    Sources* sources;              ///< null: includes are not possible
    std::vector<InputText> texts;  ///< by SourcePlace::file
    Includes includes;
    Scene scene;
    Diagnostics diagnostics;
    LeftOut left_out;
    // An ordered map, so that no choice of names makes lookups slow.
    CountedMap<std::string, std::uint32_t> materials;  ///< of all texts, by name
    std::shared_ptr<GlintMaterials> glint_materials;   ///< created by the first .glint text
    std::shared_ptr<GlintTextures> glint_textures;     ///< likewise
    std::shared_ptr<TachyonState> tachyon;             ///< created by the first .dat text
    std::map<std::uint16_t, std::uint32_t> meshes;     ///< in Scene::meshes, by the text's index in `texts`
    /// Of files of pictures, by the text's index in `texts`; null: it cannot be decoded.
    std::map<std::uint16_t, std::shared_ptr<const TextureImage>> texture_images;
    /// Those with the colors of one image, or white, and the opacity of another.
    std::map<std::pair<const TextureImage*, const TextureImage*>, std::shared_ptr<const TextureImage>>
        faded_images;
    std::optional<std::uint16_t> lone_mesh;  ///< the caller's text that is a file of a mesh
    double mesh_ambient_light = 1;           ///< what such a scene has if it has no lights
    bool is_view_used = false;               ///< LoadOptions::view
    bool camera_given = false, background_given = false;
    bool camera_included = false, background_included = false;  ///< set by an included text
    bool is_include_missing = false;                            ///< a text could not be read
    bool settings_given = false;                                ///< a text has set conventions explicitly
    bool own_ambient_light = false;           ///< the implicit ambient light of EPFL's scenes
    std::optional<ReadText> profile_text;     ///< the caller's profile file
    std::optional<Diagnostic> camera_wanted;  ///< the error to report if no text gives a camera

    /// Stores an included text, and returns its number.
    std::uint16_t add_text(const std::string& path, std::string text);
    /// Counts the scene's memory. Beyond the budget: an error at this place, and false. Readers call it, or
    /// Diagnostics::go_on(), before what they have added can be more than some MiB.
    bool is_within_memory(InputText where, std::size_t offset, std::size_t length = 1);
    /// Whether the budget has room for these bytes in addition, which are not counted. If not: an error at
    /// this place, and false.
    bool has_room(std::uint64_t bytes, InputText where, std::size_t offset, std::size_t length = 1);
    bool is_memory_reported = false;

  private:
    bool report_memory(InputText where, std::size_t offset, std::size_t length);
};

inline constexpr std::size_t k_max_texts =
    65534;  ///< of a load: SourcePlace::file, and one more for a profile

inline SourcePlace source_place(const ReadText& text, const Token& token) {
    return {token.line, static_cast<std::uint16_t>(token.column < 65535 ? token.column : 65535), text.file};
}

/// What a name in ItemTexts takes beside its characters, which a table of names may hold, too.
inline constexpr std::uint64_t k_name_bytes = 112;

/// Stores the place of item `index`, and its name if it has one.
inline void note(ItemTexts& texts, std::size_t index, SourcePlace place, std::string name = {}) {
    texts.places.resize(index);
    texts.places.push_back(place);
    if (name.empty()) return;
    if (MemoryBudget* budget = MemoryBudget::current()) budget->add(k_name_bytes + 2 * name.capacity());
    texts.names.emplace(static_cast<std::uint32_t>(index), std::move(name));
}

}  // namespace glint
