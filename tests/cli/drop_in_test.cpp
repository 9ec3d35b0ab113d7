// SPDX-License-Identifier: Apache-2.0
// glint-tachyon and glint-povray: other programs' command lines.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/drop_in.h"
#include "cli/failure.h"
#include "cli/foreign_table.h"
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
    EXPECT_EQ(d.render.scene.further_texts[0].second, "Shader_Mode Medium Trans_VMD End_Shader_Mode\n");
    EXPECT_TRUE(d.warnings.empty());
}

// The text that the flags become is one that the reader takes, whatever their order.
TEST(TachyonDropIn, TakesShadersAfterOtherModes) {
    const std::string scene = "Begin_Scene Resolution 4 4 Sphere Center 0 0 5 Rad 1 t End_Scene";
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"a.dat", "-trans_vmd", "-shadow_filter_off", "-mediumshade"},
          {"a.dat", "-fullshade", "-mediumshade", "-trans_vmd", "-shadow_filter_off"},
          {"-mediumshade", "-trans_vmd", "a.dat", "-shadow_filter_off"}}) {
        const DropIn d = cli::tachyon_drop_in(words);
        const std::string& modes = d.render.scene.further_texts.at(0).second;
        EXPECT_EQ(modes, "Shader_Mode Medium Trans_VMD Shadow_Filter_Off End_Shader_Mode\n");
        const SceneText texts[] = {{"a.dat", scene, "tachyon"}, {"command line", modes, "tachyon"}};
        const auto loaded = load(texts);
        EXPECT_TRUE(loaded) << to_string(loaded);
    }
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

// As they stand in VMD's variable, in tutorials and in scripts, and as Sage calls it.
TEST(TachyonDropIn, TakesTheLinesOfUsers) {
    const auto text_of = [](const std::vector<std::string>& words) {
        const DropIn d = cli::tachyon_drop_in(words);
        EXPECT_TRUE(d.warnings.empty()) << d.warnings.front();
        return d.render.scene.further_texts.empty() ? "" : d.render.scene.further_texts[0].second;
    };
    EXPECT_EQ(text_of({"-aasamples", "12", "a.dat", "-format", "TARGA", "-o", "a.dat.tga"}), "");
    EXPECT_EQ(text_of({"a.dat", "-aasamples", "4", "-trans_vmd", "-mediumshade", "-format", "TARGA"}),
              "Shader_Mode Medium Trans_VMD End_Shader_Mode\n");
    EXPECT_EQ(text_of({"a.dat", "-fullshade", "-shade_phong", "-trans_vmd", "-aasamples", "32", "-res",
                       "1080", "1080"}),
              "Shader_Mode Full Trans_VMD End_Shader_Mode\n");
    EXPECT_EQ(text_of({"a.dat", "-trans_vmd", "-shade_blinn", "-fullshade", "-aasamples", "10",
                       "-rescale_lights", "0.5", "-add_skylight", "0.8"}),
              "Shader_Mode Full Trans_VMD Rescale_Direct 0.5 End_Shader_Mode\n"
              "Sky_Light NumSamples 128 Color 0.8 0.8 0.8\n");
    EXPECT_EQ(text_of({"a.dat", "-trans_vmd", "-shadow_filter_off", "-fog_vmd", "-numthreads", "4"}),
              "Shader_Mode Trans_VMD Shadow_Filter_Off Fog_VMD End_Shader_Mode\n");
    EXPECT_EQ(text_of({"-trans_max_surfaces", "2", "-trans_orig", "-fog_normal", "a.dat", "+V"}),
              "Shader_Mode Trans_Max_Surfaces 2 Trans_Orig Fog_Radial End_Shader_Mode\n");
    EXPECT_EQ(text_of({"/tmp/a.dat", "-format", "PNG", "-o", "/tmp/a.png", "-res", "400", "400", "+V"}), "");
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-res", "1620.0", "910.5"}).render.picture.size, "1620x910");
}

