// SPDX-License-Identifier: Apache-2.0
// Bytes per second of load(), for texts with different contents. Run: bench_load [--benchmark_filter=nff].
// The texts have 100 MB; GLINT_BENCH_MB sets another size.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <iterator>
#include <random>
#include <string>

#include "glint/load.h"

namespace {

constexpr std::string_view k_head =
    "b 0.078 0.361 0.753\nv\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.01\nresolution 512 "
    "512\n"
    "l 4 3 2\nf 1 0.9 0.7 0.5 0.5 3.0827 0 1\n";

// Six digits, as in the databases' own programs.
class Values {
  public:
    double next() { return distribution_(random_); }
    void put_point(std::string& text) {
        fmt::format_to(std::back_inserter(text), " {:.6g} {:.6g} {:.6g}", next(), next(), next());
    }

  private:
    std::mt19937 random_{1};
    std::uniform_real_distribution<double> distribution_{-1, 1};
};

void put_sphere(std::string& text, Values& values) {
    text += 's';
    values.put_point(text);
    fmt::format_to(std::back_inserter(text), " {:.6g}\n", 0.01 + 0.001 * values.next());
}

// A polygon of `count` vertices, one per line; a patch also has a normal for each vertex.
template <int Count, bool Patch> void put_polygon(std::string& text, Values& values) {
    text += fmt::format("{} {}\n", Patch ? "pp" : "p", Count);
    for (int i = 0; i < Count; ++i) {
        values.put_point(text);
        if (Patch) values.put_point(text);
        text += '\n';
    }
}

void put_cone(std::string& text, Values& values) {
    text += "c\n";
    for (int end = 0; end < 2; ++end) {
        values.put_point(text);
        fmt::format_to(std::back_inserter(text), " {:.6g}\n", 0.01 + 0.001 * values.next());
    }
}

// Vertices on a grid, as in the databases' tetrahedra: short numbers, and more of them.
void put_short_numbers(std::string& text, Values& values) {
    text += "p 3\n";
    for (int i = 0; i < 3; ++i) {
        const auto next = [&] { return static_cast<int>(8 * values.next()) / 8.0; };
        fmt::format_to(std::back_inserter(text), "{:g} {:g} {:g}\n", next(), next(), next());
    }
}

// A fill before every sphere: one material per shape.
void put_fill_and_sphere(std::string& text, Values& values) {
    text += 'f';
    values.put_point(text);
    text += " 0.5 0.5 3.0827 0 1\n";
    put_sphere(text, values);
}

void load_nff(benchmark::State& state, void (*put)(std::string&, Values&)) {
    const char* wanted = std::getenv("GLINT_BENCH_MB");
    const std::size_t bytes = (wanted ? std::strtoul(wanted, nullptr, 10) : 100) * 1000000;
    std::string text(k_head);
    text.reserve(bytes + 10000);
    for (Values values; text.size() < bytes;) put(text, values);
    const glint::SceneText texts[] = {{"a.nff", text, {}}};
    std::size_t shapes = 0;
    for (auto _ : state) {
        const glint::Result<glint::Scene> result = glint::load(texts);
        if (!result) {
            state.SkipWithError("no scene");
            break;
        }
        shapes = result->shapes.size();
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(text.size() * state.iterations()));
    state.counters["shapes"] = static_cast<double>(shapes);
}

BENCHMARK_CAPTURE(load_nff, spheres, put_sphere)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_nff, triangles, put_polygon<3, false>)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_nff, quadrangles, put_polygon<4, false>)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_nff, patches, put_polygon<3, true>)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_nff, cones, put_cone)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_nff, short_numbers, put_short_numbers)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_nff, fills_and_spheres, put_fill_and_sphere)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
