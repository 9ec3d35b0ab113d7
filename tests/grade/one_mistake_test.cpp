// SPDX-License-Identifier: Apache-2.0
// One mistake of a program costs one part, whatever the order of the rubric's lines.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "compare/render_scene.h"
#include "compare/scene_faults.h"
#include "glint/glint.h"
#include "grade/count_faults.h"
#include "grade/grade_by_rubric.h"
#include "grade/rubric_order.h"

namespace glint::test {
namespace {

constexpr std::string_view k_tasks[] = {
    "ambient 5 ambient lights=ambient shadows=false reflections=0\n",
    "diffuse 15 diffuse shading=diffuse shadows=false reflections=0 without lights=ambient\n",
    "phong 10 phong shading=phong shadows=false reflections=0 without shading=diffuse\n",
    "shadows 25 shadows shading=phong reflections=0 without shadows=false\n",
    "reflections 20 reflections shading=phong reflections=3 without reflections=0\n",
};

// What a program does wrong.
struct Program {
    std::string name;
    std::string scene_fault;  // a row of the tables of faults
    TracerFault fault = TracerFault::none;
    void (*edit)(Image&) = nullptr;
};

void swap_red_and_blue(Image& image) {
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) std::swap(image.rgb[i], image.rgb[i + 2]);
}
void apply_gamma(Image& image) {
    for (float& v : image.rgb) v = std::pow(std::clamp(v, 0.0F, 1.0F), 1 / 2.2F);
}
void take_square_root(Image& image) {
    for (float& v : image.rgb) v = std::sqrt(std::clamp(v, 0.0F, 1.0F));
}
void turn_upside_down(Image& image) {
    const auto row = static_cast<std::ptrdiff_t>(image.width) * 3;
    for (std::ptrdiff_t y = 0; y < image.height / 2; ++y)
        std::swap_ranges(image.rgb.begin() + y * row, image.rgb.begin() + (y + 1) * row,
                         image.rgb.end() - (y + 1) * row);
}

const std::vector<Program> k_class = {
    {"right", ""},
    {"bgr", "", TracerFault::none, swap_red_and_blue},
    {"gamma", "", TracerFault::none, apply_gamma},
    {"root", "", TracerFault::none, take_square_root},
    {"upside-down", "", TracerFault::none, turn_upside_down},
    {"aspect", "aspect-missing"},
    {"l", "", TracerFault::light_not_unit},
    {"n", "", TracerFault::normal_not_unit},
    {"ambient", "ambient-missing"},
    {"shadows", "shadows-missing"},
    {"ambient and bgr", "ambient-missing", TracerFault::none, swap_red_and_blue}};

Scene some_spheres() {
    Scene scene;
    scene.settings.width = 96;
    scene.settings.height = 64;
    scene.settings.reflections = 3;
    scene.camera.position = {0.4, 2, 8};
    scene.background = {0.1, 0.15, 0.25};
    const Color colors[] = {{0.8, 0.3, 0.2}, {0.3, 0.7, 0.3}, {0.3, 0.4, 0.9}, {0.6, 0.55, 0.5}};
    for (const Color& color : colors) {
        scene.materials.push_back({.ambient = color * 0.5,
                                   .diffuse = color,
                                   .specular = {0.4, 0.4, 0.4},
                                   .shininess = 20,
                                   .mirror = 0.3});
    }
    scene.add(Sphere{.center = {-1.6, 0.2, 0}, .radius = 1.2}, 0);
    scene.add(Sphere{.center = {0.6, 0, 1.4}, .radius = 1}, 1);
    scene.add(Sphere{.center = {2.2, 0.3, -0.6}, .radius = 1.3}, 2);
    scene.add(Plane{.point = {0, -1, 0}, .normal = {0, 1, 0}}, 3);
    scene.lights.push_back({.kind = LightKind::ambient, .color = {0.3, 0.3, 0.3}});
    scene.lights.push_back({.position = {4, 6, 5}, .color = {0.6, 0.6, 0.6}});
    scene.lights.push_back({.position = {-5, 5, 3}, .color = {0.4, 0.4, 0.4}});
    return scene;
}

void put(Scene& scene, const std::string& name) {
    for (const auto faults : {lighting_faults(), tracing_faults(), camera_faults()}) {
        for (const SceneFault& fault : faults) {
            if (name != fault.name || !fault.put) continue;
            if (fault.applies(scene)) fault.put(scene);
            return;
        }
    }
    FAIL() << "no fault " << name;
}

class Programs : public Submissions {
  public:
    explicit Programs(const Scene& scene) : scene_(scene), world_(prepare(scene).value()) {}
    std::vector<std::string> names() const override {
        std::vector<std::string> names;
        for (const Program& program : k_class) names.push_back(program.name);
        return names;
    }
    HandedIn find(std::size_t submission, const RubricRow& row) override {
        if (left_out == row.part) return {{}, "no file", {}};
        const Program& program = k_class[submission];
        Image& image = pictures_[{submission, row.part}];
        if (image.rgb.empty()) {
            Scene faulty = with_settings(scene_, row.settings);
            if (!program.scene_fault.empty()) put(faulty, program.scene_fault);
            image = render_scene(world_, faulty, program.fault, 2).value().image;
            if (program.edit) program.edit(image);
            for (float& v : image.rgb) v = std::round(std::clamp(v, 0.0F, 1.0F) * 255) / 255;
        }
        return {row.file, {}, image};
    }
    std::string left_out;

