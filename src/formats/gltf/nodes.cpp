// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "math/transform.h"
#include "scene/ranges.h"

namespace glint::gltf {

Affine trs(const std::array<double, 3>& t, const std::array<double, 4>& q, const std::array<double, 3>& s) {
    const double squares = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    // 2 / |q|^2, as files round the quaternion.
    const double two = squares > 0 ? 2 / squares : 0;
    const double xx = two * q[0] * q[0], yy = two * q[1] * q[1], zz = two * q[2] * q[2];
    const double xy = two * q[0] * q[1], xz = two * q[0] * q[2], yz = two * q[1] * q[2];
    const double xw = two * q[0] * q[3], yw = two * q[1] * q[3], zw = two * q[2] * q[3];
    return {{{(1 - yy - zz) * s[0], (xy - zw) * s[1], (xz + yw) * s[2], t[0]},
             {(xy + zw) * s[0], (1 - xx - zz) * s[1], (yz - xw) * s[2], t[1]},
             {(xz - yw) * s[0], (yz + xw) * s[1], (1 - xx - yy) * s[2], t[2]}}};
}

bool Nodes::local(JsonValue node, Affine& to) {
    if (node.find("matrix").exists()) {
        double m[16] = {};  // column by column
        if (!file_.numbers(node, "matrix", m, k_coordinate)) return false;
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 4; ++column) to.m[row][column] = m[4 * column + row];
        }
        return true;
    }
    std::array<double, 3> translation{0, 0, 0}, scale{1, 1, 1};
    std::array<double, 4> rotation{0, 0, 0, 1};
    if (!file_.numbers(node, "translation", translation, k_coordinate) ||
        !file_.numbers(node, "rotation", rotation, k_channel) ||
        !file_.numbers(node, "scale", scale, k_coordinate))
        return false;
    to = trs(translation, rotation, scale);
    return true;
}

bool Nodes::add_children(JsonValue list, CountedVector<std::uint32_t>& to) {
    if (!list.exists()) return true;
    if (!list.is(JsonKind::list)) return file_.expected(list, "a list of nodes");
    bool is_right = true;
    list.for_each([&](JsonValue value) {
        if (!is_right) return;
        const std::optional<std::uint32_t> node = file_.index(value, List::nodes);
        is_right = node.has_value();
        if (node) to.push_back(*node);
    });
    return is_right;
}

bool Nodes::choose_by_name(std::optional<std::uint32_t>& scene) {
    const std::string& wanted = file_.reading.options.scene_name;
    constexpr std::uint32_t most = 20;
    std::string names;
    const std::uint32_t count = file_.count(List::scenes);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string name = file_.string(file_.item(List::scenes, i), "name");
        if (!wanted.empty() && name == wanted) {
            scene = i;
            return true;
        }
        if (i <= most)
            names += (i == 0 ? "" : ", ") + (i == most      ? "..."
                                             : name.empty() ? "one without a name"
                                                            : quoted(name));
    }
    if (!wanted.empty())
        return file_.error(file_.root(),
                           fmt::format("no scene is called {}; there {} {}", quoted(wanted),
                                       count == 1 ? "is" : "are", count == 0 ? "no scenes" : names));
    if (count > 1) {
        const JsonValue at = file_.item(List::scenes, *scene);
        file_.reading.diagnostics.add(
            make_diagnostic(Severity::note, file_.text.place, at.offset(), at.length(),
                            fmt::format("{} scenes: this one is read ({})", count, names)));
    }
    return true;
}

// By its name, or the default one, or the first. Without scenes: all nodes.
bool Nodes::choose_scene(CountedVector<std::uint32_t>& roots) {
    std::optional<std::uint32_t> scene;
    if (file_.count(List::scenes) > 0) scene = 0;
    if (const JsonValue value = file_.root().find("scene"); value.exists()) {
        scene = file_.index(value, List::scenes);
        if (!scene) return false;
    }
    if (!choose_by_name(scene)) return false;
    if (scene) return add_children(file_.item(List::scenes, *scene).find("nodes"), roots);
    const std::uint32_t count = file_.count(List::nodes);
    CountedVector<bool> is_child(count);
    CountedVector<std::uint32_t> children;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!add_children(file_.item(List::nodes, i).find("children"), children)) return false;
    }
    for (const std::uint32_t child : children) is_child[child] = true;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!is_child[i]) roots.push_back(i);
    }
    return true;
}

bool Nodes::place() {
    numbers_.assign(file_.count(List::nodes), k_none);
    CountedVector<std::uint32_t> roots;
    return choose_scene(roots) && place_below(roots);
}

bool Nodes::place_below(CountedVector<std::uint32_t>& roots) {
    constexpr std::size_t k_steps = 1024;
    struct Open {
        std::uint32_t node = 0, parent = k_none;  // the parent's number in placed_
    };
    CountedVector<Open> open;  // the next one is the last
    for (std::size_t i = roots.size(); i-- > 0;) open.push_back({roots[i], k_none});
    CountedVector<std::uint32_t> children;
    while (!open.empty()) {
        const Open next = open.back();
        open.pop_back();
        const JsonValue at = file_.item(List::nodes, next.node);
        if (numbers_[next.node] != k_none)
            return file_.error(at,
                               fmt::format("{} has two parents, or is in itself: expected a tree of nodes",
                                           File::name(List::nodes, next.node)));
        Affine parent_from_node;
        if (!local(at, parent_from_node)) return false;
        const auto number = static_cast<std::uint32_t>(placed_.size());
        numbers_[next.node] = number;
        placed_.push_back({next.node, next.parent == k_none
                                          ? parent_from_node
                                          : compose(placed_[next.parent].world_from_node, parent_from_node)});
        if (number % k_steps == k_steps - 1 && !file_.go_on(at)) return false;
        children.clear();
        if (!add_children(at.find("children"), children)) return false;
        for (std::size_t i = children.size(); i-- > 0;) open.push_back({children[i], number});
    }
    return true;
}

}  // namespace glint::gltf
