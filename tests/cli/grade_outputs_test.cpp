// SPDX-License-Identifier: Apache-2.0
// The outputs of glint grade for students and for a class: Gradescope, PrairieLearn, the summary.
#include "cli/grade.h"
#include "cli/part_pictures.h"
#include "glint/image.h"

namespace glint::test {
namespace {

class StudentResults : public Grade {
  protected:
    // Without shadows, and without a picture of the diffuse part.
    void hand_in_two_mistakes(const std::string& name) {
        hand_in(name);
        draw(name + "/castle_shadows.png", {"--reflections", "0", "--no-shadows"});
        std::filesystem::remove(folder.path(name + "/castle_diffuse.png"));
    }
    nlohmann::json results(std::vector<std::string> more) {
        std::vector<std::string> arguments = {"ada",    "--scene", k_castle, "--rubric",
                                              k_rubric, "--size",  "96x72"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished r = grade(arguments);
        EXPECT_EQ(r.code, 0) << r.err;
        return nlohmann::json::parse(folder.read("results.json"));
    }
};

std::vector<std::uint8_t> from_base64(std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
        count += 6;
        if (count >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
    }
    return bytes;
}

Image picture_of(const std::string& uri) {
    constexpr std::string_view head = "data:image/png;base64,";
    EXPECT_TRUE(uri.starts_with(head)) << uri.substr(0, 40);
    return decode(from_base64(std::string_view(uri).substr(head.size()))).value().image;
}

TEST_F(StudentResults, ForGradescope) {
    hand_in("ada");
    draw("ada/castle_shadows.png", {"--reflections", "0", "--no-shadows"});
    std::filesystem::remove(folder.path("ada/castle_diffuse.png"));
    std::filesystem::create_directories(folder.path("ada/sources"));  // still one submission
    const Finished r = grade({"ada", "--scene", k_castle, "--rubric", k_rubric, "--size", "96x72",
                              "--gradescope", "results.json"});
    EXPECT_EQ(r.code, 0) << r.err;
    const auto json = nlohmann::json::parse(folder.read("results.json"));
    EXPECT_EQ(json["visibility"], "visible");
    EXPECT_EQ(json["output"],
              "Most points are lost by: shadows-missing (25 of 90). The points are provisional: a person "
              "reviews them.");
    ASSERT_EQ(json["tests"].size(), 7u);
    double score = 0, most = 0;
    for (const auto& test : json["tests"]) {
        EXPECT_TRUE(test["name"].is_string() && test["output"].is_string()) << test;
        EXPECT_EQ(test["status"], test["score"] == test["max_score"] ? "passed" : "failed");
        score += test["score"].get<double>();
        most += test["max_score"].get<double>();
    }
    EXPECT_EQ(score, 50);
    EXPECT_EQ(most, 90);
    EXPECT_EQ(json["tests"][1]["output"], "no file *diffuse*.png");
    EXPECT_EQ(json["tests"][0]["output"], "All points.");
    EXPECT_TRUE(contains(json["tests"][5]["output"], "Shadows are missing")) << json;
}

TEST_F(StudentResults, ForGradescopeWithPicturesAndWithoutCauses) {
    hand_in_two_mistakes("ada");
    const auto json = results(
        {"--gradescope", "results.json", "--pictures", "--hide-causes", "--visibility", "after_published"});
    EXPECT_EQ(json["visibility"], "after_published");
    EXPECT_FALSE(contains(json.dump(), "shadows-missing")) << json;
    for (const auto& test : json["tests"]) EXPECT_EQ(test["visibility"], "after_published");
    const auto& shadows = json["tests"][5];
    EXPECT_EQ(shadows["output_format"], "html");
    const std::string html = shadows["output"];
    EXPECT_TRUE(html.starts_with("<p>95.9% of all pixels are right, and 0% of those")) << html.substr(0, 200);
    std::vector<Image> pictures;
    for (std::size_t at = 0; (at = html.find("data:", at)) != std::string::npos; ++at)
        pictures.push_back(picture_of(html.substr(at, html.find('"', at) - at)));
    ASSERT_EQ(pictures.size(), 2u);
    EXPECT_EQ(pictures[0].width, 96);
    EXPECT_EQ(pictures[1].height, 72);
    EXPECT_FALSE(json["tests"][0].contains("output_format")) << "of a part with all its points";
}

TEST_F(StudentResults, ForPrairieLearn) {
    hand_in_two_mistakes("ada");
    const auto json = results({"--prairielearn", "results.json", "--pictures"});
    EXPECT_EQ(json["gradable"], true);
    EXPECT_NEAR(json["score"].get<double>(), 50.0 / 90, 1e-12);
    EXPECT_TRUE(contains(json["message"], "The points are provisional")) << json["message"];
    ASSERT_EQ(json["tests"].size(), 7u);
    for (const auto& test : json["tests"]) {
        EXPECT_TRUE(test["name"].is_string() && test["points"].is_number() &&
                    test["max_points"].is_number() && test["message"].is_string());
    }
    EXPECT_TRUE(contains(json["tests"][5]["message"], "Shadows are missing"));
    const auto& images = json["tests"][5]["images"];
    ASSERT_EQ(images.size(), 2u);
    EXPECT_EQ(images[0]["label"], "The picture");
    EXPECT_EQ(picture_of(images[1]["url"]).width, 96);
    EXPECT_FALSE(json["tests"][0].contains("images"));
    EXPECT_LT(folder.read("results.json").size(), 1'000'000u);
}

TEST_F(StudentResults, NothingToGradeIsAFormatErrorForPrairieLearn) {
    std::filesystem::create_directories(folder.path("ada"));
    const auto json = results({"--prairielearn", "results.json"});
    EXPECT_EQ(json["gradable"], false);
    ASSERT_EQ(json["format_errors"].size(), 7u);
    EXPECT_EQ(json["format_errors"][1], "diffuse: no file *diffuse*.png");
    EXPECT_FALSE(json.contains("score"));
}

TEST_F(StudentResults, OptionsThatDoNothingAreErrors) {
    hand_in_two_mistakes("ada");
    for (const std::string option : {"--pictures", "--hide-causes"}) {
        const Finished r = grade({"ada", "--scene", k_castle, "--rubric", k_rubric, option});
        EXPECT_EQ(r.code, 2);
        EXPECT_TRUE(contains(r.err, option + " needs --gradescope OUT or --prairielearn OUT")) << r.err;
    }
    const Finished r = grade({"ada", "--scene", k_castle, "--prairielearn", "r.json"});
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, "--prairielearn needs --rubric FILE")) << r.err;
}

TEST_F(StudentResults, SummaryOfAClass) {
    hand_in_two_mistakes("in/ada <b>");
    hand_in("in/ben");
    draw("in/ben/castle_shadows.png", {"--reflections", "0", "--no-shadows"});
    const Finished r =
        grade({"in", "--scene", k_castle, "--rubric", k_rubric, "--size", "96x72", "--summary", "c.html"});
    EXPECT_EQ(r.code, 0) << r.err;
    const std::string html = folder.read("c.html");
    EXPECT_TRUE(contains(html, "<h2 id=\"shadows-missing\">shadows-missing</h2>\n<p>Shadows are missing"))
        << html;
    EXPECT_TRUE(contains(html, "<p>2 submissions: ada &lt;b&gt;, shadows; ben, shadows</p>")) << html;
    EXPECT_TRUE(contains(html, "<td class=\"number\">50\n")) << html;
    EXPECT_TRUE(contains(html, "The points are provisional")) << html;
    EXPECT_TRUE(contains(html, "<figcaption>ben, shadows</figcaption>")) << html;
    EXPECT_TRUE(contains(html, "<a href=\"#not-handed-in\">not handed in</a>")) << html;
    // Without a rubric.
    draw("pictures/eve.png", {"--no-shadows"});
    draw("pictures/max.png", {});
    const Finished p = grade({"pictures", "--scene", k_castle, "--size", "96x72", "--summary", "p.html"});
    EXPECT_EQ(p.code, 0) << p.err;
    const std::string page = folder.read("p.html");
    EXPECT_TRUE(contains(page, "<p>1 submission: eve</p>")) << page;
    EXPECT_FALSE(contains(page, "max</p>")) << page;
}

TEST(PartPictures, AreDataUris) {
    // Lengths of 0, 1 and 2 beyond a multiple of three occur among these pictures.
    for (std::int32_t width = 1; width < 8; ++width) {
        Image image{width, 1, std::vector<float>(3 * static_cast<std::size_t>(width), 1)};
        image.rgb[0] = 0;
        EXPECT_EQ(picture_of(cli::png_data_uri(image)).rgb, image.rgb);
    }
}

}  // namespace
}  // namespace glint::test
