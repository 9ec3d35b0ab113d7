// SPDX-License-Identifier: Apache-2.0
// glint-povray's command line.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/text.h"
#include "cli/drop_in.h"
#include "cli/drop_in_animation.h"
#include "cli/drop_in_words.h"
#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/foreign_table.h"
#include "cli/input_file.h"
#include "cli/output_file.h"
#include "cli/picture_endings.h"
#include "cli/text.h"
#include "formats/number_text.h"

namespace glint::cli {
namespace {

constexpr int k_max_ini_depth = 10, k_max_ini_files = 1000;
constexpr double k_max_frame = 1e6;

class PovrayArguments {
  public:
    explicit PovrayArguments(IniFiles& files) : files_(files) {}
    DropIn parse(const std::vector<std::string>& words) {
        read_own_ini();
        for (const std::string& word : words) {
            if (word == "--help" || word == "-help" || word == "-h" || word == "-?") {
                parsed_.wants_help = true;
            } else if (word == "--version" || word == "-version") {
                parsed_.wants_version = true;
            } else if (word == "--skip-unsupported") {
                parsed_.render.scene.skip_unsupported = true;
            } else if (!word.empty() &&
                       (word[0] == '+' || word[0] == '-' || word.find('=') < word.find(' '))) {
                for (const std::string& option : split_options(word, true)) read(option);
            } else {
                read(word);
            }
        }
        if (!parsed_.wants_help && !parsed_.wants_version) finish();
        return std::move(parsed_);
    }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw Failure(k_usage, place_.empty() ? message : fmt::format("{}: {}", place_, message));
    }
    void warn(const std::string& message) {
        parsed_.warnings.push_back(place_.empty() ? message : fmt::format("{}: {}", place_, message));
    }

    // The user's and the system's defaults, as POV-Ray finds them.
    void read_own_ini() {
        std::vector<std::string> candidates;
        if (const char* named = std::getenv("POVINI")) candidates.emplace_back(named);
        candidates.emplace_back("povray.ini");
        if (const char* home = std::getenv("HOME"))
            candidates.push_back(std::string(home) + "/.povray/3.7/povray.ini");
        candidates.emplace_back("/etc/povray/3.7/povray.ini");
        for (const std::string& path : candidates) {
            if (!files_.exists(path)) continue;
            is_own_ini_ = true;
            is_trusted_ini_ = path != "povray.ini";  // which comes with a folder
            read_ini(path);
            is_own_ini_ = is_trusted_ini_ = false;
            return;
        }
    }

    // FILE.ini or FILE.ini[section].
    void read_ini(const std::string& word) {
        const std::size_t bracket = word.ends_with(']') ? word.find('[') : std::string::npos;
        const std::string path = word.substr(0, bracket);
        const std::string wanted =
            bracket == std::string::npos ? "" : word.substr(bracket + 1, word.size() - bracket - 2);
        if (++depth_ > k_max_ini_depth) fail(fmt::format("{}: .ini files are nested too deeply", path));
        // Ten files of a hundred lines, each of which names the next file, would be read 100^9 times.
        if (++ini_files_ > k_max_ini_files) fail(fmt::format("more than {} .ini files", k_max_ini_files));
        const std::string outer_ini = std::exchange(ini_, path);
        const std::string file = files_.read(path, depth_ == 1 && !is_own_ini_);
        const std::string outer = place_;
        std::string_view rest = file;
        bool is_wanted = true;
        for (int line = 1; !rest.empty(); ++line) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            const std::string text = trimmed_value(without_comment(rest.substr(0, end)));
            rest.remove_prefix(std::min(end + 1, rest.size()));
            place_ = fmt::format("{}:{}", path, line);
            // In a name it would end the message.
            if (text.find('\0') != std::string::npos) fail("expected text, found a NUL byte");
            if (text.starts_with('[') && text.ends_with(']')) {
                is_wanted = text.substr(1, text.size() - 2) == wanted;
            } else if (is_wanted && !text.empty()) {
                read_line(text);
            }
        }
        place_ = outer;
        ini_ = outer_ini;
        --depth_;
    }

