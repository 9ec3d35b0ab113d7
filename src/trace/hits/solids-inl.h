// SPDX-License-Identifier: Apache-2.0
// Rays and solids. They extend the hit rule:
//   The crossings of a solid are those of its operands, along the whole line; those of an operand count if
//   the line meets its padded box by the slab expression; those of a mesh are of the mapped line, which
//   crosses its edges and vertices exactly once (world/geometry/mesh_crossings.h). Crossings that follow one
//   within 1e-9 of the size of its point's coordinates, and 2^-44 of those of the ray's origin, are one event
//   with it. A ray hits the solid at an event at which the solid's inside begins or ends, by the states of
//   all operands before and after it (solid_states-inl.h). t is clamped to the interval of the solid's padded
//   box.
#if defined(GLINT_TRACE_SOLIDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SOLIDS_INL_H_
#undef GLINT_TRACE_SOLIDS_INL_H_
#else
#define GLINT_TRACE_SOLIDS_INL_H_
#endif

#include <span>
#include <vector>

#include "geometry/crossings-inl.h"
#include "trace/hits/hit_rule-inl.h"
#include "trace/hits/solid_states-inl.h"
#include "trace/hits/solid_sweep.h"
#include "world/geometry/mesh_crossings-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The crossings of a vector of rays with one operand.
struct OperandCrossings {
    const ShapeClass& shapes;
    const std::uint32_t slot;
    const Ray<Doubles>& ray;
    Crossing<Doubles>* to;
    int count = 0;
    /// Of the operand's kind, whether it is transformed or not.
    void find() { visit_geometry(shapes.kind, false, *this); }
    template <class Geometry> HWY_INLINE void visit() {
        if constexpr (Geometry::k_crossings > 0) find<Geometry>();
    }

  private:
    // Not inline: every kernel that tests solids would contain every kind. One function finds those of
    // transformed shapes, too, as Transformed<Geometry> does.
    template <class Geometry> HWY_NOINLINE void find() {
        static_assert(Geometry::k_crossings / 2 <= k_max_intervals);
        Doubles p[Geometry::k_values];
        broadcast_values<Geometry::k_values>(shapes, slot, p);
        find_crossings<Geometry>(p, shapes.transformed ? mapped(Geometry::k_values) : ray, to);
        count = Geometry::k_crossings / 2;
    }
    /// The ray in the shape's coordinates; first: of the values of the map.
    HWY_INLINE Ray<Doubles> mapped(int first) const {
        Doubles map[12];
        for (int k = 0; k < 12; ++k) map[k] = Doubles(shapes.value(first + k, slot));
        return AffineMap::to_object(map, ray);
    }
};

/// The operands of a solid whose boxes the lines of a packet may meet.
class SolidParts {
  public:
    SolidParts(const PackedSolid& solid, const RayPacket& packet) : solid_(solid) {
        if (solid.slots.size() <= k_few) return;
        std::vector<std::uint32_t> position(solid.slots.size(), k_none);
        const auto size = static_cast<std::uint32_t>(solid.slots.size());
        for (std::uint32_t first = 0; first < size; first += lane_count<float>()) {
            const float* lo[3] = {&solid.lo[0][first], &solid.lo[1][first], &solid.lo[2][first]};
            const float* hi[3] = {&solid.hi[0][first], &solid.hi[1][first], &solid.hi[2][first]};
            const Slab slab = packet_slab(packet, lo, hi);
            std::uint32_t met = to_bits(slab.entry <= slab.exit) &
                                first_bits(number::min(static_cast<int>(size - first), lane_count<float>()));
            for (; met != 0; met &= met - 1) {
                const std::uint32_t operand = first + static_cast<std::uint32_t>(__builtin_ctz(met));
                position[operand] = static_cast<std::uint32_t>(met_.size());
                met_.push_back(operand);
            }
        }
        reduced_ = reduce_items(solid.items, position);
        is_reduced_ = true;
    }

    std::size_t size() const { return is_reduced_ ? met_.size() : solid_.slots.size(); }
    /// The index in the solid.
    std::uint32_t operand(std::size_t i) const {
        return is_reduced_ ? met_[i] : static_cast<std::uint32_t>(i);
    }
    std::span<const SolidItem> items() const { return is_reduced_ ? reduced_ : solid_.items; }
    const PackedSolid& solid() const { return solid_; }

  private:
    static constexpr std::size_t k_few = 8;

    const PackedSolid& solid_;
    bool is_reduced_ = false;
    std::vector<std::uint32_t> met_;
    std::vector<SolidItem> reduced_;
};

