// SPDX-License-Identifier: Apache-2.0
#pragma once
// The materials of .glint: named, in a shape's block, and derived from others.
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

/// The keys that a text gives for a surface. Others are unset.
struct MaterialKeys {
    std::uint64_t given = 0;  ///< one bit per key
    Material fields;
    std::array<double, k_coefficients> coefficients = [] {
        std::array<double, k_coefficients> usual{};
        for (int i = 0; i < k_coefficients; ++i) usual[i] = k_material_coefficients[i].usual;
        return usual;
    }();

    bool has(std::size_t key) const { return (given >> key & 1u) != 0; }
    bool has_field(std::size_t field) const { return has(k_coefficients + field); }
};

/// Spelling hints for the keys of other languages.
std::span<const SpellingHint> material_hints();

/// Reads the value of one of those keys.
bool read_material_key(GlintText& t, int key, MaterialKeys& keys);

/// The materials of all .glint texts of a load, as indices in Scene::materials. A name may be used before it
/// is defined; it gets its index at the first use.
class GlintMaterials {
  public:
    /// The table of this load, created at the first call.
    static GlintMaterials& of(LoadState& reading);

    /// The material with the name in token `name`.
    std::uint32_t named(GlintText& t, const Token& name);

    /// `material NAME { keys }`. A second definition of a name is an error.
    void define(GlintText& t, const Token& word, const Token& name, const MaterialKeys& keys);

    /// The material `base` (k_none: the default) with some keys changed. is_shared: equal materials get one
    /// index.
    std::uint32_t changed(GlintText& t, const Token& word, std::uint32_t base, const MaterialKeys& keys,
                          bool is_shared);

    /// After the last text: resolves names that were used before their definition, and reports undefined
    /// ones.
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
    /// Orders materials by their bits.
    struct Less {
        const std::vector<Material>* materials;
        bool operator()(std::uint32_t a, std::uint32_t b) const;
    };

    /// The keys that a material was made of and that cannot be derived from it. There may be millions of
    /// materials.
    struct Origin {
        std::uint64_t given = 0;
        std::array<double, k_coefficients> coefficients{};
    };

    explicit GlintMaterials(Scene& scene) : scene_(scene), unnamed_(Less{&scene.materials}) {}
    std::uint32_t add(const GlintText& t, const Token& at, const Material& material);
    void keep_origin(std::uint32_t index, const MaterialKeys& keys);
    MaterialKeys keys_of(std::uint32_t index) const;

    Scene& scene_;
    CountedMap<std::string, Use> undefined_;  // names used and not defined yet
    // Materials that depend on undefined names.
    std::set<std::uint32_t, std::less<>, Counted<std::uint32_t>> unknown_;
    CountedVector<Change> changes_;                                       // of these materials
    std::set<std::uint32_t, std::less<>, Counted<std::uint32_t>> bases_;  // of other materials
    CountedHashMap<std::uint32_t, Origin> origins_;
    std::set<std::uint32_t, Less, Counted<std::uint32_t>> unnamed_;  // materials that may be shared
    std::string last_name_;
    std::uint32_t last_index_ = k_none;
};

}  // namespace glint
