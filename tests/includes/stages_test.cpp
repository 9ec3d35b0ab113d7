// SPDX-License-Identifier: Apache-2.0
// docs/architecture.md lists the batches that each stage of a tile reads and writes, as in its signature.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace glint::test {
namespace {

namespace fs = std::filesystem;

std::string read_project_file(const std::string& path) {
    std::ifstream in(fs::path(GLINT_PROJECT_DIR) / path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

struct Stage {
    std::string file;
    std::set<std::string> reads, writes;
    friend bool operator==(const Stage&, const Stage&) = default;
};
using Stages = std::map<std::string, Stage>;

std::ostream& operator<<(std::ostream& out, const Stage& stage) {
    out << stage.file << " reads";
    for (const std::string& batch : stage.reads) out << ' ' << batch;
    out << ", writes";
    for (const std::string& batch : stage.writes) out << ' ' << batch;
    return out;
}

// The types that a stage may read or write.
const char* const k_batch = R"(\b(\w+Batch|Film|FirstHits|TileJob)\b)";

std::set<std::string> find_batches(const std::string& text, const std::string& pattern) {
    const std::regex batch(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), batch), end; i != end; ++i) found.insert((*i)[1]);
    return found;
}

// The table of the document.
Stages listed_stages(const std::string& document) {
    static const std::regex row(R"(\| `(\w+)` \| `([\w/-]+\.h)` \|([^|\n]*)\|([^|\n]*)\|)");
    Stages stages;
    for (std::sregex_iterator i(document.begin(), document.end(), row), end; i != end; ++i)
        stages[(*i)[1]] = {(*i)[2], find_batches((*i)[3], k_batch), find_batches((*i)[4], k_batch)};
    return stages;
}

// The functions of a file that have batches as arguments.
void find_stages(const std::string& file, const std::string& text, Stages& stages) {
    static const std::regex signature(R"(\n(?:inline |GLINT_SMALL )?void (\w+)\(([^)]*)\) \{)");
    for (std::sregex_iterator i(text.begin(), text.end(), signature), end; i != end; ++i) {
        const std::string arguments = (*i)[2];
        const std::string all = std::string(k_batch) + "&", constant = "const " + all;
        Stage stage{file, find_batches(arguments, constant), find_batches(arguments, all)};
        for (const std::string& batch : stage.reads) stage.writes.erase(batch);
        if (!stage.reads.empty() || !stage.writes.empty()) stages[(*i)[1]] = stage;
    }
}

Stages declared_stages() {
    Stages stages;
    const fs::path folder = fs::path(GLINT_PROJECT_DIR) / "src/trace";
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).generic_string();
        if (name.ends_with("-inl.h")) find_stages(name, read_project_file("src/trace/" + name), stages);
    }
    return stages;
}

TEST(Stages, AreListedWithWhatTheyReadAndWrite) {
    const Stages listed = listed_stages(read_project_file("docs/architecture.md"));
    const Stages declared = declared_stages();
    EXPECT_GE(listed.size(), 10u);
    for (const auto& [name, stage] : listed) {
        ASSERT_TRUE(declared.contains(name)) << name << " is listed, but no function of src/trace";
        EXPECT_EQ(stage, declared.at(name)) << name;
    }
}

TEST(Stages, AreAllListed) {
    const std::string document = read_project_file("docs/architecture.md");
    const std::string tile = read_project_file("src/trace/uniform_tile-inl.h");
    const Stages declared = declared_stages();
    static const std::regex call(R"(\b(\w+)\()");
    std::size_t found = 0;
    for (std::sregex_iterator i(tile.begin(), tile.end(), call), end; i != end; ++i) {
        const std::string name = (*i)[1];
        const bool is_other = name.starts_with("record_") || name.starts_with("clear_");
        if (is_other || !declared.contains(name)) continue;
        ++found;
        EXPECT_NE(document.find('`' + name + '`'), std::string::npos)
            << name << " is called in uniform_tile-inl.h, but is not in docs/architecture.md";
    }
    EXPECT_GE(found, 10u);
}

TEST(Stages, AreReadFromSignatures) {
    Stages stages;
    find_stages("a-inl.h",
                "\ninline void mix(const WorldParts& world, const RayBatch& a,\n  HitBatch& b) {\n}\n",
                stages);
    EXPECT_EQ(stages, (Stages{{"mix", {"a-inl.h", {"RayBatch"}, {"HitBatch"}}}}));
    EXPECT_EQ(listed_stages("| `mix` | `a-inl.h` | RayBatch | HitBatch |\n"), stages);
}

// The table of docs/reading_the_code.md, and the breakpoints of tools/one_pixel.gdb.
TEST(ReadingTheCode, NamesFunctionsThatExist) {
    const std::string document = read_project_file("docs/reading_the_code.md");
    static const std::regex row(R"(\n\| \d+ \| `([^`]+)` \| `(\w+)` \|)");
    std::size_t rows = 0;
    for (std::sregex_iterator i(document.begin(), document.end(), row), end; i != end; ++i, ++rows) {
        const std::string file = read_project_file((*i)[1]), function = (*i)[2];
        EXPECT_TRUE(std::regex_search(file, std::regex("\\n[^/\n]*\\b" + function + "\\([^;]*\\{\n")))
            << (*i)[1] << " defines no " << function;
    }
    EXPECT_EQ(rows, 12u);
    const std::string script = read_project_file("tools/one_pixel.gdb");
    const Stages declared = declared_stages();
    static const std::regex stop(R"(\nscalar_stage (\w+))");
    std::size_t stops = 0;
    for (std::sregex_iterator i(script.begin(), script.end(), stop), end; i != end; ++i, ++stops)
        EXPECT_TRUE(declared.contains((*i)[1])) << (*i)[1];
    EXPECT_GE(stops, 8u);
}

}  // namespace
}  // namespace glint::test
