// SPDX-License-Identifier: Apache-2.0
// Checks every #include of the tree against the arrows of docs/architecture.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "includes/rules.h"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

struct File {
    std::string path;  // relative to the project
    std::string text;
};

std::vector<File> read_sources(std::vector<std::string> folders = {"include", "src"}) {
    const fs::path project = GLINT_PROJECT_DIR;
    std::vector<File> files;
    for (const std::string& folder : folders) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(project / folder)) {
            const fs::path extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            std::ostringstream text;
            text << std::ifstream(entry.path()).rdbuf();
            files.push_back({fs::relative(entry.path(), project).generic_string(), text.str()});
        }
    }
    return files;
}

TEST(Includes, FollowTheArrows) {
    const std::vector<File> files = read_sources();
    ASSERT_GT(files.size(), 10u);
    for (const File& file : files) {
        for (const Include& include : find_includes(file.text)) {
            const auto wrong = check_include(file.path, include);
            EXPECT_FALSE(wrong.has_value()) << file.path << ':' << include.line << ": " << wrong.value_or("");
        }
    }
}

TEST(Includes, NoLibmBetweenTextAndPixel) {
    for (const File& file : read_sources()) {
        if (file.path.starts_with("src/cli/")) continue;
        for (const std::string& call : find_libm_calls(file.text))
            ADD_FAILURE() << file.path << " calls std::" << call;
    }
}

// For the linker, two classes with the same name in one program are one class, even if they differ.
TEST(Types, HaveNamesOfTheirOwn) {
    std::map<std::string, std::string> defined;  // the name, and where
    for (const File& file : read_sources({"include", "src", "tests", "bench"})) {
        // Test programs may have classes with equal names, but their headers are used together with the
        // library's.
        if (!file.path.starts_with("include/") && !file.path.starts_with("src/") &&
            !file.path.ends_with(".h"))
            continue;
        for (const std::string& name : find_types(file.text)) {
            const auto [first, is_new] = defined.emplace(name, file.path);
            EXPECT_TRUE(is_new) << name << " is defined in " << first->second << " and in " << file.path;
        }
    }
    EXPECT_TRUE(defined.contains("glint::Scene"));
    EXPECT_TRUE(defined.contains("glint::World"));
}

// Code calls the light's functions instead of comparing its kind, so that no code misses a new kind.
TEST(Lights, AreNotComparedByKind) {
    static const std::regex comparison(R"([!=]= *LightKind::|case LightKind::)");
    int asked = 0;
    for (const File& file : read_sources()) {
        const bool answers = file.path == "include/glint/scene.h" || file.path == "src/scene/scene.cpp";
        const bool compares = std::regex_search(file.text, comparison);
        EXPECT_TRUE(answers || !compares) << file.path << " compares the kind of a light";
        asked += answers && compares ? 1 : 0;
    }
    EXPECT_EQ(asked, 2);
}

// A function that docs/lighting.md names beside a file is in it: "`cosines`, `diffuse_term` in
// lighting/phong-inl.h".
TEST(Documents, NameFunctionsWhereTheyAre) {
    std::ifstream file(fs::path(GLINT_PROJECT_DIR) / "docs/lighting.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    static const std::regex named(R"(((?:`\w+`,? )+)in (\w+/[\w-]+\.h))"), word(R"(`(\w+)`)");
    int found = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), named), end; at != end; ++at) {
        std::ifstream source(fs::path(GLINT_PROJECT_DIR) / "src" / (*at)[2].str());
        const std::string code{std::istreambuf_iterator<char>(source), {}};
        const std::string names = (*at)[1];
        for (std::sregex_iterator name(names.begin(), names.end(), word); name != end; ++name, ++found)
            EXPECT_NE(code.find(" " + (*name)[1].str() + "("), std::string::npos) << at->str();
    }
    EXPECT_GE(found, 8);
}

bool allowed(std::string_view path, std::string_view line) {
    const auto includes = find_includes(line);
    EXPECT_EQ(includes.size(), 1u) << line;
    return !includes.empty() && !check_include(path, includes[0]).has_value();
}

TEST(IncludeRules, FindViolations) {
    EXPECT_TRUE(allowed("src/bvh/build.cpp", "#include \"math/box.h\""));
    EXPECT_FALSE(allowed("src/bvh/build.cpp", "#include \"geometry/sphere-inl.h\""));
    EXPECT_FALSE(allowed("src/math/vec.h", "#include \"simd/lanes-inl.h\""));
    EXPECT_FALSE(allowed("src/trace/render.cpp", "#include \"cli/render.h\""));
    EXPECT_FALSE(allowed("src/image/encode_png.cpp", "#include \"trace/render.h\""));
    EXPECT_TRUE(allowed("src/simd/lanes-inl.h", "#include <hwy/highway.h>"));
    EXPECT_FALSE(allowed("src/bvh/traverse-inl.h", "#include <hwy/highway.h>"));
    EXPECT_TRUE(allowed("src/trace/kernels.cpp", "#include <hwy/foreach_target.h>"));
    EXPECT_FALSE(allowed("src/trace/kernels.cpp", "#include <hwy/highway.h>"));
    EXPECT_FALSE(allowed("src/trace/render.cpp", "#include <oneapi/tbb/parallel_for.h>"));
    EXPECT_FALSE(allowed("src/trace/render.cpp", "#include <thread>"));
    EXPECT_FALSE(allowed("src/scene/validate.cpp", "#include <iostream>"));
    EXPECT_FALSE(allowed("include/glint/image.h", "#include <zlib.h>"));
    EXPECT_FALSE(allowed("include/glint/image.h", "#include \"base/status.h\""));
    EXPECT_FALSE(allowed("src/attic/old.cpp", "#include <vector>"));
}

TEST(IncludeRules, ReadIncludeLinesOnly) {
    const auto found =
        find_includes("#pragma once\n// #include <a>\n  # include \"b/c.h\"\nint x;\n#include <d>");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].line, 3);
    EXPECT_EQ(found[0].name, "b/c.h");
    EXPECT_TRUE(found[0].quoted);
    EXPECT_EQ(found[1].line, 5);
    EXPECT_FALSE(found[1].quoted);
}

TEST(IncludeRules, FindLibmCalls) {
    EXPECT_EQ(find_libm_calls("x = std::sqrt(y) + std::powf (2, y) + std::cos(x);"),
              (std::vector<std::string>{"pow", "cos"}));
    EXPECT_TRUE(find_libm_calls("math::cos(x); std::cosine(x); std::expected(1)").empty());
}

TEST(TypeRules, FindDefinitionsForOtherFiles) {
    EXPECT_EQ(find_types("namespace glint {\nstruct A {\n    struct B {\n    };\n};\nclass C;\nnamespace {\n"
                         "struct D {};\n}  // namespace\nclass E final : public A {\n};\n"
                         "enum class F : int { x };\nstruct alignas(64) G {\n};\n}  // namespace glint\n"
                         "namespace glint::cli {\nstruct A {};\n}  // namespace glint::cli\n"),
              (std::vector<std::string>{"glint::A", "glint::E", "glint::F", "glint::G", "glint::cli::A"}));
}

}  // namespace
}  // namespace glint::test
