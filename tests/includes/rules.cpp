// SPDX-License-Identifier: Apache-2.0
#include "includes/rules.h"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

namespace glint::test {
namespace {

using Names = std::set<std::string_view>;

Names all_but(const Names& removed) {
    Names names;
    for (const std::string_view name :
         {"base",    "math",   "simd",    "scene", "formats", "geometry", "lighting", "bvh",
          "world",   "trace",  "explain", "check", "compare", "diagnose", "grade",    "image",
          "journal", "output", "os",      "cli",   "mpi",     "wasm",     "export"}) {
        if (!removed.contains(name)) names.insert(name);
    }
    return names;
}

// Headers of the standard library that libc++ 14 for wasm32-wasi lacks, or that need an operating system.
const Names k_not_in_browser = {"thread", "mutex",   "shared_mutex", "condition_variable",
                                "future", "fstream", "filesystem",   "source_location",
                                "ranges", "format"};
// Files that the browser build leaves out, or compiles without what they have of threads.
const Names k_with_threads = {"src/base/parallel_for_threads.cpp", "src/base/one_at_a_time.cpp"};
// The library never prints.
const Names k_printing = {"iostream", "print"};

bool starts_with_any(std::string_view name, const Names& prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](std::string_view p) { return name.starts_with(p); });
}

// <vector> or <cstdint>: a name without a dot or a slash.
bool is_standard(std::string_view name) {
    return std::all_of(name.begin(), name.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
}

std::string bracketed(std::string_view name) { return "<" + std::string(name) + ">"; }

std::optional<std::string> check_public(const Include& include) {
    if (include.name.starts_with("glint/")) return std::nullopt;
    if (!include.quoted && is_standard(include.name)) return std::nullopt;
    return "a public header includes only the standard library and glint/, not " + bracketed(include.name);
}

std::optional<std::string> check_library(std::string_view path, const Module& module,
                                         const Include& include) {
    const std::string_view name = include.name;
    const bool is_face = module.name == "cli" || module.name == "mpi" || module.name == "wasm";
    if (is_standard(name)) {
        if (module.in_browser && k_not_in_browser.contains(name) && !k_with_threads.contains(path))
            return bracketed(name) + " does not exist in the browser build";
        if (!is_face && k_printing.contains(name))
            return "the library never prints, but includes " + bracketed(name);
        return std::nullopt;
    }
    // The files that compile the kernels for every instruction set.
    if (path.starts_with("src/trace/") &&
        (path.ends_with("kernels.cpp") || path.ends_with("/solids.cpp") || path.ends_with("/faults.cpp")) &&
        name == "hwy/foreach_target.h")
        return std::nullopt;
    if (starts_with_any(name, module.libraries)) return std::nullopt;
    return std::string(module.name) + " may not include " + bracketed(name);
}

}  // namespace

