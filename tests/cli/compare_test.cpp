// SPDX-License-Identifier: Apache-2.0
// glint compare: exit codes, limits, reports, --diff and --vary.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "glint/image.h"
#include "image/read_png.h"

namespace glint::test {
namespace {

const std::string k_floor =
    "sphere { center = (0, -5001, 0)  radius = 5000  color = (255, 255, 0)  specular = 10 }\n";

class Compare : public ::testing::Test {
  protected:
    Compare() {
        folder.write("a.cgfs", k_scene + k_floor);
        draw("right.png", {});
        draw("dark.png", {"--no-shadows"});
    }
    void draw(const std::string& out, std::vector<std::string> more) {
        std::vector<std::string> arguments = {"render", "a.cgfs", "-s", "80x60", "-q", "-o", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished r = run(folder, arguments);
        ASSERT_EQ(r.code, 0) << r.err;
    }
    Finished compare(std::vector<std::string> more) {
        more.insert(more.begin(), "compare");
        return run(folder, more);
    }
    const Folder folder;
};

TEST_F(Compare, KeepsToMaxMemory) {
    const Finished free = compare({"dark.png", "right.png"}),
                   within = compare({"dark.png", "right.png", "--max-memory", "1M"});
    EXPECT_EQ(within.code, 1);
    EXPECT_EQ(within.out, free.out);
    for (const char* size : {"1K", "20K", "50000"}) {
        const Finished refused = compare({"dark.png", "right.png", "--max-memory", size});
        EXPECT_EQ(refused.code, 1);
        EXPECT_EQ(refused.out, "");
        EXPECT_NE(refused.err.find("(--max-memory) allows more"), std::string::npos) << refused.err;
    }
    for (const char* size : {"0", "5X", "M", "-1", "99999999999999G"}) {
        const Finished wrong = compare({"dark.png", "right.png", "--max-memory", size});
        EXPECT_EQ(wrong.code, 2);
        EXPECT_NE(wrong.err.find("expected a size"), std::string::npos) << wrong.err;
    }
}

#if defined(__linux__) && !defined(GLINT_SANITIZED)

TEST_F(Compare, EndsWithAnErrorWhenMemoryRunsOut) {
    run(folder, {"render", "a.cgfs", "-s", "800x700", "-o", "large.png"});
    run(folder, {"render", "a.cgfs", "-s", "800x700", "-o", "large_dark.png", "--no-shadows"});
    const std::vector<std::string> arguments = {"compare", "large_dark.png", "large.png", "--threads", "2"};
    const Finished free = run(folder, arguments);
    ASSERT_EQ(free.code, 1);
    bool fails = false;
    // With 20 MB, programs and libraries leave the C++ runtime no memory for exceptions: it aborts.
    for (long most = 22'000'000; most <= 42'000'000; most += 4'000'000) {
        RunOptions options;
        options.most_memory = most;
        const Finished limited = run(folder, arguments, options);
        if (limited.out == free.out) continue;
        fails = true;
        // The loader, too, needs memory; its code is 127.
        EXPECT_TRUE(limited.code == 1 || limited.code == 127) << most << ": " << limited.code;
        EXPECT_TRUE(!limited.err.empty() || limited.out.find("out of memory") != std::string::npos) << most;
    }
    EXPECT_TRUE(fails);
}

#endif

TEST_F(Compare, OnlyIdenticalPicturesPassWithoutLimits) {
    const Finished same = compare({"right.png", "right.png"});
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_TRUE(contains(same.out, "identical")) << same.out;
    const Finished other = compare({"dark.png", "right.png"});
    EXPECT_EQ(other.code, 1);
    EXPECT_TRUE(contains(other.out, "interiors")) << other.out;
    EXPECT_TRUE(contains(other.out, "--scene SCENE tries more")) << other.out;
}

TEST_F(Compare, TheFiguresAlone) {
    const Finished all = compare({"dark.png", "right.png"}),
                   r = compare({"dark.png", "right.png", "--no-causes"});
    EXPECT_EQ(r.code, 1) << r.err;
    EXPECT_TRUE(all.out.starts_with(r.out)) << r.out;
    EXPECT_TRUE(contains(r.out, "largest ")) << r.out;
    EXPECT_FALSE(contains(r.out, "cause")) << r.out;
    EXPECT_EQ(
        nlohmann::json::parse(compare({"dark.png", "right.png", "--no-causes", "--json"}).out)["diagnosis"],
        nullptr);
}

TEST_F(Compare, SaysWhatNoCauseExplains) {
    folder.write("none.cgfs", "light { type = ambient  intensity = 0.2 }\n");
    ASSERT_EQ(run(folder, {"render", "none.cgfs", "-s", "80x60", "-q", "-o", "none.png"}).code, 0);
    const Finished r = compare({"none.png", "right.png"});
    EXPECT_TRUE(contains(r.out, "The picture is one color throughout, (255, 255, 255): ")) << r.out;
    const Finished drawn = compare({"none.png", "right.png", "--scene", "a.cgfs"});
    EXPECT_TRUE(contains(drawn.out, "\n  Of the causes the nearest, ")) << drawn.out;
    EXPECT_TRUE(contains(compare({"dark.png", "right.png"}).out,
                         "Nothing classic explains the difference: none explains any of it"));
    draw("both.png", {"--no-shadows", "--convention", "gamma=1.3"});
    const auto json = nlohmann::json::parse(compare({"both.png", "right.png", "--json"}).out);
    EXPECT_EQ(json["diagnosis"]["remark"], nullptr);
    EXPECT_EQ(json["diagnosis"]["causes"].size(), 0u);
    const double share = json["diagnosis"]["nearest"]["explained"];
    EXPECT_TRUE(contains(compare({"both.png", "right.png"}).out,
                         "Nothing classic explains the difference: the nearest, "))
        << share;
}

TEST_F(Compare, NamesTheCauseByTheScene) {
    const Finished r = compare({"dark.png", "right.png", "--scene", "a.cgfs"});
    EXPECT_EQ(r.code, 1) << r.err;
    EXPECT_TRUE(contains(r.out, "Shadows are missing: ")) << r.out;
    EXPECT_TRUE(contains(r.out, "(shadows-missing: explains 100% of the difference)")) << r.out;
    draw("diffuse.png", {"--shading", "diffuse"});
    const Finished shown = compare({"dark.png", "diffuse.png", "--scene", "a.cgfs", "--shading", "diffuse"});
    EXPECT_TRUE(contains(shown.out, "(shadows-missing")) << shown.out << "\nthe scene's options hold";
    const Finished swapped = compare({"right.png", "dark.png", "--scene", "a.cgfs"});
    EXPECT_TRUE(contains(swapped.out, "The scene gives right.png, and not dark.png")) << swapped.out;
}

TEST_F(Compare, Limits) {
    const auto parsed = nlohmann::json::parse(compare({"dark.png", "right.png", "--json"}).out);
    const double largest = parsed["largest"]["value"], pixels = parsed["all"]["pixels"];
    const double failing = 100 * (1 - static_cast<double>(parsed["all"]["within"]) / pixels);
    const auto text = [](double value) { return std::to_string(value); };
    const auto code = [&](std::vector<std::string> limits) {
        limits.insert(limits.begin(), {"dark.png", "right.png", "-q"});
        const Finished r = compare(limits);
        EXPECT_EQ(r.out + r.err, "");
        return r.code;
    };
    EXPECT_EQ(code({}), 1);
    EXPECT_EQ(code({"--within", text(largest)}), 0);
    EXPECT_EQ(code({"--within", text(largest - 1)}), 1);
    EXPECT_EQ(code({"--within", "2", "--fail-percent", text(failing + 0.01)}), 0);
    EXPECT_EQ(code({"--within", "2", "--fail-percent", text(failing - 0.01)}), 1);
    EXPECT_EQ(code({"--fail-percent", "100"}), 0);
    EXPECT_EQ(code({"--hard-fail", text(largest)}), 0);
    EXPECT_EQ(code({"--hard-fail", text(largest - 1)}), 1);
    EXPECT_EQ(code({"--fail-percent", "100", "--hard-fail", text(largest - 1)}), 1);
}

TEST_F(Compare, Json) {
    const Finished r = compare({"dark.png", "right.png", "--json", "--scene", "a.cgfs"});
    const auto json = nlohmann::json::parse(r.out);
    EXPECT_EQ(json["width"], 80);
    EXPECT_EQ(json["identical"], false);
    EXPECT_EQ(json["passes"], false);
    for (const char* key : {"equal", "within_1", "within"}) {
        EXPECT_EQ(json["all"][key].get<int>(),
                  json["edges"][key].get<int>() + json["interiors"][key].get<int>());
    }
    EXPECT_GT(json["psnr"], 5);
    EXPECT_LT(json["ssim"], 1);
    EXPECT_EQ(json["diagnosis"]["causes"][0]["name"], "shadows-missing");
    EXPECT_EQ(json["diagnosis"]["scene_from_b"], 0);
    const auto same = nlohmann::json::parse(compare({"right.png", "right.png", "--json"}).out);
    EXPECT_EQ(same["identical"], true);
    EXPECT_EQ(same["psnr"], nullptr);
    EXPECT_EQ(same["ssim"], 1);
    EXPECT_EQ(same["diagnosis"], nullptr);
}

TEST_F(Compare, DiffIsAmplified) {
    const Finished r = compare({"dark.png", "right.png", "--diff", "d.png"});
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "d.png  |A - B| times ")) << r.err;
    const Picture a = read_png(folder.path("dark.png")), b = read_png(folder.path("right.png")),
                  d = read_png(folder.path("d.png"));
    ASSERT_EQ(d.error, "");
    ASSERT_EQ(d.samples.size(), a.samples.size());
    EXPECT_EQ(*std::max_element(d.samples.begin(), d.samples.end()), 255);
    for (std::size_t i = 0; i < d.samples.size(); ++i)
        EXPECT_EQ(d.samples[i] == 0, a.samples[i] == b.samples[i]);
    EXPECT_EQ(compare({"dark.png", "right.png", "--diff", "none/d.png"}).code, 1);
    EXPECT_EQ(compare({"dark.png", "right.png", "--diff", "d.jpg"}).code, 2);
    EXPECT_EQ(compare({"dark.png", "right.png", "--diff", "-"}).code, 2);
    EXPECT_EQ(compare({"dark.png", "right.png", "--diff", "-", "-q"}).out, folder.read("d.png"));
}

TEST_F(Compare, ReadsWhatRenderWrites) {
    for (const char* name : {"b.ppm", "b.exr"}) {
        draw(name, {});
        EXPECT_EQ(compare({name, "right.png"}).code, 0) << name << ": as bytes they are the same";
    }
    draw("c.exr", {});
    EXPECT_TRUE(contains(compare({"c.exr", "b.exr"}).out, "as floats\nidentical"));
    draw("c.exr", {"--no-shadows"});
    EXPECT_TRUE(contains(compare({"c.exr", "b.exr"}).out, ", as floats\n"));
    const auto piped = run(folder, {"compare", "-", "right.png"}, with_input(folder.read("right.png")));
    EXPECT_EQ(piped.code, 0) << piped.err;
}

TEST_F(Compare, WhatIsNotANumberIsNeverEqual) {
    const auto write = [&](const char* name, float value) {
        Image image{20, 12, std::vector<float>(720)};
        for (int c = 0; c < 3; ++c) image.rgb[c] = value;
        const auto bytes = encode(image, {FileFormat::exr}).value();
        folder.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    };
    write("black.exr", 0);
    write("nan.exr", std::nanf(""));
    write("infinite.exr", HUGE_VALF);
    EXPECT_EQ(compare({"black.exr", "black.exr"}).code, 0);
    for (const auto& [a, b] : {std::pair{"nan.exr", "black.exr"},
                               {"black.exr", "nan.exr"},
                               {"nan.exr", "nan.exr"},
                               {"infinite.exr", "infinite.exr"}}) {
        EXPECT_EQ(compare({a, b, "-q"}).code, 1) << a << b;
        EXPECT_EQ(compare({a, b, "-q", "--within", "255", "--fail-percent", "100"}).code, 1) << a << b;
        const Finished r = compare({a, b});
        EXPECT_TRUE(contains(r.out, "1 pixels have a number that is infinite or NaN: never equal")) << r.out;
        EXPECT_FALSE(contains(r.out, "identical")) << r.out;
        const auto json = nlohmann::json::parse(compare({a, b, "--json"}).out);
        EXPECT_EQ(json["not_finite"], 1);
        EXPECT_TRUE(json["diagnosis"]["causes"].empty());
        EXPECT_TRUE(contains(r.out, "come of a division by 0")) << r.out;
        EXPECT_EQ(json["all"]["equal"], 239);
        EXPECT_EQ(json["identical"], false);
    }
}

TEST_F(Compare, OverwritesNothingThatItReads) {
    const std::string right = folder.read("right.png");
    for (const char* name : {"right.png", "./right.png"}) {
        const Finished r = compare({"right.png", "dark.png", "--diff", name});
        EXPECT_EQ(r.code, 2);
        EXPECT_TRUE(contains(r.err, "would overwrite an input")) << r.err;
    }
    EXPECT_EQ(folder.read("right.png"), right);
}

TEST_F(Compare, BadInput) {
    folder.write("cut.png", folder.read("right.png").substr(0, 200));
    folder.write("text.png", "not a picture");
    draw("small.png", {"--crop", "20x20+0+0"});
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"none.png", "right.png"}, "none.png: no such file"},
        {{"cut.png", "right.png"}, "cut.png: PNG: the file is cut off"},
        {{"text.png", "right.png"}, "text.png: no PNG, PPM"},
        {{"small.png", "right.png"}, "different sizes: 20x20 and 80x60"},
        {{"right.png", "dark.png", "--scene", "none.cgfs"}, "none.cgfs: no such file"}};
    for (const auto& [arguments, message] : cases) {
        const Finished r = compare(arguments);
        EXPECT_EQ(r.code, 1) << message;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
    }
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {},
             {"right.png"},
             {"right.png", "dark.png", "right.png"},
             {"right.png", "dark.png", "--within", "-1"},
             {"right.png", "dark.png", "--fail-percent", "101"},
             {"right.png", "dark.png", "--scene", "a.cgfs", "--size", "80x60"},
             {"right.png", "dark.png", "--scene", "a.cgfs", "--shading", "plastic"}}) {
        EXPECT_EQ(compare(arguments).code, 2) << testing::PrintToString(arguments);
    }
}

