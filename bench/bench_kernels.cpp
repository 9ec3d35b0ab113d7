// SPDX-License-Identifier: Apache-2.0
// Nanoseconds per ray for a sphere, a triangle and a box, and per point for the terms of a light, by
// instruction set; seconds to build a hierarchy. Run: bench_kernels [--benchmark_filter=sphere].
// bench_math measures pow, bench_rays the traversal.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "bvh/bvh.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench_kernels.cpp"
#include <hwy/foreach_target.h>

#include "geometry/box-inl.h"
#include "geometry/sphere-inl.h"
#include "geometry/triangle-inl.h"
#include "lighting/phong-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

// One ray and many shapes, as in a leaf: column k of the parameters starts at columns[k stride].
template <class Geometry>
double nearest_of_shapes(const double* columns, std::size_t stride, std::size_t count) {
    const Ray<Doubles> ray{{Doubles(0.1), Doubles(0.2), Doubles(-5.0)},
                           {Doubles(0.02), Doubles(-0.03), Doubles(1.0)}};
    Doubles nearest(1e30);
    for (std::size_t i = 0; i < count; i += lane_count<double>()) {
        Doubles p[Geometry::k_values];
        for (int k = 0; k < Geometry::k_values; ++k) p[k] = load(columns + k * stride + i);
        const auto hit = Geometry::hit(p, ray, Doubles(0));
        nearest = select(hit.valid, min(nearest, hit.t), nearest);
    }
    alignas(64) double lanes[lane_count<double>()];
    store(nearest, lanes);
    return lanes[0];
}

double nearest_sphere(const double* columns, std::size_t stride, std::size_t count) {
    return nearest_of_shapes<SphereGeometry>(columns, stride, count);
}
double nearest_triangle(const double* columns, std::size_t stride, std::size_t count) {
    return nearest_of_shapes<TriangleGeometry>(columns, stride, count);
}
double nearest_box(const double* columns, std::size_t stride, std::size_t count) {
    return nearest_of_shapes<BoxGeometry>(columns, stride, count);
}

// One light at many points: columns 0 to 8 are unit normals and directions, column 9 is the exponent.
double shade(const double* columns, std::size_t stride, std::size_t count) {
    const LightingRules rules{.shading = Shading::phong};
    Doubles sum(0);
    for (std::size_t i = 0; i < count; i += lane_count<double>()) {
        const auto triple_at = [&](std::size_t k) HWY_ATTR {
            return Vector3<Doubles>{load(columns + k * stride + i), load(columns + (k + 1) * stride + i),
                                    load(columns + (k + 2) * stride + i)};
        };
        const auto c = cosines(triple_at(0), triple_at(3), triple_at(6), rules);
        const Doubles power = highlight_power(c.s, load(columns + 9 * stride + i), rules);
        sum += diffuse_term(c.n_l, rules) + select(has_highlight(c, rules), power, Doubles(0));
    }
    alignas(64) double lanes[lane_count<double>()];
    store(sum, lanes);
    return lanes[0];
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace {

using glint::Vec3;
using Kernel = double (*)(const double* columns, std::size_t stride, std::size_t count);

constexpr std::size_t k_count = 1024;

class Values {
  public:
    double next() { return distribution_(random_); }
    Vec3 point() { return {next(), next(), next()}; }
    Vec3 unit() {
        for (;;) {
            const Vec3 v = point();
            const double square = dot(v, v);
            if (square > 0.01 && square < 1) return v / std::sqrt(square);
        }
    }

  private:
    std::mt19937 random_{1};
    std::uniform_real_distribution<double> distribution_{-1, 1};
};

template <class Geometry, class Make> std::vector<double> pack(Make make) {
    Values values;
    std::vector<double> columns(Geometry::k_values * k_count);
    for (std::size_t i = 0; i < k_count; ++i) {
        double p[Geometry::k_values];
        Geometry::pack(make(values), p);
        for (std::size_t k = 0; k < Geometry::k_values; ++k) columns[k * k_count + i] = p[k];
    }
    return columns;
}

std::vector<double> points_to_shade() {
    Values values;
    std::vector<double> columns(10 * k_count);
    for (std::size_t i = 0; i < k_count; ++i) {
        for (std::size_t v = 0; v < 9; v += 3) {
            const Vec3 u = values.unit();
            columns[v * k_count + i] = u.x;
            columns[(v + 1) * k_count + i] = u.y;
            columns[(v + 2) * k_count + i] = u.z;
        }
        columns[9 * k_count + i] = 1 + static_cast<double>(i % 100);
    }
    return columns;
}

void add(const std::string& name, Kernel kernel, std::vector<double> columns) {
    benchmark::RegisterBenchmark(name.c_str(), [kernel, columns](benchmark::State& state) {
        for (auto step : state) benchmark::DoNotOptimize(kernel(columns.data(), k_count, k_count));
        state.counters["each"] = benchmark::Counter(
            k_count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    });
}

void add_target(const std::string& name, std::int64_t target, Kernel sphere, Kernel triangle, Kernel box,
                Kernel shade) {
    if (!(hwy::SupportedTargets() & target)) return;
    using namespace glint;
    add("sphere/" + name, sphere, pack<N_SCALAR::SphereGeometry>([](Values& v) {
            return Sphere{v.point(), 0.1};
        }));
    add("triangle/" + name, triangle, pack<N_SCALAR::TriangleGeometry>([](Values& v) {
            return Triangle{{v.point(), v.point(), v.point()}};
        }));
    add("box/" + name, box, pack<N_SCALAR::BoxGeometry>([](Values& v) {
            const Vec3 p = v.point();
            return Box{p, p + Vec3{0.2, 0.2, 0.2}};
        }));
    add("shade/" + name, shade, points_to_shade());
}

void build(benchmark::State& state) {
    Values values;
    std::vector<glint::BvhItem> boxes(static_cast<std::size_t>(state.range(0)));
    for (glint::BvhItem& box : boxes) {
        const Vec3 p = values.point();
        const glint::Aabb padded = glint::padded_box(p, p + Vec3{0.01, 0.01, 0.01});
        for (int a = 0; a < 3; ++a) box.lo[a] = padded.lo[a], box.hi[a] = padded.hi[a];
        box.item = box.item_class = 0;
    }
    const std::array<glint::LeafCost, 1> costs{};
    for (auto step : state) {
        state.PauseTiming();
        std::vector<glint::BvhItem> items = boxes;
        state.ResumeTiming();
        const glint::Bvh bvh = glint::build_bvh(items, costs, static_cast<int>(state.range(1)));
        benchmark::DoNotOptimize(bvh.nodes.data());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

}  // namespace

int main(int argc, char** argv) {
#define GLINT_TARGET(name, target, space)                                                  \
    add_target(name, target, glint::space::nearest_sphere, glint::space::nearest_triangle, \
               glint::space::nearest_box, glint::space::shade)
    GLINT_TARGET("scalar", HWY_SCALAR, N_SCALAR);
#if (HWY_TARGETS) & HWY_SSE4
    GLINT_TARGET("sse4", HWY_SSE4, N_SSE4);
    GLINT_TARGET("avx2", HWY_AVX2, N_AVX2);
    GLINT_TARGET("avx512", HWY_AVX3, N_AVX3);
#endif
#undef GLINT_TARGET
    benchmark::RegisterBenchmark("build", build)
        ->ArgNames({"boxes", "threads"})
        ->ArgsProduct({{10'000, 1'000'000}, {1, 2}})
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
}
#endif
