// SPDX-License-Identifier: Apache-2.0
#include "cli/view_argument.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text.h"
#include "formats/number_text.h"
#include "math/transform.h"
#include "scene/ranges.h"

namespace glint::cli {

std::optional<Vec3> parse_view(std::string_view text) {
    if (text == "front") return Vec3{0, 0, 1};
    if (text == "iso") return Vec3{1, 1, 1};
    double values[3];
    const char *at = text.data(), *const end = text.data() + text.size();
    for (int i = 0; i < 3; ++i) {
        if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
        const char* const stop = read_any_number(at, end, values[i]);
        if (stop == at || !(std::abs(values[i]) <= k_coordinate.max)) return std::nullopt;
        at = stop;
    }
    const Vec3 view{values[0], values[1], values[2]};
    if (at != end || !(length(view) > 0)) return std::nullopt;
    return view;
}

std::string view_message(std::string_view text) {
    return fmt::format("expected front, iso or a direction from the mesh to the eye as 1,-0.5,2, found {}",
                       glint::quoted(text));
}

void add_view_argument(CLI::App& command, std::optional<Vec3>& view) {
    command
        .add_option_function<std::string>(
            "--view", [&view](const std::string& text) { view = parse_view(text); },
            "Where a mesh without a camera (.ply, .stl, .obj, .gltf, .glb) is seen from: from +z, from (1, "
            "1, 1), "
            "or from the side that X,Y,Z points to")
        ->check(CLI::Validator(
            [](const std::string& text) { return parse_view(text) ? std::string() : view_message(text); },
            ""))
        ->option_text("front|iso|X,Y,Z");
}

}  // namespace glint::cli
