// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/standard_includes.h"

#include <fmt/format.h>

#include "glint/vec.h"

namespace glint::povray {
namespace {

struct NamedColor {
    std::string_view name;
    Color color;
};

// The colors of colors.inc.
constexpr NamedColor k_colors[] = {
    {"Aquamarine", {0.439216, 0.858824, 0.576471}},
    {"BakersChoc", {0.36, 0.2, 0.09}},
    {"Black", {0, 0, 0}},
    {"Blue", {0, 0, 1}},
    {"BlueViolet", {0.62352, 0.372549, 0.623529}},
    {"Brass", {0.71, 0.65, 0.26}},
    {"BrightGold", {0.85, 0.85, 0.1}},
    {"Bronze", {0.55, 0.47, 0.14}},
    {"Bronze2", {0.65, 0.49, 0.24}},
    {"Brown", {0.647059, 0.164706, 0.164706}},
    {"CadetBlue", {0.372549, 0.623529, 0.623529}},
    {"CoolCopper", {0.85, 0.53, 0.1}},
    {"Copper", {0.72, 0.45, 0.2}},
    {"Coral", {1, 0.498039, 0}},
    {"CornflowerBlue", {0.258824, 0.258824, 0.435294}},
    {"Cyan", {0, 1, 1}},
    {"DarkBrown", {0.36, 0.25, 0.2}},
    {"DarkGreen", {0.184314, 0.309804, 0.184314}},
    {"DarkOliveGreen", {0.309804, 0.309804, 0.184314}},
    {"DarkOrchid", {0.6, 0.196078, 0.8}},
    {"DarkPurple", {0.53, 0.12, 0.47}},
    {"DarkSlateBlue", {0.119608, 0.137255, 0.556863}},
    {"DarkSlateGray", {0.184314, 0.309804, 0.309804}},
    {"DarkSlateGrey", {0.184314, 0.309804, 0.309804}},
    {"DarkTan", {0.59, 0.41, 0.31}},
    {"DarkTurquoise", {0.439216, 0.576471, 0.858824}},
    {"DarkWood", {0.52, 0.37, 0.26}},
    {"DimGray", {0.329412, 0.329412, 0.329412}},
    {"DimGrey", {0.329412, 0.329412, 0.329412}},
    {"DkGreenCopper", {0.29, 0.46, 0.43}},
    {"DustyRose", {0.52, 0.39, 0.39}},
    {"Feldspar", {0.82, 0.57, 0.46}},
    {"Firebrick", {0.556863, 0.137255, 0.137255}},
    {"Flesh", {0.96, 0.8, 0.69}},
    {"ForestGreen", {0.137255, 0.556863, 0.137255}},
    {"Gold", {0.8, 0.498039, 0.196078}},
    {"Goldenrod", {0.858824, 0.858824, 0.439216}},
    {"Gray", {0.752941, 0.752941, 0.752941}},
    {"Gray05", {0.05, 0.05, 0.05}},
    {"Gray10", {0.1, 0.1, 0.1}},
    {"Gray15", {0.15, 0.15, 0.15}},
    {"Gray20", {0.2, 0.2, 0.2}},
    {"Gray25", {0.25, 0.25, 0.25}},
    {"Gray30", {0.3, 0.3, 0.3}},
    {"Gray35", {0.35, 0.35, 0.35}},
    {"Gray40", {0.4, 0.4, 0.4}},
    {"Gray45", {0.45, 0.45, 0.45}},
    {"Gray50", {0.5, 0.5, 0.5}},
    {"Gray55", {0.55, 0.55, 0.55}},
    {"Gray60", {0.6, 0.6, 0.6}},
    {"Gray65", {0.65, 0.65, 0.65}},
    {"Gray70", {0.7, 0.7, 0.7}},
    {"Gray75", {0.75, 0.75, 0.75}},
    {"Gray80", {0.8, 0.8, 0.8}},
    {"Gray85", {0.85, 0.85, 0.85}},
    {"Gray90", {0.9, 0.9, 0.9}},
    {"Gray95", {0.95, 0.95, 0.95}},
    {"Green", {0, 1, 0}},
    {"GreenCopper", {0.32, 0.49, 0.46}},
    {"GreenYellow", {0.576471, 0.858824, 0.439216}},
    {"Grey", {0.752941, 0.752941, 0.752941}},
    {"HuntersGreen", {0.13, 0.37, 0.31}},
    {"IndianRed", {0.309804, 0.184314, 0.184314}},
    {"Khaki", {0.623529, 0.623529, 0.372549}},
    {"LightBlue", {0.74902, 0.847059, 0.847059}},
    {"LightGray", {0.658824, 0.658824, 0.658824}},
    {"LightGrey", {0.658824, 0.658824, 0.658824}},
    {"LightSteelBlue", {0.560784, 0.560784, 0.737255}},
    {"LightWood", {0.91, 0.76, 0.65}},
    {"Light_Purple", {0.87, 0.58, 0.98}},
    {"LimeGreen", {0.196078, 0.8, 0.196078}},
    {"Magenta", {1, 0, 1}},
    {"MandarinOrange", {0.89, 0.47, 0.2}},
    {"Maroon", {0.556863, 0.137255, 0.419608}},
    {"Med_Purple", {0.73, 0.16, 0.96}},
    {"MediumAquamarine", {0.196078, 0.8, 0.6}},
    {"MediumBlue", {0.196078, 0.196078, 0.8}},
    {"MediumForestGreen", {0.419608, 0.556863, 0.137255}},
    {"MediumGoldenrod", {0.917647, 0.917647, 0.678431}},
    {"MediumOrchid", {0.576471, 0.439216, 0.858824}},
    {"MediumSeaGreen", {0.258824, 0.435294, 0.258824}},
    {"MediumSlateBlue", {0.498039, 0, 1}},
    {"MediumSpringGreen", {0.498039, 1, 0}},
    {"MediumTurquoise", {0.439216, 0.858824, 0.858824}},
    {"MediumVioletRed", {0.858824, 0.439216, 0.576471}},
    {"MediumWood", {0.65, 0.5, 0.39}},
    {"MidnightBlue", {0.184314, 0.184314, 0.309804}},
    {"Navy", {0.137255, 0.137255, 0.556863}},
    {"NavyBlue", {0.137255, 0.137255, 0.556863}},
    {"NeonBlue", {0.3, 0.3, 1}},
    {"NeonPink", {1, 0.43, 0.78}},
    {"NewMidnightBlue", {0, 0, 0.61}},
    {"NewTan", {0.92, 0.78, 0.62}},
    {"OldGold", {0.81, 0.71, 0.23}},
    {"Orange", {1, 0.5, 0}},
    {"OrangeRed", {1, 0.25, 0}},
    {"Orchid", {0.858824, 0.439216, 0.858824}},
    {"PaleGreen", {0.560784, 0.737255, 0.560784}},
    {"Pink", {0.737255, 0.560784, 0.560784}},
    {"Plum", {0.917647, 0.678431, 0.917647}},
    {"Quartz", {0.85, 0.85, 0.95}},
    {"Red", {1, 0, 0}},
    {"RichBlue", {0.35, 0.35, 0.67}},
    {"Salmon", {0.435294, 0.258824, 0.258824}},
    {"Scarlet", {0.55, 0.09, 0.09}},
    {"SeaGreen", {0.137255, 0.556863, 0.419608}},
    {"SemiSweetChoc", {0.42, 0.26, 0.15}},
    {"Sienna", {0.556863, 0.419608, 0.137255}},
    {"Silver", {0.9, 0.91, 0.98}},
    {"SkyBlue", {0.196078, 0.6, 0.8}},
    {"SlateBlue", {0, 0.498039, 1}},
    {"SpicyPink", {1, 0.11, 0.68}},
    {"SpringGreen", {0, 1, 0.498039}},
    {"SteelBlue", {0.137255, 0.419608, 0.556863}},
    {"SummerSky", {0.22, 0.69, 0.87}},
    {"Tan", {0.858824, 0.576471, 0.439216}},
    {"Thistle", {0.847059, 0.74902, 0.847059}},
    {"Turquoise", {0.678431, 0.917647, 0.917647}},
    {"VLightGray", {0.8, 0.8, 0.8}},
    {"VLightGrey", {0.8, 0.8, 0.8}},
    {"VeryDarkBrown", {0.35, 0.16, 0.14}},
    {"Very_Light_Purple", {0.94, 0.81, 0.99}},
    {"Violet", {0.309804, 0.184314, 0.309804}},
    {"VioletRed", {0.8, 0.196078, 0.6}},
    {"Wheat", {0.847059, 0.847059, 0.74902}},
    {"White", {1, 1, 1}},
    {"Yellow", {1, 1, 0}},
    {"YellowGreen", {0.6, 0.8, 0.196078}},
};

// The macros of colors.inc, by the usual formulas of HSL and HSV, in POV-Ray's units: a hue in degrees, of
// which that of a color is between -60 and 300.
constexpr std::string_view k_macros =
    "#macro CH2RGB(H) #local D=H/60-6*floor(H/360);"
    "<min(1,max(0,abs(D-3)-1)),min(1,max(0,2-abs(D-2))),min(1,max(0,2-abs(D-4)))>#end\n"
    "#macro CRGB2H(C,M,S) #if(S=0) 0 #else #if(C.red=M) (60*(C.green-C.blue)/S) #else "
    "#if(C.green=M) (120+60*(C.blue-C.red)/S) #else (240+60*(C.red-C.green)/S) #end #end #end #end\n"
    "#macro CHSL2RGB(C) #local D=C+<0,0,0,0,0>;"
    "#local R=D.blue+(1-abs(2*D.blue-1))*D.green*(CH2RGB(D.red)-0.5);"
    "#local E=rgbft<R.x,R.y,R.z,D.filter,D.transmit>;E #end\n"
    "#macro CHSV2RGB(C) #local D=C+<0,0,0,0,0>;#local R=D.blue*(1+D.green*(CH2RGB(D.red)-1));"
    "#local E=rgbft<R.x,R.y,R.z,D.filter,D.transmit>;E #end\n"
    "#macro CRGB2HSL(C) #local D=C+<0,0,0,0,0>;#local M=max(D.red,D.green,D.blue);"
    "#local S=M-min(D.red,D.green,D.blue);#local L=M-S/2;"
    "#local E=rgbft<CRGB2H(D,M,S),#if(S=0) 0 #else S/(1-abs(2*L-1)) #end,L,D.filter,D.transmit>;E #end\n"
    "#macro CRGB2HSV(C) #local D=C+<0,0,0,0,0>;#local M=max(D.red,D.green,D.blue);"
    "#local S=M-min(D.red,D.green,D.blue);"
    "#local E=rgbft<CRGB2H(D,M,S),#if(S=0) 0 #else S/M #end,M,D.filter,D.transmit>;E #end\n";

// The finishes of finish.inc.
constexpr std::string_view k_finishes =
    "#declare Dull = finish { specular 0.5 roughness 0.15 }\n"
    "#declare Shiny = finish { specular 1 roughness 0.001 }\n"
    "#declare Phong_Dull = finish { phong 0.5 phong_size 1 }\n"
    "#declare Phong_Shiny = finish { phong 1 phong_size 200 }\n"
    "#declare Glossy = finish { specular 1 roughness 0.0001 reflection 0.13 }\n"
    "#declare Phong_Glossy = finish { phong 1 phong_size 300 reflection 0.13 }\n"
    "#declare Luminous = finish { ambient 1 diffuse 0 }\n"
    "#declare Mirror = finish { ambient 0 diffuse 0 reflection 1 }\n";

// Of metals.inc, the finishes that Open Babel's scenes use.
constexpr std::string_view k_metals =
    "#declare F_MetalA = finish { ambient 0.35 brilliance 2 diffuse 0.3 metallic specular 0.8 roughness 1/20 "
    "reflection 0.1 }\n"
    "#declare F_MetalB = finish { ambient 0.3 brilliance 3 diffuse 0.4 metallic specular 0.7 roughness 1/60 "
    "reflection 0.25 }\n"
    "#declare F_MetalC = finish { ambient 0.25 brilliance 4 diffuse 0.5 metallic specular 0.8 roughness 1/80 "
    "reflection 0.5 }\n"
    "#declare F_MetalD = finish { ambient 0.15 brilliance 5 diffuse 0.6 metallic specular 0.8 roughness "
    "1/100 "
    "reflection 0.65 }\n"
    "#declare F_MetalE = finish { ambient 0.1 brilliance 6 diffuse 0.7 metallic specular 0.8 roughness 1/120 "
    "reflection 0.8 }\n";

std::string colors_text() {
    std::string text(k_macros);
    text += "#declare Clear = rgbf 1;\n#declare Mica = rgb 0;\n";
    for (const NamedColor& named : k_colors) {
        text += fmt::format("#declare {} = rgb <{}, {}, {}>;\n", named.name, named.color.r, named.color.g,
                            named.color.b);
    }
    return text;
}

}  // namespace

StandardInclude standard_include(std::string_view name) {
    if (name == "colors.inc") return {colors_text(), true};
    if (name == "finish.inc") return {std::string(k_finishes), true};
    if (name == "metals.inc") return {std::string(k_metals), false};
    return {};
}

}  // namespace glint::povray
