// SPDX-License-Identifier: Apache-2.0
// Texts to one Scene: reads each text with its format's reader, applies the settings, and validates.
#include "formats/load_validated.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/fp_environment.h"
#include "base/sort_stably.h"
#include "base/status.h"
#include "formats/profile_file.h"
#include "formats/registry.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

Diagnostic without_place(Severity severity, std::string_view file, std::string message) {
    Diagnostic d;
    d.severity = severity;
    d.file = std::string(file);
    d.message = std::move(message);
    return d;
}

class Loader {
  public:
    Loader(std::span<const SceneText> texts, const LoadOptions& options, Sources* sources)
        : texts_(texts),
          options_(options),
          bytes_(length_of(texts)),
          reading_(options, sources, std::max(1u, options.max_errors), bytes_) {
        reading_.diagnostics.set_watcher(
            [this](InputText where, std::size_t offset) { return go_on(where, offset); });
    }

    Result<ValidatedScene> run() {
        ErrorCode code = ErrorCode::invalid_argument;
        if (texts_.empty()) {
            add(Severity::error, "", "no text to read a scene from");
        } else if (texts_.size() > k_max_texts) {
            add(Severity::error, "",
                fmt::format("{} texts: at most {} make a scene", texts_.size(), k_max_texts));
        } else if (find_formats()) {
            set_profile();
            if (!reading_.diagnostics.any_errors()) code = ErrorCode::parse;
            for (std::size_t i = 0; i < texts_.size() && !reading_.diagnostics.full(); ++i) read(i);
            for (const Format& format : all_formats()) {
                if (format.finish) format.finish(reading_);
            }
            check_view();
            ask_for_memory(texts_.back());
            reading_.left_out.report(reading_.diagnostics);
            if (reading_.camera_wanted && !reading_.camera_given && !reading_.scene.camera.frame) {
                reading_.diagnostics.add(*reading_.camera_wanted);
            }
            if (!reading_.diagnostics.any_errors()) code = ErrorCode::invalid_argument;
            apply_settings();
        }
        if (!reading_.diagnostics.any_errors()) {
            code = ErrorCode::invalid_scene;
            check();
        }
        if (is_cancelled()) return cancelled();
        if (reading_.is_include_missing) code = ErrorCode::io;
        if (reading_.is_memory_reported) code = ErrorCode::out_of_memory;
        const bool is_wrong = reading_.diagnostics.any_errors();
        std::vector<Diagnostic> diagnostics = reading_.diagnostics.take();
        sort(diagnostics);
        for (Diagnostic& d : diagnostics) hide_foreign_line(d);
        if (is_wrong) return failure(code, std::move(diagnostics));
        if (options_.progress) options_.progress(1);
        return {*std::move(validated_), std::move(diagnostics)};
    }

  private:
    static std::size_t length_of(std::span<const SceneText> texts) {
        std::size_t bytes = 0;
        for (const SceneText& text : texts) bytes += text.text.size();
        return bytes;
    }

    bool is_cancelled() const { return options_.cancel.is_set(); }

    // An included text is known when it is read: then there is more to be read than before.
    void report(InputText where, std::size_t offset) {
        if (where.text.data() == texts_[reading_.includes.root].text.data()) {
            given_read_ = offset;
            for (std::size_t i = 0; i < reading_.includes.root; ++i) given_read_ += texts_[i].text.size();
            included_read_ = included_.size();
        } else {
            if (where.text.data() != included_.data()) {
                included_bytes_ += where.text.size();
                included_before_ += included_.size();
                included_ = where.text;
            }
            included_read_ = offset;
        }
        const std::size_t all = bytes_ + included_bytes_,
                          read = given_read_ + included_before_ + included_read_;
        if (all > 0) most_read_ = std::max(most_read_, static_cast<double>(read) / static_cast<double>(all));
        options_.progress(std::min(most_read_, 1.0));
    }
    bool go_on(InputText where, std::size_t offset) {
        if (options_.progress) report(where, offset);
        return !is_cancelled() && reading_.is_within_memory(where, offset);
    }

    void add(Severity severity, std::string_view file, std::string message) {
        reading_.diagnostics.add(without_place(severity, file, std::move(message)));
    }

    bool find_formats() {
        for (const SceneText& text : texts_) {
            std::string why;
            formats_.push_back(find_format(text, why));
            if (!formats_.back()) add(Severity::error, text.name, why);
            reading_.scene.files.push_back(text.name);
            reading_.texts.push_back({text.name, text.text});
        }
        return !reading_.diagnostics.any_errors();
    }

