#pragma once
// The floating-point state that the bits of a picture assume.
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace glint {

/// Sets round-to-nearest without flush-to-zero for its lifetime and restores the caller's state. (Hosts that
/// set FTZ exist: other renderers recommend it.) Where there is no such state, as in WebAssembly, it does
/// nothing.
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
    DefaultFpEnvironment() : saved_(__builtin_aarch64_get_fpcr()) { __builtin_aarch64_set_fpcr(0); }
    ~DefaultFpEnvironment() { __builtin_aarch64_set_fpcr(saved_); }

  private:
    unsigned saved_;
#else
    DefaultFpEnvironment() {}
    ~DefaultFpEnvironment() {}
#endif
  public:
    DefaultFpEnvironment(const DefaultFpEnvironment&) = delete;
    DefaultFpEnvironment& operator=(const DefaultFpEnvironment&) = delete;
};

}  // namespace glint