    // Key = Value, or switches.
    void read_line(const std::string& text) {
        const bool is_key = text[0] != '+' && text[0] != '-' && text.find('=') != std::string::npos;
        if (is_key) return read(text);
        if (text.find('=') != std::string::npos) {
            for (const std::string& option : split_options(text, true)) read(option);
            return;
        }
        for (std::size_t i = 0; i < text.size();) {
            const std::size_t end = std::min(text.find_first_of(" \t", i), text.size());
            if (end > i) read(text.substr(i, end - i));
            i = end + 1;
        }
    }

    void read(const std::string& word) {
        if (word.size() > 1 && (word[0] == '+' || word[0] == '-')) {
            const PovraySwitch* known = find_povray_switch(std::string_view(word).substr(1));
            if (known == nullptr) return unknown(fmt::format("unknown switch {}", glint::quoted(word)));
            return set(known->id, trimmed_value(word.substr(1 + known->letters.size())), word[0] == '+',
                       word);
        }
        const std::size_t equals = word.find('=');
        if (equals != std::string::npos) {
            const std::string key = trimmed_value(word.substr(0, equals)),
                              value = trimmed_value(word.substr(equals + 1));
            const PovraySwitch* known = find_povray_key(key);
            if (known == nullptr) return unknown(fmt::format("unknown key {}", glint::quoted(key)));
            return set_key(*known, value, word);
        }
        const std::string ending = extension(word.substr(0, word.find('[')));
        if (ending == ".ini") return read_ini(word);
        set_input(word);
    }

    // Who names a file: the place in an .ini file, and its folder; none if it is the user.
    struct Namer {
        std::string place, folder;
    };
    Namer namer() const { return is_trusted_ini_ ? Namer() : Namer{place_, folder_of(ini_)}; }

    void set_input(const std::string& name) {
        input_ = name;
        input_by_ = namer();
        parsed_.render.scene.is_named_by_file = !place_.empty();
    }

    // The system's own defaults may have keys of other versions.
    void unknown(const std::string& message) const {
        if (!is_own_ini_) fail(message);
    }

    static std::optional<bool> truth(const std::string& text) {
        std::string lower;
        for (const char c : text) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if (lower == "on" || lower == "true" || lower == "yes" || lower == "1") return true;
        if (lower == "off" || lower == "false" || lower == "no" || lower == "0") return false;
        return std::nullopt;
    }

    // Keys whose values differ from those of their switches.
    void set_key(const PovraySwitch& known, const std::string& value, const std::string& word) {
        if (known.key == "Output_to_File") return void(writes_ = truth(value).value_or(true));
        const bool is_switch = known.id == PovrayKey::antialias || known.id == PovrayKey::alpha ||
                               known.id == PovrayKey::jitter || known.id == PovrayKey::display ||
                               known.id == PovrayKey::verbose || known.id == PovrayKey::cycle ||
                               known.id == PovrayKey::fields;
        if (is_switch && known.key != "Jitter_Amount")
            return set(known.id, {}, truth(value).value_or(true), word);
        if (known.id == PovrayKey::other_picture && !truth(value).value_or(true)) return;
        set(known.id, value, true, word);
    }

    double number(const std::string& value, const std::string& word, double most) const {
        double result = 0;
        const char* const end = value.data() + value.size();
        if (value.empty() || read_any_number(value.data(), end, result) != end ||
            !(result >= 0 && result <= most))
            fail(fmt::format("{}: expected a number from 0 to {}", glint::quoted(word), most));
        return result;
    }

