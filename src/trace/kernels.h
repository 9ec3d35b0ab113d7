// SPDX-License-Identifier: Apache-2.0
#pragma once
// The functions that are compiled for every instruction set and selected once per render.
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bvh/rays.h"
#include "geometry/traits.h"
#include "glint/render.h"
#include "trace/hits/hit_columns.h"
#include "trace/surface_record.h"
#include "trace/tile.h"
#include "world/world.h"

namespace glint {

struct Kernels {
    const char* isa;

    /// For rays [0, count): the smallest t in (t_min, t_max) and the surface hit there. Of equal t, the shape
    /// that is first in the scene, and of one shape the first element. Packets have up to `packet` rays (1 to
    /// k_packet_size); the result does not depend on it.
    void (*nearest_hit)(const WorldParts&, const RaySpan& rays, int count, int packet, HitColumns hits);

    /// occluded[i] = 1 if anything is hit in (t_min, t_max), else 0.
    void (*any_hit)(const WorldParts&, const RaySpan& rays, int count, int packet, std::uint8_t* occluded);

    /// Renders one tile.
    void (*render_tile)(const WorldParts&, const TileJob&, TileScratch&);

    /// The camera rays of pixels, in their order.
    void (*make_pixel_rays)(const WorldParts&, const PixelList&, RayBatch&);

    /// Where a line is inside of the operand of a slot: replaces the list by the t of entries and exits, in
    /// their order. One that is not there may be empty: its entry is not below its exit.
    void (*operand_intervals)(const PackedGeometry&, std::uint32_t slot, Vec3 origin, Vec3 direction,
                              std::vector<double>& to);

    /// Traces the rays of the scratch's pixels without lighting them, and adds the surfaces to the record.
    void (*follow_pixels)(const WorldParts&, TileScratch&, SurfaceRecord&);
};

/// The kernels that this machine supports, best first.
const std::vector<Kernels>& available_kernels();
/// The kernels of an instruction set (empty: the best), or null.
const Kernels* find_kernels(std::string_view isa);
/// The error message if there are none.
std::string no_kernels_error(std::string_view isa);

}  // namespace glint
