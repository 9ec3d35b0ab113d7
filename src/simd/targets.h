// SPDX-License-Identifier: Apache-2.0
#pragma once
// The instruction sets of this machine.
#include <hwy/detect_targets.h>

#include <cstdint>
#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#endif

namespace glint {

/// The instruction sets that the processor and the system support, as Highway's target bits. Does not call
/// hwy::SupportedTargets(), because that library measures the clock for 4 ms when the program starts.
inline std::int64_t supported_targets() {
#if defined(__x86_64__) || defined(__i386__)
    // The compiler's functions also check that the system saves the wide registers.
    std::int64_t targets = HWY_SCALAR;
    if (__builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
        __builtin_cpu_supports("aes")) {
        targets |= HWY_SSE4;
    }
    unsigned a = 0, b = 0, c = 0, d = 0;
    const bool f16c = __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_F16C) != 0;
    const bool lzcnt = __get_cpuid(0x80000001u, &a, &b, &c, &d) != 0 && (c & bit_LZCNT) != 0;
    if ((targets & HWY_SSE4) != 0 && f16c && lzcnt && __builtin_cpu_supports("avx2") &&
        __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2")) {
        targets |= HWY_AVX2;
    }
    if ((targets & HWY_AVX2) != 0 && __builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd")) {
        targets |= HWY_AVX3;
    }
    return targets;
#else
    return HWY_TARGETS;  // fixed at compile time
#endif
}

}  // namespace glint
