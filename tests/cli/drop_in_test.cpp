// SPDX-License-Identifier: Apache-2.0
// glint-tachyon and glint-povray: other programs' command lines.
#include <gtest/gtest.h>

#include "cli/drop_in.h"
#include "cli/failure.h"
#include "cli/process.h"

namespace glint::test {
namespace {

using cli::DropIn;
using cli::Failure;
using Setting = std::pair<std::string, std::string>;

bool has_setting(const DropIn& d, const Setting& setting) {
    const auto& all = d.render.scene.settings;
    return std::find(all.begin(), all.end(), setting) != all.end();
}
std::string failure_of(DropIn (*parse)(const std::vector<std::string>&),
                       const std::vector<std::string>& words) {
    try {
        parse(words);
    } catch (const Failure& e) {
        return e.what();
    }
    return {};
}

TEST(TachyonDropIn, HasTachyonsDefaults) {
    const DropIn d = cli::tachyon_drop_in({"a.dat"});
    EXPECT_EQ(d.render.scene.files, (std::vector<std::string>{"a.dat"}));
    EXPECT_EQ(d.render.scene.format, "tachyon");
    EXPECT_EQ(d.render.output, "outfile.tga");
    EXPECT_EQ(d.render.numbers.format, FileFormat::tga);
    EXPECT_TRUE(d.render.scene.further_texts.empty());
}

TEST(TachyonDropIn, TakesVmdsCommandLine) {
    const DropIn d = cli::tachyon_drop_in({"-aasamples", "12", "a.dat", "-trans_vmd", "-mediumshade", "-res",
                                           "200", "100", "-format", "TARGA", "-o", "a.dat.tga", "-numthreads",
                                           "4", "-raydepth", "8", "-shade_phong"});
    EXPECT_EQ(d.render.picture.size, "200x100");
    EXPECT_EQ(d.render.output, "a.dat.tga");
    EXPECT_EQ(d.render.threads, 4);
    EXPECT_TRUE(has_setting(d, {"aa", "4"})) << "13 samples";
    EXPECT_TRUE(has_setting(d, {"reflections", "7"}));
    EXPECT_TRUE(has_setting(d, {"shading", "phong"}));
    ASSERT_EQ(d.render.scene.further_texts.size(), 1u);
    EXPECT_EQ(d.render.scene.further_texts[0].second, "Shader_Mode Trans_VMD Medium End_Shader_Mode\n");
    EXPECT_TRUE(d.warnings.empty());
}

TEST(TachyonDropIn, SetsTheLightOfTheSky) {
    const DropIn d = cli::tachyon_drop_in({"a.dat", "-rescale_lights", "0.5", "-add_skylight", "0.8"});
    EXPECT_EQ(d.render.scene.further_texts.at(0).second,
              "Shader_Mode Rescale_Direct 0.5 End_Shader_Mode\nSky_Light NumSamples 128 Color 0.8 0.8 0.8\n");
    const DropIn by_itself =
        cli::tachyon_drop_in({"a.dat", "-auto_skylight", "0.75", "-skylight_samples", "9"});
    EXPECT_EQ(
        by_itself.render.scene.further_texts.at(0).second,
        "Shader_Mode Rescale_Direct 0.25 End_Shader_Mode\nSky_Light NumSamples 9 Color 0.75 0.75 0.75\n");
}

TEST(TachyonDropIn, NamesWhatItDoesNotKnow) {
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {}), "expected the name of a model file");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "-trans_vdm"}),
              "unknown flag '-trans_vdm'; did you mean `-trans_vmd`?");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "-aasamples"}), "-aasamples: expected a value");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "-raydepth", "x"}),
              "-raydepth: expected a number >= 0, found 'x'");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "-format", "BMP"}),
              "-format: glint-tachyon writes TARGA, PNG, PPM and PPM48, found 'BMP'");
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-normalize"}).warnings.size(), 1u);
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-nobounding", "-boundthresh", "9", "+V"}).warnings.size(), 0u);
}

class Povray : public testing::Test {
  protected:
    void SetUp() override {
        folder_.write("none.ini", "");
        setenv("POVINI", folder_.path("none.ini").c_str(), 1);
    }
    void TearDown() override { unsetenv("POVINI"); }
    Folder folder_;
};