TEST(TachyonDropIn, NamesThePictureByTheFormat) {
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-format", "PNG"}).render.output, "outfile.png");
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-format", "ppm48"}).render.output, "outfile.ppm");
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-format", "BMP"}).render.output, "outfile.bmp");
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-format", "jpeg"}).render.output, "outfile.jpg");
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-format", "JPEG", "-o", "x.tga"}).render.numbers.format,
              FileFormat::jpeg);
    EXPECT_EQ(cli::tachyon_drop_in({"a.dat", "-format", "PNG", "-o", "x.tga"}).render.numbers.format,
              FileFormat::png);
    EXPECT_EQ(cli::tachyon_drop_in({"-nosave", "a.dat", "-o", "x.tga"}).render.output, "/dev/null");
}

// In Tachyon the automatic light replaces the other two, wherever it stands.
TEST(TachyonDropIn, IgnoresTheOrderOfTheLightsFlags) {
    const std::string all =
        "Shader_Mode Rescale_Direct 0.25 End_Shader_Mode\n"
        "Sky_Light NumSamples 128 Color 0.75 0.75 0.75\n";
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"a.dat", "-auto_skylight", "0.75", "-rescale_lights", "0.5",
                                   "-add_skylight", "1"},
          {"a.dat", "-add_skylight", "1", "-rescale_lights", "0.5", "-auto_skylight", "0.75"}})
        EXPECT_EQ(cli::tachyon_drop_in(words).render.scene.further_texts.at(0).second, all);
    EXPECT_TRUE(cli::tachyon_drop_in({"a.dat", "-rescale_lights", "1.5"}).render.scene.further_texts.empty());
}

// Every flag of Tachyon's is in the help.
TEST(TachyonDropIn, HelpHasEveryFlag) {
    const std::string help = cli::drop_in_help(cli::k_tachyon_program);
    for (const cli::ForeignFlag& flag : cli::tachyon_flags()) {
        if (flag.flag == "-verbose") continue;  // not Tachyon's
        EXPECT_TRUE(contains(help, std::string(flag.flag))) << flag.flag;
    }
}

TEST(TachyonDropIn, NamesWhatItDoesNotKnow) {
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "b.dat"}),
              "glint-tachyon renders one scene, found 'a.dat' and 'b.dat'");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {}), "expected the name of a model file");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "-trans_vdm"}),
              "unknown flag '-trans_vdm'; did you mean `-trans_vmd`?");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "-aasamples"}),
              "-aasamples: expected a value, found nothing");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "-raydepth", "x"}),
              "-raydepth: expected a number >= 0, found 'x'");
    EXPECT_EQ(failure_of(cli::tachyon_drop_in, {"a.dat", "-format", "RGB"}),
              "-format: glint-tachyon writes TARGA, PNG, PPM, PPM48, BMP and JPEG, found 'RGB'; PNG loses "
              "nothing");
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

// The lines of VMD, PyMOL, LeoCAD and Avogadro.
TEST_F(Povray, TakesTheLinesOfPrograms) {
    const DropIn vmd = cli::povray_drop_in(
        {"+W400", "+H300", "-Ivmdscene.pov", "-Ovmdscene.pov.tga", "+D", "+X", "+A", "+FT"});
    EXPECT_EQ(vmd.render.scene.files, (std::vector<std::string>{"vmdscene.pov"}));
    EXPECT_EQ(vmd.render.output, "vmdscene.pov.tga");
    EXPECT_EQ(vmd.render.numbers.format, FileFormat::tga);
    EXPECT_EQ(vmd.render.picture.aa, "adaptive:3:0.1");
    const DropIn pymol =
        cli::povray_drop_in({"+FN", "-D", "+Itmp_pymol.pov", "+Otmp_pymol.png", "+W320", "+H240", "+A"});
    EXPECT_EQ(pymol.render.output, "tmp_pymol.png");
    EXPECT_EQ(pymol.render.picture.size, "320x240");
    const DropIn leocad = cli::povray_drop_in(
        {"+C", "+W1280", "+H720", "+A0.1", "+J0", "+R3", "+Omodel.png", "+Imodel.pov", "-D"});
    EXPECT_EQ(leocad.render.picture.aa, "adaptive:3:0.03333");
    const DropIn avogadro = cli::povray_drop_in(
        {"+Imol.pov", "+Omol.png", "+W640", "+H480", "-V", "+FN", "+Q9", "+A0.300000", "+UA"});
    EXPECT_TRUE(avogadro.render.picture.alpha);
    EXPECT_TRUE(avogadro.render.quiet);
    for (const DropIn* d : {&vmd, &pymol, &leocad, &avogadro}) EXPECT_TRUE(d->warnings.empty());
}