    void set(PovrayKey key, const std::string& value, bool on, const std::string& word) {
        RenderArguments& render = parsed_.render;
        switch (key) {
            case PovrayKey::width:
                return void(width_ = static_cast<int>(number(value, word, k_max_size)));
            case PovrayKey::height:
                return void(height_ = static_cast<int>(number(value, word, k_max_size)));
            case PovrayKey::input:
                return set_input(value);
            case PovrayKey::output:
                output_ = value;
                output_by_ = namer();
                return;
            case PovrayKey::file_type:
                writes_ = on;
                return set_file_type(value, word);
            case PovrayKey::bits:
                return void(render.numbers.bits = number(value, word, 16) > 8 ? 16 : 8);
            case PovrayKey::threads:
                return void(render.threads = static_cast<int>(number(value, word, 1024)));
            case PovrayKey::antialias:
                antialias_ = on;
                if (!value.empty()) threshold_ = number(value, word, 1e6);
                return;
            case PovrayKey::antialias_threshold:
                return void(threshold_ = number(value, word, 1e6));
            case PovrayKey::antialias_depth:
                return void(depth_of_samples_ = std::clamp(static_cast<int>(number(value, word, 9)), 1, 9));
            case PovrayKey::quality:
                return set_quality(number(value, word, 11));
            case PovrayKey::alpha:
                return void(render.picture.alpha = on);
            case PovrayKey::verbose:
                return void(render.quiet = !on);
            case PovrayKey::library:
                if (value.empty()) fail(fmt::format("{}: expected a folder", glint::quoted(word)));
                return void(folders_.push_back(value));
            case PovrayKey::clock:
                return declare("clock", value, word);
            case PovrayKey::first_frame:
                return void(animation_.first_frame = number(value, word, k_max_frame));
            case PovrayKey::last_frame:
                return void(animation_.last_frame = number(value, word, k_max_frame));
            case PovrayKey::first_clock:
                return void(animation_.first_clock = any_number(value, word));
            case PovrayKey::last_clock:
                return void(animation_.last_clock = any_number(value, word));
            case PovrayKey::cycle:
                return void(animation_.is_cyclic = on);
            case PovrayKey::subset_first_frame:
                return void(animation_.subset_first = number(value, word, k_max_frame));
            case PovrayKey::subset_last_frame:
                return void(animation_.subset_last = number(value, word, k_max_frame));
            case PovrayKey::frame_step:
                return void(animation_.step = number(value, word, k_max_frame));
            case PovrayKey::fields:
                if (on)
                    warn(fmt::format("{} has no effect: glint renders whole frames", glint::quoted(word)));
                return;
            case PovrayKey::first_column:
                return void(columns_.first = number(value, word, k_max_size));
            case PovrayKey::last_column:
                return void(columns_.last = number(value, word, k_max_size));
            case PovrayKey::first_row:
                return void(rows_.first = number(value, word, k_max_size));
            case PovrayKey::last_row:
                return void(rows_.last = number(value, word, k_max_size));
            case PovrayKey::compression:
                if (const double quality = number(value, word, 100); quality >= 1)
                    jpeg_quality_ = static_cast<int>(quality);
                return;
            case PovrayKey::warning_level:
                return void(render.hides_warnings = number(value, word, 10) < 1);
            case PovrayKey::declare: {
                const std::size_t equals = value.find('=');
                if (equals == std::string::npos || equals == 0)
                    return fail(fmt::format("{}: expected NAME=NUMBER", glint::quoted(word)));
                return declare(value.substr(0, equals), trimmed_value(value.substr(equals + 1)), word);
            }
            case PovrayKey::header:
                return fail(fmt::format("{}: glint-povray does not change the scene", glint::quoted(word)));
            case PovrayKey::file_gamma:
            case PovrayKey::other_picture:
                return warn(fmt::format("{} has no effect in glint", glint::quoted(word)));
            case PovrayKey::jitter:
            case PovrayKey::sampling_method:
            case PovrayKey::display:
            case PovrayKey::console:
            case PovrayKey::unused:
                return;
        }
    }

    double any_number(const std::string& value, const std::string& word) const {
        double number = 0;
        const char* const end = value.data() + value.size();
        if (value.empty() || read_any_number(value.data(), end, number) != end ||
            !(number >= -1e12 && number <= 1e12))
            fail(fmt::format("{}: expected a number", glint::quoted(word)));
        return number;
    }

