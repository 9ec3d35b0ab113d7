// SPDX-License-Identifier: Apache-2.0
#include "formats/include.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/registry.h"

namespace glint {
namespace {

constexpr std::size_t k_max_depth = 16;
// Files that include each other twice in a chain would grow exponentially.
constexpr std::uint32_t k_max_includes = 10000;
constexpr std::size_t k_max_repeated_bytes = std::size_t{64} << 20;

// The values that an included text must not overwrite once they have been set.
struct Kept {
    explicit Kept(const LoadState& r)
        : camera(r.scene.camera),
          background(r.scene.background),
          camera_place(r.scene.camera_place),
          background_place(r.scene.background_place),
          conventions(r.scene.conventions),
          settings(r.scene.settings),
          profile(r.scene.profile),
          origins(r.scene.origins),
          camera_wanted(r.camera_wanted),
          camera_given(r.camera_given),
          background_given(r.background_given),
          camera_included(r.camera_included),
          background_included(r.background_included) {}

    Camera camera;
    Color background;
    SourcePlace camera_place, background_place;
    Conventions conventions;
    RenderSettings settings;
    std::string profile;
    std::vector<SettingOrigin> origins;
    std::optional<Diagnostic> camera_wanted;
    bool camera_given, background_given, camera_included, background_included;
};

class Include {
  public:
    /// without: what the scene is without the text, if it can do without.
    Include(LoadState& reading, const ReadText& from, const Token& at, std::string_view without = {})
        : reading_(reading), from_(from), at_(at), without_(without) {}

    void read(const std::string& name, const std::string& format_name) {
        if (reading_.diagnostics.full()) return;
        const std::string path = path_of(name);
        std::string why;
        const Format* format = find_format({path, {}, format_name}, why);
        const std::string loop = loop_of(path);
        if (reading_.sources == nullptr) {
            error(name, "this text cannot include others: no files are read here");
        } else if (!loop.empty()) {
            error(name, "a text cannot include itself: " + loop);
        } else if (reading_.includes.open.size() >= k_max_depth) {
            error(name, fmt::format("includes are nested more than {} deep", k_max_depth));
        } else if (++reading_.includes.count > k_max_includes) {
            error(name, fmt::format("more than {} includes", k_max_includes));
        } else if (format == nullptr) {
            error(name, why);
        } else if (const auto file = find_text(name, path)) {
            // A .pov is of one of two formats, by its text.
            const SceneText text{path, reading_.texts[*file].text, format_name};
            if (const Format* by_text = find_format(text, why)) format = by_text;
            read_text(*format, {reading_.texts[*file], *file, true});
        }
    }

    std::optional<ReadText> open(const std::string& name) {
        if (reading_.diagnostics.full()) return std::nullopt;
        const auto known = reading_.includes.files.find(path_of(name));
        if (known != reading_.includes.files.end()) {
            return ReadText{reading_.texts[known->second], known->second, true};
        }
        if (reading_.sources == nullptr) {
            error(name, "this text cannot refer to others: no files are read here");
        } else if (const auto file = find_text(name, path_of(name))) {
            return ReadText{reading_.texts[*file], *file, true};
        }
        return std::nullopt;
    }

  private:
    void error(const std::string& name, const std::string& what) {
        if (!without_.empty()) {
            reading_.diagnostics.warn(from_.place, at_.offset, at_.length,
                                      fmt::format("{}: {}; {}", quoted(name), what, without_));
            return;
        }
        reading_.diagnostics.error(from_.place, at_.offset, at_.length,
                                   fmt::format("{}: {}", quoted(name), what));
    }

    // The name as used by FileSources and messages: relative to the including text.
    std::string path_of(const std::string& name) const {
        if (is_absolute_path(name)) return name;
        return std::string(from_.place.name.substr(0, from_.place.name.rfind('/') + 1)) + name;
    }

    // "a.glint -> b.glint -> a.glint", or an empty string.
    std::string loop_of(const std::string& path) const {
        std::string loop;
        const auto visit = [&](std::string_view name) {
            if (!loop.empty() || name == path) loop += fmt::format("{} -> ", quoted(name));
        };
        visit(reading_.texts[reading_.includes.root].name);
        for (const auto file : reading_.includes.open) visit(reading_.texts[file].name);
        return loop.empty() ? loop : loop + quoted(path);
    }

    // The index of the text, which is read only once.
    std::optional<std::uint16_t> find_text(const std::string& name, const std::string& path) {
        Includes& all = reading_.includes;
        if (const auto known = all.files.find(path); known != all.files.end()) {
            all.repeated_bytes += reading_.texts[known->second].text.size();
            if (all.repeated_bytes <= k_max_repeated_bytes) return known->second;
            error(name, fmt::format("more than {} MiB of texts that are included again",
                                    k_max_repeated_bytes >> 20));
            return std::nullopt;
        }
        Result<std::string> text = reading_.sources->read(name, from_.place.name);
        if (!text) {
            if (without_.empty()) reading_.is_include_missing = true;
            error(name, text.message.empty() ? "no such file" : text.message);
            return std::nullopt;
        }
        if (reading_.texts.size() > k_max_texts) {
            error(name, fmt::format("at most {} texts make a scene", k_max_texts));
            return std::nullopt;
        }
        return reading_.add_text(path, std::move(*text));
    }

    void read_text(const Format& format, const ReadText& text) {
        const Kept kept(reading_);
        reading_.camera_given = reading_.background_given = false;
        reading_.includes.open.push_back(text.file);
        format.read(reading_, text);
        reading_.includes.open.pop_back();
        restore(kept, text);
    }

    void restore(const Kept& kept, const ReadText& text) {
        Scene& scene = reading_.scene;
        scene.conventions = kept.conventions;
        scene.settings = kept.settings;
        scene.profile = kept.profile;
        scene.origins = kept.origins;
        reading_.camera_wanted = kept.camera_wanted;
        if (kept.camera_given || !reading_.camera_given) {
            if (reading_.camera_given) warn_ignored("camera", text);
            scene.camera = kept.camera;
            scene.camera_place = kept.camera_place;
            reading_.camera_given = kept.camera_given;
            reading_.camera_included = kept.camera_included;
        } else {
            reading_.camera_included = true;
        }
        if (kept.background_given || !reading_.background_given) {
            if (reading_.background_given) warn_ignored("background", text);
            scene.background = kept.background;
            scene.background_place = kept.background_place;
            reading_.background_given = kept.background_given;
            reading_.background_included = kept.background_included;
        } else {
            reading_.background_included = true;
        }
    }

    void warn_ignored(std::string_view what, const ReadText& text) {
        reading_.diagnostics.warn(
            from_.place, at_.offset, at_.length,
            fmt::format("glint ignores the {} of {}: the scene has one", what, quoted(text.place.name)));
    }

    LoadState& reading_;
    const ReadText& from_;
    const Token& at_;
    const std::string_view without_;
};

}  // namespace

void include_text(LoadState& reading, const ReadText& from, const Token& at, const std::string& name,
                  const std::string& format) {
    Include(reading, from, at).read(name, format);
}

std::optional<ReadText> open_text(LoadState& reading, const ReadText& from, const Token& at,
                                  const std::string& name) {
    return Include(reading, from, at).open(name);
}

std::optional<ReadText> open_optional_text(LoadState& reading, const ReadText& from, const Token& at,
                                           const std::string& name, std::string_view without) {
    return Include(reading, from, at, without).open(name);
}

}  // namespace glint
