// SPDX-License-Identifier: Apache-2.0
// The plane is cut at the y of all points and crossings. Between two cuts no edges cross: from left to right
// they are borders of what is inside in turn. A trapezoid goes on through the cuts while its borders do.
#include "formats/povray/even_odd.h"

#include <algorithm>

namespace glint::povray {
namespace {

constexpr std::size_t k_max_crossings = 100000;

struct RisingEdge {
    FlatPoint low, high;  // low.y < high.y

    /// The same for both trapezoids beside it.
    double x_at(double y) const {
        if (y <= low.y) return low.x;
        if (y >= high.y) return high.x;
        return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
    }
};

// A trapezoid by the number of its left edge.
struct OpenTrapezoid {
    std::size_t right = 0;
    double from = 0, to = 0;
    bool is_open = false;
};

CountedVector<RisingEdge> edges_of(const CountedVector<FlatLoop>& loops) {
    CountedVector<RisingEdge> edges;
    std::size_t points = 0;
    for (const FlatLoop& loop : loops) points += loop.size();
    edges.reserve(points);
    for (const FlatLoop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const FlatPoint a = loop[i], b = loop[(i + 1) % loop.size()];
            if (a.y == b.y) continue;
            edges.push_back(a.y < b.y ? RisingEdge{a, b} : RisingEdge{b, a});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const RisingEdge& a, const RisingEdge& b) { return a.low.y < b.low.y; });
    return edges;
}

// Adds the y of each crossing.
bool add_crossings(const CountedVector<RisingEdge>& edges, const std::function<bool(std::uint64_t)>& spend,
                   CountedVector<double>& cuts) {
    const std::size_t most = cuts.size() + k_max_crossings;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const RisingEdge& a = edges[i];
        std::size_t k = i + 1;
        for (; k < edges.size() && edges[k].low.y < a.high.y; ++k) {
            const RisingEdge& b = edges[k];
            const double low = b.low.y, high = std::min(a.high.y, b.high.y);
            const double before = a.x_at(low) - b.x_at(low), after = a.x_at(high) - b.x_at(high);
            if (!(before < 0 && after > 0) && !(before > 0 && after < 0)) continue;
            const double y = low + (high - low) * (before / (before - after));
            if (y > low && y < high) cuts.push_back(y);
            if (cuts.size() > most) return false;
        }
        if (!spend((k - i) / 64 + 1)) return false;
    }
    return true;
}

FlatTrapezoid trapezoid_of(const RisingEdge& left, const RisingEdge& right, double from, double to) {
    return {{left.x_at(from), from}, {right.x_at(from), from}, {left.x_at(to), to}, {right.x_at(to), to}};
}

}  // namespace

bool fill_even_odd(const CountedVector<FlatLoop>& loops, const std::function<bool(std::uint64_t)>& spend,
                   CountedVector<FlatTrapezoid>& trapezoids) {
    const CountedVector<RisingEdge> edges = edges_of(loops);
    CountedVector<double> cuts;
    cuts.reserve(2 * edges.size());
    for (const RisingEdge& edge : edges) {
        cuts.push_back(edge.low.y);
        cuts.push_back(edge.high.y);
    }
    if (!add_crossings(edges, spend, cuts)) return false;
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    CountedVector<OpenTrapezoid> open(edges.size());
    CountedVector<std::size_t> active;  // from left to right
    CountedVector<double> x(edges.size());
    std::size_t next = 0;
    for (std::size_t cut = 0; cut + 1 < cuts.size(); ++cut) {
        const double from = cuts[cut], to = cuts[cut + 1];
        active.erase(std::remove_if(active.begin(), active.end(),
                                    [&](std::size_t i) { return edges[i].high.y <= from; }),
                     active.end());
        while (next < edges.size() && edges[next].low.y <= from) active.push_back(next++);
        if (!spend(active.size() / 16 + 1)) return false;
        for (const std::size_t i : active) x[i] = edges[i].x_at(from + (to - from) / 2);
        // Nearly in order: only those that begin here, or that cross at the cut, move.
        for (std::size_t i = 1; i < active.size(); ++i) {
            const std::size_t moved = active[i];
            std::size_t at = i;
            for (; at > 0 && x[active[at - 1]] > x[moved]; --at) active[at] = active[at - 1];
            active[at] = moved;
        }
        for (std::size_t i = 0; i + 1 < active.size(); i += 2) {
            OpenTrapezoid& trapezoid = open[active[i]];
            if (trapezoid.is_open && trapezoid.right == active[i + 1] && trapezoid.to == from) {
                trapezoid.to = to;
                continue;
            }
            if (trapezoid.is_open)
                trapezoids.push_back(
                    trapezoid_of(edges[active[i]], edges[trapezoid.right], trapezoid.from, trapezoid.to));
            trapezoid = {active[i + 1], from, to, true};
        }
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (open[i].is_open)
            trapezoids.push_back(trapezoid_of(edges[i], edges[open[i].right], open[i].from, open[i].to));
    }
    return true;
}

bool fill_even_odd(const CountedVector<FlatLoop>& loops, const std::function<bool(std::uint64_t)>& spend,
                   CountedVector<FlatTriangle>& triangles) {
    CountedVector<FlatTrapezoid> trapezoids;
    if (!fill_even_odd(loops, spend, trapezoids)) return false;
    for (const auto& [a, b, d, c] : trapezoids) {
        if (a.x < b.x) triangles.push_back({a, b, c});
        if (d.x < c.x) triangles.push_back({a, c, d});
    }
    return true;
}

}  // namespace glint::povray