/// A vector of rays and their crossings with a solid.
class SolidLanes {
  public:
    SolidLanes(const ShapeTests& tests, const RayPacket& packet, std::uint32_t slot, const SolidParts& parts,
               int i)
        : tests_(tests), slot_(slot), parts_(parts), ray_number_(i), ray_(tests.ray_lanes(i)) {
        if (parts.size() > k_few) {
            grow(parts.size() * k_most);
            many_counts_.resize(parts.size());
            many_states_.resize(2 * parts.size());
            counts_ = many_counts_.data();
            before_ = many_states_.data(), after_ = before_ + parts.size();
        }
        find_all(packet);
    }

    /// Accepts the hits of the rays `bits`, by entry and exit of the solid's box.
    // Vectors by reference: emscripten calls what may throw by functions of JavaScript, which take none.
    void test(std::uint32_t bits, const Doubles& entry, const Doubles& exit) {
        if (total_ > k_most_together) return test_one_by_one(bits, entry, exit);
        const Doubles t_min = load(tests_.rays.t_min + ray_number_);
        const Doubles size = max_abs(ray_.direction), error = max_abs(ray_.origin) * Doubles(k_event_error);
        Doubles last(-k_infinity);
        set_states(last, before_);
        while (true) {
            const Doubles next = next_crossing(last);
            bits &= to_bits(next < Doubles(k_infinity));
            if (bits == 0) return;
            const Doubles reach = max_abs(ray_.origin + ray_.direction * next);
            last = next + (reach * Doubles(k_event_size) + error) / size;
            set_states(last, after_);
            const Doubles t = min(max(next, entry), exit),
                          nearest = load(tests_.result.nearest.t + ray_number_);
            bits &= to_bits(t <= nearest);
            const std::uint32_t begins = to_bits(next > t_min && t > t_min) & bits;
            if (begins != 0) {
                const std::uint32_t hit = find_surface(parts_.items(), before_, after_) & begins;
                if (hit != 0) bits &= ~accept(hit, t, next);
            }
            std::swap(before_, after_);
        }
    }

  private:
    static constexpr std::size_t k_few = 16;
    static constexpr int k_most = k_max_intervals;
    static constexpr int k_stride = 2 * lane_count<double>();
    // Of more crossings, each ray is tested by itself. (Measured: the time is about the same from 0 to 96.)
    static constexpr int k_most_together = 32;

