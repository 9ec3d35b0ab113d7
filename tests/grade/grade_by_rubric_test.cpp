// SPDX-License-Identifier: Apache-2.0
// Points by a rubric, of pictures in memory. tests/cli has those of files.
#include "grade/grade_by_rubric.h"

#include <gtest/gtest.h>

#include <map>

#include "glint/glint.h"
#include "grade/grading.h"

namespace glint::test {
namespace {

constexpr std::string_view k_rubric = R"(
all      4  all    without shadows=false
diffuse  2  diffuse  shading=diffuse
again    6  all    without shadows=false
)";

Scene some_scene() {
    Scene scene;
    scene.settings.width = 48;
    scene.settings.height = 36;
    scene.camera.position = {0, 2, 7};
    scene.materials.push_back({.diffuse = {0.8, 0.3, 0.2}, .specular = {0.4, 0.4, 0.4}});
    scene.add(Sphere{.center = {0, 0, 0}, .radius = 1}, 0);
    scene.add(Plane{.point = {0, -1, 0}, .normal = {0, 1, 0}}, 0);
    scene.lights.push_back({.position = {3, 5, 4}});
    return scene;
}

Image picture_of(Scene scene, bool shadows, Shading shading) {
    scene.settings.shadows = shadows;
    scene.settings.shading = shading;
    return render(*prepare(scene)).value().image;
}

class Pictures : public Submissions {
  public:
    std::vector<std::pair<std::string, std::map<std::string, Image>>> pictures;
    std::vector<std::string> shown;
    std::function<void()> found = [] {};

    std::vector<std::string> names() const override {
        std::vector<std::string> names;
        for (const auto& [name, files] : pictures) names.push_back(name);
        return names;
    }
    HandedIn find(std::size_t submission, const RubricRow& row) override {
        found();
        const auto& files = pictures[submission].second;
        const auto at = files.find(row.file);
        if (at == files.end()) return {{}, "no file " + row.file, {}};
        return {at->first, {}, at->second};
    }
    void show_wanted(std::size_t row, const Image&) override {
        shown.push_back("row " + std::to_string(row));
    }
    void show(std::size_t submission, std::size_t row, const Image&, const Image* wanted) override {
        shown.push_back(std::to_string(submission) + "," + std::to_string(row) +
                        (wanted != nullptr ? "" : "?"));
    }
    void show_same(std::size_t from, std::size_t to) override {
        shown.push_back(std::to_string(from) + "=" + std::to_string(to));
    }
};

Pictures some_class() {
    const Scene scene = some_scene();
    const Image right = picture_of(scene, true, scene.settings.shading),
                diffuse = picture_of(scene, true, Shading::diffuse);
    Pictures pictures;
    pictures.pictures = {{"ada", {{"all", right}, {"diffuse", diffuse}}},
                         {"bob", {{"all", picture_of(scene, false, scene.settings.shading)}}},
                         {"eve", {{"all", Image{2, 1, std::vector<float>(6)}}, {"diffuse", diffuse}}}};
    return pictures;
}

TEST(GradeByRubric, PicturesInMemory) {
    Pictures pictures = some_class();
    const Scene scene = some_scene();
    const Rubric rubric = read_rubric("r", k_rubric).rubric;
    ASSERT_EQ(rubric.rows.size(), 3u);
    std::vector<double> fractions;
    RubricOptions options;
    options.progress = [&](double fraction) { fractions.push_back(fraction); };
    const auto graded = grade_by_rubric(scene, rubric, pictures, options);
    ASSERT_TRUE(graded) << graded.message;
    ASSERT_EQ(graded->size(), 3u);
    const GradedSubmission &ada = (*graded)[0], &bob = (*graded)[1], &eve = (*graded)[2];
    EXPECT_EQ(ada.name, "ada");
    EXPECT_EQ(ada.total(), 12);
    EXPECT_EQ(bob.parts[0].score.points, 0);
    ASSERT_TRUE(bob.parts[0].cause);
    EXPECT_EQ(bob.parts[0].cause->name, "shadows-missing");
    EXPECT_EQ(bob.parts[1].error, "no file diffuse");
    EXPECT_EQ(bob.parts[2].cause->name, "shadows-missing");
    EXPECT_EQ(eve.parts[0].error, "2x1 pixels, expected 48x36");
    EXPECT_EQ(eve.total(), 2);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1);
    EXPECT_EQ(pictures.shown,
              (std::vector<std::string>{"row 1", "0,1", "2,1", "row 0", "0,0", "1,0", "2,0?", "0=2"}));
}

TEST(GradeByRubric, CanBeCancelled) {
    Pictures pictures = some_class();
    std::atomic<bool> cancel{false};
    int calls = 0;
    pictures.found = [&] { cancel = ++calls == 2; };
    RubricOptions options;
    options.cancel = &cancel;
    EXPECT_EQ(grade_by_rubric(some_scene(), read_rubric("r", k_rubric).rubric, pictures, options).code,
              ErrorCode::cancelled);
    EXPECT_EQ(calls, 2);
}

TEST(GradeByRubric, NamesThePartThatCannotBeRendered) {
    Pictures pictures = some_class();
    Scene scene = some_scene();
    scene.get<Sphere>().front().radius = -1;
    const auto graded = grade_by_rubric(scene, read_rubric("r", k_rubric).rubric, pictures);
    EXPECT_EQ(graded.code, ErrorCode::invalid_argument);
    EXPECT_EQ(graded.message.rfind("r:3: part 'diffuse': ", 0), 0u) << graded.message;
}

TEST(Points, AreRoundedToHundredths) {
    EXPECT_EQ(points_of(10, 1.0 / 3), 3.33);
    EXPECT_EQ(points_of(10, 0), 0);
    EXPECT_EQ(points_of(0.004, 1), 0.004) << "all points of a row are its points";
    EXPECT_EQ(points_of(0.004, 0.9), 0);
    EXPECT_EQ(points_of(0.996, 0.9999), 0.996) << "never more than the row has";
}

}  // namespace
}  // namespace glint::test
