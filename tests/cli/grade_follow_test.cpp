// SPDX-License-Identifier: Apache-2.0
// glint grade --rubric: one fault of a program costs the points of one part.
#include "cli/grade.h"
#include "glint/image.h"

namespace glint::test {
namespace {

class Follow : public Grade {
  protected:
    // All pictures of a program that renders another scene; `more` for those with shadows.
    void hand_in_of(const std::string& name, const std::string& scene_text, std::vector<std::string> more) {
        folder.write("faulty.json", scene_text);
        std::filesystem::create_directories(folder.path(name));
        const auto render = [&](const std::string& file, std::vector<std::string> options) {
            std::vector<std::string> arguments = {
                "render", "faulty.json", "-s", "96x72", "-q", "-o", name + "/castle_" + file + ".png"};
            arguments.insert(arguments.end(), options.begin(), options.end());
            const Finished r = run(folder, arguments);
            ASSERT_EQ(r.code, 0) << r.err;
        };
        render("diffuse", {"--shading", "diffuse", "--no-shadows", "--reflections", "0"});
        render("phong", {"--shading", "phong", "--no-shadows", "--reflections", "0"});
        render("blinn", {"--no-shadows", "--reflections", "0"});
        render("reflections", more);
        more.insert(more.end(), {"--reflections", "0"});
        render("shadows", more);
    }
    static std::string castle_text() {
        std::ifstream in(k_castle);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    // Materials without an ambient coefficient.
    static std::string castle_without_ambient() {
        return std::regex_replace(castle_text(), std::regex("\"ambient\": [0-9.]+"), "\"ambient\": 0");
    }
    void write_black(const std::string& name) {
        std::string black = "P6\n96 72\n255\n";
        black.resize(black.size() + 96 * 72 * 3);
        folder.write(name, black);
    }
    nlohmann::json by_rubric(const std::string& where) {
        return graded({where, "--scene", k_castle, "--rubric", k_rubric, "--size", "96x72"});
    }
    void turn_around(const std::string& name) {
        for (const auto& entry : std::filesystem::directory_iterator(folder.path(name))) {
            const std::string bytes = folder.read(name + "/" + entry.path().filename().string());
            Image image =
                decode({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}).value().image;
            Image turned = image;
            for (std::int32_t y = 0; y < image.height; ++y)
                std::copy_n(&image.rgb[3 * std::size_t(y) * image.width], 3 * image.width,
                            &turned.rgb[3 * std::size_t(image.height - 1 - y) * image.width]);
            const auto png = encode(turned).value();
            folder.write(name + "/" + entry.path().filename().string(),
                         {reinterpret_cast<const char*>(png.data()), png.size()});
        }
    }
};

TEST_F(Follow, AMissingTermCostsItsOwnPoints) {
    hand_in_of("in/ada", castle_without_ambient(), {});
    write_black("in/ada/castle_ambient.png");
    hand_in_of("in/ben", castle_without_ambient(), {});  // hands in no ambient picture at all
    const auto json = by_rubric("in");
    ASSERT_EQ(json.size(), 2u);
    for (const auto& row : json) {
        EXPECT_EQ(row["parts"][0]["points"], 0) << row;
        EXPECT_EQ(row["total"], 85) << row;
        EXPECT_LT(row["total_alone"], 10) << row;
        EXPECT_EQ(row["parts"][5]["followed"], nlohmann::json({"ambient-missing"})) << row;
        EXPECT_EQ(row["parts"][5]["points"], 25);
        EXPECT_LT(row["parts"][5]["points_alone"], 5);
    }
}

TEST_F(Follow, AWholePictureUpsideDownCostsOnePart) {
    hand_in("in/ada");
    turn_around("in/ada");
    const auto json = by_rubric("in");
    EXPECT_EQ(json[0]["total"], 85) << json;
    EXPECT_EQ(json[0]["parts"][1]["followed"], nlohmann::json({"upside-down"})) << json;
    EXPECT_EQ(json[0]["costs_most"]["cause"], "upside-down");
    EXPECT_EQ(json[0]["costs_most"]["points"], 5);
}

// A second fault costs its own part, too.
TEST_F(Follow, TwoFaultsCostTwoParts) {
    hand_in_of("in/ada", castle_without_ambient(), {"--no-shadows"});
    write_black("in/ada/castle_ambient.png");
    const auto json = by_rubric("in");
    const auto& parts = json[0]["parts"];
    EXPECT_EQ(parts[4]["points"], 5) << json;
    EXPECT_EQ(parts[5]["points"], 0) << json;
    EXPECT_EQ(parts[5]["cause"]["name"], "shadows-missing") << json;
    EXPECT_EQ(parts[6]["points"], 20) << json;
    EXPECT_EQ(json[0]["total"], 60) << json;
    EXPECT_EQ(json[0]["costs_most"]["cause"], "shadows-missing");
}

// A fault must not be followed where the part would not be visible with it.
TEST_F(Follow, NothingIsEarnedByWhatIsNotThere) {
    hand_in("in/ada");
    for (const char* name : {"phong", "blinn", "shadows", "reflections"})
        std::filesystem::copy_file(folder.path("in/ada/castle_diffuse.png"),
                                   folder.path("in/ada/castle_" + std::string(name) + ".png"),
                                   std::filesystem::copy_options::overwrite_existing);
    const auto json = by_rubric("in");
    const auto& parts = json[0]["parts"];
    EXPECT_EQ(parts[1]["points"], 15) << json;
    for (const int k : {2, 3, 5, 6}) EXPECT_LT(parts[k]["points"], 1) << k << json;
}

TEST_F(Follow, NeverTakesPoints) {
    hand_in("in/ada");
    hand_in("in/ben");
    hand_in("in/eve");
    draw("in/ben/castle_phong.png",
         {"--shading", "phong", "--no-shadows", "--reflections", "0", "--convention", "specular_gate=false"});
    draw("in/ben/castle_shadows.png", {"--reflections", "0", "--no-shadows"});
    draw("in/eve/castle_diffuse.png", {"--shading", "phong", "--no-shadows", "--reflections", "0"});
    draw("in/eve/castle_blinn.png", {"--shading", "phong", "--no-shadows", "--reflections", "0"});
    for (const auto& row : by_rubric("in")) {
        for (const auto& part : row["parts"]) {
            EXPECT_GE(part["points"], part["points_alone"]) << row;
            if (part["followed"].empty()) {
                EXPECT_EQ(part["points"], part["points_alone"]) << row;
            }
        }
    }
}

// Lights are left out of the ambient part, where light 1 of a fault is another than in the next part.
TEST_F(Follow, FaultsOfLightsFitPartsWithOtherLights) {
    hand_in("in/ada");
    folder.write("light.rubric",
                 "two 10 *two*.png lights=2 shadows=false reflections=0\n"
                 "one 10 *one*.png lights=1 shadows=false reflections=0\n"
                 "none 10 *ambient*.png lights=ambient shadows=false reflections=0\n"
                 "all 10 *blinn*.png shadows=false reflections=0 without lights=ambient\n");
    draw("in/ada/two.png", {"--no-shadows", "--reflections", "0", "--shading", "diffuse"});
    draw("in/ada/one.png", {"--no-shadows", "--reflections", "0", "--convention", "clamp_cosines=false"});
    const auto json = graded({"in", "--scene", k_castle, "--rubric", "light.rubric", "--size", "96x72"});
    EXPECT_EQ(json[0]["parts"][2]["points"], 10) << json;
    EXPECT_EQ(json[0]["parts"][3]["points"], 10) << json;
}

// A light that is missing shifts the numbers of the others: faults that are found later must not mix them up.
TEST_F(Follow, AMissingLightAndThenAnotherFaultOfLights) {
    const std::string text = castle_text();
    const std::size_t lights = text.find("\"lights\""), first = text.find('{', lights),
                      end = text.find("},", first) + 2;
    hand_in_of("in/ada", text.substr(0, first) + text.substr(end), {});
    hand_in("in/ben");
    for (const char* name : {"diffuse", "phong"})
        std::filesystem::copy_file(folder.path("in/ada/castle_" + std::string(name) + ".png"),
                                   folder.path("in/ben/castle_" + std::string(name) + ".png"),
                                   std::filesystem::copy_options::overwrite_existing);
    draw("in/ben/castle_shadows.png", {"--reflections", "0", "--convention", "shadow_stops_at_light=false"});
    const auto json = by_rubric("in");
    EXPECT_EQ(json[0]["parts"][4]["cause"]["name"], "light-missing") << json;
    EXPECT_EQ(json[0]["parts"][1]["counted_in"], nlohmann::json({"sum of lights"})) << json;
    for (const int k : {1, 2, 3, 5, 6})
        EXPECT_EQ(json[0]["parts"][k]["points"], json[0]["parts"][k]["of"]) << k << json;
    EXPECT_EQ(json[1]["parts"][3]["points"], 10) << json;
    EXPECT_EQ(json[1]["parts"][5]["cause"]["name"], "shadow-past-light") << json;
    EXPECT_EQ(json[1]["parts"][6]["points"], 20) << json;
}

TEST_F(Follow, EqualLinesAreGradedOnce) {
    draw("in/ada/castle.png", {"--no-shadows"});
    folder.write("twice.rubric", "one 10 *.png\nother 20 *.png reflections=0\nagain 30 *.png\n");
    const auto json = graded(
        {"in", "--scene", k_castle, "--rubric", "twice.rubric", "--size", "96x72", "--sheet", "s.png"});
    const auto& parts = json[0]["parts"];
    // Each is rounded to hundredths.
    EXPECT_NEAR(parts[2]["points"], 3 * parts[0]["points"].get<double>(), 0.02);
    EXPECT_EQ(parts[2]["cause"]["name"], "shadows-missing");
    EXPECT_EQ(parts[2]["file"], parts[0]["file"]);
}

TEST_F(Follow, ARowWithoutACauseSaysSo) {
    hand_in("in/ada");
    std::string noise = "P6 96 72 255\n";
    unsigned state = 1;
    for (int i = 0; i < 3 * 96 * 72; ++i)
        noise += static_cast<char>((state = state * 1664525u + 1013904223u) >> 24);
    folder.write("in/ada/castle_shadows.png", noise);
    const Finished r =
        grade({"in", "--scene", k_castle, "--rubric", k_rubric, "--size", "96x72", "--csv", "t.csv"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "ada, shadows: ")) << r.out;
    EXPECT_TRUE(contains(r.out, "; no classic cause\n")) << r.out;
    EXPECT_TRUE(contains(r.out, "  no classic cause (25)\n")) << r.out;
    const std::string csv = folder.read("t.csv");
    EXPECT_TRUE(contains(csv, ",total,of,notes,costs_most,points_lost,total_alone\r\n")) << csv;
    EXPECT_TRUE(contains(csv, ",no classic cause,25.00,65.00\r\n")) << csv;
}

TEST_F(Follow, TheOrderOfTheLinesDoesNotCount) {
    hand_in_of("in/ada", castle_without_ambient(), {"--no-shadows"});
    hand_in("in/ben");
    turn_around("in/ben");
    std::vector<std::string> lines;
    std::ifstream in(k_rubric);
    for (std::string line; std::getline(in, line);) lines.insert(lines.begin(), line + "\n");
    std::string text;
    for (const std::string& line : lines) text += line;
    folder.write("turned.rubric", text);
    const auto json = by_rubric("in");
    const auto turned = graded({"in", "--scene", k_castle, "--rubric", "turned.rubric", "--size", "96x72"});
    for (const int i : {0, 1}) {
        EXPECT_EQ(json[i]["total"], turned[i]["total"]) << json << turned;
        for (const auto& part : json[i]["parts"]) {
            const auto same = std::find_if(turned[i]["parts"].begin(), turned[i]["parts"].end(),
                                           [&](const auto& p) { return p["part"] == part["part"]; });
            ASSERT_NE(same, turned[i]["parts"].end());
            EXPECT_EQ(*same, part);
        }
    }
}

TEST_F(Follow, APenaltyInTheRubric) {
    hand_in_of("in/ada", castle_without_ambient(), {});
    std::ifstream in(k_rubric);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    folder.write("p.rubric", text + "penalty ambient-missing 3\n");
    write_black("in/ada/castle_ambient.png");
    const Finished r = grade({"in", "--scene", k_castle, "--rubric", "p.rubric", "--size", "96x72", "--json",
                              "p.json", "--csv", "p.csv"});
    EXPECT_EQ(r.code, 0) << r.err;
    const auto json = nlohmann::json::parse(folder.read("p.json"));
    // The black picture is no picture of a program that lacks the ambient term only: it shows nothing.
    EXPECT_EQ(json[0]["total"], 82) << json;
    EXPECT_EQ(json[0]["penalties"],
              nlohmann::json::parse(R"([{"cause": "ambient-missing", "points": 3.0}])"));
    EXPECT_TRUE(contains(r.out, "\nada: 3 points off for ambient-missing\n")) << r.out;
    EXPECT_TRUE(contains(folder.read("p.csv"), " | 3 points off for ambient-missing\","))
        << folder.read("p.csv");
}

}  // namespace
}  // namespace glint::test
