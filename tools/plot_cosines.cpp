// SPDX-License-Identifier: Apache-2.0
// The plots of docs/lighting.md as SVG, on standard output.
//     plot_cosines powers > docs/images/plots/powers.svg      cos^n for several n
//     plot_cosines models > docs/images/plots/models.svg      Phong and Blinn-Phong, with equal and with
//     fourfold exponents
// A test in tests/math generates them again and compares. With glint's own functions, the text is the same
// on every machine.
#include <cstdio>
#include <cstring>
#include <string>

#include "math/elementary.h"

namespace {

constexpr double k_left = 60, k_top = 20, k_width = 600, k_height = 300;

double x_of(double degrees) { return k_left + k_width * degrees / 90; }
double y_of(double value) { return k_top + k_height * (1 - value); }

void begin(const char* title, const char* axis) {
    std::printf(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 380\" font-family=\"sans-serif\" "
        "font-size=\"13\">\n"
        "<title>%s</title>\n<rect width=\"700\" height=\"380\" fill=\"#fff\"/>\n<g stroke=\"#ccc\">\n",
        title);
    for (int degrees = 0; degrees <= 90; degrees += 15) {
        std::printf("<path d=\"M%.0f %.0fV%.0f\"/>\n", x_of(degrees), y_of(0), y_of(1));
    }
    for (int quarter = 0; quarter <= 4; ++quarter) {
        std::printf("<path d=\"M%.0f %.0fH%.0f\"/>\n", x_of(0), y_of(quarter / 4.0), x_of(90));
    }
    std::printf("</g>\n<g fill=\"#333\">\n");
    for (int degrees = 0; degrees <= 90; degrees += 15) {
        std::printf("<text x=\"%.0f\" y=\"%.0f\" text-anchor=\"middle\">%d°</text>\n", x_of(degrees),
                    y_of(0) + 18, degrees);
    }
    for (int quarter = 0; quarter <= 4; ++quarter) {
        std::printf("<text x=\"%.0f\" y=\"%.0f\" text-anchor=\"end\">%.2f</text>\n", k_left - 8,
                    y_of(quarter / 4.0) + 4, quarter / 4.0);
    }
    std::printf("<text x=\"%.0f\" y=\"%.0f\" text-anchor=\"middle\">%s</text>\n</g>\n", x_of(45),
                y_of(0) + 40, axis);
}

/// (cos of angle / divisor)^n over 0 to 90 degrees, labelled where it crosses `label_at`.
void curve(double n, double divisor, const char* color, const char* dashes, const std::string& label,
           double label_at) {
    std::printf("<path fill=\"none\" stroke=\"%s\" stroke-width=\"2\" stroke-dasharray=\"%s\" d=\"", color,
                dashes);
    double label_x = 0;
    for (int half = 0; half <= 180; ++half) {
        const double degrees = half / 2.0;
        const double value = glint::pow(glint::cos_degrees(degrees / divisor), n);
        std::printf("%c%.2f %.2f", half == 0 ? 'M' : 'L', x_of(degrees), y_of(value));
        if (value >= label_at) label_x = x_of(degrees);
    }
    std::printf("\"/>\n<text x=\"%.0f\" y=\"%.0f\" fill=\"%s\">%s</text>\n", label_x + 6, y_of(label_at),
                color, label.c_str());
}

void powers() {
    begin("cos^n of an angle", "the angle between R and V (Phong), or between N and H (Blinn-Phong)");
    const char* colors[] = {"#7a4", "#287", "#25b", "#63a", "#a24", "#d60"};
    const int exponents[] = {1, 2, 5, 10, 50, 200};
    const double labels[] = {0.75, 0.65, 0.55, 0.45, 0.25, 0.15};
    for (int i = 0; i < 6; ++i) {
        curve(exponents[i], 1, colors[i], "none", (i == 0 ? "n = " : "") + std::to_string(exponents[i]),
              labels[i]);
    }
    std::printf("</svg>\n");
}

void models() {
    begin("Phong and Blinn-Phong", "the angle between R and V");
    curve(20, 1, "#25b", "none", "Phong, n = 20", 0.30);
    curve(80, 2, "#a24", "8 5", "Blinn-Phong, n = 80", 0.08);
    curve(20, 2, "#a24", "none", "Blinn-Phong, n = 20", 0.5);
    std::printf("</svg>\n");
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "powers") == 0) return powers(), 0;
    if (argc == 2 && std::strcmp(argv[1], "models") == 0) return models(), 0;
    std::fprintf(stderr, "usage: plot_cosines powers|models\n");
    return 2;
}
