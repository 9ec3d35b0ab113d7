// SPDX-License-Identifier: Apache-2.0
// Nanoseconds per ray on one thread, by class, for glint's kernels and for Embree's packets of 16.
// Run: bench_rays [--benchmark_filter=mirror] SCENE...
// `hits` is the fraction of rays that hit anything: it must be about the same for both.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "bvh/rays.h"
#include "frame_rays.h"
#include "read_scene.h"
#include "replay.h"
#include "trace/kernels.h"

namespace {

using namespace glint_floor;

constexpr int k_size = 512;

// A scene and the rays of its frame, also as columns of doubles.
struct Frame {
    std::string name;
    glint::Result<glint::World> world;
    std::unique_ptr<EmbreeScene> embree;
    FrameRays rays;
    std::vector<double> columns[k_ray_classes][8];

    glint::RaySpan span(int ray_class, std::size_t first) const {
        const auto& c = columns[ray_class];
        return {c[0].data() + first, c[1].data() + first, c[2].data() + first, c[3].data() + first,
                c[4].data() + first, c[5].data() + first, c[6].data() + first, c[7].data() + first};
    }
};

void widen(const RayList& rays, std::vector<double> (&columns)[8]) {
    const std::vector<float>* narrow[] = {&rays.ox, &rays.oy, &rays.oz, &rays.dx,
                                          &rays.dy, &rays.dz, nullptr,  &rays.t_max};
    for (int k = 0; k < 8; ++k) {
        if (narrow[k]) columns[k].assign(narrow[k]->begin(), narrow[k]->end());
        columns[k].resize(rays.size() + glint::k_ray_padding);
    }
}

std::shared_ptr<const Frame> read(const std::string& path) {
    const glint::Result<glint::Scene> loaded = read_scene(path);
    if (!loaded) return nullptr;
    auto frame = std::make_shared<Frame>();
    frame->name = path.substr(path.find_last_of('/') + 1);
    frame->world = glint::prepare(*loaded);
    frame->embree = std::make_unique<EmbreeScene>(*loaded, 1);
    frame->rays = frame_rays(*loaded, *frame->embree, k_size, 5);
    for (int c = 0; c < k_ray_classes; ++c) widen(frame->rays.lists[c], frame->columns[c]);
    return frame->world ? frame : nullptr;
}

// In streams of 1024 rays, as in a tile. Returns the number of hits.
std::size_t trace(const Frame& frame, int c, const glint::Kernels& kernels) {
    constexpr std::size_t k_run = 1024;
    double t[k_run + glint::k_ray_padding];
    std::uint32_t slot[k_run + glint::k_ray_padding], element[k_run + glint::k_ray_padding];
    std::uint8_t occluded[k_run + glint::k_ray_padding];
    const std::size_t total = frame.rays.lists[c].size();
    std::size_t hits = 0;
    for (std::size_t first = 0; first < total; first += k_run) {
        const int count = static_cast<int>(std::min(k_run, total - first));
        if (is_shadow(c)) {
            kernels.any_hit(frame.world->parts(), frame.span(c, first), count, glint::k_packet_size,
                            occluded);
            hits += std::count(occluded, occluded + count, 1);
        } else {
            kernels.nearest_hit(frame.world->parts(), frame.span(c, first), count, glint::k_packet_size,
                                {t, slot, element});
            hits += count - std::count(slot, slot + count, glint::k_none);
        }
    }
    return hits;
}

void add(const std::shared_ptr<const Frame>& frame) {
    for (int c = 0; c < k_ray_classes; ++c) {
        const double rays = static_cast<double>(frame->rays.lists[c].size());
        if (rays == 0) continue;
        const auto add_one = [&](const std::string& who, auto run, auto count) {
            const std::string name = frame->name + "/" + k_class_names[c] + "/" + who;
            benchmark::RegisterBenchmark(name.c_str(), [rays, run, count](benchmark::State& state) {
                for (auto step : state) benchmark::DoNotOptimize(run());
                state.counters["each"] = benchmark::Counter(
                    rays, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
                state.counters["hits"] = static_cast<double>(count()) / rays;
            })->Unit(benchmark::kMillisecond);
        };
        for (const glint::Kernels& kernels : glint::available_kernels()) {
            const auto run = [frame, c, &kernels] { return trace(*frame, c, kernels); };
            add_one(kernels.isa, run, run);
        }
        const auto ray_class = static_cast<RayClass>(c);
        add_one(
            "embree",
            [frame, ray_class] {
                return replay(frame->embree->get(), frame->rays.lists[ray_class], ray_class, 1);
            },
            [frame, ray_class] {
                return count_hits(frame->embree->get(), frame->rays.lists[ray_class], ray_class);
            });
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (argc < 2) {
        std::fputs("usage: bench_rays [--benchmark_...] SCENE...\n", stderr);
        return 2;
    }
    for (int i = 1; i < argc; ++i) {
        const auto frame = read(argv[i]);
        if (!frame) {
            std::fprintf(stderr, "bench_rays: cannot read %s\n", argv[i]);
            return 1;
        }
        add(frame);
    }
    benchmark::RunSpecifiedBenchmarks();
}