    // The texts of a scene may have different formats; the conventions are those of the first.
    void set_profile() {
        const auto own = formats_.front()->info.profile;
        const std::string wrong = set_named_profile(
            reading_.scene, options_.profile.empty() ? own : std::string_view(options_.profile));
        if (!wrong.empty()) add(Severity::error, "", wrong);
        formats_.front()->set_defaults(reading_.scene);
        if (options_.profile_text) {
            const InputText place{options_.profile_text->name, options_.profile_text->text};
            reading_.scene.files.push_back(options_.profile_text->name);
            reading_.texts.push_back(place);
            reading_.profile_text = {place, static_cast<std::uint16_t>(texts_.size())};
            read_profile_file(reading_, *reading_.profile_text);
        }
        for (std::size_t i = 1; i < texts_.size() && options_.profile.empty(); ++i) {
            if (formats_[i]->info.profile == own) continue;
            add(Severity::warning, texts_[i].name,
                fmt::format("read with the conventions of {}, as the first text is", own));
        }
    }

    // The caller has chosen its own texts; a scene may name any file.
    void hide_foreign_line(Diagnostic& d) const {
        const std::vector<std::string>& files = validated_ ? (*validated_)->files : reading_.scene.files;
        const auto end_of_own =
            files.begin() + static_cast<std::ptrdiff_t>(
                                std::min(files.size(), texts_.size() + (options_.profile_text ? 1 : 0)));
        if (is_scene_name(d.file) || std::find(files.begin(), end_of_own, d.file) != end_of_own) return;
        d.source_line.clear();
        d.caret = 0;
    }

    void read(std::size_t i) {
        const SceneText& text = texts_[i];
        reading_.includes.root = static_cast<std::uint16_t>(i);
        formats_[i]->read(reading_, {{text.name, text.text}, static_cast<std::uint16_t>(i)});
        ask_for_memory(text);
    }

    // Reports what is too much at the end of a text.
    void ask_for_memory(const SceneText& text) {
        (void)reading_.is_within_memory({text.name, text.text}, text.text.size());
    }

    void check_view() {
        if (!options_.view) return;
        const double distance = length(*options_.view);
        if (!(distance > 0 && distance < number::k_infinity))
            add(Severity::error, "", "the view has no direction");
        if (!reading_.is_view_used && !reading_.diagnostics.any_errors())
            add(Severity::error, "", "only meshes without a camera have a view");
    }

    void apply_settings() {
        for (const auto& [key, value] : options_.settings) {
            const std::string wrong =
                set_named_setting(reading_.scene, key, value, {SettingOrigin::Kind::command, {}});
            if (!wrong.empty()) add(Severity::error, "", wrong);
        }
    }

    void check() {
        std::vector<Mistake> mistakes;
        validated_ = ValidatedScene::take(reading_.scene, mistakes);
        for (Mistake& mistake : mistakes) {
            const SourcePlace place = mistake.place;
            const bool has_place = place.line != 0 && place.file < reading_.texts.size();
            Diagnostic d = has_place ? diagnostic_at(mistake.severity, reading_.texts[place.file], place,
                                                     std::move(mistake.message))
                                     : without_place(mistake.severity, "", std::move(mistake.message));
            d.item = mistake.item;
            d.index = mistake.index;
            reading_.diagnostics.add(std::move(d));
        }
    }

    // In the order of the texts; diagnostics without a place come last.
    void sort(std::vector<Diagnostic>& diagnostics) const {
        const auto file = [&](const Diagnostic& d) {
            const auto at = std::find_if(reading_.texts.begin(), reading_.texts.end(),
                                         [&](const InputText& t) { return t.name == d.file; });
            return at - reading_.texts.begin();
        };
        sort_stably(diagnostics, [&](const Diagnostic& a, const Diagnostic& b) {
            const auto fa = file(a), fb = file(b);
            if (fa != fb) return fa < fb;
            return a.line != b.line ? a.line < b.line : a.column < b.column;
        });
    }

    std::span<const SceneText> texts_;
    const LoadOptions& options_;
    std::size_t bytes_;  // of all texts
    // For the progress: bytes that are read, of the given texts, of the included ones before the last, and of
    // the last.
    std::size_t given_read_ = 0, included_before_ = 0, included_read_ = 0, included_bytes_ = 0;
    std::string_view included_;
    double most_read_ = 0;
    std::vector<const Format*> formats_;
    LoadState reading_;
    std::optional<ValidatedScene> validated_;  // once it is known to be valid; reading_.scene is then empty
};

}  // namespace

Result<ValidatedScene> load_validated(std::span<const SceneText> texts, const LoadOptions& options,
                                      Sources* sources) {
    const auto body = [&] {
        const DefaultFpEnvironment environment;
        return Loader(texts, options, sources).run();
    };
    return result_of(body, " while reading the scene");
}

Result<Scene> load(std::span<const SceneText> texts, const LoadOptions& options, Sources* sources) {
    Result<ValidatedScene> loaded = load_validated(texts, options, sources);
    if (!loaded) return Status(std::move(loaded));
    return {std::move(*loaded).release(), std::move(loaded.diagnostics)};
}

}  // namespace glint
