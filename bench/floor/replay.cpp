#include "replay.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace glint_floor {

namespace {

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

}  // namespace

double replay(RTCScene scene, const RayList& rays, RayClass ray_class, int threads) {
    const bool shadow = is_shadow(ray_class);
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

}  // namespace glint_floor
