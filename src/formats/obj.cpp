// SPDX-License-Identifier: Apache-2.0
// .obj: Wavefront's meshes. docs/formats/obj.md.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "formats/include.h"
#include "formats/line_reader.h"
#include "formats/mesh_file.h"
#include "formats/mtl.h"
#include "formats/obj_data.h"
#include "formats/obj_index.h"
#include "formats/obj_shapes.h"
#include "formats/registry.h"
#include "scene/ranges.h"

namespace glint {
namespace {

constexpr std::size_t k_max_face_corners = 1'000'000;
constexpr std::size_t k_max_library_names = 1000;  // each may be looked for in several folders

// What has no surface, and the statements that belong to it.
constexpr std::string_view k_curves[] = {"p",    "l",    "curv", "curv2", "surf", "parm", "trim",
                                         "hole", "scrv", "sp",   "end",   "con",  "vp",   "cstype",
                                         "deg",  "bmat", "step", "stech", "ctech"};

class ObjReader : LineReader {
  public:
    /// is_one_mesh: without materials.
    ObjReader(LoadState& reading, const ReadText& text, bool is_one_mesh)
        : LineReader(reading, text.place, LineWords::Syntax::wavefront, "line"),
          text_(text),
          is_one_mesh_(is_one_mesh) {}

    std::shared_ptr<const MeshData> read_mesh() {
        return read() ? ObjMeshes(data_, reading_, where_).make(data_.parts[0]) : nullptr;
    }
    void read_scene() {
        if (read()) ObjShapes(data_, materials_, is_library_missing_, reading_, text_).add();
    }

  private:
    bool read() {
        const std::uint32_t errors = reading_.diagnostics.error_count();
        while (words_.next_line()) {
            const std::string_view word = words_.next();
            if (!word.empty()) statement(word);
            if (++work_ >= 16384 && !go_on()) return false;
        }
        if (reading_.diagnostics.error_count() > errors) return false;
        if (!vertex_numbers_.check(data_.positions.size(), "vertex", reading_, where_)) return false;
        if (!normal_numbers_.check(data_.normals.size(), "normal", reading_, where_)) return false;
        if (data_.texture_coordinates.size() >= CornerValues::k_none ||
            texture_numbers_.exceed(data_.texture_coordinates.size()))
            drop_missing_places();
        if (data_.parts.empty()) {
            reading_.diagnostics.error(where_, 0, 1, "no faces with three vertices");
            return false;
        }
        if (small_faces_ > 0) {
            reading_.diagnostics.warn(
                where_, 0, 1,
                fmt::format("{} faces with fewer than three vertices are left out", small_faces_));
        }
        return go_on() && smooth_groups(data_, reading_, where_);
    }
    // Faces without all of their places in textures have none.
    void drop_missing_places() {
        constexpr std::uint32_t none = CornerValues::k_none;
        const std::size_t count = data_.texture_coordinates.size();
        for (ObjPart& part : data_.parts) {
            for (TriangleCorners& t : part.textures) {
                if (std::any_of(t.begin(), t.end(), [&](std::uint32_t n) { return n >= count; }))
                    t = {none, none, none};
            }
        }
    }
    bool go_on() {
        work_ = 0;
        return reading_.diagnostics.go_on(where_, words_.offset());
    }

    void statement(std::string_view word) {
        if (word == "v") return read_vertex();
        if (word == "vn") return read_normal();
        if (word == "f" || word == "fo") return read_face();
        if (word == "vt") return read_texture_coordinates();
        if (word == "usemtl") return use_material();
        if (word == "mtllib") return read_libraries();
        if (word == "s") return read_group();
        if (word == "o") {
            object_name_ = std::string(words_.rest());
        } else if (word == "g") {
            group_name_ = std::string(words_.rest());
        } else if (std::find(std::begin(k_curves), std::end(k_curves), word) != std::end(k_curves)) {
            warn_once("obj curves", "glint draws no points, lines, curves and curved surfaces of .obj files");
        } else {
            warn_once("obj other", fmt::format("glint ignores {}, and other statements that it does not know",
                                               quoted(word)));
        }
    }

