// SPDX-License-Identifier: Apache-2.0
// Where a solid has a surface, by the states of its operands on both sides of an event. A state is a bit for
// each of up to 32 rays: whether the ray is inside.
#if defined(GLINT_TRACE_SOLID_STATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SOLID_STATES_INL_H_
#undef GLINT_TRACE_SOLID_STATES_INL_H_
#else
#define GLINT_TRACE_SOLID_STATES_INL_H_
#endif

#include <algorithm>
#include <span>
#include <vector>

#include "simd/lanes-inl.h"
#include "world/geometry/packed_solid.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Crossings within these parts of the coordinates of their point, and of the origin, are one event. The
/// second covers the rounding errors of rays from far away, which are some 2^-50 of their origin.
inline constexpr double k_event_size = 1e-9, k_event_error = 0x1p-44;

/// What is known of a part of a solid at an event.
struct SolidState {
    std::uint32_t before = 0, after = 0;  // inside
    /// There is a surface. With SolidOperation::unite also where `before` and `after` are both set.
    std::uint32_t surface = 0;
};

/// A combination whose parts are added one by one.
class SolidCombination {
  public:
    explicit SolidCombination(SolidOperation operation = SolidOperation::operand) : operation_(operation) {}

    HWY_INLINE void add(SolidState part) {
        const bool is_first = is_empty_;
        is_empty_ = false;
        switch (operation_) {
            case SolidOperation::merge:
            case SolidOperation::unite: {
                const std::uint32_t inside = part.before | part.after;
                in_two_ |= in_one_ & inside;
                in_one_ |= inside;
                all_.before |= part.before, all_.after |= part.after;
                break;
            }
            case SolidOperation::inverse:
                part = outside_of(part);
                break;
            case SolidOperation::difference:
                if (!is_first) part = outside_of(part);
                break;
            case SolidOperation::clip:
                if (is_first) break;
                all_.surface &= part.before | part.after;
                part.surface = 0;
                break;
            case SolidOperation::operand:
            case SolidOperation::intersection:
                break;
        }
        if (operation_ != SolidOperation::merge && operation_ != SolidOperation::unite) {
            all_.before = is_first ? part.before : all_.before & part.before;
            all_.after = is_first ? part.after : all_.after & part.after;
        }
        inner_ |= part.surface & ~(part.before ^ part.after);
        all_.surface |= part.surface;
    }
    HWY_INLINE SolidState result() const {
        if (operation_ == SolidOperation::unite || operation_ == SolidOperation::clip) return all_;
        // Surfaces within a part remain where no other part ends them.
        const std::uint32_t seen = operation_ == SolidOperation::merge ? ~in_two_ : all_.before & all_.after;
        const std::uint32_t changes = all_.before ^ all_.after;
        return {all_.before, all_.after, (changes & all_.surface) | (~changes & inner_ & seen)};
    }

  private:
    static HWY_INLINE SolidState outside_of(SolidState part) {
        // The outside of a union has no surfaces within it (POV-Ray, measured).
        return {~part.before, ~part.after, part.surface & (part.before ^ part.after)};
    }

    SolidOperation operation_;
    bool is_empty_ = true;
    SolidState all_;
    std::uint32_t in_one_ = 0, in_two_ = 0;  // inside at least one part, at least two
    std::uint32_t inner_ = 0;                // surfaces where the inside does not change
};

/// The rays that meet a surface of the solid, by the operands' states before and after an event. An operand
/// with the number k_none is met by no ray.
inline std::uint32_t find_surface(std::span<const SolidItem> items, const std::uint32_t* before,
                                  const std::uint32_t* after) {
    SolidCombination open[k_max_solid_depth + 1];
    int depth = 0;
    SolidState state;
    for (const SolidItem& item : items) {
        if (item.kind == SolidItem::Kind::begin) {
            open[depth++] = SolidCombination(item.operation);
            continue;
        }
        if (item.kind == SolidItem::Kind::end) {
            state = open[--depth].result();
        } else if (item.operand == k_none) {
            state = {};
        } else {
            const std::uint32_t from = before[item.operand], to = after[item.operand];
            state = {from, to, from ^ to};
        }
        if (depth > 0) open[depth - 1].add(state);
    }
    return state.surface;
}

/// The operand whose surface a ray meets at an event: the first that would make a surface by itself, else the
/// first that changes. ray: a bit.
inline std::size_t find_face(std::span<const SolidItem> items, const std::uint32_t* before,
                             const std::uint32_t* after, std::size_t count, std::uint32_t ray) {
    std::size_t first = count, changes = 0;
    for (std::size_t i = count; i-- > 0;) {
        if (((before[i] ^ after[i]) & ray) != 0) first = i, ++changes;
    }
    if (changes <= 1) return first;
    std::vector<std::uint32_t> only(before, before + count);
    for (std::size_t i = first; i < count; ++i) {
        if (((before[i] ^ after[i]) & ray) == 0) continue;
        only[i] = after[i];
        const bool is_surface = (find_surface(items, before, only.data()) & ray) != 0;
        only[i] = before[i];
        if (is_surface) return i;
    }
    return first;
}

/// What of a combination is met, while its items are reduced.
struct ReducedCombination {
    SolidOperation operation;
    std::size_t begin;        // of its items
    bool has_parts = false;   // before they were reduced
    bool is_nothing = false;  // no ray is inside, or meets a surface: parts that are none decide this
    bool has_any = false;     // a part that is not nothing

    /// Adds a part. Returns whether it is of no effect.
    bool add(bool part_is_nothing) {
        const bool is_first = !has_parts;
        has_parts = true;
        if (!part_is_nothing) {
            has_any = true;
            return false;
        }
        switch (operation) {
            case SolidOperation::merge:
            case SolidOperation::unite:
                return true;
            case SolidOperation::difference:
                is_nothing |= is_first;
                return !is_first;
            case SolidOperation::intersection:
            case SolidOperation::clip:
                is_nothing = true;
                return false;
            case SolidOperation::inverse:
            case SolidOperation::operand:
                break;
        }
        return false;
    }
    bool ends_as_nothing() const {
        const bool is_sum = operation == SolidOperation::merge || operation == SolidOperation::unite;
        return is_nothing || (is_sum && !has_any);
    }
};

/// The items without operands that no ray meets, and without combinations of which nothing is met, where they
/// do not matter. position: of an operand among those that are met, or k_none.
inline std::vector<SolidItem> reduce_items(std::span<const SolidItem> items,
                                           std::span<const std::uint32_t> position) {
    std::vector<SolidItem> reduced;
    std::vector<ReducedCombination> open;
    for (SolidItem item : items) {
        if (item.kind == SolidItem::Kind::begin) {
            open.push_back({item.operation, reduced.size()});
            reduced.push_back(item);
            continue;
        }
        bool is_nothing = false;
        if (item.kind == SolidItem::Kind::end) {
            const ReducedCombination whole = open.back();
            open.pop_back();
            is_nothing = whole.ends_as_nothing();
            if (is_nothing) {
                reduced.resize(whole.begin);
                item = {SolidItem::Kind::operand, SolidOperation::operand, k_none};
            }
        } else {
            item.operand = position[item.operand];
            is_nothing = item.operand == k_none;
        }
        if (!open.empty() && open.back().add(is_nothing)) continue;
        reduced.push_back(item);
    }
    return reduced;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
