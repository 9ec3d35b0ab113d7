// SPDX-License-Identifier: Apache-2.0
#pragma once
// The shapes and materials of an .obj that is a scene.
#include <cstdint>

#include "formats/load_state.h"
#include "formats/mtl.h"
#include "formats/obj_data.h"

namespace glint {

class ObjShapes {
  public:
    /// is_library_missing: an .mtl could not be read, which has been reported.
    ObjShapes(ObjData& data, const MtlMaterials& materials, bool is_library_missing, LoadState& reading,
              const ReadText& text)
        : data_(data),
          materials_(materials),
          is_library_missing_(is_library_missing),
          reading_(reading),
          text_(text) {}

    /// Adds a shape for each part, and the materials that they have.
    void add();

  private:
    std::uint32_t add_material(const ObjPart& part);
    bool go_on() { return reading_.diagnostics.go_on(text_.place, text_.place.text.size()); }

    ObjData& data_;
    const MtlMaterials& materials_;
    const bool is_library_missing_;
    LoadState& reading_;
    const ReadText& text_;
    const ObjPart* first_undefined_ = nullptr;  // whose material no .mtl has
    std::size_t undefined_ = 0;
};

}  // namespace glint
