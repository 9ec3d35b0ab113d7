// SPDX-License-Identifier: Apache-2.0
// LoadOptions::max_memory: texts that ask for much memory are refused soon, with a place.
#include "formats/load_text.h"

namespace glint::test {
namespace {

constexpr std::uint64_t k_mib = 1u << 20;

LoadOptions with_budget(std::uint64_t bytes) {
    LoadOptions options;
    options.max_memory = bytes;
    return options;
}

void expect_refused(std::string_view text, const std::string& name, std::uint64_t budget,
                    Sources* sources = nullptr) {
    const Result<Scene> result = load_text(text, name, with_budget(budget), sources);
    ASSERT_FALSE(result) << name;
    EXPECT_EQ(result.code, ErrorCode::out_of_memory) << messages(result);
    EXPECT_NE(messages(result).find("MiB of memory, the limit that was given: max_memory (--max-memory)"),
              std::string::npos)
        << messages(result);
    EXPECT_GT(result.diagnostics.back().line, 0u);
}

struct Hostile {
    const char* name;
    const char* text;
};

class PovrayMemory : public testing::TestWithParam<Hostile> {};

TEST_P(PovrayMemory, IsLimited) { expect_refused(GetParam().text, "a.pov", 4 * k_mib); }

constexpr Hostile k_hostile[] = {
    {"array", "#declare A = array[4000000];"},
    {"arrays", "#declare A = array[1000] #for(I, 0, 999) #declare A[I] = array[1000]; #end"},
    {"strings",
     "#declare S = \"abcdefgh\"; #for(I, 1, 12) #declare S = concat(S, S); #end "
     "#declare A = array[1000]; #for(I, 0, 999) #declare A[I] = concat(S, str(I, 0, 0)); #end"},
    {"union", "union { #while(1) sphere { 0, 1 } #end }"},
    {"shared_union", "#declare B = sphere { 0, 1 } union { #while(1) object { B } #end }"},
    {"changed_objects", "#declare B = sphere { 0, 1 } union { #while(1) object { B translate x } #end }"},
    {"doubled_union",
     "#declare A = sphere { 0, 1 } #for(I, 1, 20) #declare A = union { object { A } object { A } } #end A"},
    {"doubled_lights",
     "#declare A = light_source { 0, 1 } #for(I, 1, 20) #declare A = union { object { A } object { A } } "
     "#end A"},
    {"mesh", "mesh { #while(1) triangle { 0, x, y } #end }"},
    {"meshes", "#while(1) mesh { triangle { 0, x, y } triangle { 0, x, z } } #end"},
    {"single_faces",
     "#declare T = texture { pigment { rgb x } } #declare U = texture { pigment { rgb y } } #while(1) mesh2 "
     "{ "
     "vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } texture_list { 2, T U } face_indices { 1, <0,1,2>, 0, "
     "1, 0 } } "
     "#end"},
    {"mesh2", "mesh2 { vertex_vectors { 9000000 #while(1) x, #end } }"},
    {"shapes", "#while(1) sphere { 0, 1 } #end"},
    {"boxes", "#declare I = 0; #while(1) box { 0, 1 rotate I scale <1, 2, 3> } #declare I = I + 1; #end"},
    {"materials", "#declare I = 0; #while(1) sphere { 0, 1 pigment { rgb I } } #declare I = I + 1; #end"},
    {"textures", "#declare A = array { #while(1) pigment { rgb 1 } finish { phong 1 } #end }"},
    {"interiors", "fog { distance 9 rgb 1 } #while(1) union { sphere { 0, 1 pigment { rgbt 1 } } } #end"},
};
INSTANTIATE_TEST_SUITE_P(Hostile, PovrayMemory, testing::ValuesIn(k_hostile),
                         [](const auto& param) { return std::string(param.param.name); });

TEST(PovrayLimits, LoopsThatMakeShapesMayBeLong) {
    std::string text = "union {\n#for (I, 1, 40000)\n#local A = 0";
    for (int i = 0; i < 450; ++i) text += "+1";
    text += ";\nsphere { I, 0.1 }\n#end }";  // 36 million tokens
    const Result<Scene> scene = load_text(text, "a.pov", {}, nullptr, "povray");
    EXPECT_TRUE(scene) << messages(scene);
}

// Before, some of these took minutes, and others overflowed the stack.
TEST(PovrayLimits, EndShortTextsThatTakeLong) {
    const std::pair<const char*, const char*> cases[] = {
        {"#declare A = array[1]; #for(I, 1, 1000000) #declare A[0] = A; #end", "arrays are nested more than"},
        {"#declare A = mesh { } #for(I, 1, 60) #declare A = union { object { A } object { A } } #end A",
         "more than 4000"},
        {"#declare S = \"abcdefgh\"; #for(I, 1, 13) #declare S = concat(S, S); #end #while(S = S) #end",
         "tokens were read again"},
        {"mesh { #for(I, 1, 100000) triangle { <I, 0, 0>, x, y } #end #while(1) clipped_by { box { -1, 1 } } "
         "#end }",
         "tokens were read again"},
    };
    for (const auto& [text, message] : cases) {
        const Result<Scene> result = load_text(text, "a.pov", {}, nullptr, "povray");
        EXPECT_NE(messages(result).find(message), std::string::npos) << text << messages(result);
    }
}

TEST(PovrayArrays, AreCopiedWhenOneIsModified) {
    const Result<Scene> result = load_text(
        "#declare A = array[2] { array[2] { 1, 2 }, array[2] { 3, 4 } } #declare B = A; #declare B[0][1] = "
        "9; "
        "#declare C = array[2] { A[1], B[0] } #declare A[1][0] = 7; "
        "#macro Set(X) #declare X[0] = 5; #end #declare D = array[1] { 8 } #declare E = D; Set(E) "
        "sphere { <A[0][1], B[0][1], C[0][0]>, A[1][0] } sphere { <D[0], E[0], C[1][1]>, 1 }",
        "a.pov", {}, nullptr, "povray");
    ASSERT_TRUE(result) << messages(result);
    const auto& spheres = result->get<Sphere>();
    ASSERT_EQ(spheres.size(), 2u);
    EXPECT_EQ(spheres[0].center, (Vec3{2, 9, 3}));
    EXPECT_EQ(spheres[0].radius, 7);
    EXPECT_EQ(spheres[1].center, (Vec3{8, 5, 9}));
}

// The last word of a macro: the look for an index after it must not leave the macro's names.
TEST(PovrayArrays, ElementsEndMacros) {
    const Result<Scene> result = load_text(
        "#declare P = array[2] { 8, 9 } #declare Q = array[2] { 1, 2 } "
        "#macro Get() #local P = array[2] { 4, 5 }; P[1] #end #macro At(P, I) P[I] #end "
        "#macro Named(X) X[1] #end #declare S = array[1] { \"ab\" } #macro Text(T) T[0] #end "
        "#declare B = array[2] { sphere { 0, 3 } sphere { x, 6 } } "
        "sphere { 0, Get() } sphere { 0, At(Q, 0) } sphere { 0, Named(Q) } sphere { 0, strlen(Text(S)) } "
        "object { Named(B) }",
        "a.pov", {}, nullptr, "povray");
    ASSERT_TRUE(result) << messages(result);
    const auto& spheres = result->get<Sphere>();
    ASSERT_EQ(spheres.size(), 5u);
    const double radii[] = {5, 1, 2, 2, 6};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(spheres[i].radius, radii[i]) << i;
}

TEST(PovrayArrays, ShapesThatAreNotRenderedAreNoLights) {
    for (const char* shape : {"torus { 1, 1 }", "torus { 0, 1 }", "blob { }", "superellipsoid { <1, 1> }"}) {
        const Result<Scene> result =
            load_text(std::string("light_source { ") + shape + " }", "a.pov", {}, nullptr, "povray");
        EXPECT_FALSE(result) << shape;
        EXPECT_TRUE(has_errors(result.diagnostics));
    }
}

std::string repeated(std::string_view text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

TEST(Memory, IsLimitedInEveryFormat) {
    constexpr std::size_t n = 30000;
    expect_refused(repeated("sphere { center = (1, 2, 3) radius = 1 color = (9, 9, 9) }\n", n), "a.cgfs",
                   2 * k_mib);
    expect_refused("f 1 1 1 1 0 0 0 1\n" + repeated("s 1 2 3 1\n", n), "a.nff", 2 * k_mib);
    expect_refused(repeated("disc { radius = 1 center = (1, 2, 3) normal = (0, 1, 0) ior = 2 }\n", n),
                   "a.glint", 2 * k_mib);
    expect_refused(repeated("sphere { <1, 2, 3>, 1 pigment { color rgb <1, 1, 1> } }\n", n), "a.pov",
                   2 * k_mib);
    expect_refused("{ \"spheres\": [" +
                       repeated("{ \"center\": [1, 2, 3], \"radius\": 1, \"material\": \"a\" },\n", n) +
                       "] }",
                   "a.json", 2 * k_mib);
    const std::string head = "Begin_Scene\nResolution 8 8\n";
    const std::string texture = " Texture Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 1 1 TexFunc 0\n";
    expect_refused(head + repeated("Sphere Center 1 2 3 Rad 1" + texture, n), "a.dat", 2 * k_mib);
    expect_refused(head + "VertexArray Numverts 4000000000 Coords " + repeated("0 0 0\n", n), "a.dat", k_mib);
    std::string names;
    for (std::size_t i = 0; i < n; ++i)
        names += "material m" + std::to_string(i) + " { color = (1, 0, 0) }\n";
    expect_refused(names, "a.glint", 2 * k_mib);
}

class Doubling : public Sources {
  public:
    Result<std::string> read(std::string_view name, std::string_view) override {
        const int level = std::stoi(std::string(name));
        if (level == 0) return repeated("sphere { center = (0, 0, 0) radius = 1 }\n", 10);
        const std::string next = "include \"" + std::to_string(level - 1) + ".glint\"\n";
        return next + next;
    }
};

TEST(Memory, OfIncludesIsLimited) {
    Doubling sources;
    expect_refused("include \"12.glint\"", "a.glint", k_mib, &sources);
}

TEST(Memory, DefaultIsAMultipleOfTheLength) {
    EXPECT_EQ(default_max_memory(0), 2048 * k_mib);
    EXPECT_EQ(default_max_memory(1000), 2048 * k_mib + 256000);
    EXPECT_GT(default_max_memory(UINT64_MAX), default_max_memory(1000));
    EXPECT_TRUE(load_text("sphere { 0, 1 }", "a.pov", with_budget(k_mib)));
}

}  // namespace
}  // namespace glint::test
