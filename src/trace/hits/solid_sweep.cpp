// SPDX-License-Identifier: Apache-2.0
#include "trace/hits/solid_sweep.h"

#include <algorithm>

#include "world/geometry/surface_id.h"

namespace glint {

namespace {

constexpr std::uint32_t k_left_out = k_none - 1;  // the node of a part that no item has

bool is_sum(SolidOperation operation) {
    return operation == SolidOperation::merge || operation == SolidOperation::unite;
}

bool is_inside(SolidOperation operation, std::uint32_t inside, std::uint32_t parts) {
    return is_sum(operation) ? inside > 0 : inside == parts;
}

}  // namespace

void sort_events(std::vector<SolidEvent>& events) {
    std::sort(events.begin(), events.end(),
              [](const SolidEvent& a, const SolidEvent& b) { return a.t < b.t; });
}

SolidSweep::SolidSweep(std::span<const SolidItem> items, std::size_t parts)
    : place_(parts, {k_left_out, true}), intervals_(parts), before_(parts), after_(parts) {
    std::vector<std::uint32_t> open;
    std::vector<Place> none;  // parts that no ray meets
    for (const SolidItem& item : items) {
        if (item.kind == SolidItem::Kind::end) {
            open.pop_back();
            continue;
        }
        Place place{k_none, true};
        if (!open.empty()) place = {open.back(), nodes_[open.back()].parts++ == 0};
        if (item.kind == SolidItem::Kind::begin) {
            open.push_back(static_cast<std::uint32_t>(nodes_.size()));
            nodes_.push_back({item.operation, place});
        } else if (item.operand == k_none) {
            none.push_back(place);
        } else {
            place_[item.operand] = place;
        }
    }
    for (const Place& place : none) start(place, false);
    for (const Place& place : place_) start(place, false);
    for (std::size_t i = nodes_.size(); i-- > 0;)
        start(nodes_[i].place, is_inside(nodes_[i].operation, nodes_[i].inside, nodes_[i].parts));
}

SolidSweep::State SolidSweep::turned(const Node& node, bool is_first, State part) {
    const bool is_outside = node.operation == SolidOperation::inverse ||
                            (node.operation == SolidOperation::difference && !is_first);
    if (!is_outside) return part;
    return {!part.before, !part.after, part.surface && part.before != part.after};
}

void SolidSweep::start(Place place, bool is_inside) {
    if (place.node >= k_left_out) return;
    Node& node = nodes_[place.node];
    const std::uint32_t one = turned(node, place.is_first, {is_inside, is_inside, false}).after ? 1 : 0;
    node.inside += one;
    if (!place.is_first) node.others_inside += one;
}

void SolidSweep::add(Place place, State part) {
    if (place.node == k_none) is_surface_ = part.surface;
    if (place.node >= k_left_out) return;
    Node& node = nodes_[place.node];
    part = turned(node, place.is_first, part);
    if (part.before != part.after) {
        ++(part.after ? node.gained : node.lost);
        if (!place.is_first) ++(part.after ? node.others_gained : node.others_lost);
    }
    if (part.surface && (place.is_first || node.operation != SolidOperation::clip)) {
        node.has_surface = true;
        node.has_inner_surface |= part.before == part.after;
    }
    if (node.is_changed) return;
    node.is_changed = true;
    changed_.push_back(place.node);
    std::push_heap(changed_.begin(), changed_.end());
}

SolidSweep::State SolidSweep::finish(Node& node) {
    const std::uint32_t inside = node.inside + node.gained - node.lost;
    State whole{is_inside(node.operation, node.inside, node.parts),
                is_inside(node.operation, inside, node.parts), node.has_surface};
    // Inside before or after.
    const std::uint32_t in = node.inside + node.gained, others_in = node.others_inside + node.others_gained;
    if (node.operation == SolidOperation::clip) {
        whole.surface &= others_in + 1 == node.parts;
    } else if (node.operation != SolidOperation::unite && whole.before == whole.after) {
        const bool is_seen = node.operation == SolidOperation::merge ? in < 2 : whole.before;
        whole.surface = node.has_inner_surface && is_seen;
    }
    node.inside = inside;
    node.others_inside = others_in - node.others_lost;
    node.gained = node.lost = node.others_gained = node.others_lost = 0;
    node.has_surface = node.has_inner_surface = node.is_changed = false;
    return whole;
}

bool SolidSweep::meet(std::span<const SolidEvent> events) {
    for (const std::uint32_t part : met_) before_[part] = after_[part];
    met_.clear();
    is_surface_ = false;
    for (const SolidEvent& event : events) {
        intervals_[event.part] += event.change;
        met_.push_back(event.part);
    }
    for (const std::uint32_t part : met_) {
        const bool was = before_[part] != 0, is = intervals_[part] > 0;
        if (was == is || after_[part] == std::uint32_t{is}) continue;  // or added before
        after_[part] = is;
        add(place_[part], {was, is, true});
    }
    while (!changed_.empty()) {
        std::pop_heap(changed_.begin(), changed_.end());
        Node& node = nodes_[changed_.back()];
        changed_.pop_back();
        const State whole = finish(node);
        if (whole.surface || whole.before != whole.after) add(node.place, whole);
    }
    return is_surface_;
}

}  // namespace glint