TEST_F(Compare, VarySaysFromWhichValueOnNothingChanges) {
    const Finished r = compare({"a.cgfs", "--vary", "reflections=0..4", "--size", "40x30"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "from reflections = ")) << r.out;
    const auto json = nlohmann::json::parse(
        compare({"a.cgfs", "--vary", "shading=phong,phong,blinn-phong", "--size", "40x30", "--json"}).out);
    ASSERT_EQ(json["steps"].size(), 3u);
    EXPECT_EQ(json["steps"][1]["changed"], 0);
    EXPECT_GT(json["steps"][2]["changed"], 0);
    EXPECT_EQ(json["settled_from"], nullptr);
    const auto settled = nlohmann::json::parse(
        compare({"a.cgfs", "--vary", "reflections=1,0,0", "--size", "40x30", "--json"}).out);
    EXPECT_EQ(settled["settled_from"], "0");
}

TEST_F(Compare, VaryMistakesAreOfUsage) {
    const std::pair<const char*, const char*> cases[] = {
        {"reflections", "expected KEY="},   {"mirrors=0..3", "there is no 'mirrors'"},
        {"reflections=3..1", "A below B"},  {"reflections=0..9999", "more than 1001"},
        {"reflections=2", "two values"},    {"shading=phong,plastic", "plastic"},
        {"size=3x4,5x6", "different sizes"}};
    for (const auto& [vary, message] : cases) {
        const Finished r = compare({"a.cgfs", "--vary", vary});
        EXPECT_EQ(r.code, 2) << vary;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
    }
    EXPECT_EQ(compare({"none.cgfs", "--vary", "reflections=0..2"}).code, 1);
}

}  // namespace
}  // namespace glint::test