TEST_F(Povray, HasPovraysDefaults) {
    const DropIn d = cli::povray_drop_in({"folder/a.pov"});
    EXPECT_EQ(d.render.picture.size, "320x240");
    EXPECT_EQ(d.render.output, "folder/a.png");
    EXPECT_EQ(d.render.numbers.format, FileFormat::png);
    EXPECT_EQ(d.render.numbers.bits, 8);
    EXPECT_EQ(cli::povray_drop_in({"+Ia", "+FN16"}).render.numbers.bits, 16);
    EXPECT_EQ(cli::povray_drop_in({"+Ia", "+Ob"}).render.output, "b.png");
    EXPECT_EQ(cli::povray_drop_in({"+Ia", "+O-"}).render.output, "-");
    const std::pair<std::vector<std::string>, const char*> names[] = {
        {{"+Ox.tga"}, "x.tga.png"},          {{"+Ox.tga", "+FT"}, "x.tga"}, {{"+Ox.TGA", "+FT"}, "x.TGA.tga"},
        {{"+Ox.jpeg", "+FJ"}, "x.jpeg.jpg"}, {{"+Ox.v2"}, "x.v2.png"},      {{"+Ox."}, "x.png"},
        {{"+O/dev/null"}, "/dev/null"},      {{"+Oq/"}, "q/a.png"}};
    for (auto [words, name] : names) {
        words.push_back("+Ia");
        EXPECT_EQ(cli::povray_drop_in(words).render.output, name);
    }
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

// As Blender writes them; POV-Ray takes both kinds of quotes.
TEST_F(Povray, TakesQuotesInIniFiles) {
    folder_.write("quotes.ini",
                  "Input_File_Name='a;b.pov' ; a comment\nOutput_File_Name=\"x y.png\"\n+W60 +H40 "
                  "Antialias=on +L'a folder'\n");
    const DropIn d = cli::povray_drop_in({folder_.path("quotes.ini")});
    EXPECT_EQ(d.render.scene.files.at(0), "a;b.pov");
    EXPECT_EQ(d.render.output, "x y.png");
    EXPECT_EQ(d.render.picture.size, "60x40");
    EXPECT_EQ(d.render.picture.aa, "adaptive:3:0.1");
    EXPECT_EQ(d.render.scene.include_paths.at(0), "a folder");
    EXPECT_EQ(cli::povray_drop_in({"+I\"a.pov\"", "+O'b c.png'"}).render.output, "b c.png");
}

TEST_F(Povray, TakesSeveralOptionsInOneArgument) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"+Ia.pov +Ox.png  +W60", "+H40 -A"},
          {"Input_File_Name=a.pov Output_File_Name=x.png", "Width=60 +H40 +WL0"}}) {
        const DropIn d = cli::povray_drop_in(words);
        EXPECT_EQ(d.render.scene.files.at(0), "a.pov");
        EXPECT_EQ(d.render.output, "x.png");
        EXPECT_EQ(d.render.picture.size, "60x40");
    }
    EXPECT_EQ(cli::povray_drop_in({"my scene.pov"}).render.scene.files.at(0), "my scene.pov");
}

