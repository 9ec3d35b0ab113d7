// SPDX-License-Identifier: Apache-2.0
// glint-tachyon's command line. Flags that set modes become a second text in Tachyon's format.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "cli/drop_in.h"
#include "cli/failure.h"
#include "cli/foreign_table.h"
#include "cli/picture_endings.h"
#include "formats/number_text.h"

namespace glint::cli {
namespace {

using Value = ForeignValue;

constexpr int k_sky_samples = 128;  // Tachyon's default

class TachyonArguments {
  public:
    explicit TachyonArguments(const std::vector<std::string>& words) : words_(words) {}

    DropIn parse() {
        RenderArguments& render = parsed_.render;
        render.scene.format = "tachyon";
        render.numbers.format = FileFormat::tga;
        for (next_ = 0; next_ < words_.size();) read(words_[next_++]);
        if (parsed_.wants_help || parsed_.wants_version) return std::move(parsed_);
        if (render.scene.files.empty() || render.scene.files[0].empty())
            throw Failure(k_usage, "expected the name of a model file");
        if (render.output.empty()) render.output = "outfile" + ending_of(*render.numbers.format);
        if (!writes_) render.output = "/dev/null";
        const std::string text = settings_text();
        if (!text.empty()) render.scene.further_texts.emplace_back("command line", text);
        return std::move(parsed_);
    }

  private:
    // What the flags set, in Tachyon's format. The order of the lights' flags does not matter.
    std::string settings_text() const {
        // The shader comes first; of several, the last counts (Tachyon, measured).
        std::string modes = shader_ + modes_, text;
        double sky = add_sky_;
        if (auto_sky_ > 0) {
            sky = auto_sky_;
            modes += fmt::format(" Rescale_Direct {}", std::max(0.0, 1 - sky));
        } else if (light_scale_ < 1) {
            modes += fmt::format(" Rescale_Direct {}", light_scale_);
        }
        if (!modes.empty()) text += fmt::format("Shader_Mode{} End_Shader_Mode\n", modes);
        if (sky > 0) text += fmt::format("Sky_Light NumSamples {0} Color {1} {1} {1}\n", sky_samples_, sky);
        return text;
    }

    [[noreturn]] static void fail(const std::string& message) { throw Failure(k_usage, message); }

    std::string value_of(std::string_view flag) {
        if (next_ == words_.size() || words_[next_].empty())
            fail(fmt::format("{}: expected a value, found nothing", flag));
        return words_[next_++];
    }
    static double number_in(std::string_view flag, const std::string& text) {
        double value = 0;
        const char* const end = text.data() + text.size();
        if (text.empty() || read_any_number(text.data(), end, value) != end || !(value >= 0 && value <= 1e9))
            fail(fmt::format("{}: expected a number >= 0, found {}", flag, glint::quoted(text)));
        return value;
    }
    // Tachyon cuts off fractions: VMD's scripts compute sizes.
    static int whole_in(std::string_view flag, const std::string& text, int most) {
        const double value = number_in(flag, text);
        if (value > most)
            fail(fmt::format("{}: expected a whole number from 0 to {}, found {}", flag, most,
                             glint::quoted(text)));
        return static_cast<int>(value);
    }
    void set(const std::string& key, const std::string& value) {
        std::erase_if(parsed_.render.scene.settings,
                      [&](const auto& setting) { return setting.first == key; });
        parsed_.render.scene.settings.emplace_back(key, value);
    }

    void read(const std::string& word) {
        const bool is_alone = words_.size() == 1;  // Tachyon has no flags with two hyphens
        if (word == "-help" || (is_alone && word == "--help")) return void(parsed_.wants_help = true);
        if (word == "-version" || word == "-banner" || (is_alone && word == "--version"))
            return void(parsed_.wants_version = true);
        if (word == "+V") return void(parsed_.render.quiet = false);
        if (word == "-V") return;
        if (word == "--skip-unsupported") return void(parsed_.render.scene.skip_unsupported = true);
        if (word == "-o") return void(parsed_.render.output = value_of(word));
        if (word.size() > 1 && word[0] == '-') return read_flag(word);
        if (!parsed_.render.scene.files.empty())
            fail(fmt::format("glint-tachyon renders one scene, found {} and {}",
                             glint::quoted(parsed_.render.scene.files[0]), glint::quoted(word)));
        parsed_.render.scene.files = {word};
    }

