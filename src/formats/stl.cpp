// SPDX-License-Identifier: Apache-2.0
// .stl: triangles of 3D printing and CAD programs, as text or binary. docs/formats/stl.md.
#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "base/text.h"
#include "formats/line_reader.h"
#include "formats/merge_vertices.h"
#include "formats/mesh_file.h"
#include "formats/registry.h"
#include "formats/stl_colors.h"
#include "scene/ranges.h"

namespace glint {
namespace {

constexpr std::size_t k_stl_count = 80;  // offset of the number of triangles in a binary file
constexpr std::size_t k_stl_begin = 84, k_stl_triangle = 50, k_stl_attribute = 48;
constexpr std::uint64_t k_most_triangles = CornerValues::k_none / 3;

template <class T> T stl_number(std::string_view text, std::size_t offset) {
    T value;
    std::memcpy(&value, text.data() + offset, sizeof value);
    return value;
}

// lower: in lower case. Programs write keywords in either.
bool is_keyword(std::string_view word, std::string_view lower) {
    const auto equal = [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); };
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), equal);
}

// Binary files may begin with `solid`, too, but a text has their exact length only by accident.
bool is_stl_text(std::string_view text) {
    LineWords words(text, LineWords::Syntax::plain);
    if (!is_keyword(words.next_of_text(), "solid")) return false;
    return text.size() < k_stl_begin ||
           text.size() !=
               k_stl_begin + k_stl_triangle * std::uint64_t{stl_number<std::uint32_t>(text, k_stl_count)};
}

// A text: solids of facets. Their normals and names are not used.
class StlText : LineReader {
  public:
    StlText(LoadState& reading, InputText where)
        : LineReader(reading, where, LineWords::Syntax::plain, "file") {}

    std::shared_ptr<const MeshData> read() {
        while (!words_.next_of_text().empty()) {
            if (!read_solid()) return nullptr;
        }
        if (corners_.empty()) {
            error("no facets");
            return nullptr;
        }
        auto mesh = std::make_shared<MeshData>();
        const bool is_merged =
            is_single_ ? merge_vertices(corners_, mesh->single_positions, mesh->triangles, reading_, where_)
                       : merge_vertices(corners_, mesh->positions, mesh->triangles, reading_, where_);
        return is_merged ? mesh : nullptr;
    }

  private:
    bool expect(std::string_view keyword) {
        return is_keyword(words_.next_of_text(), keyword) || expected(fmt::format("`{}`", keyword));
    }

    bool read_solid() {
        if (!is_keyword(words_.found(), "solid")) return expected("`solid`");
        words_.rest();  // its name
        for (;;) {
            words_.next_of_text();
            if (is_keyword(words_.found(), "endsolid")) {
                words_.rest();
                return true;
            }
            if (!is_keyword(words_.found(), "facet")) return expected("`facet` or `endsolid`");
            if (!read_facet()) return false;
        }
    }
    bool read_facet() {
        if (!expect("normal")) return false;
        for (int i = 0; i < 3; ++i) words_.next_of_text();  // which may be anything
        if (!expect("outer") || !expect("loop")) return false;
        if (corners_.size() / 3 >= k_most_triangles) return error("too many facets");
        for (int i = 0; i < 3; ++i) {
            LooseCorner<double> c;
            if (!expect("vertex") || !number(c.x) || !number(c.y) || !number(c.z)) return false;
            c.index = static_cast<std::uint32_t>(corners_.size());
            corners_.push_back(c);
        }
        if (!expect("endloop") || !expect("endfacet")) return false;
        return corners_.size() % 49152 != 0 || reading_.diagnostics.go_on(where_, words_.offset());
    }
    bool number(double& value) {
        if (!read_number_word(words_.next_of_text(), value) || !k_coordinate.contains(value))
            return expected(k_coordinate.text);
        is_single_ = is_single_ && is_single_number(value);
        return true;
    }

    CountedVector<LooseCorner<double>> corners_;
    bool is_single_ = true;  // no number needs more than single precision
};