const std::vector<Module>& modules() {
    static const std::vector<Module> list = {
        {"base", {}, {"oneapi/tbb/", "fmt/", "immintrin.h", "sys/mman.h"}},
        {"math", {"base"}, {}},
        {"simd", {"base", "math"}, {"hwy/", "cpuid.h", "wasm_simd128.h"}},
        {"geometry", {"base", "math", "simd"}, {}},
        {"lighting", {"base", "math", "simd"}, {}},
        {"bvh", {"base", "math", "simd"}, {}},
        {"scene", {"base", "math"}, {"fmt/", "fast_float/"}},
        {"formats", {"base", "math", "scene", "image"}, {"fmt/", "fast_float/", "ft2build.h"}},
        {"world",
         all_but({"trace", "explain", "check", "compare", "diagnose", "grade", "image", "journal", "output",
                  "os", "cli", "mpi", "wasm", "export"}),
         {"fmt/"}},
        {"trace",
         all_but({"explain", "check", "compare", "diagnose", "grade", "image", "journal", "output", "os",
                  "cli", "mpi", "wasm", "export"}),
         {"fmt/"}},
        {"explain",
         all_but({"check", "compare", "diagnose", "grade", "image", "journal", "output", "os", "cli", "mpi",
                  "wasm", "export"}),
         {"fmt/", "fast_float/", "nlohmann/"}},
        {"check",
         all_but({"explain", "compare", "diagnose", "grade", "image", "journal", "output", "os", "cli", "mpi",
                  "wasm", "export"}),
         {"fmt/", "fast_float/", "nlohmann/"}},
        {"compare",
         all_but({"explain", "check", "diagnose", "grade", "journal", "output", "os", "cli", "mpi", "wasm",
                  "export"}),
         {"fmt/", "fast_float/", "nlohmann/"}},
        {"diagnose",
         all_but({"check", "compare", "grade", "journal", "output", "os", "cli", "mpi", "wasm", "export"}),
         {"fmt/", "fast_float/", "nlohmann/"}},
        {"grade",
         all_but({"explain", "check", "diagnose", "journal", "output", "os", "cli", "mpi", "wasm", "export"}),
         {"fmt/", "fast_float/", "nlohmann/"}},
        {"image",
         {"base", "math"},
         {"fmt/", "zlib.h", "png.h", "jerror.h", "jpeglib.h", "Imf", "Imath", "stb_image.h"},
         false},
        {"journal", {"base"}, {"fmt/", "zlib.h", "xxhash.h"}, false},
        {"output", {"base", "trace", "image", "journal"}, {}, false},
        {"export",
         {"base", "math", "scene", "formats", "geometry", "bvh", "simd", "image", "world"},
         {"fmt/", "nlohmann/"},
         false},
        {"cli", all_but({"mpi", "wasm"}), {"fmt/", "nlohmann/", "CLI/"}, false},
        {"os",
         {},
         {"sys/", "unistd.h", "fcntl.h", "fnmatch.h", "poll.h", "signal.h", "windows.h", "psapi.h",
          "shellapi.h", "io.h"},
         false},
        {"mpi", all_but({"wasm"}), {"fmt/", "CLI/", "mpi.h"}, false},
        {"wasm", all_but({"journal", "output", "os", "cli", "mpi", "export"}), {"fmt/", "nlohmann/"}},
    };
    return list;
}

std::vector<Include> find_includes(std::string_view text) {
    std::vector<Include> found;
    int line = 0;
    while (!text.empty()) {
        ++line;
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string row(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^">]+)[">])");
        std::smatch match;
        if (std::regex_search(row, match, pattern)) found.push_back({line, match[2], match[1] == "\""});
    }
    return found;
}

std::optional<std::string> check_include(std::string_view path, const Include& include) {
    if (path.starts_with("include/")) return check_public(include);
    const std::string_view inside = path.substr(std::string_view("src/").size());
    const std::string_view module_name = inside.substr(0, inside.find('/'));
    const auto module = std::find_if(modules().begin(), modules().end(),
                                     [&](const Module& r) { return r.name == module_name; });
    if (module == modules().end())
        return "no module is called " + std::string(module_name) +
               ": give it a line in tests/includes/rules.cpp";
    if (!include.quoted) return check_library(path, *module, include);
    const std::string_view target = std::string_view(include.name).substr(0, include.name.find('/'));
    if (target == "glint" || target == module_name || module->sees.contains(target)) return std::nullopt;
    return std::string(module_name) + " may not see \"" + include.name + "\"";
}

std::vector<std::string> find_libm_calls(std::string_view text) {
    static const std::regex pattern(
        R"(\bstd::(a?(?:sin|cos|tan)h?|atan2|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|fmod|remainder|fma|lerp)f?\s*\()");
    std::vector<std::string> found;
    const std::string copy(text);
    for (std::sregex_iterator i(copy.begin(), copy.end(), pattern), end; i != end; ++i)
        found.push_back((*i)[1]);
    return found;
}

std::vector<std::string> find_types(std::string_view text) {
    static const std::regex opens(R"(^(?:inline )?namespace ([\w:]+ )?\{$)"),
        closes(R"(^\}  // namespace.*)"),
        type(
            R"(^(?:struct|class|enum class|enum|union) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: : [^;]*)?(?: \{.*)$)");
    std::vector<std::string> found, inside;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_match(line, match, opens)) {
            std::string name = match[1];
            if (!name.empty()) name.back() = ':';
            inside.push_back(name.empty() ? "" : name + ':');
        } else if (std::regex_match(line, closes)) {
            if (!inside.empty()) inside.pop_back();
        } else if (std::regex_match(line, match, type)) {
            if (std::find(inside.begin(), inside.end(), "") != inside.end()) continue;
            std::string name;
            for (const std::string& space : inside) name += space;
            found.push_back(name + match[1].str());
        }
    }
    return found;
}

}  // namespace glint::test