    void read_flag(const std::string& word) {
        const ForeignFlag* flag = find_foreign_flag(word, true);
        if (flag == nullptr) {
            std::vector<std::string_view> known;
            for (const ForeignFlag& f : tachyon_flags()) known.push_back(f.flag);
            fail(fmt::format("unknown flag {}{}", glint::quoted(word), did_you_mean(word, known)));
        }
        std::vector<std::string> values;
        values.reserve(static_cast<std::size_t>(flag->values));
        for (int i = 0; i < flag->values; ++i) values.push_back(value_of(word));
        if (is_shader(flag->mode)) return void(shader_ = fmt::format(" {}", flag->mode));
        if (!flag->mode.empty()) {
            modes_ += fmt::format(" {}", flag->mode);
            for (const std::string& value : values)
                modes_ += fmt::format(" {}", whole_in(word, value, 1000000000));
            return;
        }
        apply(*flag, word, values);
    }

    static bool is_shader(std::string_view mode) {
        return mode == "Full" || mode == "Medium" || mode == "Low" || mode == "Lowest";
    }

    void apply(const ForeignFlag& flag, const std::string& word, const std::vector<std::string>& values) {
        RenderArguments& render = parsed_.render;
        switch (flag.value) {
            case Value::size: {
                const int width = whole_in(word, values[0], k_max_size);
                render.picture.size = fmt::format("{}x{}", width, whole_in(word, values[1], k_max_size));
                return;
            }
            case Value::samples_besides: {
                const int wanted = whole_in(word, values[0], 1000000) + 1;
                int side = 1;
                while (side < k_max_samples && side * side < wanted) ++side;
                return set("aa", std::to_string(side));
            }
            case Value::depth:
                return set("reflections", std::to_string(std::clamp(whole_in(word, values[0], 1000000) - 1, 0,
                                                                    k_max_reflections)));
            case Value::same:  // -numthreads
                return void(render.threads = whole_in(word, values[0], 1024));
            case Value::file_type:
                return set_format(values[0]);
            case Value::light_scale:
                return void(light_scale_ = number_in(word, values[0]));
            case Value::sky_instead:
                return void(auto_sky_ = number_in(word, values[0]));
            case Value::sky_besides:
                return void(add_sky_ = number_in(word, values[0]));
            case Value::sky_samples:
                sky_samples_ = whole_in(word, values[0], 1000000);
                return;
            case Value::unused:
                return;
            case Value::nearest:
                parsed_.warnings.push_back(fmt::format("{}: drawn as -shade_blinn", word));
                return set("shading", "blinn-phong");
            case Value::gamma:
                parsed_.warnings.push_back(
                    fmt::format("{}: glint has no such gamma; the picture has none", word));
                return;
            default:
                break;
        }
        if (word == "-nosave") return void(writes_ = false);
        constexpr std::string_view shading = "--shading ";
        if (flag.ours.starts_with(shading))
            return set("shading", std::string(flag.ours.substr(shading.size())));
        parsed_.warnings.push_back(fmt::format("{} has no effect: {}", word, flag.ours));
    }

    void set_format(const std::string& name) {
        NumberArguments& numbers = parsed_.render.numbers;
        std::string upper;
        for (const char c : name) upper += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        numbers.bits = upper == "PPM48" ? 16 : 8;
        if (upper == "PNG") {
            numbers.format = FileFormat::png;
        } else if (upper == "PPM" || upper == "PPM48") {
            numbers.format = FileFormat::ppm;
        } else if (upper == "TARGA" || upper == "TGA") {
            numbers.format = FileFormat::tga;
        } else if (upper == "BMP") {
            numbers.format = FileFormat::bmp;
        } else if (upper == "JPEG") {
            numbers.format = FileFormat::jpeg;
        } else {
            fail(
                fmt::format("-format: glint-tachyon writes TARGA, PNG, PPM, PPM48, BMP and JPEG, found {}; "
                            "PNG loses nothing",
                            glint::quoted(name)));
        }
    }

    const std::vector<std::string>& words_;
    std::size_t next_ = 0;
    DropIn parsed_;
    std::string shader_, modes_;
    bool writes_ = true;
    double light_scale_ = 1, auto_sky_ = 0, add_sky_ = 0;
    int sky_samples_ = k_sky_samples;
};

}  // namespace

DropIn tachyon_drop_in(const std::vector<std::string>& arguments) {
    return TachyonArguments(arguments).parse();
}

}  // namespace glint::cli
