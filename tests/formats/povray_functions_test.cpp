// SPDX-License-Identifier: Apache-2.0
// Functions of numbers: the values are POV-Ray's (measured).
#include "formats/mistakes.h"
#include "formats/povray_text.h"

namespace glint::test {
namespace {

// The value of an expression after these declarations.
double value_after(const std::string& declarations, const std::string& expression) {
    const Scene scene = povray_scene(declarations + "\nsphere { <" + expression + ", 0, 0>, 1 }");
    return scene.get<Sphere>().empty() ? 1e9 : scene.get<Sphere>()[0].center.x;
}

TEST(PovRayFunctions, AreCalledAsNumbers) {
    EXPECT_EQ(value_after("#declare F = function(x) { x*x }", "F(5)"), 25);
    EXPECT_EQ(value_after("#declare F = function(a, b) { a - b }", "F(5, 6)*2 + 1"), -1);
    EXPECT_EQ(value_after("#declare F = function(a b) { a - b };", "F(5 6)"), -1);
    EXPECT_EQ(value_after("#declare F = function { x + 2*y + 3*z }", "F(5, 6, 7)"), 38);
    EXPECT_EQ(value_after("#declare F = function { u + 2*v }", "F(5, 6, 7)"), 17);
    EXPECT_EQ(value_after("#declare F = function(x) { -pow(x, 2) + select(x, 1, 2, 3) }", "F(2)"), -1);
    EXPECT_EQ(value_after("#declare F = function(x) { (1 < x) + (x = 2)*10 }", "F(2)"), 11);
}

// tests/peers has the same in a picture.
TEST(PovRayFunctions, NumbersNearZeroAreFalseButNotEqual) {
    const auto truths = [](const std::string& number) {
        std::string text;
        for (const char* test : {" & 1", " | 0", " > 0", " < 0", " = 0", " >= 0", " <= 0"})
            text += value_after("", "(" + number + test + ")") != 0 ? '1' : '0';
        return text;
    };
    EXPECT_EQ(truths("1.1e-10"), "1110010");
    EXPECT_EQ(truths("1e-10"), "0010111");
    EXPECT_EQ(truths("1e-13"), "0010111");
    EXPECT_EQ(truths("0"), "0000111");
    EXPECT_EQ(truths("-1e-11"), "0001111");
    EXPECT_EQ(truths("-1e-9"), "1101001");
}

TEST(PovRayFunctions, LogicIsTermByTerm) {
    const auto sum = [](const std::string& vector) {
        return value_after("#declare V = " + vector + ";", "V.x + 10*V.y + 100*V.z");
    };
    EXPECT_EQ(sum("(<1, 0, 3> & <0, 2, 3>)"), 100);
    EXPECT_EQ(sum("(<1, 0, 3> | <0, 2, 3>)"), 111);
    EXPECT_EQ(sum("(<1, 0, 3> < <0, 2, 3>)"), 10);
    EXPECT_EQ(sum("(1 & <1, 0, 3>)"), 101);
}

TEST(PovRayFunctions, ArcsBeyondOneAreThoseOfOne) {
    EXPECT_EQ(value_after("", "asin(2)"), value_after("", "asin(1)"));
    EXPECT_EQ(value_after("", "acos(-1.5)"), value_after("", "acos(-1)"));
    EXPECT_EQ(value_after("", "acos(2)"), 0);
}

TEST(PovRayFunctions, KeepTheNumbersOfTheirDeclaration) {
    EXPECT_EQ(value_after("#declare A = 3; #declare F = function(x) { A*x } #declare A = 4;", "F(5)"), 15);
    EXPECT_EQ(value_after("#macro M(Q) function(a) { Q*a } #end #declare F = M(3)", "F(5)"), 15);
    EXPECT_EQ(
        value_after("#macro K() 5 #end #declare F = function(x) { #if (1) x #else 2 #end * K() }", "F(7)"),
        35);
}

TEST(PovRayFunctions, CallEachOtherAndAreArguments) {
    const std::string g = "#declare G = function(x) { x + 100 } ";
    EXPECT_EQ(value_after(g + "#declare F = function(y) { G(2*y) - y }", "F(5)"), 105);
    EXPECT_EQ(value_after(g + "#macro M(Q) Q(4) #end", "M(G)"), 104);
    EXPECT_EQ(value_after("#declare F = array[2] { function(a) { a*2 }, function(a) { a*3 } }", "F[1](5)"),
              15);
}

TEST(PovRayFunctions, CompareExactly) {
    EXPECT_EQ(value_after("#declare F = function(a) { a = 0.1 + 0.2 }", "F(0.3)"), 0);
    EXPECT_EQ(value_after("", "(0.3 = 0.1 + 0.2)"), 1);
}

TEST(PovRayFunctions, WhatIsNoArithmeticIsAnErrorWhereItIsCalled) {
    const std::string noise = "#declare F = function(x) { f_noise3d(x, 0, 0) }\n";
    EXPECT_EQ(povray_scene(noise + "sphere { 0, 1 }").shapes.size(), 1u) << "not called";
    expect_messages(
        {"noise",
         "#declare F = function(x) { f_noise3d(x, 0, 0) }\nsphere { 0, $F(1) }",
         {"glint does not evaluate this function of POV-Ray: it has 'f_noise3d', which is not declared"}},
        "a.pov", "povray");
    expect_messages({"pattern",
                     "#declare F = function { pigment { rgb 1 } }\nsphere { 0, $F(1, 2, 3) }",
                     {"glint does not evaluate this function of POV-Ray: it has 'pigment'"}},
                    "a.pov", "povray");
}

TEST(PovRayFunctions, IntegersBeyond32BitsAreWarnedOf) {
    const auto said = [](const std::string& x) {
        return messages(read_povray("light_source { <0, 0, -9>, rgb 1 } sphere { " + x + " * x, 1 }"));
    };
    EXPECT_EQ(said("(div(1e9, .5) - 2e9)"), "");
    EXPECT_EQ(said("int(-2147483647)"), "");
    EXPECT_NE(
        said("(div(1e9, .4) - 2e9)").find("warning: `div` of 2500000000: POV-Ray's integers are within 2^31"),
        std::string::npos)
        << said("(div(1e9, .4) - 2e9)");
    EXPECT_NE(said("int(2147483648)").find("warning: `int`"), std::string::npos);
}

TEST(PovRayFunctions, BadInputIsNamed) {
    expect_messages({"few",
                     "#declare F = function(a, b) { a }\nsphere { 0, F(1$) }",
                     {"expected 2 values for F(), found 1"}},
                    "a.pov", "povray");
    for (const std::string text :
         {"#declare F = function(a", "#declare F = function(a) { a", "#declare F = function { {",
          "#declare F = function", "#declare F = function(a) { F(a) } sphere { 0, F(1) }",
          "#declare F = function(a) { (a } sphere { 0, F(1) }",
          "#declare F = function(a) { } sphere { 0, F(1) }",
          "#declare F = function(a) { 1/a } sphere { 0, sqrt(F(0)*-1) }"}) {
        EXPECT_FALSE(read_povray(text)) << text;
    }
    // Twice as many steps with each function: the bound of tokens ends it.
    std::string deep = "#declare F0 = function(x) { x }\n";
    for (int i = 1; i < 60; ++i)
        deep += "#declare F" + std::to_string(i) + " = function(x) { F" + std::to_string(i - 1) + "(x) + F" +
                std::to_string(i - 1) + "(x) }\n";
    EXPECT_FALSE(read_povray(deep + "sphere { 0, F59(1) }"));
}

}  // namespace
}  // namespace glint::test