    // A number that the scene finds declared.
    void declare(const std::string& name, const std::string& value, const std::string& word) {
        const double number = any_number(value, word);
        auto& declared = parsed_.render.scene.declared;
        std::erase_if(declared, [&](const auto& d) { return d.first == name; });
        declared.emplace_back(name, number);
    }

    // N8, N16, T, P, E, J, B; the bits follow the letter.
    void set_file_type(const std::string& value, const std::string& word) {
        if (value.empty()) return;
        NumberArguments& numbers = parsed_.render.numbers;
        const char type = value[0] >= 'a' ? static_cast<char>(value[0] - 'a' + 'A') : value[0];
        std::string rest = value.substr(1);
        if (!rest.empty() && (rest[0] == 'G' || rest[0] == 'g')) return fail_gray(word);
        switch (type) {
            case 'N':
            case 'S':  // the system's, on Unix
                numbers.format = FileFormat::png;
                break;
            case 'T':
            case 'C':  // compressed: other bytes of the same picture
                numbers.format = FileFormat::tga;
                break;
            case 'P':
                numbers.format = FileFormat::ppm;
                break;
            case 'E':
                numbers.format = FileFormat::exr;
                break;
            case 'J':
                numbers.format = FileFormat::jpeg;
                return;  // the number that follows has no effect
            case 'B':
                numbers.format = FileFormat::bmp;
                break;
            default:
                fail(fmt::format(
                    "{}: glint-povray writes N (PNG), T (TGA), P (PPM), E (OpenEXR), J (JPEG) and "
                    "B (BMP)",
                    glint::quoted(word)));
        }
        if (!rest.empty()) numbers.bits = number(rest, word, 16) > 8 ? 16 : 8;
    }
    void fail_gray(const std::string& word) const {
        fail(fmt::format("{}: glint-povray writes colors only", glint::quoted(word)));
    }

    void set_quality(double quality) {
        auto& settings = parsed_.render.scene.settings;
        std::erase_if(settings, [](const auto& s) { return s.first == "shading" || s.first == "shadows"; });
        if (quality <= 1) settings.emplace_back("shading", "color");
        if (quality <= 3) settings.emplace_back("shadows", "false");
    }

    void finish() {
        if (input_.empty()) throw Failure(k_usage, "expected the name of a scene: +Iscene.pov");
        RenderArguments& render = parsed_.render;
        render.scene.files = {find_input()};
        render.scene.format = "povray";
        if (width_ == 0 || height_ == 0) fail("expected a width and a height above 0");
        render.picture.size = fmt::format("{}x{}", width_, height_);
        // POV-Ray compares the sum of three channels.
        if (antialias_ && depth_of_samples_ > 1)
            render.picture.aa = fmt::format("adaptive:{}:{:.4g}", depth_of_samples_, threshold_ / 3);
        if (!antialias_) render.picture.aa = "1";
        NumberArguments& numbers = render.numbers;
        if (!numbers.format) numbers.format = FileFormat::png;
        if (*numbers.format != FileFormat::png && *numbers.format != FileFormat::ppm) numbers.bits = 8;
        numbers.jpeg_quality = jpeg_quality_;
        render.output = writes_ ? output_path() : "/dev/null";
        render.scene.include_paths = folders_;
        set_part();
        set_frames();
        if (!writes_) return;
        if (parsed_.frames.empty()) check_output(render.output);
        for (const DropInFrame& frame : parsed_.frames) check_output(frame.output);
    }

    // POV-Ray's picture has its whole size, with black around the part.
    void set_part() {
        const auto across = pixels_of(columns_, width_), down = pixels_of(rows_, height_);
        if (!across || !down)
            throw Failure(
                k_usage,
                fmt::format("+SC, +EC, +SR, +ER: expected a part of the {}x{} pixels: the first column "
                            "and row at or before the last, from 1, or fractions",
                            width_, height_));
        if (across->count == width_ && down->count == height_) return;
        parsed_.render.crop =
            fmt::format("{}x{}+{}+{}", across->count, down->count, across->first, down->first);
        parsed_.render.keeps_size = true;
    }