    bool number(double& value, const Range& range) {
        words_.next();
        return (read_number_word(words_.found(), value) && range.contains(value)) || expected(range.text);
    }
    bool point(Vec3& p) {
        return number(p.x, k_coordinate) && number(p.y, k_coordinate) && number(p.z, k_coordinate);
    }

    // x y z, and a weight, which is not used, or a color.
    void read_vertex() {
        Vec3 p, color;
        if (!point(p)) return;
        double* const channels[] = {&color.x, &color.y, &color.z};
        std::size_t count = 0;
        for (; count < 3 && !words_.next().empty(); ++count) {
            double& channel = *channels[count];
            if (!read_number_word(words_.found(), channel) || !k_not_negative.contains(channel)) {
                expected(k_not_negative.text);
                return;
            }
        }
        data_.is_single =
            data_.is_single && is_single_number(p.x) && is_single_number(p.y) && is_single_number(p.z);
        data_.positions.push_back(p);
        if (count < 3) return;
        data_.vertex_colors.resize(data_.positions.size() - 1, ObjData::k_no_color);
        data_.vertex_colors.push_back(to_single(color));
    }
    void read_normal() {
        Vec3 n;
        if (point(n)) data_.normals.push_back(to_single(n));
    }

    // u, and v and a depth if they are there.
    void read_texture_coordinates() {
        double u = 0, v = 0;
        if (!number(u, k_coordinate)) return;
        if (!words_.next().empty() && (!read_number_word(words_.found(), v) || !k_coordinate.contains(v))) {
            expected(k_coordinate.text);
            return;
        }
        data_.texture_coordinates.push_back(to_single({u, v, 0}));
    }

    // A face with more than three corners becomes triangles that have its first corner in common. Normals and
    // texture coordinates count if each corner has them.
    void read_face() {
        face_.clear();
        bool has_normals = true, has_textures = true;
        while (!words_.next().empty()) {
            ObjCorner corner;
            if (!read_corner(corner)) return;
            if (face_.size() == k_max_face_corners) {
                error(fmt::format("more than {} corners of a face", k_max_face_corners));
                return;
            }
            has_normals = has_normals && corner.normal != CornerValues::k_none;
            has_textures = has_textures && corner.texture != CornerValues::k_none;
            face_.push_back(corner);
        }
        if (face_.size() < 3) {
            ++small_faces_;
            return;
        }
        work_ += face_.size() / 8;
        ObjPart& part = part_of_face();
        for (std::size_t i = 2; i < face_.size(); ++i) {
            const ObjCorner &a = face_[0], &b = face_[i - 1], &c = face_[i];
            part.triangles.push_back({a.vertex, b.vertex, c.vertex});
            if (has_textures) {
                constexpr std::uint32_t none = CornerValues::k_none;
                part.textures.resize(part.triangles.size() - 1, {none, none, none});
                part.textures.push_back({a.texture, b.texture, c.texture});
            }
            if (!has_normals && group_ == 0) continue;
            part.normals.resize(part.triangles.size() - 1, {CornerValues::k_none, 0, 0});
            part.normals.push_back(has_normals ? TriangleCorners{a.normal, b.normal, c.normal}
                                               : TriangleCorners{CornerValues::k_none, group_, 0});
        }
    }
    bool read_corner(ObjCorner& corner) {
        ObjIndices indices;
        if (!read_obj_indices(words_.found(), indices))
            return expected("a corner, as `1`, `1/2`, `1//3` or `1/2/3`, of numbers that are not 0");
        const std::size_t vertices = data_.positions.size(), normals = data_.normals.size();
        if (!vertex_numbers_.resolve(indices.vertex, vertices, words_, corner.vertex))
            return too_negative("vertex", vertices);
        // Textures are not what makes a mesh: a number of a `vt` that is not there is none.
        if (indices.texture != 0)
            (void)texture_numbers_.resolve(indices.texture, data_.texture_coordinates.size(), words_,
                                           corner.texture);
        return indices.normal == 0 ||
               normal_numbers_.resolve(indices.normal, normals, words_, corner.normal) ||
               too_negative("normal", normals);
    }
    bool too_negative(std::string_view what, std::size_t count) {
        return error(
            fmt::format("expected the number of a {} before this line, of which there are {}, found {}", what,
                        count, quoted(words_.found())));
    }

