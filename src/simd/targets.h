// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which instruction sets this machine has.
#include <hwy/detect_targets.h>

#include <cstdint>
#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#endif

namespace glint {

/// The instruction sets that this machine's processor and system support, as Highway's target bits. Not
/// hwy::SupportedTargets(): that library measures the clock for 4 ms when a program that needs it starts.
inline std::int64_t supported_targets() {
#if defined(__x86_64__) || defined(__i386__)
    // The compiler's functions ask whether the system saves the wide registers, too.
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
    return HWY_TARGETS;  // fixed when compiled
#endif
}

}  // namespace glint
