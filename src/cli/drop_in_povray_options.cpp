// SPDX-License-Identifier: Apache-2.0
// What each of POV-Ray's options says.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "cli/drop_in_povray.h"
#include "cli/drop_in_words.h"
#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/text.h"
#include "formats/number_text.h"
#include "os/files.h"

namespace glint::cli {
namespace {

constexpr double k_max_frame = 1e6;

std::optional<bool> truth(const std::string& text) {
    std::string lower;
    for (const char c : text) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (lower == "on" || lower == "true" || lower == "yes" || lower == "1") return true;
    if (lower == "off" || lower == "false" || lower == "no" || lower == "0") return false;
    return std::nullopt;
}

}  // namespace

void PovrayOptions::fail(const std::string& message) const {
    throw Failure(k_usage, place.text.empty() ? message : fmt::format("{}: {}", place.text, message));
}

void PovrayOptions::warn(const std::string& message) {
    parsed_.warnings.push_back(place.text.empty() ? message : fmt::format("{}: {}", place.text, message));
}

PovrayOptions::Namer PovrayOptions::namer() const {
    return place.is_trusted ? Namer() : Namer{place.text, os::folder_of(place.file)};
}

void PovrayOptions::set_input(const std::string& name) {
    input_ = name;
    input_by_ = namer();
    parsed_.render.scene.is_named_by_file = !place.text.empty();
}

void PovrayOptions::set(const PovraySwitch& known, const std::string& value, const std::string& word) {
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

void PovrayOptions::set(PovrayKey key, const std::string& value, bool on, const std::string& word) {
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
            if (on) warn(fmt::format("{} has no effect: glint renders whole frames", glint::quoted(word)));
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

double PovrayOptions::number(const std::string& value, const std::string& word, double most) const {
    double result = 0;
    const char* const end = value.data() + value.size();
    if (value.empty() || read_any_number(value.data(), end, result) != end ||
        !(result >= 0 && result <= most))
        fail(fmt::format("{}: expected a number from 0 to {}", glint::quoted(word), most));
    return result;
}

double PovrayOptions::any_number(const std::string& value, const std::string& word) const {
    double number = 0;
    const char* const end = value.data() + value.size();
    if (value.empty() || read_any_number(value.data(), end, number) != end ||
        !(number >= -1e12 && number <= 1e12))
        fail(fmt::format("{}: expected a number", glint::quoted(word)));
    return number;
}

// A number that the scene finds declared.
void PovrayOptions::declare(const std::string& name, const std::string& value, const std::string& word) {
    const double number = any_number(value, word);
    auto& declared = parsed_.render.scene.declared;
    std::erase_if(declared, [&](const auto& d) { return d.first == name; });
    declared.emplace_back(name, number);
}

// N8, N16, T, P, E, J, B; the bits follow the letter.
void PovrayOptions::set_file_type(const std::string& value, const std::string& word) {
    if (value.empty()) return;
    NumberArguments& numbers = parsed_.render.numbers;
    const char type = value[0] >= 'a' ? static_cast<char>(value[0] - 'a' + 'A') : value[0];
    std::string rest = value.substr(1);
    if (!rest.empty() && (rest[0] == 'G' || rest[0] == 'g'))
        fail(fmt::format("{}: glint-povray writes colors only", glint::quoted(word)));
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
            fail(
                fmt::format("{}: glint-povray writes N (PNG), T (TGA), P (PPM), E (OpenEXR), J (JPEG) and "
                            "B (BMP)",
                            glint::quoted(word)));
    }
    if (!rest.empty()) numbers.bits = number(rest, word, 16) > 8 ? 16 : 8;
}

void PovrayOptions::set_quality(double quality) {
    auto& settings = parsed_.render.scene.settings;
    std::erase_if(settings, [](const auto& s) { return s.first == "shading" || s.first == "shadows"; });
    if (quality <= 1) settings.emplace_back("shading", "color");
    if (quality <= 3) settings.emplace_back("shadows", "false");
}

}  // namespace glint::cli
