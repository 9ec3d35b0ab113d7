// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a scene has and glTF has not.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "glint/diagnostic.h"

namespace glint::gltf_export {

class Losses {
  public:
    /// kind: "ambient lights"; done: "they are left out". Both are views of static text.
    void add(std::string_view kind, std::string_view done);
    /// One warning for each kind, with the number of things; file: the name of the scene, or empty.
    std::vector<Diagnostic> warnings(const std::string& file) const;

  private:
    struct Kind {
        std::string_view name, done;
        std::uint32_t count = 0;
    };
    std::vector<Kind> kinds_;
};

}  // namespace glint::gltf_export