    void set_frames() {
        parsed_.frames = frames_of(animation_, parsed_.render.output);
        const bool is_alone = animation_.first_frame.value_or(1) >= animation_.last_frame.value_or(0);
        if (!parsed_.frames.empty() && is_alone)
            warn("an animation of one frame: its clock is Initial_Clock; in POV-Ray it is not a number");
        if (!parsed_.frames.empty() && is_standard_output(parsed_.render.output))
            throw Failure(k_usage, "an animation is several files: name them with +O");
    }

    // Somebody else's .ini must not write to any place: on the command line the user sees where.
    void check_output(const std::string& path) const {
        const Namer& by = output_.empty() ? input_by_ : output_by_;
        if (by.place.empty() || path == "-" || is_inside(path, ".") || is_inside(path, by.folder)) return;
        throw Failure(k_usage,
                      fmt::format("{}: expected an output in this folder or the .ini file's, found {}; for "
                                  "another folder, give +O on the command line",
                                  by.place, glint::quoted(output_.empty() ? path : output_)));
    }

    // The scene, with .pov or without, in this folder or one of +L. Without extension `input_` then has it.
    std::string find_input() {
        std::error_code ignored;
        const bool is_bare = extension(input_).empty() && input_ != "-";
        if (is_bare && !std::filesystem::exists(input_, ignored)) input_ += ".pov";
        if (input_ == "-" || std::filesystem::exists(input_, ignored)) return input_;
        for (const std::string& folder : folders_) {
            std::string path = (std::filesystem::path(folder) / input_).string();
            if (std::filesystem::exists(path, ignored)) return path;
        }
        return input_;
    }

    // The names are POV-Ray's (measured): the ending of the file's type is added unless the name has it;
    // without +O the picture is beside the scene.
    std::string output_path() const {
        const std::string ending = ending_of(*parsed_.render.numbers.format);
        const std::filesystem::path scene(input_ == "-" ? "stdin" : input_);
        const std::string name = stem(scene.string()) + ending;
        if (output_.empty()) return (scene.parent_path() / name).string();
        if (output_ == "-") return output_;
        if (output_.ends_with('/')) return (std::filesystem::path(output_) / name).string();
        std::error_code ignored;
        if (output_.ends_with(ending) || std::filesystem::is_character_file(output_, ignored)) return output_;
        return output_ + (output_.ends_with('.') ? ending.substr(1) : ending);
    }

    IniFiles& files_;
    DropIn parsed_;
    std::string ini_, place_;  // the .ini file that is being read, and the place in it
    Namer input_by_, output_by_;
    bool is_own_ini_ = false, is_trusted_ini_ = false;
    int depth_ = 0, ini_files_ = 0;
    std::string input_, output_;
    Animation animation_;
    PartOfSide columns_, rows_;
    int jpeg_quality_ = 85;  // POV-Ray's default, measured
    std::vector<std::string> folders_;
    int width_ = 320, height_ = 240;
    bool antialias_ = false, writes_ = true;
    double threshold_ = 0.3;
    int depth_of_samples_ = 3;
};

}  // namespace

bool IniFiles::exists(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

std::string IniFiles::read(const std::string& path, bool is_users) {
    std::string why;
    TextReader reader;
    const auto file = reader.open(path, {.is_users = is_users}, why);
    if (!file) throw Failure(k_bad_input, fmt::format("{}: {}", path, why));
    return std::string(file->text());
}

DropIn povray_drop_in(const std::vector<std::string>& arguments, IniFiles& files) {
    return PovrayArguments(files).parse(arguments);
}

DropIn povray_drop_in(const std::vector<std::string>& arguments) {
    IniFiles files;
    return povray_drop_in(arguments, files);
}

}  // namespace glint::cli
