// SPDX-License-Identifier: Apache-2.0
// Functions and constants of numbers and vectors.
#include <fmt/format.h>
#include <algorithm>

#include "formats/povray/standard_includes.h"
#include "formats/povray/value_parser.h"
#include "math/elementary.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

constexpr double k_pi = 3.14159265358979323846;

double floor_of(double x) {
    if (x >= 0x1p52 || x <= -0x1p52) return x;
    const double whole = static_cast<double>(static_cast<std::int64_t>(x));
    return whole > x ? whole - 1 : whole;
}
double truncate(double x) { return x < 0 ? -floor_of(-x) : floor_of(x); }

// a minus the whole multiple of b below it in size, exactly, with the sign of a, as C's fmod().
double remainder(double a, double b) {
    double rest = number::abs(a);
    const double size = number::abs(b);
    if (!(rest >= size)) return a;
    if (!(rest < number::k_infinity)) return 0;
    double step = size;
    while (step <= rest / 2) step *= 2;
    for (; step >= size; step /= 2) {
        if (rest >= step) rest -= step;
    }
    return a < 0 ? -rest : rest;
}

// The sine and cosine of an angle in radians of any finite size.
double reduced(double x) {
    if (x <= 1e5 && x >= -1e5) return x;
    return x - floor_of(x / (2 * k_pi)) * (2 * k_pi);
}

// POV-Ray's rotation of a point about an axis, by the right-hand rule.
Vec3 rotate_about(Vec3 p, Vec3 axis, double radians) {
    const Vec3 n = normalize(axis);
    const double c = cos(reduced(radians)), s = sin(reduced(radians));
    return p * c + cross(n, p) * s + n * (dot(n, p) * (1 - c));
}

}  // namespace

// Without its fraction. POV-Ray's has 32 bits.
double ValueParser::integer(const Token& name, double x) {
    if (!(number::abs(x) < 0x1p31))
        warn_once("integer", name,
                  fmt::format("`{}` of {}: POV-Ray's integers are within 2^31, and the picture may differ",
                              text_of(name), x));
    return truncate(x) + 0.0;
}

std::optional<double> ValueParser::declared_number(std::string_view wanted) const {
    std::optional<double> number;
    for (const auto& [name, value] : reading().options.declared) {
        if (name == wanted) number = value;
    }
    return number;
}

// The size of the picture: the command's, else that of the profile.
RenderSettings ValueParser::scene_size() const {
    Scene sized;
    sized.settings = reading().scene.settings;
    const auto key = find_setting("size");
    for (const auto& [name, value] : reading().options.settings) {
        if (key && name == "size") (void)set_setting(sized, *key, value, {}).ok();
    }
    return sized.settings;
}

double ValueParser::argument() {
    const double value = number();
    accept(',');
    return value;
}

Vec3 ValueParser::vector_argument() {
    const Vec3 value = vector();
    accept(',');
    return value;
}

// The function's name has been read.
Numbers ValueParser::function(const Token& name) {
    switch (name.word()) {
        case Word::k_pi:
            return k_pi;
        case Word::k_x:
        case Word::k_u:
            return Numbers(Vec3{1, 0, 0});
        case Word::k_y:
        case Word::k_v:
            return Numbers(Vec3{0, 1, 0});
        case Word::k_z:
            return Numbers(Vec3{0, 0, 1});
        case Word::k_t: {
            Numbers t;
            t.v[3] = 1;
            t.terms = 4;
            return t;
        }
        case Word::k_true:
        case Word::k_yes:
        case Word::k_on:
            return 1.0;
        case Word::k_false:
        case Word::k_no:
        case Word::k_off:
            return 0.0;
        case Word::k_clock:
            return declared_number("clock").value_or(0);
        case Word::k_clock_on:
            return declared_number("clock") ? 1.0 : 0.0;
        case Word::k_clock_delta:
        case Word::k_initial_frame:
        case Word::k_final_frame:
        case Word::k_frame_number:
        case Word::k_initial_clock:
        case Word::k_final_clock:
            return declared_number(to_string(name.word())).value_or(0);
        case Word::k_version:
            return version_.value_or(3.7);
        case Word::k_image_width:
            return scene_size().width;
        case Word::k_image_height:
            return scene_size().height;
        case Word::k_defined: {
            if (!expect('(')) return {};
            return read_defined() ? 1.0 : 0.0;
        }
        default:
            break;
    }
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('(')) return {};
    const Numbers value = call(name);
    if (!failed()) expect(')');
    for (const double x : value.v) {
        if (!(x <= 1e300 && x >= -1e300) && !failed()) {
            error(name, fmt::format("{} has no finite value here", to_string(name.word())));
        }
    }
    return failed() ? Numbers() : value;
}

