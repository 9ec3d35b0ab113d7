// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which module may include which: the arrows of docs/architecture.md, as data.
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glint::test {

struct Module {
    std::string_view name;
    std::set<std::string_view> sees;       ///< other modules of src/
    std::set<std::string_view> libraries;  ///< what a third-party or system include may begin with
    bool in_browser = true;                ///< compiled for WebAssembly too
};

/// The modules of src/.
const std::vector<Module>& modules();

/// One #include of a file, as written.
struct Include {
    int line = 0;
    std::string name;
    bool quoted = false;
};

/// The #include lines of a text.
std::vector<Include> find_includes(std::string_view text);

/// The error of an include in the file at `path` (relative to the project: "src/bvh/build.cpp"), or
/// nothing.
std::optional<std::string> check_include(std::string_view path, const Include& include);

/// The functions of libm that a text calls, by name: their bits differ between machines.
std::vector<std::string> find_libm_calls(std::string_view text);

/// The classes and enumerations that a text defines for other files, with their namespace
/// ("glint::Scene"), except those of unnamed namespaces and nested ones. The text must be formatted like
/// the project's.
std::vector<std::string> find_types(std::string_view text);

}  // namespace glint::test
