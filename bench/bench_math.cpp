// SPDX-License-Identifier: Apache-2.0
// Nanoseconds per pow, by instruction set, compared with the C library's. Run: bench_math
// [--benchmark_filter=pow].
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "math/elementary.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench_math.cpp"
#include <hwy/foreach_target.h>

#include "simd/elementary-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

void pow_of_lanes(const double* x, const double* y, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; i += lane_count<double>())
        store(pow(load(x + i), load(y + i)), out + i);
}

void exp_of_lanes(const double* x, const double*, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; i += lane_count<double>()) store(exp(load(x + i)), out + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace {

using Function = void (*)(const double*, const double*, double*, std::size_t);

constexpr std::size_t k_count = 1024;

// Typical cosines and exponents: S in (0, 1), n from 1 to 1000.
void run(benchmark::State& state, Function function) {
    std::vector<double> x(k_count), y(k_count), out(k_count);
    for (std::size_t i = 0; i < k_count; ++i) {
        x[i] = (static_cast<double>(i * 619 % k_count) + 0.5) / k_count;
        y[i] = 1 + static_cast<double>(i * 367 % 1000);
    }
    for (auto step : state) {
        function(x.data(), y.data(), out.data(), k_count);
        benchmark::DoNotOptimize(out.data());
        benchmark::ClobberMemory();
    }
    state.counters["each"] = benchmark::Counter(
        k_count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void pow_of_library(const double* x, const double* y, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out[i] = std::pow(x[i], y[i]);
}
void pow_of_glint(const double* x, const double* y, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out[i] = glint::pow(x[i], y[i]);
}

void add(const std::string& name, Function function) {
    benchmark::RegisterBenchmark(name.c_str(), [function](benchmark::State& state) { run(state, function); });
}

void add_target(const char* name, std::int64_t target, Function pow, Function exp) {
    if (!(hwy::SupportedTargets() & target)) return;
    add(std::string("pow/") + name, pow);
    add(std::string("exp/") + name, exp);
}

}  // namespace

int main(int argc, char** argv) {
    add("pow/std", pow_of_library);
    add("pow/plain", pow_of_glint);
    add_target("scalar", HWY_SCALAR, glint::N_SCALAR::pow_of_lanes, glint::N_SCALAR::exp_of_lanes);
#if (HWY_TARGETS) & HWY_SSE4
    add_target("sse4", HWY_SSE4, glint::N_SSE4::pow_of_lanes, glint::N_SSE4::exp_of_lanes);
    add_target("avx2", HWY_AVX2, glint::N_AVX2::pow_of_lanes, glint::N_AVX2::exp_of_lanes);
    add_target("avx512", HWY_AVX3, glint::N_AVX3::pow_of_lanes, glint::N_AVX3::exp_of_lanes);
#endif
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
#endif
