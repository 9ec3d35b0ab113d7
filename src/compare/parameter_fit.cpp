// SPDX-License-Identifier: Apache-2.0
#include "compare/parameter_fit.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr int k_iterations = 4, k_near_iterations = 8, k_dampings = 3;
constexpr double k_first_damping = 0.01, k_damping_factor = 8;
constexpr double k_min_gain = 0.01;       // of the squared difference: else the next blur
constexpr double k_enough = 0.01;         // mean difference in 255ths that is rounding
constexpr double k_rounding_costs = 0.1;  // rounding a number may add this fraction of what remains
constexpr double k_near_step = 6;         // units of one step without a blur
constexpr double k_fine = 0.6;            // slopes are refined if this fraction is left, or less
// The numbers of a cause remove most of the difference that is blurred most. If more than this fraction of
// its square is left, no other blur is tried.
constexpr double k_hopeless_fit = 0.7;
constexpr std::size_t k_max_values = 6;
// Numbers that leave at most this fraction are polished: by what is left of at most this, so that edges do
// not count, and slopes of this part of a unit.
constexpr double k_worth_polishing = 0.2, k_rest = 1.5 / 255, k_polish_unit = 0.1, k_polish_damping = 1e-6;
constexpr double k_half_byte = 0.5 / 255;
constexpr int k_polishings = 8;

// A stage of a fit: the radius of the blur, and the units by which slopes are measured. What moves edges by
// less than a pixel needs smaller ones.
struct Stage {
    int radius = 0;
    double by = 1;
};
std::vector<Stage> stages_of(std::int32_t columns, FitStart start) {
    std::vector<Stage> last = {{0, 1}, {0, 0.3}, {0, 0.1}};
    if (start == FitStart::near) return last;
    const int first = std::max(columns / 16, 2);
    std::vector<Stage> stages;
    for (const int radius : {first, first / 2, first / 4, 1})
        stages.push_back({radius, std::max(1.0, radius / 2.0)});
    stages.insert(stages.end(), last.begin(), last.end());
    return stages;
}

void clamp_to_picture(std::vector<float>& values) {
    for (float& v : values) v = std::clamp(v, 0.0f, 1.0f);
}

std::optional<std::vector<float>> rendered_with(const FitProblem& problem, std::span<const double> values) {
    std::optional<std::vector<float>> made = problem.render(values);
    if (made) clamp_to_picture(*made);
    return made;
}

// The mean of 2 radius + 1 numbers around each, `step` apart; beyond the ends there are zeros.
void blur_line(float* line, std::ptrdiff_t count, std::ptrdiff_t step, int radius,
               std::vector<float>& scratch) {
    scratch.resize(static_cast<std::size_t>(count) + 1);
    double sum = 0;
    scratch[0] = 0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        sum += static_cast<double>(line[i * step]);
        scratch[static_cast<std::size_t>(i) + 1] = static_cast<float>(sum);
    }
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const std::ptrdiff_t first = std::max<std::ptrdiff_t>(i - radius, 0),
                             end = std::min<std::ptrdiff_t>(i + radius + 1, count);
        line[i * step] = (scratch[static_cast<std::size_t>(end)] - scratch[static_cast<std::size_t>(first)]) /
                         static_cast<float>(2 * radius + 1);
    }
}

// Solves a x = b by Gaussian elimination; zeros where a is singular.
std::vector<double> solved(std::vector<std::vector<double>> a, std::vector<double> b) {
    const std::size_t n = b.size();
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i + 1; k < n; ++k) {
            if (std::fabs(a[k][i]) > std::fabs(a[pivot][i])) pivot = k;
        }
        if (!(std::fabs(a[pivot][i]) > 0)) return std::vector<double>(n);
        std::swap(a[i], a[pivot]);
        std::swap(b[i], b[pivot]);
        for (std::size_t k = i + 1; k < n; ++k) {
            const double factor = a[k][i] / a[i][i];
            for (std::size_t j = i; j < n; ++j) a[k][j] -= factor * a[i][j];
            b[k] -= factor * b[i];
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i][j] * b[j];
        b[i] /= a[i][i];
    }
    return b;
}

}  // namespace

double product(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum;
}

// The normal equations of one step.
struct ParameterFit::Step {
    std::vector<std::vector<double>> squares;
    std::vector<double> products;
    double error = 0;  // squared

    std::vector<double> change(double damping) const {
        std::vector<std::vector<double>> damped = squares;
        double most = 0;
        for (std::size_t i = 0; i < damped.size(); ++i) most = std::max(most, squares[i][i]);
        for (std::size_t i = 0; i < damped.size(); ++i)
            damped[i][i] += damping * squares[i][i] + 1e-6 * damping * most + 1e-30;
        return solved(std::move(damped), products);
    }
};

