// SPDX-License-Identifier: Apache-2.0
#pragma once
// The materials of glint's own language: by name, in place, and from one another.
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "formats/glint_text.h"
#include "scene/material_fields.h"

namespace glint {

/// The keys of a material: first the coefficients, then the fields.
inline constexpr int k_coefficients = static_cast<int>(std::size(k_material_coefficients));
inline constexpr auto k_material_keys = [] {
    std::array<Field, k_coefficients + std::size(k_material_fields)> keys{};
    auto* key = keys.data();
    for (const MaterialCoefficient& c : k_material_coefficients) *key++ = {c.key};
    for (const ItemField<Material>& f : k_material_fields) *key++ = {f.key};
    return keys;
}();

/// What a text says of a surface: the keys given, and nothing of the others.
struct MaterialKeys {
    std::uint64_t given = 0;  ///< a bit a key
    Material fields;
    std::array<double, k_coefficients> coefficients = [] {
        std::array<double, k_coefficients> usual{};
        for (int i = 0; i < k_coefficients; ++i) usual[i] = k_material_coefficients[i].usual;
        return usual;
    }();

    bool has(std::size_t key) const { return (given >> key & 1u) != 0; }
    bool has_field(std::size_t field) const { return has(k_coefficients + field); }
};

/// What people of other languages write.
std::span<const SpellingHint> material_hints();

/// Reads the value of one of those keys.
bool read_material_key(GlintText& t, int key, MaterialKeys& keys);

/// One for all .glint texts of a load. Materials are indices into Scene::materials; a name may be used before
/// it is defined, and then has its index already.
class GlintMaterials {
  public:
    /// The table of this load, made when first asked for.
    static GlintMaterials& of(LoadState& reading);

    /// The material that the text names at `name`.
    std::uint32_t named(GlintText& t, const Token& name);

    /// `material NAME { keys }`. A second one of the name is an error.
    void define(GlintText& t, const Token& word, const Token& name, const MaterialKeys& keys);

    /// The material `base` (k_none: the default one) with some keys changed. is_shared: equal ones are one.
    std::uint32_t changed(GlintText& t, const Token& word, std::uint32_t base, const MaterialKeys& keys,
                          bool is_shared);

    /// After the last text: what was used before it was defined, and what never was.
    void finish(LoadState& reading);

  private:
    struct Use {
        std::uint32_t index = 0;
        InputText place;
        Token token;
    };
    struct Change {
        std::uint32_t index, base;
        MaterialKeys keys;
    };
    /// By the bits of their materials.
    struct Less {
        const std::vector<Material>* materials;
        bool operator()(std::uint32_t a, std::uint32_t b) const;
    };

    /// What a Material does not say of the keys it was made of. There may be millions of materials.
    struct Origin {
        std::uint64_t given = 0;
        std::array<double, k_coefficients> coefficients{};
    };

    explicit GlintMaterials(Scene& scene) : scene_(scene), unnamed_(Less{&scene.materials}) {}
    std::uint32_t add(const GlintText& t, const Token& at, const Material& material);
    void keep_origin(std::uint32_t index, const MaterialKeys& keys);
    MaterialKeys keys_of(std::uint32_t index) const;

    Scene& scene_;
    std::map<std::string, Use, std::less<>> undefined_;  // names used and not defined yet
    std::set<std::uint32_t> unknown_;                    // materials that depend on them
    std::vector<Change> changes_;                        // of those
    std::unordered_map<std::uint32_t, Origin> origins_;
    std::set<std::uint32_t, Less> unnamed_;  // those that may be shared
    std::string last_name_;
    std::uint32_t last_index_ = k_none;
};

}  // namespace glint
