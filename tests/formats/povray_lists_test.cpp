// SPDX-License-Identifier: Apache-2.0
// The lists of mesh2, as one token and as many.
#include <gtest/gtest.h>

#include "formats/povray/number_list.h"
#include "povray_text.h"

namespace glint::test {
namespace {

using povray::end_of_number_list;
using povray::NumberList;

// The length of the list, or -1.
std::ptrdiff_t length_of(std::string_view text) {
    const char* const end = end_of_number_list(text.data(), text.data() + text.size());
    return end == nullptr ? -1 : end - text.data();
}

TEST(PovRayLists, HavePlainNumbersOnly) {
    for (const std::string_view list :
         {" ", "1", "-1.5e-3, 2,", "2, <1, 2>, <.5,+6 ,- 7.> <1,2,3>\n, 4, 5"}) {
        EXPECT_EQ(length_of(std::string(list) + "}"), static_cast<std::ptrdiff_t>(list.size())) << list;
    }
    for (const std::string_view text :
         {"",           "1",          "1 2}",   "1-2}",       "<1>}", "<1,2,3,4>}", "<1 2 3>}",
          "<1,2,3>*2}", "<1,2,3>.x}", "x}",     "1e}",        ".}",   "1,,2}",      "<1,2}",
          "<1,2,",      "1 // }",     "1.5.5}", "<1,2,3> 4}", "3x}",  "-}",         "#if(1) 2 #end}"}) {
        EXPECT_EQ(length_of(text), -1) << text;
    }
}

TEST(PovRayLists, AreReadInOrder) {
    NumberList list(" 2, <1, 2>, <.5,+6 ,- 7.>\n 4.25e1, 123456789012345678");
    bool is_short = false;
    EXPECT_EQ(list.number(), 2);
    EXPECT_TRUE(list.is_vector());
    EXPECT_EQ(list.vector(is_short), (Vec3{1, 2, 0}));
    EXPECT_TRUE(is_short);
    EXPECT_EQ(list.vector(is_short), (Vec3{.5, 6, -7}));
    EXPECT_FALSE(is_short);
    EXPECT_EQ(list.number(), 42.5);
    EXPECT_EQ(list.number(), 123456789012345678.0);
    EXPECT_TRUE(list.at_end());
}

// With `#if(1)` in it, a list is read as tokens.
TEST(PovRayLists, MeanTheSameAsTokens) {
    const auto mesh = [](const std::string& points, const std::string& faces) {
        return "mesh2 { vertex_vectors { " + points +
               " } texture_list { 2, texture { pigment { rgb x } } texture { pigment "
               "{ rgb y } } } face_indices { " +
               faces + " } normal_vectors { 1, -z } normal_indices { 1, <0, 0, 0> } }";
    };
    const std::string tokens = "#if(1) #end ";
    for (const auto& [points, faces] : std::initializer_list<std::pair<std::string, std::string>>{
             {"3, <0,0,0>, <1,-1e-1,2>, <0.1,1>", "2, <0,1,2>, 1, <1,2,0>, 0, 1, 0"},
             {"3 <0,0,0> <1,2,3>, 7,", "1 <0,1,2>"},
             {"3, <0,0,0>, <1,0,0>", "1, <0,1,2>"},
             {"2, <0,0,0>, <1,0,0>, <1,2,3>", "1, <0,1,2>"},
             {"<3,4,5>, <0,0,0>", "1, <0,1,2>"},
             {"-3", "1, <0,1,2>"},
             {"3, <0,0,0>, <1,-1,2>, <0,1,0>", "1, <0,1,-2>"},
             {"3, <0,0,0>, <1,-1,2>, <0,1,0>", "1, <0,1,2>, 0, 1"},
             {"3, <0,0,0>, <1,-1,2>, <0,1,0>", "2, <0,1,2>, 0, 1, 1, 1"},
             {"3, <0,0,0>, <1,-1,2>, <0,1,0>", "1, <0,1,3>"},
             {"3, <0,0,0>, <1,-1,2>, <0,1,0>", "2, 0, 1, 2"},
             {"3, <0,0,0>, <1,-1,2>, <0,1,0>", "1, <0,1>"}}) {
        const Result<Scene> list = read_povray(mesh(points, faces));
        const Result<Scene> expanded = read_povray(mesh(tokens + points, tokens + faces));
        ASSERT_EQ(static_cast<bool>(list), static_cast<bool>(expanded)) << points << faces << messages(list);
        if (!list) continue;
        ASSERT_EQ(list->meshes.size(), expanded->meshes.size()) << points << faces;
        for (std::size_t i = 0; i < list->meshes.size(); ++i)
            EXPECT_EQ(*list->meshes[i], *expanded->meshes[i]);
        EXPECT_EQ(list->get<SmoothTriangle>().size(), expanded->get<SmoothTriangle>().size());
    }
}

// Lists that macros read again and again take steps.
TEST(PovRayLists, CountAsTokens) {
    std::string text = "#macro M() mesh2 { vertex_vectors { 20000";
    for (int i = 0; i < 20000; ++i) text += ", <1,2,3>";
    text += " } } #end #while(1) M() #end";
    EXPECT_NE(messages(read_povray(text)).find("tokens were read again"), std::string::npos);
    // Mistakes have their place.
    const std::string wrong = messages(read_povray("mesh2 { vertex_vectors { 1, <1,2,3>,\n<4,5,6> } }"));
    EXPECT_NE(wrong.find("2:1: error: expected `}`, found a vector"), std::string::npos) << wrong;
}

}  // namespace
}  // namespace glint::test
