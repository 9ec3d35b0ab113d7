// SPDX-License-Identifier: Apache-2.0
// .ply: Stanford's polygon files, as text or binary. docs/formats/ply.md.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "base/text.h"
#include "formats/mesh_file.h"
#include "formats/ply_columns.h"
#include "formats/ply_header.h"
#include "formats/ply_numbers.h"
#include "formats/registry.h"

namespace glint {
namespace {

// Whether every number of the type is one of single precision.
bool is_single(PlyType type) {
    return type != PlyType::float64 && type != PlyType::int32 && type != PlyType::uint32;
}

// Of a number from 0 to 2^32 - 1.
bool is_whole(double x) { return x == static_cast<double>(static_cast<std::uint32_t>(x)); }

template <class Numbers> class PlyBody {
  public:
    PlyBody(LoadState& reading, InputText where, const PlyHeader& header)
        : reading_(reading),
          where_(where),
          header_(header),
          numbers_(where.text, header.end, header.coding) {}
    ~PlyBody() { reading_.memory.remove(held_); }  // from now on the scene's
    PlyBody(const PlyBody&) = delete;
    PlyBody& operator=(const PlyBody&) = delete;

    std::shared_ptr<const MeshData> read() {
        for (const PlyElement& element : header_.elements) {
            if (!read(element)) return nullptr;
        }
        if (mesh_->triangles.empty()) {
            error_at(0, 3,
                     is_cloud() ? "no faces: a cloud of points has no surface to render"
                                : "no face with three vertices");
            return nullptr;
        }
        if (small_faces_ > 0) {
            reading_.diagnostics.warn(
                where_, 0, 3,
                fmt::format("{} faces with fewer than three vertices are left out", small_faces_));
        }
        return std::move(mesh_);
    }

  private:
    bool is_cloud() const {
        return std::none_of(header_.elements.begin(), header_.elements.end(),
                            [](const PlyElement& e) { return e.name == "face" && e.count > 0; });
    }
    void error_at(std::size_t offset, std::size_t length, std::string message) {
        reading_.diagnostics.error(where_, offset, length, std::move(message));
    }
    bool fail(std::string message) {
        // Lines of binary numbers mean nothing: the error has the place of the element in the header.
        if constexpr (std::is_same_v<Numbers, PlyText>) {
            const std::size_t length = std::max<std::size_t>(numbers_.found().size(), 1);
            error_at(numbers_.start(), length, fmt::format("{} {}: {}", element_->name, index_, message));
        } else {
            error_at(element_->offset, element_->length,
                     fmt::format("byte {}, {} {}: {}", numbers_.offset(), element_->name, index_, message));
        }
        return false;
    }
    bool number(PlyType type, double& value) {
        if (numbers_.next(type, value)) return true;
        if constexpr (std::is_same_v<Numbers, PlyText>) {
            if (!numbers_.found().empty())
                return fail("expected a number, found " + quoted(numbers_.found()));
        }
        return fail("the file ends here");
    }
    // The length of a list.
    bool length(const PlyProperty& list, double& count) {
        if (!number(*list.count_type, count)) return false;
        if (count >= 0 && count <= k_max_corners && is_whole(count)) return true;
        return fail(fmt::format("expected a list of 0 to {} numbers, found {}", k_max_corners, count));
    }
    bool skip(const PlyProperty& p) {
        double value = 0, count = 1;
        if (p.count_type && !length(p, count)) return false;
        for (; count > 0; --count) {
            if (!number(p.type, value)) return false;
        }
        return true;
    }
    // Called for each element: whether to go on.
    bool goes_on() { return index_ % 65536 != 0 || reading_.diagnostics.go_on(where_, numbers_.offset()); }

    bool read(const PlyElement& element) {
        element_ = &element;
        index_ = 0;
        const std::size_t least = element.least_bytes(header_.coding);
        const std::size_t rest = where_.text.size() - std::min(numbers_.offset(), where_.text.size());
        // The last number of a text needs no blank after it.
        const std::uint64_t room = least == 0 ? 0 : (rest + 1) / least;
        if (least > 0 && element.count > room) {
            error_at(element.offset, element.length,
                     fmt::format("expected {} times `{}`, found a file with room for {} at most",
                                 element.count, printable(element.name), room));
            return false;
        }
        if (least == 0) return true;
        if (element.name == "vertex") return read_vertices();
        if (element.name == "face") return read_faces();
        for (; index_ < element.count && goes_on(); ++index_) {
            for (const PlyProperty& p : element.properties) {
                if (!skip(p)) return false;
            }
        }
        return !reading_.diagnostics.full();
    }

    template <class Item> bool reserve(std::vector<Item>& list, std::size_t count) {
        const std::uint64_t bytes = MemoryBudget::list_bytes(count, sizeof(Item));
        if (!reading_.has_room(bytes, where_, element_->offset, element_->length)) return false;
        reading_.memory.add(bytes);
        held_ += bytes;
        list.reserve(count);
        return true;
    }

    bool read_vertices() {
        const auto count = static_cast<std::size_t>(element_->count);
        if (count >= k_none) {
            error_at(element_->offset, element_->length, "expected fewer than 4294967295 vertices");
            return false;
        }
        bool single = true;
        for (const char* const name : {"x", "y", "z"}) {
            const PlyProperty* const p = element_->find(name);
            if (p == nullptr || p->count_type) {
                error_at(element_->offset, element_->length,
                         fmt::format("expected the properties x, y and z of a vertex, found no {}", name));
                return false;
            }
            single = single && is_single(p->type);
        }
        const bool has_normals = element_->find("nx") != nullptr && element_->find("ny") != nullptr &&
                                 element_->find("nz") != nullptr;
        const bool is_colored = has_colors(*element_);
        const bool is_textured = has_columns(*element_, k_texture_column, k_ply_columns);
        MeshData& mesh = *mesh_;
        if (!(single ? reserve(mesh.single_positions, count) : reserve(mesh.positions, count)) ||
            (has_normals && !reserve(mesh.normals.values, count)) ||
            (is_colored && !reserve(mesh.colors.values, count)) ||
            (is_textured && !reserve(mesh.texture_coordinates.values, count))) {
            return false;
        }
        const std::vector<int> columns = columns_of(*element_);
        for (; index_ < count && goes_on(); ++index_) {
            double v[k_ply_columns] = {};
            for (std::size_t i = 0; i < columns.size(); ++i) {
                if (!read_column(element_->properties[i], columns[i], v)) return false;
            }
            if (single) {
                mesh.single_positions.push_back(single_of(v));
            } else {
                mesh.positions.push_back({v[0], v[1], v[2]});
            }
            if (has_normals) mesh.normals.values.push_back(single_of(v + k_normal_column));
            if (is_colored) mesh.colors.values.push_back(single_of(v + k_color_column));
            if (is_textured)
                mesh.texture_coordinates.values.push_back({static_cast<float>(v[k_texture_column]),
                                                           static_cast<float>(v[k_texture_column + 1]), 0});
        }
        return !reading_.diagnostics.full();
    }
    // Reads or skips a property.
    bool read_column(const PlyProperty& p, int column, double (&values)[k_ply_columns]) {
        if (p.count_type) return skip(p);
        double value = 0;
        if (!number(p.type, value)) return false;
        if (column >= k_color_column && column < k_texture_column) {
            value /= full_channel(p.type);
            if (!k_not_negative.contains(value))
                return fail(fmt::format("expected a color of at least 0, found {}", value));
        }
        if (column >= 0 && !k_coordinate.contains(value))
            return fail(fmt::format("expected {}, found {}", k_coordinate.text, value));
        if (column >= 0) values[column] = value;
        return true;
    }
    static Float3 single_of(const double* v) {
        return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
    }

    bool read_faces() {
        const PlyProperty* corners = element_->find("vertex_indices");
        if (corners == nullptr) corners = element_->find("vertex_index");
        if (corners == nullptr || !corners->count_type) {
            error_at(element_->offset, element_->length,
                     "expected the list `vertex_indices` of a face, found none");
            return false;
        }
        std::uint64_t vertices = 0;
        bool is_colored = has_colors(*element_);
        for (const PlyElement& e : header_.elements) {
            if (e.name != "vertex") continue;
            vertices = e.count;
            if (has_colors(e)) is_colored = false;  // those of the vertices are finer
        }
        const auto count = static_cast<std::size_t>(element_->count);
        if (!reserve(mesh_->triangles, count)) return false;
        if (is_colored && (!reserve(mesh_->colors.values, count) || !reserve(mesh_->colors.corners, count)))
            return false;
        const std::vector<int> columns = columns_of(*element_);
        for (; index_ < count && goes_on(); ++index_) {
            double v[k_ply_columns] = {};
            for (std::size_t i = 0; i < columns.size(); ++i) {
                const PlyProperty& p = element_->properties[i];
                if (&p == corners ? !read_face(p, vertices) : !read_column(p, columns[i], v)) return false;
            }
            if (is_colored) add_face_color(single_of(v + k_color_column));
        }
        return !reading_.diagnostics.full();
    }

    // Of the triangles since the last one that has a color. Neighbours often have the same.
    void add_face_color(const Float3& color) {
        CornerValues& colors = mesh_->colors;
        if (colors.empty() || colors.values.back() != color) colors.values.push_back(color);
        const auto number = static_cast<std::uint32_t>(colors.values.size() - 1);
        colors.corners.resize(mesh_->triangles.size(), {number, number, number});
    }

    // A face with more than three corners becomes triangles that have its first corner in common.
    bool read_face(const PlyProperty& corners, std::uint64_t vertices) {
        double count = 0;
        if (!length(corners, count)) return false;
        std::uint32_t first = 0, before = 0;
        const std::size_t more =
            mesh_->triangles.size() + (count > 2 ? static_cast<std::size_t>(count) - 2 : 0);
        if (more > mesh_->triangles.capacity() &&
            !reserve(mesh_->triangles, std::max(more, 2 * mesh_->triangles.capacity())))
            return false;
        for (int i = 0; i < static_cast<int>(count); ++i) {
            double value = 0;
            if (!number(corners.type, value)) return false;
            if (!(value >= 0 && value < static_cast<double>(vertices)) || !is_whole(value))
                return fail(fmt::format("expected a vertex from 0 to {}, found {}",
                                        static_cast<std::int64_t>(vertices) - 1, value));
            const auto corner = static_cast<std::uint32_t>(value);
            if (i == 0) first = corner;
            if (i >= 2) mesh_->triangles.push_back({first, before, corner});
            before = corner;
        }
        small_faces_ += count < 3 ? 1 : 0;
        return true;
    }

    static constexpr double k_max_corners = 1e6;
    LoadState& reading_;
    InputText where_;
    const PlyHeader& header_;
    Numbers numbers_;
    const PlyElement* element_ = nullptr;
    std::uint64_t index_ = 0;  // of the element's
    std::uint64_t small_faces_ = 0;
    std::uint64_t held_ = 0;  // bytes of the mesh that the budget counts
    std::shared_ptr<MeshData> mesh_ = std::make_shared<MeshData>();
};

}  // namespace

std::shared_ptr<const MeshData> read_ply_mesh(LoadState& reading, InputText where) {
    static_assert(std::endian::native == std::endian::little);
    const std::optional<PlyHeader> header = read_ply_header(reading, where);
    if (!header) return nullptr;
    if (header->coding == PlyCoding::ascii) return PlyBody<PlyText>(reading, where, *header).read();
    return PlyBody<PlyBinary>(reading, where, *header).read();
}

void read_ply(LoadState& reading, const ReadText& text) { read_mesh_text(reading, text, read_ply_mesh); }

}  // namespace glint