  private:
    const Scene scene_;
    const World world_;
    std::map<std::pair<std::size_t, std::string>, Image> pictures_;
};

Rubric rubric_of(std::vector<std::size_t> order, const std::string& more = "") {
    std::string text;
    for (const std::size_t i : order) text += k_tasks[i];
    RubricResult read = read_rubric("r", text + more);
    EXPECT_TRUE(read.diagnostics.empty());
    return read.rubric;
}

using PointsByPart = std::map<std::string, double>;
std::vector<PointsByPart> points_by_part(const Rubric& rubric, const std::vector<GradedSubmission>& graded) {
    std::vector<PointsByPart> all;
    for (const GradedSubmission& s : graded) {
        PointsByPart points;
        for (std::size_t k = 0; k < s.parts.size(); ++k)
            points[rubric.rows[k].part] = s.parts[k].score.points;
        all.push_back(std::move(points));
    }
    return all;
}

TEST(OneMistake, CostsOnePartInAnyOrder) {
    const Scene scene = some_spheres();
    Programs programs(scene);
    const Rubric rubric = rubric_of({0, 1, 2, 3, 4});
    const auto graded = grade_by_rubric(scene, rubric, programs).value();
    for (std::size_t i = 0; i < graded.size(); ++i) {
        int lower = 0;
        std::string text;
        for (std::size_t k = 0; k < rubric.rows.size(); ++k) {
            const GradedPart& part = graded[i].parts[k];
            lower += part.score.points < rubric.rows[k].points;
            text += fmt::format(" {} {}/{}", rubric.rows[k].part, part.score.points, part.points_alone);
            if (part.cause) {
                text += " " + part.cause->name;
                EXPECT_GT(part.cause->explained, 0.2) << graded[i].name << text;
            }
        }
        const int mistakes = graded[i].name == "right" ? 0 : graded[i].name == "ambient and bgr" ? 2 : 1;
        EXPECT_EQ(lower, mistakes) << graded[i].name << text;
    }
    for (const auto& order : {std::vector<std::size_t>{4, 3, 2, 1, 0}, {2, 0, 4, 1, 3}}) {
        const Rubric other = rubric_of(order);
        EXPECT_EQ(points_by_part(other, grade_by_rubric(scene, other, programs).value()),
                  points_by_part(rubric, graded));
    }
}

// The other model is one of highlights: without them, a picture that has some is not explained by it.
TEST(OneMistake, OfTheModelDoesNotShowWithoutHighlights) {
    for (const SceneFault& fault : lighting_faults()) {
        if (!std::string_view(fault.name).starts_with("shading-model")) continue;
        Scene scene = some_spheres();
        scene.settings.shading = Shading::diffuse;
        fault.put(scene);
        EXPECT_EQ(scene.settings.shading, Shading::diffuse);
    }
}

// The part of the mistake is not handed in: it costs nothing more.
TEST(OneMistake, CostsNothingMoreThanAMissingPart) {
    const Scene scene = some_spheres();
    Programs programs(scene);
    programs.left_out = "ambient";
    const auto graded = grade_by_rubric(scene, rubric_of({0, 1, 2, 3, 4}), programs).value();
    for (const GradedSubmission& s : graded) {
        if (s.name == "ambient") {
            EXPECT_EQ(s.total(), 70);
        }
    }
}

TEST(OneMistake, APenaltyIsTakenOffInstead) {
    const Scene scene = some_spheres();
    Programs programs(scene);
    const Rubric rubric =
        rubric_of({0, 1, 2, 3, 4}, "penalty gamma-applied 2\npenalty red-blue-swapped 1.5\npenalty acne 70");
    ASSERT_EQ(rubric.penalties.size(), 3u);
    for (const GradedSubmission& s : grade_by_rubric(scene, rubric, programs).value()) {
        const double off = s.name == "gamma" || s.name == "root" ? 2 : s.name == "bgr" ? 1.5 : 0;
        if (off == 0) continue;
        EXPECT_EQ(s.total(), 75 - off) << s.name;
        ASSERT_EQ(s.penalties.size(), 1u);
        EXPECT_EQ(s.penalties.front().points, off);
    }
}

TEST(RubricOrder, DoesNotDependOnTheLines) {
    const auto names = [](const std::vector<std::size_t>& order) {
        const Rubric rubric = rubric_of(order);
        std::vector<std::string> names;
        for (const EqualRows& equal : judging_order(rubric.rows))
            names.push_back(rubric.rows[equal.first()].part);
        return names;
    };
    EXPECT_EQ(names({0, 1, 2, 3, 4}),
              (std::vector<std::string>{"ambient", "phong", "diffuse", "reflections", "shadows"}));
    EXPECT_EQ(names({4, 1, 3, 2, 0}), names({0, 1, 2, 3, 4}));
}

TEST(PartsThatPay, AreThoseThatAFaultSpoilsMost) {
    std::vector<PartLosses> parts(3);
    parts[0].lost_factors = {0.1, 1};
    parts[1].lost_factors = {1, 1};
    parts[2].lost_factors = {1, 0};
    using Pays = std::vector<std::optional<std::size_t>>;
    EXPECT_EQ(parts_that_pay(parts, {false, false}), (Pays{1, 0}));
    EXPECT_EQ(parts_that_pay(parts, {true, false}), (Pays{std::nullopt, 0}));
    parts.resize(1);
    EXPECT_EQ(parts_that_pay(parts, {false, false}), (Pays{0, 0})) << "two in one part";
    parts[0].lost_factors = {0, 0};
    EXPECT_EQ(parts_that_pay(parts, {false, false}), (Pays{std::nullopt, std::nullopt}));
}

TEST(Penalties, NamesAreChecked) {
    const RubricResult read = read_rubric("r",
                                          "penalty gama-applied 2\npenalty acne\npenalty acne 0\n"
                                          "penalty acne 1\npenalty acne 2\npenalty 5 all\n");
    std::string text;
    for (const Diagnostic& d : read.diagnostics)
        text += fmt::format("{}:{}: {}\n", d.line, d.column, d.message);
    EXPECT_EQ(text,
              "1:9: docs/compare.md has no cause 'gama-applied'; did you mean `gamma-applied`?\n2:9: "
              "expected penalty CAUSE POINTS\n3:14: expected the penalty's points, a number "
              "above 0 and at most 1000000, found '0'\n5:9: 'acne' has a penalty already\n");
    ASSERT_EQ(read.rubric.rows.size(), 1u) << "a part that is called penalty";
    EXPECT_EQ(read.rubric.rows[0].part, "penalty");
}

}  // namespace
}  // namespace glint::test
