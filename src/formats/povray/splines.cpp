// SPDX-License-Identifier: Apache-2.0
// spline { [KIND] t, value, ... }, called as S(t [, KIND]). What was measured of POV-Ray: before the first
// and after the last t, the value is theirs, of cubic ones that of their neighbours; of several values at one
// t the last counts, but the first where t was the greatest of two or more; a number stands for two terms;
// quadratic ones are the parabola through both ends of a span and the point before, of
// the first span the point after; cubic ones have at each point the mean of the slopes beside it; natural
// ones bend nowhere at their ends. Two points make a straight line, of a cubic spline their mean.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/value_parser.h"

namespace glint::povray {
namespace {

constexpr std::string_view k_kinds[] = {"linear_spline", "quadratic_spline", "cubic_spline",
                                        "natural_spline"};
constexpr std::size_t k_quadratic = 1, k_cubic = 2, k_natural = 3;

// The second derivatives of one term of a natural spline, by points.
CountedVector<double> bends(const CountedVector<ValueSpline::Point>& p, std::size_t term) {
    const auto slope = [&](std::size_t i) {
        return (p[i + 1].value.v[term] - p[i].value.v[term]) / (p[i + 1].t - p[i].t);
    };
    CountedVector<double> bend(p.size()), over(p.size());
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const double before = p[i].t - p[i - 1].t, after = p[i + 1].t - p[i].t;
        const double pivot = 2 * (before + after) - before * over[i - 1];
        over[i] = after / pivot;
        bend[i] = (6 * (slope(i) - slope(i - 1)) - before * bend[i - 1]) / pivot;
    }
    for (std::size_t i = p.size() - 1; i-- > 1;) bend[i] -= over[i] * bend[i + 1];
    return bend;
}

// One term, for t between the points k and k + 1.
double value_between(const CountedVector<ValueSpline::Point>& p, std::size_t k, std::size_t kind, double t,
                     std::size_t term) {
    const auto x = [&](std::size_t i) { return p[i].value.v[term]; };
    const auto slope = [&](std::size_t i) { return (x(i + 1) - x(i)) / (p[i + 1].t - p[i].t); };
    const double from = t - p[k].t, span = p[k + 1].t - p[k].t, left = span - from;
    const double straight = x(k) + slope(k) * from;
    if (kind == k_quadratic) {
        const std::size_t first = k == 0 ? 0 : k - 1;
        return straight - from * left * (slope(first + 1) - slope(first)) / (p[first + 2].t - p[first].t);
    }
    if (kind == k_cubic) {
        const double a = (slope(k - 1) - slope(k)) / 2, b = (slope(k) - slope(k + 1)) / 2;
        return straight + from * left * (a * left + b * from) / (span * span);
    }
    if (kind == k_natural) {
        const CountedVector<double> bend = bends(p, term);
        return straight - from * left * (bend[k] * (left + span) + bend[k + 1] * (from + span)) / (6 * span);
    }
    return straight;
}

}  // namespace

// False, and nothing is read, if this is no kind of a spline.
bool ValueParser::read_spline_kind(std::size_t& kind) {
    if (peek().kind != TokenKind::word) return false;
    const auto* const found = std::find(std::begin(k_kinds), std::end(k_kinds), text_of(peek()));
    if (found == std::end(k_kinds)) return false;
    take();
    kind = static_cast<std::size_t>(found - std::begin(k_kinds));
    return true;
}

// After `spline`: a declared one may be first.
std::shared_ptr<const ValueSpline> ValueParser::read_value_spline() {
    auto out = make_counted<ValueSpline>();
    if (!expect('{')) return out;
    double first = 0;
    bool has_first = false;
    if (const Value* known = find_value(peek());
        known != nullptr && !std::holds_alternative<Numbers>(*known)) {
        const Token name = take();
        const Value value = named_value(name);
        if (const auto* copied = std::get_if<std::shared_ptr<const ValueSpline>>(&value)) {
            *out = **copied;
        } else if (const auto* numbers = std::get_if<Numbers>(&value)) {
            first = expression_after(*numbers).v[0];  // of an array
            has_first = true;
        } else if (!failed()) {
            error(name, fmt::format("expected a spline or a number, found {}", povray::describe(value)));
        }
    }
    if (!has_first) read_spline_kind(out->kind);
    auto& points = out->points;
    while (!failed() && (has_first || !peek().is('}'))) {
        const double t = has_first ? first : number();
        has_first = false;
        accept(',');
        const Numbers value = promoted(expression(), 2);
        accept(',');
        out->terms = std::max(out->terms, value.terms);
        const auto at = std::lower_bound(points.begin(), points.end(), t,
                                         [](const ValueSpline::Point& p, double x) { return p.t < x; });
        if (!spend(static_cast<std::uint64_t>(points.end() - at) / 64 + 1)) break;
        if (at == points.end() || at->t != t) {
            points.insert(at, {t, value});
        } else if (points.size() == 1 || at + 1 != points.end()) {
            at->value = value;
        }
    }
    if (!failed() && points.empty()) expected("a number and a value");
    for (auto& point : points) point.value = promoted(point.value, out->terms);
    if (!failed()) expect('}');
    return out;
}

// The spline's name has been read: (t [, KIND]).
Numbers ValueParser::call_spline(const Token& name, const std::shared_ptr<const ValueSpline>& spline) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('(')) return {};
    const double t = number();
    std::size_t kind = spline->kind;
    if (accept(',') && !read_spline_kind(kind)) expected("the kind of a spline");
    if (failed() || !expect(')')) return {};
    const auto& points = spline->points;
    const std::size_t n = points.size();
    if (n == 2 && kind == k_cubic) {
        Numbers mean = points[0].value;
        for (std::size_t i = 0; i < mean.v.size(); ++i) mean.v[i] = (mean.v[i] + points[1].value.v[i]) / 2;
        return mean;
    }
    if (n < 3) kind = 0;
    const std::size_t first = kind == k_cubic ? 1 : 0, last = n - 1 - first;
    if (t <= points[first].t) return points[first].value;
    if (t >= points[last].t) return points[last].value;
    const auto after = std::upper_bound(points.begin(), points.end(), t,
                                        [](double x, const ValueSpline::Point& p) { return x < p.t; });
    Numbers out = points[first].value;
    for (std::size_t i = 0; i < static_cast<std::size_t>(out.terms); ++i) {
        if (!spend(kind == k_natural ? n / 4 + 1 : 1)) return {};
        out.v[i] = value_between(points, static_cast<std::size_t>(after - points.begin()) - 1, kind, t, i);
        if (!(out.v[i] <= 1e300 && out.v[i] >= -1e300) && !failed())
            error(name, "the spline has no finite value here");
    }
    return failed() ? Numbers() : out;
}

}  // namespace glint::povray
