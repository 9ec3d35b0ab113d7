// SPDX-License-Identifier: Apache-2.0
// floor_embree SCENE [SIZE [THREADS]]: the time that Embree needs to trace the rays of a frame in packets
// of 16, without shading. Prints JSON: rays and seconds (the minimum of three replays), in total and by
// class. Recording the rays is not counted.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "frame_rays.h"
#include "read_scene.h"
#include "replay.h"

using namespace glint_floor;

int main(int count, char** arguments) {
    const int size = count > 2 ? std::atoi(arguments[2]) : 1024;
    const int threads =
        count > 3 ? std::atoi(arguments[3]) : static_cast<int>(std::thread::hardware_concurrency());
    if (count < 2 || count > 4 || size < 1 || size > 16384 || threads < 1 || threads > 1024) {
        std::fputs("usage: floor_embree SCENE [SIZE [THREADS]]\n", stderr);
        return 2;
    }
    const glint::Result<glint::Scene> loaded = read_scene(arguments[1]);
    if (!loaded) return fail("floor_embree", loaded);
    const EmbreeScene embree(*loaded, threads);
    const FrameRays frame = frame_rays(*loaded, embree, size, 5);

    double seconds = 0;
    std::size_t rays = 0;
    std::printf("{\"classes\": {");
    for (int c = 0; c < k_ray_classes; ++c) {
        const RayList& list = frame.lists[c];
        double took = list.size() > 0 ? INFINITY : 0;
        for (int i = 0; i < 3 && list.size() > 0; ++i)
            took = std::min(took, replay(embree.get(), list, static_cast<RayClass>(c), threads));
        seconds += took;
        rays += list.size();
        std::printf("%s\"%s\": {\"rays\": %zu, \"seconds\": %.9f}", c > 0 ? ", " : "", k_class_names[c],
                    list.size(), took);
    }
    std::printf("}, \"rays\": %zu, \"seconds\": %.9f, \"threads\": %d}\n", rays, seconds, threads);
    return 0;
}