Numbers ValueParser::call(const Token& name) {
    switch (name.word()) {
        case Word::k_abs:
            return number::abs(number());
        case Word::k_acos:
            return acos(number());
        case Word::k_asin:
            return k_pi / 2 - acos(number());
        case Word::k_atan:
            return atan2(number(), 1);
        case Word::k_atan2: {
            const double y = argument();
            return atan2(y, number());
        }
        case Word::k_cos:
            return cos(reduced(number()));
        case Word::k_sin:
            return sin(reduced(number()));
        case Word::k_tan:
            return tan(reduced(number()));
        case Word::k_cosh: {
            const double x = number();
            return (exp(x) + exp(-x)) / 2;
        }
        case Word::k_sinh: {
            const double x = number();
            return (exp(x) - exp(-x)) / 2;
        }
        case Word::k_tanh: {
            const double e = exp(2 * number());
            return e > 1e300 ? 1 : (e - 1) / (e + 1);
        }
        case Word::k_acosh: {
            const double x = number();
            return log(x + number::sqrt(x * x - 1));
        }
        case Word::k_asinh: {
            const double x = number();
            return log(x + number::sqrt(x * x + 1));
        }
        case Word::k_atanh: {
            const double x = number();
            return log((1 + x) / (1 - x)) / 2;
        }
        case Word::k_ceil:
            return -floor_of(-number());
        case Word::k_floor:
            return floor_of(number());
        case Word::k_int:
            return integer(name, number());
        case Word::k_degrees:
            return number() * (180 / k_pi);
        case Word::k_radians:
            return number() * (k_pi / 180);
        case Word::k_exp:
            return exp(number());
        case Word::k_ln:
        case Word::k_log: {
            const double x = number();
            if (!(x > 0)) {
                error(name, "expected the logarithm of a number > 0");
                return {};
            }
            return name.word() == Word::k_ln ? log(x) : log(x) / log(10.0);
        }
        case Word::k_sqrt: {
            const double x = number();
            if (!(x >= 0)) error(name, "expected the square root of a number >= 0");
            return failed() ? 0 : number::sqrt(x);
        }
        case Word::k_pow: {
            const double base = argument(), exponent = number();
            if (base >= 0) return pow(base, exponent);
            const double whole = truncate(exponent);
            if (whole != exponent) {
                error(name, "expected a whole exponent of a negative number");
                return {};
            }
            const bool is_odd = truncate(whole / 2) * 2 != whole;
            return is_odd ? -pow(-base, exponent) : pow(-base, exponent);
        }
        case Word::k_div:
        case Word::k_mod: {
            const double a = argument(), b = number();
            if (b == 0) {
                error(name, "expected a divisor other than 0");
                return {};
            }
            return name.word() == Word::k_div ? integer(name, a / b) : remainder(a, b);
        }
        case Word::k_min:
        case Word::k_max: {
            Numbers value = argument();
            while (!failed() && !peek().is(')')) {
                const double x = argument();
                if (name.word() == Word::k_min ? x < value.v[0] : x > value.v[0]) value = x;
            }
            return value;
        }
        case Word::k_select: {
            const double chosen = argument();
            const Numbers negative = expression();
            accept(',');
            Numbers zero = expression(), positive = zero;
            if (accept(',')) positive = expression();
            return chosen < 0 ? negative : chosen > 0 ? positive : zero;
        }
        case Word::k_seed: {
            const double x = number();
            if (random_.size() >= 100000) error(name, "more than 100000 calls of seed()");
            random_.push_back(
                static_cast<std::uint32_t>(static_cast<std::int64_t>(std::clamp(x, -1e15, 1e15))));
            return static_cast<double>(random_.size() - 1);
        }
        case Word::k_rand: {
            const double stream = number();
            if (!(stream >= 0) || stream >= static_cast<double>(random_.size())) {
                error(name, "expected a value of seed()");
                return {};
            }
            // The generator of POV-Ray.
            std::uint32_t& state = random_[static_cast<std::size_t>(stream)];
            state = state * 1812433253u + 12345u;
            return static_cast<double>(state) / 4294967295.0;
        }
        case Word::k_asc: {
            const String text = string();
            return text->empty() ? 0.0 : static_cast<double>(static_cast<unsigned char>(text->front()));
        }
        case Word::k_strlen:
            return static_cast<double>(string()->size());
        case Word::k_strcmp: {
            const String a = string();
            accept(',');
            const int order = compare(*a, *string());
            return order < 0 ? -1.0 : order > 0 ? 1.0 : 0.0;
        }
        case Word::k_val: {
            const Token at = peek();
            const String text = string();
            spend(text->size() / 4);
            return value_of(at, *text);
        }
        case Word::k_file_exists: {
            const std::string file(*string());
            if (++reading().includes.count > k_max_includes) {
                error(name, fmt::format("more than {} includes", k_max_includes));
            }
            if (failed() || reading().sources == nullptr) return 0.0;
            const bool is_own = !standard_include(file).text.empty();
            return is_own || reading().sources->read(file, text().place.name) ? 1.0 : 0.0;
        }
        case Word::k_dimensions:
        case Word::k_dimension_size:
            return array_size(name);
        case Word::k_vlength:
            return length(vector());
        case Word::k_vdot: {
            const Vec3 a = vector_argument();
            return dot(a, vector());
        }
        case Word::k_vcross: {
            const Vec3 a = vector_argument();
            return Numbers(cross(a, vector()));
        }
        case Word::k_vnormalize: {
            const Vec3 v = vector();
            return Numbers(normalize(v));
        }
        case Word::k_vrotate: {
            const Vec3 p = vector_argument(), by = vector();
            return Numbers(
                transform_vector(compose(rotation_z(by.z), compose(rotation_y(by.y), rotation_x(by.x))), p));
        }
        case Word::k_vaxis_rotate: {
            const Vec3 p = vector_argument(), axis = vector_argument();
            return Numbers(rotate_about(p, axis, number() * (k_pi / 180)));
        }
        case Word::k_min_extent:
        case Word::k_max_extent:
            return extent(name);
        case Word::k_trace:
            return trace(name);
        case Word::k_inside:
            return inside(name);
        default:
            error(name, fmt::format("{}() is not a function of numbers here", to_string(name.word())));
            return {};
    }
}

}  // namespace glint::povray