ParameterFit::ParameterFit(const PixelGrid& grid, const BytePicture& target) : grid_(grid) {
    target_.reserve(target.rgb.size());
    for (const std::uint8_t v : target.rgb) target_.push_back(static_cast<float>(v) / 255);
}

std::vector<float> ParameterFit::blurred_difference(const std::vector<float>& to,
                                                    const std::vector<float>& from, int radius) const {
    std::vector<float> difference(to.size());
    for (std::size_t i = 0; i < to.size(); ++i) difference[i] = to[i] - from[i];
    if (radius == 0) return difference;
    const std::ptrdiff_t columns = grid_.columns(), rows = grid_.rows();
    std::vector<float> scratch;
    for (std::ptrdiff_t c = 0; c < 3; ++c) {
        for (std::ptrdiff_t y = 0; y < rows; ++y)
            blur_line(&difference[static_cast<std::size_t>(3 * y * columns + c)], columns, 3, radius,
                      scratch);
        for (std::ptrdiff_t x = 0; x < columns; ++x)
            blur_line(&difference[static_cast<std::size_t>(3 * x + c)], rows, 3 * columns, radius, scratch);
    }
    return difference;
}

std::optional<ParameterFit::Step> ParameterFit::step_from(const FitProblem& problem,
                                                          std::span<const double> values,
                                                          const std::vector<float>& rendered, int radius,
                                                          double by) const {
    const std::vector<float> error = blurred_difference(target_, rendered, radius);
    std::vector<std::vector<float>> slopes;
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::vector<double> beside(values.begin(), values.end());
        beside[i] += by * problem.units[i];
        const auto made = rendered_with(problem, beside);
        if (!made) return std::nullopt;
        slopes.push_back(blurred_difference(*made, rendered, radius));
        for (float& v : slopes.back()) v /= static_cast<float>(by);
    }
    return step_of(slopes, error);
}

ParameterFit::Step ParameterFit::step_of(const std::vector<std::vector<float>>& slopes,
                                         const std::vector<float>& error) {
    Step step{{}, {}, product(error, error)};
    for (const auto& a : slopes) {
        step.products.push_back(product(a, error));
        step.squares.emplace_back();
        for (const auto& b : slopes) step.squares.back().push_back(product(a, b));
    }
    return step;
}

double ParameterFit::promise(const FitProblem& problem, const std::vector<float>& at_start) const {
    std::vector<float> rendered = at_start;
    clamp_to_picture(rendered);
    const Stage stage = stages_of(grid_.columns(), FitStart::far)[1];
    const auto step = step_from(problem, problem.start, rendered, stage.radius, stage.by);
    if (!step || !(step->error > 0)) return 0;
    const std::vector<double> change = step->change(k_first_damping);
    double gain = 0;
    for (std::size_t i = 0; i < change.size(); ++i) gain += change[i] * step->products[i];
    return gain / step->error;
}

double ParameterFit::blurred_square(std::vector<float> rendered) const {
    clamp_to_picture(rendered);
    const int radius = stages_of(grid_.columns(), FitStart::far)[1].radius;
    const std::vector<float> error = blurred_difference(target_, rendered, radius);
    return product(error, error);
}

double ParameterFit::left_of(const std::vector<float>& rendered) const {
    double sum = 0;
    for (std::size_t i = 0; i < rendered.size(); ++i) {
        const double byte = std::floor(255 * static_cast<double>(rendered[i]) + 0.5);
        sum += std::fabs(byte - 255 * static_cast<double>(target_[i]));
    }
    return sum / static_cast<double>(rendered.size());
}