    void find_all(const RayPacket& packet) {
        const PackedSolid& solid = parts_.solid();
        int found = 0;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const std::uint32_t operand = parts_.operand(i), slot = solid.slots[operand];
            const float lo[3] = {solid.lo[0][operand], solid.lo[1][operand], solid.lo[2][operand]};
            const float hi[3] = {solid.hi[0][operand], solid.hi[1][operand], solid.hi[2][operand]};
            const Slab slab = box_slab(packet, ray_number_, lo, hi);
            const std::uint32_t met = to_bits(slab.entry <= slab.exit) & first_bits(lane_count<double>());
            counts_[i] = 0;
            if (met == 0) continue;
            const ShapeClass& shapes = tests_.geometry.class_of(slot);
            if (shapes.kind == ShapeKind::mesh) {
                counts_[i] = add_mesh(i, slot, met, found, (parts_.size() - i - 1) * k_most);
                found += counts_[i];
                continue;
            }
            Crossing<Doubles> crossings[k_most];
            OperandCrossings of{shapes, slot, ray_, crossings};
            of.find();
            const auto is_met = from_bits<double>(met);
            double* to = crossings_ + found * k_stride;
            for (int k = 0; k < of.count; ++k, to += k_stride) {
                store(select(is_met, crossings[k].enter, Doubles(k_infinity)), to);
                store(select(is_met, crossings[k].exit, Doubles(-k_infinity)), to + lane_count<double>());
            }
            counts_[i] = of.count;
            found += of.count;
        }
        total_ = found;
    }

    HWY_NOINLINE void test_one_by_one(std::uint32_t bits, const Doubles& entry, const Doubles& exit) {
        alignas(64) double entries[lane_count<double>()], exits[lane_count<double>()];
        store(entry, entries);
        store(exit, exits);
        const SolidSweep outside(parts_.items(), parts_.size());
        for (; bits != 0; bits &= bits - 1) {
            const int lane = __builtin_ctz(bits);
            sweep(lane, entries[lane], exits[lane], outside);
        }
    }

    /// Accepts the hits of one ray.
    void sweep(int lane, double entry, double exit, SolidSweep states) {
        const HitResult& result = tests_.result;
        const RaySpan& rays = tests_.rays;
        const int ray = ray_number_ + lane;
        const Vector3<double> origin{rays.ox[ray], rays.oy[ray], rays.oz[ray]},
            direction{rays.dx[ray], rays.dy[ray], rays.dz[ray]};
        const double t_min = rays.t_min[ray], size = max_abs(direction),
                     error = max_abs(origin) * k_event_error;
        const std::vector<SolidEvent> events = events_of(lane);
        const auto end_of = [&](std::size_t from, double t) {
            while (from < events.size() && events[from].t <= t) ++from;
            return from;
        };
        std::size_t at = end_of(0, -k_infinity);
        states.meet({events.data(), at});
        while (at < events.size()) {
            const double next = events[at].t;
            const double reach = max_abs(origin + direction * next);
            const std::size_t end = end_of(at, next + (reach * k_event_size + error) / size);
            const double t = number::min(number::max(next, entry), exit);
            if (end == at || !(t <= result.nearest.t[ray])) return;
            const bool is_surface = states.meet({events.data() + at, end - at});
            at = end;
            if (!is_surface || !(next > t_min && t > t_min)) continue;
            const std::size_t part =
                find_face(parts_.items(), states.before(), states.after(), parts_.size(), 1);
            if (accept_one(lane, part, t, next)) return;
        }
    }

    /// Where a ray crosses parts, in order; no infinite t but the least.
    std::vector<SolidEvent> events_of(int lane) const {
        std::vector<SolidEvent> events;
        const double* at = crossings_ + lane;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            for (int k = 0; k < counts_[i]; ++k, at += k_stride) {
                const double enter = at[0], exit = at[lane_count<double>()];
                const int change = enter < exit ? 1 : 0;
                const auto part = static_cast<std::uint32_t>(i);
                if (enter < k_infinity) events.push_back({enter, part, change});
                if (exit < k_infinity && exit > -k_infinity) events.push_back({exit, part, -change});
            }
        }
        sort_events(events);
        return events;
    }

    /// Writes the intervals of the rays `met` with a mesh to place `first`, with room for as many as `after`
    /// of the parts behind it. Returns the number of their vectors.
    HWY_NOINLINE int add_mesh(std::size_t part, std::uint32_t slot, std::uint32_t met, int first,
                              std::size_t after) {
        constexpr std::size_t lanes = lane_count<double>();
        const RaySpan& rays = tests_.rays;
        Ray<double> lines[lanes];
        std::size_t lane_of[lanes] = {};
        int size = 0;
        for (; met != 0; met &= met - 1, ++size) {
            const auto lane = static_cast<std::size_t>(__builtin_ctz(met));
            const auto i = static_cast<std::size_t>(ray_number_) + lane;
            lines[size] = {{rays.ox[i], rays.oy[i], rays.oz[i]}, {rays.dx[i], rays.dy[i], rays.dz[i]}};
            lane_of[size] = lane;
        }
        std::vector<MeshCrossing> found[lanes];
        find_crossings_of_mesh(tests_.geometry, slot, lines, size, found);
        std::size_t count = 0;
        for (int i = 0; i < size; ++i) count = number::max(count, found[i].size() / 2);
        grow(static_cast<std::size_t>(first) + count + after);
        double* const to = crossings_ + static_cast<std::size_t>(first) * k_stride;
        for (std::size_t k = 0; k < count; ++k) {
            store(Doubles(k_infinity), to + k * k_stride);
            store(Doubles(-k_infinity), to + k * k_stride + lanes);
        }
        for (int i = 0; i < size; ++i) {
            for (std::size_t k = 0; k < found[i].size(); ++k) {
                to[k * lanes + lane_of[i]] = found[i][k].t;
                faces_.push_back({part, lane_of[i], found[i][k]});
            }
        }
        return static_cast<int>(count);
    }

    /// Makes room for as many intervals.
    void grow(std::size_t intervals) {
        if (intervals * k_stride <= (many_.empty() ? std::size(few_) : many_.size())) return;
        const bool is_first = many_.empty();
        many_.resize(intervals * k_stride);
        if (is_first) std::copy(std::begin(few_), std::end(few_), many_.begin());
        crossings_ = many_.data();
    }

    /// The least t of a crossing beyond `last`.
    Doubles next_crossing(Doubles last) const noexcept {
        Doubles next(k_infinity);
        const double* const end = crossings_ + total_ * k_stride;
        for (const double* at = crossings_; at != end; at += lane_count<double>()) {
            const Doubles t = load(at);
            next = min(next, select(t > last, t, Doubles(k_infinity)));
        }
        return next;
    }

    /// By operand: the rays that are inside it beyond t.
    void set_states(Doubles t, std::uint32_t* states) const noexcept {
        const double* at = crossings_;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            std::uint32_t inside = 0;
            for (const double* const end = at + counts_[i] * k_stride; at != end; at += k_stride)
                inside |= to_bits(load(at) <= t && load(at + lane_count<double>()) > t);
            states[i] = inside;
        }
    }

    /// The surface of a part that a ray meets from t on.
    SurfaceId surface_of(std::size_t part, int lane, double t) const {
        const std::uint32_t slot = parts_.solid().slots[parts_.operand(part)];
        for (const MeshFace& face : faces_) {
            if (face.part == part && face.lane == static_cast<std::size_t>(lane) && face.crossing.t >= t)
                return {slot, face.crossing.triangle};
        }
        return tests_.geometry.surface_of(slot);
    }

    /// Returns the rays that need no further crossings. next: where they cross, not clamped.
    std::uint32_t accept(std::uint32_t hit, Doubles at, Doubles next) noexcept {
        alignas(64) double t[lane_count<double>()], from[lane_count<double>()];
        store(at, t);
        store(next, from);
        std::uint32_t done = 0;
        for (; hit != 0; hit &= hit - 1) {
            const int lane = __builtin_ctz(hit);
            const std::size_t part = find_face(parts_.items(), before_, after_, parts_.size(), 1u << lane);
            if (accept_one(lane, part, t[lane], from[lane])) done |= 1u << lane;
        }
        return done;
    }
    /// Returns whether the ray needs no further crossings.
    bool accept_one(int lane, std::size_t part, double t, double next) const {
        const HitResult& result = tests_.result;
        const int ray = ray_number_ + lane;
        result.accept(ray, t, surface_of(part, lane, next));
        // Of several operands, some may let light pass.
        if (result.occluded != nullptr && result.occluded[ray] == 0) return false;
        if (result.occluded != nullptr) *result.occluder = slot_;  // operands occlude only together
        return true;
    }

    struct MeshFace {
        std::size_t part, lane;
        MeshCrossing crossing;
    };

    const ShapeTests& tests_;
    const std::uint32_t slot_;  // of the solid
    const SolidParts& parts_;
    const int ray_number_;  // of the first, in the chunk
    const Ray<Doubles> ray_;
    alignas(64) double few_[k_few * k_most * k_stride];
    int few_counts_[k_few];
    std::uint32_t few_states_[2 * k_few];
    std::vector<double> many_;
    std::vector<MeshFace> faces_;  // by part, ray and t
    std::vector<int> many_counts_;
    std::vector<std::uint32_t> many_states_;
    double* crossings_ = few_;   // of each, the vectors of enter and exit
    int* counts_ = few_counts_;  // of crossings, by part
    int total_ = 0;
    std::uint32_t *before_ = few_states_, *after_ = few_states_ + k_few;  // the rays that are inside, by part
};

