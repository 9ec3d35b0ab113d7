// SPDX-License-Identifier: Apache-2.0
#pragma once
// The floating-point state that gives the same bits on every machine.
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace glint {

/// Sets round-to-nearest without flush-to-zero for its lifetime, then restores the caller's state. (Some
/// hosts set FTZ: other renderers recommend it.) It does nothing where no such state exists, as in
/// WebAssembly.
class DefaultFpEnvironment {
  public:
#if defined(__SSE2__)
    DefaultFpEnvironment() : saved_(_mm_getcsr()) {
        _mm_setcsr(0x1f80);
    }  // all exceptions masked, nearest, no FTZ, no DAZ
    ~DefaultFpEnvironment() { _mm_setcsr(saved_); }

  private:
    unsigned saved_;
#elif defined(__aarch64__)
    // Only GCC has functions for this register; every compiler has inline assembly.
    DefaultFpEnvironment() {
        __asm__ __volatile__("mrs %0, fpcr" : "=r"(saved_) : : "memory");
        set(0);  // no traps, nearest, no FZ
    }
    ~DefaultFpEnvironment() { set(saved_); }

  private:
    static void set(std::uint64_t control) {
        __asm__ __volatile__("msr fpcr, %0" : : "r"(control) : "memory");
    }

    std::uint64_t saved_;
#else
    DefaultFpEnvironment() {}
    ~DefaultFpEnvironment() {}
#endif
  public:
    DefaultFpEnvironment(const DefaultFpEnvironment&) = delete;
    DefaultFpEnvironment& operator=(const DefaultFpEnvironment&) = delete;
};

}  // namespace glint
