// SPDX-License-Identifier: Apache-2.0
#include "formats/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/text.h"

namespace glint {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr TypeName k_type_names[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};
constexpr std::string_view k_types =
    "char, uchar, short, ushort, int, uint, float, double, or int8 to float64";
// More are refused: no program writes so many, and each number of a file would look at all.
constexpr std::size_t k_max_elements = 256, k_max_properties = 256;

bool is_space(char c) { return c == ' ' || c == '\t'; }

// Reads lines and their words.
class HeaderReader {
  public:
    HeaderReader(LoadState& reading, InputText where) : reading_(reading), where_(where) {}

    std::optional<PlyHeader> read() {
        if (!next_line() || next_word() != "ply") return error("expected `ply` in the first line");
        if (!next_line() || next_word() != "format")
            return error("expected `format`, and `ascii`, `binary_little_endian` or `binary_big_endian`");
        if (!read_coding()) return std::nullopt;
        while (next_line()) {
            const std::string_view word = next_word();
            if (word == "end_header") {
                header_.end = next_;
                return std::move(header_);
            }
            if (word.empty() || word == "comment" || word == "obj_info") continue;
            if (word != "element" && word != "property")
                return error("expected `element`, `property`, `comment` or `end_header`, found " +
                             quoted(word));
            if (!(word == "element" ? read_element() : read_property())) return std::nullopt;
        }
        return error("the header has no end: expected `end_header`");
    }

  private:
    std::nullopt_t error(std::string message) {
        const std::size_t length = std::min<std::size_t>(line_.size(), 200);
        reading_.diagnostics.error(where_, start_, std::max<std::size_t>(length, 1), std::move(message));
        return std::nullopt;
    }

    // Lines end with LF, CR LF or CR. If the first one ends with CR, a LF after the last one is binary data.
    bool next_line() {
        const std::string_view text = where_.text;
        if (next_ >= text.size() || ++lines_ > 100000) return false;
        start_ = next_;
        const std::size_t end = std::min(text.find_first_of("\r\n", start_), text.size());
        line_ = text.substr(start_, end - start_);
        next_ = std::min(end + 1, text.size());
        const bool is_cr_lf = text.substr(end, 2) == "\r\n";
        if (lines_ == 1) ends_with_cr_ = !is_cr_lf && text.substr(end, 1) == "\r";
        if (is_cr_lf && !ends_with_cr_) ++next_;
        word_ = 0;
        return true;
    }

    std::string_view next_word() {
        while (word_ < line_.size() && is_space(line_[word_])) ++word_;
        const std::size_t begin = word_;
        while (word_ < line_.size() && !is_space(line_[word_])) ++word_;
        return line_.substr(begin, word_ - begin);
    }

    bool read_coding() {
        const std::string_view word = next_word();
        if (word == "binary_little_endian") {
            header_.coding = PlyCoding::little_endian;
        } else if (word == "binary_big_endian") {
            header_.coding = PlyCoding::big_endian;
        } else if (word != "ascii") {
            error("expected `ascii`, `binary_little_endian` or `binary_big_endian`, found " + quoted(word));
            return false;
        }
        if (next_word() == "1.0") return true;
        error("expected version 1.0");
        return false;
    }

    bool read_element() {
        PlyElement element{next_word()};
        const std::string_view count = next_word();
        const auto [end, code] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (element.name.empty() || code != std::errc() || end != count.data() + count.size()) {
            error("expected `element`, a name and a number");
            return false;
        }
        const auto is_same = [&](const PlyElement& e) { return e.name == element.name; };
        if ((element.name == "vertex" || element.name == "face") &&
            std::any_of(header_.elements.begin(), header_.elements.end(), is_same)) {
            error(fmt::format("expected one element `{}`, found a second one", element.name));
            return false;
        }
        if (header_.elements.size() >= k_max_elements) {
            error(fmt::format("more than {} elements", k_max_elements));
            return false;
        }
        element.offset = start_;
        element.length = std::max<std::size_t>(line_.size(), 1);
        header_.elements.push_back(std::move(element));
        return true;
    }

    bool read_type(PlyType& type) {
        const std::string_view word = next_word();
        for (const TypeName& known : k_type_names) {
            if (known.name != word) continue;
            type = known.type;
            return true;
        }
        error(fmt::format("expected a type ({}), found {}", k_types, quoted(word)));
        return false;
    }

    bool read_property() {
        if (header_.elements.empty()) {
            error("expected `element` before its first `property`");
            return false;
        }
        PlyProperty property;
        const std::size_t before = word_;
        if (next_word() == "list") {
            if (!read_type(property.count_type.emplace())) return false;
            if (*property.count_type == PlyType::float32 || *property.count_type == PlyType::float64) {
                error("expected a whole number as the length of a list");
                return false;
            }
        } else {
            word_ = before;
        }
        if (!read_type(property.type)) return false;
        property.name = next_word();
        if (property.name.empty()) {
            error("expected the name of the property");
            return false;
        }
        std::vector<PlyProperty>& all = header_.elements.back().properties;
        if (all.size() >= k_max_properties) {
            error(fmt::format("more than {} properties of an element", k_max_properties));
            return false;
        }
        all.push_back(property);
        return true;
    }

    LoadState& reading_;
    InputText where_;
    PlyHeader header_;
    std::string_view line_;
    bool ends_with_cr_ = false;
    std::size_t start_ = 0, next_ = 0, word_ = 0, lines_ = 0;
};

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 8;
}

std::size_t PlyElement::least_bytes(PlyCoding coding) const {
    std::size_t bytes = 0;
    for (const PlyProperty& p : properties) {
        // In text: a digit and a blank, or the end of the line.
        bytes += coding == PlyCoding::ascii ? 2 : size_of(p.count_type.value_or(p.type));
    }
    return bytes;
}

const PlyProperty* PlyElement::find(std::string_view property) const {
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [&](const PlyProperty& p) { return p.name == property; });
    return found == properties.end() ? nullptr : &*found;
}

std::optional<PlyHeader> read_ply_header(LoadState& reading, InputText where) {
    return HeaderReader(reading, where).read();
}

}  // namespace glint
