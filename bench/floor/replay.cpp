// SPDX-License-Identifier: Apache-2.0
#include "replay.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace glint_floor {

namespace {

constexpr std::size_t k_packet = 16, k_chunk = 64 * k_packet;  // each thread takes one chunk at a time

template <class Packet>
void fill(const RayList& rays, std::size_t first, std::size_t count, Packet& packet, int (&valid)[k_packet]) {
    const std::pair<const std::vector<float>*, float*> columns[] = {
        {&rays.ox, packet.org_x},   {&rays.oy, packet.org_y}, {&rays.oz, packet.org_z},
        {&rays.dx, packet.dir_x},   {&rays.dy, packet.dir_y}, {&rays.dz, packet.dir_z},
        {&rays.t_max, packet.tfar},
    };
    for (const auto& [from, to] : columns) std::copy_n(from->data() + first, count, to);
    for (std::size_t i = 0; i < k_packet; ++i) {
        valid[i] = i < count ? -1 : 0;
        packet.tnear[i] = 0;
        packet.time[i] = 0;
        packet.mask[i] = ~0u;
        packet.flags[i] = 0;
    }
}

// Returns the number of hits if `counted`.
template <bool counted>
std::size_t replay_chunk(RTCScene scene, const RayList& rays, std::size_t first, RayClass ray_class) {
    const bool coherent = ray_class == k_camera || ray_class == k_first_shadow;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    alignas(64) int valid[k_packet];
    std::size_t hits = 0;
    const std::size_t end = std::min(first + k_chunk, rays.size());
    for (std::size_t i = first; i < end; i += k_packet) {
        const std::size_t count = std::min(k_packet, end - i);
        if (is_shadow(ray_class)) {
            RTCRay16 packet;
            fill(rays, i, count, packet, valid);
            rtcOccluded16(valid, scene, &context, &packet);
            if constexpr (counted)
                hits += std::count_if(packet.tfar, packet.tfar + count, [](float t) { return t < 0; });
        } else {
            RTCRayHit16 packet;
            fill(rays, i, count, packet.ray, valid);
            std::fill_n(packet.hit.geomID, k_packet, RTC_INVALID_GEOMETRY_ID);
            std::fill_n(packet.hit.instID[0], k_packet, RTC_INVALID_GEOMETRY_ID);
            rtcIntersect16(valid, scene, &context, &packet);
            if constexpr (counted)
                hits += std::count_if(packet.hit.geomID, packet.hit.geomID + count,
                                      [](unsigned id) { return id != RTC_INVALID_GEOMETRY_ID; });
        }
    }
    return hits;
}

}  // namespace

double replay(RTCScene scene, const RayList& rays, RayClass ray_class, int threads) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t first; (first = next.fetch_add(k_chunk)) < rays.size();)
            replay_chunk<false>(scene, rays, first, ray_class);
    };
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& thread : others) thread.join();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t count_hits(RTCScene scene, const RayList& rays, RayClass ray_class) {
    std::size_t hits = 0;
    for (std::size_t first = 0; first < rays.size(); first += k_chunk)
        hits += replay_chunk<true>(scene, rays, first, ray_class);
    return hits;
}

}  // namespace glint_floor