    ObjPart& part_of_face() {
        if (part_ == k_none) {
            const auto [found, is_new] =
                part_numbers_.try_emplace(material_, static_cast<std::uint32_t>(data_.parts.size()));
            part_ = found->second;
            if (is_new) {
                ObjPart part;
                part.material = material_;
                part.usemtl = usemtl_;
                part.usemtl_length = std::max<std::size_t>(material_.size(), 1);
                part.place = {words_.line(), 1, text_.file};
                part.name = name();
                data_.parts.push_back(std::move(part));
            }
        }
        ObjPart& part = data_.parts[part_];
        if (!part.name.empty() && part.name != name()) part.name.clear();
        return part;
    }
    const std::string& name() const { return object_name_.empty() ? group_name_ : object_name_; }

    void use_material() {
        if (words_.rest().empty()) {
            expected("the name of a material");
        } else if (!is_one_mesh_) {
            material_ = std::string(words_.found());
            usemtl_ = words_.start();
            part_ = k_none;
        }
    }

    // Groups are numbered in the order of their first use, from 1.
    void read_group() {
        const std::string_view word = words_.next();
        if (word.empty()) {
            expected("a smoothing group, or `off`");
        } else if (word == "off" || word.find_first_not_of('0') == std::string_view::npos) {
            group_ = 0;
        } else {
            const auto next = static_cast<std::uint32_t>(groups_.size() + 1);
            group_ = groups_.try_emplace(std::string(word), next).first->second;
        }
    }

    // No file with another name is opened.
    void read_libraries() {
        if (is_one_mesh_) return;
        const std::string_view names = words_.rest();
        if (names.empty()) expected("the name of a file");
        for (const std::string_view name : library_names(names)) {
            if (++library_names_ > k_max_library_names) {
                warn_once("obj libraries",
                          fmt::format("only the first {} .mtl files are read", k_max_library_names));
                return;
            }
            const std::size_t at = words_.start() + static_cast<std::size_t>(name.data() - names.data());
            if (name.ends_with(k_mtl_extension)) {
                read_library(std::string(name), at);
            } else {
                reading_.diagnostics.warn(
                    where_, at, name.size(),
                    fmt::format("{}: expected the name of a file that ends in .mtl", quoted(name)));
            }
        }
    }
    void read_library(const std::string& name, std::size_t at) {
        Token token;
        token.offset = at;
        token.length = name.size();
        const auto library =
            open_optional_text(reading_, text_, token, name, "its materials are glint's default one");
        if (!library) {
            is_library_missing_ = true;
        } else if (libraries_.try_emplace(library->file).second) {
            read_mtl(reading_, *library, materials_);
        }
    }

    const ReadText& text_;
    const bool is_one_mesh_;
    ObjData data_;
    ObjNumbers vertex_numbers_, normal_numbers_, texture_numbers_;
    CountedVector<ObjCorner> face_;
    std::uint64_t small_faces_ = 0, work_ = 0;
    std::string object_name_, group_name_, material_;
    std::size_t usemtl_ = 0;  // offset of the name of the material
    std::uint32_t part_ = k_none, group_ = 0;
    CountedMap<std::string, std::uint32_t> part_numbers_, groups_;
    CountedMap<std::uint16_t, bool> libraries_;  // those that have been read
    MtlMaterials materials_;
    std::size_t library_names_ = 0;
    bool is_library_missing_ = false;
};

}  // namespace

std::shared_ptr<const MeshData> read_obj_mesh(LoadState& reading, InputText where) {
    return ObjReader(reading, ReadText{where}, true).read_mesh();
}

void read_obj(LoadState& reading, const ReadText& text) { ObjReader(reading, text, false).read_scene(); }

}  // namespace glint
