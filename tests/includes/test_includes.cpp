// Every #include of the tree against the arrows of docs/architecture.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "includes/rules.h"

namespace glint::includes {
namespace {

namespace fs = std::filesystem;

struct File {
    std::string path;  // relative to the project
    std::string text;
};

std::vector<File> read_sources() {
    const fs::path project = GLINT_PROJECT_DIR;
    std::vector<File> files;
    for (const char* const folder : {"include", "src"}) {
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

bool allowed(std::string_view path, std::string_view line) {
    const auto includes = find_includes(line);
    EXPECT_EQ(includes.size(), 1u) << line;
    return !includes.empty() && !check_include(path, includes[0]).has_value();
}

TEST(IncludeRules, KnowWhatIsWrong) {
    EXPECT_TRUE(allowed("src/bvh/build.cpp", "#include \"math/box.h\""));
    EXPECT_FALSE(allowed("src/bvh/build.cpp", "#include \"geometry/sphere-inl.h\""));
    EXPECT_FALSE(allowed("src/math/vec.h", "#include \"simd/lanes-inl.h\""));
    EXPECT_FALSE(allowed("src/trace/render.cpp", "#include \"cli/render.h\""));
    EXPECT_FALSE(allowed("src/image/png.cpp", "#include \"trace/render.h\""));
    EXPECT_TRUE(allowed("src/simd/lanes-inl.h", "#include <hwy/highway.h>"));
    EXPECT_FALSE(allowed("src/bvh/traverse-inl.h", "#include <hwy/highway.h>"));
    EXPECT_TRUE(allowed("src/trace/kernels.cpp", "#include <hwy/foreach_target.h>"));
    EXPECT_FALSE(allowed("src/trace/kernels.cpp", "#include <hwy/highway.h>"));
    EXPECT_FALSE(allowed("src/trace/render.cpp", "#include <oneapi/tbb/parallel_for.h>"));
    EXPECT_FALSE(allowed("src/trace/render.cpp", "#include <thread>"));
    EXPECT_FALSE(allowed("src/scene/validate.cpp", "#include <iostream>"));
    EXPECT_FALSE(allowed("include/glint/image.h", "#include <zlib.h>"));
    EXPECT_FALSE(allowed("include/glint/image.h", "#include \"base/guard.h\""));
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

}  // namespace
}  // namespace glint::includes