std::optional<Fit> ParameterFit::fit(const FitProblem& problem, FitStart start) const {
    if (problem.units.size() > k_max_values) return std::nullopt;
    std::vector<double> values = problem.start;
    auto at_start_values = rendered_with(problem, values);
    if (!at_start_values) return std::nullopt;
    std::vector<float> rendered = std::move(*at_start_values);
    Fit best{values, left_of(rendered)};
    double damping = k_first_damping;
    const double at_start = best.left;
    const std::vector<Stage> stages = stages_of(grid_.columns(), start);
    for (const auto& [radius, by] : stages) {
        if (by < 1 && best.left > k_fine * at_start) break;
        const double most =
            (start == FitStart::near ? k_near_step : 4 * std::max(radius, 1)) * std::min(by, 1.0);
        double at_first = 0, last = 0;  // squared, blurred
        const int iterations = start == FitStart::near && by >= 1 ? k_near_iterations : k_iterations;
        for (int iteration = 0; iteration < iterations && best.left > k_enough; ++iteration) {
            const auto step = step_from(problem, values, rendered, radius, by);
            if (!step) return std::nullopt;
            if (iteration == 0) at_first = step->error;
            last = step->error;
            double gain = 0;
            for (int i = 0; i < k_dampings && gain <= 0; ++i) {
                std::vector<double> change = step->change(damping), next = values;
                for (std::size_t k = 0; k < next.size(); ++k)
                    next[k] += std::clamp(change[k], -most, most) * problem.units[k];
                auto made = rendered_with(problem, next);
                if (!made) return std::nullopt;
                const std::vector<float> error = blurred_difference(target_, *made, radius);
                gain = 1 - product(error, error) / step->error;
                damping = gain > 0 ? damping / k_damping_factor : damping * k_damping_factor;
                if (gain <= 0) continue;
                last = (1 - gain) * step->error;
                values = std::move(next);
                rendered = std::move(*made);
                const double left = left_of(rendered);
                if (left < best.left) best = {values, left};
            }
            if (gain < k_min_gain) break;
        }
        damping = std::clamp(damping, 1e-6, k_first_damping);
        const bool is_first = start == FitStart::far && radius == stages.front().radius;
        if (is_first && last > k_hopeless_fit * at_first) break;
    }
    best = rounded(problem, best);
    if (best.left > 0 && best.left <= k_worth_polishing * at_start) polish(problem, best);
    return best;
}

// Until the bytes are roundings of what is rendered, but for edges: they tell numbers to a small part of
// 1/255. First by what is left, and then only by what is left beyond rounding.
void ParameterFit::polish(const FitProblem& problem, Fit& fit) const {
    std::optional<std::vector<float>> rendered = rendered_with(problem, fit.values);
    if (!rendered) return;
    const auto excess = [&](const std::vector<float>& made) {
        double sum = 0;
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double rest = std::fabs(static_cast<double>(target_[i] - made[i])) - k_half_byte;
            sum += rest > 0 ? std::min(rest, k_rest) : 0;
        }
        return sum;
    };
    double least = excess(*rendered);
    bool beyond_rounding = false;
    for (int i = 0; i < k_polishings; ++i) {
        std::vector<float> error = blurred_difference(target_, *rendered, 0);
        if (beyond_rounding) {
            for (float& e : error) {
                const double rest = std::fabs(static_cast<double>(e)) - k_half_byte;
                e = rest > 0 ? static_cast<float>(e < 0 ? -rest : rest) : 0;
            }
        }
        std::vector<std::vector<float>> slopes;
        for (std::size_t k = 0; k < fit.values.size(); ++k) {
            std::vector<double> beside = fit.values;
            beside[k] += k_polish_unit * problem.units[k];
            const auto made = rendered_with(problem, beside);
            if (!made) return;
            slopes.push_back(blurred_difference(*made, *rendered, 0));
        }
        for (std::size_t p = 0; p < error.size(); ++p) {
            const auto is_far = [](float v) { return std::fabs(static_cast<double>(v)) > k_rest; };
            const bool is_edge = is_far(error[p]) || (beyond_rounding && !(std::fabs(error[p]) > 0)) ||
                                 std::any_of(slopes.begin(), slopes.end(),
                                             [&](const std::vector<float>& s) { return is_far(s[p]); });
            for (std::vector<float>& slope : slopes)
                slope[p] = is_edge ? 0 : slope[p] / static_cast<float>(k_polish_unit);
        }
        const std::vector<double> change = step_of(slopes, error).change(k_polish_damping);
        bool is_nearer = false;
        for (double by = 1; by > 0.2 && !is_nearer; by /= 2) {
            std::vector<double> next = fit.values;
            for (std::size_t k = 0; k < next.size(); ++k)
                next[k] += by * std::clamp(change[k], -1.0, 1.0) * problem.units[k];
            std::optional<std::vector<float>> made = rendered_with(problem, next);
            if (!made) return;
            const double left = excess(*made);
            is_nearer = left < least;
            if (!is_nearer) continue;
            least = left;
            rendered = std::move(made);
            fit = {std::move(next), left_of(*rendered)};
        }
        if (!is_nearer && beyond_rounding) return;
        beyond_rounding = beyond_rounding || !is_nearer;
    }
}

// Numbers with as few digits as render nearly the same.
Fit ParameterFit::rounded(const FitProblem& problem, Fit found) const {
    for (const double unit : {0.1, 0.05, 0.01}) {
        Fit near = found;
        for (double& v : near.values) v = std::floor(v / unit + 0.5) * unit;
        if (const auto made = rendered_with(problem, near.values)) {
            near.left = left_of(*made);
            if (near.left <= found.left * (1 + k_rounding_costs)) return near;
        }
    }
    return found;
}

}  // namespace glint