TEST_F(Povray, TakesSwitches) {
    const DropIn d = cli::povray_drop_in(
        {"+Ia.pov", "+Oout.tga", "+W40.9", "+H30.33", "+FT", "-D", "+WT2", "+UA", "-V", "+Q3", "-P"});
    EXPECT_EQ(d.render.scene.files, (std::vector<std::string>{"a.pov"}));
    EXPECT_EQ(d.render.output, "out.tga");
    EXPECT_EQ(d.render.picture.size, "40x30") << "fractions are cut off";
    EXPECT_EQ(d.render.picture.aa, "1");
    EXPECT_EQ(d.render.numbers.format, FileFormat::tga);
    EXPECT_EQ(d.render.threads, 2);
    EXPECT_TRUE(d.render.picture.alpha);
    EXPECT_TRUE(d.render.quiet);
    EXPECT_TRUE(has_setting(d, {"shadows", "false"}));
    EXPECT_FALSE(has_setting(d, {"shading", "color"}));
}

TEST_F(Povray, HasPovraysDefaults) {
    const DropIn d = cli::povray_drop_in({"folder/a.pov"});
    EXPECT_EQ(d.render.picture.size, "320x240");
    EXPECT_EQ(d.render.output, "a.png");
    EXPECT_EQ(d.render.numbers.format, FileFormat::png);
    EXPECT_EQ(d.render.numbers.bits, 8);
    EXPECT_EQ(cli::povray_drop_in({"+Ia", "+FN16"}).render.numbers.bits, 16);
    EXPECT_EQ(cli::povray_drop_in({"+Ia", "+Ob"}).render.output, "b.png");
    EXPECT_EQ(cli::povray_drop_in({"+Ia", "+O-"}).render.output, "-");
    EXPECT_EQ(cli::povray_drop_in({"+Ia"}).render.scene.files.at(0), "a.pov");
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "+A"}).render.picture.aa, "adaptive:3:0.1");
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "+A0.6", "+R2"}).render.picture.aa, "adaptive:2:0.2");
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "-F"}).render.output, "/dev/null");
}

TEST_F(Povray, ReadsIniFiles) {
    folder_.write(
        "ase.ini",
        "; a comment\nInput_File_Name=water.pov\nOutput_to_File=True\nOutput_File_Type=N\nOutput_Alpha=off\n"
        "Width=400\nHeight=303.33\nAntialias=True\nAntialias_Threshold=0.1\nDisplay=False\n"
        "Pause_When_Done=True\nVerbose=False\n+R2 +WT1\n[small]\nWidth = 20\n");
    const DropIn d = cli::povray_drop_in({folder_.path("ase.ini")});
    EXPECT_EQ(d.render.scene.files.at(0), "water.pov");
    EXPECT_EQ(d.render.picture.size, "400x303");
    EXPECT_EQ(d.render.output, "water.png");
    EXPECT_EQ(d.render.picture.aa, "adaptive:2:0.03333");
    EXPECT_FALSE(d.render.picture.alpha);
    EXPECT_TRUE(d.render.quiet);
    EXPECT_EQ(d.render.threads, 1);
    EXPECT_EQ(cli::povray_drop_in({folder_.path("ase.ini") + "[small]"}).render.picture.size, "20x303");
    EXPECT_EQ(cli::povray_drop_in({folder_.path("ase.ini"), "Width=50"}).render.picture.size, "50x303");
}

TEST_F(Povray, NamesWhatItDoesNotKnow) {
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"+W40"}), "expected the name of a scene: +Iscene.pov");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "+Zork"}), "unknown switch '+Zork'");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "Foo=1"}), "unknown key 'Foo'");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "+KFF10"}),
              "'+KFF10': glint-povray renders one picture, no animation");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "+FJ"}),
              "'+FJ': glint-povray writes N (PNG), T (TGA), P (PPM) and E (OpenEXR)");
    folder_.write("bad.ini", "Width=40\nWidht=3\n");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {folder_.path("bad.ini")}),
              folder_.path("bad.ini") + ":2: unknown key 'Widht'");
    EXPECT_NE(failure_of(cli::povray_drop_in, {"nosuch.ini"}), "");
}

}  // namespace
}  // namespace glint::test