void ShapeTests::solids_leaf(const ShapeClass& shapes, const RayPacket& packet, std::uint64_t active,
                             std::uint32_t first, std::uint32_t count) {
    constexpr int lanes = lane_count<float>();
    for (std::uint32_t shape = first; shape < first + count; ++shape) {
        const float lo[3] = {geometry.box_lo[0][shape], geometry.box_lo[1][shape], geometry.box_lo[2][shape]};
        const float hi[3] = {geometry.box_hi[0][shape], geometry.box_hi[1][shape], geometry.box_hi[2][shape]};
        const std::uint64_t met = rays_that_meet(packet, active, lo, hi);
        if (met == 0) continue;
        const SolidParts parts(geometry.solids[static_cast<std::size_t>(shapes.value(0, shape))], packet);
        for (int r = 0; r < packet.count; r += lanes) {
            const std::uint32_t bits = static_cast<std::uint32_t>(met >> r) & first_bits(lanes);
            if (bits == 0) continue;
            const Slab slab = box_slab(packet, packet.first + r, lo, hi);
            alignas(64) float entry[lanes], exit[lanes];
            store(slab.entry, entry);
            store(slab.exit, exit);
            for (int c = 0; c < lanes; c += lane_count<double>()) {
                const std::uint32_t here = bits >> c & first_bits(lane_count<double>());
                if (here == 0) continue;
                SolidLanes(*this, packet, shape, parts, packet.first + r + c)
                    .test(here, widen(entry + c), widen(exit + c));
            }
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