TEST_F(Povray, DeclaresNumbers) {
    using Declared = std::vector<std::pair<std::string, double>>;
    const DropIn d = cli::povray_drop_in({"+Ia.pov", "+K0.5", "Declare=Big=-1e2", "Declare=Big=3"});
    EXPECT_EQ(d.render.scene.declared, (Declared{{"clock", .5}, {"Big", 3}}));
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "Declare=Big=Foo"}),
              "'Declare=Big=Foo': expected a number");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "Declare=Big"}),
              "'Declare=Big': expected NAME=NUMBER");
}

std::string frames_text(const DropIn& d) {
    std::string text;
    for (const cli::DropInFrame& frame : d.frames) {
        text += frame.output;
        for (const auto& [name, value] : frame.declared)
            if (name == "clock" || name == "final_frame") text += fmt::format(" {:.4g}", value);
        text += "; ";
    }
    return text;
}

// Names, clocks and final_frame are POV-Ray's (measured).
TEST_F(Povray, TakesAnimations) {
    const auto frames = [](std::vector<std::string> words) {
        words.insert(words.end(), {"+Ia.pov", "+Oq"});
        return frames_text(cli::povray_drop_in(words));
    };
    const auto numbers = [](std::vector<std::string> words) {
        words.insert(words.end(), {"+Ia.pov", "+Oq"});
        std::string text;
        for (const cli::DropInFrame& frame : cli::povray_drop_in(words).frames)
            text += fmt::format("{:.0f} ", frame.declared.at(1).second);
        return text;
    };
    EXPECT_EQ(frames({}), "");
    EXPECT_EQ(frames({"+KI3", "+KF4", "+SF2"}), "") << "not an animation";
    EXPECT_EQ(frames({"+KFF0"}), "");
    EXPECT_EQ(frames({"+KFF3"}), "q1.png 0 3; q2.png 0.5 3; q3.png 1 3; ");
    EXPECT_EQ(frames({"+KFI2", "+KFF4"}), "q2.png 0 4; q3.png 0.5 4; q4.png 1 4; ");
    EXPECT_EQ(frames({"+KI2", "+KF5", "+KFF3", "+K7"}), "q1.png 2 3; q2.png 3.5 3; q3.png 5 3; ");
    EXPECT_EQ(frames({"+KFF2", "Cyclic_Animation=on"}), "q1.png 0 3; q2.png 0.5 3; ");
    EXPECT_EQ(frames({"+KFF5", "Frame_Step=2"}), "q1.png 0 5; q3.png 0.5 5; q5.png 1 5; ");
    EXPECT_EQ(frames({"+KFF12", "+SF12"}), "q12.png 1 12; ");
    EXPECT_EQ(frames({"+KFF11", "+EF1"}), "q01.png 0 11; ");
    EXPECT_EQ(frames({"+KFF9", "+KC", "+EF1"}), "q01.png 0 10; ");
    EXPECT_EQ(frames({"+KFI5", "+KFF14", "+SF0.3", "+EF0.55"}), "q05.png 0 14; ");
    EXPECT_EQ(frames({"+KFF9", "+SF0.9"}), "q8.png 0.875 9; q9.png 1 9; ");
    EXPECT_EQ(numbers({"+KFF9", "+SF0.5"}), "4 5 6 7 8 9 ");
    EXPECT_EQ(numbers({"+KFF9", "+KC", "+SF0.5"}), "5 6 7 8 9 ") << "half of 10";
    EXPECT_EQ(numbers({"+KFF9", "+KC", "+EF0.5"}), "1 2 3 4 5 ");
    EXPECT_EQ(numbers({"+KFF9", "+KC", "+SF0.5", "+EF0.8"}), "5 6 7 8 ");
    EXPECT_EQ(numbers({"+KFF9", "+KC", "+SF9", "+EF10"}), "9 10 ");
    EXPECT_EQ(numbers({"+KFF9", "+KC", "+SF9"}), "9 ");
    EXPECT_EQ(numbers({"+KFF9", "+KC", "+SF10"}), "10 ");
    EXPECT_EQ(numbers({"+KFF9", "+SF8", "+EF11"}), "8 9 10 11 ");
    EXPECT_EQ(numbers({"+KFI3", "+KFF12", "+KC", "+SF0.5"}), "5 6 7 8 9 10 11 12 ");
    EXPECT_EQ(frames({"+KFF3", "+SF5"}), "q5.png 2 3; ") << "beyond the last one";
    EXPECT_EQ(numbers({"+KFF3", "+SF3", "+EF2"}), "3 ");
    EXPECT_EQ(frames({"+KFF9", "+KC", "+SF10"}), "q10.png 1 10; ");
    EXPECT_EQ(frames({"+KFI5"}), "q5.png 0 5; ");
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "+KFI5"}).warnings.size(), 1u);
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "+KFF3"}).warnings.size(), 0u);
    EXPECT_EQ(frames_text(cli::povray_drop_in({"a.pov", "+KFF2", "-F"})), "/dev/null 0 2; /dev/null 1 2; ");
}