class StlBinary {
  public:
    StlBinary(LoadState& reading, InputText where) : reading_(reading), where_(where) {}

    std::shared_ptr<const MeshData> read() {
        const std::string_view text = where_.text;
        if (text.size() < k_stl_begin) {
            return error(
                "expected `solid`, the first word of a text, or a binary header of 84 bytes, found "
                "neither");
        }
        const std::size_t count = stl_number<std::uint32_t>(text, k_stl_count);
        const std::size_t room = (text.size() - k_stl_begin) / k_stl_triangle;
        if (count > room) {
            return error(fmt::format("byte {}: expected {} triangles, found a file with room for {}",
                                     k_stl_count, count, room));
        }
        if (count == 0) return error("no triangles");
        if (count > k_most_triangles)
            return error(fmt::format("expected {} triangles at most, found {}", k_most_triangles, count));
        if (const std::size_t end = k_stl_begin + k_stl_triangle * count; end < text.size()) {
            reading_.diagnostics.warn(
                where_, 0, 1, fmt::format("{} bytes after the last triangle are ignored", text.size() - end));
        }
        auto mesh = std::make_shared<MeshData>();
        return read_positions(count, *mesh) && read_colors(count, *mesh) ? mesh : nullptr;
    }

  private:
    // The numbers of a binary file have no lines: errors are at its begin, and name the byte.
    std::nullptr_t error(std::string message) {
        reading_.diagnostics.error(where_, 0, 1, std::move(message));
        return nullptr;
    }

    bool read_positions(std::size_t count, MeshData& mesh) {
        using Corner = LooseCorner<float>;
        if (!reading_.has_room(MemoryBudget::list_bytes(3 * count, sizeof(Corner)), where_, 0)) return false;
        CountedVector<Corner> corners;
        corners.reserve(3 * count);
        for (std::size_t i = 0; i < count; ++i) {
            std::size_t at = k_stl_begin + k_stl_triangle * i;
            if (i % 65536 == 0 && !reading_.diagnostics.go_on(where_, at)) return false;
            for (int k = 0; k < 3; ++k) {
                Corner c;
                c.index = static_cast<std::uint32_t>(corners.size());
                for (float* const number : {&c.x, &c.y, &c.z}) {
                    at += sizeof(float);  // the normal comes first
                    *number = stl_number<float>(where_.text, at + 2 * sizeof(float));
                    if (k_coordinate.contains(static_cast<double>(*number))) continue;
                    error(fmt::format("byte {}, triangle {}: expected {}, found {}", at + 2 * sizeof(float),
                                      i, k_coordinate.text, *number));
                    return false;
                }
                corners.push_back(c);
            }
        }
        return merge_vertices(corners, mesh.single_positions, mesh.triangles, reading_, where_);
    }

    bool read_colors(std::size_t count, MeshData& mesh) {
        const auto attribute = [&](std::size_t i) {
            return stl_number<std::uint16_t>(where_.text, k_stl_begin + k_stl_triangle * i + k_stl_attribute);
        };
        StlColors colors(where_.text.substr(0, k_stl_count));
        bool is_colored = colors.has_default();
        for (std::size_t i = 0; i < count && !is_colored; ++i) is_colored = colors.is_colored(attribute(i));
        if (!is_colored) return true;
        const std::uint64_t bytes = MemoryBudget::list_bytes(count, sizeof(TriangleCorners));
        if (!reading_.has_room(bytes, where_, 0)) return false;
        mesh.colors.corners.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t color = colors.number_of(attribute(i), mesh.colors.values);
            mesh.colors.corners.push_back({color, color, color});
        }
        return true;
    }

    LoadState& reading_;
    InputText where_;
};

}  // namespace

std::shared_ptr<const MeshData> read_stl_mesh(LoadState& reading, InputText where) {
    static_assert(std::endian::native == std::endian::little);
    return is_stl_text(where.text) ? StlText(reading, where).read() : StlBinary(reading, where).read();
}

void read_stl(LoadState& reading, const ReadText& text) { read_mesh_text(reading, text, read_stl_mesh); }

}  // namespace glint
