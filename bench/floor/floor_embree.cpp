// floor_embree SCENE.nff [SIZE [THREADS]]: how long Embree takes to answer the rays of a frame, as packets of
// 16 and without any shading. Prints JSON: rays and seconds (the least of three replays), all in all and by
// class. The rays are recorded first, which does not count.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "frame_rays.h"
#include "glint/load.h"

namespace {

using namespace glint_floor;

constexpr std::size_t k_packet = 16, k_chunk = 64 * k_packet;  // a thread takes a chunk at a time

template <class Packet>
void fill(const RayList& rays, std::size_t first, Packet& packet, int (&valid)[k_packet]) {
    for (std::size_t i = 0; i < k_packet; ++i) {
        valid[i] = first + i < rays.size() ? -1 : 0;
        const std::size_t j = valid[i] ? first + i : first;
        packet.org_x[i] = rays.ox[j];
        packet.org_y[i] = rays.oy[j];
        packet.org_z[i] = rays.oz[j];
        packet.dir_x[i] = rays.dx[j];
        packet.dir_y[i] = rays.dy[j];
        packet.dir_z[i] = rays.dz[j];
        packet.tfar[i] = rays.t_max[j];
        packet.tnear[i] = 0;
        packet.time[i] = 0;
        packet.mask[i] = ~0u;
        packet.flags[i] = 0;
    }
}

void replay_chunk(RTCScene scene, const RayList& rays, std::size_t first, bool shadow, bool coherent) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    alignas(64) int valid[k_packet];
    const std::size_t end = std::min(first + k_chunk, rays.size());
    for (std::size_t i = first; i < end; i += k_packet) {
        if (shadow) {
            RTCRay16 packet;
            fill(rays, i, packet, valid);
            rtcOccluded16(valid, scene, &context, &packet);
        } else {
            RTCRayHit16 packet;
            fill(rays, i, packet.ray, valid);
            for (unsigned& id : packet.hit.geomID) id = RTC_INVALID_GEOMETRY_ID;
            for (unsigned& id : packet.hit.instID[0]) id = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect16(valid, scene, &context, &packet);
        }
    }
}

double replay(RTCScene scene, const RayList& rays, RayClass ray_class, int threads) {
    const bool shadow = ray_class == k_first_shadow || ray_class == k_later_shadow;
    const bool coherent = ray_class == k_camera || ray_class == k_first_shadow;
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t first; (first = next.fetch_add(k_chunk)) < rays.size();)
            replay_chunk(scene, rays, first, shadow, coherent);
    };
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& thread : others) thread.join();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int count, char** arguments) {
    const int size = count > 2 ? std::atoi(arguments[2]) : 1024;
    const int threads =
        count > 3 ? std::atoi(arguments[3]) : static_cast<int>(std::thread::hardware_concurrency());
    if (count < 2 || count > 4 || size < 1 || size > 16384 || threads < 1 || threads > 1024) {
        std::fputs("usage: floor_embree SCENE.nff [SIZE [THREADS]]\n", stderr);
        return 2;
    }
    std::ifstream file(arguments[1], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const glint::SceneText source{arguments[1], text, "nff"};
    const glint::LoadResult loaded = glint::load({&source, 1});
    if (!file || !loaded.scene) {
        std::fprintf(stderr, "floor_embree: cannot read %s\n", arguments[1]);
        return 1;
    }
    const EmbreeScene embree(*loaded.scene, threads);
    const FrameRays frame = frame_rays(*loaded.scene, embree, size, 5);

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