// The columns and rows that POV-Ray renders, at 40x30 (measured).
TEST_F(Povray, TakesPartsOfPictures) {
    const auto crop = [](std::vector<std::string> words) {
        words.insert(words.end(), {"a.pov", "+W40", "+H30"});
        const DropIn d = cli::povray_drop_in(words);
        EXPECT_EQ(d.render.keeps_size, !d.render.crop.empty());
        return d.render.crop;
    };
    EXPECT_EQ(crop({"+SC1", "+EC1"}), "") << "1 as an end is the whole";
    EXPECT_EQ(crop({"+SC10", "+EC20"}), "11x30+9+0");
    EXPECT_EQ(crop({"+SC0.25", "+EC0.5", "+SR0.5"}), "10x15+10+15");
    EXPECT_EQ(crop({"+SC0.26", "+EC0.54"}), "11x30+10+0");
    EXPECT_EQ(crop({"+SR5", "+ER10"}), "40x6+0+4");
    EXPECT_EQ(crop({"+SC0", "+EC10"}), "10x30+0+0");
    EXPECT_EQ(crop({"+SC0.999"}), "1x30+39+0");
    EXPECT_EQ(crop({"Start_Column=10", "End_Column=10", "+SR3", "+ER3"}), "1x1+9+2");
    for (const std::vector<std::string>& words : {std::vector<std::string>{"a.pov", "+W40", "+H30", "+EC41"},
                                                  {"a.pov", "+W40", "+H30", "+SC41"},
                                                  {"a.pov", "+W40", "+H30", "+EC0"},
                                                  {"a.pov", "+W40", "+H30", "+SR20", "+ER10"}})
        EXPECT_TRUE(contains(failure_of(cli::povray_drop_in, words), "expected a part of the 40x30 pixels"));
}

TEST_F(Povray, TakesJpegAndItsCompression) {
    const DropIn d = cli::povray_drop_in({"a.pov", "+FJ80"});
    EXPECT_EQ(d.render.output, "a.jpg");
    EXPECT_EQ(d.render.numbers.format, FileFormat::jpeg);
    EXPECT_EQ(d.render.numbers.jpeg_quality, 85) << "as in POV-Ray, the number has no effect";
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "Compression=40"}).render.numbers.jpeg_quality, 40);
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "Compression=0"}).render.numbers.jpeg_quality, 85);
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "+FB"}).render.output, "a.bmp");
}

TEST_F(Povray, HidesWarningsAtLevel0) {
    EXPECT_TRUE(cli::povray_drop_in({"a.pov", "+WL0"}).render.hides_warnings);
    EXPECT_FALSE(cli::povray_drop_in({"a.pov", "+WL5"}).render.hides_warnings);
    EXPECT_FALSE(cli::povray_drop_in({"a.pov"}).render.hides_warnings);
}

TEST_F(Povray, TakesSwitchesOfSpeed) {
    EXPECT_TRUE(cli::povray_drop_in({"a.pov", "+SU", "-SU", "+RP4", "Split_Unions=on", "BSP_MissChance=.2",
                                     "Clockless_Animation=off"})
                    .warnings.empty());
    EXPECT_EQ(cli::povray_drop_in({"a.pov", "+A", "+R2", "+RP4"}).render.picture.aa, "adaptive:2:0.1");
}

