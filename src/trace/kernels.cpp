// SPDX-License-Identifier: Apache-2.0
// The kernels, compiled once for every instruction set: foreach_target includes this file again for each.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/kernels.cpp"
#include <hwy/foreach_target.h>  // must be the first include

#include "simd/targets.h"
#include "trace/follow_pixels-inl.h"
#include "trace/kernels.h"
#include "trace/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

Kernels kernels(const char* isa) {
    return {isa, &nearest_hit, &any_hit, &render_tile, &make_pixel_rays, &operand_intervals, &follow_pixels};
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {

const std::vector<Kernels>& available_kernels() {
    static const std::vector<Kernels> list = [] {
        std::vector<Kernels> found;
        [[maybe_unused]] const auto supported = supported_targets();
#if HWY_TARGETS & HWY_AVX3
        if (supported & HWY_AVX3) found.push_back(N_AVX3::kernels("avx512"));
#endif
#if HWY_TARGETS & HWY_AVX2
        if (supported & HWY_AVX2) found.push_back(N_AVX2::kernels("avx2"));
#endif
#if HWY_TARGETS & HWY_SSE4
        if (supported & HWY_SSE4) found.push_back(N_SSE4::kernels("sse4"));
#endif
#if HWY_TARGETS & HWY_NEON
        if (supported & HWY_NEON) found.push_back(N_NEON::kernels("neon"));
#endif
#if HWY_TARGETS & HWY_WASM
        found.push_back(N_WASM::kernels("simd128"));
#endif
#if HWY_TARGETS & HWY_SCALAR
        found.push_back(N_SCALAR::kernels("scalar"));
#endif
        return found;
    }();
    return list;
}

const Kernels* find_kernels(std::string_view isa) {
#if HWY_TARGETS & HWY_WASM
    if (isa == "scalar") isa = "simd128";  // the name of the only kernels there before they had vectors
#endif
    for (const Kernels& k : available_kernels()) {
        if (isa.empty() || isa == k.isa) return &k;
    }
    return nullptr;
}

std::string no_kernels_error(std::string_view isa) {
    std::string list;
    for (const Kernels& k : available_kernels()) list += (list.empty() ? "" : ", ") + std::string(k.isa);
    return "this machine has no instruction set '" + std::string(isa) + "'; it has " + list;
}

}  // namespace glint
#endif
