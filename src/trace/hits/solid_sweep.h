// SPDX-License-Identifier: Apache-2.0
#pragma once
// The states of a solid along one ray, for solids of many crossings: an event costs as much as changes at it.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "world/geometry/packed_solid.h"

namespace glint {

/// A ray crosses a surface of a part.
struct SolidEvent {
    double t;
    std::uint32_t part;
    std::int32_t change;  ///< of the number of the part's intervals that the ray is in: 1, -1, or 0
};

/// By t.
void sort_events(std::vector<SolidEvent>& events);

class SolidSweep {
  public:
    /// A ray that is in no part. An item of an operand with the number k_none is a part that no ray meets.
    SolidSweep(std::span<const SolidItem> items, std::size_t parts);

    /// The ray meets all of `events`. Returns whether it meets a surface of the solid: find_surface() of
    /// solid_states-inl.h for the states before and after.
    bool meet(std::span<const SolidEvent> events);

    /// By part: 1 if the ray was inside before the events of the last meet(), and after them.
    const std::uint32_t* before() const { return before_.data(); }
    const std::uint32_t* after() const { return after_.data(); }

  private:
    struct State {
        bool before, after, surface;
    };
    struct Place {
        std::uint32_t node;  // that the part belongs to; k_none: it is the solid
        bool is_first;       // of its parts
    };
    // A combination. `inside` counts what SolidCombination adds up: parts, those of which the outside counts
    // turned.
    struct Node {
        SolidOperation operation;
        Place place;
        std::uint32_t parts = 0, inside = 0, others_inside = 0;  // others: all but the first
        // Of the present events.
        std::uint32_t gained = 0, lost = 0, others_gained = 0, others_lost = 0;
        bool has_surface = false, has_inner_surface = false, is_changed = false;
    };

    static State turned(const Node& node, bool is_first, State part);
    void start(Place place, bool is_inside);
    void add(Place place, State part);
    State finish(Node& node);

    std::vector<Node> nodes_;  // each before its parts
    std::vector<Place> place_;
    std::vector<std::int32_t> intervals_;
    std::vector<std::uint32_t> before_, after_;
    std::vector<std::uint32_t> met_, changed_;  // parts; a heap of nodes
    bool is_surface_ = false;
};

}  // namespace glint