TEST_F(Povray, RunsNoCommands) {
    const DropIn d = cli::povray_drop_in({"a.pov", "Pre_Scene_Command=touch x", "Pre_Scene_Return=I"});
    ASSERT_EQ(d.warnings.size(), 1u);
    EXPECT_EQ(d.warnings[0], "'Pre_Scene_Command=touch x' has no effect in glint");
}

TEST_F(Povray, FindsTheSceneInTheLibrary) {
    folder_.write("of_library.pov", "");
    const DropIn d = cli::povray_drop_in({"+L" + folder_.path(""), "+Iof_library"});
    EXPECT_TRUE(std::filesystem::equivalent(d.render.scene.files.at(0), folder_.path("of_library.pov")));
    EXPECT_EQ(d.render.output, "of_library.png");
}

TEST_F(Povray, AnIniFileNamesNoSceneBesideWhichItWrites) {
    folder_.write("other.ini", "Input_File_Name=../a.pov\n");
    EXPECT_NE(
        failure_of(cli::povray_drop_in, {folder_.path("other.ini")}).find("for another folder, give +O"),
        std::string::npos);
}

TEST_F(Povray, LeavesOutWhatIsAsked) {
    EXPECT_TRUE(cli::povray_drop_in({"a.pov", "--skip-unsupported"}).render.scene.skip_unsupported);
    EXPECT_TRUE(cli::tachyon_drop_in({"--skip-unsupported", "a.dat"}).render.scene.skip_unsupported);
    EXPECT_FALSE(cli::povray_drop_in({"a.pov"}).render.scene.skip_unsupported);
}

TEST_F(Povray, NamesWhatItDoesNotKnow) {
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"+W40"}), "expected the name of a scene: +Iscene.pov");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "+Zork"}), "unknown switch '+Zork'");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "Foo=1"}), "unknown key 'Foo'");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "+FH"}),
              "'+FH': glint-povray writes N (PNG), T (TGA), P (PPM), E (OpenEXR), J (JPEG) and B (BMP)");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "Clock_Delta=2"}), "unknown key 'Clock_Delta'");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {"a.pov", "+KFF3", "+O-"}),
              "an animation is several files: name them with +O");
    folder_.write("bad.ini", "Width=40\nWidht=3\n");
    EXPECT_EQ(failure_of(cli::povray_drop_in, {folder_.path("bad.ini")}),
              folder_.path("bad.ini") + ":2: unknown key 'Widht'");
    EXPECT_NE(failure_of(cli::povray_drop_in, {"nosuch.ini"}), "");
    folder_.write("nul.ini", std::string("Width=40\n\0a.ini\n", 16));
    EXPECT_EQ(failure_of(cli::povray_drop_in, {folder_.path("nul.ini")}),
              folder_.path("nul.ini") + ":2: expected text, found a NUL byte");
}

// 0.ini has a hundred lines, each of which names 1.ini, and so on up to the last one.
class ManyIniFiles : public cli::IniFiles {
  public:
    explicit ManyIniFiles(int last) : last_(last) {}
    bool exists(const std::string&) override { return false; }
    std::string read(const std::string& path, bool) override {
        const int number = std::stoi(path);
        std::string text;
        for (int i = 0; i < 100 && number < last_; ++i) text += std::to_string(number + 1) + ".ini\n";
        return text;
    }

  private:
    int last_;
};

TEST_F(Povray, ReadsABoundedNumberOfIniFiles) {
    const auto failure = [](int last) {
        ManyIniFiles files(last);
        try {
            cli::povray_drop_in({"+Ia.pov", "0.ini"}, files);
        } catch (const Failure& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(failure(1), "");
    EXPECT_EQ(failure(9), "8.ini:83: more than 1000 .ini files");
    EXPECT_EQ(failure(99), "9.ini:1: 10.ini: .ini files are nested too deeply");
}

}  // namespace
}  // namespace glint::test
